// SPDX-License-Identifier: GPL-3.0-or-later
#include <granum/network/linear_response.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include <granum/core/error.hpp>
#include <granum/core/text.hpp>

#include "block_cg.hpp"
#include "contact_operator.hpp"
#include "network/factor/elimination.hpp"
#include "network/factor/incomplete_factor.hpp"

namespace granum::network {

namespace {

using elastic::Matrix6;

/// Iterations that suffice with a good factor; packings take 20 to 110.
constexpr int patience = 150;

/// Result with one factor.
struct Attempt {
  FactorRule rule;
  Solution solution;
  std::size_t factor_nonzeros = 0, mended_pivots = 0;

  /// Whether another factor would not change the result.
  [[nodiscard]] bool is_final() const { return solution.status != Status::iteration_limit; }
};

/// Motions of a network by the numbers of its grains in the assembly [m]. What no wall holds does not move in
/// the mean.
StrainMotions in_assembly(const StrainMotions& of_network, const Backbone& network) {
  StrainMotions out;
  for (std::size_t c = 0; c < out.size(); ++c) {
    Vec3 mean;
    if (network.wall_links.empty())
      for (const GrainMotion& motion : of_network[c])
        mean += (1 / static_cast<double>(network.grain_count)) * motion.displacement;
    out[c].resize(network.moving_count);
    for (std::size_t g = 0; g < of_network[c].size(); ++g)
      out[c][network.grain[g]] = {network.length_scale * (of_network[c][g].displacement - mean),
                                  network.length_scale * of_network[c][g].turn};
  }
  return out;
}

template <int Dof>
Attempt attempt(const packing::Assembly& assembly, Backbone& backbone, const FactorRule& rule,
                ResponseOptions options, int iteration_limit, const Workers& workers) {
  const Preconditioner<Dof> preconditioner(
      backbone, workers,
      uses_motions(rule.soft_pivots) ? factor_with_soft_first<Dof>(assembly, options, rule, workers, backbone)
                                     : IncompleteFactor<Dof>(backbone, workers, rule));
  options.iteration_limit = iteration_limit;
  Solution solution = relax<Dof>(backbone, preconditioner, options, workers);
  if (options.motions) // now, because another attempt may number the grains anew
    solution.motions = in_assembly(solution.motions, backbone);
  return {.rule = rule,
          .solution = std::move(solution),
          .factor_nonzeros = preconditioner.nonzeros(),
          .mended_pivots = preconditioner.factor().mended_pivots()};
}

/// Solves H q = -W. Each factor in turn gets `patience` iterations; then the one with the least residual the
/// rest.
/// \param    backbone   of the assembly; may be renumbered
template <int Dof>
Solution relaxation(const packing::Assembly& assembly, Backbone& backbone, const ResponseOptions& options,
                    Response::Report& report) {
  std::optional<Team> team;
  if (const std::size_t members = std::min(options.threads, backbone.stages.front().size()); members > 1)
    team.emplace(members);
  const Workers workers(team ? &*team : nullptr);
  int left = options.iteration_limit;
  std::optional<Attempt> best;
  const auto solve = [&](FactorRule rule, int iteration_limit) {
    Attempt next = attempt<Dof>(assembly, backbone, rule, options, std::min(iteration_limit, left), workers);
    left -= next.solution.iterations;
    if (!best || next.is_final() || next.solution.residual < best->solution.residual)
      best = std::move(next);
  };
  for (const FactorRule& rule : factor_rules(backbone))
    if (!best || (!best->is_final() && left > 0))
      solve(rule, patience);
  if (!best->is_final() && left > 0)
    solve(best->rule, left);
  report.status = best->solution.status;
  report.iterations = options.iteration_limit - left;
  report.residual = best->solution.residual;
  report.factor_nonzeros = best->factor_nonzeros;
  report.mended_pivots = best->mended_pivots;
  return std::move(best->solution);
}

// Residuals are relative to the forces of the stiffest contacts, and C is the difference of two energies of
// theirs: where stiffnesses differ by more than this factor, both may hide what the other contacts do.
constexpr double widest_spread = 1e7;
// Change of C if the stiffest contacts become ten times softer, with which they are as good as rigid: C then
// is wrong by a ninth of it.
constexpr double of_rigid = 1e-4;
// Least share of the affine energy that relaxation may leave of such a network.
constexpr double least_left = 1e-7;

template <class Visit>
void each_contact(const packing::Assembly& assembly, const Visit& visit) {
  for (const auto* contacts : {&assembly.contacts, &assembly.wall_contacts})
    std::for_each(contacts->begin(), contacts->end(), visit);
}

/// The least k_n above 0, and the largest k_n or k_t [N/m].
struct Spread {
  double least = std::numeric_limits<double>::infinity(), largest = 0;
};

Spread spread_of_stiffness(const packing::Assembly& assembly) {
  Spread k;
  each_contact(assembly, [&](const packing::Contact& c) {
    if (c.normal_stiffness > 0)
      k.least = std::min(k.least, c.normal_stiffness);
    k.largest = std::max({k.largest, c.normal_stiffness, c.tangential_stiffness});
  });
  return k;
}

/// The k_n that half of the contacts exceed [N/m].
/// Assumes   that one is positive
double median_stiffness(const packing::Assembly& assembly) {
  std::vector<double> normal;
  each_contact(assembly, [&](const packing::Contact& c) {
    if (c.normal_stiffness > 0)
      normal.push_back(c.normal_stiffness);
  });
  const auto half = normal.begin() + static_cast<std::ptrdiff_t>(normal.size() / 2);
  std::nth_element(normal.begin(), half, normal.end());
  return *half;
}

/// The assembly with no k_n or k_t above a limit [N/m].
packing::Assembly softened(packing::Assembly assembly, double limit) {
  for (auto* contacts : {&assembly.contacts, &assembly.wall_contacts})
    for (packing::Contact& c : *contacts) {
      c.normal_stiffness = std::min(c.normal_stiffness, limit);
      c.tangential_stiffness = std::min(c.tangential_stiffness, limit);
    }
  return assembly;
}

/// Largest change of C_ab, over sqrt(C_aa C_bb).
double change(const Matrix6& from, const Matrix6& to) {
  const Eigen::Matrix<double, 6, 1> scale =
      to.diagonal().unaryExpr([](double c) { return c > 0 ? 1 / std::sqrt(c) : 0.0; });
  return (scale.asDiagonal() * (to - from) * scale.asDiagonal()).cwiseAbs().maxCoeff();
}

/// Of energies of a network without units, over the volume [Pa].
double stiffness_unit(const Backbone& network, const packing::Assembly& assembly) {
  return network.stiffness_scale * network.length_scale * network.length_scale / assembly.volume();
}

/// Of uniform strain [Pa].
elastic::VoigtStiffness affine_of(const Backbone& network, const packing::Assembly& assembly) {
  if (network.links.empty() && network.wall_links.empty())
    return {};
  return {stiffness_unit(network, assembly) * affine_energy(network)};
}

std::string failure_text(const Response::Report& report) {
  if (report.status == Status::not_positive_definite)
    return detail::formatted("network is unstable (negative energy after %d iterations, residual %.3g)",
                             report.iterations, report.residual);
  return detail::formatted("network response did not converge (%d iterations, relative residual %.3g)",
                           report.iterations, report.residual);
}

} // namespace

namespace {

void require_converged(const Response& response) {
  if (response.report().status == Status::stopped)
    throw Stopped();
  if (!response.converged())
    throw NotConverged(failure_text(response.report()));
}

} // namespace

const elastic::VoigtStiffness& Response::relaxed() const {
  require_converged(*this);
  return relaxed_;
}

const StrainMotions& Response::motions() const {
  require_converged(*this);
  return motions_;
}

namespace {

Response response_of(const packing::Assembly& assembly, const ResponseOptions& options) {
  Backbone backbone = load_bearing_network(assembly, options);
  Response::Report report{.grains = backbone.grain_count,
                          .contacts = backbone.links.size(),
                          .wall_contacts = backbone.wall_links.size(),
                          .unknowns_per_grain = backbone.rotations ? 6 : 3};
  if (backbone.links.empty() && backbone.wall_links.empty()) {
    StrainMotions at_rest;
    if (options.motions)
      at_rest.fill(std::vector<GrainMotion>(backbone.moving_count));
    return {{}, {}, report, {}, std::move(at_rest)};
  }

  const double unit = stiffness_unit(backbone, assembly);
  const Matrix6 affine = affine_energy(backbone);
  Solution solution = backbone.rotations ? relaxation<6>(assembly, backbone, options, report)
                                         : relaxation<3>(assembly, backbone, options, report);
  const Matrix6 relaxed = affine + solution.work;
  const double largest = relaxed.cwiseAbs().maxCoeff();
  if (largest > 0)
    report.symmetry_residual = (relaxed - relaxed.transpose()).cwiseAbs().maxCoeff() / largest;
  std::optional<ForceTerms> by_forces;
  if (options.force_terms)
    by_forces = ForceTerms{{unit * solution.by_forces.geometric}, {unit * solution.by_forces.shedding}};
  return {{unit * affine},
          {unit * (relaxed + relaxed.transpose()) / 2},
          report,
          by_forces,
          std::move(solution.motions)};
}

/// Of an assembly whose stiffnesses differ widely: those far above the median count as rigid. It did not
/// converge if they are not, or if next to nothing is left of the affine energy.
/// \param    largest   k_n or k_t [N/m]
Response response_of_wide_spread(const packing::Assembly& assembly, double largest,
                                 const ResponseOptions& options) {
  const double limit = widest_spread * median_stiffness(assembly);
  Response stiff = response_of(softened(assembly, limit), options);
  const Response softer = largest > limit / 10 ? response_of(softened(assembly, limit / 10), options) : stiff;
  const Matrix6 c = stiff.last_iterate().matrix;
  Response::Report report = stiff.report();
  if (stiff.converged())
    report.status = softer.report().status;
  const double moved = change(softer.last_iterate().matrix, c);
  const double left = (c - least_left * stiff.affine().matrix).diagonal().minCoeff();
  if (report.status == Status::converged && !(moved <= of_rigid && left >= 0)) {
    report.status = Status::iteration_limit;
    report.residual = std::max(report.residual, moved);
  }
  return {affine_of(load_bearing_network(assembly, options), assembly),
          {c},
          report,
          stiff.force_terms(),
          stiff.take_motions()};
}

} // namespace

Response linear_response(const packing::Assembly& assembly, const ResponseOptions& options) {
  require_valid(assembly);
  require_open("tolerance", options.tolerance, 0, 1);
  require_positive("iteration_limit", options.iteration_limit);
  require_positive("threads", static_cast<double>(options.threads));
  if (options.force_terms && !assembly.wall_contacts.empty())
    throw InvalidArgument("force_terms: " + std::to_string(assembly.wall_contacts.size()) +
                          " contacts with walls, for which they are not implemented");

  const auto turns = [](const packing::Contact& c) {
    return c.rolling_stiffness > 0 || c.twisting_stiffness > 0;
  };
  if (options.force_terms && std::any_of(assembly.contacts.begin(), assembly.contacts.end(), turns))
    throw InvalidArgument("force_terms: not implemented for contacts that resist rolling or twisting");
  if (options.force_terms && !assembly.body.empty())
    throw InvalidArgument("force_terms: not implemented for grains that are parts of rigid bodies");

  const Spread k = spread_of_stiffness(assembly);
  return k.largest > widest_spread * k.least ? response_of_wide_spread(assembly, k.largest, options)
                                             : response_of(assembly, options);
}

elastic::VoigtStiffness affine_all(const packing::Assembly& assembly, const ResponseOptions& options) {
  require_valid(assembly);
  return affine_of(network_with_rattlers(assembly, options), assembly);
}

} // namespace granum::network

// SPDX-License-Identifier: GPL-3.0-or-later
#include <granum/network/linear_response.hpp>

#include <algorithm>
#include <optional>
#include <string>

#include <granum/core/check.hpp>
#include <granum/core/error.hpp>
#include <granum/core/number.hpp>

#include "block_cg.hpp"
#include "contact_operator.hpp"
#include "network/factor/factor_rule.hpp"
#include "network/factor/incomplete_factor.hpp"
#include "preconditioner.hpp"

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

template <int Dof>
Attempt attempt(const packing::Assembly& assembly, Backbone& backbone, const FactorRule& rule,
                ResponseOptions options, int iteration_limit, const Workers& workers) {
  const Preconditioner<Dof> preconditioner(
      backbone, workers,
      uses_motions(rule.soft_pivots) ? factor_with_soft_first<Dof>(assembly, options, rule, workers, backbone)
                                     : IncompleteFactor<Dof>(backbone, workers, rule));
  options.iteration_limit = iteration_limit;
  return {.rule = rule,
          .solution = relax<Dof>(backbone, preconditioner, options, workers),
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
  return best->solution;
}

/// Of energies of a network without units, over the volume [Pa].
double stiffness_unit(const Backbone& network, const packing::Assembly& assembly) {
  return network.stiffness_scale * network.length_scale * network.length_scale / assembly.volume();
}

std::string failure_text(const Response::Report& report) {
  if (report.status == Status::not_positive_definite)
    return detail::formatted("network is unstable (negative energy after %d iterations, residual %.3g)",
                             report.iterations, report.residual);
  return detail::formatted("network response did not converge (%d iterations, relative residual %.3g)",
                           report.iterations, report.residual);
}

} // namespace

const elastic::VoigtStiffness& Response::relaxed() const {
  if (report_.status == Status::stopped)
    throw Stopped();
  if (!converged())
    throw NotConverged(failure_text(report_));
  return relaxed_;
}

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
  if ((options.force_terms || options.prestress) && !assembly.body.empty())
    throw InvalidArgument(std::string(options.prestress ? "prestress" : "force_terms") +
                          ": not implemented for grains that are parts of rigid bodies");

  Backbone backbone = load_bearing_network(assembly, options);
  Response::Report report{.grains = backbone.grain_count,
                          .contacts = backbone.links.size(),
                          .wall_contacts = backbone.wall_links.size(),
                          .unknowns_per_grain = backbone.rotations ? 6 : 3};
  if (backbone.links.empty() && backbone.wall_links.empty())
    return {{}, {}, report};

  const double unit = stiffness_unit(backbone, assembly);
  const Matrix6 affine = affine_energy(backbone);
  const Solution solution = backbone.rotations ? relaxation<6>(assembly, backbone, options, report)
                                               : relaxation<3>(assembly, backbone, options, report);
  const Matrix6 relaxed = affine + solution.work;
  const double largest = relaxed.cwiseAbs().maxCoeff();
  if (largest > 0)
    report.symmetry_residual = (relaxed - relaxed.transpose()).cwiseAbs().maxCoeff() / largest;
  std::optional<ForceTerms> by_forces;
  if (options.force_terms)
    by_forces = ForceTerms{{unit * solution.by_forces.geometric}, {unit * solution.by_forces.shedding}};
  return {{unit * affine}, {unit * (relaxed + relaxed.transpose()) / 2}, report, by_forces};
}

elastic::VoigtStiffness affine_all(const packing::Assembly& assembly, const ResponseOptions& options) {
  require_valid(assembly);
  const Backbone network = network_with_rattlers(assembly, options);
  if (network.links.empty() && network.wall_links.empty())
    return {};
  return {stiffness_unit(network, assembly) * affine_energy(network)};
}

} // namespace granum::network

// SPDX-License-Identifier: GPL-3.0-or-later
#include <granum/analysis/measurement.hpp>

#include <algorithm>
#include <cmath>

#include <granum/analysis/measure.hpp>
#include <granum/core/error.hpp>
#include <granum/core/text.hpp>
#include <granum/elastic/isotropic.hpp>

namespace granum::analysis {

namespace {

/// The contacts that press: moments of forces have no meaning in tension.
packing::Assembly pressing_part(const packing::Assembly& assembly) {
  packing::Assembly pressing = assembly;
  std::erase_if(pressing.contacts, [](const packing::Contact& c) { return !(c.normal_force > 0); });
  return pressing;
}

} // namespace

NetworkMatrix network_matrix(const elastic::VoigtStiffness& stiffness,
                             const std::optional<double>& bulk_density) {
  NetworkMatrix out{.stiffness = stiffness, .moduli = elastic::engineering_moduli(stiffness)};
  if (stiffness.matrix.norm() > 0)
    out.symmetry = elastic::symmetry_distances(stiffness);
  if (!bulk_density)
    return out;
  require_positive("bulk_density", *bulk_density, "kg/m3");
  try {
    out.waves = elastic::plane_waves_along_axes(stiffness, *bulk_density);
  } catch (const InvalidArgument&) { // not positive semidefinite: no waves
  }
  return out;
}

elastic::Isotropic Network::isotropic_relaxed() const {
  return elastic::isotropic_projection(response.relaxed());
}

elastic::Isotropic Network::isotropic_affine() const {
  return elastic::isotropic_projection(response.affine());
}

double Network::G_hh() const { return response.relaxed().matrix(5, 5); }

double Network::G_vh() const {
  const elastic::Matrix6& c = response.relaxed().matrix;
  return (c(3, 3) + c(4, 4)) / 2;
}

Microstructure Measurement::microstructure() const {
  if (interior)
    return interior->micro;
  if (!fabric)
    throw InvalidArgument("a packing of fewer than 2 contacts has no fabric");
  return {.coordination_number = counts.coordination_number,
          .mechanical_coordination_number = counts.mechanical.coordination_number,
          .rattler_fraction = counts.mechanical.rattler_fraction,
          .fabric_anisotropy = fabric->by_moment.anisotropy,
          .fabric_anisotropy_error = fabric->by_moment.standard_error,
          .sliding_fraction = counts.sliding_fraction};
}

std::optional<effective::RungAnswer> Measurement::closed_form(effective::RungName name) const {
  for (const ClosedForm& form : closed_forms)
    if (form.rung->name == name)
      return form.answer;
  return std::nullopt;
}

const Network& Measurement::solved_network() const {
  if (!network)
    throw NotConverged("no grain of the packing carries load: it has no network");
  return *network;
}

std::vector<ClosedForm> closed_forms(const effective::State& packing) {
  std::vector<ClosedForm> out;
  for (const effective::Rung& rung : effective::closed_forms()) {
    out.push_back({.rung = &rung});
    try {
      out.back().answer = effective::answer(rung, packing);
    } catch (const InvalidArgument& error) {
      out.back().refusal = error.what();
    }
  }
  return out;
}

void keep_within_bounds(Measurement& m) {
  if (!m.network || m.interior) // bounds of the whole cell are none of its interior
    return;
  const packing::BulkModulusBounds& bounds = m.network->bulk_bounds;
  for (ClosedForm& form : m.closed_forms) {
    if (!form.answer || form.rung->name != effective::RungName::relaxed || !(bounds.upper > 0))
      continue;
    elastic::TransverselyIsotropic& c = form.answer->stiffness;
    const double K = c.bulk_modulus(), kept = std::min(std::max(K, bounds.lower), bounds.upper);
    constexpr double rounding = 1e-9;
    if (std::abs(kept - K) <= rounding * kept)
      continue;
    for (double* entry : {&c.C11, &c.C33, &c.C12, &c.C13}) // shear moduli stay
      *entry += kept - K;
    m.notes.push_back(std::string("K of rung 3 is the ") + (kept > K ? "lower" : "upper") +
                      " bound of this packing, which its formula leaves by " +
                      percent_text(std::abs(kept / K - 1)));
  }
}

Fabric measure_fabric(std::span<const Vec3> normals, const Wanted& wanted) {
  constexpr std::size_t enough = 20;
  Fabric out{.contacts = normals.size(),
             .tensor = packing::fabric_tensor(normals),
             .by_moment = fabric::estimate_anisotropy(normals)};
  if (wanted.fabric_tests) {
    out.by_likelihood = fabric::estimate_anisotropy_by_likelihood(normals);
    out.isotropy = fabric::test_isotropy(normals);
    if (normals.size() >= enough) {
      out.density = fabric::test_density(normals);
      out.axisymmetry = fabric::test_axisymmetry(normals);
    }
  }
  if (wanted.rose_bins)
    out.rose =
        fabric::rose(normals, out.by_likelihood ? out.by_likelihood->anisotropy : 0, *wanted.rose_bins);
  return out;
}

namespace {

/// Of the contacts whose normal force is taken; empty for fewer than 2.
template <class Takes>
std::optional<fabric::AnisotropyEstimate> anisotropy_where(const packing::Assembly& assembly,
                                                           const Takes& takes) {
  std::vector<Vec3> normals;
  for (const packing::Contact& c : assembly.contacts)
    if (takes(c.normal_force))
      normals.push_back(normal(c));
  return normals.size() < 2 ? std::nullopt : std::optional(fabric::estimate_anisotropy(normals));
}

} // namespace

Forces measure_forces(const packing::Assembly& assembly, const Given& given, std::size_t bins) {
  Forces out{.distribution = packing::force_distribution(normal_forces(assembly), bins)};
  if (given.tangential_forces) {
    constexpr double hardly = 1e-3, explained = 0.1;
    out.unbalance = unbalance(assembly);
    const packing::Weight weight = common_weight(assembly);
    if (out.unbalance->force_ratio > hardly && weight.left_over < explained)
      out.weight = weight;
  }
  if (out.distribution.pressing == 0)
    return out;
  const packing::Assembly pressing = pressing_part(assembly);
  out.Z_2 = normal_force_moment(pressing, 2);
  out.Z_5_3 = normal_force_moment(pressing, 5.0 / 3);
  out.strong = anisotropy_where(pressing, [&](double f) { return f > out.distribution.mean; });
  out.weak = anisotropy_where(pressing, [&](double f) { return f <= out.distribution.mean; });
  if (!given.tangential_forces)
    return out;
  double tangential = 0;
  for (const packing::Contact& c : pressing.contacts)
    tangential += norm(c.tangential_force);
  out.mean_tangential_over_normal =
      tangential / (out.distribution.mean * static_cast<double>(out.distribution.pressing));
  out.friction = estimate_friction(pressing);
  if (given.friction_coefficient)
    out.sliding_fraction = sliding_fraction(pressing, *given.friction_coefficient);
  else if (out.friction)
    out.sliding_fraction = sliding_fraction(pressing, out.friction->coefficient);
  return out;
}

} // namespace granum::analysis

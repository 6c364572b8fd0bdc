// SPDX-License-Identifier: GPL-3.0-or-later
#include "frozen_point.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <utility>
#include <vector>

#include <granum/assembly/coordination.hpp>
#include <granum/assembly/fabric_tensor.hpp>
#include <granum/assembly/force_distribution.hpp>
#include <granum/core/error.hpp>
#include <granum/core/number.hpp>
#include <granum/core/units.hpp>
#include <granum/effective/relaxation.hpp>
#include <granum/effective/uniform_field.hpp>
#include <granum/fabric/rose.hpp>
#include <granum/network/linear_response.hpp>
#include <granum/triaxial/measures.hpp>
#include <granum/triaxial/probe.hpp>

#include "outcome_text.hpp"

namespace granum::verify {

namespace {

/// Unbalanced force ratio at which a frozen state counts as at rest. Against 1e-5 it moves G of 1,000 spheres
/// by 1e-7 (median) and 0.2 % at most up to |eta| = 0.6, and by 0.2 % (median), 2 % at most beyond, where the
/// specimen creeps on, for a quarter of the steps; 1e-8 takes five times as many again.
constexpr double rest_tolerance = 1e-4;
/// Moduli change by 1e-9 at most against 1e-10, as their error is of second order, in 6/7 of the time.
constexpr double network_tolerance = 1e-7;

std::array<double, 36> rows(const elastic::VoigtStiffness& stiffness) {
  std::array<double, 36> out{};
  for (int i = 0; i < 6; ++i)
    for (int j = 0; j < 6; ++j)
      out[static_cast<std::size_t>(6 * i + j)] = stiffness.matrix(i, j);
  return out;
}

/// Standard error of the mean number of contacts of a grain.
double coordination_error(const Assembly& assembly) {
  std::vector<double> contacts(assembly.grain_count());
  for (const Contact& c : assembly.contacts) {
    contacts[c.i] += 1;
    contacts[c.j] += 1;
  }
  const double grains = static_cast<double>(contacts.size());
  const double mean = std::accumulate(contacts.begin(), contacts.end(), 0.0) / grains;
  double squares = 0;
  for (const double number : contacts)
    squares += (number - mean) * (number - mean);
  return std::sqrt(squares / (grains - 1) / grains);
}

/// Microstructure, and contacts by direction and by force.
void measure_contacts(const dem::State& state, const dem::Material& material, const Assembly& assembly,
                      FrozenPoint& out) {
  out.void_ratio = out.interior_void_ratio = dem::void_ratio(state);
  if (state.walls) {
    const triaxial::InteriorMeasures inside = triaxial::interior_measures(state, material, 4 * state.radius);
    out.micro = inside.micro;
    out.interior_void_ratio = inside.void_ratio;
  } else {
    out.micro = triaxial::microstructure(assembly);
  }
  out.coordination_number_all = coordination_number(assembly);
  out.coordination_error = coordination_error(assembly);
  const std::vector<Vec3> normals = contact_normals(assembly);
  out.contacts = static_cast<std::uint32_t>(normals.size());
  out.fabric = fabric_tensor(assembly);
  const std::vector<fabric::RoseBin> rose = fabric::rose(normals, 0, polar_bins);
  const ForceDistribution forces = force_distribution(normal_forces(assembly), force_bins, 8);
  for (std::size_t k = 0; k < polar_bins; ++k)
    out.polar_counts[k] = static_cast<std::uint32_t>(rose[k].count);
  for (std::size_t k = 0; k < force_bins; ++k)
    out.force_counts[k] = static_cast<std::uint32_t>(forces.bins[k].count);
}

/// Near failure, C_n, a and the stress may be such as no static force field has.
std::optional<ClosedForms> closed_forms(const dem::Material& material, double radius,
                                        const FrozenPoint& point) {
  const effective::State state{.law = material.law,
                               .tangential_ratio = material.tangential_ratio,
                               .radius = radius,
                               .void_ratio = point.interior_void_ratio,
                               .coordination_number = point.micro.coordination_number,
                               .fabric_anisotropy = point.micro.fabric_anisotropy,
                               .stress_v = point.stress.v,
                               .stress_h = point.stress.h};
  try {
    const effective::RelaxedEstimate relaxed =
        effective::relaxed(state, point.micro.mechanical_coordination_number);
    return ClosedForms{.uniform_strain = effective::uniform_strain(state).stiffness,
                       .uniform_stress = effective::uniform_stress(state).stiffness,
                       .relaxed = relaxed.stiffness,
                       .G_hh_error = relaxed.relative_error.G_hh,
                       .G_vh_error = relaxed.relative_error.G_vh};
  } catch (const InvalidArgument&) {
    return std::nullopt;
  }
}

} // namespace

void require_rest(double unbalanced_force_ratio, const std::string& what, double limit) {
  if (!(unbalanced_force_ratio <= limit))
    throw NotConverged(what + " did not come to rest: unbalanced force ratio " +
                       short_text(unbalanced_force_ratio));
}

double modulus_of(const triaxial::ProbeResult& result) {
  if (!result.converged)
    throw NotConverged("a probe did not come to rest: unbalanced force ratio " +
                       short_text(result.unbalanced_force_ratio));
  return result.shear_modulus;
}

Probes run_probes(const dem::State& state, const dem::Material& material, const StopRequest& stop_requested) {
  const auto [hh, hv, vh] = triaxial::probe_all(state, material, {.stop_requested = stop_requested});
  Probes probes;
  probes.G_hh = modulus_of(hh);
  probes.G_hv = modulus_of(hv);
  probes.G_vh = modulus_of(vh);
  probes.amplitude = hh.amplitude;
  return probes;
}

ShearLoop shear_loop(const dem::State& state, const dem::Material& material, double eta, double amplitude,
                     const StopRequest& stop_requested) {
  triaxial::ProbeResult result = triaxial::probe(state, material, triaxial::ShearMode::hh,
                                                 {.amplitude = amplitude,
                                                  .sliding = true,
                                                  .hold_normal_stress = true,
                                                  .loop_points = 5,
                                                  .force_tolerance = 1e-6,
                                                  .max_steps = 4000,
                                                  .stop_requested = stop_requested});
  return {.eta = eta, .amplitude = amplitude, .points = std::move(result.loop)};
}

FrozenPoint frozen_point(const dem::State& state, const dem::Material& material,
                         const triaxial::PathPoint& at, bool probed, std::vector<std::string>& notes,
                         const StopRequest& stop_requested) {
  const triaxial::FrozenState frozen =
      triaxial::freeze_in_place(state, material, rest_tolerance, stop_requested);
  require_rest(frozen.report.unbalanced_force_ratio, "a frozen state", rest_tolerance);
  const Mat3& stress = frozen.report.stress;
  FrozenPoint out;
  out.at = at;
  out.stress = {.v = stress(2, 2), .h = (stress(0, 0) + stress(1, 1)) / 2};
  out.unbalanced_force_ratio = frozen.report.unbalanced_force_ratio;
  out.rest_steps = frozen.report.steps;
  const Assembly assembly = dem::freeze(frozen.state, material);
  measure_contacts(frozen.state, material, assembly, out);
  out.micro.sliding_fraction = triaxial::microstructure(dem::freeze(state, material)).sliding_fraction;
  const network::Response response =
      network::linear_response(assembly, {.tolerance = network_tolerance, .stop_requested = stop_requested});
  out.network = rows(response.relaxed());
  out.affine = rows(response.affine());
  out.closed = closed_forms(material, state.radius, out);
  if (probed) {
    const std::string failure =
        failure_of([&] { out.probes = run_probes(frozen.state, material, stop_requested); });
    if (!failure.empty())
      notes.push_back("not probed at eta = " + short_text(at.stress.ratio()) +
                      ", p' = " + pretty(at.stress.mean(), Dimension::pressure) + ": " + failure);
  }
  return out;
}

} // namespace granum::verify

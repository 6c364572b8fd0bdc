// SPDX-License-Identifier: GPL-3.0-or-later
#include "path_run.hpp"

#include <granum/analysis/measure.hpp>
#include <granum/core/text.hpp>
#include <granum/core/units.hpp>
#include <granum/triaxial/probe.hpp>

#include "studies/running/outcome_text.hpp"
#include "studies/running/probes.hpp"

namespace granum::studies {

namespace {

/// Moduli change by 1e-9 at most against 1e-10, as their error is of second order, in 6/7 of the time.
constexpr double network_tolerance = 1e-7;

std::array<double, 36> rows(const elastic::VoigtStiffness& stiffness) {
  std::array<double, 36> out{};
  for (int i = 0; i < 6; ++i)
    for (int j = 0; j < 6; ++j)
      out[static_cast<std::size_t>(6 * i + j)] = stiffness.matrix(i, j);
  return out;
}

analysis::Measurement measure(const dem::Specimen& state, const dem::Material& material,
                              const stress::AxialStress& stress, const StopRequest& stop_requested) {
  analysis::Given given = known_of(state, material);
  given.stress = stress;
  analysis::Wanted wanted{
      .rose_bins = polar_bins,
      .force_bins = force_bins,
      .closed_forms = true,
      .network = network::ResponseOptions{.tolerance = network_tolerance, .stop_requested = stop_requested}};
  if (state.walls)
    wanted.interior_layer = 4 * state.radius; // two diameters, the custom
  return analysis::measure(dem::contact_network(state, material), given, wanted);
}

std::optional<ClosedForms> closed_forms_of(const analysis::Measurement& measured) {
  using effective::RungName;
  const auto strain = measured.closed_form(RungName::directional);
  const auto stress = measured.closed_form(RungName::uniform_stress);
  const auto relaxed = measured.closed_form(RungName::relaxed);
  if (!strain || !stress || !relaxed)
    return std::nullopt;
  const effective::ModulusErrors errors = relaxed->relative_error.value();
  return ClosedForms{.uniform_strain = strain->stiffness,
                     .uniform_stress = stress->stiffness,
                     .relaxed = relaxed->stiffness,
                     .G_hh_error = errors.G_hh,
                     .G_vh_error = errors.G_vh};
}

/// The part of a measurement that checkpoints store.
void record(const analysis::Measurement& measured, StateRecord& out) {
  out.void_ratio = measured.void_ratio;
  out.interior_void_ratio = measured.interior_void_ratio();
  out.micro = measured.microstructure();
  out.coordination_number_all = measured.counts.coordination_number;
  out.coordination_error = measured.counts.coordination_error;
  const analysis::Fabric& fabric = measured.fabric.value();
  out.contacts = static_cast<std::uint32_t>(fabric.contacts);
  out.fabric = fabric.tensor;
  for (std::size_t k = 0; k < polar_bins; ++k)
    out.polar_counts[k] = static_cast<std::uint32_t>(fabric.rose.at(k).count);
  const packing::ForceDistribution& forces = measured.forces.value().distribution;
  for (std::size_t k = 0; k < force_bins; ++k)
    out.force_counts[k] = static_cast<std::uint32_t>(forces.bins.at(k).count);
  const network::Response& response = measured.solved_network().response;
  out.network = rows(response.relaxed());
  out.affine = rows(response.affine());
  out.closed = closed_forms_of(measured);
}

} // namespace

StateRecord state_record(const dem::Specimen& state, const dem::Material& material,
                         const triaxial::PathPoint& at, bool probed, std::vector<std::string>& notes,
                         const StopRequest& stop_requested) {
  const triaxial::FrozenState frozen =
      triaxial::freeze_in_place(state, material, triaxial::creeping_force_tolerance, stop_requested);
  const Mat3& stress = frozen.stress();
  StateRecord out;
  out.at = at;
  out.stress = {.v = stress(2, 2), .h = (stress(0, 0) + stress(1, 1)) / 2};
  out.unbalanced_force_ratio = frozen.report.unbalanced_force_ratio;
  out.rest_steps = frozen.report.steps;
  record(measure(frozen.state(), material, out.stress, stop_requested), out);
  out.micro.sliding_fraction = sliding_fraction(dem::contact_network(state, material));
  if (probed) {
    const std::string failure = failure_of(
        [&] { out.probes = run_probes(frozen.state(), material, {.stop_requested = stop_requested}); });
    if (!failure.empty())
      notes.push_back("not probed at eta = " + short_text(at.stress.ratio()) +
                      ", p' = " + pretty(at.stress.mean(), Dimension::pressure) + ": " + failure);
  }
  return out;
}

ShearLoop shear_loop(const dem::Specimen& state, const dem::Material& material, double eta, double amplitude,
                     const StopRequest& stop_requested) {
  triaxial::ProbeResult result = triaxial::probe(state, material, triaxial::ShearMode::hh,
                                                 {.amplitude = amplitude,
                                                  .sliding = true,
                                                  .hold_normal_stress = true,
                                                  .loop_points = 5,
                                                  .force_tolerance = 1e-6,
                                                  .max_steps = 4000,
                                                  .stop_requested = stop_requested});
  return {.eta = eta, .amplitude = amplitude, .points = std::move(result.last_loop)};
}

} // namespace granum::studies

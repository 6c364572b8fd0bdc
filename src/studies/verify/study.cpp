// SPDX-License-Identifier: GPL-3.0-or-later
#include "studies/verify/study.hpp"

#include <algorithm>
#include <cmath>

#include "studies/plan/plan.hpp"
#include <granum/analysis/measure.hpp>
#include <granum/core/error.hpp>
#include <granum/core/units.hpp>
#include <granum/effective/rungs.hpp>
#include <granum/triaxial/probe.hpp>

#include "studies/running/outcome_text.hpp"
#include "studies/running/probes.hpp"
#include "studies/running/work_sharing.hpp"

namespace granum::studies {

namespace {

/// Rung 2 from the counts of the frozen packing, at the requested pressure.
void estimate_closed_form(const dem::Material& material, CompressedState& out) {
  const effective::State state{.law = out.packing.law.value(),
                               .tangential_ratio = material.tangential_ratio,
                               .radius = out.packing.sizes.equivalent,
                               .void_ratio = out.packing.void_ratio,
                               .coordination_number = out.packing.counts.coordination_number,
                               .stress_v = out.pressure,
                               .stress_h = out.pressure,
                               .contacts = out.packing.sizes.contacts};
  const effective::RungAnswer form =
      effective::answer(effective::rung(effective::RungName::directional), {state});
  out.G_closed = form.stiffness.G_vh();
  out.K_closed = form.stiffness.bulk_modulus();
}

struct Packing {
  contact::Shape contact = contact::Shape::sphere;
  std::uint64_t seed = 0;
  dem::Specimen state;
  std::string failure;
};

/// Probes at rest by the usual tolerances, or, where their moduli differ from those of the network by more
/// than the limit, by ones a tenth as large. Soft modes of loose packings relax slowly: at the usual
/// tolerances some are still under way, at the smaller ones the probe is within 0.2 % of the network. A
/// difference that remains is a fault of one of the two.
void probe_to_the_end(const Scene& scene, const dem::Specimen& state, const dem::Material& material,
                      const SpecimenResult& specimen, const StopRequest& stop_requested,
                      CompressedState& out) {
  out.probes = run_probes(state, material, {.stop_requested = stop_requested});
  const bool by_forces =
      largest_force_share(out) > probe_limit(scene, triaxial::Density::loose); // not judged
  if (!by_forces && probe_error(out) > probe_limit(scene, specimen.density))
    out.probes = run_probes(state, material,
                            {.force_tolerance = 1e-10,
                             .settled_share = 1e-6,
                             .max_steps = 200000,
                             .stop_requested = stop_requested});
}

/// A state, and its probes, if they come to rest; else why not.
void measure(const Scene& scene, const triaxial::Snapshot& snapshot, const triaxial::SpecimenRecipe& recipe,
             bool probed, const StopRequest& stop_requested, SpecimenResult& specimen) {
  const dem::Material& material = recipe.material;
  const auto leave_out = [&](const NotConverged& why) {
    specimen.left_out.push_back(pretty(snapshot.pressure, Dimension::pressure) + ": " + why.what());
  };
  const triaxial::FrozenState frozen =
      triaxial::freeze_in_place(snapshot.state, material, triaxial::usual_force_tolerance, stop_requested);
  try {
    (void)frozen.state();
  } catch (const NotConverged& why) {
    leave_out(why);
    return;
  }
  CompressedState out{
      .pressure = snapshot.pressure,
      .contact_pressure = trace(snapshot.report.stress()) / 3,
      .sliding_fraction = sliding_fraction(dem::contact_network(snapshot.state, material)),
      .packing = analysis::measure(
          dem::contact_network(frozen.state(), material), known_of(frozen.state(), material),
          {.work = true,
           .network = network::ResponseOptions{.force_terms = true, .stop_requested = stop_requested}}),
      .probes = {},
      .steps = snapshot.report.steps + frozen.report.steps,
      .unbalanced_force_ratio = frozen.report.unbalanced_force_ratio,
      .largest_inertial_number = snapshot.report.largest_inertial_number};
  (void)out.packing.solved_network().response.relaxed(); // throws unless the network converged
  estimate_closed_form(material, out);
  if (probed)
    try {
      probe_to_the_end(scene, frozen.state(), material, specimen, stop_requested, out);
    } catch (const NotConverged& why) {
      leave_out(why);
    }
  specimen.states.push_back(std::move(out));
}

void run_specimen(const Scene& scene, const Packing& packing, SpecimenResult& out, Meter& meter) {
  if (!packing.failure.empty()) {
    out.failure = packing.failure;
    return;
  }
  const triaxial::SpecimenRecipe specimen = recipe(scene, out.contact, out.seed);
  dem::QuasistaticOptions options = triaxial::compression_options();
  options.stop_requested = meter.stop_request();
  std::size_t stage = 0;
  const auto visit = [&](const triaxial::Snapshot& snapshot) {
    if (!snapshot.report.converged()) {
      out.failure = failure_of(snapshot);
      return false;
    }
    const bool probed = std::find(scene.study.probe_pressures.begin(), scene.study.probe_pressures.end(),
                                  snapshot.pressure) != scene.study.probe_pressures.end();
    measure(scene, snapshot, specimen, probed, options.stop_requested, out);
    meter.add(stage_work(scene, out.density, out.contact, stage++), title(out));
    if (meter.stopped() && stage < scene.study.pressures.size())
      out.failure = stopped_on_request;
    return out.failure.empty();
  };
  if (!triaxial::isotropic_path(
          triaxial::start_of_compression(packing.state, out.density, specimen, options.stop_requested),
          specimen.material, scene.study.pressures, options, visit) &&
      out.failure.empty())
    out.failure = "the path ended early";
}

/// \param    plane   row of the 6x6
double by_forces(const CompressedState& state, int plane) {
  const auto& terms = state.packing.solved_network().response.force_terms();
  return terms ? terms->geometric.matrix(plane, plane) + terms->shedding.matrix(plane, plane) : 0;
}

void prepare(const Scene& scene, Packing& packing, Meter& meter) {
  packing.failure = failure_or_stop_of([&] {
    throw_if_stopped(meter.stop_request());
    packing.state =
        triaxial::frictionless_specimen(recipe(scene, packing.contact, packing.seed), meter.stop_request())
            .state;
  });
  meter.add(preparation_work(scene), std::string(name(packing.contact)) + " packing");
}

} // namespace

std::string title(const SpecimenResult& specimen) {
  return std::string(name(specimen.contact)) + " " + std::string(name(specimen.density)) + " #" +
         std::to_string(specimen.seed);
}

std::optional<double> relaxed_modulus(const CompressedState& state) {
  if (!state.packing.state)
    return std::nullopt;
  const effective::RungAnswer answer =
      effective::answer(effective::rung(effective::RungName::relaxed), *state.packing.state);
  return effective::declines(answer) ? std::nullopt : std::optional(answer.stiffness.G_vh());
}

double G_hh_network(const CompressedState& state) {
  return state.packing.solved_network().response.relaxed().matrix(5, 5);
}

double G_vh_network(const CompressedState& state) {
  return state.packing.solved_network().response.relaxed().matrix(4, 4);
}

double G_hh_by_forces(const CompressedState& state) { return by_forces(state, 5); }

double G_vh_by_forces(const CompressedState& state) { return by_forces(state, 4); }

double largest_force_share(const CompressedState& s) {
  return std::max(std::abs(G_hh_by_forces(s) / G_hh_network(s)),
                  std::abs(G_vh_by_forces(s) / G_vh_network(s)));
}

double probe_error(const CompressedState& s) {
  const auto difference = [](double a, double b) { return std::abs(a / b - 1); };
  return std::max(difference(s.probes->G_hh, G_hh_network(s) + G_hh_by_forces(s)),
                  difference(s.probes->G_hv, G_vh_network(s) + G_vh_by_forces(s)));
}

double probe_limit(const Scene& scene, triaxial::Density density) {
  const double few = std::max(1.0, 1000.0 / static_cast<double>(scene.study.grains));
  return few * (density == triaxial::Density::dense ? 3e-3 : 1e-2);
}

std::vector<SpecimenResult> run_study(const Scene& scene, const RunControl& control) {
  require_valid(scene);
  require_periodic_cell(scene);
  Meter meter(control, total_work(scene));
  const std::vector<SpecimenName> names = specimens_of(scene);
  std::vector<Packing> packings(scene.study.contacts.size() * scene.study.seeds);
  std::vector<SpecimenResult> specimens;
  std::vector<Job> jobs(packings.size());
  for (std::size_t k = 0; k < names.size(); ++k) {
    const SpecimenName& of = names[k];
    Packing& packing = packings[of.packing];
    packing.contact = of.contact;
    packing.seed = of.seed;
    jobs[of.packing] = {
        .work = [&] { prepare(scene, packing, meter); }, .cost = preparation_work(scene), .after = {}};
    specimens.push_back({of.contact, of.density, of.seed, {}, {}});
    jobs.push_back({.work =
                        [&, k] {
                          const std::string failure =
                              failure_or_stop_of([&] { run_specimen(scene, packing, specimens[k], meter); });
                          if (!failure.empty())
                            specimens[k].failure = failure;
                        },
                    .cost = specimen_work(scene, of.density, of.contact),
                    .after = of.packing});
  }
  side_by_side(jobs, thread_count(scene));
  return specimens;
}

} // namespace granum::studies

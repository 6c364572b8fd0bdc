// SPDX-License-Identifier: GPL-3.0-or-later
#include "studies/trade/trade.hpp"

#include <algorithm>
#include <ctime>

#include <granum/analysis/measure.hpp>
#include <granum/core/error.hpp>
#include <granum/triaxial/probe.hpp>
#include <granum/triaxial/shear_test.hpp>
#include <granum/triaxial/specimen.hpp>

#include "studies/running/fitted_exponent.hpp"
#include "studies/running/outcome_text.hpp"
#include "studies/running/probes.hpp"
#include "studies/running/work_sharing.hpp"
#include "trade_parts.hpp"

namespace granum::studies {

namespace trade {

namespace {

/// Processor time of this thread since its start; on a shared machine wall time is unreliable.
class ThreadClock {
 public:
  [[nodiscard]] double seconds() const { return now() - start_; }

 private:
  static double now() {
    std::timespec time{};
    clock_gettime(CLOCK_THREAD_CPUTIME_ID, &time);
    return static_cast<double>(time.tv_sec) + 1e-9 * static_cast<double>(time.tv_nsec);
  }
  double start_ = now();
};

triaxial::SpecimenRecipe recipe_of(const TradeScene& trade, const Settings& settings) {
  Scene scene = trade.scene;
  scene.study.grains = settings.grains;
  triaxial::SpecimenRecipe out = recipe(scene, scene.study.contacts.front(), settings.seed);
  if (settings.boundary == Boundary::smooth_walls)
    out.wall_friction = 0;
  if (settings.boundary == Boundary::rough_walls)
    out.wall_friction = out.material.friction_coefficient;
  return out;
}

void make(const triaxial::SpecimenRecipe& recipe, const StopRequest& stop_requested, Part& packing) {
  triaxial::FrictionlessPacking made = triaxial::frictionless_specimen(recipe, stop_requested);
  packing.state = std::move(made.state);
  packing.steps = made.minimiser_steps;
}

double probed(const dem::Specimen& state, const dem::Material& material, triaxial::ShearMode mode,
              double amplitude, const StopRequest& stop_requested, Part& part) {
  const triaxial::ProbeResult result =
      triaxial::probe(state, material, mode, {.amplitude = amplitude, .stop_requested = stop_requested});
  part.steps += result.steps;
  return result.shear_modulus();
}

analysis::Measurement measured(const dem::Specimen& state, const dem::Material& material,
                               const StopRequest& stop_requested) {
  return analysis::measure(dem::contact_network(state, material), known_of(state, material),
                           {.network = network::ResponseOptions{.stop_requested = stop_requested}});
}

void measure_network(const dem::Specimen& frozen, const dem::Material& material,
                     const StopRequest& stop_requested, Part& out) {
  const ThreadClock clock;
  const analysis::Measurement packing = measured(frozen, material, stop_requested);
  out.network_seconds += clock.seconds();
  const analysis::Network& network = packing.solved_network();
  const elastic::Matrix6& c = network.response.relaxed().matrix;
  out.isotropic.push_back(network.isotropic_relaxed().shear_modulus());
  out.planes.push_back((c(5, 5) + c(4, 4)) / 2);
  out.vertical.push_back(c(4, 4));
}

triaxial::FrozenState brought_to_rest(const dem::Specimen& state, const dem::Material& material,
                                      const StopRequest& stop_requested) {
  return triaxial::freeze_in_place(state, material, triaxial::usual_force_tolerance, stop_requested);
}

void measure(const dem::Specimen& state, const dem::Material& material, const StopRequest& stop_requested,
             Part& out) {
  const triaxial::FrozenState specimen = brought_to_rest(state, material, stop_requested);
  const dem::Specimen& at_rest = specimen.state();
  out.steps += specimen.report.steps;
  out.void_ratio.push_back(dem::void_ratio(at_rest));
  if (at_rest.walls)
    out.planes.push_back((probed(at_rest, material, triaxial::ShearMode::hh, 0, stop_requested, out) +
                          probed(at_rest, material, triaxial::ShearMode::vh, 0, stop_requested, out)) /
                         2);
  else
    measure_network(at_rest, material, stop_requested, out);
  if (out.probed_later)
    out.frozen.push_back(at_rest);
}

void compress(const TradeScene& trade, const Part& packing, const triaxial::SpecimenRecipe& specimen,
              const StopRequest& stop_requested, Part& out) {
  dem::QuasistaticOptions options = triaxial::compression_options();
  options.inertial_number = out.settings.compression;
  options.time_step_fraction = out.settings.time_step;
  options.stop_requested = stop_requested;
  const auto visit = [&](const triaxial::Snapshot& snapshot) {
    if (const std::string failure = failure_of(snapshot); !failure.empty())
      throw NotConverged(failure);
    out.steps += snapshot.report.steps;
    measure(snapshot.state, specimen.material, options.stop_requested, out);
    if (out.sheared_later && snapshot.pressure == trade.scene.study.pressures.back())
      out.state = snapshot.state;
    return true;
  };
  (void)triaxial::isotropic_path(
      triaxial::start_of_compression(packing.state, out.settings.density, specimen, options.stop_requested),
      specimen.material, trade.scene.study.pressures, options, visit);
  out.network_seconds /= static_cast<double>(trade.scene.study.pressures.size());
}

/// Point of the test at which G_vh is measured: within the reach of the dense plateau, well before the peak.
constexpr double measured_ratio = 0.8;

void shear(const TradeScene& trade, const Part& start, const dem::Material& material,
           const StopRequest& stop_requested, Part& out) {
  triaxial::ShearOptions options;
  options.mean_stress = trade.scene.study.pressures.back();
  options.inertial_number = out.settings.shear;
  options.time_step_fraction = out.settings.time_step;
  options.eta_step = measured_ratio;
  options.strain_step = options.largest_strain = trade.shear_strain;
  options.stop_requested = stop_requested;
  triaxial::ShearTest test(start.state, material, options);
  for (triaxial::ShearEvent event = test.advance(); event != triaxial::ShearEvent::finished;
       event = test.advance()) {
    if (event == triaxial::ShearEvent::stopped)
      throw Stopped();
    if (event == triaxial::ShearEvent::unstable)
      throw NotConverged("the shear test " + words(dem::Outcome::unstable));
    if (out.vertical.empty() && test.now().stress.ratio() >= measured_ratio)
      out.vertical.push_back(
          measured(brought_to_rest(test.engine().state(), material, stop_requested).state(), material,
                   stop_requested)
              .solved_network()
              .G_vh());
  }
  out.peak_ratio = test.peak().stress.ratio();
  out.steps = test.now().step;
}

/// Full approach of two grains under the mean contact force, over their diameter.
double mean_overlap_ratio(const dem::Specimen& state, const dem::Material& material) {
  const analysis::Forces forces =
      analysis::measure_forces(dem::contact_network(state, material), known_of(state, material), 1);
  return material.law.overlap(forces.distribution.mean) / (2 * state.radius);
}

void probe_all(const Part& start, const dem::Material& material, const StopRequest& stop_requested,
               Part& out) {
  for (const dem::Specimen& state : start.frozen)
    out.vertical.push_back(probed(state, material, triaxial::ShearMode::vh,
                                  out.settings.probe * mean_overlap_ratio(state, material), stop_requested,
                                  out));
}

void run_part(const TradeScene& trade, const std::vector<Part>& parts, const StopRequest& stop_requested,
              Part& out) {
  const triaxial::SpecimenRecipe recipe = recipe_of(trade, out.settings);
  if (out.kind == Kind::packing)
    return make(recipe, stop_requested, out);
  const Part& start = parts[out.before];
  if (!start.failure.empty())
    throw NotConverged(start.failure);
  if (out.kind == Kind::compression)
    compress(trade, start, recipe, stop_requested, out);
  else if (out.kind == Kind::shear)
    shear(trade, start, recipe.material, stop_requested, out);
  else
    probe_all(start, recipe.material, stop_requested, out);
}

constexpr const char* kind_names[] = {"packings", "compressions", "shear tests", "probes"};

Job job_of(const TradeScene& trade, const std::vector<Part>& parts, Meter& meter, Part& part) {
  const double cost = predicted_work(trade, part);
  const auto run = [&trade, &parts, &meter, &part, cost] {
    const ThreadClock clock;
    part.failure = failure_or_stop_of([&] {
      throw_if_stopped(meter.stop_request());
      run_part(trade, parts, meter.stop_request(), part);
    });
    part.cpu_seconds = clock.seconds();
    meter.add(cost, kind_names[static_cast<std::size_t>(part.kind)]);
  };
  return {.work = run, .cost = cost, .after = {}};
}

/// Does all parts, those of one kind side by side.
void run_parts(const TradeScene& trade, const RunControl& control, std::vector<Part>& parts) {
  Meter meter(control, predicted_work(trade));
  for (const Kind kind : {Kind::packing, Kind::compression, Kind::shear, Kind::probing}) {
    std::vector<Job> jobs;
    for (Part& part : parts)
      if (part.kind == kind)
        jobs.push_back(job_of(trade, parts, meter, part));
    side_by_side(jobs, thread_count(trade.scene));
  }
}

/// s as `granum verify` fits it.
std::optional<double> exponent_of(const TradeScene& trade, const std::vector<double>& shear_modulus,
                                  const std::vector<double>& void_ratio) {
  std::vector<hardin::MeasuredModulus> states;
  for (std::size_t k = 0; k < shear_modulus.size(); ++k) {
    const double pressure = trade.scene.study.pressures.at(k);
    states.push_back({shear_modulus[k], {pressure, pressure, void_ratio.at(k)}});
  }
  const std::optional<Measured> s = fitted_exponent(states);
  return s ? std::optional(s->value) : std::nullopt;
}

TradeSample read(const TradeScene& trade, const std::vector<Part>& parts, const Source& source) {
  TradeSample sample = source.sample;
  for (const std::size_t place : source.charged) {
    const Part& part = parts[place];
    sample.cpu_seconds += part.cpu_seconds;
    sample.steps += part.steps;
    if (sample.failure.empty())
      sample.failure = part.failure;
    if (part.kind == Kind::shear)
      sample.peak_ratio = part.peak_ratio;
  }
  const Part& measured = parts[source.measured];
  if (sample.varied == Varied::probe) { // one state and one modulus
    const bool by_network = measured.kind == Kind::compression;
    const std::size_t states = trade.scene.study.pressures.size();
    sample.cpu_seconds =
        by_network ? measured.network_seconds : sample.cpu_seconds / static_cast<double>(states);
    sample.steps = by_network ? 0 : sample.steps / states;
  }
  if (!sample.failure.empty()) {
    sample.peak_ratio.reset();
    return sample;
  }
  sample.shear_modulus = measured.*source.moduli;
  if (source.path != none)
    sample.exponent = exponent_of(trade, sample.shear_modulus, parts[source.path].void_ratio);
  return sample;
}

} // namespace

} // namespace trade

std::vector<TradeSample> run_trade(const TradeScene& trade, const RunControl& control) {
  require_valid(trade);
  trade::PlannedWork planned = trade::planned_work(trade);
  trade::run_parts(trade, control, planned.parts);
  std::vector<TradeSample> samples;
  for (const trade::Source& source : planned.sources)
    samples.push_back(trade::read(trade, planned.parts, source));
  return samples;
}

} // namespace granum::studies

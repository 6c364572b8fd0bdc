// SPDX-License-Identifier: GPL-3.0-or-later
#include "studies/trade/trade.hpp"

#include <algorithm>
#include <ctime>

#include <granum/analysis/measure.hpp>
#include <granum/core/error.hpp>
#include <granum/core/units.hpp>
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

triaxial::SpecimenRecipe recipe_of(const TradeScene& trade, const Packing& packing) {
  Scene scene = trade.scene;
  scene.study.grains = packing.grains;
  triaxial::SpecimenRecipe out = recipe(scene, scene.study.contacts.front(), packing.seed);
  if (packing.boundary == Boundary::smooth_walls)
    out.wall_friction = 0;
  if (packing.boundary == Boundary::rough_walls)
    out.wall_friction = out.material.friction_coefficient;
  return out;
}

void make(const TradeScene& trade, const StopRequest& stop_requested, Packing& packing) {
  triaxial::FrictionlessPacking made =
      triaxial::frictionless_specimen(recipe_of(trade, packing), stop_requested);
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
                     const StopRequest& stop_requested, Compression& out) {
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
             Compression& out) {
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

void compress(const TradeScene& trade, const Packing& packing, const Meter& meter, Compression& out) {
  const triaxial::SpecimenRecipe specimen = recipe_of(trade, packing);
  dem::QuasistaticOptions options = triaxial::compression_options();
  options.inertial_number = out.inertial_number;
  options.time_step_fraction = out.time_step_fraction;
  options.stop_requested = meter.stop_request();
  const auto visit = [&](const triaxial::Snapshot& snapshot) {
    if (!snapshot.report.converged())
      throw NotConverged("compression to " + pretty(snapshot.pressure, Dimension::pressure) + " " +
                         words(snapshot.report.outcome));
    out.steps += snapshot.report.steps;
    measure(snapshot.state, specimen.material, options.stop_requested, out);
    if (out.sheared_later && snapshot.pressure == trade.scene.study.pressures.back())
      out.last = snapshot.state;
    return true;
  };
  (void)triaxial::isotropic_path(
      triaxial::start_of_compression(packing.state, out.density, specimen, options.stop_requested),
      specimen.material, trade.scene.study.pressures, options, visit);
  out.network_seconds /= static_cast<double>(trade.scene.study.pressures.size());
}

/// Point of the test at which G_vh is measured: within the reach of the dense plateau, well before the peak.
constexpr double measured_ratio = 0.8;

void shear(const TradeScene& trade, const Compression& start, const dem::Material& material,
           const Meter& meter, Shear& out) {
  triaxial::ShearOptions options;
  options.mean_stress = trade.scene.study.pressures.back();
  options.inertial_number = out.inertial_number;
  options.time_step_fraction = out.time_step_fraction;
  options.eta_step = measured_ratio;
  options.strain_step = options.largest_strain = trade.shear_strain;
  options.stop_requested = meter.stop_request();
  triaxial::ShearTest test(start.last, material, options);
  for (triaxial::ShearEvent event = test.advance(); event != triaxial::ShearEvent::finished;
       event = test.advance()) {
    if (event == triaxial::ShearEvent::stopped)
      throw Stopped();
    if (event == triaxial::ShearEvent::unstable)
      throw NotConverged("the shear test " + words(dem::Outcome::unstable));
    if (!out.vertical && test.now().stress.ratio() >= measured_ratio)
      out.vertical =
          measured(brought_to_rest(test.engine().state(), material, options.stop_requested).state(), material,
                   options.stop_requested)
              .solved_network()
              .G_vh();
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

void probe_all(const Compression& start, const dem::Material& material, const StopRequest& stop_requested,
               Probing& out) {
  for (const dem::Specimen& state : start.frozen)
    out.shear_modulus.push_back(probed(state, material, triaxial::ShearMode::vh,
                                       out.amplitude * mean_overlap_ratio(state, material), stop_requested,
                                       out));
}

/// Does all parts, in the order in which they need each other.
class Runner {
 public:
  Runner(const TradeScene& trade, Work& work, const RunControl& control)
      : trade_(trade), work_(work), meter_(control, predicted_work(trade, work)) {}

  void run() {
    phase(work_.packings, "packings", [this](Packing& p) { make(trade_, meter_.stop_request(), p); });
    phase(work_.compressions, "compressions", [this](Compression& c) {
      const Packing& packing = work_.packings[c.packing];
      require_whole(packing);
      compress(trade_, packing, meter_, c);
    });
    phase(work_.shears, "shear tests", [this](Shear& s) {
      const Compression& start = work_.compressions[s.compression];
      require_whole(start);
      shear(trade_, start, material_of(start), meter_, s);
    });
    phase(work_.probings, "probes", [this](Probing& p) {
      const Compression& start = work_.compressions[p.compression];
      require_whole(start);
      probe_all(start, material_of(start), meter_.stop_request(), p);
    });
  }

 private:
  static void require_whole(const Part& part) {
    if (!part.failure.empty())
      throw NotConverged(part.failure);
  }

  [[nodiscard]] dem::Material material_of(const Compression& part) const {
    return recipe_of(trade_, work_.packings[part.packing]).material;
  }

  /// All parts of one kind side by side.
  template <class Kind, class Do>
  void phase(std::vector<Kind>& parts, const std::string& what, const Do& work) {
    std::vector<Job> jobs;
    for (Kind& part : parts) {
      const double cost = predicted_work(trade_, work_, part);
      const auto run = [this, cost, &part, &what, &work] {
        const ThreadClock clock;
        part.failure =
            meter_.stopped() ? words(dem::Outcome::stopped) : failure_or_stop_of([&] { work(part); });
        part.cpu_seconds = clock.seconds();
        meter_.add(cost, what);
      };
      jobs.push_back({.work = run, .cost = cost, .after = {}});
    }
    side_by_side(jobs, thread_count(trade_.scene));
  }

  const TradeScene& trade_;
  Work& work_;
  Meter meter_;
};

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

void charge(TradeSample& sample, const Part& part) {
  sample.cpu_seconds += part.cpu_seconds;
  sample.steps += part.steps;
  if (sample.failure.empty())
    sample.failure = part.failure;
}

const std::vector<double>& moduli_of(const Varied varied, const Compression& part) {
  switch (varied) {
  case Varied::probe:
    return part.vertical;
  case Varied::boundary:
    return part.planes;
  default:
    return part.isotropic;
  }
}

TradeSample read(const TradeScene& trade, const Work& work, const Source& source) {
  TradeSample sample = source.sample;
  const bool whole_specimen = sample.varied == Varied::grains || sample.varied == Varied::boundary;
  const Compression* compression =
      source.compression != none ? &work.compressions[source.compression] : nullptr;
  if (compression != nullptr) {
    charge(sample, *compression);
    if (whole_specimen)
      charge(sample, work.packings[compression->packing]);
    sample.shear_modulus = moduli_of(sample.varied, *compression);
    if (sample.failure.empty())
      sample.exponent = exponent_of(trade, sample.shear_modulus, compression->void_ratio);
  }
  if (source.shear != none) {
    const Shear& part = work.shears[source.shear];
    charge(sample, part);
    if (part.failure.empty())
      sample.peak_ratio = part.peak_ratio;
    if (compression == nullptr && part.vertical)
      sample.shear_modulus = {*part.vertical};
  }
  if (sample.varied == Varied::probe) {
    // One state and one modulus.
    sample.cpu_seconds = compression->network_seconds;
    sample.steps = 0;
    if (source.probing != none) {
      const Probing& part = work.probings[source.probing];
      const std::size_t states = trade.scene.study.pressures.size();
      sample.failure = part.failure;
      sample.cpu_seconds = part.cpu_seconds / static_cast<double>(states);
      sample.steps = part.steps / states;
      sample.shear_modulus = part.shear_modulus;
      if (sample.failure.empty())
        sample.exponent = exponent_of(trade, part.shear_modulus, compression->void_ratio);
    }
  }
  if (!sample.failure.empty()) {
    sample.shear_modulus.clear();
    sample.exponent.reset();
    sample.peak_ratio.reset();
  }
  return sample;
}

} // namespace

} // namespace trade

std::vector<TradeSample> run_trade(const TradeScene& trade, const RunControl& control) {
  require_valid(trade);
  trade::PlannedWork planned = trade::planned_work(trade);
  trade::Runner(trade, planned.work, control).run();
  std::vector<TradeSample> samples;
  for (const trade::Source& source : planned.sources)
    samples.push_back(trade::read(trade, planned.work, source));
  return samples;
}

} // namespace granum::studies

// SPDX-License-Identifier: GPL-3.0-or-later
// How long a step of the DEM engine takes, per grain, for specimens that the library prepares. It takes the
// options of Google Benchmark; the counter ns_per_grain_step is wall-clock time.
#include <benchmark/benchmark.h>

#include <chrono>
#include <cstddef>
#include <string>

#include <granum/dem/engine.hpp>
#include <granum/dem/quasistatic.hpp>

#include "specimens.hpp"

namespace {

using namespace granum;

using bench::material;
using bench::pressure;

/// Grain-steps while the cell is sheared to and fro at constant volume.
void add(const std::string& name, const dem::Specimen& start, double friction, std::size_t threads = 1) {
  const double grains = static_cast<double>(start.grain_count());
  benchmark::RegisterBenchmark(
      name.c_str(),
      [=](benchmark::State& run) {
        dem::Engine engine(start, material(friction));
        engine.set_threads(threads);
        dem::QuasistaticOptions settle;
        settle.max_steps = 3000;
        settle.inertial_number = 5e-3;
        (void)dem::equilibrate(engine, {pressure, pressure, pressure}, settle);
        const double rate = 5e-8 / engine.time_step();
        double steps = 0;
        const auto begin = std::chrono::steady_clock::now();
        for ([[maybe_unused]] auto iteration : run) {
          const double way = engine.steps() % 400 < 200 ? rate : -rate;
          engine.set_velocity_gradient(Mat3::diagonal(way, -way, 0));
          engine.step();
          ++steps;
        }
        const std::chrono::duration<double, std::nano> time = std::chrono::steady_clock::now() - begin;
        run.counters["ns_per_grain_step"] = time.count() / (steps * grains);
        run.counters["ns_per_contact_step"] =
            time.count() / (steps * static_cast<double>(engine.figures().contacts));
        run.counters["contacts_per_grain"] = static_cast<double>(engine.figures().contacts) / grains;
        run.counters["sliding_share"] =
            static_cast<double>(engine.figures().sliding) / static_cast<double>(engine.figures().contacts);
      })
      ->Unit(benchmark::kMicrosecond)
      ->UseRealTime();
}

} // namespace

int main(int argc, char** argv) {
  benchmark::Initialize(&argc, argv);
  if (benchmark::ReportUnrecognizedArguments(argc, argv))
    return 2;
  const dem::Specimen thousand = bench::thousand_grains();
  const dem::Specimen small = bench::repeated(thousand, 1, 1, 1);
  const dem::Specimen medium = bench::repeated(thousand, 5, 2, 1);
  add("friction/1000", small, 0.5);
  add("friction/10000", medium, 0.5);
  add("friction/10000/threads:2", medium, 0.5, 2);
  add("frictionless/10000", medium, 0);
  const dem::Specimen unequal =
      bench::repeated(bench::thousand_grains({}, sizes::Distribution::lognormal(0.35)), 5, 2, 1);
  add("friction, unequal/10000", unequal, 0.5);
  add("frictionless, unequal/10000", unequal, 0);
  add("smooth walls/1000", bench::thousand_grains(0), 0.5);
  add("friction/100000", bench::repeated(thousand, 5, 5, 4), 0.5);
  benchmark::RunSpecifiedBenchmarks();
  benchmark::Shutdown();
  return 0;
}

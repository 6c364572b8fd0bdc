// SPDX-License-Identifier: GPL-3.0-or-later
// What specimens of unequal grains cost beside equal ones: steps and processor time from nothing to rest at
// 10 and 100 kPa, and of one step of the engine there.
//   bench_sizes GRAINS SEED dense|loose SIZES...      as grain.sizes of a scene: bidisperse:8, power-law:3:8
// Prints a CSV table. Exit codes: 0 done, 1 something failed, 2 usage.
#include <cstdio>
#include <exception>
#include <string>
#include <vector>

#include <granum/dem/engine.hpp>
#include <granum/dem/neighbours.hpp>
#include <granum/packing/coordination.hpp>
#include <granum/sizes/distribution.hpp>
#include <granum/triaxial/specimen.hpp>

#include "meter.hpp"
#include "specimens.hpp"

using namespace granum;
using namespace granum::bench;

namespace {

/// CPU time of a step while the cell is sheared to and fro at constant volume [s].
double step_time(dem::Engine& engine) {
  constexpr int steps = 4000;
  const double rate = 5e-8 / engine.time_step();
  const Meter meter;
  for (int k = 0; k < steps; ++k) {
    const double way = k % 400 < 200 ? rate : -rate;
    engine.set_velocity_gradient(Mat3::diagonal(way, -way, 0));
    engine.step();
  }
  return meter.cpu_seconds() / steps;
}

void measure(const std::string& sizes, std::size_t count, std::uint64_t seed, triaxial::Density density) {
  const triaxial::SpecimenRecipe recipe{.material = material(0.5),
                                        .radius = radius,
                                        .sizes = sizes::parse_distribution(sizes),
                                        .grains = count,
                                        .seed = seed};
  const Meter meter;
  const triaxial::FrictionlessPacking made = triaxial::frictionless_specimen(recipe);
  const double made_in = meter.cpu_seconds();
  std::vector<std::size_t> steps;
  std::vector<double> seconds;
  dem::Specimen state;
  const bool arrived = triaxial::isotropic_path(triaxial::start_of_compression(made.state, density, recipe),
                                                recipe.material, {1e4, 1e5}, triaxial::compression_options(),
                                                [&](const triaxial::Snapshot& snapshot) {
                                                  steps.push_back(snapshot.report.steps);
                                                  seconds.push_back(meter.cpu_seconds());
                                                  state = snapshot.state;
                                                  return true;
                                                });
  if (steps.size() < 2)
    steps.resize(2), seconds.resize(2);
  const double grains = static_cast<double>(count);
  const packing::Assembly network = dem::contact_network(state, recipe.material);
  dem::Engine engine(state, recipe.material);
  const double step = step_time(engine), contacts = static_cast<double>(network.contacts.size());
  std::printf("%s,%.0f,%zu,%.2f,%.3f,%zu,%.2f,%zu,%zu,%.2f,%d,%.1f,%.1f,%.3g\n", sizes.c_str(), grains,
              triaxial::least_grains(recipe.sizes), contacts / grains,
              packing::mechanical_coordination(network, packing::ContactKind::frictional).rattler_fraction,
              made.minimiser_steps, made_in, steps[0], steps[1], seconds[1], arrived ? 1 : 0,
              1e9 * step / grains, 1e9 * step / contacts, engine.time_step());
  std::fflush(stdout);
}

} // namespace

int main(int argc, char** argv) {
  const std::string density = argc > 3 ? argv[3] : "";
  if (argc < 5 || (density != "dense" && density != "loose")) {
    std::fprintf(stderr, "usage: bench_sizes GRAINS SEED dense|loose SIZES...\n");
    return 2;
  }
  std::printf("sizes,grains,least_grains,contacts_per_grain,rattler_fraction,minimiser_steps,minimiser_s,"
              "steps_to_10kPa,steps_to_100kPa,specimen_s,at_rest,ns_per_grain_step,ns_per_contact_step,time_"
              "step_s\n");
  try {
    for (int k = 4; k < argc; ++k)
      measure(argv[k], std::stoul(argv[1]), std::stoull(argv[2]),
              density == "dense" ? triaxial::Density::dense : triaxial::Density::loose);
  } catch (const std::exception& error) {
    std::fprintf(stderr, "%s\n", error.what());
    return 1;
  }
  return 0;
}

// SPDX-License-Identifier: GPL-3.0-or-later
// Time and memory of the engine and of the network as specimens grow; bench/growth.sh runs it.
//   bench_growth pack dense|loose GRAINS SEED OUT.data at 10 kPa, loose: without its histories
//   bench_growth copies IN.data X Y Z OUT.data         so many copies along the axes, as a file
//   bench_growth network IN.data X Y Z THREADS         of such copies
//   bench_growth engine IN.data X Y Z STEPS THREADS
//   bench_growth specimen GRAINS SEED                  dense, from nothing to rest at 10 kPa, on one core
// Memory is the most that the process held beyond what it held before, over the grains.
// Prints a line of a CSV table. Exit codes: 0 done, 1 something failed, 2 usage.
#include <cstdint>
#include <cstdio>
#include <exception>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include <granum/dem/engine.hpp>
#include <granum/network/linear_response.hpp>
#include <granum/triaxial/specimen.hpp>

#include "meter.hpp"
#include "stored_packing.hpp"

using namespace granum;
using namespace granum::bench;

namespace {

triaxial::SpecimenRecipe recipe_of(std::size_t grains, std::uint64_t seed) {
  return {.material = material(friction), .radius = radius, .grains = grains, .seed = seed};
}

/// The specimen at rest at 10 kPa with friction.
dem::Specimen at_rest(const dem::Specimen& start, const dem::Material& grains) {
  dem::Specimen state;
  const bool arrived = triaxial::isotropic_path(start, grains, {1e4}, triaxial::compression_options(),
                                                [&](const triaxial::Snapshot& snapshot) {
                                                  state = snapshot.state;
                                                  return true;
                                                });
  if (!arrived)
    throw std::runtime_error("the specimen did not come to rest at 10 kPa");
  return state;
}

void pack(const std::string& density, std::size_t grains, std::uint64_t seed, const std::string& out) {
  if (density != "dense" && density != "loose")
    throw std::invalid_argument("'" + density + "' is neither dense nor loose");
  const triaxial::Density kind = density == "dense" ? triaxial::Density::dense : triaxial::Density::loose;
  const triaxial::SpecimenRecipe recipe = recipe_of(grains, seed);
  const dem::Specimen jammed = triaxial::frictionless_specimen(recipe).state;
  save_packing(at_rest(triaxial::start_of_compression(jammed, kind, recipe), recipe.material), out);
}

void prepare(std::size_t size, std::uint64_t seed) {
  const triaxial::SpecimenRecipe recipe = recipe_of(size, seed);
  const Meter meter;
  const triaxial::FrictionlessPacking preparation = triaxial::frictionless_specimen(recipe);
  const dem::Specimen state = at_rest(preparation.state, recipe.material);
  const double wall = meter.seconds(), cpu = meter.cpu_seconds();
  const double grains = static_cast<double>(size);
  std::printf("specimen,%.0f,1,%.4g,%.4g,%.0f,%zu,%.2g,%.4f\n", grains, wall, cpu, meter.bytes() / grains,
              preparation.minimiser_steps, preparation.last.unbalanced_force_ratio,
              2 * static_cast<double>(dem::contact_network(state, recipe.material).contacts.size()) / grains);
}

void solve(const dem::Specimen& state, bool copies, std::size_t threads) {
  const packing::Assembly assembly = network_of(state, copies);
  const Meter meter;
  const network::Response response = network::linear_response(assembly, {.threads = threads});
  const double grains = static_cast<double>(state.grain_count());
  std::printf(
      "network,%.0f,%zu,%.4g,%.4g,%.0f,%d,%.2g,%.4f\n", grains, threads, meter.seconds(), meter.cpu_seconds(),
      meter.bytes() / grains, response.report().iterations, response.report().residual,
      2 * static_cast<double>(response.report().contacts) / static_cast<double>(response.report().grains));
}

void step(dem::Specimen state, std::size_t steps, std::size_t threads) {
  const double grains = static_cast<double>(state.grain_count());
  const Meter whole;
  dem::Engine engine(std::move(state), material(friction));
  engine.set_threads(threads);
  for (int k = 0; k < 10; ++k)
    engine.step();
  const double bytes = whole.bytes() / grains;
  const double rate = 1e-5 / (static_cast<double>(steps) * engine.time_step());
  engine.set_velocity_gradient(Mat3::diagonal(rate, -rate, 0));
  const Meter meter;
  for (std::size_t k = 0; k < steps; ++k)
    engine.step();
  const double to_nanoseconds = 1e9 / (static_cast<double>(steps) * grains);
  std::printf("engine,%.0f,%zu,%.4g,%.4g,%.0f,%zu,,%.4f\n", grains, engine.threads(),
              to_nanoseconds * meter.seconds(), to_nanoseconds * meter.cpu_seconds(), bytes, steps,
              2 * static_cast<double>(engine.figures().contacts) / grains);
}

} // namespace

int main(int argc, char** argv) try {
  const std::vector<std::string> given(argv + 1, argv + argc);
  const std::string what = given.empty() ? "" : given[0];
  const auto copies = [&] {
    return side_by_side(load_packing(given[1]), count_of(given[2]), count_of(given[3]), count_of(given[4]));
  };
  if (what == "pack" && given.size() == 5)
    pack(given[1], count_of(given[2]), count_of(given[3]), given[4]);
  else if (what == "copies" && given.size() == 6)
    save_packing(copies(), given[5]);
  else if (what == "network" && given.size() == 6)
    solve(copies(), count_of(given[2]) * count_of(given[3]) * count_of(given[4]) > 1, count_of(given[5]));
  else if (what == "engine" && given.size() == 7)
    step(copies(), count_of(given[5]), count_of(given[6]));
  else if (what == "specimen" && given.size() == 3)
    prepare(count_of(given[1]), count_of(given[2]));
  else {
    std::fprintf(stderr, "usage: bench_growth pack dense|loose GRAINS SEED OUT | copies IN X Y Z OUT | "
                         "network IN X Y Z THREADS | engine IN X Y Z STEPS THREADS | specimen GRAINS SEED\n");
    return 2;
  }
  return 0;
} catch (const std::exception& error) {
  std::fprintf(stderr, "bench_growth: %s\n", error.what());
  return 1;
}

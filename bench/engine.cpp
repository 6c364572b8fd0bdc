// SPDX-License-Identifier: GPL-3.0-or-later
// How long a step of the DEM engine takes, per grain, for specimens that the library prepares. It takes the
// options of Google Benchmark; the counter ns_per_grain_step is wall-clock time.
#include <benchmark/benchmark.h>

#include <chrono>
#include <cstdint>
#include <string>

#include <granum/dem/engine.hpp>
#include <granum/dem/quasistatic.hpp>
#include <granum/triaxial/specimen.hpp>

namespace {

using namespace granum;

constexpr double radius = 5e-4;
constexpr double pressure = 1e5;
constexpr contact::GrainMaterial quartz{.shear_modulus = 30e9, .poisson_ratio = 0.15};

dem::Material material(double friction) {
  return {.law = contact::PowerLaw::sphere(quartz, radius),
          .tangential_stiffness_ratio = contact::mindlin_stiffness_ratio(quartz.poisson_ratio),
          .friction_coefficient = friction};
}

/// A dense specimen of 1,000 grains at 100 kPa.
dem::State thousand_grains() {
  const triaxial::SpecimenRecipe recipe{.material = material(0.5), .radius = radius};
  dem::Engine engine(triaxial::frictionless_specimen(recipe).state, recipe.material);
  (void)dem::equilibrate(engine, {pressure, pressure, pressure}, triaxial::compression_options());
  dem::State state = engine.state();
  state.history.clear();
  return state;
}

/// The periodic specimen `copies` times along each axis; each copy moves its own way, by some mm/s.
dem::State repeated(const dem::State& one, int nx, int ny, int nz) {
  dem::State all = one;
  all.cell = one.cell * Mat3::diagonal(nx, ny, nz);
  all.position.clear();
  std::uint64_t random = 1;
  const auto next = [&random] {
    random = random * 6364136223846793005u + 1442695040888963407u;
    return static_cast<double>(random >> 11) * 0x1p-53 - 0.5;
  };
  for (int x = 0; x < nx; ++x)
    for (int y = 0; y < ny; ++y)
      for (int z = 0; z < nz; ++z)
        for (const Vec3& at : one.position) {
          const Vec3 shift{static_cast<double>(x), static_cast<double>(y), static_cast<double>(z)};
          all.position.push_back(at + one.cell * shift);
        }
  all.velocity.clear();
  for (std::size_t g = 0; g < all.position.size(); ++g)
    all.velocity.push_back(2e-3 * Vec3{next(), next(), next()});
  all.angular_velocity.assign(all.position.size(), Vec3{});
  return all;
}

/// Grain-steps while the cell is sheared to and fro at constant volume.
void add(const std::string& name, const dem::State& start, double friction) {
  const double grains = static_cast<double>(start.grain_count());
  benchmark::RegisterBenchmark(
      name.c_str(),
      [=](benchmark::State& run) {
        dem::Engine engine(start, material(friction));
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
  const dem::State thousand = thousand_grains();
  const dem::State small = repeated(thousand, 1, 1, 1);
  const dem::State medium = repeated(thousand, 5, 2, 1);
  add("friction/1000", small, 0.5);
  add("friction/10000", medium, 0.5);
  add("frictionless/10000", medium, 0);
  add("friction/100000", repeated(thousand, 5, 5, 4), 0.5);
  benchmark::RunSpecifiedBenchmarks();
  benchmark::Shutdown();
  return 0;
}

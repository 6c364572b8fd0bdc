// SPDX-License-Identifier: GPL-3.0-or-later
#include "studies/plan/plan.hpp"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <utility>

#include <granum/core/error.hpp>
#include <granum/core/text.hpp>
#include <granum/dem/engine.hpp>
#include <granum/triaxial/specimen.hpp>

namespace granum::studies {

namespace {

// Steps for 1,000 grains, mean of 32 seeds of the default study; steps of probes, mean of four of them.

/// Of the first stage of loose specimens beyond the later ones: most of the network is built there.
double loose_first_stage_steps(contact::Shape shape) {
  using contact::Shape;
  constexpr std::pair<Shape, double> measured[] = {
      {Shape::cone, 1300}, {Shape::sphere, 21500}, {Shape::flat, 33500}};
  for (const auto& [known, steps] : measured)
    if (shape == known)
      return steps;
  return 12000;
}

// Compression and freezing together.
constexpr double dense_stage_steps = 400;
constexpr double loose_stage_steps = 2400;
constexpr double dense_probe_steps = 800; ///< of one of the three directions
constexpr double loose_probe_steps = 2600;
/// 27,000 of the minimiser, each at about half the cost of one with friction.
constexpr double preparation_steps = 14000;
/// Factor of the time with unequal grains: 1.8 with 500 and 2.4 with 1,000, mean of six
/// distributions and three seeds each (bench_sizes).
constexpr double unequal_preparation = 2.1;
/// The network's solution, in steps of the engine.
constexpr double network_steps = 600;

double grains_and_waves(const Scene& scene) {
  const double grains = static_cast<double>(scene.study.grains);
  return grains * std::cbrt(grains / 1000);
}

bool probed(const Scene& scene, double pressure) {
  return std::find(scene.study.probe_pressures.begin(), scene.study.probe_pressures.end(), pressure) !=
         scene.study.probe_pressures.end();
}

} // namespace

/// A lattice of touching spheres, shaken.
double measured_speed(const Scene& scene) {
  require_valid(scene);
  const triaxial::SpecimenRecipe specimen =
      recipe(scene, scene.study.contacts.front(), scene.study.first_seed);
  // 4 grains in a cubic cell
  const int edges =
      static_cast<int>(std::clamp(std::cbrt(static_cast<double>(scene.study.grains) / 4), 3.0, 14.0));
  const double edge = std::sqrt(2.0) * 2 * specimen.radius * (1 - 1e-5);
  dem::Specimen state;
  state.radius = specimen.radius;
  state.cell = Mat3::diagonal(edges * edge, edges * edge, edges * edge);
  for (int x = 0; x < edges; ++x)
    for (int y = 0; y < edges; ++y)
      for (int z = 0; z < edges; ++z)
        for (const Vec3& site : {Vec3{0, 0, 0}, Vec3{0.5, 0.5, 0}, Vec3{0.5, 0, 0.5}, Vec3{0, 0.5, 0.5}})
          state.position.push_back(edge * (site + Vec3{x + 0.25, y + 0.25, z + 0.25}));
  if (!specimen.sizes.is_equal())
    state.size.assign(state.grain_count(), 1.0); // each has its own radius, as far as the engine knows
  dem::Engine engine(state, specimen.material);
  using Clock = std::chrono::steady_clock;
  const auto start = Clock::now();
  double elapsed = 0;
  std::size_t steps = 0;
  while (elapsed < 0.1) {
    for (int k = 0; k < 20; ++k)
      engine.step();
    steps += 20;
    elapsed = std::chrono::duration<double>(Clock::now() - start).count();
  }
  // Twelve contacts a grain here, about five with the near misses in a disordered packing.
  constexpr double contacts_share = 0.55;
  return contacts_share * elapsed / (static_cast<double>(steps) * static_cast<double>(state.grain_count()));
}

double preparation_work(const Scene& scene) {
  const double slower = scene.grain.sizes.is_equal() ? 1 : unequal_preparation;
  return slower * preparation_steps * grains_and_waves(scene);
}

double stage_work(const Scene& scene, triaxial::Density density, contact::Shape shape, std::size_t stage) {
  const bool loose = density == triaxial::Density::loose;
  double steps = network_steps + (loose ? loose_stage_steps : dense_stage_steps);
  if (loose && stage == 0)
    steps += loose_first_stage_steps(shape);
  if (probed(scene, scene.study.pressures.at(stage)))
    steps += 3 * (loose ? loose_probe_steps : dense_probe_steps);
  return steps * grains_and_waves(scene);
}

double specimen_work(const Scene& scene, triaxial::Density density, contact::Shape shape) {
  double work = 0;
  for (std::size_t stage = 0; stage < scene.study.pressures.size(); ++stage)
    work += stage_work(scene, density, shape, stage);
  return work;
}

double total_work(const Scene& scene) {
  double work = 0;
  for (const contact::Shape shape : scene.study.contacts) {
    work += preparation_work(scene);
    for (const triaxial::Density density : scene.study.densities)
      work += specimen_work(scene, density, shape);
  }
  return work * static_cast<double>(scene.study.seeds);
}

Plan plan(const Scene& scene, double seconds_per_grain_step) {
  require_valid(scene);
  require_periodic_cell(scene);
  require_positive("seconds_per_grain_step", seconds_per_grain_step, "s");
  Plan out;
  out.packings = scene.study.contacts.size() * scene.study.seeds;
  out.specimens = out.packings * scene.study.densities.size();
  out.network_solutions = out.specimens * scene.study.pressures.size();
  const auto probed_stages = std::count_if(scene.study.pressures.begin(), scene.study.pressures.end(),
                                           [&](double p) { return probed(scene, p); });
  out.probes = 3 * out.specimens * static_cast<std::size_t>(probed_stages);
  out.grain_steps = total_work(scene);
  out.seconds_per_grain_step = seconds_per_grain_step;
  const double side_by_side = static_cast<double>(std::min(thread_count(scene), out.packings));
  out.seconds = out.grain_steps * out.seconds_per_grain_step / side_by_side;
  // Bytes of a grain: the frictionless packing that waits, and engine with network for each that runs
  // (measured).
  constexpr double waiting = 200, running = 12e3, program = 20e6;
  const double grains = static_cast<double>(scene.study.grains);
  out.memory = program + grains * (waiting * static_cast<double>(out.packings) +
                                   running * static_cast<double>(thread_count(scene)));
  return out;
}

std::string cost_of_sizes(const Scene& scene) {
  constexpr double widest_without_note = 5, rounding = 1e-9;
  const sizes::Distribution& sizes = scene.grain.sizes;
  if (sizes.size_ratio() <= widest_without_note * (1 + rounding))
    return {};
  return "grain.sizes span 1:" + short_text(sizes.size_ratio(), 2) +
         ": a step costs about as much as with equal grains, but a packing takes 2 to 5 times as long to "
         "make; its cell, wider than four of the largest grains, needs " +
         std::to_string(triaxial::least_grains(sizes)) +
         " grains or more; and many of the small ones carry no load";
}

} // namespace granum::studies

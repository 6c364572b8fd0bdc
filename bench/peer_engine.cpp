// SPDX-License-Identifier: GPL-3.0-or-later
// granum's side of bench/peers/run.sh: packs the specimens that all codes load, and times its own engine.
//   bench_peer_engine pack GRAINS OUT.data          equal spheres of quartz at 100 kPa, periodic
//   bench_peer_engine repeat IN.data X Y Z OUT.data copies of it side by side
//   bench_peer_engine scene IN.data                 what the other codes need to know: lines name=value, SI
//   bench_peer_engine run IN.data STEPS STRAIN THREADS
// `run` prints "state contacts pressure" [1, Pa] before and after the steps, and "took seconds cpu_seconds".
// Exit codes: 0 done, 1 something failed, 2 usage.
#include <chrono>
#include <cmath>
#include <cstdio>
#include <ctime>
#include <exception>
#include <filesystem>
#include <numbers>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include <granum/core/text.hpp>
#include <granum/dem/engine.hpp>
#include <granum/io/lammps/files.hpp>
#include <granum/io/output_file.hpp>
#include <granum/packing/forces.hpp>
#include <granum/triaxial/specimen.hpp>

#include "stored_packing.hpp"

using namespace granum;
using namespace granum::bench;

namespace {

constexpr double damping = 0.2; // of the contacts of the other codes, of critical [1]
// Of granum's stability limit, for all codes. granum itself runs at 0.8: it lends its grains a larger
// rotational inertia, the others do not, and need shorter steps.
constexpr double time_step_fraction = 0.2;

void pack(std::size_t grains, const std::filesystem::path& out) {
  save_packing(
      triaxial::frictionless_specimen(
          {.material = material(friction), .radius = radius, .grains = grains, .first_pressure = pressure})
          .state,
      out);
}

/// Before its first step, which moves nothing: its figures are those of the state that was loaded.
dem::Engine started(const dem::Specimen& state) {
  dem::Engine engine(state, material(friction));
  engine.set_time_step_fraction(time_step_fraction);
  engine.step();
  return engine;
}

void say_state(const dem::Engine& engine) {
  std::printf("state %zu %.10g\n", engine.figures().contacts, trace(engine.figures().stress) / 3);
}

void scene(const dem::Specimen& state) {
  const packing::Assembly frozen = dem::contact_network(state, material(friction));
  // The spring of equal stiffness in all contacts that bears the same mean stress, for laws without Hertz.
  double overlap_stress = 0; // of springs of 1 N/m, in their unit [1/m]
  double stiffness = 0;      // k_n of a contact in the mean [N/m]
  for (const packing::Contact& c : frozen.contacts) {
    overlap_stress += c.overlap * norm(c.branch) / (3 * frozen.volume());
    stiffness += c.normal_stiffness / static_cast<double>(frozen.contacts.size());
  }
  const double mean = trace(contact_stress(frozen).tensor) / 3;
  const double spring = mean / overlap_stress;
  const double hertz =
      4 * quartz.shear_modulus / (3 * (1 - quartz.poisson_ratio)); // f = hertz * a * overlap [Pa]
  const double pair_mass =
      2. / 3 * std::numbers::pi * std::pow(radius, 3) * material(friction).density;   // reduced [kg]
  const auto drag = [=](double k) { return 2 * damping * std::sqrt(k / pair_mass); }; // [1/s]
  const auto say = [](const char* name, double value) { std::printf("%s=%.17g\n", name, value); };
  std::printf("grains=%zu\ncontacts=%zu\n", frozen.grain_count(), frozen.contacts.size());
  say("pressure", mean);
  say("edge_x", state.cell(0, 0));
  say("edge_y", state.cell(1, 1));
  say("edge_z", state.cell(2, 2));
  say("radius", radius);
  say("density", material(friction).density);
  say("young", 2 * quartz.shear_modulus * (1 + quartz.poisson_ratio));
  say("poisson", quartz.poisson_ratio);
  say("friction", friction);
  say("hertz_normal", hertz);
  say("hertz_tangential", 4 * quartz.shear_modulus / (2 - quartz.poisson_ratio));
  say("hertz_drag",
      drag(stiffness) * 1.5 * hertz / stiffness); // per contact radius a = k_n/(1.5 hertz) [1/(s m)]
  say("spring_normal", spring);
  say("spring_tangential", spring * material(friction).tangential_ratio);
  say("spring_drag", drag(spring));
  say("time_step", started(state).time_step());
}

/// Biaxial strain at constant volume: longer along x, shorter along y.
void run(const dem::Specimen& state, std::size_t steps, double strain, std::size_t threads) {
  dem::Engine engine = started(state);
  engine.set_threads(threads); // specimens below 2,048 grains take one all the same
  say_state(engine);
  const double rate = strain / (static_cast<double>(steps) * engine.time_step());
  engine.set_velocity_gradient(Mat3::diagonal(rate, -rate, 0));
  const std::clock_t cpu = std::clock();
  const auto begin = std::chrono::steady_clock::now();
  for (std::size_t k = 0; k < steps; ++k)
    engine.step();
  const std::chrono::duration<double> seconds = std::chrono::steady_clock::now() - begin;
  // As if every thread that was granted had run: those that the engine does not use ask for no core.
  const double used = static_cast<double>(engine.threads()) / static_cast<double>(threads);
  const double cpu_seconds = static_cast<double>(std::clock() - cpu) / CLOCKS_PER_SEC / used;
  say_state(engine);
  std::printf("took %.6g %.6g\n", seconds.count(), cpu_seconds);
}

} // namespace

int main(int argc, char** argv) try {
  const std::vector<std::string> given(argv + 1, argv + argc);
  const std::string what = given.empty() ? "" : given[0];
  if (what == "pack" && given.size() == 3)
    pack(count_of(given[1]), given[2]);
  else if (what == "repeat" && given.size() == 6)
    save_packing(
        side_by_side(load_packing(given[1]), count_of(given[2]), count_of(given[3]), count_of(given[4])),
        given[5]);
  else if (what == "scene" && given.size() == 2)
    scene(load_packing(given[1]));
  else if (what == "run" && given.size() == 5)
    run(load_packing(given[1]), count_of(given[2]), parse_number(given[3]).value(), count_of(given[4]));
  else {
    std::fprintf(stderr, "usage: bench_peer_engine pack GRAINS OUT | repeat IN X Y Z OUT | scene IN | "
                         "run IN STEPS STRAIN THREADS\n");
    return 2;
  }
  return 0;
} catch (const std::exception& error) {
  std::fprintf(stderr, "bench_peer_engine: %s\n", error.what());
  return 1;
}

// SPDX-License-Identifier: GPL-3.0-or-later
#include "studies/plan/plan.hpp"

#include <granum/sizes/distribution.hpp>

#include "unit.hpp"

using namespace granum::studies;
using contact::Shape;
using triaxial::Density;

namespace {
constexpr double speed = 2e-7; ///< of an imagined machine [s per grain and step]
}

TEST_CASE("the work of a study is that of its parts, and a plan counts what a study runs") {
  Scene scene;
  scene.study.seeds = 2;
  scene.study.grains = 200;
  double parts = 0;
  for (const Shape shape : scene.study.contacts) {
    parts += preparation_work(scene);
    for (const Density density : scene.study.densities)
      for (std::size_t stage = 0; stage < scene.study.pressures.size(); ++stage)
        parts += stage_work(scene, density, shape, stage);
  }
  CHECK(parts > 0);
  CHECK(total_work(scene) == relative(2 * parts, 1e-12)); // rounding of 60 terms
  const Plan planned = plan(scene, speed);
  CHECK(planned.packings == 6);
  CHECK(planned.specimens == 12);
  CHECK(planned.network_solutions == 120);
  CHECK(planned.probes == 108); // three directions at three pressures
  CHECK(planned.grain_steps == total_work(scene));
  CHECK(planned.seconds_per_grain_step == speed);
  // Packings wait, and as many run as there are threads: memory is a sum of parts.
  const auto memory = [&](std::size_t grains, std::size_t seeds, std::size_t threads) {
    scene.study.grains = grains;
    scene.study.seeds = seeds;
    scene.study.threads = threads;
    return plan(scene, speed).memory;
  };
  const double one = memory(1000, 2, 1), waiting = memory(1000, 4, 1) - one,
               running = memory(1000, 2, 2) - one;
  CHECK((waiting > 1000 * 6 * 24.0 && running > 5 * waiting)); // six more packings, places of grains alone
  CHECK(one == relative(20e6 + waiting + running, 1e-12));
  CHECK(memory(1000, 6, 4) == relative(one + 2 * waiting + 3 * running, 1e-12));
  CHECK(memory(3000, 2, 1) == relative(one + 2 * (waiting + running), 1e-12));
}

TEST_CASE(
    "steps grow as the number of grains and the time of a wave, and by the first loose stage and probes") {
  Scene scene;
  const std::vector<double> pressures = scene.study.pressures;
  const auto work = [&](Density density, std::size_t stage, std::size_t grains = 1000) {
    scene.study.grains = grains;
    return stage_work(scene, density, Shape::sphere, stage);
  };
  scene.study.grains = 1000;
  // 27,000 steps of the minimiser, each at about half the cost of one with friction
  CHECK(preparation_work(scene) == relative(27000 * 1000 / 2, 0.05));
  for (const Density density : {Density::loose, Density::dense}) {
    CHECK(work(density, 1, 8000) == relative(16 * work(density, 1), 1e-12));
    scene.study.probe_pressures.clear();
    const double first = work(density, 0), bare = work(density, 1);
    CHECK((first > bare) == (density == Density::loose));
    scene.study.probe_pressures = {pressures[1]};
    CHECK(work(density, 1) > bare);
    CHECK(work(density, 0) == first);
  }
  // Steps for 1,000 grains: 600 for the network, 400 or 2,400 of a stage, three times 800 or 2,600 of probes.
  scene.study.probe_pressures = {pressures[1]};
  const double steps[] = {work(Density::dense, 2), work(Density::dense, 1), work(Density::loose, 2),
                          work(Density::loose, 1), work(Density::loose, 0)};
  const double expected[] = {1000, 3400, 3000, 10800, 24500};
  for (int k = 0; k < 5; ++k)
    CHECK(steps[k] == relative(1000 * expected[k], 1e-12));
  CHECK(stage_work(scene, Density::loose, Shape::flat, 0) >
        stage_work(scene, Density::loose, Shape::cone, 0));
}

TEST_CASE("unequal grains take longer to pack, and as long as equal ones from there on") {
  Scene equal, unequal;
  unequal.grain.sizes = sizes::parse_distribution("lognormal:0.35");
  CHECK(preparation_work(unequal) > 1.8 * preparation_work(equal)); // measured: 1.8 and 2.4
  CHECK(preparation_work(unequal) < 2.4 * preparation_work(equal));
  CHECK(specimen_work(unequal, Density::loose, Shape::sphere) ==
        specimen_work(equal, Density::loose, Shape::sphere));
  CHECK(plan(unequal, speed).grain_steps == total_work(unequal));
  unequal.study.grains = 293; // the cell would be narrower than four of the largest
  CHECK_THROWS_WITH_AS((void)plan(unequal, speed), doctest::Contains("294"), InvalidArgument);
  unequal.study.grains = 294;
  CHECK(std::isfinite(measured_speed(unequal)));
}

TEST_CASE("the predicted time shares the work among threads, no more than there are packings") {
  Scene scene;
  scene.study.contacts = {Shape::sphere};
  scene.study.seeds = 2;
  scene.study.grains = 40;
  for (const auto& [threads, sharing] : {std::pair{1, 1}, {2, 2}, {64, 2}}) {
    scene.study.threads = static_cast<std::size_t>(threads);
    const Plan planned = plan(scene, speed);
    CHECK(planned.seconds == relative(total_work(scene) * speed / sharing, 1e-12));
  }
}

TEST_CASE("an impossible scene has no plan, and the engine's speed can be measured for every law") {
  Scene scene;
  for (const Shape shape : Scene{}.study.contacts) {
    scene.study.contacts = {shape};
    const double measured = measured_speed(scene);
    CHECK((measured > 0 && std::isfinite(measured)));
  }
  scene.study.pressures = {10e3};
  CHECK_THROWS_AS((void)plan(scene, speed), InvalidArgument);
  CHECK_THROWS_AS((void)measured_speed(scene), InvalidArgument);
  for (const double wrong : {0.0, -1.0})
    CHECK_THROWS_AS((void)plan(Scene{}, wrong), InvalidArgument);
}

TEST_CASE("sizes that span up to 1:5 have no note on their cost, wider ones do") {
  const auto cost = [](const char* sizes) {
    Scene scene;
    scene.grain.sizes = sizes::parse_distribution(sizes);
    return cost_of_sizes(scene);
  };
  for (const char* sizes : {"equal", "uniform:1:3", "lognormal:0.25", "power-law:3:5", "bidisperse:5:0.1"})
    CHECK(cost(sizes) == "");
  for (const char* sizes : {"uniform:1:6", "power-law:3:6", "bidisperse:6:0.1"})
    CHECK(cost(sizes).find("1:6") != std::string::npos);
  CHECK(cost("power-law:3:10").find("760") != std::string::npos); // grains or more
}

// SPDX-License-Identifier: GPL-3.0-or-later
#include "studies/reproduce/experiment.hpp"

#include <atomic>
#include <filesystem>
#include <fstream>
#include <numbers>
#include <numeric>
#include <set>

#include <sys/stat.h>

#include "studies/plan/plan.hpp"
#include <granum/triaxial/specimen.hpp>

#include "io/temporary_folder.hpp"
#include "unit.hpp"

using namespace granum::studies;
using contact::Shape;
using stress::ShearPath;
using triaxial::Density;
namespace fs = std::filesystem;

namespace {

/// Seconds: few grains, two paths, short of the peak.
Scene small_scene() {
  Scene scene;
  scene.study.grains = 80;
  scene.study.contacts = {Shape::sphere};
  scene.study.densities = {Density::dense};
  scene.study.pressures = {25e3, 50e3, 100e3};
  scene.study.probe_pressures = {100e3};
  scene.shear.paths = {ShearPath::txc, ShearPath::rtxe};
  scene.shear.inertial_number = 1e-3;
  scene.shear.largest_strain = 5e-4;
  scene.shear.eta_step = 0.2;
  scene.shear.strain_step = 2.5e-4;
  scene.shear.probe_eta_step = 0.4;
  scene.study.threads = 1;
  return scene;
}

void check_same(const Experiment& a, const Experiment& b) {
  REQUIRE(a.specimens.size() == b.specimens.size());
  for (std::size_t s = 0; s < a.specimens.size(); ++s) {
    REQUIRE(a.specimens[s].runs.size() == b.specimens[s].runs.size());
    CHECK(a.specimens[s].end_of_iso == b.specimens[s].end_of_iso);
    for (std::size_t r = 0; r < a.specimens[s].runs.size(); ++r) {
      const PathRun &x = a.specimens[s].runs[r], &y = b.specimens[s].runs[r];
      CHECK(x.path == y.path);
      CHECK(x.failure == "");
      CHECK(y.failure == "");
      CHECK(x.points == y.points);
      CHECK(x.curve == y.curve);
      CHECK(x.peak == y.peak);
      CHECK(x.steps == y.steps);
      REQUIRE(x.loops.size() == y.loops.size());
      for (std::size_t k = 0; k < x.loops.size(); ++k) {
        REQUIRE(x.loops[k].points.size() == y.loops[k].points.size());
        CHECK(x.loops[k].points.back().shear_stress == y.loops[k].points.back().shear_stress);
      }
    }
  }
}

} // namespace

TEST_CASE("an experiment compresses, shears, and freezes according to the scene") {
  Scene scene = small_scene();
  scene.shear.inertial_number = 2e-4; // the servos hold the other stress the better, the slower the path
  const Experiment experiment = run_experiment(scene);
  REQUIRE(experiment.complete());
  REQUIRE(experiment.specimens.size() == 1);
  const std::vector<PathRun>& runs = experiment.specimens.front().runs;
  REQUIRE(runs.size() == 3);

  const PathRun& iso = runs[0];
  CHECK(name(iso.path) == "ISO");
  REQUIRE(iso.points.size() == 3);
  for (std::size_t k = 0; k < 3; ++k) {
    CHECK(iso.points[k].at.stress.mean() == relative(scene.study.pressures[k], 1e-5));
    CHECK(iso.points[k].probes.has_value() == (k == 2));
    const triaxial::PathPoint& at = iso.points[k].at;
    CHECK(at.stress_difference < 1e-4 * at.stress.mean());
    CHECK(std::abs(at.stress.ratio()) < 1e-4);
    // The volume of the grains stays, and the cell shrinks about as much along each axis.
    CHECK(std::abs(at.volumetric_strain -
                   std::log((1 + iso.points[0].void_ratio) / (1 + iso.points[k].void_ratio))) < 1e-12);
    CHECK(std::abs(at.axial_strain - at.volumetric_strain / 3) <= 0.2 * at.volumetric_strain);
  }
  CHECK(iso.points[0].at.volumetric_strain == 0);
  CHECK(iso.steps == iso.points[0].at.step + iso.points[1].at.step + iso.points[2].at.step);
  CHECK((iso.largest_inertial_number > 0 && iso.largest_inertial_number < 0.01));
  CHECK(iso.notes.empty());
  CHECK(iso.points[2].at.volumetric_strain > iso.points[1].at.volumetric_strain);
  CHECK(iso.points[2].void_ratio < iso.points[0].void_ratio);

  for (std::size_t r : {std::size_t{1}, std::size_t{2}}) {
    const PathRun& run = runs[r];
    const double sense = stress::is_compression(*run.path) ? 1 : -1;
    CHECK(run.path == scene.shear.paths[r - 1]);
    REQUIRE(run.points.size() >= 3);
    CHECK(run.curve.size() > 2 * run.points.size());
    CHECK(std::abs(run.curve.back().axial_strain) >= scene.shear.largest_strain);
    CHECK(sense * run.curve[1].stress.ratio() == relative(scene.shear.eta_step / 5, 0.1));
    CHECK(run.path_error < 0.02);
    for (const triaxial::PathPoint& point : run.curve)
      CHECK(sense * point.stress.ratio() <= sense * run.peak.stress.ratio());
    CHECK(std::ranges::any_of(run.points, [&](const StateRecord& point) {
      return std::abs(point.at.axial_strain) == relative(scene.shear.strain_step, 0.02);
    }));
    double next = scene.shear.eta_step;
    for (const StateRecord& point : run.points) {
      const double eta = sense * point.at.stress.ratio();
      // Frozen just behind the multiple: a snapshot is taken in the step that passes it.
      if (eta >= next) {
        CHECK(eta == relative(next, 0.02));
        next += scene.shear.eta_step;
      }
      CHECK(point.at.stress.h == relative(100e3, 0.02)); // both paths hold the horizontal stress
      // The frozen state is that of the path, at rest.
      CHECK(std::abs(point.stress.v - point.at.stress.v) < 0.02 * point.at.stress.mean());
      CHECK(point.unbalanced_force_ratio <= 1e-4);
      CHECK(point.closed.has_value());
      // The network is softer than uniform strain.
      CHECK(point.G_vh() < (point.affine[21] + point.affine[28]) / 2);
    }
    CHECK(next > 2 * scene.shear.eta_step);
  }
}

TEST_CASE("stored results of a frozen state are consistent: probes, cycles, histograms and its network") {
  const std::vector<PathRun> runs = run_experiment(small_scene()).specimens.front().runs;
  std::size_t probed = 0;
  for (const PathRun& run : runs)
    for (const StateRecord& point : run.points) {
      if (point.probes) {
        ++probed;
        CHECK(point.probes->G_hh == relative(point.network[35], 0.01));
        CHECK(point.probes->G_vh == relative(point.network[28], 0.01)); // the x z plane
        CHECK(point.probes->G_hv == relative(point.probes->G_vh, 0.01));
      }
      const auto by_angle = std::reduce(point.polar_counts.begin(), point.polar_counts.end(), 0U),
                 by_force = std::reduce(point.force_counts.begin(), point.force_counts.end(), 0U);
      CHECK(by_angle == point.contacts);
      CHECK(by_force <= point.contacts);
      CHECK(by_force > 0.95 * point.contacts); // few press with more than 8 times the mean
      CHECK(2.0 * point.contacts / 80 == relative(point.micro.coordination_number, 1e-14));
      CHECK(trace(point.fabric) == relative(1, 1e-12));
      CHECK(point.coordination_number_all == point.micro.coordination_number);
      CHECK(point.interior_void_ratio == point.void_ratio);
      CHECK(
          (point.G_hh() == point.network[35] && point.G_vh() == (point.network[21] + point.network[28]) / 2));
    }
  CHECK(probed >= 3);
  // Cycles of shear are kept of TXC.
  CHECK((runs[0].loops.empty() && runs[2].loops.empty()));
  REQUIRE(runs[1].loops.size() >= 2);
  const ShearLoop& first = runs[1].loops.front();
  CHECK(std::abs(first.eta) < 1e-5); // the servos hold the stresses to 1e-6
  CHECK(first.points.front().shear_strain == 0);
  CHECK(first.points.back().shear_strain == relative(1e-5, 1e-9));
  CHECK(runs[1].loops[1].eta == relative(0.5, 0.06)); // the fast path of this scene overshoots
}

TEST_CASE("an experiment is the same bits on two threads, from its checkpoints, and stopped repeatedly") {
  double done = 0; // no work is counted twice, and none is left
  const auto count = [&](const Progress& progress) {
    CHECK(progress.done >= done);
    done = progress.done;
  };
  const Experiment one = run_experiment(small_scene(), {.report = count});
  CHECK(done == relative(1, 1e-12));
  Scene scene = small_scene();
  scene.study.threads = 2;
  const TemporaryFolder whole, parts;
  for (const char* from : {"the engine", "its checkpoints"}) {
    CAPTURE(from);
    check_same(one, run_experiment(scene, {}, {.folder = whole.path(), .scene_text = "scene"}));
  }
  const CheckpointFolder checkpoints{.folder = parts.path(), .scene_text = "scene"};
  int rounds = 0;
  for (bool complete = false; !complete && rounds < 30; ++rounds) {
    std::atomic<bool> stop = false;
    std::size_t reports = 0;
    double before = 0;
    // The second report of a round is the first of its own work, as soon as something was found.
    const auto report = [&](const Progress& progress) {
      CHECK(progress.done >= before);
      before = progress.done;
      if (progress.done > progress.done_before && ++reports >= 2)
        stop = true;
    };
    complete = run_experiment(small_scene(), {.report = report, .stop = &stop}, checkpoints).complete();
  }
  CHECK(rounds > 3);
  check_same(one, run_experiment(small_scene(), {}, checkpoints));
}

/// The progress that is shown weighs the pieces by these steps.
TEST_CASE("the predicted steps of a stress path follow from its rate, and from the states that are frozen") {
  const auto predicted = [](const Scene& scene) { // of all paths
    std::atomic<bool> stop = false;
    double first = 0; // share of the first piece, a packing
    const auto report = [&](const Progress& progress) {
      first = stop ? first : progress.done;
      stop = true;
    };
    (void)run_experiment(scene, {.report = report, .stop = &stop});
    const double packing = preparation_work(scene);
    return (packing / first - packing - specimen_work(scene, Density::dense, Shape::sphere)) / 80;
  };
  Scene scene = small_scene();
  const auto of = [&](ShearPath path) {
    scene.shear.paths = {path};
    return predicted(scene);
  };
  const double txc = of(ShearPath::txc);
  CHECK(of(ShearPath::rtxe) == relative(txc, 1e-9));
  CHECK(of(ShearPath::rtxc) == relative(txc * 1.5 / 0.95, 1e-9));
  CHECK(of(ShearPath::txe) == relative(txc * 0.6 / 0.95, 1e-9));
  const double of_point = 0.95 * 1000 * std::cbrt(0.08); // steps
  scene.shear.paths = {ShearPath::txc};
  scene.shear.eta_step = 0.1;
  CHECK(predicted(scene) - txc == relative(5 * of_point, 1e-6));
  scene.shear.eta_step = 0.2;
  scene.shear.strain_step = 1.25e-4;
  CHECK(predicted(scene) - txc == relative(2 * of_point, 1e-6));
  const double d = 2 * scene.grain.radius, p = 100e3, rho = scene.grain.density;
  const double seconds = scene.shear.largest_strain * d * std::sqrt(rho / p) / scene.shear.inertial_number;
  const double mass = rho * std::numbers::pi / 6 * std::pow(d, 3);
  const double oscillation = std::sqrt(mass / law(scene, Shape::sphere).stiffness_at_force(p * d * d));
  CHECK(txc - 7 * of_point == relative(0.95 * seconds / (0.5 * oscillation), 1e-6));
}

TEST_CASE("a checkpoint in the place of another specimen's, path's or piece's is refused") {
  Scene scene = small_scene();
  scene.study.densities = {Density::dense, Density::loose};
  scene.study.seeds = 2;
  const TemporaryFolder folder;
  const CheckpointFolder checkpoints{.folder = folder.path(), .scene_text = "scene"};
  REQUIRE(run_experiment(scene, {}, checkpoints).complete());
  std::vector<fs::path> files;
  for (const auto& entry : fs::directory_iterator(folder.path()))
    files.push_back(entry.path());
  REQUIRE(files.size() == 14); // two packings, four compressions, eight paths
  const fs::path aside = folder.path() / "aside";
  std::size_t swaps = 0;
  for (const fs::path& a : files)
    for (const fs::path& b : files)
      if (a < b) {
        const auto swap = [&] {
          fs::rename(a, aside);
          fs::rename(b, a);
          fs::rename(aside, b);
        };
        swap();
        CHECK_THROWS_AS((void)run_experiment(scene, {}, checkpoints), FileError);
        swap();
        ++swaps;
      }
  CHECK(swaps == 91);
  CHECK(run_experiment(scene, {}, checkpoints).complete());
}

TEST_CASE("checkpoints are of one scene, and are removed by their names, and nothing else is") {
  Scene scene = small_scene();
  scene.study.contacts = {Shape::power_law};
  scene.study.pressures = {80e3, 90e3, 100e3};
  const auto run = [&](const fs::path& folder, const char* text) {
    return run_experiment(scene, {}, {.folder = folder, .scene_text = text});
  };
  const TemporaryFolder folder;
  const auto files = [&] {
    std::set<std::string> names;
    for (const auto& entry : fs::directory_iterator(folder.path()))
      names.insert(entry.path().filename().string());
    return names;
  };
  REQUIRE(run(folder.path(), "one").complete());
  CHECK_THROWS_AS((void)run(folder.path(), "other"), FileError);
  REQUIRE(files().size() >= 3);
  // As a run with another seed leaves them that was killed while it wrote.
  std::ofstream(folder.path() / "sphere-loose-12-rtxe.checkpoint.granum.part") << "x";
  std::ofstream(folder.path() / "flat-7-packing.checkpoint") << "x";
  const std::set<std::string> foreign{"notes.txt",
                                      "sphere-dense-1-txc.checkpoint.bak",
                                      "sphere-dense-1-txc",
                                      "sphere-dense-x-txc.checkpoint",
                                      "cube-dense-1-txc.checkpoint",
                                      "sphere-dense-1-TXC.checkpoint",
                                      "sphere-dense-1-packing.checkpoint",
                                      "sphere-1-packing.checkpoint.part"};
  for (const std::string& name : foreign)
    std::ofstream(folder.path() / name) << "x";
  fs::create_directory(folder.path() / "cone-1-packing.checkpoint");
  REQUIRE(mkfifo((folder.path() / "cone-2-packing.checkpoint").c_str(), 0600) == 0);
  CHECK_THROWS_AS((void)run(folder.path() / "notes.txt", "one"), FileError); // a file in place of the folder
  remove_checkpoints(folder.path());
  std::set<std::string> left = foreign;
  left.insert({"cone-1-packing.checkpoint", "cone-2-packing.checkpoint"});
  CHECK(files() == left);
  remove_checkpoints(folder.path() / "none");
}

TEST_CASE("a scene that no experiment can have is refused, between walls one of too few interior grains") {
  const auto refused = [](auto change) {
    Scene scene = small_scene();
    change(scene);
    CHECK_THROWS_AS((void)run_experiment(scene), InvalidArgument);
  };
  refused([](Scene& s) { s.shear.eta_step = 0; });
  refused([](Scene& s) { s.shear.paths = {ShearPath::txc, ShearPath::txc}; });
  refused([](Scene& s) { s.specimen = {.walls = true, .wall_friction = -1}; });
  // of the densest packing in a box of ten radii: 1000/(4/3 pi 1.55) = 154.02
  refused([](Scene& s) { s.specimen.walls = true, s.study.grains = 153; });
  Scene scene = small_scene();
  scene.study.grains = 155;
  scene.specimen.walls = true;
  CHECK_NOTHROW(require_valid(scene));
}

// SPDX-License-Identifier: GPL-3.0-or-later
#include "studies/reproduce/experiment.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <regex>
#include <system_error>

#include "studies/plan/plan.hpp"
#include <granum/core/error.hpp>
#include <granum/io/output_file.hpp>

#include "path_run.hpp"
#include "studies/running/outcome_text.hpp"

namespace granum::studies {

namespace {

namespace fs = std::filesystem;

// ---- work

double packing_steps(const Scene& scene) {
  return preparation_work(scene) / static_cast<double>(scene.study.grains);
}

double isotropic_steps(const Scene& scene, contact::Shape contact, triaxial::Density density) {
  return specimen_work(scene, density, contact) / static_cast<double>(scene.study.grains);
}

/// Time of a path over the mean of all four (measured): longer at lower stresses, and with more frozen states
/// up to a peak.
double share_of(stress::ShearPath path) {
  return path == stress::ShearPath::rtxc ? 1.5 : path == stress::ShearPath::txe ? 0.6 : 0.95;
}

/// The time to a strain follows from the inertial number, the time step from the stiffness of a contact at
/// the mean force; their quotient is the number of steps.
double shear_steps(const Scene& scene, contact::Shape contact, stress::ShearPath path) {
  const double pressure = scene.study.pressures.back(), diameter = 2 * scene.grain.radius;
  const double rate = scene.shear.inertial_number / (diameter * std::sqrt(scene.grain.density / pressure));
  const double force = diameter * diameter * pressure; // about the mean
  const double mass = scene.grain.density * std::numbers::pi / 6 * diameter * diameter * diameter;
  constexpr double step_over_period = 0.5; // measured
  const double step = step_over_period * std::sqrt(mass / law(scene, contact).stiffness_at_force(force));
  constexpr double peak_eta = 1; // about; past it states are frozen by axial strain
  const double points =
      peak_eta / scene.shear.eta_step + scene.shear.largest_strain / scene.shear.strain_step;
  // Freezing a state and solving its network cost as many steps, for 1,000 grains.
  constexpr double frozen_point_steps = 1000;
  const double waves = std::cbrt(static_cast<double>(scene.study.grains) / 1000);
  return share_of(path) * (scene.shear.largest_strain / (rate * step) + points * frozen_point_steps * waves);
}

double experiment_steps(const Scene& scene) {
  double steps = 0;
  for (const contact::Shape contact : scene.study.contacts) {
    steps += packing_steps(scene);
    for (const triaxial::Density density : scene.study.densities) {
      steps += isotropic_steps(scene, contact, density);
      for (const stress::ShearPath path : scene.shear.paths)
        steps += shear_steps(scene, contact, path);
    }
  }
  return steps * static_cast<double>(scene.study.seeds);
}

// ---- the pieces: packings, isotropic compressions, stress paths

/// Each piece begins once the one that it starts from is done, side by side with others.
class Pieces {
 public:
  Pieces(const Scene& scene, const RunControl& control, const CheckpointFolder& checkpoints)
      : scene_(scene), checkpoints_(checkpoints), meter_(control, experiment_steps(scene)) {}

  std::vector<ExperimentSpecimen> run() && {
    for (const SpecimenName& of : specimens_of(scene_)) {
      specimens_.push_back({of.contact, of.density, of.seed, {}, {}});
      packing_of_.push_back(of.packing);
    }
    packings_.resize(scene_.study.contacts.size() * scene_.study.seeds);
    std::vector<Job> jobs(packings_.size());
    for (std::size_t k = 0; k < specimens_.size(); ++k) {
      const ExperimentSpecimen& of = specimens_[k];
      Job& packing = jobs[packing_of_[k]]; // the last specimen that needs it asks for it
      packing = {.work = [this, k] { make_packing(k); }, .cost = packing_steps(scene_), .after = {}};
      jobs.push_back({.work = [this, k] { compress(k); },
                      .cost = isotropic_steps(scene_, of.contact, of.density),
                      .after = packing_of_[k]});
    }
    for (std::size_t k = 0; k < specimens_.size(); ++k) {
      specimens_[k].runs.resize(1 + scene_.shear.paths.size());
      for (std::size_t path = 0; path < scene_.shear.paths.size(); ++path)
        jobs.push_back({.work = [this, k, path] { shear(specimens_[k], path); },
                        .cost = shear_steps(scene_, specimens_[k].contact, scene_.shear.paths[path]),
                        .after = packings_.size() + k});
    }
    side_by_side(jobs, thread_count(scene_));
    return std::move(specimens_);
  }

 private:
  struct Packing {
    dem::Specimen state;
    std::string failure;
  };

  [[nodiscard]] Piece piece(const ExperimentSpecimen& of, double steps) {
    return {scene_, checkpoints_, meter_, of.contact, of.density, of.seed, steps};
  }

  /// Runs a piece of work; returns why it failed, empty if it did not. A file that cannot be written ends all
  /// work.
  std::string guarded(const std::function<void()>& work) {
    try {
      return failure_or_stop_of([&] {
        throw_if_stopped(meter_.stop_request());
        work();
      });
    } catch (const FileError&) {
      meter_.stop_all();
      throw;
    }
  }

  void make_packing(std::size_t specimen) {
    Packing& to = packings_[packing_of_[specimen]];
    to.failure = guarded([&] { to.state = packing(piece(specimens_[specimen], packing_steps(scene_))); });
  }

  void compress(std::size_t k) {
    ExperimentSpecimen& of = specimens_[k];
    const Packing& from = packings_[packing_of_[k]];
    std::string failure = from.failure;
    if (failure.empty())
      failure = guarded([&] {
        of.runs.front() = isotropic_run(piece(of, isotropic_steps(scene_, of.contact, of.density)),
                                        from.state, of.end_of_iso);
      });
    if (!failure.empty())
      of.runs.front().failure = failure;
  }

  void shear(ExperimentSpecimen& of, std::size_t path) {
    PathRun& run = of.runs[1 + path];
    run.path = scene_.shear.paths[path];
    const std::string& iso = of.runs.front().failure;
    const std::string failure = !iso.empty() ? "isotropic compression: " + iso : guarded([&] {
      run = shear_run(piece(of, shear_steps(scene_, of.contact, *run.path)), of.end_of_iso, *run.path);
    });
    if (!failure.empty())
      run.failure = failure;
  }

  const Scene& scene_;
  const CheckpointFolder& checkpoints_;
  Meter meter_;
  std::vector<Packing> packings_; ///< contact, then seed
  std::vector<ExperimentSpecimen> specimens_;
  std::vector<std::size_t> packing_of_; ///< each specimen
};

/// Names of checkpoints: "sphere-1-packing.checkpoint", "sphere-dense-1-txc.checkpoint".
std::regex checkpoint_names() {
  std::string shapes, paths = path_in_file_names(std::nullopt);
  for (const contact::LawRow& row : contact::laws())
    shapes += (shapes.empty() ? "" : "|") + std::string(name(row.shape));
  for (const stress::ShearPath path : stress::all_shear_paths)
    paths += "|" + path_in_file_names(path);
  return std::regex("(" + shapes + ")-([0-9]+-packing|(dense|loose)-[0-9]+-(" + paths + "))\\.checkpoint");
}

} // namespace

std::string_view name(const std::optional<stress::ShearPath>& path) {
  return path ? stress::name(*path) : "ISO";
}

bool Experiment::complete() const {
  return std::ranges::all_of(specimens, [](const ExperimentSpecimen& specimen) {
    return std::ranges::all_of(specimen.runs, [](const PathRun& run) { return run.failure.empty(); });
  });
}

void remove_checkpoints(const fs::path& folder) {
  std::error_code error;
  const fs::directory_iterator entries(folder, error);
  if (error && error != std::errc::no_such_file_or_directory)
    throw FileError(folder.string(), 0, "cannot be read: " + error.message());
  const std::regex names = checkpoint_names();
  std::vector<fs::path> files;
  for (const fs::directory_entry& entry : entries) {
    std::string file = entry.path().filename().string();
    if (file.ends_with(io::part_extension)) // of a writer that was killed
      file.resize(file.size() - io::part_extension.size());
    if (std::regex_match(file, names) && (entry.is_regular_file(error) || entry.is_symlink(error)))
      files.push_back(entry.path());
  }
  for (const fs::path& file : files)
    if (!fs::remove(file, error) && error)
      throw FileError(file.string(), 0, "cannot be removed: " + error.message());
}

Experiment run_experiment(const Scene& scene, const RunControl& control,
                          const CheckpointFolder& checkpoints) {
  require_valid(scene);
  return {.scene = scene, .specimens = Pieces(scene, control, checkpoints).run()};
}

} // namespace granum::studies

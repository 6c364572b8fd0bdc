// SPDX-License-Identifier: GPL-3.0-or-later
#include "studies/reproduce/experiment.hpp"

#include <algorithm>

#include <granum/core/error.hpp>

#include "path_run.hpp"
#include "studies/running/outcome_text.hpp"
#include "studies/running/work_sharing.hpp"

namespace granum::studies {

namespace {

/// The pieces of an experiment: packings, isotropic compressions, stress paths. Each begins once the one that
/// it starts from is done, side by side with others.
class Pieces {
 public:
  Pieces(const Scene& scene, const RunControl& control, const CheckpointFolder& checkpoints)
      : scene_(scene), checkpoints_(checkpoints), meter_(control, experiment_steps(scene)) {
    for (const contact::Shape contact : scene.study.contacts)
      for (const triaxial::Density density : scene.study.densities)
        for (std::size_t k = 0; k < scene.study.seeds; ++k)
          specimens_.push_back({contact, density, scene.study.first_seed + k, {}, {}});
  }

  std::vector<ExperimentSpecimen> run() && {
    const std::size_t paths = scene_.shear.paths.size();
    packings_.resize(scene_.study.contacts.size() * scene_.study.seeds);
    for (ExperimentSpecimen& specimen : specimens_)
      specimen.runs.resize(1 + paths);
    std::vector<Job> jobs;
    for (std::size_t k = 0; k < packings_.size(); ++k)
      jobs.push_back({.work = [this, k] { make_packing(k); }, .cost = packing_steps(scene_), .after = {}});
    for (std::size_t k = 0; k < specimens_.size(); ++k)
      jobs.push_back({.work = [this, k] { compress(k); },
                      .cost = isotropic_steps(scene_, specimens_[k].contact, specimens_[k].density),
                      .after = packing_of(k)});
    for (std::size_t k = 0; k < specimens_.size(); ++k)
      for (std::size_t path = 0; path < paths; ++path)
        jobs.push_back({.work = [this, k, path] { shear(specimens_[k], path); },
                        .cost = shear_steps(scene_, specimens_[k].contact, scene_.shear.paths[path]),
                        .after = packings_.size() + k});
    side_by_side(jobs, thread_count(scene_));
    return std::move(specimens_);
  }

 private:
  struct Packing {
    dem::Specimen state;
    std::string failure;
  };

  [[nodiscard]] Piece piece(const ExperimentSpecimen& specimen) {
    return {scene_, checkpoints_, meter_, specimen.contact, specimen.density, specimen.seed};
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

  /// The packing that a specimen starts from; specimens are in the order contact, density, seed.
  [[nodiscard]] std::size_t packing_of(std::size_t specimen) const {
    const std::size_t of_contact = scene_.study.densities.size() * scene_.study.seeds;
    return specimen / of_contact * scene_.study.seeds + specimen % scene_.study.seeds;
  }

  void make_packing(std::size_t k) {
    const std::size_t of_contact = scene_.study.densities.size() * scene_.study.seeds;
    const ExperimentSpecimen& first =
        specimens_[k / scene_.study.seeds * of_contact + k % scene_.study.seeds];
    packings_[k].failure = guarded([&] { packings_[k].state = packing(piece(first)); });
  }

  void compress(std::size_t k) {
    ExperimentSpecimen& specimen = specimens_[k];
    PathRun& run = specimen.runs.front();
    const Packing& from = packings_[packing_of(k)];
    if (!from.failure.empty()) {
      run.failure = from.failure;
      return;
    }
    const std::string failure = guarded([&] {
      IsoRun iso = isotropic_run(piece(specimen), from.state);
      run = std::move(iso.run);
      if (run.failure.empty())
        specimen.end_of_iso = std::move(iso.state);
    });
    if (!failure.empty())
      run.failure = failure;
  }

  void shear(ExperimentSpecimen& specimen, std::size_t path) {
    PathRun& run = specimen.runs[1 + path];
    run.path = scene_.shear.paths[path];
    if (const std::string& iso = specimen.runs.front().failure; !iso.empty()) {
      run.failure = "isotropic compression: " + iso;
      return;
    }
    const std::string failure =
        guarded([&] { run = shear_run(piece(specimen), specimen.end_of_iso, *run.path); });
    if (!failure.empty())
      run.failure = failure;
  }

  const Scene& scene_;
  const CheckpointFolder& checkpoints_;
  Meter meter_;
  std::vector<Packing> packings_; ///< contact, then seed
  std::vector<ExperimentSpecimen> specimens_;
};

} // namespace

std::string_view name(const std::optional<stress::ShearPath>& path) {
  return path ? stress::name(*path) : "ISO";
}

bool Experiment::complete() const {
  return std::all_of(specimens.begin(), specimens.end(), [](const ExperimentSpecimen& specimen) {
    return std::all_of(specimen.runs.begin(), specimen.runs.end(),
                       [](const PathRun& run) { return run.failure.empty(); });
  });
}

Experiment run_experiment(const Scene& scene, const RunControl& control,
                          const CheckpointFolder& checkpoints) {
  require_valid(scene);
  return {.scene = scene, .specimens = Pieces(scene, control, checkpoints).run()};
}

} // namespace granum::studies

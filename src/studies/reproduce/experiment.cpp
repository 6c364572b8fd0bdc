// SPDX-License-Identifier: GPL-3.0-or-later
#include "studies/reproduce/experiment.hpp"

#include <algorithm>
#include <numeric>

#include <granum/core/error.hpp>

#include "path_run.hpp"
#include "studies/running/outcome_text.hpp"
#include "studies/running/work_sharing.hpp"

namespace granum::studies {

namespace {

/// Indices 0 .. count - 1 by falling work, so that no thread ends up alone with a long piece.
std::vector<std::size_t> longest_first(std::size_t count, const std::function<double(std::size_t)>& work) {
  std::vector<std::size_t> order(count);
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::stable_sort(order.begin(), order.end(),
                   [&](std::size_t a, std::size_t b) { return work(a) > work(b); });
  return order;
}

/// The stages of an experiment: packings, isotropic compression, stress paths. Pieces of a stage run side by
/// side.
class Stages {
 public:
  Stages(const Scene& scene, const RunControl& control, const CheckpointFolder& checkpoints)
      : scene_(scene), checkpoints_(checkpoints), meter_(control, experiment_steps(scene)) {
    for (const contact::Shape contact : scene.study.contacts)
      for (const triaxial::Density density : scene.study.densities)
        for (std::size_t k = 0; k < scene.study.seeds; ++k)
          specimens_.push_back({contact, density, scene.study.first_seed + k, {}, {}});
  }

  std::vector<ExperimentSpecimen> run() && {
    make_packings();
    compress();
    shear();
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

  void make_packings() {
    packings_.resize(scene_.study.contacts.size() * scene_.study.seeds);
    side_by_side(packings_.size(), thread_count(scene_), [&](std::size_t k) {
      const ExperimentSpecimen& first =
          specimens_[k / scene_.study.seeds * scene_.study.densities.size() * scene_.study.seeds +
                     k % scene_.study.seeds];
      packings_[k].failure = guarded([&] { packings_[k].state = packing(piece(first)); });
    });
  }

  void compress() {
    const auto order = longest_first(specimens_.size(), [&](std::size_t k) {
      return isotropic_steps(scene_, specimens_[k].contact, specimens_[k].density);
    });
    side_by_side(order.size(), thread_count(scene_), [&](std::size_t position) {
      const std::size_t k = order[position];
      ExperimentSpecimen& specimen = specimens_[k];
      const Packing& from = packings_[packing_of(k)];
      specimen.runs.resize(1);
      if (!from.failure.empty()) {
        specimen.runs.front().failure = from.failure;
        return;
      }
      const std::string failure = guarded([&] {
        IsoRun iso = isotropic_run(piece(specimen), from.state);
        specimen.runs.front() = std::move(iso.run);
        if (specimen.runs.front().failure.empty())
          specimen.end_of_iso = std::move(iso.state);
      });
      if (!failure.empty())
        specimen.runs.front().failure = failure;
    });
    packings_.clear();
  }

  void shear() {
    const std::size_t paths = scene_.shear.paths.size();
    for (ExperimentSpecimen& specimen : specimens_)
      specimen.runs.resize(1 + paths);
    const auto order = longest_first(specimens_.size() * paths, [&](std::size_t k) {
      return shear_steps(scene_, specimens_[k / paths].contact);
    });
    side_by_side(order.size(), thread_count(scene_), [&](std::size_t position) {
      const std::size_t k = order[position];
      ExperimentSpecimen& specimen = specimens_[k / paths];
      PathRun& run = specimen.runs[1 + k % paths];
      run.path = scene_.shear.paths[k % paths];
      if (const std::string& iso = specimen.runs.front().failure; !iso.empty()) {
        run.failure = "isotropic compression: " + iso;
        return;
      }
      const std::string failure =
          guarded([&] { run = shear_run(piece(specimen), specimen.end_of_iso, *run.path); });
      if (!failure.empty())
        run.failure = failure;
    });
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
  return {.scene = scene, .specimens = Stages(scene, control, checkpoints).run()};
}

} // namespace granum::studies

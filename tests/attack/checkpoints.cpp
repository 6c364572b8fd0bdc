// SPDX-License-Identifier: GPL-3.0-or-later
// Checkpoints of two small experiments, which differ in their seed: damaged, swapped in pairs, or in the
//   place of their namesake in the other experiment. Each time the experiment must refuse the folder with
//   FileError that names a wrong file, and read it again once the folder is mended. attack_checkpoints
//   <damages> <swaps> <seed> <scratch folder>
#include <algorithm>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <exception>
#include <filesystem>
#include <fstream>
#include <random>
#include <sstream>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "studies/reproduce/experiment.hpp"
#include <granum/core/error.hpp>

namespace {

using namespace granum;
using namespace granum::studies;
namespace fs = std::filesystem;

Scene small_scene(std::uint64_t first_seed) {
  Scene scene;
  scene.study.first_seed = first_seed;
  scene.study.grains = 60;
  scene.study.contacts = {contact::Shape::sphere};
  scene.study.pressures = {25e3, 50e3, 100e3};
  scene.study.probe_pressures = {};
  scene.shear.paths = {stress::ShearPath::txc, stress::ShearPath::rtxe};
  scene.shear.inertial_number = 2e-3;
  scene.shear.largest_strain = 5e-4;
  scene.shear.eta_step = 0.4;
  scene.shear.strain_step = 2.5e-4;
  scene.shear.probe_eta_step = 0;
  scene.shear.loop_strain = 0;
  scene.study.threads = 1;
  return scene;
}

std::string contents(const fs::path& path) {
  std::ostringstream bytes;
  bytes << std::ifstream(path, std::ios::binary).rdbuf();
  return bytes.str();
}

void write(const fs::path& path, const std::string& bytes) {
  std::ofstream(path, std::ios::binary | std::ios::trunc) << bytes;
}

/// What the file holds after some damage; never what it held before.
std::string damaged(std::string bytes, const std::string& other, std::mt19937_64& random) {
  const std::string before = bytes;
  const std::size_t at = random() % bytes.size();
  switch (random() % 7) {
  case 0: // one bit
    bytes[at] = static_cast<char>(static_cast<unsigned char>(bytes[at]) ^ (1u << random() % 8));
    break;
  case 1: // one byte of the header
    bytes[random() % 64] = static_cast<char>(random());
    break;
  case 2:
    bytes.resize(at);
    break;
  case 3:
    bytes += before.substr(at);
    break;
  case 4: // a hole, as a disk leaves it
    std::fill(bytes.begin() + static_cast<std::ptrdiff_t>(at), bytes.end(), '\0');
    break;
  case 5: // another one's end
    bytes = bytes.substr(0, at) + other.substr(std::min(at, other.size()));
    break;
  default:
    bytes = other;
  }
  return bytes == before ? before + "x" : bytes;
}

/// An experiment that came to its end, with the bytes of its checkpoints.
class Folder {
 public:
  Folder(std::uint64_t first_seed, fs::path folder) : seed_(first_seed), folder_(std::move(folder)) {
    fs::create_directories(folder_);
    if (!run().complete())
      throw std::runtime_error("an experiment did not come to its end");
    for (const auto& entry : fs::directory_iterator(folder_))
      files_.push_back(entry.path());
    std::sort(files_.begin(), files_.end());
    for (const fs::path& file : files_)
      whole_.push_back(contents(file));
  }

  [[nodiscard]] std::size_t size() const { return files_.size(); }
  [[nodiscard]] const std::string& whole(std::size_t k) const { return whole_[k]; }
  void put(std::size_t k, const std::string& bytes) const { write(files_[k], bytes); }
  void mend(std::size_t k) const { put(k, whole_[k]); }

  /// Goes on from the checkpoints as they lie there.
  [[nodiscard]] Experiment run() const {
    return run_experiment(small_scene(seed_), {},
                          {.folder = folder_, .scene_text = "seed " + std::to_string(seed_)});
  }

  /// Whether it is refused for the fault of one of these files; says what happened if not.
  [[nodiscard]] bool refuses(const std::vector<std::size_t>& wrong, const char* what) const {
    try {
      (void)run();
    } catch (const FileError& error) {
      for (const std::size_t k : wrong)
        if (std::string(error.what()).find(files_[k].string()) != std::string::npos)
          return true;
      std::printf("%s: another file than %s is named: %s\n", what, files_[wrong.front()].c_str(),
                  error.what());
      return false;
    }
    std::printf("%s of %s was not seen\n", what, files_[wrong.front()].c_str());
    return false;
  }

 private:
  std::uint64_t seed_;
  fs::path folder_;
  std::vector<fs::path> files_;
  std::vector<std::string> whole_;
};
/// How many damages of one file were not seen.
std::size_t unseen_damages(const Folder& experiment, std::uint64_t damages, std::mt19937_64& random) {
  std::size_t unseen = 0;
  for (std::uint64_t k = 0; k < damages; ++k) {
    const std::size_t which = random() % experiment.size();
    const std::size_t other = (which + 1 + random() % (experiment.size() - 1)) % experiment.size();
    experiment.put(which, damaged(experiment.whole(which), experiment.whole(other), random));
    unseen += !experiment.refuses({which}, "damage");
    experiment.mend(which);
  }
  return unseen;
}

/// How many swaps were not seen: of two files of an experiment, or of a file and its namesake in the other.
std::size_t unseen_swaps(const Folder& a, const Folder& b, std::uint64_t swaps, std::mt19937_64& random) {
  std::size_t unseen = 0;
  for (std::uint64_t k = 0; k < swaps; ++k) {
    const std::size_t which = random() % a.size();
    if (random() % 2 == 0) {
      const std::size_t other = (which + 1 + random() % (a.size() - 1)) % a.size();
      a.put(which, a.whole(other));
      a.put(other, a.whole(which));
      unseen += !a.refuses({which, other}, "swap within an experiment");
      a.mend(other);
    } else {
      a.put(which, b.whole(which));
      unseen += !a.refuses({which}, "swap with the other experiment");
    }
    a.mend(which);
  }
  return unseen;
}

} // namespace

int main(int argc, char** argv) {
  if (argc != 5) {
    std::fprintf(stderr, "usage: %s <damages> <swaps> <seed> <scratch folder>\n", argv[0]);
    return 2;
  }
  const std::uint64_t damages = std::strtoull(argv[1], nullptr, 10);
  const std::uint64_t swaps = std::strtoull(argv[2], nullptr, 10);
  std::mt19937_64 random(std::strtoull(argv[3], nullptr, 10));
  const fs::path scratch = argv[4];
  try {
    fs::remove_all(scratch);
    const Folder a(1, scratch / "seed 1"), b(2, scratch / "seed 2");
    const std::size_t damages_unseen = unseen_damages(a, damages, random);
    const std::size_t swaps_unseen = unseen_swaps(a, b, swaps, random);
    std::printf("%llu damages of %zu checkpoints, %zu not seen; %llu swaps, %zu not seen\n",
                static_cast<unsigned long long>(damages), a.size(), damages_unseen,
                static_cast<unsigned long long>(swaps), swaps_unseen);
    (void)a.run(); // mended: no FileError
    return damages_unseen + swaps_unseen == 0 ? 0 : 1;
  } catch (const std::exception& error) {
    std::printf("%s\n", error.what());
    return 1;
  }
}

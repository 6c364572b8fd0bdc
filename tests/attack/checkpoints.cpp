// SPDX-License-Identifier: GPL-3.0-or-later
// Checkpoints of a small experiment, damaged or in each other's places: each time the experiment must refuse
// the folder with FileError, and read it again once the folder is mended.
//   attack_checkpoints <damages> <seed> <scratch folder>
#include <algorithm>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <random>
#include <sstream>
#include <string>
#include <vector>

#include "studies/reproduce/experiment.hpp"
#include <granum/core/error.hpp>

namespace {

using namespace granum;
using namespace granum::studies;
namespace fs = std::filesystem;

Scene small_scene() {
  Scene scene;
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

} // namespace

int main(int argc, char** argv) {
  if (argc != 4) {
    std::fprintf(stderr, "usage: %s <damages> <seed> <scratch folder>\n", argv[0]);
    return 2;
  }
  const std::uint64_t damages = std::strtoull(argv[1], nullptr, 10);
  std::mt19937_64 random(std::strtoull(argv[2], nullptr, 10));
  const fs::path folder = argv[3];
  fs::remove_all(folder);
  fs::create_directories(folder);
  const CheckpointFolder checkpoints{.folder = folder, .scene_text = "scene"};
  if (!run_experiment(small_scene(), {}, checkpoints).complete()) {
    std::printf("the experiment did not come to its end\n");
    return 1;
  }
  std::vector<fs::path> files;
  std::vector<std::string> whole;
  for (const auto& entry : fs::directory_iterator(folder))
    files.push_back(entry.path());
  std::sort(files.begin(), files.end());
  for (const fs::path& file : files)
    whole.push_back(contents(file));

  std::size_t accepted = 0;
  for (std::uint64_t k = 0; k < damages; ++k) {
    const std::size_t which = random() % files.size();
    const std::size_t other = (which + 1 + random() % (files.size() - 1)) % files.size();
    write(files[which], damaged(whole[which], whole[other], random));
    try {
      (void)run_experiment(small_scene(), {}, checkpoints);
      ++accepted;
      std::printf("damage %llu of %s was not seen\n", static_cast<unsigned long long>(k),
                  files[which].c_str());
    } catch (const FileError& error) {
      if (std::string(error.what()).find(files[which].string()) == std::string::npos) {
        ++accepted;
        std::printf("another file than %s is named: %s\n", files[which].c_str(), error.what());
      }
    }
    write(files[which], whole[which]);
  }
  std::printf("%llu damages of %zu checkpoints, %zu not seen\n", static_cast<unsigned long long>(damages),
              files.size(), accepted);
  (void)run_experiment(small_scene(), {}, checkpoints); // mended: no FileError
  return accepted == 0 ? 0 : 1;
}

// SPDX-License-Identifier: GPL-3.0-or-later
// Checkpoints with changed bytes, also such as a right checksum would cover: what is taken runs on without
// reading or writing memory that is not its own. Input: one byte that names the part, then 13 bytes for each
// change: what is done, where (4 bytes), and a value (8 bytes).
#include <algorithm>
#include <array>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <string>
#include <utility>

#include <unistd.h>

#include <granum/core/bytes.hpp>
#include <granum/dem/specimen.hpp>
#include <granum/io/checkpoint/checkpoint.hpp>
#include <granum/triaxial/shear_test.hpp>

#include "dem/lattice_state.hpp"
#include "input.hpp"

using namespace granum;

namespace {

enum Part : unsigned { whole_file, specimen, engine, shear_test, walled_engine, part_count };

/// The bytes of each part as granum writes them.
std::string bytes_of(Part part) {
  const double radius = 0.5e-3;
  const dem::Material material = test::quartz(radius, 0.5);
  dem::Specimen start = test::fcc(radius, 2, 1e-4 * radius);
  if (part == walled_engine)
    start.walls.emplace(dem::Walls{.friction_coefficient = 0.3, .history = {}});
  ByteWriter writer;
  if (part == shear_test) {
    triaxial::ShearTest(start, material, {}).save(writer);
    return writer.bytes();
  }
  dem::Engine engine(start, material);
  engine.step();
  if (part == specimen)
    dem::save_specimen(writer, engine.state());
  else
    engine.save(writer);
  if (part != whole_file)
    return writer.bytes();
  const std::filesystem::path path =
      std::filesystem::temp_directory_path() / ("granum-fuzz-" + std::to_string(getpid()));
  io::write_checkpoint(path, {.subject = "a specimen", .scene = "a scene", .state = writer.bytes()});
  std::ostringstream bytes;
  bytes << std::ifstream(path, std::ios::binary).rdbuf();
  std::filesystem::remove(path);
  return bytes.str();
}

const std::string& written(Part part) {
  static const std::array<std::string, part_count> bytes = [] {
    std::array<std::string, part_count> all;
    for (unsigned k = 0; k < part_count; ++k)
      all[k] = bytes_of(static_cast<Part>(k));
    return all;
  }();
  return bytes[part];
}

/// Overwrites a byte, a number or a 32-bit number, cuts the end off, or doubles a piece.
void change(std::string& bytes, std::string_view how) {
  std::uint32_t at = 0;
  std::memcpy(&at, &how[1], sizeof at);
  const std::string_view value = how.substr(5, 8);
  at %= static_cast<std::uint32_t>(bytes.size() + 1);
  switch (static_cast<unsigned char>(how[0]) % 5) {
  case 0:
    bytes.replace(at, std::min<std::size_t>(1, bytes.size() - at), value.substr(0, 1));
    break;
  case 1:
    bytes.replace(at, std::min<std::size_t>(4, bytes.size() - at), value.substr(0, 4));
    break;
  case 2:
    bytes.replace(at, std::min<std::size_t>(8, bytes.size() - at), value);
    break;
  case 3:
    bytes.resize(at);
    break;
  default:
    bytes.insert(at, bytes.substr(at, static_cast<unsigned char>(value[0])));
  }
}

/// What a run does with a checkpoint: steps, an engine made anew of what they come to, and the contacts.
void go_on(dem::Engine engine) {
  for (int k = 0; k < 3; ++k)
    engine.step();
  dem::Engine anew(engine.state(), engine.material());
  anew.step();
  (void)dem::contact_network(anew.state(), anew.material());
}

void load(Part part, const std::string& bytes) {
  const dem::Material material = test::quartz(0.5e-3, 0.5);
  ByteReader from(bytes, "bytes");
  if (part == whole_file) {
    const fuzz::MemoryFile file(bytes);
    (void)io::read_checkpoint(file.path());
  } else if (part == specimen) {
    go_on(dem::Engine(dem::load_specimen(from), material));
  } else if (part == shear_test) {
    bool stop = false; // after the first look: a forged test could ask for any number of steps
    triaxial::ShearTest test =
        triaxial::ShearTest::load(from, material, [&stop] { return std::exchange(stop, true); });
    (void)test.advance();
  } else {
    go_on(dem::Engine::load(from, material));
  }
}

void checkpoint(std::string_view input) {
  if (input.empty())
    return;
  const auto part = static_cast<Part>(static_cast<unsigned char>(input[0]) % part_count);
  std::string bytes = written(part);
  constexpr std::size_t length = 13;
  for (input.remove_prefix(1); input.size() >= length; input.remove_prefix(length))
    change(bytes, input);
  try {
    load(part, bytes);
  } catch (const FileError&) {
  } catch (const InvalidArgument&) { // a state that no engine takes
  }
}

const fuzz::Named of_checkpoints("checkpoint", checkpoint);

} // namespace

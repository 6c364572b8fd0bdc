// SPDX-License-Identifier: GPL-3.0-or-later
#include <granum/io/checkpoint/checkpoint.hpp>

#include <fstream>
#include <iterator>
#include <sstream>

#include <sys/stat.h>

#include "io/temporary_folder.hpp"
#include "unit.hpp"

using namespace granum::io;

namespace {

std::string content(const std::filesystem::path& path) {
  std::ifstream file(path, std::ios::binary);
  std::ostringstream bytes;
  bytes << file.rdbuf();
  return bytes.str();
}

/// The text of the error that reading gives, which its path begins; empty if it is read.
std::string complaint(const std::filesystem::path& path) {
  try {
    (void)read_checkpoint(path);
  } catch (const FileError& error) {
    const std::string text = error.what();
    CHECK(text.starts_with(path.string() + ": "));
    return text.substr(path.string().size() + 2);
  }
  return "";
}

const Checkpoint sample{.subject = "sphere dense #1 TXC",
                        .scene = "grains = 1000\n",
                        .state = std::string("\0\1\2\xff state", 10)};

} // namespace

TEST_CASE("a checkpoint is read as written, and replaced by the next one") {
  const TemporaryFolder folder;
  const auto path = folder.path() / "run.checkpoint";
  write_checkpoint(path, sample);
  CHECK(read_checkpoint(path) == sample);
  const Checkpoint later{.subject = sample.subject, .scene = sample.scene, .state = std::string(100000, 'x')};
  write_checkpoint(path, later);
  CHECK(read_checkpoint(path) == later);
  write_checkpoint(path, {});
  CHECK(read_checkpoint(path) == Checkpoint{});
  CHECK(std::distance(std::filesystem::directory_iterator(folder.path()), {}) == 1);
}

TEST_CASE("a checkpoint that cannot be read, is cut, or has any byte changed is refused with its path") {
  const TemporaryFolder folder;
  const auto path = folder.path() / "run.checkpoint";
  write_checkpoint(path, sample);
  const std::string whole = content(path);
  const auto refused = [&](const std::string& bytes) {
    std::ofstream(path, std::ios::binary) << bytes;
    return !complaint(path).empty();
  };
  const auto pipe = folder.path() / "pipe";
  REQUIRE(mkfifo(pipe.c_str(), 0600) == 0);
  for (const auto& place : {folder.path() / "none", folder.path(), pipe})
    CHECK_FALSE(complaint(place).empty());
  CHECK(refused("ITEM: TIMESTEP\n0\n"));
  CHECK(refused(whole + "x"));
  for (std::size_t length = 0; length < whole.size(); ++length)
    CHECK(refused(whole.substr(0, length)));
  for (std::size_t k = 0; k < whole.size(); ++k) {
    std::string damaged = whole;
    damaged[k] = static_cast<char>(damaged[k] ^ 0x10);
    CHECK(refused(damaged));
  }
  std::string foreign = whole;
  std::swap(foreign[12], foreign[15]); // another byte order
  CHECK(refused(foreign));
  std::string newer = whole;
  newer[8] = static_cast<char>(checkpoint_version + 1);
  CHECK(refused(newer));
  for (const char* number : {"7", "6"}) // its version, and that of this granum
    CHECK(complaint(path).find(number) != std::string::npos);
  CHECK_FALSE(refused(whole));
  CHECK_THROWS_AS(write_checkpoint(folder.path() / "none" / "run.checkpoint", sample), FileError);
}

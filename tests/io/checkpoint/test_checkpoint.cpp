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

void overwrite(const std::filesystem::path& path, const std::string& bytes) {
  std::ofstream(path, std::ios::binary) << bytes;
}

/// The text of the error that reading gives, without the path that must begin it.
std::string complaint(const std::filesystem::path& path) {
  try {
    (void)read_checkpoint(path);
  } catch (const FileError& error) {
    const std::string text = error.what();
    CHECK(text.rfind(path.string() + ": ", 0) == 0);
    return text.substr(path.string().size() + 2);
  }
  return "no error";
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

TEST_CASE("an unreadable checkpoint is reported with path and reason") {
  const TemporaryFolder folder;
  const auto path = folder.path() / "run.checkpoint";
  write_checkpoint(path, sample);
  const std::string whole = content(path);

  const auto refused = [&](const std::string& bytes) {
    overwrite(path, bytes);
    return complaint(path) != "no error";
  };
  CHECK(complaint(folder.path() / "none") != "no error");
  CHECK(complaint(folder.path()) != "no error");
  const auto pipe = folder.path() / "pipe";
  REQUIRE(mkfifo(pipe.c_str(), 0600) == 0);
  CHECK(complaint(pipe) != "no error");
  CHECK(refused("ITEM: TIMESTEP\n0\n"));
  CHECK(refused(""));
  CHECK(refused(whole.substr(0, 20)));
  for (std::size_t length = 48; length < whole.size(); ++length)
    CHECK(refused(whole.substr(0, length)));
  CHECK(refused(whole + "x"));
  std::string newer = whole;
  newer[8] = static_cast<char>(checkpoint_version + 1);
  CHECK(refused(newer));
  for (const char* number : {"7", "6"}) // its version, and that of this granum
    CHECK(complaint(path).find(number) != std::string::npos);
  std::string foreign = whole;
  std::swap(foreign[12], foreign[15]); // another byte order
  CHECK(refused(foreign));
  CHECK_FALSE(refused(whole));
}

TEST_CASE("any byte that flips is noticed") {
  const TemporaryFolder folder;
  const auto path = folder.path() / "run.checkpoint";
  write_checkpoint(path, sample);
  const std::string whole = content(path);
  for (std::size_t k = 0; k < whole.size(); ++k) {
    std::string damaged = whole;
    damaged[k] = static_cast<char>(damaged[k] ^ 0x10);
    overwrite(path, damaged);
    CHECK(complaint(path) != "no error");
  }
}

TEST_CASE("a folder that is not there stops the writing, and nothing is lost") {
  const TemporaryFolder folder;
  CHECK_THROWS_AS(write_checkpoint(folder.path() / "none" / "run.checkpoint", sample), FileError);
}

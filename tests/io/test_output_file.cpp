// SPDX-License-Identifier: GPL-3.0-or-later
#include <granum/io/output_file.hpp>

#include <fstream>
#include <iterator>
#include <sstream>
#include <string>

#include <doctest/doctest.h>
#include <granum/core/error.hpp>

#include "temporary_folder.hpp"

using namespace granum;
using namespace granum::io;

namespace {

std::string content(const std::filesystem::path& path) {
  std::ostringstream text;
  text << std::ifstream(path, std::ios::binary).rdbuf();
  return text.str();
}

long entries(const std::filesystem::path& folder) {
  return std::distance(std::filesystem::directory_iterator(folder), std::filesystem::directory_iterator());
}

} // namespace

TEST_CASE("a file is written whole, bytes as given, and nothing else stays in the folder") {
  const TemporaryFolder folder;
  const std::string text("a\r\nb\0c\n", 7);
  write_file(folder.path() / "out file.txt", text, Existing::keep);
  CHECK(content(folder.path() / "out file.txt") == text);
  CHECK(entries(folder.path()) == 1);
}

TEST_CASE("an existing file is kept unless it may be replaced") {
  const TemporaryFolder folder;
  const auto path = folder.path() / "out.txt";
  write_file(path, "old", Existing::keep);
  CHECK_THROWS_AS(write_file(path, "new", Existing::keep), FileError);
  CHECK(content(path) == "old");
  write_file(path, "new", Existing::replace);
  CHECK(content(path) == "new");
  CHECK(entries(folder.path()) == 1);
}

TEST_CASE("a place that cannot be written to is named, and no part of the file stays") {
  const TemporaryFolder folder;
  const auto missing = folder.path() / "no such folder" / "out.txt";
  CHECK_THROWS_WITH_AS(write_file(missing, "x", Existing::keep),
                       (missing.string() + ": cannot be written: No such file or directory").c_str(),
                       FileError);
  CHECK(entries(folder.path()) == 0);

  // a folder in the way of the last step, the rename
  const auto occupied = folder.path() / "occupied";
  std::filesystem::create_directories(occupied / "inside");
  CHECK_THROWS_AS(write_file(occupied, "x", Existing::replace), FileError);
  CHECK(entries(folder.path()) == 1);
  CHECK(std::filesystem::exists(occupied / "inside"));
}

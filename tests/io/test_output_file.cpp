// SPDX-License-Identifier: GPL-3.0-or-later
#include <granum/io/output_file.hpp>

#include <csignal>
#include <cstdio>
#include <fstream>
#include <iterator>
#include <sstream>
#include <thread>

#include <fcntl.h>
#include <sys/resource.h>
#include <sys/stat.h>
#include <unistd.h>

#include "temporary_folder.hpp"
#include "unit.hpp"

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

TEST_CASE("a file is written whole, bytes as given, and kept unless it may be replaced") {
  const TemporaryFolder folder;
  const auto path = folder.path() / "out file.txt";
  const std::string text("a\r\nb\0c\n", 7);
  write_file(path, text, Existing::keep);
  CHECK_THROWS_AS(write_file(path, "new", Existing::keep), FileError);
  CHECK(content(path) == text);
  write_file(path, "new", Existing::replace);
  CHECK(content(path) == "new");
  CHECK(entries(folder.path()) == 1);
}

TEST_CASE("a file that is replaced hands its mode on, and a new one has the usual") {
  const TemporaryFolder folder;
  const auto path = folder.path() / "secret.csv";
  const auto mode = [&] { return std::filesystem::status(path).permissions(); };
  using std::filesystem::perms;
  write_file(path, "old", Existing::keep);
  const perms usual = mode();
  CHECK((usual & perms::owner_write) != perms::none);
  for (const perms own : {perms(0600), perms(0640), perms(0444)}) {
    std::filesystem::permissions(path, own);
    write_file(path, "new", Existing::replace);
    CHECK(mode() == own);
  }
}

TEST_CASE("a link is something that exists, also where it leads nowhere") {
  const TemporaryFolder folder;
  const auto link = folder.path() / "link";
  std::filesystem::create_symlink("nowhere", link);
  CHECK(is_taken(link));
  CHECK_FALSE(is_taken(folder.path() / "nowhere"));
  CHECK_THROWS_AS(write_file(link, "x", Existing::keep), FileError);
  CHECK(std::filesystem::is_symlink(link));
  write_file(link, "x", Existing::replace);
  CHECK(content(link) == "x");
  CHECK(entries(folder.path()) == 1);
}

TEST_CASE("remains of a file of a killed run are removed by the next run that writes it") {
  const TemporaryFolder folder;
  const auto path = folder.path() / "out.csv";
  const auto part = folder.path() / "out.csv.granum.part";
  std::ofstream(part) << "half a file, longer than the whole one";
  write_file(path, "whole", Existing::keep);
  CHECK(content(path) == "whole");
  CHECK_FALSE(std::filesystem::exists(part));
  // not through a link that someone put there
  std::ofstream(folder.path() / "other") << "kept";
  std::filesystem::create_symlink("other", part);
  CHECK_THROWS_AS(write_file(path, "new", Existing::replace), FileError);
  CHECK(content(folder.path() / "other") == "kept");
  // nor through a pipe, or in the place of a folder
  for (const bool pipe : {true, false}) {
    std::filesystem::remove(part);
    REQUIRE((pipe ? mkfifo(part.c_str(), 0600) : mkdir(part.c_str(), 0700)) == 0);
    CHECK_THROWS_AS(write_file(path, "new", Existing::replace), FileError);
    CHECK((pipe ? std::filesystem::is_fifo(part) : std::filesystem::is_directory(part)));
  }
  CHECK(content(path) == "whole");
}

TEST_CASE("a pipe takes text from whoever may not replace a file, and stays a pipe") {
  const TemporaryFolder folder;
  const auto pipe = folder.path() / "pipe", link = folder.path() / "link";
  REQUIRE(mkfifo(pipe.c_str(), 0600) == 0);
  std::filesystem::create_symlink("pipe", link);
  CHECK_FALSE(is_taken(pipe));
  CHECK_FALSE(is_taken(link));
  const std::string text(50'000, 'a'); // less than a pipe holds
  const int reader = open(pipe.c_str(), O_RDONLY | O_NONBLOCK | O_CLOEXEC);
  for (const auto& path : {pipe, link})
    for (const Existing existing : {Existing::keep, Existing::replace}) {
      write_file(path, text, existing);
      std::string got(2 * text.size(), ' ');
      got.resize(static_cast<std::size_t>(std::max<ssize_t>(read(reader, got.data(), got.size()), 0)));
      CHECK(got == text);
    }
  close(reader);
  CHECK_THROWS_AS(write_file(pipe, text, Existing::replace), FileError); // nobody reads
  CHECK(std::filesystem::is_fifo(pipe));
  CHECK(std::filesystem::is_symlink(link));
  CHECK(entries(folder.path()) == 2);
}

TEST_CASE("a link to a device is written through") {
  const TemporaryFolder folder;
  const auto device = folder.path() / "null", full = folder.path() / "full";
  std::filesystem::create_symlink("/dev/null", device);
  std::filesystem::create_symlink("/dev/full", full);
  CHECK_FALSE(is_taken(device));
  for (const Existing existing : {Existing::keep, Existing::replace}) {
    write_file(device, "x", existing);
    CHECK_THROWS_AS(write_file(full, "x", existing), FileError);
  }
  CHECK((std::filesystem::is_symlink(device) && std::filesystem::is_symlink(full)));
  CHECK(entries(folder.path()) == 2);
}

TEST_CASE("a descriptor of this process is written to where it is") {
  const TemporaryFolder folder;
  std::FILE* file = std::fopen((folder.path() / "file").c_str(), "w");
  REQUIRE(file != nullptr);
  const std::string number = std::to_string(fileno(file));
  const auto link = folder.path() / "link";
  std::filesystem::create_symlink("/dev/fd/" + number, link);
  for (const std::filesystem::path& path : {std::filesystem::path("/proc/self/fd/" + number), link}) {
    CHECK_FALSE(is_taken(path));
    write_file(path, "one\n", Existing::keep);
  }
  std::fclose(file);
  CHECK(content(folder.path() / "file") == "one\none\n");
  CHECK(std::filesystem::is_symlink(link));
}

TEST_CASE("a name may be as long as its folder takes it") {
  const TemporaryFolder folder;
  for (const std::size_t length : {243U, 244U, 250U, 255U}) {
    const auto path = folder.path() / std::string(length, 'n');
    write_file(path, "text", Existing::keep);
    CHECK(content(path) == "text");
  }
  std::string sand; // 85 characters of three bytes
  for (int k = 0; k < 85; ++k)
    sand += "\u7802";
  write_file(folder.path() / sand, "text", Existing::keep);
  CHECK(content(folder.path() / sand) == "text");
  CHECK_THROWS_AS(write_file(std::string(5000, 'n'), "x", Existing::keep), FileError);
  CHECK(entries(folder.path()) == 5);
}

TEST_CASE("a limit of file sizes is an error of the file, and leaves nothing") {
  const TemporaryFolder folder;
  rlimit before{};
  REQUIRE(getrlimit(RLIMIT_FSIZE, &before) == 0);
  const auto of_signal = std::signal(SIGXFSZ, SIG_IGN);
  const rlimit small{.rlim_cur = 1000, .rlim_max = before.rlim_max};
  setrlimit(RLIMIT_FSIZE, &small);
  CHECK_THROWS_AS(write_file(folder.path() / "out", std::string(5000, 'a'), Existing::keep), FileError);
  setrlimit(RLIMIT_FSIZE, &before);
  std::signal(SIGXFSZ, of_signal);
  CHECK(entries(folder.path()) == 0);
}

TEST_CASE("two runs that write one file leave one of the two texts") {
  const TemporaryFolder folder;
  const auto path = folder.path() / "out.csv";
  const std::string texts[] = {std::string(100'000, 'a'), std::string(50'000, 'b')};
  std::vector<std::thread> writers;
  for (const std::string& text : texts)
    writers.emplace_back([&] {
      for (int k = 0; k < 20; ++k)
        write_file(path, text, Existing::replace);
    });
  for (std::thread& writer : writers)
    writer.join();
  CHECK((content(path) == texts[0] || content(path) == texts[1]));
  CHECK(entries(folder.path()) == 1);
}

TEST_CASE("two names of one file: spelled in other ways, or through a link to its folder") {
  const TemporaryFolder folder;
  const auto one = folder.path() / "one", link = folder.path() / "link";
  std::filesystem::create_directories(one / "inside");
  std::filesystem::create_directory_symlink("one", link);
  for (const auto& name :
       {one / "a.svg", one / "." / "a.svg", one / "inside" / ".." / "a.svg", link / "a.svg"})
    CHECK(is_one_file(one / "a.svg", name));
  CHECK(is_one_file("a.svg", std::filesystem::current_path() / "a.svg"));
  CHECK_FALSE(is_one_file(one / "a.svg", one / "b.svg"));
  CHECK_FALSE(is_one_file(one / "a.svg", link / "inside" / "a.svg"));
  // A link to a file is replaced, its target is kept: these are two.
  write_file(one / "a.svg", "a", Existing::keep);
  std::filesystem::create_symlink("a.svg", one / "b.svg");
  CHECK_FALSE(is_one_file(one / "a.svg", one / "b.svg"));
  write_file(one / "b.svg", "b", Existing::replace);
  CHECK(content(one / "a.svg") == "a");
}

TEST_CASE("a place that cannot be written to is named, and no part of the file stays") {
  const TemporaryFolder folder;
  const auto missing = folder.path() / "no such folder" / "out.txt";
  CHECK_THROWS_WITH_AS(write_file(missing, "x", Existing::keep), doctest::Contains(missing.string().c_str()),
                       FileError);
  CHECK(entries(folder.path()) == 0);

  // a folder in the way of the last step, the rename
  const auto occupied = folder.path() / "occupied";
  std::filesystem::create_directories(occupied / "inside");
  CHECK_THROWS_AS(write_file(occupied, "x", Existing::replace), FileError);
  CHECK(entries(folder.path()) == 1);
  CHECK(std::filesystem::exists(occupied / "inside"));

  // a link to a folder is no place for a file either
  const auto link = folder.path() / "link";
  std::filesystem::create_directory_symlink("occupied", link);
  CHECK_THROWS_AS(write_file(link, "x", Existing::replace), FileError);
  CHECK(std::filesystem::is_symlink(link));
}

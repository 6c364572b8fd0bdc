// SPDX-License-Identifier: GPL-3.0-or-later
#include <granum/io/text/source.hpp>

#include <cerrno>
#include <cstring>

#include <granum/core/stop.hpp>
#include <zlib.h>

#include "io/import_support.hpp"
#include "io/temporary_folder.hpp"

using namespace granum::io;

namespace {

std::vector<std::string> lines(TextSource source) {
  std::vector<std::string> result;
  while (source.next())
    result.emplace_back(source.line());
  return result;
}

/// Writes a text so often, compressed.
std::filesystem::path write_packed(const TemporaryFolder& folder, const std::string& text, int times = 1) {
  const auto path = folder.path() / "packed.gz";
  const gzFile file = gzopen(path.c_str(), "wb1");
  for (int k = 0; k < times; ++k)
    gzwrite(file, text.data(), static_cast<unsigned>(text.size()));
  gzclose(file);
  return path;
}

std::string packed(const std::string& text) {
  const TemporaryFolder folder;
  std::ostringstream bytes;
  bytes << std::ifstream(write_packed(folder, text), std::ios::binary).rdbuf();
  return bytes.str();
}

std::filesystem::path written(const TemporaryFolder& folder, const std::string& bytes) {
  const auto path = folder.path() / "file";
  std::ofstream(path, std::ios::binary) << bytes;
  return path;
}

std::string numbered_lines(int count) {
  std::string text;
  for (int k = 0; k < count; ++k)
    text += "line " + std::to_string(k) + "\n";
  return text;
}

} // namespace

TEST_CASE("a source that keeps its content can be rewound repeatedly") {
  const TemporaryFolder folder;
  const std::string text = "\xEF\xBB\xBFhead\n" + numbered_lines(100'000);
  for (const std::string& bytes : {text, packed(text)}) {
    TextSource source(written(folder, bytes));
    source.keep_from_start();
    for (const int few : {1, 3, 90'000}) {
      for (int k = 0; k < few; ++k)
        REQUIRE(source.next());
      source.hold();
      source.back_to_start();
    }
    source.stop_keeping();
    CHECK((source.next() && source.line() == "head" && source.line_number() == 1));
    std::size_t count = 0;
    while (source.next())
      CHECK(source.line() == "line " + std::to_string(count++));
    CHECK(count == 100'000);
  }
}

TEST_CASE("lines come without their ends, counted from 1, with or without a last line end") {
  using Lines = std::vector<std::string>;
  CHECK(lines(TextSource::of_text("t", "")) == Lines{});
  CHECK(lines(TextSource::of_text("t", "\n")) == Lines{""});
  CHECK(lines(TextSource::of_text("t", "a\r\n\nb")) == Lines{"a", "", "b"});
  CHECK(lines(TextSource::of_text("t", "\xEF\xBB\xBFhead\nb\n")) == Lines{"head", "b"});
  TextSource source = TextSource::of_text("t", "a\nb\n");
  CHECK(source.next());
  source.hold();
  CHECK(source.next());
  CHECK(source.line() == "a");
  CHECK(source.line_number() == 1);
  CHECK(source.next());
  CHECK(source.line_number() == 2);
  CHECK_FALSE(source.next());
  CHECK_FALSE(source.next());
  CHECK(samples::refusal([&] { source.fail("expected more"); }) == "t:2: expected more");
}

TEST_CASE("plain and gzip files give the same lines, across the buffer's border and of any length") {
  const TemporaryFolder folder;
  const std::string text = numbered_lines(50000) + std::string(700000, 'x') + "\nlast";
  const auto expected = lines(TextSource::of_text("t", text));
  REQUIRE(expected.size() == 50002);
  CHECK(expected[50000].size() == 700000);
  CHECK(lines(TextSource(written(folder, text))) == expected);
  CHECK(lines(TextSource(written(folder, packed(text)))) == expected);
  CHECK(lines(TextSource(written(folder, packed("a\n") + packed("b\n")))) ==
        std::vector<std::string>{"a", "b"});
}

TEST_CASE("compressed data that end too early or are damaged are refused, not taken for a short file") {
  const TemporaryFolder folder;
  const std::string whole = packed(numbered_lines(50000));
  const auto refused = [&](const std::string& bytes) {
    const auto path = written(folder, bytes);
    return !samples::refusal([&] { lines(TextSource(path)); }).empty();
  };
  for (const std::size_t missing : {std::size_t{1}, std::size_t{8}, whole.size() / 2, whole.size() - 12}) {
    CAPTURE(missing);
    CHECK(refused(whole.substr(0, whole.size() - missing)));
  }
  std::string damaged = whole;
  damaged[damaged.size() - 6] = static_cast<char>(damaged[damaged.size() - 6] ^ 1); // its checksum
  CHECK(refused(damaged));
}

TEST_CASE("reading ends on a stop request, a missing file and a folder are refused by name") {
  const TemporaryFolder folder;
  TextSource source(written(folder, "one line\n"));
  const std::filesystem::path missing = folder.path() / "none";
  for (const auto& path : {missing, folder.path()})
    CHECK(samples::refusal([&] { TextSource source_of_path{path}; }).starts_with(path.string()));
  const StopScope scope([] { return true; });
  CHECK_THROWS_AS((void)source.next(), Stopped);
}

TEST_CASE("a file that compresses endless zeros into one line costs no more than the longest line") {
  const TemporaryFolder folder;
  const auto path = write_packed(folder, std::string(std::size_t{1} << 20, '\0'), 70);
  CHECK(samples::refusal([&] { lines(TextSource(path)); }).find("64 MiB") != std::string::npos);
}

TEST_CASE("the bytes behind a line come as they are, plain or gzip") {
  std::string whole = "<xml>\r\n";
  for (std::uint32_t k = 0, value = 1; k < 700'000; ++k, value = value * 1664525 + 1013904223)
    whole += static_cast<char>(value >> 24); // more than two buffers of all bytes, line ends among them
  const TemporaryFolder folder;
  for (const auto& path : {written(folder, whole), write_packed(folder, whole)}) {
    TextSource source(path);
    REQUIRE(source.next());
    CHECK(source.line() == "<xml>");
    std::string rest;
    for (auto bytes = source.next_bytes(); !bytes.empty(); bytes = source.next_bytes())
      rest += bytes;
    CHECK(rest == whole.substr(7));
    CHECK_FALSE(source.next());
  }
  CHECK(samples::text_source("name", "all").next_bytes() == "all");
}

TEST_CASE("a file is read whole, plain or gzip, or refused") {
  const TemporaryFolder folder;
  const std::string text = "\xEF\xBB\xBF" + numbered_lines(100'000) + std::string("\0\r\n end", 7);
  CHECK(file_content(written(folder, text)) == text);
  CHECK(file_content(written(folder, packed(text))) == text);
  CHECK(file_content(written(folder, "")).empty());
  CHECK(file_content(written(folder, text), text.size()) == text);
  const auto refused = [](const std::filesystem::path& path, std::size_t most = 1'000) {
    return samples::refusal([&] { (void)file_content(path, most); });
  };
  CHECK(refused(written(folder, text)).find("1000") != std::string::npos);
  CHECK(refused(folder.path() / "none").find(std::strerror(ENOENT)) != std::string::npos);
  CHECK(refused("/proc/self/mem").find(std::strerror(EIO)) !=
        std::string::npos); // its beginning is not mapped
}

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

std::string packed(const std::string& text) {
  const TemporaryFolder folder;
  const auto path = folder.path() / "t.gz";
  const gzFile file = gzopen(path.c_str(), "wb");
  gzwrite(file, text.data(), static_cast<unsigned>(text.size()));
  gzclose(file);
  std::ostringstream bytes;
  bytes << std::ifstream(path, std::ios::binary).rdbuf();
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
  for (const std::size_t missing : {std::size_t{1}, std::size_t{8}, whole.size() / 2, whole.size() - 12}) {
    const auto path = written(folder, whole.substr(0, whole.size() - missing));
    CAPTURE(missing);
    CHECK(samples::refusal([&] { lines(TextSource(path)); }) != "");
  }
  std::string damaged = whole;
  damaged[damaged.size() - 6] = static_cast<char>(damaged[damaged.size() - 6] ^ 1); // its checksum
  const auto path = written(folder, damaged);
  CHECK(samples::refusal([&] { lines(TextSource(path)); }) != "");
}

TEST_CASE("reading ends on a stop request") {
  const TemporaryFolder folder;
  const auto path = folder.path() / "t";
  std::ofstream(path) << "one line\n";
  TextSource source(path);
  const StopScope scope([] { return true; });
  CHECK_THROWS_AS((void)source.next(), Stopped);
}

TEST_CASE("a missing file and a folder are refused by name") {
  const TemporaryFolder folder;
  const std::string missing = (folder.path() / "none").string();
  CHECK(samples::refusal([&] { TextSource source{std::filesystem::path(missing)}; }).starts_with(missing));
  CHECK(samples::refusal([&] { TextSource source{folder.path()}; }).starts_with(folder.path().string()));
}

TEST_CASE("a file that compresses endless zeros into one line costs no more than the longest line") {
  const TemporaryFolder folder;
  const auto path = folder.path() / "bomb.gz";
  const gzFile file = gzopen(path.c_str(), "wb1");
  const std::string zeros(std::size_t{1} << 20, '\0');
  for (int k = 0; k < 70; ++k)
    gzwrite(file, zeros.data(), static_cast<unsigned>(zeros.size()));
  gzclose(file);
  CHECK(samples::refusal([&] { lines(TextSource(path)); }).find("64 MiB") != std::string::npos);
}

TEST_CASE("the bytes behind a line come as they are, plain or gzip") {
  std::string whole = "<xml>\r\n";
  for (std::uint32_t k = 0, value = 1; k < 700'000; ++k, value = value * 1664525 + 1013904223)
    whole += static_cast<char>(value >> 24); // more than two buffers of all bytes, line ends among them
  const TemporaryFolder folder;
  const auto packed = folder.path() / "packed.gz";
  const gzFile file = gzopen(packed.c_str(), "wb1");
  gzwrite(file, whole.data(), static_cast<unsigned>(whole.size()));
  gzclose(file);
  for (const auto& path : {written(folder, whole), packed}) {
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

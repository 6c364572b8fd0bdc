// SPDX-License-Identifier: GPL-3.0-or-later
// How fast the files of other codes are read, and the memory that it takes:
//   bench_reading FILES...       of grains and contacts that go together, as granum analyse takes them
// Prints a row of a table: the median of seven rounds in processor time, and the most memory that the process
// held in a first round beyond what it held before.
// Exit codes: 0 done, 1 something failed, 2 usage.
#include <algorithm>
#include <cstdio>
#include <exception>
#include <filesystem>
#include <vector>

#include <granum/io/packing_files.hpp>

#include "meter.hpp"

using namespace granum;

namespace {

struct Read {
  std::size_t frames = 0, grains = 0, contacts = 0;
};

Read read_all(const std::vector<std::filesystem::path>& files) {
  Read out;
  io::PackingFiles reader(files);
  while (const std::optional<io::ImportedPacking> packing = reader.next()) {
    ++out.frames;
    out.grains += packing->assembly.grain_count();
    out.contacts += packing->assembly.contacts.size();
  }
  return out;
}

} // namespace

int main(int argc, char** argv) try {
  const std::vector<std::filesystem::path> files(argv + 1, argv + argc);
  if (files.empty()) {
    std::fprintf(stderr, "usage: bench_reading FILES...\n");
    return 2;
  }
  double bytes = 0;
  for (const std::filesystem::path& file : files)
    bytes += static_cast<double>(std::filesystem::file_size(file));
  const bench::Meter first;
  const Read held = read_all(files);
  const double most = first.bytes();
  std::vector<double> seconds;
  for (int round = 0; round < 7; ++round) {
    const bench::Meter meter;
    (void)read_all(files);
    seconds.push_back(meter.cpu_seconds());
  }
  std::ranges::sort(seconds);
  const double median = seconds[seconds.size() / 2];
  std::printf("| %s | %zu | %zu | %zu | %.2f | %.3f | %.0f | %.2f |\n",
              files[0].filename().extension() == ".gz" ? "gzip" : "plain", held.frames, held.grains,
              held.contacts, bytes / 1e6, median, bytes / 1e6 / median, most / bytes);
  return 0;
} catch (const std::exception& error) {
  std::fprintf(stderr, "bench_reading: %s\n", error.what());
  return 1;
}

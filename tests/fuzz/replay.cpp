// SPDX-License-Identifier: GPL-3.0-or-later
// Feeds a corpus to a fuzz target where libFuzzer is not at hand: every file of a folder as it is, cut off at
// many places, and with bytes changed at random, always the same ones.
//   replay_<target> <folder> [<changes of each file, 1000 by default>]
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

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size);

namespace {

void feed(const std::string& input) {
  const std::vector<std::uint8_t> bytes(input.begin(),
                                        input.end()); // exactly as long: reading past it is seen
  LLVMFuzzerTestOneInput(bytes.data(), bytes.size());
}

std::string changed(std::string input, std::mt19937_64& random) {
  const std::string alphabet = "0123456789.-+eEn #\n\t,=:IT[]";
  for (std::uint64_t changes = 1 + random() % 4; changes > 0 && !input.empty(); --changes) {
    const std::size_t at = random() % input.size();
    switch (random() % 4) {
    case 0:
      input[at] = static_cast<char>(random());
      break;
    case 1:
      input[at] = alphabet[random() % alphabet.size()];
      break;
    case 2:
      input.erase(at, 1 + random() % 20);
      break;
    default:
      input.insert(at, input.substr(random() % input.size(), random() % 40));
    }
  }
  return input;
}

} // namespace

int main(int argc, char** argv) {
  if (argc != 2 && argc != 3) {
    std::fprintf(stderr, "usage: %s <corpus folder> [<changes>]\n", argv[0]);
    return 2;
  }
  const std::size_t changes = argc == 3 ? std::strtoull(argv[2], nullptr, 10) : 1000;
  const std::size_t cuts = changes / 5;
  std::vector<std::filesystem::path> files;
  for (const auto& entry : std::filesystem::directory_iterator(argv[1]))
    files.push_back(entry.path());
  std::sort(files.begin(), files.end());
  std::mt19937_64 random(20240607);
  std::size_t inputs = 0;
  for (const auto& path : files) {
    std::ostringstream bytes;
    bytes << std::ifstream(path, std::ios::binary).rdbuf();
    const std::string whole = bytes.str();
    feed(whole);
    for (std::size_t k = 0; k < cuts; ++k)
      feed(whole.substr(0, whole.size() * k / cuts));
    for (std::size_t k = 0; k < changes; ++k)
      feed(changed(whole, random));
    inputs += 1 + cuts + changes;
  }
  std::printf("%zu files, %zu inputs\n", files.size(), inputs);
  return files.empty() ? 1 : 0;
}

// SPDX-License-Identifier: GPL-3.0-or-later
// Feeds seeds to a fuzz target where libFuzzer is not at hand: each as it is, cut off at many places, and
// with bytes changed at random, always the same ones.
//   replay <target> <changes of each seed> <file, folder of them, or grains+contacts>...
// With GRANUM_FUZZ_TARGET, the name of a target, the entry of libFuzzer.
#include <algorithm>
#include <cstdint>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <random>
#include <sstream>
#include <vector>

#include "input.hpp"

using granum::fuzz::targets;

#ifdef GRANUM_FUZZ_TARGET
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  targets().at(GRANUM_FUZZ_TARGET)({reinterpret_cast<const char*>(data), size});
  return 0;
}
#else
namespace {

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

std::string content(const std::filesystem::path& path) {
  std::ostringstream bytes;
  bytes << std::ifstream(path, std::ios::binary).rdbuf();
  return bytes.str();
}

std::vector<std::string> seeds(const std::string& argument) {
  if (const std::size_t plus = argument.find('+'); plus != std::string::npos)
    return {content(argument.substr(0, plus)) + "=====\n" + content(argument.substr(plus + 1))};
  if (!std::filesystem::is_directory(argument))
    return {content(argument)};
  std::vector<std::filesystem::path> files;
  for (const auto& entry : std::filesystem::directory_iterator(argument))
    files.push_back(entry.path());
  std::sort(files.begin(), files.end());
  std::vector<std::string> all;
  for (const auto& file : files)
    all.push_back(content(file));
  return all;
}

} // namespace

int main(int argc, char** argv) {
  if (argc < 4 || !targets().contains(argv[1])) {
    std::fprintf(stderr, "usage: %s <target> <changes> <seeds>...\n", argv[0]);
    return 2;
  }
  const auto feed = [&](const std::string& input) {
    const std::vector<char> bytes(input.begin(), input.end()); // exactly as long: reading past it is seen
    targets().at(argv[1])({bytes.data(), bytes.size()});
  };
  const std::size_t changes = std::strtoull(argv[2], nullptr, 10), cuts = changes / 5;
  std::mt19937_64 random(20240607);
  std::size_t count = 0;
  for (int k = 3; k < argc; ++k)
    for (const std::string& whole : seeds(argv[k])) {
      if (whole.empty())
        return 1;
      feed(whole);
      for (std::size_t cut = 0; cut < cuts; ++cut)
        feed(whole.substr(0, whole.size() * cut / cuts));
      for (std::size_t change = 0; change < changes; ++change)
        feed(changed(whole, random));
      ++count;
    }
  std::printf("%zu seeds, %zu inputs\n", count, count * (1 + cuts + changes));
  return count == 0 ? 1 : 0;
}
#endif

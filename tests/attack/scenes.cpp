// SPDX-License-Identifier: GPL-3.0-or-later
// Hostile scenes from a grammar, given to `granum plan`: each is taken (exit code 0) or refused with a
// message (2 or 3); nothing ends the program by a signal or an internal error, and none takes for ever.
//   attack_scenes <program> <scenes> <seed> <scratch folder> <deepest nesting>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <map>
#include <random>
#include <sstream>
#include <string>
#include <vector>

#include <fcntl.h>
#include <spawn.h>
#include <sys/wait.h>

extern char** environ;

namespace {

namespace fs = std::filesystem;

const std::vector<std::string> sections{"grain", "contact", "study", "specimen", "shear"};
const std::vector<std::string> keys{"grain.radius",
                                    "grain.shear_modulus",
                                    "grain.poisson_ratio",
                                    "grain.friction_angle",
                                    "grain.density",
                                    "contact.cone_slope",
                                    "contact.tangential_ratio",
                                    "contact.punch_radius",
                                    "contact.alpha",
                                    "contact.profile_constant",
                                    "study.contacts",
                                    "study.densities",
                                    "study.grains",
                                    "study.seeds",
                                    "study.first_seed",
                                    "study.threads",
                                    "study.pressures",
                                    "study.probe_pressures",
                                    "specimen.boundary",
                                    "specimen.wall_friction",
                                    "specimen.agitation",
                                    "specimen.unjamming_strain",
                                    "specimen.expansion_void_ratio",
                                    "shear.paths",
                                    "shear.eta_step",
                                    "shear.inertial_number",
                                    "shear.largest_strain",
                                    "shear.nothing"};
const std::vector<std::string> units{"", "m", "mm", "Pa", "kPa", "GPa", "deg", "rad", "kg/m^3", "furlong"};
const std::vector<std::string> numbers{"0",
                                       "-0.0",
                                       "1",
                                       "0.5",
                                       "-1",
                                       "1e102",
                                       "1e-110",
                                       "1e308",
                                       "1e-308",
                                       "1e400",
                                       "nan",
                                       "inf",
                                       "-inf",
                                       "0x10",
                                       "1_000",
                                       "1e",
                                       "--1",
                                       "2.5e-3",
                                       "4e-324",
                                       "1e-5",
                                       "30",
                                       "100",
                                       "40",
                                       "9e15",
                                       "1e16",
                                       "2147483648",
                                       "18446744073709551616",
                                       "-9223372036854775809",
                                       "0.3",
                                       "1e5",
                                       "30e9"};
const std::vector<std::string> words{"sphere",  "cone",    "flat",  "power-law", "dense",
                                     "loose",   "TXC",     "walls", "",          "periodic",
                                     "\\u0000", "\\uD800", "\\n",   "../../x"};

class Grammar {
 public:
  Grammar(std::uint64_t seed, std::uint64_t deepest) : random_(seed), deepest_(deepest) {}

  std::string scene() {
    std::string text;
    for (std::uint64_t lines = 1 + below(6); lines > 0; --lines)
      text += line();
    if (below(8) == 0)
      text = mutilated(text);
    return text;
  }

 private:
  std::uint64_t below(std::uint64_t n) { return random_() % n; }
  const std::string& one_of(const std::vector<std::string>& list) { return list[below(list.size())]; }

  std::string line() {
    switch (below(12)) {
    case 0:
      return "[" + one_of(sections) + "]\n";
    case 1:
      return "[[" + one_of(sections) + "]]\n";
    case 2:
      return "# " + std::string(below(3) * 20000, 'x') + "\n";
    case 3: {
      const std::uint64_t levels = depth();
      std::string key = "a";
      for (std::uint64_t k = 0; k < levels; ++k)
        key += ".a";
      return below(2) == 0 ? key + " = 1\n" : "[" + key + "]\n";
    }
    case 4: {
      const std::uint64_t levels = depth();
      return one_of(keys) + " = " + std::string(levels, '[') + "1" +
             std::string(below(4) == 0 ? 0 : levels, ']') + "\n";
    }
    case 5: {
      const std::uint64_t levels = depth();
      std::string text = one_of(keys) + " = ";
      for (std::uint64_t k = 0; k < levels; ++k)
        text += "{a = ";
      return text + "1" + std::string(levels, '}') + "\n";
    }
    default:
      return one_of(keys) + " = " + value() + "\n";
    }
  }

  std::string value() {
    switch (below(6)) {
    case 0:
      return one_of(numbers);
    case 1:
      return '"' + one_of(numbers) + one_of(units) + '"';
    case 2:
      return '"' + one_of(words) + '"';
    case 3: {
      std::string list = "[";
      for (std::uint64_t k = below(below(10) == 0 ? 20000 : 6); k > 0; --k)
        list += value_of_list() + ", ";
      return list + "]";
    }
    case 4:
      return below(2) == 0 ? "true" : "1979-05-27T07:32:00Z";
    default:
      return '"' + std::string(below(3) * 40000, '9') + one_of(units) + '"';
    }
  }

  std::string value_of_list() {
    return below(2) == 0 ? '"' + one_of(numbers) + one_of(units) + '"'
                         : (below(2) == 0 ? '"' + one_of(words) + '"' : one_of(numbers));
  }

  std::string mutilated(std::string text) {
    for (std::uint64_t k = 1 + below(5); k > 0; --k)
      text[below(text.size())] = static_cast<char>(below(256));
    return text.substr(0, 1 + below(text.size()));
  }

  /// Mostly a few, now and then as many as there may be.
  std::uint64_t depth() { return 1 + below(below(4) == 0 ? deepest_ : 8); }

  std::mt19937_64 random_;
  std::uint64_t deepest_;
};

/// Wait status of a run without input, its streams in files.
int status_of(const std::string& program, const std::vector<std::string>& arguments, const fs::path& out,
              const fs::path& err) {
  std::vector<char*> argv;
  std::vector<std::string> copies{program};
  copies.insert(copies.end(), arguments.begin(), arguments.end());
  for (std::string& text : copies)
    argv.push_back(text.data());
  argv.push_back(nullptr);
  posix_spawn_file_actions_t files;
  posix_spawn_file_actions_init(&files);
  posix_spawn_file_actions_addopen(&files, 0, "/dev/null", O_RDONLY, 0);
  posix_spawn_file_actions_addopen(&files, 1, out.c_str(), O_WRONLY | O_CREAT | O_TRUNC, 0600);
  posix_spawn_file_actions_addopen(&files, 2, err.c_str(), O_WRONLY | O_CREAT | O_TRUNC, 0600);
  pid_t child = 0;
  const int error = posix_spawn(&child, program.c_str(), &files, nullptr, argv.data(), environ);
  posix_spawn_file_actions_destroy(&files);
  int status = -1;
  if (error == 0)
    waitpid(child, &status, 0);
  return status;
}

std::string contents(const fs::path& path) {
  std::ostringstream bytes;
  bytes << std::ifstream(path, std::ios::binary).rdbuf();
  return bytes.str();
}

} // namespace

int main(int argc, char** argv) {
  if (argc != 6) {
    std::fprintf(stderr, "usage: %s <program> <scenes> <seed> <scratch folder> <deepest nesting>\n", argv[0]);
    return 2;
  }
  const std::uint64_t scenes = std::strtoull(argv[2], nullptr, 10);
  Grammar grammar(std::strtoull(argv[3], nullptr, 10), std::strtoull(argv[5], nullptr, 10));
  const fs::path folder = argv[4];
  fs::create_directories(folder);
  const fs::path scene = folder / "scene.toml", out = folder / "out", err = folder / "err";
  std::map<int, std::size_t> codes;
  std::size_t faults = 0;
  for (std::uint64_t k = 0; k < scenes; ++k) {
    const std::string text = grammar.scene();
    std::ofstream(scene, std::ios::binary | std::ios::trunc) << text;
    const int status = status_of(argv[1], {"plan", "--scene", scene.string(), "--json"}, out, err);
    const int code = WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
    ++codes[code];
    const std::string said = contents(err);
    const bool refused = (code == 2 || code == 3) && said.starts_with("granum: error: ");
    const bool taken = code == 0 && contents(out).starts_with("{");
    if (refused || taken)
      continue;
    const fs::path kept = folder / ("fault-" + std::to_string(k) + ".toml");
    fs::copy_file(scene, kept, fs::copy_options::overwrite_existing);
    std::printf("exit code %d for %s: %.200s\n", code, kept.c_str(), said.c_str());
    ++faults;
  }
  std::printf("%llu scenes, %zu faults;", static_cast<unsigned long long>(scenes), faults);
  for (const auto& [code, count] : codes)
    std::printf(" exit code %d: %zu", code, count);
  std::printf("\n");
  return faults == 0 ? 0 : 1;
}

// SPDX-License-Identifier: GPL-3.0-or-later
// Random command lines over all options that the commands have, as their own tables list them, run in this
// process and held against what must be true of any answer:
//   attack_command_lines <lines> <seed> <data of tests/cli> <scratch folder>
// Exit code 1, with the first lines that broke a promise, if any did.
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include <fcntl.h>
#include <unistd.h>

#include <granum/core/units.hpp>

#include "../refusal_text.hpp"
#include "command_lines.hpp"
#include "printed_numbers.hpp"

namespace {

using namespace granum;
using attack::Line;
using attack::Lines;
using attack::Random;
using nlohmann::json;

struct Ended {
  int code = 0;
  std::string out, said;
  std::optional<RefusedNumber> refused = {};
};

/// A standard stream that goes to a file of this process, and can be read.
class Caught {
 public:
  Caught(int stream, const std::string& path)
      : file_(open(path.c_str(), O_RDWR | O_CREAT | O_TRUNC | O_APPEND, 0600)) {
    if (file_ < 0 || dup2(file_, stream) < 0)
      std::abort();
  }
  std::string take() {
    std::string text(static_cast<std::size_t>(lseek(file_, 0, SEEK_END)), '\0');
    const auto size = pread(file_, text.data(), text.size(), 0);
    if (size != static_cast<long>(text.size()) || ftruncate(file_, 0) != 0)
      std::abort();
    return text;
  }

 private:
  int file_;
};

class Attack {
 public:
  Attack(std::uint64_t seed, const std::string& data, const std::string& scratch)
      : random_(seed), lines_(random_, data), report_(fdopen(dup(STDOUT_FILENO), "w")),
        out_(STDOUT_FILENO, scratch + "/out"), said_(STDERR_FILENO, scratch + "/said"),
        row_(scratch + "/row.csv") {}

  void one() {
    const Line line = lines_.any();
    const Ended ended = run(line);
    judge(ended);
    if (ended.code == 0) {
      std::map<std::string, double> given;
      for (const attack::Given& one : lines_.given(line))
        if (one.value)
          given[one.option] = *one.value;
      judge_limits(given);
    }
    if (line.name != "estimate")
      return;
    if (line.json && (ended.code == 0 || ended.code == 2) && random_.one_in(2))
      ask_row(line, ended);
    else if (ended.code == 0)
      compare(line, ended);
    if (ended.refused && line.has(ended.refused->name))
      try_ends(line, *ended.refused);
  }

  [[nodiscard]] int report() const {
    for (const auto& [name, codes] : codes_) {
      std::fprintf(report_, "%-8s", name.c_str());
      for (const auto& [code, count] : codes)
        std::fprintf(report_, "  %d: %zu", code, count);
      std::fprintf(report_, "\n");
    }
    std::fprintf(report_, "%zu runs, %zu rows of tables, %zu comparisons, %zu promises broken\n", runs_,
                 rows_, comparisons_, broken_);
    for (const auto& [promise, count] : count_)
      std::fprintf(report_, "%9zu  %s\n", count, promise.c_str());
    bool answered = true; // of each command a fifth or more of the lines has an answer
    for (const auto& [name, codes] : codes_) {
      std::size_t all = 0, good = 0;
      for (const auto& [code, count] : codes) {
        all += count;
        good += code == 0 ? count : 0;
      }
      answered = answered && (5 * good >= all || all < 50);
    }
    std::fflush(report_);
    return broken_ == 0 && answered ? 0 : 1;
  }

 private:
  Ended run(const Line& line) {
    here_ = &line;
    ++runs_;
    std::vector<std::string> words{"granum", line.name};
    words.insert(words.end(), line.words.begin(), line.words.end());
    std::vector<char*> argv;
    for (std::string& word : words)
      argv.push_back(word.data());
    Ended ended;
    std::string error;
    try {
      ended.code = static_cast<int>(cli::parse_and_run(static_cast<int>(argv.size()), argv.data()));
    } catch (const InvalidArgument& e) {
      ended.code = 2;
      error = e.what();
      ended.refused = e.refused();
    } catch (const FileError& e) {
      ended.code = 3;
      error = e.what();
    } catch (const NotConverged& e) {
      ended.code = 4;
      error = e.what();
    } catch (const std::exception& e) {
      ended.code = 1;
      error = e.what();
      demand(false, "ends in what is no error of granum: " + error.substr(0, 60));
    }
    ended.out = out_.take();
    ended.said = said_.take() + error;
    ++codes_[line.name][ended.code];
    return ended;
  }

  [[nodiscard]] bool is_typed(const RefusedNumber& refused) const {
    const std::string text = here_->value(refused.name);
    const auto number = leading_number(text);
    const auto unit = find_unit(number ? number->rest : ""), shown = find_unit(refused.unit);
    return number && unit && shown &&
           std::abs(number->value * unit->factor - refused.value * shown->factor) <=
               1e-9 * std::abs(number->value * unit->factor);
  }

  void judge_refusal(const Ended& ended) {
    demand(!contradicts_itself(ended.said), "a refused value is within the range it is refused by");
    if (ended.refused && here_->has(ended.refused->name))
      demand(is_typed(*ended.refused), "an option is refused for a value that was not typed");
  }

  /// What is true of any run.
  void judge(const Ended& ended) {
    demand(ended.code >= 0 && ended.code <= 4, "an exit code that no page lists");
    demand(ended.code != 3, "no file can have failed: " + ended.said.substr(0, 60));
    demand(ended.code != 0 || !ended.out.empty(), "an answer without a word");
    demand(ended.code == 0 || !ended.said.empty(), "an error without a word");
    demand(ended.code != 2 || ended.out.empty(), "a usage error with an answer");
    judge_refusal(ended);
    for (const std::string* text : {&ended.out, &ended.said})
      demand(!attack::speaks_of_no_number(*text), "nan or inf is printed");
    if (!here_->json || ended.out.empty())
      return;
    const json answer = json::parse(ended.out, nullptr, false);
    demand(!answer.is_discarded(), "what --json prints is no JSON");
    attack::check_numbers(answer, "",
                          [&](bool holds, const std::string& promise) { demand(holds, promise); });
  }

  /// An option that was refused, at the ends of its range and beside them. Answers there are not judged: they
  /// are of packings that have no stiffness.
  void try_ends(const Line& line, const RefusedNumber& refused) {
    for (const char* before : {"(", "[", ", "})
      if (const std::size_t at = refused.range.find(before); at != std::string::npos)
        if (const auto end = leading_number(refused.range.substr(at + std::string_view(before).size())))
          for (const double value : around(end->value))
            if (random_.one_in(4))
              judge_refusal(run(line.with(refused.name, value, refused.unit)));
  }

  /// The same packing asked in another way, or with one number larger.
  void compare(const Line& line, const Ended& ended) {
    if (!line.json)
      return;
    const json answer = json::parse(ended.out).at("answer");
    const double G = answer.at("shear_modulus").at("value");
    const double K = answer.at("bulk_modulus").at("value"), compression = 1e3 * line.pressure / K;
    const bool rigid = G > 0.03 * K;
    const auto share = answer.find("rattler_fraction"); // null for a sand
    const double rattlers =
        share != answer.end() && share->is_object() ? share->at("value").get<double>() : 0;
    ++comparisons_;
    switch (random_.below(4)) {
    case 0:
      // At a given C_n fewer rattlers mean fewer contacts of the others: flat ones soften by 1e-4. Unequal
      // flat grains near the isostatic point lose up to 6 %, which rung 3 has to mend. With a given share of
      // rattlers z* is that of packings of this e, which were looser before a higher pressure: 1 % softer
      // once grains are no longer nearly rigid. So are those under stresses of a hundredth of K.
      if (!line.has("--coordination-number") && !line.has("--uniformity") && !line.has("--sizes") &&
          compression < 0.01)
        stiffer(line.with("--pressure", line.pressure * (1 + random_.decades(-3, 1)), "kPa"), "shear_modulus",
                G, "more pressure softens");
      return;
    case 1:
      if (line.has("--mechanical-coordination-number"))
        stiffer(line.with("--mechanical-coordination-number", line.contacts * (1 + random_.decades(-3, -0.5)),
                          ""),
                "shear_modulus", G, "more contacts soften");
      return;
    case 2:
      // At the edge of rigidity overlaps, which grow with e, decide by 1e-3 of a contact; with more rattlers
      // than any packing that was tested z* stays at that edge.
      if (line.has("--void-ratio") && rigid && rattlers < 0.25)
        stiffer(line.with("--void-ratio", line.void_ratio / (1 + random_.decades(-3, -0.5)), ""),
                "shear_modulus", G, "denser is softer");
      return;
    default:
      const double density = answer.at("bulk_density").at("value");
      return stiffer(line.with("--saturation", 1, ""), "bulk_density", density, "water has no weight");
    }
  }

  void stiffer(const Line& more, const std::string& key, double before, const std::string& promise) {
    const Ended ended = run(more);
    judge(ended);
    if (ended.code == 0)
      demand(json::parse(ended.out).at("answer").at(key).at("value").get<double>() >= before * (1 - 1e-9),
             promise);
  }

  /// The same question as the last row of a table, some of its options being columns; the rows before are of
  /// other void ratios and pressures.
  void ask_row(const Line& line, const Ended& ended) {
    for (const char* other : {"--uncertainty", "--tolerance", "--bounds", "--cement", "--cement-friction",
                              "--report", "--full", "--densest"})
      if (line.has(other)) // which sweep does not take, or answers otherwise
        return;
    constexpr std::size_t others = 6;
    Line row = line;
    std::string headings = "run";
    std::array<std::string, others + 1> cells;
    std::array<std::map<std::string, double>, others + 1> numbers;
    for (const attack::Given& given : lines_.given(line)) {
      const bool moves = given.option == "--pressure" || given.option == "--void-ratio";
      const bool column = given.option == "--pressure" || random_.one_in(2);
      if (column) {
        headings += ',' + given.heading;
        row = row.without(given.option);
      }
      for (std::size_t k = 0; k <= others; ++k) {
        const double here =
            given.value.value_or(0) * (moves && column && k < others ? random_.decades(-0.4, 0.4) : 1);
        if (column)
          cells[k] += ',' + (given.value ? exact_text(here) : given.cell);
        if (given.value)
          numbers[k][given.option] = here;
      }
    }
    std::ofstream table(row_);
    table << headings << '\n';
    for (const std::string& one : cells)
      table << '1' << one << '\n';
    table.close();
    row.name = "sweep";
    row.json = false;
    row.words.erase(std::remove(row.words.begin(), row.words.end(), "--json"), row.words.end());
    row.words.insert(row.words.end(), {"--table", row_, "--units", "si"});
    const Ended swept = run(row);
    judge(swept);
    const std::vector<std::map<std::string, double>> found = attack::cells_of_rows(swept.out);
    rows_ += found.size();
    for (std::size_t k = 0; k < std::min(found.size(), numbers.size()); ++k)
      judge_row(found[k], numbers[k]);
    const bool answered = found.size() == cells.size() && found.back().contains("G_answer_Pa");
    if (ended.code == 2)
      return demand(!answered, "a row of a table is answered where estimate refuses: " + headings);
    demand(answered, "a row of a table is refused where estimate answers: " + headings);
    if (!answered)
      return;
    const json answer = json::parse(ended.out).at("answer");
    for (const auto& [heading, key, member] : attack::cells_of_answer)
      if (const auto cell = found.back().find(heading); cell != found.back().end() && answer.contains(key))
        demand(cell->second == answer.at(key).at(member).get<double>(),
               "a row differs from estimate: " + heading + " of " + headings);
  }

  /// An answered row has its numbers in their ranges, and nothing beyond its limits.
  void judge_row(const std::map<std::string, double>& cells, const std::map<std::string, double>& given) {
    if (!cells.contains("G_answer_Pa"))
      return;
    for (const char* of : {"G", "V_s"}) {
      const std::string unit = *of == 'G' ? "_Pa" : "_m/s";
      const auto low = cells.find(of + ("_low" + unit)), value = cells.find(of + ("_answer" + unit)),
                 high = cells.find(of + ("_high" + unit));
      if (low != cells.end() && value != cells.end() && high != cells.end())
        demand(low->second <= value->second && value->second <= high->second && std::isfinite(high->second),
               "a row's number is not within its range");
    }
    judge_limits(given);
  }

  /// Nothing beyond its limits is answered.
  void judge_limits(const std::map<std::string, double>& given) {
    const auto value = [&](const char* option) {
      const auto found = given.find(option);
      return found == given.end() ? std::nullopt : std::optional(found->second);
    };
    constexpr double rounding = 1e-9;
    const auto e = value("--void-ratio"), least = value("--least-void-ratio"),
               most = value("--largest-void-ratio");
    if (e && least && most)
      demand(std::abs((*most - *e) / (*most - *least) - 0.6) <= 0.6 + rounding,
             "a relative density beyond 0 to 1.2");
    if (const auto D_r = value("--relative-density"))
      demand(*D_r >= 0 && *D_r <= 1.2, "a relative density beyond 0 to 1.2");
    if (const auto k0 = value("--k0"))
      demand(*k0 > 0.03 && *k0 < 33, "a K_0 that no friction holds");
    if (const auto roughness = value("--roughness"))
      demand(*roughness >= 0 && *roughness <= 10e-6, "a roughness beyond 10 um");
  }

  void demand(bool holds, const std::string& promise) {
    if (holds)
      return;
    ++broken_;
    if (++count_[promise] > 3)
      return;
    std::fprintf(report_, "%s\n ", promise.c_str());
    std::fprintf(report_, " granum %s", here_->name.c_str());
    for (const std::string& word : here_->words)
      std::fprintf(report_, " %s", word.c_str());
    std::fprintf(report_, "\n");
    std::fflush(report_);
  }

  Random random_;
  Lines lines_;
  std::FILE* report_;
  Caught out_, said_;
  std::string row_;
  const Line* here_ = nullptr;
  std::size_t runs_ = 0, rows_ = 0, comparisons_ = 0, broken_ = 0;
  std::map<std::string, std::size_t> count_;
  std::map<std::string, std::map<int, std::size_t>> codes_;
};

} // namespace

int main(int argc, char** argv) {
  if (argc != 5) {
    std::fprintf(stderr, "usage: %s <lines> <seed> <data of tests/cli> <scratch folder>\n", argv[0]);
    return 2;
  }
  std::filesystem::create_directories(argv[4]);
  Attack attack(std::strtoull(argv[2], nullptr, 10), argv[3], argv[4]);
  for (std::uint64_t k = std::strtoull(argv[1], nullptr, 10); k > 0; --k)
    attack.one();
  return attack.report();
}

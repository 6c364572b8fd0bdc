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
    if (line.name == "estimate" && line.json && (ended.code == 0 || ended.code == 2))
      ask_row(line, ended);
  }

  [[nodiscard]] int report() const {
    for (const auto& [name, codes] : codes_) {
      std::fprintf(report_, "%-8s", name.c_str());
      for (const auto& [code, count] : codes)
        std::fprintf(report_, "  %d: %zu", code, count);
      std::fprintf(report_, "\n");
    }
    std::fprintf(report_, "%zu runs, %zu rows of tables\n", runs_, rows_);
    bool answered = true; // of each command a fifth or more of the lines has an answer
    for (const auto& [name, codes] : codes_) {
      std::size_t all = 0, good = 0;
      for (const auto& [code, count] : codes) {
        all += count;
        good += code == 0 ? count : 0;
      }
      answered = answered && (5 * good >= all || all < 50);
    }
    return promises_.report() && answered ? 0 : 1;
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
    } catch (const std::exception& e) {
      error = e.what();
      const auto* invalid = dynamic_cast<const InvalidArgument*>(&e);
      ended.code = invalid                                 ? 2
                   : dynamic_cast<const FileError*>(&e)    ? 3
                   : dynamic_cast<const NotConverged*>(&e) ? 4
                                                           : 1;
      if (invalid)
        ended.refused = invalid->refused();
      demand(ended.code != 1, "ends in what is no error of granum: " + error.substr(0, 60));
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

  /// What is true of any run.
  void judge(const Ended& ended) {
    demand(ended.code >= 0 && ended.code <= 4, "an exit code that no page lists");
    demand(ended.code != 3, "no file can have failed: " + ended.said.substr(0, 60));
    demand(ended.code != 0 || !ended.out.empty(), "an answer without a word");
    demand(ended.code == 0 || !ended.said.empty(), "an error without a word");
    demand(ended.code != 2 || ended.out.empty(), "a usage error with an answer");
    demand(!contradicts_itself(ended.said), "a refused value is within the range it is refused by");
    if (ended.refused && here_->has(ended.refused->name))
      demand(is_typed(*ended.refused), "an option is refused for a value that was not typed");
    for (const std::string* text : {&ended.out, &ended.said})
      demand(!attack::speaks_of_no_number(*text), "nan or inf is printed");
    if (!here_->json || ended.out.empty())
      return;
    const json answer = json::parse(ended.out, nullptr, false);
    demand(!answer.is_discarded(), "what --json prints is no JSON");
    attack::check_numbers(answer, "",
                          [&](bool holds, const std::string& promise) { demand(holds, promise); });
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
    for (const auto& cells_of_row : found)
      judge_row(cells_of_row);
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

  /// An answered row has its numbers in their ranges.
  void judge_row(const std::map<std::string, double>& cells) {
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
  }

  void demand(bool holds, const std::string& promise) { promises_.demand(holds, promise); }

  Random random_;
  Lines lines_;
  std::FILE* report_;
  Caught out_, said_;
  std::string row_;
  const Line* here_ = nullptr;
  std::size_t runs_ = 0, rows_ = 0;
  attack::Promises promises_{report_, [this] {
                               std::string line = "granum " + here_->name;
                               for (const std::string& word : here_->words)
                                 line += " " + word;
                               return line;
                             }};
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

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include <granum/core/error.hpp>
#include <granum/core/text.hpp>
#include <granum/core/units.hpp>

#include "cli/commands.hpp"
#include "samples.hpp"

/// Random command lines of the commands that answer at once.
namespace attack {

/// A line without the name of the program.
struct Line {
  std::string name;               ///< of the command
  std::vector<std::string> words; ///< after it
  bool json = false;

  [[nodiscard]] bool has(const std::string& option) const {
    return std::find(words.begin(), words.end(), option) != words.end();
  }
  [[nodiscard]] std::string value(const std::string& option) const {
    return *std::next(std::find(words.begin(), words.end(), option));
  }
  [[nodiscard]] Line without(const std::string& option) const {
    Line line = *this;
    const auto found = std::find(line.words.begin(), line.words.end(), option);
    if (found != line.words.end())
      line.words.erase(found, found + 2);
    return line;
  }
};

/// An option of a line as a column of a table.
struct Given {
  std::string option, heading, cell;
  std::optional<double> value; ///< of a number, in SI
};

/// Where most values of an option are taken from, by its name; others are of the decades of their type.
struct Usual {
  const char* option;
  double low, high;
};
inline constexpr std::array usual{
    Usual{"--void-ratio", 0.3, 1.3},
    Usual{"--porosity", 0.2, 0.6},
    Usual{"--solid-fraction", 0.4, 0.8},
    Usual{"--relative-density", 0, 1.1},
    Usual{"--least-void-ratio", 0.3, 0.6},
    Usual{"--largest-void-ratio", 0.6, 1.2},
    Usual{"--saturation", 0, 1},
    Usual{"--coordination-number", 3, 9},
    Usual{"--mechanical-coordination-number", 3.9, 9},
    Usual{"--rattler-fraction", 0, 0.3},
    Usual{"--fabric", -0.6, 0.6},
    Usual{"--grain-poisson-ratio", 0, 0.5},
    Usual{"--tangential-ratio", 0, 1},
    Usual{"--rolling", 0, 1},
    Usual{"--slope", 0.01, 2},
    Usual{"--alpha", 1, 6},
    Usual{"--profile-constant", 0.1, 1000},
    Usual{"--uniformity", 1, 12},
    Usual{"--tolerance", 0.001, 1},
    Usual{"--eta", 0.1, 1.2},
    Usual{"--k0", 0.3, 2},
    Usual{"--measurement-error", 0, 0.2},
    Usual{"--predict-stress-ratio", 0.3, 2},
    Usual{"--predict-void-ratio", 0.4, 1},
    Usual{"--error", 0.001, 0.2},
};

/// Of a kind of numbers, as help calls it.
struct OfType {
  const char* type;
  double low, high; ///< of its decades
  const char* unit;
};
inline constexpr std::array types{
    OfType{"PRESSURE", 3, 7, "Pa"},   OfType{"LENGTH", -5, -2, "m"},         OfType{"SPEED", 1.5, 3.3, "m/s"},
    OfType{"DENSITY", 3, 4, "kg/m3"}, OfType{"UNIT_WEIGHT", 4, 4.4, "N/m3"}, OfType{"ANGLE", 0.5, 1.7, "deg"},
    OfType{"NUMBER", -2, 1, ""},
};

class Lines {
 public:
  Lines(Random& random, std::string data)
      : random_(random), data_(std::move(data)), program_(cli::make_program()) {}

  Line any() {
    constexpr std::array names{"estimate", "estimate", "estimate", "sweep",  "sweep",
                               "infer",    "fit",      "plan",     "analyse"};
    Line line{.name = names[random_.below(names.size())], .words = {}};
    begin(line);
    const cli::Command& command = *std::find_if(program_->within.begin(), program_->within.end(),
                                                [&](const cli::Command& c) { return c.name == line.name; });
    for (std::uint64_t more = random_.below(random_.one_in(8) ? 9 : 4); more > 0; --more)
      add_option(line, command);
    line.json = random_.below(3) != 0;
    if (line.json)
      line.words.emplace_back("--json");
    return line;
  }

  /// Options of a line that tables have as columns: all numbers, and texts on the grains and their contacts.
  [[nodiscard]] std::vector<Given> given(const Line& line) const {
    constexpr std::array texts{"--contact", "--preparation", "--grain", "--sand", "--grain-shape", "--sizes"};
    const cli::Command& command = *std::find_if(program_->within.begin(), program_->within.end(),
                                                [&](const cli::Command& c) { return c.name == line.name; });
    std::vector<Given> all;
    for (const cli::OptionRow& row : command.options) {
      const std::string name = long_name(row);
      const bool text = std::find(texts.begin(), texts.end(), name) != texts.end();
      if (!line.has(name) || (row.value.number == nullptr && !text && name != "--uniformity"))
        continue;
      std::string heading = name.substr(2), cell = line.value(name);
      std::replace(heading.begin(), heading.end(), '-', '_');
      if (text) {
        all.push_back({name, heading, cell, std::nullopt});
        continue;
      }
      const auto dimension =
          row.value.number != nullptr ? row.value.number->dimension : granum::Dimension::dimensionless;
      double value = 0;
      try {
        value = granum::parse_quantity(name, cell, dimension);
      } catch (const granum::Error&) {
        continue; // a number that no double holds
      }
      const std::string unit(granum::si_symbol(dimension));
      all.push_back({name, heading + (unit.empty() ? "" : "_" + unit), granum::exact_text(value), value});
    }
    return all;
  }

 private:
  /// What the command cannot do without.
  void begin(Line& line) {
    if (line.name == "fit")
      line.words = {data_ + (random_.one_in(2) ? "/isotropic.csv" : "/hv_dense_cone.csv")};
    else if (line.name == "analyse")
      line.words = {data_ + "/../../io/data/lammps_chain.atoms",
                    data_ + "/../../io/data/lammps_chain.contacts"};
    else if (line.name != "plan")
      begin_packing(line);
  }

  void begin_packing(Line& line) {
    const double pressure = random_.decades(0.5, 4); // [kPa]
    const std::string text = granum::exact_text(pressure);
    line.words = {"--void-ratio", granum::exact_text(random_.between(0.45, 0.95))};
    if (line.name == "sweep") {
      if (random_.one_in(2))
        line.words.insert(line.words.end(), {"--from", "10kPa", "--to", text + "MPa"});
      else
        line.words.insert(line.words.end(),
                          {"--depth", "1m.." + granum::exact_text(random_.between(2, 200)) + "m"});
      line.words.insert(line.words.end(), {"--points", std::to_string(2 + random_.below(6))});
      return;
    }
    line.words.insert(line.words.end(), {"--pressure", text + "kPa"});
    if (line.name == "infer") // between what few and what many contacts give spheres of quartz
      line.words.insert(line.words.end(), {"--vs", granum::exact_text(std::pow(pressure / 100, 1 / 6.0) *
                                                                      random_.between(180, 360)) +
                                                       "m/s"});
  }

  void add_option(Line& line, const cli::Command& command) {
    const cli::OptionRow& row = command.options[random_.below(command.options.size())];
    if (row.positional())
      return;
    const std::string name = long_name(row);
    // Files are for test_exit_codes.py; the others print something else, or are there already.
    for (const char* other : {"--out", "--picture", "--scene", "--force", "--help", "--version", "--table",
                              "--sieve", "--column-map", "--paraview", "--json", "--points", "--material",
                              "--window", "--box", "--stress", "--depth", "--set"})
      if (name == other)
        return;
    if (line.has(name))
      return;
    if (row.value.flag()) {
      line.words.push_back(name);
      return;
    }
    const std::string value = value_of(name, row.value, command);
    if (value.empty())
      return;
    line.words.insert(line.words.end(), {name, value});
  }

  static std::string long_name(const cli::OptionRow& row) {
    const std::vector<std::string> names = cli::names_of(row);
    const auto found = std::find_if(names.begin(), names.end(),
                                    [](const std::string& name) { return name.starts_with("--"); });
    return found == names.end() ? row.name : *found;
  }

  static std::string number(double value) { return granum::exact_text(value); }

  std::string value_of(const std::string& name, const cli::Value& value, const cli::Command& command) {
    if (!value.choices.empty())
      return choice(value.choices);
    const std::string type = value.type.substr(0, value.type.find("[+-"));
    const bool error = type != value.type;
    if (type == "N")
      return std::to_string(random_.below(random_.one_in(2) ? 5 : 2000));
    if (type == "DISTRIBUTION")
      return choice({"equal", "bidisperse:2:0.5", "uniform:1:3", "lognormal:0.4", "power-law:2.5:4"});
    if (type == "KEY=SD")
      return deviation(command);
    for (const OfType& of : types)
      if (type == of.type)
        return quantity(name, of) +
               (error && random_.one_in(2) ? "+-" + number(random_.between(0.1, 20)) + "%" : "");
    return {};
  }

  std::string quantity(const std::string& name, const OfType& of) {
    if (random_.one_in(12)) // wild
      return (random_.one_in(3) ? "-" : "") +
             number(random_.one_in(4)   ? 0
                    : random_.one_in(2) ? random_.decades(-12, 12)
                                        : random_.decades(-300, 300)) +
             of.unit;
    if (name == "--grain-shear-modulus")
      return number(random_.decades(0, 2)) + "GPa";
    if (name == "--punch-radius")
      return number(random_.between(1, 100)) + "um";
    for (const Usual& u : usual)
      if (name == u.option)
        return number(random_.between(u.low, u.high));
    return number(random_.decades(of.low, of.high)) + of.unit;
  }

  std::string choice(const std::vector<std::string>& words) {
    const std::string& word = words[random_.below(words.size())];
    const std::size_t colon = word.find(":NUMBER");
    return colon == std::string::npos ? word : word.substr(0, colon + 1) + number(random_.decades(-3, 0.5));
  }

  /// Of an option of the command that takes a number.
  std::string deviation(const cli::Command& command) {
    for (int tries = 0; tries < 20; ++tries) {
      const cli::OptionRow& row = command.options[random_.below(command.options.size())];
      if (row.value.number != nullptr)
        return long_name(row).substr(2) + "=" + number(random_.decades(-3, 2)) + "%";
    }
    return {};
  }

  Random& random_;
  std::string data_;
  std::unique_ptr<cli::Command> program_;
};

} // namespace attack

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <array>
#include <cfloat>
#include <cmath>
#include <map>
#include <regex>
#include <sstream>
#include <string>
#include <utility>

#include <granum/core/text.hpp>
#include <nlohmann/json.hpp>

#include "samples.hpp"

/// What must be true of every number that a command prints.
namespace attack {

/// "nan" or "inf" where a number should be.
inline bool speaks_of_no_number(const std::string& text) {
  static const std::regex open_end(R"(, inf[)\]])"); // of a range that an error names
  static const std::regex no_number(R"((^|[^A-Za-z_./-])-?(nan|inf|infinity)($|[^A-Za-z_.]))");
  return std::regex_search(std::regex_replace(text, open_end, ""), no_number);
}

/// The ranges that the meaning of a number leaves it.
struct Bounds {
  const char* ending; ///< of its key
  double low, high;
};
inline constexpr std::array bounds{
    Bounds{"modulus", 0, INFINITY},
    Bounds{"wave_speed", 0, INFINITY},
    Bounds{"density", 0, INFINITY},
    Bounds{"poisson_ratio", -1, 1}, // solids with an axis of symmetry go beyond 0.5
    Bounds{"coordination_number", 0, INFINITY},
    Bounds{"rattler_fraction", 0, 1},
    Bounds{"saturation", 0, 1},
    Bounds{"void_ratio", 0, INFINITY},
    Bounds{"slip_strain", DBL_MIN, INFINITY}, // where it is not known it is left out
};

inline bool is_number(const nlohmann::json& json, const char* key) {
  return json.contains(key) && json.at(key).is_number();
}

/// All numbers below a key are finite, each range in order and where its meaning lets it be.
inline void check_numbers(const nlohmann::json& json, const std::string& key, const Demand& demand) {
  if (json.is_number_float())
    demand(std::isfinite(json.get<double>()), "not finite: " + key);
  if (json.is_string())
    demand(!speaks_of_no_number(json.get<std::string>()), "a text speaks of no number: " + key);
  const bool ranged =
      json.is_object() && json.contains("value") && json.contains("low") && json.contains("high");
  if (ranged) // JSON has null for NaN and infinity
    for (const char* part : {"value", "low", "high"})
      demand(is_number(json, part), "null in " + key + ": " + part);
  if (ranged && is_number(json, "value") && is_number(json, "low") && is_number(json, "high")) {
    const double low = json.at("low"), value = json.at("value"), high = json.at("high");
    demand(low <= value && value <= high, "not within its range: " + key);
    for (const Bounds& b : bounds)
      if (key.ends_with(b.ending))
        demand(low >= b.low && high <= b.high, "beyond what it can be: " + key);
  }
  if (json.is_object())
    for (const auto& [name, member] : json.items())
      check_numbers(member, name, demand);
  if (json.is_array())
    for (const nlohmann::json& member : json)
      check_numbers(member, key, demand);
}

/// Headings of a row of `sweep --table`, and the keys of estimate's answer that have the same numbers.
inline const std::array<std::array<std::string, 3>, 8> cells_of_answer{
    {{"G_answer_Pa", "shear_modulus", "value"},
     {"G_low_Pa", "shear_modulus", "low"},
     {"G_high_Pa", "shear_modulus", "high"},
     {"V_s_answer_m/s", "shear_wave_speed", "value"},
     {"V_s_low_m/s", "shear_wave_speed", "low"},
     {"V_s_high_m/s", "shear_wave_speed", "high"},
     {"V_p_answer_m/s", "compression_wave_speed", "value"},
     {"V_p_high_m/s", "compression_wave_speed", "high"}}};

/// Of each row by heading, those that are numbers; comments begin with #.
inline std::vector<std::map<std::string, double>> cells_of_rows(const std::string& csv) {
  std::vector<std::vector<std::string>> rows;
  std::istringstream text(csv);
  for (std::string line; std::getline(text, line);)
    if (!line.starts_with("#")) {
      std::istringstream fields(line);
      rows.emplace_back();
      for (std::string field; std::getline(fields, field, ',');)
        rows.back().push_back(field);
    }
  std::vector<std::map<std::string, double>> cells;
  // Notes come last and may hold commas of their own.
  for (std::size_t row = 1; row < rows.size(); ++row) {
    cells.emplace_back();
    for (std::size_t k = 0; k < std::min(rows.front().size(), rows[row].size()); ++k)
      if (!rows[row][k].empty())
        cells.back()[rows.front()[k]] = std::strtod(rows[row][k].c_str(), nullptr);
  }
  return cells;
}

} // namespace attack

// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>

#include <fmt/core.h>
#include <granum/core/error.hpp>
#include <granum/core/number.hpp>
#include <granum/io/csv/table.hpp>

#include "fit.hpp"

namespace granum::cli {

namespace {

using Names = std::vector<std::string>;

/// What people call a column; the first is what errors name.
const Names modulus_names = {"G", "G_max", "Gmax", "G_0", "G0", "G_hv", "G_vh", "G_hh", "Ghv", "Gvh", "Ghh"};
const Names vertical_names = {"sigma_v", "sigma'_v", "sigma_v'", "sigma_1", "sigma1", "sigma_a", "sigma_z"};
const Names horizontal_names = {"sigma_h", "sigma'_h", "sigma_h'", "sigma_3", "sigma3", "sigma_r", "sigma_x"};
const Names mean_names = {"p",       "p'",      "p0",      "p_0",    "p'_0",  "p0'",    "sigma_0", "sigma0",
                          "sigma_c", "sigma_m", "sigma_3", "sigma3", "sigma", "sigma'", "stress"};
const Names void_ratio_names = {"e", "void_ratio", "e_0", "e0"};

/// The first of the names that the table has a column of; empty if none.
std::string found_in(const io::CsvTable& table, const Names& names) {
  for (const std::string& name : names)
    if (table.has(name))
      return name;
  return {};
}

bool has_unit(const std::string& heading, const std::string& quantity, Dimension dimension) {
  try {
    return is_column_of(heading, quantity) && column_factor(heading, quantity, dimension) > 0;
  } catch (const InvalidArgument&) {
    return false;
  }
}

/// The quantity that a user names, who may have given the whole heading, "G_MPa" or "G (MPa)".
std::string quantity_of(const io::CsvTable& table, const std::string& given, Dimension dimension) {
  const auto& headings = table.headings();
  if (std::find(headings.begin(), headings.end(), given) == headings.end())
    return given;
  for (std::size_t end = given.size() - 1; end > 0; --end) {
    const std::string begin(trimmed(given.substr(0, end)));
    if (has_unit(given, begin, dimension))
      return begin;
  }
  return given;
}

/// The direction that the name of a modulus gives, 'v' or 'h', of i (place 0) or j (place 1); G is taken as
/// G_vh.
char direction_of(const std::string& modulus, std::size_t place) {
  const std::size_t end = modulus.size();
  const bool named = end > 2 && modulus.find_first_not_of("hv", end - 2) == std::string::npos;
  return named ? modulus[end - 2 + place] : "vh"[place];
}

void fill_in_columns(const io::CsvTable& table, FitQuestion& question) {
  for (std::string* column : {&question.modulus_column, &question.stress_i_column, &question.stress_j_column})
    *column = quantity_of(table, *column, Dimension::pressure);
  question.void_ratio_column = quantity_of(table, question.void_ratio_column, Dimension::dimensionless);
  const auto fill = [&](std::string& column, const Names& names) {
    if (column.empty())
      column = found_in(table, names);
    if (column.empty())
      column = names.front();
  };
  fill(question.modulus_column, modulus_names);
  fill(question.void_ratio_column, void_ratio_names);
  const bool no_stress_named = question.stress_i_column.empty() && question.stress_j_column.empty();
  const bool no_pair = found_in(table, vertical_names).empty() || found_in(table, horizontal_names).empty();
  if (const std::string mean = found_in(table, mean_names); no_stress_named && no_pair && !mean.empty()) {
    question.stress_i_column = question.stress_j_column = mean;
    question.sum_only = true;
  }
  const auto names_of = [](char direction) { return direction == 'v' ? vertical_names : horizontal_names; };
  fill(question.stress_i_column, names_of(direction_of(question.modulus_column, 0)));
  fill(question.stress_j_column, names_of(direction_of(question.modulus_column, 1)));
}

std::vector<double> void_ratios(const io::CsvTable& table, const FitQuestion& question,
                                hardin::VoidRatioFunction function) {
  if (table.has(question.void_ratio_column))
    return table.numbers(question.void_ratio_column, Dimension::dimensionless);
  if (function == hardin::VoidRatioFunction::none)
    return std::vector<double>(table.row_count(), 1.0); // any value does where f(e) = 1
  throw FileError(
      question.file, 0,
      fmt::format("expected a column '{}' of the void ratio; --void-ratio-column names another, and "
                  "--void-ratio-function none does without",
                  question.void_ratio_column));
}

} // namespace

std::vector<hardin::MeasuredModulus> read_rows(FitQuestion& question, hardin::VoidRatioFunction function) {
  const io::CsvTable table = io::read_csv(question.file);
  fill_in_columns(table, question);
  const auto modulus = table.numbers(question.modulus_column, Dimension::pressure);
  const auto stress_i = table.numbers(question.stress_i_column, Dimension::pressure);
  const auto stress_j = table.numbers(question.stress_j_column, Dimension::pressure);
  const auto void_ratio = void_ratios(table, question, function);
  std::vector<hardin::MeasuredModulus> rows;
  for (std::size_t k = 0; k < table.row_count(); ++k) {
    rows.push_back({modulus[k], {stress_i[k], stress_j[k], void_ratio[k]}});
    try {
      hardin::require_valid(rows.back(), function);
    } catch (const InvalidArgument& error) {
      throw FileError(question.file, table.line(k),
                      fmt::format("{} (stress_i is {}, stress_j is {})", error.what(),
                                  question.stress_i_column, question.stress_j_column));
    }
  }
  return rows;
}

} // namespace granum::cli

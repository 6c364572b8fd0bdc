// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include <granum/core/validity.hpp>
#include <granum/hardin/fit.hpp>
#include <granum/plot/chart.hpp>
#include <nlohmann/json.hpp>

#include "cli/frame/frame.hpp"

/// What granum fit reads, and how it puts the fitted law into words.
namespace granum::cli {

/// Columns by the name of their quantity, without unit; empty: the usual names are looked for.
struct FitQuestion {
  std::string file;
  std::string modulus_column;
  std::string stress_i_column;
  std::string stress_j_column;
  std::string void_ratio_column;
  std::string void_ratio_function = "hardin-richart-round";
  std::string weights = "relative";
  double atmospheric_pressure = 100e3; ///< [Pa]
  double middle_stress = 0;            ///< geometric mean of those of all rows [Pa]
  bool sum_only = false;
  bool void_ratio_function_given = false, void_ratio_column_given = false;
  Validity remarks; ///< rows left out, likely slips, what was taken instead of what is missing
  std::string picture;
  OutputOptions output;
};

/// Reads the rows, and fills in which columns hold them. A file with one mean stress, p, allows s alone; one
/// without a void ratio has f(e) = 1. Rows with an empty cell among these columns are left out.
/// \throws   FileError for what cannot be read, a missing column, or a row that no fit can take
[[nodiscard]] std::vector<hardin::MeasuredModulus> read_rows(FitQuestion& question);

[[nodiscard]] nlohmann::ordered_json fit_json(const FitQuestion& question, const hardin::FitReport& report);
[[nodiscard]] std::string fit_table(const FitQuestion& question, const hardin::FitReport& report);
/// G/f(e) of the rows against the stress that the law takes, the law, and the slopes of cones and spheres.
[[nodiscard]] plot::Chart fit_chart(const FitQuestion& question, const hardin::Fit& fit,
                                    const std::vector<hardin::MeasuredModulus>& rows);

} // namespace granum::cli

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include <granum/core/error.hpp>
#include <granum/hardin/fit.hpp>

#include "cli/frame/frame.hpp"

/// Input of granum fit.
namespace granum::cli {

/// Columns by the name of their quantity, without unit; empty: the usual names are tried.
struct FitQuestion {
  std::string file;
  std::string modulus_column; ///< or that of V_s
  std::string stress_i_column;
  std::string stress_j_column;
  std::string void_ratio_column;
  std::string void_ratio_function = "hardin-richart-round";
  std::string weights = "relative";
  double atmospheric_pressure = 100e3; ///< [Pa]
  double middle_stress = 0;            ///< geometric mean of those of all rows [Pa]
  bool sum_only = false;
  bool void_ratio_function_given = false, void_ratio_column_given = false;
  bool by_porosity = false; ///< the column of the void ratio is one of porosity
  bool by_speed = false;    ///< the column of the modulus is one of V_s, G = density V_s^2
  Validity remarks;         ///< rows left out, likely mistakes, substitutes for missing columns
  std::string picture;
  OutputOptions output;
};

/// "G", or "rho V_s^2" of measured speeds: the left side of the law.
[[nodiscard]] std::string modulus_name(const FitQuestion& question);
/// Reads the rows, and records the columns used. A file with only a mean stress, p, allows only s; without a
/// void ratio f(e) = 1. Without a modulus V_s and the density give it; the density has a column, or follows
/// from void ratio, grain density (2650 kg/m3 without a column) and degree of saturation (0 without one).
/// Rows with an empty cell in these columns are left out.
/// \throws   FileError for an unreadable file, a missing column, or a row that cannot be used in a fit
[[nodiscard]] std::vector<hardin::MeasuredModulus> read_rows(FitQuestion& question);

} // namespace granum::cli

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <optional>
#include <stdexcept>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

/// What the library throws, the checks of arguments that throw it, and notes on values that it returns.
namespace granum {

/// Root of every exception that the library throws. A NUL in its text would end what(), and is escaped there.
class Error : public std::runtime_error {
 public:
  explicit Error(const std::string& text);
};

/// A number that was refused.
struct RefusedNumber {
  std::string name;  ///< of the argument, as the user knows it
  double value = 0;  ///< [unit]
  std::string unit;  ///< "" for a pure number
  std::string range; ///< allowed values, "(0, 1)"
};

/// An argument that no physical state can have (porosity 38, Poisson's ratio 0.6, NaN).
/// The text of a refused number reads "<name> = <value> [<unit>] is outside <range>".
/// Checked by tests/core/test_check.cpp
class InvalidArgument : public Error {
 public:
  using Error::Error;
  InvalidArgument(const std::string& name, double value, const std::string& unit, const std::string& range);

  /// The number, where it is one number that was refused.
  [[nodiscard]] const std::optional<RefusedNumber>& refused() const { return refused_; }

 private:
  std::optional<RefusedNumber> refused_;
};

/// A file that cannot be read or written. The text begins with "<path>:<line>: " (line 0: no line
/// is meant).
class FileError : public Error {
 public:
  FileError(const std::string& path, std::size_t line, const std::string& what);

  [[nodiscard]] const std::string& path() const { return path_; }
  [[nodiscard]] std::size_t line() const { return line_; } ///< counted from 1; 0: no line is meant

 private:
  std::string path_;
  std::size_t line_;
};

/// A result was requested from a calculation that did not converge.
class NotConverged : public Error {
 public:
  using Error::Error;
};

/// Long work was stopped (core/stop.hpp) before it had a result.
class Stopped : public Error {
 public:
  Stopped() : Error("stopped on request") {}
};

/// \file
/// Range checks of public functions. Each returns its value, so that a check can be written where the value
/// is used.
/// Assumes   name and unit as the user knows them; unit "" for a pure number.
/// \throws   InvalidArgument with name, value, unit and the allowed range; NaN and infinity never pass.
/// Checked by tests/core/test_check.cpp

/// Common part of the checks: cold, so that a passed check costs one comparison.
namespace detail {
[[noreturn]] void refuse(std::string_view name, double value, std::string_view unit, const char* range);
[[noreturn]] void refuse_open(std::string_view name, double value, std::string_view unit, double low,
                              double high);
[[noreturn]] void refuse_closed(std::string_view name, double value, std::string_view unit, double low,
                                double high);
/// "[low, high]", "(low, high)" as the checks write them: with as many digits as exclude the refused value.
[[nodiscard]] std::string closed_range(double low, double high, double refused);
[[nodiscard]] std::string open_range(double low, double high, double refused);
/// Whether a range that begins as "[0, 1)" contains a value; false if an end is in words.
[[nodiscard]] bool contains(std::string_view range, double value);
/// A value that a range refuses, with `digits` digits, or all where rounding would move it into the range.
[[nodiscard]] std::string refused_text(double value, std::string_view range, int digits);
inline constexpr double largest = std::numeric_limits<double>::max();
} // namespace detail

/// Any finite number.
inline double require_finite(std::string_view name, double value, std::string_view unit = "") {
  if (!(value >= -detail::largest && value <= detail::largest)) [[unlikely]]
    detail::refuse(name, value, unit, "(-inf, inf)");
  return value;
}
/// value > 0 and finite.
inline double require_positive(std::string_view name, double value, std::string_view unit = "") {
  if (!(value > 0 && value <= detail::largest)) [[unlikely]]
    detail::refuse(name, value, unit, "(0, inf)");
  return value;
}
/// value >= 0 and finite.
inline double require_non_negative(std::string_view name, double value, std::string_view unit = "") {
  if (!(value >= 0 && value <= detail::largest)) [[unlikely]]
    detail::refuse(name, value, unit, "[0, inf)");
  return value;
}
/// low <= value <= high.
inline double require_closed(std::string_view name, double value, double low, double high,
                             std::string_view unit = "") {
  if (!(value >= low && value <= high)) [[unlikely]]
    detail::refuse_closed(name, value, unit, low, high);
  return value;
}
/// low < value < high.
inline double require_open(std::string_view name, double value, double low, double high,
                           std::string_view unit = "") {
  if (!(value > low && value < high)) [[unlikely]]
    detail::refuse_open(name, value, unit, low, high);
  return value;
}

/// Poisson's ratio of an isotropic elastic solid: -1 < value <= 0.5.
inline double require_poisson_ratio(std::string_view name, double value) {
  if (!(value > -1 && value <= 0.5)) [[unlikely]]
    detail::refuse(name, value, "", "(-1, 0.5]");
  return value;
}

/// How far two entries that should be equal may differ, over the largest entry. A solver leaves less than
/// 1e-6, and two halves rounded to four digits, each by itself, differ by 1e-3 at most. A matrix in
/// which one half was left out is far above, unless that half does not matter.
inline constexpr double largest_asymmetry = 1e-3;

/// Any finite, symmetric matrix.
/// Throws    InvalidArgument for entries that are not finite, or differ by more than largest_asymmetry
template <int size, class Matrix>
void require_symmetric(const char* name, const Matrix& matrix) {
  double largest = 0, difference = 0;
  int row = 0, column = 0;
  for (int i = 0; i < size; ++i)
    for (int j = 0; j <= i; ++j) {
      const double below = require_finite(name, matrix(i, j)), above = require_finite(name, matrix(j, i));
      largest = std::max({largest, std::abs(below), std::abs(above)});
      if (const double d = std::abs(below - above); d > difference) {
        difference = d;
        row = i + 1;
        column = j + 1;
      }
    }
  if (difference > largest_asymmetry * largest)
    throw InvalidArgument(std::string(name) + " is not symmetric: entries " + std::to_string(row) +
                          std::to_string(column) + " and " + std::to_string(column) + std::to_string(row) +
                          " differ by more than rounding");
}

/// Notes on a value that is possible but lies outside the range for which its formula was derived or
/// measured.
/// Empty: no notes. The program prints the notes as warnings; `--strict` makes them an error.
struct Validity {
  std::vector<std::string> notes;

  [[nodiscard]] bool ok() const { return notes.empty(); }
  void add(std::string note) { notes.push_back(std::move(note)); }
  /// Skips notes that are already present.
  void keep_each_once() {
    std::vector<std::string> once;
    for (std::string& note : notes)
      if (std::find(once.begin(), once.end(), note) == once.end())
        once.push_back(std::move(note));
    notes = std::move(once);
  }
  void merge(const Validity& other) { notes.insert(notes.end(), other.notes.begin(), other.notes.end()); }
};

} // namespace granum

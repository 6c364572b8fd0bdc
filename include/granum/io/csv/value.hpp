// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <concepts>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <type_traits>
#include <utility>
#include <variant>
#include <vector>

#include <granum/core/numerics.hpp>
#include <granum/core/units.hpp>

/// Values in results, and their format for people: the cells of columns.hpp.
/// Checked by tests/io/csv/test_columns.cpp
namespace granum::io {

/// Value of a row in a column. The first two mean an empty cell; JSON leaves the first out and has the
/// second as null.
using Value =
    std::variant<std::monostate, std::nullptr_t, double, std::uint64_t, std::int64_t, bool, std::string,
                 Measured, std::vector<double>, std::vector<std::string>, std::vector<std::vector<double>>>;
[[nodiscard]] inline bool is_nothing(const Value& value) { return value.index() < 2; }
/// A number, a count, or the value of a Measured; empty for others.
[[nodiscard]] std::optional<double> number_of(const Value& value);

/// How a column looks on a screen and in a page.
struct ShownColumn {
  std::string heading;
  int width = 0;           ///< in a table [characters]; below 0: to the left; 0: not in tables
  int digits = 4;          ///< significant ones, or behind the point
  bool fixed = false;      ///< digits behind the point
  double unit = 1;         ///< that numbers are shown in [SI]
  std::string absent = ""; ///< text of an empty cell in a table; a list leaves it out
  std::string symbol = ""; ///< behind a number: " %"
  std::optional<Dimension> dimension = {}; ///< numbers are shown in the unit that suits, "66.95 mN"
  std::string meaning = "";                ///< in a list, behind the number
  bool listed = true;                      ///< in a list
  bool sign = false;                       ///< numbers above 0 have a + in front
};

/// The value of a getter's result.
template <class T>
[[nodiscard]] Value value_of(T&& of) {
  using Plain = std::remove_cvref_t<T>;
  if constexpr (std::same_as<Plain, Value> || std::same_as<Plain, bool> ||
                std::same_as<Plain, std::nullptr_t>)
    return Value(std::forward<T>(of));
  else if constexpr (std::floating_point<Plain>)
    return static_cast<double>(of);
  else if constexpr (std::unsigned_integral<Plain>)
    return static_cast<std::uint64_t>(of);
  else if constexpr (std::integral<Plain>)
    return static_cast<std::int64_t>(of);
  else if constexpr (std::convertible_to<Plain, std::string_view>)
    return std::string(std::string_view(of));
  else if constexpr (requires { *of; })
    return of ? value_of(*std::forward<T>(of)) : Value();
  else
    return Value(std::forward<T>(of));
}

/// A getter that returns null for empty.
template <class Get>
struct OrNull {
  Get get;

  template <class Row>
  Value operator()(const Row& row) const {
    Value value = value_of(std::invoke(get, row));
    return is_nothing(value) ? Value(nullptr) : value;
  }
};
template <class Get>
[[nodiscard]] OrNull<Get> or_null(Get get) {
  return {std::move(get)};
}

/// Whether a getter returns a value with its error, or empty.
template <class Get, class Row>
inline constexpr bool gives_measured =
    std::convertible_to<std::invoke_result_t<Get, const Row&>, std::optional<Measured>> &&
    !std::same_as<std::remove_cvref_t<std::invoke_result_t<Get, const Row&>>, std::nullopt_t>;
template <class Get, class Row>
inline constexpr bool gives_measured<OrNull<Get>, Row> = gives_measured<Get, Row>;

/// Text between a value and its standard error.
inline constexpr const char* screen_sign = "+-";
inline constexpr const char* page_sign = " \u00b1 ";

/// A value as text, with unit and digits of the column; `absent` if empty.
[[nodiscard]] std::string shown_text(const ShownColumn& column, const Value& value, const char* sign);
/// A heading or a value in its column. A value that fills its column has a blank in front, so that it never
/// runs into the one before.
[[nodiscard]] std::string heading_text(const ShownColumn& column);
[[nodiscard]] std::string cell_text(const ShownColumn& column, const Value& value);
/// A line of a list: label, value, meaning. Errors have two significant digits.
[[nodiscard]] std::string list_line(const ShownColumn& column, const Value& value, int label_width = 24);

} // namespace granum::io

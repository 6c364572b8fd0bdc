// SPDX-License-Identifier: GPL-3.0-or-later
#include <granum/io/csv/columns.hpp>

#include <algorithm>

#include <granum/core/number.hpp>

namespace granum::io {

namespace {

std::string to_the_right(const std::string& text, int width) {
  const auto missing =
      static_cast<std::size_t>(width) - std::min(text.size(), static_cast<std::size_t>(width));
  return std::string(missing, ' ') + text;
}

} // namespace

std::string heading_text(const ShownColumn& column) { return to_the_right(column.heading, column.width); }

std::string number_text(const ShownColumn& column, const std::optional<double>& number) {
  if (!number)
    return to_the_right(column.absent, column.width);
  const double shown = *number / column.unit;
  const std::string text = column.fixed ? detail::formatted("%.*f", column.digits, shown)
                                        : detail::formatted("%.*g", column.digits, shown);
  const bool fills = text.size() >= static_cast<std::size_t>(column.width);
  return (fills ? " " : "") + to_the_right(text, column.width);
}

} // namespace granum::io

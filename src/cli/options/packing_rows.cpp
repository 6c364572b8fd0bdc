// SPDX-License-Identifier: GPL-3.0-or-later
#include "packing_rows.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include <fmt/core.h>
#include <granum/core/error.hpp>
#include <granum/core/number.hpp>

namespace granum::cli {

namespace {

/// "--void-ratio" as the heading void_ratio.
std::string heading_of(const Number& number) {
  std::string name = number.name.substr(2);
  std::replace(name.begin(), name.end(), '-', '_');
  return name;
}

void refuse_twice(bool option_given, const std::string& option, const std::string& heading) {
  if (option_given)
    throw InvalidArgument(fmt::format("{} is an option and the column '{}' too", option, heading));
}

} // namespace

PackingRows::PackingRows(const io::CsvTable& table, const PackingOptions& options)
    : table_(table), row_(options), read_(table.headings().size(), false) {
  const auto& headings = table.headings();
  for (Number* number : numbers(row_))
    for (const std::string& name : {heading_of(*number), number->symbol})
      if (!name.empty() && table.has(name))
        bind(*number, table.column(name, number->dimension));
  const auto contact = std::find(headings.begin(), headings.end(), "contact");
  if (contact != headings.end()) {
    contact_ = static_cast<std::size_t>(contact - headings.begin());
    refuse_twice(row_.contact_given(), "--contact", "contact");
    read_[*contact_] = true;
    row_.contact_in_table = true;
  }
}

const PackingOptions& PackingRows::packing(std::size_t row) {
  const auto& fields = table_.fields(row);
  for (const Input& input : inputs_)
    take(input, fields[input.column.index]);
  if (contact_) {
    const std::string& text = fields[*contact_];
    const std::optional<contact::Shape> shape = contact::find_shape(text);
    if (!shape)
      throw InvalidArgument(fmt::format("contact '{}' is not one of {}", text, contact::shape_names()));
    row_.contact = *shape;
  }
  return row_;
}

std::vector<std::string> PackingRows::unread() const {
  std::vector<std::string> headings;
  for (std::size_t k = 0; k < read_.size(); ++k)
    if (!read_[k])
      headings.push_back(table_.headings()[k]);
  return headings;
}

void PackingRows::bind(Number& number, const io::CsvTable::Column& column) {
  const std::string& heading = table_.headings()[column.index];
  refuse_twice(number.given(), number.name, heading);
  for (const Input& input : inputs_)
    if (input.number == &number)
      throw InvalidArgument(fmt::format("both '{}' and '{}' hold {}", table_.headings()[input.column.index],
                                        heading, heading_of(number)));
  inputs_.push_back({&number, column});
  read_[column.index] = true;
}

/// Whether every packing has this number, whatever its contact and however its density is given.
bool PackingRows::always_needed(const Number& number) const {
  const Number* needed[] = {&row_.grain_shear_modulus, &row_.grain_poisson_ratio, &row_.radius,
                            &row_.coordination_number, &row_.fabric};
  return std::find(std::begin(needed), std::end(needed), &number) != std::end(needed);
}

/// An empty field is an input that the row does not give; no default stands in for it.
void PackingRows::take(const Input& input, const std::string& field) const {
  Number& number = *input.number;
  number.in_table = !trimmed(field).empty();
  number.value = std::numeric_limits<double>::quiet_NaN();
  if (!number.in_table && always_needed(number))
    throw InvalidArgument(fmt::format("column '{}' is empty", table_.headings()[input.column.index]));
  if (!number.in_table)
    return;
  const auto value = parse_number(field);
  if (!value || !std::isfinite(*value * input.column.factor))
    throw InvalidArgument(fmt::format("expected a finite number in column '{}', found '{}'",
                                      table_.headings()[input.column.index], field));
  number.value = *value * input.column.factor;
}

} // namespace granum::cli

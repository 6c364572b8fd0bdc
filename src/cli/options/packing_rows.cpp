// SPDX-License-Identifier: GPL-3.0-or-later
#include "packing_rows.hpp"

#include <algorithm>

#include <fmt/core.h>
#include <granum/core/error.hpp>
#include <granum/core/number.hpp>
#include <granum/sizes/distribution_text.hpp>

namespace granum::cli {

namespace {

/// Numbers that a packing may lack, as its contacts or how its density is given, have no default.
EmptyField when_empty(const PackingOptions& o, const Number& number) {
  const Number* needed[] = {&o.grain_shear_modulus, &o.grain_poisson_ratio, &o.radius, &o.fabric};
  return std::find(std::begin(needed), std::end(needed), &number) != std::end(needed) ? EmptyField::refused
                                                                                      : EmptyField::not_given;
}

} // namespace

PackingRows::PackingRows(const io::CsvTable& table, const PackingOptions& options)
    : table_(table), row_(options), columns_(table) {
  for (Number* number : numbers(row_))
    columns_.bind(*number, when_empty(row_, *number));
  contact_ = columns_.text("contact", row_.contact_given());
  row_.contact_in_table = contact_.has_value();
  sizes_ = columns_.text("sizes", row_.sizes.has_value());
  uniformity_ = {0, Dimension::dimensionless, "C_u Cu", "--uniformity"};
  uniformity_.preset = row_.sizes.has_value();
  sizes_in_table_ = columns_.bind(uniformity_, EmptyField::not_given) || sizes_;
}

const PackingOptions& PackingRows::packing(std::size_t row) {
  const auto& fields = table_.fields(row);
  columns_.take(row);
  if (contact_) {
    const std::string& text = fields[*contact_];
    const std::optional<contact::Shape> shape = contact::find_shape(text);
    if (!shape)
      throw InvalidArgument(fmt::format("contact '{}' is not one of {}", text, contact::shape_names()));
    row_.contact = *shape;
  }
  take_sizes(fields);
  return row_;
}

/// Equal grains where the row says nothing of their sizes.
void PackingRows::take_sizes(const std::vector<std::string>& fields) {
  const bool told = sizes_ && !trimmed(fields[*sizes_]).empty();
  if (told && uniformity_.in_table)
    throw InvalidArgument("sizes and uniformity say the same: give one of them");
  if (told)
    row_.sizes = sizes::parse_distribution(fields[*sizes_]);
  else if (uniformity_.in_table)
    row_.sizes = sizes::Distribution::uniformity(uniformity_.value);
  else if (sizes_in_table_)
    row_.sizes.reset();
}

} // namespace granum::cli

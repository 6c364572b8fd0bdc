// SPDX-License-Identifier: GPL-3.0-or-later
#include "packing_rows.hpp"

#include <fmt/core.h>
#include <granum/core/error.hpp>
#include <granum/core/number.hpp>
#include <granum/sizes/distribution_text.hpp>

namespace granum::cli {

PackingRows::PackingRows(const io::CsvTable& table, const PackingOptions& options)
    : table_(table), row_(options), contact_by_default_(options.contact), columns_(table) {
  for (Number* number : numbers(row_)) {
    const bool is_given = columns_.bind(*number) || number->given();
    const bool stress = number == &row_.pressure || number == &row_.stress_v || number == &row_.stress_h;
    tells_stress_ = tells_stress_ || (stress && is_given);
  }
  contact_ = columns_.text("contact", row_.contact_given());
  sizes_ = columns_.text("sizes", row_.sizes.has_value());
  uniformity_ = {0, Dimension::dimensionless, "C_u Cu", "--uniformity"};
  uniformity_.preset = row_.sizes.has_value();
  sizes_in_table_ = columns_.bind(uniformity_) || sizes_;
}

const PackingOptions& PackingRows::packing(std::size_t row) {
  const auto& fields = table_.fields(row);
  columns_.take(row);
  const std::string text(contact_ ? trimmed(fields[*contact_]) : "");
  row_.contact_in_table = !text.empty();
  row_.contact = contact_by_default_;
  if (row_.contact_in_table) {
    const std::optional<contact::Shape> shape = contact::find_shape(text);
    if (!shape)
      throw InvalidArgument(fmt::format("contact '{}' is not one of {}", text, contact::shape_names()));
    row_.contact = *shape;
  }
  take_sizes(fields);
  return row_;
}

/// Equal grains if the row has no sizes.
void PackingRows::take_sizes(const std::vector<std::string>& fields) {
  const bool is_given = sizes_ && !trimmed(fields[*sizes_]).empty();
  if (is_given && uniformity_.in_table)
    throw InvalidArgument("sizes and uniformity are alternatives: give one of them");
  if (sizes_in_table_) {
    row_.graded = uniformity_.in_table;
    row_.uniformity = uniformity_.in_table ? std::optional(uniformity_.value) : std::nullopt;
  }
  if (is_given)
    row_.sizes = sizes::parse_distribution(fields[*sizes_]);
  else if (uniformity_.in_table)
    row_.sizes = sizes::Distribution::uniformity(uniformity_.value);
  else if (sizes_in_table_)
    row_.sizes.reset();
}

} // namespace granum::cli

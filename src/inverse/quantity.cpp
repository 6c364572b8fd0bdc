// SPDX-License-Identifier: GPL-3.0-or-later
#include <granum/inverse/quantity.hpp>

#include <algorithm>
#include <string>

#include <granum/core/error.hpp>

namespace granum::inverse {

namespace {

using effective::Modulus;

constexpr QuantityRow table[] = {
    {Quantity::G_vh, "G", Modulus::G_vh, false, "shear modulus of a vertical plane"},
    {Quantity::G_hh, "G_hh", Modulus::G_hh, false, "shear modulus of the horizontal plane"},
    {Quantity::K, "K", Modulus::K, false, "bulk modulus"},
    {Quantity::V_s, "V_s", Modulus::G_vh, true, "shear wave, vertical"},
    {Quantity::V_s_hh, "V_s_hh", Modulus::G_hh, true, "shear wave, horizontal"},
    {Quantity::V_p, "V_p", Modulus::C33, true, "compression wave, vertical"},
    {Quantity::V_p_h, "V_p_h", Modulus::C11, true, "compression wave, horizontal"}};

/// The one of that name among all of them.
template <class Values, class Name>
const auto& named(const char* what, const Values& all, const Name& name_of, std::string_view text) {
  std::string names;
  for (const auto& value : all) {
    if (name_of(value) == text)
      return value;
    names += (names.empty() ? "" : ", ") + std::string(name_of(value));
  }
  throw InvalidArgument(std::string(what) + " is one of " + names + ", not " + std::string(text));
}

} // namespace

std::span<const QuantityRow> quantities() { return table; }

const QuantityRow& row_of(Quantity quantity) {
  const auto found = std::find_if(std::begin(table), std::end(table),
                                  [quantity](const QuantityRow& row) { return row.quantity == quantity; });
  if (found == std::end(table))
    throw InvalidArgument("quantity is not one of the known ones");
  return *found;
}

Quantity quantity_of(std::string_view key) {
  const auto key_of = [](const QuantityRow& row) { return std::string_view(row.key); };
  return named("quantity", table, key_of, key).quantity;
}

void require_measured(const QuantityRow& row, const Measured& value) {
  const char* const unit = row.speed ? "m/s" : "Pa";
  // Outside of these, nothing is a solid.
  require_open(row.key, value.value, row.speed ? 0.01 : 1, row.speed ? 1e5 : 1e14, unit);
  require_closed(std::string(row.key) + " error", value.standard_error, 0, value.value, unit);
}

std::string_view name(GrowthRule growth) {
  switch (growth) {
  case GrowthRule::packings:
    return "packings";
  case GrowthRule::fixed:
    return "fixed";
  case GrowthRule::fitted:
    return "fitted";
  }
  throw InvalidArgument("growth is not one of the known ones");
}

std::string_view name(AskedPacking specimen) {
  switch (specimen) {
  case AskedPacking::same:
    return "same";
  case AskedPacking::prepared_alike:
    return "prepared_alike";
  }
  throw InvalidArgument("specimen is not one of the known ones");
}

GrowthRule growth_rule_of(std::string_view text) {
  return named(
      "growth", all_growth_rules, [](GrowthRule rule) { return name(rule); }, text);
}

AskedPacking asked_packing_of(std::string_view text) {
  return named(
      "specimen", all_asked_packings, [](AskedPacking asked) { return name(asked); }, text);
}

} // namespace granum::inverse

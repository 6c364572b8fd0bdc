// SPDX-License-Identifier: GPL-3.0-or-later
#include <granum/inverse/growth.hpp>

#include <string>

#include <granum/core/error.hpp>

namespace granum::inverse {

namespace {

/// The value of that name among all of them.
template <class Values>
typename Values::value_type named_value(const char* what, const Values& all, std::string_view text) {
  std::string names;
  for (const auto value : all) {
    if (name(value) == text)
      return value;
    names += (names.empty() ? "" : ", ") + std::string(name(value));
  }
  throw InvalidArgument(std::string(what) + " is one of " + names + ", not " + std::string(text));
}

} // namespace

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

GrowthRule growth_rule_of(std::string_view text) { return named_value("growth", all_growth_rules, text); }

AskedPacking asked_packing_of(std::string_view text) {
  return named_value("specimen", all_asked_packings, text);
}

} // namespace granum::inverse

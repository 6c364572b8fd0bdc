// SPDX-License-Identifier: GPL-3.0-or-later
#include <granum/core/units.hpp>

#include <algorithm>
#include <cctype>
#include <cmath>
#include <iterator>
#include <numbers>
#include <vector>

#include <granum/core/error.hpp>
#include <granum/core/number.hpp>

namespace granum {

namespace {

constexpr double degree = std::numbers::pi / 180;

/// Every unit. The first of a dimension is SI, or nothing for a pure number; those that hints and tables use
/// come in order of size.
constexpr Unit units[] = {
    {"", Dimension::dimensionless, 1},   {"%", Dimension::dimensionless, 1e-2},
    {"Pa", Dimension::pressure, 1},      {"kPa", Dimension::pressure, 1e3},
    {"MPa", Dimension::pressure, 1e6},   {"GPa", Dimension::pressure, 1e9},
    {"m", Dimension::length, 1},         {"nm", Dimension::length, 1e-9},
    {"um", Dimension::length, 1e-6},     {"mm", Dimension::length, 1e-3},
    {"cm", Dimension::length, 1e-2},     {"rad", Dimension::angle, 1},
    {"deg", Dimension::angle, degree},   {"kg/m3", Dimension::density, 1},
    {"kg/m^3", Dimension::density, 1},   {"g/cm3", Dimension::density, 1e3},
    {"g/cm^3", Dimension::density, 1e3}, {"s", Dimension::time, 1},
    {"ns", Dimension::time, 1e-9},       {"us", Dimension::time, 1e-6},
    {"ms", Dimension::time, 1e-3},       {"N", Dimension::force, 1},
    {"nN", Dimension::force, 1e-9},      {"uN", Dimension::force, 1e-6},
    {"mN", Dimension::force, 1e-3},      {"kN", Dimension::force, 1e3},
    {"MN", Dimension::force, 1e6},       {"m/s", Dimension::speed, 1},
    {"km/s", Dimension::speed, 1e3},
};

std::vector<Unit> units_of(Dimension dimension) {
  std::vector<Unit> found;
  std::copy_if(std::begin(units), std::end(units), std::back_inserter(found),
               [&](const Unit& unit) { return unit.dimension == dimension; });
  return found;
}

/// "100Pa, 100kPa, 100MPa, 100GPa"; without `number` the symbols alone.
std::string choices(Dimension dimension, std::string_view number) {
  std::string text;
  for (const Unit& unit : units_of(dimension))
    if (!unit.symbol.empty())
      text += (text.empty() ? "" : ", ") + std::string(number) + std::string(unit.symbol);
  return text;
}

bool same_but_for_case(std::string_view a, std::string_view b) {
  const auto lower = [](char c) { return std::tolower(static_cast<unsigned char>(c)); };
  return std::equal(a.begin(), a.end(), b.begin(), b.end(),
                    [&](char x, char y) { return lower(x) == lower(y); });
}

std::string near_symbol(std::string_view symbol, Dimension dimension) {
  for (const Unit& unit : units_of(dimension))
    if (same_but_for_case(unit.symbol, symbol))
      return "did you mean " + std::string(unit.symbol) + "?";
  const std::string known = choices(dimension, "");
  return "known for " + std::string(description(dimension)) + ": " + known;
}

} // namespace

std::optional<Unit> find_unit(std::string_view symbol) {
  const auto found = std::find_if(std::begin(units), std::end(units),
                                  [&](const Unit& unit) { return unit.symbol == symbol; });
  return found == std::end(units) ? std::nullopt : std::optional<Unit>(*found);
}

std::string_view si_symbol(Dimension dimension) { return units_of(dimension).front().symbol; }

std::string_view description(Dimension dimension) {
  switch (dimension) {
  case Dimension::dimensionless:
    return "a pure number";
  case Dimension::pressure:
    return "a pressure";
  case Dimension::length:
    return "a length";
  case Dimension::angle:
    return "an angle";
  case Dimension::density:
    return "a density";
  case Dimension::time:
    return "a time";
  case Dimension::force:
    return "a force";
  case Dimension::speed:
    return "a speed";
  }
  throw InvalidArgument("dimension is not one of the known ones");
}

double parse_quantity(std::string_view name, std::string_view text, Dimension dimension) {
  const std::string said = std::string(name) + " = '" + std::string(text) + "'";
  const std::string_view content = trimmed(text);
  const auto number = leading_number(content);
  if (!number)
    throw InvalidArgument(said + " is not " + std::string(description(dimension)) +
                          ": it must begin with a finite number");
  const std::string_view symbol = trimmed(number->rest);
  const auto unit = find_unit(symbol);
  if (!unit)
    throw InvalidArgument(said + " has the unknown unit '" + std::string(symbol) + "'; " +
                          near_symbol(symbol, dimension));
  if (symbol.empty() && dimension != Dimension::dimensionless)
    throw InvalidArgument(std::string(name) + " = " + std::string(content) + " has no unit; write " +
                          choices(dimension, content));
  if (unit->dimension != dimension)
    throw InvalidArgument(said + " must be " + std::string(description(dimension)) + ", not " +
                          std::string(description(unit->dimension)));
  const double value = unit->factor * number->value;
  if (!std::isfinite(value))
    throw InvalidArgument(said + " is too large");
  return value;
}

bool is_column_of(std::string_view heading, std::string_view quantity) {
  if (!heading.starts_with(quantity))
    return false;
  const std::string_view suffix = heading.substr(quantity.size());
  return suffix.empty() || (suffix[0] == '_' && suffix.size() > 1 && find_unit(suffix.substr(1)));
}

double column_factor(std::string_view heading, std::string_view quantity, Dimension dimension) {
  const std::string_view suffix = heading.substr(quantity.size());
  const auto unit = find_unit(suffix.empty() ? suffix : suffix.substr(1));
  if (unit && unit->dimension == dimension)
    return unit->factor;
  const std::string said = "column '" + std::string(heading) + "'";
  if (dimension == Dimension::dimensionless)
    throw InvalidArgument(said + " must be a pure number, without unit");
  throw InvalidArgument(said + (suffix.empty() ? " has no unit" : " has the unit of something else") +
                        "; name it " + choices(dimension, std::string(quantity) + "_"));
}

std::string pretty(double value, Dimension dimension) {
  if (dimension == Dimension::dimensionless)
    return short_text(value);
  if (dimension == Dimension::angle)
    return short_text(value / degree) + " deg";
  std::vector<Unit> steps = units_of(dimension);
  std::erase_if(steps, [](const Unit& unit) {
    return unit.symbol == "cm" || unit.symbol == "km/s" || unit.symbol.starts_with("g/");
  });
  std::sort(steps.begin(), steps.end(), [](const Unit& a, const Unit& b) { return a.factor < b.factor; });
  // the largest unit in which the rounded value is not below 1, so that 999.96 kPa becomes 1 MPa
  Unit best = *find_unit(si_symbol(dimension));
  const double rounded = std::abs(parse_number(short_text(value)).value_or(0));
  if (rounded > 0) {
    best = steps.front();
    for (const Unit& unit : steps)
      if (rounded >= unit.factor && unit.factor > best.factor)
        best = unit;
  }
  return short_text(value / best.factor) + " " + std::string(best.symbol);
}

} // namespace granum

// SPDX-License-Identifier: GPL-3.0-or-later
#include <granum/core/units.hpp>

#include <algorithm>
#include <cctype>
#include <cmath>
#include <iterator>
#include <numbers>
#include <utility>
#include <vector>

#include <granum/core/error.hpp>
#include <granum/core/text.hpp>

namespace granum {

namespace {

constexpr double degree = std::numbers::pi / 180;

constexpr double foot = 0.3048, inch = 0.0254, pound = 0.45359237;
constexpr double pound_force = pound * standard_gravity;

/// A row of the table of units.
struct Row {
  Unit unit;
  bool offered = true; ///< hints and tables use it
};
constexpr bool understood = false; ///< read as well, but not offered

/// Every unit. The first of a dimension is SI, or empty for a pure number; those that hints and tables use
/// come in order of size.
constexpr Row rows[] = {
    {{"", Dimension::dimensionless, 1}},
    {{"%", Dimension::dimensionless, 1e-2}},
    {{"percent", Dimension::dimensionless, 1e-2}, understood},
    {{"Pa", Dimension::pressure, 1}},
    {{"kPa", Dimension::pressure, 1e3}},
    {{"MPa", Dimension::pressure, 1e6}},
    {{"GPa", Dimension::pressure, 1e9}},
    {{"hPa", Dimension::pressure, 1e2}, understood},
    {{"N/m2", Dimension::pressure, 1}, understood},
    {{"kN/m2", Dimension::pressure, 1e3}, understood},
    {{"MN/m2", Dimension::pressure, 1e6}, understood},
    {{"N/mm2", Dimension::pressure, 1e6}, understood},
    {{"kN/mm2", Dimension::pressure, 1e9}, understood},
    {{"mbar", Dimension::pressure, 1e2}, understood},
    {{"bar", Dimension::pressure, 1e5}, understood},
    {{"kbar", Dimension::pressure, 1e8}, understood},
    {{"kgf/cm2", Dimension::pressure, standard_gravity * 1e4}, understood},
    {{"kg/cm2", Dimension::pressure, standard_gravity * 1e4}, understood},
    {{"tf/m2", Dimension::pressure, standard_gravity * 1e3}, understood},
    {{"t/m2", Dimension::pressure, standard_gravity * 1e3}, understood},
    {{"psf", Dimension::pressure, pound_force / (foot * foot)}, understood},
    {{"ksf", Dimension::pressure, 1e3 * pound_force / (foot * foot)}, understood},
    {{"tsf", Dimension::pressure, 2e3 * pound_force / (foot * foot)}, understood}, // short tons
    {{"psi", Dimension::pressure, pound_force / (inch * inch)}, understood},
    {{"ksi", Dimension::pressure, 1e3 * pound_force / (inch * inch)}, understood},
    {{"m", Dimension::length, 1}},
    {{"nm", Dimension::length, 1e-9}},
    {{"um", Dimension::length, 1e-6}},
    {{"mm", Dimension::length, 1e-3}},
    {{"cm", Dimension::length, 1e-2}},
    {{"\u00b5m", Dimension::length, 1e-6}, understood}, // micro sign
    {{"\u03bcm", Dimension::length, 1e-6}, understood}, // Greek mu
    {{"in", Dimension::length, inch}, understood},
    {{"ft", Dimension::length, foot}, understood},
    {{"rad", Dimension::angle, 1}},
    {{"deg", Dimension::angle, degree}},
    {{"\u00b0", Dimension::angle, degree}, understood},
    {{"kg/m3", Dimension::density, 1}},
    {{"g/cm3", Dimension::density, 1e3}},
    {{"t/m3", Dimension::density, 1e3}},
    {{"Mg/m3", Dimension::density, 1e3}, understood},
    {{"g/cc", Dimension::density, 1e3}, understood},
    {{"g/ml", Dimension::density, 1e3}, understood},
    {{"lb/ft3", Dimension::density, pound / (foot * foot * foot)}, understood},
    {{"pcf", Dimension::density, pound / (foot * foot * foot)}, understood},
    {{"N/m3", Dimension::unit_weight, 1}},
    {{"kN/m3", Dimension::unit_weight, 1e3}},
    {{"MN/m3", Dimension::unit_weight, 1e6}, understood},
    {{"lbf/ft3", Dimension::unit_weight, pound_force / (foot * foot * foot)}, understood},
    {{"s", Dimension::time, 1}},
    {{"ns", Dimension::time, 1e-9}},
    {{"us", Dimension::time, 1e-6}},
    {{"ms", Dimension::time, 1e-3}},
    {{"\u00b5s", Dimension::time, 1e-6}, understood},
    {{"N", Dimension::force, 1}},
    {{"nN", Dimension::force, 1e-9}},
    {{"uN", Dimension::force, 1e-6}},
    {{"mN", Dimension::force, 1e-3}},
    {{"kN", Dimension::force, 1e3}},
    {{"MN", Dimension::force, 1e6}},
    {{"lbf", Dimension::force, pound_force}, understood},
    {{"m/s", Dimension::speed, 1}},
    {{"km/s", Dimension::speed, 1e3}},
    {{"mm/s", Dimension::speed, 1e-3}, understood},
    {{"cm/s", Dimension::speed, 1e-2}, understood},
    {{"ft/s", Dimension::speed, foot}, understood},
};

/// The units of a dimension that are offered.
std::vector<Unit> units_of(Dimension dimension) {
  std::vector<Unit> found;
  for (const Row& row : rows)
    if (row.offered && row.unit.dimension == dimension)
      found.push_back(row.unit);
  return found;
}

/// "100Pa, 100kPa, 100MPa, 100GPa"
std::string choices(Dimension dimension, std::string_view number) {
  std::string text;
  for (const Unit& unit : units_of(dimension))
    if (!unit.symbol.empty())
      text += (text.empty() ? "" : ", ") + std::string(number) + std::string(unit.symbol);
  return text;
}

/// All units of a dimension that are read, in ASCII: "Pa, kPa, ..., ksi".
std::string all_symbols(Dimension dimension) {
  std::string text;
  for (const Row& row : rows)
    if (const std::string_view symbol = row.unit.symbol;
        row.unit.dimension == dimension && !symbol.empty() && static_cast<unsigned char>(symbol[0]) < 0x80)
      text += (text.empty() ? "" : ", ") + std::string(symbol);
  return text;
}

bool same_but_for_case(std::string_view a, std::string_view b) {
  const auto lower = [](char c) { return std::tolower(static_cast<unsigned char>(c)); };
  return std::equal(a.begin(), a.end(), b.begin(), b.end(),
                    [&](char x, char y) { return lower(x) == lower(y); });
}

/// "m^3" and "m\u00b3" as "m3".
std::string plain_powers(std::string_view symbol) {
  std::string plain(symbol);
  for (const auto& [written, meant] :
       {std::pair("^", ""), std::pair("\u00b2", "2"), std::pair("\u00b3", "3")})
    for (std::size_t at = plain.find(written); at != std::string::npos; at = plain.find(written))
      plain.replace(at, std::string_view(written).size(), meant);
  return plain;
}

/// The unit that is meant by a symbol of wrong case, if that is clear, or merely likely.
std::optional<Unit> unit_but_for_case(std::string_view symbol, bool likely) {
  std::optional<Unit> found;
  for (const Row& row : rows) {
    const std::string_view right = row.unit.symbol;
    if (right.empty() || !same_but_for_case(right, symbol))
      continue;
    const bool other_prefix = (right[0] == 'm' || right[0] == 'M') && right.substr(1) == symbol.substr(1);
    if (found || (other_prefix && !likely))
      return std::nullopt;
    found = row.unit;
  }
  return found;
}

std::string near_symbol(std::string_view symbol, Dimension dimension) {
  const auto near = unit_but_for_case(symbol, true);
  if (near && near->dimension == dimension)
    return "did you mean " + std::string(near->symbol) + "?";
  return "known for " + std::string(description(dimension)) + ": " + all_symbols(dimension);
}

/// Possible meanings of a number with a comma: "0.6" for "0,6", "1.500kPa or 1500kPa" for "1,500kPa".
std::string without_comma(std::string_view text) {
  std::string decimal(text), thousands(text);
  std::replace(decimal.begin(), decimal.end(), ',', '.');
  std::erase(thousands, ',');
  const std::string_view behind = text.substr(text.find(',') + 1);
  if (behind.find(',') != std::string_view::npos)
    return thousands;
  const std::size_t digits = std::min(behind.find_first_not_of("0123456789"), behind.size());
  return digits == 3 ? decimal + " or " + thousands : decimal;
}

/// "0.6,0.7", "50kPa,100kPa", "10kPa..1MPa": a list or a range, and no number with a comma in it.
bool has_several_values(std::string_view text) {
  if (text.find("..") != std::string_view::npos || text.find(';') != std::string_view::npos)
    return true;
  const std::size_t comma = text.find(',');
  if (comma == std::string_view::npos)
    return false;
  const auto first = leading_number(text.substr(0, comma));
  const auto second = leading_number(trimmed(text.substr(comma + 1)));
  const bool fraction = text.substr(0, comma).find('.') != std::string_view::npos;
  return first && second && (fraction || !first->rest.empty() || text[comma + 1] == ' ');
}

bool has_decimal_comma(std::string_view rest) {
  return rest.size() > 1 && rest[0] == ',' && std::isdigit(static_cast<unsigned char>(rest[1]));
}

/// Factor that converts a value of one dimension to another; empty if impossible.
std::optional<double> factor_between(Dimension from, Dimension to) {
  if (from == to)
    return 1;
  if (from == Dimension::density && to == Dimension::unit_weight)
    return standard_gravity;
  if (from == Dimension::unit_weight && to == Dimension::density)
    return 1 / standard_gravity;
  return std::nullopt;
}

/// Whether a quantity is a word, such as void_ratio, and no symbol, in which case matters.
bool is_word(std::string_view quantity) {
  constexpr std::size_t shortest = 5;
  return quantity.size() >= shortest &&
         quantity.find_first_not_of("abcdefghijklmnopqrstuvwxyz_") == std::string_view::npos;
}

/// Whether a character may be that of a word: in any case, and with a blank or - for _.
bool is_letter_of_word(char character, char letter) {
  return std::tolower(static_cast<unsigned char>(character)) == letter ||
         (letter == '_' && (character == ' ' || character == '-'));
}

/// What a heading has behind the quantity; empty if it begins otherwise. A prime is an apostrophe, the Greek
/// letter is its name, and words are spelt as people do.
std::optional<std::string_view> behind(std::string_view heading, std::string_view quantity) {
  constexpr std::pair<std::string_view, std::string_view> same[] = {
      {"\u2032", "'"}, {"\u2019", "'"}, {"\u03c3", "sigma"}};
  const bool word = is_word(quantity);
  while (!quantity.empty()) {
    const auto* const sign = std::find_if(std::begin(same), std::end(same), [&](const auto& pair) {
      return heading.starts_with(pair.first) && quantity.starts_with(pair.second);
    });
    const bool found = sign != std::end(same);
    const bool letter = !found && !heading.empty() &&
                        (heading[0] == quantity[0] || (word && is_letter_of_word(heading[0], quantity[0])));
    if (!found && !letter)
      return std::nullopt;
    heading.remove_prefix(found ? sign->first.size() : 1);
    quantity.remove_prefix(found ? sign->second.size() : 1);
  }
  return heading;
}

/// The unit that the heading of a column names behind the quantity, "" for none; empty if the heading is
/// that of something else.
std::optional<std::string_view> symbol_in_heading(std::string_view heading, std::string_view quantity) {
  const std::optional<std::string_view> rest = behind(heading, quantity);
  if (!rest)
    return std::nullopt;
  std::string_view suffix = *rest;
  if (trimmed(suffix).empty())
    return "";
  const bool joined = suffix[0] == '_';
  const bool apart = suffix[0] == ' ';
  suffix = trimmed(joined ? suffix.substr(1) : suffix);
  const bool bracketed = suffix.size() > 2 && ((suffix.front() == '(' && suffix.back() == ')') ||
                                               (suffix.front() == '[' && suffix.back() == ']'));
  if (bracketed)
    suffix = trimmed(suffix.substr(1, suffix.size() - 2));
  if (bracketed && suffix == "-")
    return "";
  const bool unit = (joined || apart || bracketed) && !suffix.empty() && find_unit(suffix);
  return unit ? std::optional(suffix) : std::nullopt;
}

} // namespace

std::optional<Unit> find_unit(std::string_view symbol) {
  const std::string plain = plain_powers(symbol);
  for (const Row& row : rows)
    if (row.unit.symbol == plain)
      return row.unit;
  return unit_but_for_case(plain, false);
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
  case Dimension::unit_weight:
    return "a unit weight";
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
  if (has_several_values(content))
    throw InvalidArgument(said + " contains several values; one is expected");
  if (has_decimal_comma(symbol))
    throw InvalidArgument(said + " has a comma in its number: write " + without_comma(content));
  const auto unit = find_unit(symbol);
  if (!unit)
    throw InvalidArgument(said + " has the unknown unit '" + std::string(symbol) + "'; " +
                          near_symbol(symbol, dimension));
  if (symbol.empty() && dimension != Dimension::dimensionless)
    throw InvalidArgument(std::string(name) + " = " + std::string(content) + " has no unit; write " +
                          choices(dimension, content));
  const auto factor = factor_between(unit->dimension, dimension);
  if (!factor)
    throw InvalidArgument(said + " must be " + std::string(description(dimension)) + ", not " +
                          std::string(description(unit->dimension)));
  const double value = *factor * unit->factor * number->value;
  if (!std::isfinite(value))
    throw InvalidArgument(said + " is too large");
  return value;
}

bool is_column_of(std::string_view heading, std::string_view quantity) {
  return symbol_in_heading(heading, quantity).has_value();
}

double column_factor(std::string_view heading, std::string_view quantity, Dimension dimension) {
  const std::string_view symbol = symbol_in_heading(heading, quantity).value_or("");
  const auto unit = find_unit(symbol);
  const auto factor = unit ? factor_between(unit->dimension, dimension) : std::nullopt;
  if (factor)
    return *factor * unit->factor;
  const std::string said = "column '" + std::string(heading) + "'";
  if (dimension == Dimension::dimensionless)
    throw InvalidArgument(said + " must be a pure number, without unit");
  throw InvalidArgument(said + (symbol.empty() ? " has no unit" : " has the unit of something else") +
                        "; name it " + choices(dimension, std::string(quantity) + "_"));
}

std::string pretty(double value, Dimension dimension) {
  if (dimension == Dimension::dimensionless)
    return short_text(value);
  if (dimension == Dimension::angle)
    return short_text(value / degree) + " deg";
  std::vector<Unit> steps = units_of(dimension);
  std::erase_if(steps, [](const Unit& unit) {
    return unit.symbol == "cm" || unit.symbol == "km/s" || unit.symbol == "g/cm3" || unit.symbol == "t/m3";
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

// SPDX-License-Identifier: GPL-3.0-or-later
#include "input_columns.hpp"

#include <algorithm>
#include <cctype>
#include <cmath>
#include <limits>

#include <fmt/format.h>
#include <granum/core/error.hpp>
#include <granum/core/text.hpp>
#include <granum/core/units.hpp>

#include "cli/frame/messages.hpp"

namespace granum::cli {

namespace {

using estimate::Belongs;
using estimate::Input;
using estimate::InputRow;
using estimate::InputValues;

/// "--void-ratio" as void_ratio.
std::string heading_of(const std::string& option) {
  std::string name = option.substr(2);
  std::replace(name.begin(), name.end(), '-', '_');
  return name;
}

/// Other headings that people have, the most telling first: read only where no column has a symbol or the
/// name of the input.
struct OtherHeadings {
  Input input;
  std::string_view names;
};
constexpr OtherHeadings other_headings[] = {
    {Input::void_ratio, "e_c ec e_0 e0"},
    {Input::pressure, "mean_effective_stress effective_mean_stress mean_stress effective_confining_pressure "
                      "effective_confining_stress confining_pressure confining_stress sigma_c sigma'_c "
                      "sigma_c' sigma'c sigma_0 "
                      "sigma'_0 sigma_0' sigma'0 sigma_m sigma'_m sigma_m' sigma'm p_0 p'_0 p_0' p0 p0'"},
    {Input::stress_v, "vertical_effective_stress effective_vertical_stress vertical_stress sigma_1 sigma'_1 "
                      "sigma_1' sigma1 sigma'1 sigma1' sigma_a sigma'_a sigma_a' sigma_z"},
    {Input::stress_h, "horizontal_effective_stress effective_horizontal_stress horizontal_stress sigma_3 "
                      "sigma'_3 sigma_3' sigma3 "
                      "sigma'3 sigma3' sigma_r sigma'_r sigma_r' sigma_x"},
    {Input::relative_density, "density_index"},
    {Input::least_void_ratio, "minimum_void_ratio"},
    {Input::largest_void_ratio, "maximum_void_ratio"},
    {Input::uniformity, "uniformity_coefficient coefficient_of_uniformity"},
    {Input::d50, "d_50 D50 D_50 mean_grain_size median_grain_size"},
    {Input::grain_density, "particle_density density_of_grains"},
    {Input::saturation, "degree_of_saturation"},
};

std::string_view other_headings_of(Input input) {
  const auto* const found = std::ranges::find(other_headings, input, &OtherHeadings::input);
  return found == std::end(other_headings) ? std::string_view() : found->names;
}

/// Whether a unit in the heading of a quantity is of another dimension: gamma is a strain and a unit weight.
bool is_of_other_dimension(const std::string& heading, std::string_view quantity, Dimension dimension) {
  try {
    return !(column_factor(heading, quantity, dimension) > 0);
  } catch (const InvalidArgument&) {
    return true;
  }
}
constexpr std::string_view shared_symbol = "gamma";

void refuse_twice(bool option_given, const std::string& option, const std::string& heading) {
  if (option_given)
    throw InvalidArgument(fmt::format("{} is given as an option and by the column '{}'", option, heading));
}

} // namespace

void refuse_suction(const io::CsvTable& table) {
  constexpr std::string_view reason = "suction is not modelled: the laws are of dry and of saturated sand, "
                                      "and suction stiffens moist sand; give "
                                      "the effective stress, with a pore pressure of 0 or more";
  const auto& headings = table.headings();
  for (std::size_t k = 0; k < headings.size(); ++k) {
    const auto is = [&](std::string_view words) {
      return std::ranges::any_of(words_of(words),
                                 [&](const std::string& word) { return is_column_of(headings[k], word); });
    };
    const bool suction = is("suction matric_suction matrix_suction"),
               pore = is("pore_pressure pore_water_pressure");
    for (std::size_t row = 0; (suction || pore) && row < table.row_count(); ++row)
      if (const auto value = parse_number(trimmed(table.fields(row)[k]));
          value && (suction ? *value != 0 : *value < 0))
        throw FileError(table.name(), table.line(row),
                        fmt::format("column '{}' has {}: {}", headings[k], table.fields(row)[k], reason));
  }
}

std::vector<std::string> names_of_column(std::string_view symbols, const std::string& option) {
  std::vector<std::string> names = words_of(symbols);
  if (std::find(names.begin(), names.end(), option) == names.end())
    names.push_back(option);
  return names;
}

std::vector<std::string> names_of_column(Input input) {
  const InputRow& row = estimate::row_of(input);
  std::vector<std::string> names = names_of_column(row.symbols, row.key);
  std::ranges::move(words_of(other_headings_of(input)), std::back_inserter(names));
  return names;
}

InputColumns::InputColumns(const io::CsvTable& table, const InputValues& options)
    : table_(table), given_(options), read_(table.headings().size(), false),
      options_(table.headings().size()) {
  refuse_suction(table);
}

std::optional<io::CsvTable::Place> InputColumns::find(std::string_view symbols, const std::string& name,
                                                      Dimension dimension) const {
  const auto& headings = table_.headings();
  std::optional<io::CsvTable::Place> found;
  for (const std::string& one : names_of_column(symbols, name)) {
    if (!table_.has(one) ||
        (one == shared_symbol && std::ranges::any_of(headings, [&](const std::string& heading) {
           return is_column_of(heading, one) && is_of_other_dimension(heading, one, dimension);
         })))
      continue;
    const io::CsvTable::Place column = table_.column(one, dimension);
    if (found && found->index != column.index)
      throw FileError(table_.name(), table_.heading_line(),
                      fmt::format("columns {} and {}, '{}' and '{}', both contain {}", found->index + 1,
                                  column.index + 1, headings[found->index], headings[column.index], name));
    found = column;
  }
  return found;
}

bool InputColumns::bind_number(Number* number, Input input, std::string_view symbols,
                               const std::string& option, Dimension dimension, bool option_given,
                               double by_default) {
  std::optional<io::CsvTable::Place> place = find(symbols, heading_of(option), dimension);
  if (number == nullptr)
    for (const std::string& other : words_of(other_headings_of(input)))
      if (!place && table_.has(other))
        place = table_.column(other, dimension);
  if (!place)
    return false;
  refuse_twice(option_given, option, table_.headings()[place->index]);
  numbers_.push_back(
      {number, input, *place, dimension == Dimension::dimensionless && place->factor != 1, by_default});
  read(place->index, option);
  const std::string& heading = table_.headings()[place->index];
  if (number == nullptr && input == Input::shear_strain && heading.find_first_of("([") == std::string::npos &&
      place->factor == 1)
    remarks_.push_back(
        fmt::format("column '{}' has no unit: 0.0001 is 0.01 %; name it strain_% for per cent", heading));
  return true;
}

bool InputColumns::bind(Number& number) {
  return bind_number(&number, {}, number.symbols, number.name, number.dimension, number.given(),
                     number.value);
}

bool InputColumns::bind(Input input) {
  const InputRow& row = estimate::row_of(input);
  if (row.kind != estimate::Kind::number)
    return bind_text(row);
  const bool sizes_given = input == Input::uniformity && given_.sizes;
  return bind_number(nullptr, input, row.symbols, row.option(), row.dimension,
                     given_.given(input) || sizes_given, 0);
}

bool InputColumns::bind_text(const InputRow& row) {
  const auto& headings = table_.headings();
  const auto found = std::find_if(headings.begin(), headings.end(),
                                  [&](const std::string& one) { return same_word(one, row.key); });
  if (found == headings.end())
    return false;
  refuse_twice(given_.given(row.input) || (row.input == Input::sizes && given_.sizes), row.option(), *found);
  const auto index = static_cast<std::size_t>(found - headings.begin());
  texts_.push_back({row.input, index});
  read(index, row.option());
  return true;
}

void InputColumns::bind_packing() {
  for (const InputRow& row : estimate::inputs())
    if (row.belongs == Belongs::to_packing && row.input != Input::sieve) // which is a file
      bind(row.input);
  take_alone_as_mean();
}

void InputColumns::take_alone_as_mean() {
  const auto column_of = [this](Input input) {
    return std::ranges::find_if(
        numbers_, [input](const NumberColumn& of) { return of.number == nullptr && of.input == input; });
  };
  const auto horizontal = column_of(Input::stress_h);
  if (horizontal == numbers_.end())
    return;
  const std::string& heading = table_.headings()[horizontal->place.index];
  const bool cell_stress =
      std::ranges::any_of(words_of("sigma_3 sigma'_3 sigma_3' sigma3 sigma'3 sigma3'"),
                          [&](const std::string& name) { return is_column_of(heading, name); });
  const bool alone = column_of(Input::stress_v) == numbers_.end() &&
                     column_of(Input::pressure) == numbers_.end() && !given_.given(Input::stress_v) &&
                     !given_.given(Input::pressure);
  if (!cell_stress || !alone)
    return;
  horizontal->input = Input::pressure;
  options_[horizontal->place.index] = estimate::row_of(Input::pressure).option();
  remarks_.push_back(
      fmt::format("column '{}' is the stress of a cell, alone: taken as the mean stress", heading));
}

void InputColumns::bind_material() {
  for (const InputRow& row : estimate::inputs())
    if (row.belongs == Belongs::to_answer && row.input != Input::preparation)
      bind(row.input);
}

bool InputColumns::gives_stress() const {
  const auto gives = [&](Input input) {
    return given_.given(input) || std::any_of(numbers_.begin(), numbers_.end(), [&](const NumberColumn& of) {
             return of.number == nullptr && of.input == input;
           });
  };
  return gives(Input::pressure) || gives(Input::stress_v) || gives(Input::stress_h);
}

InputColumns::Field InputColumns::field(const NumberColumn& column, std::size_t row) const {
  const std::string& field = table_.fields(row)[column.place.index];
  std::string text(trimmed(field));
  if (text.empty())
    return {};
  double share = 1;
  const Dimension dimension =
      column.number != nullptr ? column.number->dimension : estimate::row_of(column.input).dimension;
  if (dimension == Dimension::dimensionless && text.ends_with('%')) {
    text.pop_back();
    share = column.per_cent ? 1 : 0.01; // the sign in the cell repeats that of the heading
  }
  const auto value = parse_number(trimmed(text));
  const double number =
      value ? *value * share * column.place.factor : std::numeric_limits<double>::infinity();
  if (!std::isfinite(number))
    throw InvalidArgument(fmt::format("expected a finite number in column '{}', found '{}'",
                                      table_.headings()[column.place.index], field));
  return {number, true};
}

InputValues InputColumns::row(std::size_t row) const {
  InputValues values = given_;
  for (const NumberColumn& column : numbers_) {
    const Field cell = field(column, row);
    if (column.number != nullptr) {
      column.number->in_table = cell.given;
      column.number->value = cell.given ? cell.number : column.by_default;
      column.number->per_cent = column.per_cent;
    } else if (cell.given)
      values.give(column.input, cell.number, estimate::Source::table, column.per_cent);
  }
  for (const TextColumn& column : texts_)
    if (const std::string text(trimmed(table_.fields(row)[column.index])); !text.empty()) {
      if (column.input == Input::sizes && values.sizes)
        throw InvalidArgument("sizes and uniformity are alternatives: give one of them");
      values.give(column.input, text, estimate::Source::table);
    }
  return values;
}

void InputColumns::read(std::size_t column, const std::string& option) {
  read_[column] = true;
  options_[column] = option;
}

std::optional<std::string> InputColumns::heading(std::string_view option) const {
  const auto found = std::find(options_.begin(), options_.end(), option);
  if (found == options_.end())
    return std::nullopt;
  return table_.headings()[static_cast<std::size_t>(found - options_.begin())];
}

std::vector<std::string> InputColumns::unread() const {
  std::vector<std::string> headings;
  for (std::size_t k = 0; k < read_.size(); ++k)
    if (!read_[k])
      headings.push_back(table_.headings()[k]);
  return headings;
}

std::vector<std::string> InputColumns::remarks() const {
  std::vector<std::string> all = remarks_;
  if (const std::vector<std::string> headings = unread(); !headings.empty())
    all.push_back(fmt::format("unused columns: {}", fmt::join(headings, ", ")));
  return all;
}

void name_remarks(estimate::Notes& to, const std::vector<std::string>& remarks) {
  for (const std::string& remark : remarks) {
    add_sentence(to, remark);
    say("note", remark);
  }
}

} // namespace granum::cli

// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <iterator>
#include <optional>

#include <fmt/core.h>
#include <granum/core/error.hpp>
#include <granum/core/text.hpp>
#include <granum/elastic/waves.hpp>
#include <granum/io/csv/table.hpp>

#include "cli/options/input_columns.hpp"
#include "fit.hpp"

namespace granum::cli {

namespace {

using estimate::Input;
using Names = std::vector<std::string>;

/// The names of a list, and others that only fit reads.
Names with(Names names, std::string_view others) {
  std::ranges::move(words_of(others), std::back_inserter(names));
  return names;
}

/// Usual names of columns; the first is used in errors.
struct KnownNames {
  Names modulus = with(with({}, column_names::shear_modulus),
                       std::string(column_names::shear_modulus_hh) + " G_answer"); // of granum sweep
  Names speed = with(with({}, column_names::shear_wave_speed), column_names::shear_wave_speed_hh);
  Names density = with({}, "rho rho_b bulk_density density unit_weight gamma");
  Names grain_density = names_of_column(Input::grain_density);
  Names saturation = names_of_column(Input::saturation);
  Names vertical = names_of_column(Input::stress_v);
  Names horizontal = names_of_column(Input::stress_h);
  Names mean = with(names_of_column(Input::pressure),
                    "sigma_3 sigma'_3 sigma_3' sigma3 sigma'3 sigma3' sigma sigma' stress");
  Names void_ratio = names_of_column(Input::void_ratio);
  Names porosity = names_of_column("", "porosity");
};

const KnownNames& known_names() {
  static const KnownNames names;
  return names;
}

/// The first of the names with a column in the table; empty if none.
std::string found_in(const io::CsvTable& table, const Names& names) {
  for (const std::string& name : names)
    if (table.has(name))
      return name;
  return {};
}

bool has_unit(const std::string& heading, const std::string& quantity, Dimension dimension) {
  try {
    return is_column_of(heading, quantity) && column_factor(heading, quantity, dimension) > 0;
  } catch (const InvalidArgument&) {
    return false;
  }
}

/// The quantity named by the user, possibly as the whole heading, "G_MPa" or "G (MPa)".
std::string quantity_of(const io::CsvTable& table, const std::string& given, Dimension dimension) {
  const auto& headings = table.headings();
  if (std::find(headings.begin(), headings.end(), given) == headings.end())
    return given;
  for (std::size_t end = given.size() - 1; end > 0; --end) {
    const std::string begin(trimmed(given.substr(0, end)));
    if (has_unit(given, begin, dimension))
      return begin;
  }
  return given;
}

/// The direction, 'v' or 'h', of the stress i (place 0) or j (place 1): of G_hh and G_vv that in the name; of
/// G, G_hv and G_vh i is horizontal and j vertical, as everywhere in granum.
char direction_of(const std::string& modulus, std::size_t place) {
  const char last = modulus.back();
  const bool of_one_direction = modulus.ends_with("hh") || modulus.ends_with("vv");
  return of_one_direction ? last : "hv"[place];
}

/// Takes the speed where a table has no modulus, or where the column that is named is one.
void find_speed(const io::CsvTable& table, FitQuestion& question) {
  if (question.modulus_column.empty() && found_in(table, known_names().modulus).empty())
    question.modulus_column = found_in(table, known_names().speed);
  const std::string named = quantity_of(table, question.modulus_column, Dimension::speed);
  question.by_speed = std::ranges::any_of(table.headings(), [&](const std::string& heading) {
    return !named.empty() && has_unit(heading, named, Dimension::speed);
  });
  if (question.by_speed)
    question.modulus_column = named;
}

void fill_in_columns(const io::CsvTable& table, FitQuestion& question) {
  question.void_ratio_column_given = !question.void_ratio_column.empty();
  find_speed(table, question);
  for (std::string* column : {&question.modulus_column, &question.stress_i_column, &question.stress_j_column})
    *column = quantity_of(table, *column, Dimension::pressure);
  question.void_ratio_column = quantity_of(table, question.void_ratio_column, Dimension::dimensionless);
  const auto fill = [&](std::string& column, const Names& names) {
    if (column.empty())
      column = found_in(table, names);
    if (column.empty())
      column = names.front();
  };
  const KnownNames& known = known_names();
  fill(question.modulus_column, known.modulus);
  if (!question.void_ratio_column_given && found_in(table, known.void_ratio).empty())
    question.void_ratio_column = found_in(table, known.porosity);
  question.by_porosity = !question.void_ratio_column_given && !question.void_ratio_column.empty();
  fill(question.void_ratio_column, known.void_ratio);
  const bool no_stress_named = question.stress_i_column.empty() && question.stress_j_column.empty();
  const bool no_pair = found_in(table, known.vertical).empty() || found_in(table, known.horizontal).empty();
  if (const std::string mean = found_in(table, known.mean); no_stress_named && no_pair && !mean.empty()) {
    question.stress_i_column = question.stress_j_column = mean;
    question.sum_only = true;
  }
  const auto names_of = [&](char direction) { return direction == 'v' ? known.vertical : known.horizontal; };
  fill(question.stress_i_column, names_of(direction_of(question.modulus_column, 0)));
  fill(question.stress_j_column, names_of(direction_of(question.modulus_column, 1)));
}

/// Numbers of a column; empty for an empty cell.
std::vector<std::optional<double>> numbers_in(const io::CsvTable& table, const std::string& quantity,
                                              Dimension dimension) {
  const io::CsvTable::Place column = table.column(quantity, dimension);
  std::vector<std::optional<double>> out;
  for (std::size_t row = 0; row < table.row_count(); ++row) {
    const std::string_view field = trimmed(table.fields(row)[column.index]);
    const std::optional<double> value = parse_number(field);
    if (!value && !field.empty())
      throw FileError(
          table.name(), table.line(row),
          fmt::format("expected a number in column '{}', found '{}'", table.headings()[column.index], field));
    out.push_back(value ? std::optional(*value * column.factor) : std::nullopt);
  }
  return out;
}

double void_ratio_of_porosity(const io::CsvTable& table, std::size_t row, double porosity) {
  if (!(porosity > 0 && porosity < 1))
    throw FileError(table.name(), table.line(row),
                    fmt::format("porosity {} is outside (0, 1); write per cent as 38%, or in the heading",
                                short_text(porosity)));
  return porosity / (1 - porosity);
}

/// 1 in every row if the table has no void ratio: f(e) = 1.
std::vector<std::optional<double>> void_ratios(const io::CsvTable& table, FitQuestion& question) {
  if (table.has(question.void_ratio_column)) {
    auto numbers = numbers_in(table, question.void_ratio_column, Dimension::dimensionless);
    if (question.by_porosity)
      for (std::size_t row = 0; row < numbers.size(); ++row)
        if (std::optional<double>& number = numbers[row])
          *number = void_ratio_of_porosity(table, row, *number);
    return numbers;
  }
  const bool none = question.void_ratio_function == "none";
  if (!none && (question.void_ratio_function_given || question.void_ratio_column_given))
    throw FileError(
        question.file, 0,
        fmt::format("expected a column '{}' of the void ratio; name another with --void-ratio-column, or "
                    "use --void-ratio-function none",
                    question.void_ratio_column));
  if (!none)
    question.remarks.add(
        "the table has no void ratio: f(e) = 1 is used, valid for one specimen that hardly compacts");
  question.void_ratio_function = "none";
  return std::vector<std::optional<double>>(table.row_count(), 1.0);
}

/// Densities of all rows [kg/m3], from the columns that there are; void ratios as in void_ratios.
class Densities {
 public:
  Densities(const io::CsvTable& table, FitQuestion& question,
            const std::vector<std::optional<double>>& void_ratio)
      : table_(table), void_ratio_(void_ratio) {
    const KnownNames& known = known_names();
    const auto numbers = [&](const Names& names, Dimension dimension) {
      const std::string name = found_in(table, names);
      return name.empty() ? Numbers() : numbers_in(table, name, dimension);
    };
    whole_ = numbers(known.density, Dimension::density);
    if (!whole_.empty())
      return;
    if (!table.has(question.void_ratio_column))
      throw FileError(table.name(), table.heading_line(),
                      "has V_s, but no density: add a column of the void ratio, e, or rho_kg/m3");
    grains_ = numbers(known.grain_density, Dimension::density);
    saturation_ = numbers(known.saturation, Dimension::dimensionless);
    if (grains_.empty() || saturation_.empty())
      question.remarks.add(fmt::format(
          "G = rho V_s^2 with {}{}{}; columns rho_s_kg/m3 and S_r, or rho_kg/m3, say "
          "otherwise",
          grains_.empty() ? "grains of 2650 kg/m3" : "",
          grains_.empty() && saturation_.empty() ? " and " : "", saturation_.empty() ? "dry pores" : ""));
  }

  /// \throws   InvalidArgument for numbers out of range
  [[nodiscard]] std::optional<double> of_row(std::size_t row) const {
    if (!whole_.empty())
      return whole_[row];
    const std::optional<double> grains =
        grains_.empty() ? estimate::row_of(Input::grain_density).by_default : grains_[row];
    const std::optional<double> saturation = saturation_.empty() ? 0 : saturation_[row];
    if (!grains || !saturation || !void_ratio_[row])
      return std::nullopt;
    estimate::require_within(estimate::row_of(Input::grain_density), *grains, "rho_s");
    estimate::require_within(estimate::row_of(Input::saturation), *saturation, "S_r");
    return elastic::bulk_density({.grain_density = *grains,
                                  .void_ratio = *void_ratio_[row],
                                  .pore_density = *saturation * elastic::water_density});
  }

 private:
  using Numbers = std::vector<std::optional<double>>;
  const io::CsvTable& table_;
  const std::vector<std::optional<double>>& void_ratio_;
  Numbers whole_, grains_, saturation_;
};

/// The moduli of all rows [Pa]; of a column of V_s by the density.
std::vector<std::optional<double>> moduli(const io::CsvTable& table, FitQuestion& question,
                                          const std::vector<std::optional<double>>& void_ratio) {
  if (!question.by_speed)
    return numbers_in(table, question.modulus_column, Dimension::pressure);
  auto numbers = numbers_in(table, question.modulus_column, Dimension::speed);
  const Densities densities(table, question, void_ratio);
  for (std::size_t row = 0; row < numbers.size(); ++row)
    try {
      const std::optional<double> density = densities.of_row(row);
      numbers[row] = numbers[row] && density
                         ? std::optional(elastic::shear_modulus_from_speed(*numbers[row], *density))
                         : std::nullopt;
    } catch (const InvalidArgument& error) {
      throw FileError(table.name(), table.line(row), error.what());
    }
  return numbers;
}

/// A sand at 100 kPa has about 100 MPa; if all rows are a thousandth of that or less, units were confused.
void judge_modulus(const std::vector<hardin::MeasuredModulus>& rows, FitQuestion& question) {
  constexpr double softest = 2e6, hardest = 100e9, least_stress = 10e3; // [Pa]
  double largest = 0;
  for (const hardin::MeasuredModulus& row : rows)
    if (std::min(row.state.stress_i, row.state.stress_j) >= least_stress)
      largest = std::max(largest, row.shear_modulus);
  if (largest > 0 && largest < softest)
    question.remarks.add(fmt::format("{} of at most {}: no sand is so soft; did you mean {}?",
                                     modulus_name(question), pretty(largest, Dimension::pressure),
                                     pretty(1e3 * largest, Dimension::pressure)));
  else if (largest > hardest)
    question.remarks.add(fmt::format("{} of {}: no sand is so stiff; did you mean {}?",
                                     modulus_name(question), pretty(largest, Dimension::pressure),
                                     pretty(largest / 1e3, Dimension::pressure)));
}

} // namespace

std::string modulus_name(const FitQuestion& question) {
  return question.by_speed ? "rho " + question.modulus_column + "^2" : question.modulus_column;
}

std::vector<hardin::MeasuredModulus> read_rows(FitQuestion& question) {
  const io::CsvTable table = io::read_csv(question.file);
  refuse_suction(table);
  fill_in_columns(table, question);
  const auto stress_i = numbers_in(table, question.stress_i_column, Dimension::pressure);
  const auto stress_j = numbers_in(table, question.stress_j_column, Dimension::pressure);
  const auto void_ratio = void_ratios(table, question);
  const auto modulus = moduli(table, question, void_ratio);
  const hardin::VoidRatioFunction function = hardin::void_ratio_function(question.void_ratio_function);
  std::vector<hardin::MeasuredModulus> rows;
  std::size_t left_out = 0;
  for (std::size_t k = 0; k < table.row_count(); ++k) {
    if (!modulus[k] || !stress_i[k] || !stress_j[k] || !void_ratio[k]) {
      ++left_out;
      continue;
    }
    rows.push_back({*modulus[k], {*stress_i[k], *stress_j[k], *void_ratio[k]}});
    try {
      hardin::require_valid(rows.back(), function);
    } catch (const InvalidArgument& error) {
      throw FileError(question.file, table.line(k),
                      fmt::format("{} (stress_i is {}, stress_j is {})", error.what(),
                                  question.stress_i_column, question.stress_j_column));
    }
  }
  if (left_out > 0)
    question.remarks.add(
        fmt::format("{} of {} rows have an empty cell and are left out", left_out, table.row_count()));
  judge_modulus(rows, question);
  return rows;
}

} // namespace granum::cli

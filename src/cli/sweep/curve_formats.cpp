// SPDX-License-Identifier: GPL-3.0-or-later
// Curves of G/G0 and damping as files of programs for site response.
#include <fmt/format.h>
#include <granum/core/text.hpp>
#include <granum/core/version.hpp>

#include "curves.hpp"

namespace granum::cli {

namespace {

using nlohmann::ordered_json;

constexpr int curve_digits = 5;
constexpr double per_cent = 0.01, atmosphere = 101325, thousand = 1e3;

double to_curve_digits(double number) { return *parse_number(short_text(number, curve_digits)); }

/// A decimal number of TOML, which distinguishes 1.0 from the whole number 1.
std::string toml_number(double number) {
  std::string text = short_text(number, curve_digits);
  return text.find_first_of(".e") == std::string::npos ? text + ".0" : text;
}

template <class Of>
std::string toml_array(const StrainCurve& curve, Of of) {
  std::string text;
  for (const StrainPoint& point : curve.points)
    text += (text.empty() ? "" : ", ") + toml_number(of(point));
  return "[" + text + "]";
}

std::string toml_string(const std::string& text) {
  return json_text(ordered_json(text), -1); // the escapes of JSON are among those of TOML
}

template <class Of>
ordered_json array_of(const StrainCurve& curve, double unit, Of of) {
  ordered_json array = ordered_json::array();
  for (const StrainPoint& point : curve.points)
    array.push_back(to_curve_digits(of(point) / unit));
  return array;
}

double strain_of(const StrainPoint& point) { return point.strain; }
double ratio_of(const StrainPoint& point) { return point.ratio.value; }
double damping_of(const StrainPoint& point) { return point.damping.value; }

ordered_json strata_soil_type(const StrainCurve& curve, const std::string& notes) {
  enum Type { modulus_reduction, damping };
  const auto model = [&](Type type, const ordered_json& average) {
    return ordered_json{{"name", curve.name},
                        {"type", static_cast<int>(type)},
                        {"strain", array_of(curve, per_cent, strain_of)},
                        {"average", average}};
  };
  return {{"name", curve.name},
          {"notes", notes},
          {"untWt", to_curve_digits(curve.unit_weight / thousand)},
          {"damping", to_curve_digits(curve.points.front().damping.value / per_cent)},
          {"isVaried", false},
          {"saveData", false},
          {"meanStress", to_curve_digits(curve.mean_stress / atmosphere)},
          {"pi", 0},
          {"ocr", 1},
          {"freq", 1},
          {"nCycles", 10},
          {"modulusType", "CustomNonlinearProperty"},
          {"modulusModel", model(modulus_reduction, array_of(curve, 1, ratio_of))},
          {"dampingType", "CustomNonlinearProperty"},
          {"dampingModel", model(damping, array_of(curve, per_cent, damping_of))}};
}

/// A row of the table.
struct CurveRow {
  const StrainCurve* curve;
  StrainPoint at;
};

/// In CSV a to_curve_digits number in a unit of practice; in JSON a number in SI.
template <class Of>
void add_number(io::Columns<CurveRow>& to, const std::string& heading, const std::string& key, double unit,
                Of of) {
  to.emplace_back(heading, "", [of, unit](const CurveRow& row) { return to_curve_digits(of(row) / unit); });
  to.emplace_back("", key, of);
}

/// \param    heading, unit   "G_over_G0", ""; "damping", "_percent"
void add_range(io::Columns<CurveRow>& to, const std::string& heading, const std::string& unit,
               const std::string& key, double factor, estimate::Range StrainPoint::*range) {
  for (const auto& [name, member, part] :
       {std::tuple{"_low", "/low", &estimate::Range::low}, {"_high", "/high", &estimate::Range::high}})
    add_number(to, heading + name + unit, key + member, factor,
               [range, part = part](const CurveRow& row) { return row.at.*range.*part; });
}

std::vector<CurveRow> rows_of(const std::vector<StrainCurve>& curves) {
  std::vector<CurveRow> rows;
  for (const StrainCurve& curve : curves)
    for (const StrainPoint& point : curve.points)
      rows.push_back({&curve, point});
  return rows;
}

void add_state(io::Columns<CurveRow>& to, const StrainCurve& of) {
  to.emplace_back("curve", "curve", [](const CurveRow& row) { return row.curve->name; });
  if (of.depth)
    add_number(to, "depth_m", "depth", 1, [](const CurveRow& row) { return row.curve->depth.value_or(0); });
  if (of.line)
    to.emplace_back("line", "line", [](const CurveRow& row) { return row.curve->line.value_or(0); });
  add_number(to, "p_kPa", "mean_stress", thousand,
             [](const CurveRow& row) { return row.curve->mean_stress; });
  add_number(to, "V_s_m/s", "shear_wave_speed", 1,
             [](const CurveRow& row) { return row.curve->speed.value; });
  add_number(to, "unit_weight_kN/m3", "unit_weight", thousand,
             [](const CurveRow& row) { return row.curve->unit_weight; });
}

} // namespace

std::string pystrata_text(const std::vector<StrainCurve>& curves, const std::vector<std::string>& comments) {
  std::string text = fmt::format("# program: granum {} sweep\n", version());
  for (const std::string& comment : comments)
    text += "# " + comment + "\n";
  for (const StrainCurve& curve : curves) {
    const std::string strains = toml_array(curve, strain_of);
    text += fmt::format("\n[[models]]\nname = {}\n", toml_string(curve.name));
    text +=
        fmt::format("[models.mod_reduc]\nstrains = {}\nvalues = {}\n", strains, toml_array(curve, ratio_of));
    text +=
        fmt::format("[models.damping]\nstrains = {}\nvalues = {}\n", strains, toml_array(curve, damping_of));
  }
  return text;
}

std::string strata_text(const std::vector<StrainCurve>& curves, const std::vector<std::string>& comments,
                        bool alone) {
  const std::string notes = fmt::format("granum {}; {}", version(), fmt::join(comments, "; "));
  ordered_json all = ordered_json::array();
  for (const StrainCurve& curve : curves)
    all.push_back(strata_soil_type(curve, notes));
  return json_text(alone ? all.front() : all);
}

Table curve_table(const std::vector<StrainCurve>& curves, bool alone) {
  io::Columns<CurveRow> columns;
  if (!alone)
    add_state(columns, curves.front());
  add_number(columns, "strain_percent", "strain", per_cent,
             [](const CurveRow& row) { return row.at.strain; });
  add_number(columns, "G_over_G0", "modulus_ratio/value", 1,
             [](const CurveRow& row) { return ratio_of(row.at); });
  add_number(columns, "damping_percent", "damping_ratio/value", per_cent,
             [](const CurveRow& row) { return damping_of(row.at); });
  add_range(columns, "G_over_G0", "", "modulus_ratio", 1, &StrainPoint::ratio);
  add_range(columns, "damping", "_percent", "damping_ratio", per_cent, &StrainPoint::damping);
  constexpr double million = 1e6;
  add_number(columns, "G_MPa", "strained_shear_modulus/value", million,
             [](const CurveRow& row) { return row.at.modulus.value; });
  add_range(columns, "G", "_MPa", "strained_shear_modulus", million, &StrainPoint::modulus);
  return table_of("curves", "", columns, rows_of(curves));
}

Table shown_curves(const std::vector<StrainCurve>& curves) {
  using Of = const CurveRow&;
  const auto with_range = [](estimate::Range StrainPoint::*range, double unit) {
    return [range, unit](Of row) {
      const auto text = [&](double value) { return short_text(value / unit, 3); };
      const estimate::Range& of = row.at.*range;
      return fmt::format("{} ({} to {})", text(of.value), text(of.low), text(of.high));
    };
  };
  io::Columns<CurveRow> columns;
  if (curves.size() > 1)
    columns.emplace_back(
        "", "", [](Of row) { return row.curve->name; }, shown_as("curve", {}, -1));
  columns.emplace_back(
      "", "", [](Of row) { return short_text(row.at.strain / per_cent); }, shown_as("strain [%]", {}, 10));
  columns.emplace_back("", "", with_range(&StrainPoint::ratio, 1), shown_as("G/G0", {}, 24));
  columns.emplace_back("", "", with_range(&StrainPoint::damping, per_cent), shown_as("damping [%]", {}, 22));
  return table_of("", "", columns, rows_of(curves));
}

} // namespace granum::cli

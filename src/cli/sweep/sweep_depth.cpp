// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cmath>

#include <fmt/core.h>
#include <granum/core/error.hpp>
#include <granum/core/number.hpp>

#include "cli/frame/help.hpp"
#include "cli/frame/json_members.hpp"
#include "depth.hpp"

namespace granum::cli {

namespace {

using estimate::Field;
using estimate::Range;
using nlohmann::ordered_json;

/// A depth and the stresses there.
struct DepthPoint {
  double depth = 0; ///< [m]
  stress::GroundStress stress;
};

io::Columns<DepthPoint> depth_columns() {
  return {{"depth_m", "depth", [](const DepthPoint& at) { return at.depth; }},
          {"total_sigma_v_Pa", "total_stress_v", [](const DepthPoint& at) { return at.stress.total.v; }},
          {"total_sigma_h_Pa", "total_stress_h", [](const DepthPoint& at) { return at.stress.total.h; }},
          {"pore_pressure_Pa", "pore_pressure", [](const DepthPoint& at) { return at.stress.pore_pressure; }},
          {"sigma_v_Pa", "stress_v", [](const DepthPoint& at) { return at.stress.effective.v; }},
          {"sigma_h_Pa", "stress_h", [](const DepthPoint& at) { return at.stress.effective.h; }},
          {"p_Pa", "mean_stress", [](const DepthPoint& at) { return at.stress.effective.mean(); }}};
}

struct DepthState {
  DepthPoint point;
  SweptState state;
};

/// The answer of granum estimate at the stresses and in the water of that depth.
DepthState state_at(const SweepOptions& o, const GroundCase& ground, double depth) {
  DepthState at{.point = {depth, stress::stress_at(ground.ground, depth)}, .state = {}};
  AnswerOptions answer = o.answer;
  const auto& table = ground.ground.water_table;
  answer.saturation.value = table && depth > *table ? 1.0 : ground.saturation;
  answer.saturation.in_table = true;
  at.state = swept(at_stress(o.packing, at.point.stress.effective), answer, {});
  if (!at.state.answer)
    throw InvalidArgument(fmt::format("at {}: {}", pretty(depth, Dimension::length), at.state.error));
  return at;
}

std::vector<DepthState> states_at(const SweepOptions& o, const GroundCase& ground,
                                  const std::vector<double>& depths) {
  std::vector<DepthState> states;
  for (const double depth : depths)
    states.push_back(state_at(o, ground, depth));
  return states;
}

// ---- screen

std::string ground_text(const GroundCase& c) {
  const auto weight = [](double value) { return pretty(value, Dimension::unit_weight); };
  std::string text = fmt::format("  ground    {}, {} % of the pores water", weight(c.ground.unit_weight),
                                 short_text(100 * c.saturation, 3));
  if (const auto& table = c.ground.water_table)
    text += fmt::format("; below {} m {}, full", short_text(*table), weight(c.ground.saturated_unit_weight));
  text += fmt::format("\n  at rest   K_0 = {}", short_text(c.ground.earth_pressure_at_rest));
  if (c.ground.surcharge > 0)
    text += fmt::format(", under {}", pretty(c.ground.surcharge, Dimension::pressure));
  return text + "\n\n";
}

/// Three digits, or all before the point: 0.512, 85.1, 1649.
std::string brief(double number, int digits) {
  return number < std::pow(10, digits) - 0.5 ? fmt::format("{:.{}g}", number, digits)
                                             : fmt::format("{:.0f}", number);
}

/// To the right of its column, with a blank in front where it fills a column that is not the first.
std::string cell(const std::string& text, int width, bool first) {
  const std::string filled = fmt::format("{:>{}}", text, width);
  return first || filled.starts_with(' ') ? filled : " " + filled;
}

/// "85.1 (36-133)".
std::string brief_range(const Range& range, double unit) {
  return fmt::format("{} ({}-{})", brief(range.value / unit, 3), brief(range.low / unit, 2),
                     brief(range.high / unit, 2));
}

/// A column of the screen: together they fill 80 columns.
struct ShownDepth {
  int width;
  const char* heading;
  const char* unit;
  std::string (*text)(const DepthState& at);
};

template <class Of>
std::string stress_text(const DepthState& at, const Of& of) {
  return brief(of(at.point.stress) / 1e3, 4);
}
std::string field_cell(const DepthState& at, Field field, double unit) {
  return brief_range(at.state.answer->answer[field], unit);
}

constexpr ShownDepth shown_columns[] = {
    {5, "depth", "m", [](const DepthState& at) { return brief(at.point.depth, 4); }},
    {6, "s_v", "kPa",
     [](const DepthState& at) { return stress_text(at, [](const auto& s) { return s.total.v; }); }},
    {6, "u", "kPa",
     [](const DepthState& at) { return stress_text(at, [](const auto& s) { return s.pore_pressure; }); }},
    {6, "s'_v", "kPa",
     [](const DepthState& at) { return stress_text(at, [](const auto& s) { return s.effective.v; }); }},
    {6, "s'_h", "kPa",
     [](const DepthState& at) { return stress_text(at, [](const auto& s) { return s.effective.h; }); }},
    {6, "p'", "kPa",
     [](const DepthState& at) { return stress_text(at, [](const auto& s) { return s.effective.mean(); }); }},
    {14, "G (low-high)", "MPa",
     [](const DepthState& at) { return field_cell(at, Field::shear_modulus, 1e6); }},
    {14, "V_s", "m/s", [](const DepthState& at) { return field_cell(at, Field::shear_wave_speed, 1); }},
    {17, "V_p", "m/s",
     [](const DepthState& at) { return field_cell(at, Field::compression_wave_speed, 1); }}};

template <class Text>
std::string line_of(const Text& text) {
  std::string line;
  for (const ShownDepth& column : shown_columns)
    line += cell(text(column), column.width, line.empty());
  return line + "\n";
}

std::string table_of(const GroundCase& ground, const std::vector<DepthState>& states,
                     const std::vector<std::string>& remarks) {
  const AnswerCase& last = *states.back().state.answer;
  std::string text =
      fmt::format("Stiffness of level ground, void ratio {}: {}\n\n",
                  short_text(last.question.state.void_ratio), title_of(last.question.grain_shape));
  text += ground_text(ground);
  text += line_of([](const ShownDepth& column) { return std::string(column.heading); });
  text += line_of([](const ShownDepth& column) { return std::string(column.unit); });
  for (const DepthState& at : states)
    text += line_of([&](const ShownDepth& column) { return column.text(at); });
  text += fmt::format("\n  s total stress, s' effective stress, u pore pressure; G in a vertical plane,\n"
                      "  waves up and down; at {} m:",
                      short_text(states.back().point.depth)) +
          range_text(last) + "\n";
  for (const std::string& remark : remarks)
    text += "- " + remark + "\n";
  return text;
}

// ---- files

ordered_json ground_json(const GroundCase& c) {
  const stress::Ground& g = c.ground;
  const bool wet = g.water_table.has_value();
  return {{"unit_weight", g.unit_weight},
          {"saturation", c.saturation},
          {"water_table", wet ? ordered_json(*g.water_table) : ordered_json()},
          {"saturated_unit_weight", wet ? ordered_json(g.saturated_unit_weight) : ordered_json()},
          {"water_unit_weight", g.water_unit_weight},
          {"k0", g.earth_pressure_at_rest},
          {"surcharge", g.surcharge}};
}

SweepOutput output_of(const SweepOptions& o, const std::vector<DepthState>& states) {
  const io::Columns<DepthPoint> columns = depth_columns();
  std::vector<std::string> headings;
  for (const io::Column<DepthPoint>& column : columns)
    headings.push_back(column.heading);
  SweepOutput output(o, {}, headings);
  for (const DepthState& at : states) {
    std::vector<io::CsvCell> cells;
    io::add_cells(cells, columns, at.point);
    output.add(std::move(cells), members(columns, at.point), at.state);
  }
  return output;
}

std::vector<std::string> depth_remarks(const SweepOptions& o, const GroundCase& ground,
                                       const AnswerCase& first, const std::vector<DepthState>& states) {
  std::vector<std::string> remarks = ground.assumptions;
  for (const std::string& note : remarks_on(o, first.assumptions))
    remarks.push_back(note);
  const bool sand = first.question.grain_shape == estimate::GrainShape::sand;
  if (ground.ground.earth_pressure_at_rest != 1)
    remarks.emplace_back(
        sand ? "unequal stresses share the exponent of G in a vertical plane, m of sigma_h and n of sigma_v"
             : "unequal stresses act on each contact by its direction (rung 2, relaxed); they change "
               "no contacts: --fabric is that of the ground as it lies");
  const auto shallow = [](const DepthState& at) {
    const double p = at.point.stress.effective.mean();
    return p > 0 && p < sands::least_tested_stress;
  };
  if (const auto last = std::find_if(states.rbegin(), states.rend(), shallow); sand && last != states.rend())
    remarks.push_back(
        fmt::format("no sand was tested below p' = 25 kPa, here at {} m and less: the range is wider "
                    "there, up to a factor of 1.6",
                    short_text(last->point.depth)));
  if (states.front().point.stress.effective.v == 0)
    remarks.emplace_back(
        "without stress grains have no stiffness: at the surface G and V_s are 0, where suction "
        "and cement would hold real ground");
  return remarks;
}

// ---- picture

plot::Chart panel(const std::string& title, const std::string& x, double unit) {
  return {.title = title,
          .x = {.title = x, .unit = unit},
          .y = {.title = "depth [m]", .reversed = true},
          .series = {},
          .width = 230,
          .height = 460,
          .legend_below = true};
}

plot::Chart stress_panel(const std::vector<DepthState>& states) {
  plot::Chart chart = panel("stress", "stress [kPa]", 1e3);
  const auto add = [&](const char* name, std::optional<plot::Colour> colour,
                       double (*of)(const DepthPoint&)) {
    plot::Series line{.name = name,
                      .mark = plot::Mark::line,
                      .x = {},
                      .y = {},
                      .style = chart.series.size(), // of dashes
                      .tone = colour ? plot::Tone::full : plot::Tone::grey,
                      .colour = colour};
    for (const DepthState& at : states) {
      line.x.push_back(of(at.point));
      line.y.push_back(at.point.depth);
    }
    chart.series.push_back(std::move(line));
  };
  add("\u03c3'_v", plot::Colour::vertical, [](const DepthPoint& at) { return at.stress.effective.v; });
  add("\u03c3'_h", plot::Colour::horizontal, [](const DepthPoint& at) { return at.stress.effective.h; });
  add("u", std::nullopt, [](const DepthPoint& at) { return at.stress.pore_pressure; });
  add("\u03c3_v", std::nullopt, [](const DepthPoint& at) { return at.stress.total.v; });
  return chart;
}

plot::Chart field_panel(const SweepOptions& o, const std::vector<DepthState>& states, Field field,
                        const std::string& x, double unit) {
  plot::Chart chart = panel(estimate::row_of(field).meaning, x, unit);
  Band band;
  std::vector<const SweptState*> all;
  for (const DepthState& at : states) {
    band.at.push_back(at.point.depth);
    band.ranges.push_back(at.state.answer->answer[field]);
    all.push_back(&at.state);
  }
  if (field == Field::shear_modulus)
    add_law_band(chart, o, band.at, all, true);
  add_band(chart, band, true);
  return chart;
}

/// Depths close enough for smooth curves, with the jump at the water table.
std::vector<double> picture_depths(const GroundCase& c) {
  constexpr std::size_t count = 121;
  const double first = c.depths.front(), last = c.depths.back();
  std::vector<double> depths = spread(first, last, count, false);
  const auto& table = c.ground.water_table;
  if (table && *table > first && *table < last) {
    depths.push_back(*table);
    depths.push_back(std::nextafter(*table, last));
  }
  std::sort(depths.begin(), depths.end());
  return depths;
}

std::vector<plot::Chart> picture_of(const SweepOptions& o, const GroundCase& ground) {
  if (o.picture.empty())
    return {};
  const std::vector<DepthState> states = states_at(o, ground, picture_depths(ground));
  return {stress_panel(states), field_panel(o, states, Field::shear_modulus, "G [MPa]", 1e6),
          field_panel(o, states, Field::shear_wave_speed, "V_s [m/s]", 1),
          field_panel(o, states, Field::compression_wave_speed, "V_p [m/s]", 1)};
}

Validity validity_of(const GroundCase& ground, const std::vector<DepthState>& states) {
  Validity validity = ground.validity;
  Tally tally;
  for (const DepthState& at : states)
    tally.count(at.state, pretty(at.point.depth, Dimension::length));
  validity.merge(tally.validity());
  return validity;
}

} // namespace

ExitCode sweep_depth(const SweepOptions& o) {
  require_free(o.output, o.picture);
  const GroundCase ground = resolve_ground(o);
  const std::vector<DepthState> states = states_at(o, ground, ground.depths);
  const AnswerCase& last = *states.back().state.answer;
  const AnswerCase solved =
      solve_answer(at_stress(o.packing, states.back().point.stress.effective), o.answer, {});
  const std::vector<std::string> remarks = depth_remarks(o, ground, solved, states);
  const ordered_json packing = packing_json(o.packing, last.question.state);
  const SweepOutput output = output_of(o, states);
  return deliver_sweep(
      o, within_width(table_of(ground, states, remarks)),
      output.csv({{"inputs", json_text(packing, -1)}, {"ground", json_text(ground_json(ground), -1)}},
                 remarks),
      output.json({{"inputs", packing}, {"ground", ground_json(ground)}}, remarks),
      validity_of(ground, states), picture_of(o, ground));
}

} // namespace granum::cli

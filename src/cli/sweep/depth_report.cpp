// SPDX-License-Identifier: GPL-3.0-or-later
#include <array>

#include <fmt/format.h>
#include <granum/core/number.hpp>
#include <granum/core/version.hpp>

#include "answer_columns.hpp"
#include "depth.hpp"

namespace granum::cli {

namespace {

using effective::Range;
using nlohmann::ordered_json;

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

/// "162.0 (78-245)".
std::string range_cell(const Range& range, double unit, int decimals, int width) {
  const std::string text = fmt::format("{:.{}f} ({:.0f}-{:.0f})", range.value / unit, decimals,
                                       range.low / unit, range.high / unit);
  return fmt::format("{:>{}}", text, width);
}

std::string row_text(const DepthAnswer& at) {
  const effective::PackingAnswer& a = at.answer.answer;
  return fmt::format("{:>7.2f}{:>9.1f}{:>8.1f}{:>10.1f}{:>10.1f}{:>8.1f}", at.depth, at.stress.total.v / 1e3,
                     at.stress.pore_pressure / 1e3, at.stress.effective.v / 1e3, at.stress.effective.h / 1e3,
                     at.stress.effective.mean() / 1e3) +
         range_cell(a.shear_modulus, 1e6, 1, 17) + range_cell(*a.shear_wave_speed, 1, 0, 15) +
         range_cell(*a.compression_wave_speed, 1, 0, 18) + "\n";
}

struct StressColumn {
  const char* heading;
  const char* key; ///< in JSON
  double (*of)(const stress::GroundStress& stress);
};
constexpr StressColumn stress_columns[] = {
    {"total_sigma_v_kPa", "total_stress_v", [](const stress::GroundStress& s) { return s.total.v; }},
    {"total_sigma_h_kPa", "total_stress_h", [](const stress::GroundStress& s) { return s.total.h; }},
    {"pore_pressure_kPa", "pore_pressure", [](const stress::GroundStress& s) { return s.pore_pressure; }},
    {"sigma_v_kPa", "stress_v", [](const stress::GroundStress& s) { return s.effective.v; }},
    {"sigma_h_kPa", "stress_h", [](const stress::GroundStress& s) { return s.effective.h; }},
    {"p_kPa", "mean_stress", [](const stress::GroundStress& s) { return s.effective.mean(); }},
};

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

void add_line(plot::Chart& chart, const DepthSweep& sweep, const std::string& name,
              std::optional<plot::Colour> colour, double (*of)(const DepthAnswer& at)) {
  plot::Series line{.name = name,
                    .mark = plot::Mark::line,
                    .x = {},
                    .y = {},
                    .style = chart.series.size(), // of dashes
                    .tone = colour ? plot::Tone::full : plot::Tone::grey,
                    .colour = colour};
  for (const DepthAnswer& at : sweep.answers) {
    line.x.push_back(of(at));
    line.y.push_back(at.depth);
  }
  chart.series.push_back(std::move(line));
}

/// A line in the middle of its band.
plot::Chart range_panel(const DepthSweep& sweep, const std::string& title, const std::string& x, double unit,
                        Range (*of)(const effective::PackingAnswer& answer)) {
  plot::Chart chart = panel(title, x, unit);
  plot::Series line{.name = "answer",
                    .mark = plot::Mark::line,
                    .x = {},
                    .y = {},
                    .style = 0,
                    .colour = plot::Colour::closed_form};
  plot::Series band{.name = "range",
                    .mark = plot::Mark::area,
                    .x = {},
                    .y = {},
                    .style = 0,
                    .colour = plot::Colour::closed_form};
  for (const DepthAnswer& at : sweep.answers) {
    const Range range = of(at.answer.answer);
    line.x.push_back(range.value);
    line.y.push_back(at.depth);
    band.x.push_back(range.low);
    band.y.push_back(at.depth);
  }
  for (auto at = sweep.answers.rbegin(); at != sweep.answers.rend(); ++at) {
    band.x.push_back(of(at->answer.answer).high);
    band.y.push_back(at->depth);
  }
  chart.series = {std::move(band), std::move(line)};
  return chart;
}

} // namespace

std::string depth_table(const DepthSweep& sweep) {
  const AnswerCase& last = sweep.answers.back().answer;
  std::string text = fmt::format("Small-strain stiffness of level ground of void ratio {}\n\n",
                                 short_text(last.question.state.void_ratio));
  text += ground_text(sweep.ground);
  const auto headings = [&text](const std::array<const char*, 9>& h) {
    text += fmt::format("{:>7}{:>9}{:>8}{:>10}{:>10}{:>8}{:>17}{:>15}{:>18}\n", h[0], h[1], h[2], h[3], h[4],
                        h[5], h[6], h[7], h[8]);
  };
  headings({"depth", "sigma_v", "u", "sigma'_v", "sigma'_h", "p'", "G (low-high)", "V_s", "V_p"});
  headings({"m", "kPa", "kPa", "kPa", "kPa", "kPa", "MPa", "m/s", "m/s"});
  for (const DepthAnswer& at : sweep.answers)
    text += row_text(at);
  text += fmt::format("\n  G in a vertical plane, waves up and down; at {} m:",
                      short_text(sweep.answers.back().depth)) +
          range_text(last) + "\n";
  for (const std::string& remark : sweep.remarks)
    text += "- " + remark + "\n";
  return text;
}

std::string depth_csv(const DepthSweep& sweep, bool all_columns) {
  io::CsvContent csv;
  csv.notes = {{"program", fmt::format("granum {} sweep", version())},
               {"inputs", json_text(sweep.packing, -1)},
               {"ground", json_text(ground_json(sweep.ground), -1)},
               {"signs", "compression positive; sigma_v, sigma_h and p are effective stresses"}};
  for (const std::string& remark : sweep.remarks)
    csv.notes.emplace_back("note", remark);
  csv.headings = {"depth_m"};
  for (const StressColumn& column : stress_columns)
    csv.headings.emplace_back(column.heading);
  for (const std::string& heading : answer_headings(all_columns))
    csv.headings.push_back(heading);
  csv.headings.emplace_back("notes");
  for (const DepthAnswer& at : sweep.answers) {
    std::vector<io::CsvCell> row{at.depth};
    for (const StressColumn& column : stress_columns)
      row.emplace_back(column.of(at.stress) / 1e3);
    append_answer_cells(row, at.answer.answer, all_columns);
    row.emplace_back(fmt::format("{}", fmt::join(at.answer.answer.validity.notes, "; ")));
    csv.rows.push_back(std::move(row));
  }
  return io::csv_text(csv);
}

ordered_json depth_json(const DepthSweep& sweep) {
  ordered_json json = json_head("sweep");
  json["inputs"] = sweep.packing;
  json["ground"] = ground_json(sweep.ground);
  json["states"] = ordered_json::array();
  for (const DepthAnswer& at : sweep.answers) {
    ordered_json state = {{"depth", at.depth}};
    for (const StressColumn& column : stress_columns)
      state[column.key] = column.of(at.stress);
    state["answer"] = answer_json(at.answer);
    state["answer"].erase("notes");
    state["notes"] = at.answer.answer.validity.notes;
    json["states"].push_back(std::move(state));
  }
  json["notes"] = sweep.remarks;
  return json;
}

std::vector<plot::Chart> depth_charts(const DepthSweep& sweep) {
  plot::Chart stresses = panel("stress", "stress [kPa]", 1e3);
  const auto line = [&](const char* name, std::optional<plot::Colour> colour,
                        double (*of)(const DepthAnswer&)) { add_line(stresses, sweep, name, colour, of); };
  line("\u03c3'_v", plot::Colour::vertical, [](const DepthAnswer& at) { return at.stress.effective.v; });
  line("\u03c3'_h", plot::Colour::horizontal, [](const DepthAnswer& at) { return at.stress.effective.h; });
  line("u", std::nullopt, [](const DepthAnswer& at) { return at.stress.pore_pressure; });
  line("\u03c3_v", std::nullopt, [](const DepthAnswer& at) { return at.stress.total.v; });
  return {std::move(stresses),
          range_panel(sweep, "shear modulus", "G [MPa]", 1e6, [](const auto& a) { return a.shear_modulus; }),
          range_panel(sweep, "shear wave", "V_s [m/s]", 1, [](const auto& a) { return *a.shear_wave_speed; }),
          range_panel(sweep, "compression wave", "V_p [m/s]", 1,
                      [](const auto& a) { return *a.compression_wave_speed; })};
}

} // namespace granum::cli

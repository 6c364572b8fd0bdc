// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cmath>

#include <fmt/core.h>
#include <granum/core/error.hpp>
#include <granum/core/text.hpp>

#include "cli/frame/json_members.hpp"
#include "cli/options/packing_json.hpp"
#include "depth.hpp"
#include "site.hpp"

namespace granum::cli {

namespace {

using estimate::Field;
using estimate::Range;
using nlohmann::ordered_json;

/// A depth, its layer and the stresses there.
struct DepthPoint {
  double depth = 0; ///< [m]
  const Layer* layer = nullptr;
  stress::GroundStress stress;
};

/// \param    layered   whether the ground has layers, which are then a column
io::Columns<DepthPoint> depth_columns(bool layered) {
  io::Columns<DepthPoint> columns{
      {"depth_m", "depth", [](const DepthPoint& at) { return at.depth; }},
      {"total_sigma_v_Pa", "total_stress_v", [](const DepthPoint& at) { return at.stress.total.v; }},
      {"total_sigma_h_Pa", "total_stress_h", [](const DepthPoint& at) { return at.stress.total.h; }},
      {"pore_pressure_Pa", "pore_pressure", [](const DepthPoint& at) { return at.stress.pore_pressure; }},
      {"sigma_v_Pa", "stress_v", [](const DepthPoint& at) { return at.stress.effective.v; }},
      {"sigma_h_Pa", "stress_h", [](const DepthPoint& at) { return at.stress.effective.h; }},
      {"p_Pa", "mean_stress", [](const DepthPoint& at) { return at.stress.effective.mean(); }}};
  if (layered)
    columns.emplace_back("layer_top_m", "layer_top", [](const DepthPoint& at) { return at.layer->top; });
  return columns;
}

struct DepthState {
  DepthPoint point;
  SweptState state;
};

DepthState state_at(const std::vector<Layer>& layers, double depth) {
  const Layer& layer = layer_at(layers, depth);
  return {.point = {depth, &layer, stress::stress_at(layer.ground.ground, depth - layer.top)},
          .state = swept(values_at(layers, depth), {})};
}

std::vector<DepthState> states_at(const std::vector<Layer>& layers, const std::vector<double>& depths) {
  std::vector<DepthState> states;
  for (const double depth : depths)
    states.push_back(state_at(layers, depth));
  return states;
}

/// The deepest state that has an answer; null if none has one.
const DepthState* last_answered(const std::vector<DepthState>& states) {
  const auto found = std::find_if(states.rbegin(), states.rend(),
                                  [](const DepthState& at) { return at.state.answer.has_value(); });
  return found == states.rend() ? nullptr : &*found;
}

// ---- screen

/// Three digits, or all digits before the decimal point: 0.512, 85.1, 1649.
std::string brief(double number, int digits) {
  return number < std::pow(10, digits) - 0.5 ? fmt::format("{:.{}g}", number, digits)
                                             : fmt::format("{:.0f}", number);
}

/// \param    top   depth of the zero of the ground's own depths [m]
std::string ground_text(const GroundCase& c, double top) {
  const auto weight = [](double value) { return pretty(value, Dimension::unit_weight); };
  if (const auto& table = c.ground.water_table; table && *table <= 0 && top > 0)
    return fmt::format("{}, below the water table, S_r = 100 %", weight(c.ground.saturated_unit_weight));
  std::string text =
      fmt::format("{}, S_r = {} %", weight(c.ground.unit_weight), short_text(100 * c.saturation, 3));
  if (const auto& table = c.ground.water_table)
    text += fmt::format("; below {} m {}, S_r = 100 %", short_text(top + *table),
                        weight(c.ground.saturated_unit_weight));
  return text;
}

std::string rest_text(const stress::Ground& ground) {
  std::string text = fmt::format("K_0 = {}", short_text(ground.earth_pressure_at_rest));
  if (ground.surcharge > 0)
    text += fmt::format(", loaded by {}", pretty(ground.surcharge, Dimension::pressure));
  return text;
}

double void_ratio_of(const Layer& layer) {
  constexpr stress::AxialStress any{1e5, 1e5}; // the density does not depend on it
  return state_of(layer.options.inputs, any).void_ratio;
}

std::string depth_title(const std::vector<Layer>& layers, const AnswerCase& last) {
  if (layers.size() > 1)
    return "Stiffness of level ground in layers, each from its top down";
  const sands::KnownSand* const sand = layers.front().options.inputs.known_sand;
  return fmt::format("Stiffness of level ground, {}void ratio {}: {}",
                     sand != nullptr ? sand->name + std::string(", ") : "",
                     short_text(last.question.state.void_ratio), title_of(last.question.grain_shape));
}

/// The ground, or a line for each layer.
Items ground_lines(const std::vector<Layer>& layers) {
  Items to;
  const auto add = [&to](const std::string& label, const std::string& text) {
    io::add_item(to.items, "", text, shown_as(label));
  };
  if (layers.size() == 1) {
    add("ground", ground_text(layers.front().ground, 0));
    add("at rest", rest_text(layers.front().ground.ground));
    return to;
  }
  for (const Layer& layer : layers)
    add(fmt::format("{:>5} m", brief(layer.top, 4)),
        fmt::format("e = {}, {}, {}", short_text(void_ratio_of(layer)), ground_text(layer.ground, layer.top),
                    rest_text(layer.ground.ground)));
  return to;
}

/// "85.1 (36-133)".
std::string brief_range(const Range& range, double unit) {
  return fmt::format("{} ({}-{})", brief(range.value / unit, 3), brief(range.low / unit, 2),
                     brief(range.high / unit, 2));
}

/// Stresses, and G, V_s and V_p with their ranges, for a screen of 80 columns; the first row has the units.
Table depth_table(const std::vector<DepthState>& states) {
  using Of = const DepthState&;
  const auto stress = [](double (*of)(const stress::GroundStress&)) {
    return [of](Of at) { return brief(of(at.point.stress) / 1e3, 4); };
  };
  const auto range = [](Field field, double unit) {
    return [field, unit](Of at) {
      return at.state.answer ? brief_range(at.state.answer->answer[field], unit) : std::string("-");
    };
  };
  const io::Columns<DepthState> columns = {
      {"", "", [](Of at) { return brief(at.point.depth, 4); }, shown_as("depth", {}, 5)},
      {"", "", stress([](const auto& s) { return s.total.v; }), shown_as("s_v", {}, 6)},
      {"", "", stress([](const auto& s) { return s.pore_pressure; }), shown_as("u", {}, 6)},
      {"", "", stress([](const auto& s) { return s.effective.v; }), shown_as("s'_v", {}, 6)},
      {"", "", stress([](const auto& s) { return s.effective.h; }), shown_as("s'_h", {}, 6)},
      {"", "", stress([](const auto& s) { return s.effective.mean(); }), shown_as("p'", {}, 6)},
      {"", "", range(Field::shear_modulus, 1e6), shown_as("G (low-high)", {}, 14)},
      {"", "", range(Field::shear_wave_speed, 1), shown_as("V_s", {}, 14)},
      {"", "", range(Field::compression_wave_speed, 1), shown_as("V_p", {}, 17)}};
  Table table = table_of("", "", columns, states);
  Cells units;
  for (const char* unit : {"m", "kPa", "kPa", "kPa", "kPa", "kPa", "MPa", "m/s", "m/s"})
    units.emplace_back(unit);
  table.rows.insert(table.rows.begin(), std::move(units));
  return table;
}

/// G, G/G0 and damping at the strain with their ranges; without rows if none is given.
Table strain_table(const std::vector<DepthState>& states) {
  using Of = const DepthState&;
  const auto range = [](Field field, double unit) {
    return [field, unit](Of at) {
      const bool any = at.state.answer && at.state.answer->answer.find(field);
      return any ? brief_range(at.state.answer->answer[field], unit) : std::string("-");
    };
  };
  const io::Columns<DepthState> columns = {
      {"", "", [](Of at) { return brief(at.point.depth, 4); }, shown_as("depth [m]", {}, 9)},
      {"", "", range(Field::strained_shear_modulus, 1e6), shown_as("G(strain) [MPa]", {}, 20)},
      {"", "", range(Field::modulus_ratio, 1), shown_as("G/G0", {}, 20)},
      {"", "", range(Field::damping_ratio, 0.01), shown_as("damping [%]", {}, 20)}};
  const bool strained = std::ranges::any_of(
      states, [](Of at) { return at.state.answer && at.state.answer->answer.find(Field::modulus_ratio); });
  return table_of("", "", columns, strained ? states : std::vector<DepthState>());
}

/// What the columns are, and where the range at the last depth comes from.
Prose depth_legend(const std::vector<DepthState>& states) {
  const DepthState& deepest = *last_answered(states);
  const AnswerCase& last = *deepest.state.answer;
  Prose prose{{"s total stress, s' effective stress, p' its mean, u pore pressure; S_r degree of saturation, "
               "K_0 = s'_h/s'_v at rest; (low-high): range of the answer; G in a vertical plane, V_s and V_p "
               "of vertical waves"}};
  if (const std::string shares = shares_text(last.answer); !shares.empty())
    prose.lines.push_back(
        fmt::format("At {} m the range of G comes from: {}.", short_text(deepest.point.depth), shares));
  std::vector<std::pair<double, std::string>> remarks; // a line where they change, from its layer on
  for (const DepthState& at : states)
    if (const std::string remark = at.state.answer ? preparation_remark(at.state.answer->question) : "";
        at.state.answer && (remarks.empty() || remarks.back().second != remark))
      remarks.emplace_back(at.point.layer->top, remark);
  for (const auto& [top, remark] : remarks)
    if (!remark.empty())
      prose.lines.push_back(remarks.size() == 1 ? remark
                                                : fmt::format("From {} m: {}", short_text(top), remark));
  return prose;
}

/// "At 30 m G is 140 MPa (121 to 161 MPa), ...".
std::string sentence_at(const DepthState& at) {
  const estimate::Answer& answer = at.state.answer->answer;
  return fmt::format("At {} m, p' = {}, G is {} and V_s {}.", short_text(at.point.depth),
                     pretty(at.point.stress.effective.mean(), Dimension::pressure),
                     range_text(Dimension::pressure, answer[Field::shear_modulus]),
                     range_text(Dimension::speed, answer[Field::shear_wave_speed]));
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

/// The ground, or its layers, each from its top down.
ordered_json ground_json(const std::vector<Layer>& layers) {
  if (layers.size() == 1)
    return ground_json(layers.front().ground);
  ordered_json json = ordered_json::array();
  for (const Layer& layer : layers) {
    json.push_back({{"top", layer.top}, {"void_ratio", void_ratio_of(layer)}});
    json.back().update(ground_json(layer.ground));
  }
  return json;
}

SweptRows rows_of(const SweepOptions& o, const std::vector<DepthState>& states) {
  const io::Columns<DepthPoint> columns = SweptRows::in_units(depth_columns(!o.ground.layers.empty()), o);
  SweptRows output(o, {}, io::headings_of(columns), asked_of(o.inputs));
  for (const DepthState& at : states) {
    std::vector<io::CsvCell> cells;
    io::add_cells(cells, columns, at.point);
    output.add(std::move(cells), members(columns, at.point), at.state);
  }
  return output;
}

/// The assumptions of a layer: those of its ground, and of its answer at the bottom.
/// \param    alone   whether it is the only layer
estimate::Notes assumptions_of(const Layer& layer, double bottom, bool alone) {
  estimate::Notes all = layer.ground.assumptions;
  const stress::GroundStress stress = stress::stress_at(layer.ground.ground, bottom - layer.top);
  try {
    const AnswerCase solved = solve_answer(at_stress(layer.options.inputs, stress.effective), {});
    std::ranges::copy(alone ? remarks_on(layer.options, solved.assumptions) : solved.assumptions,
                      std::back_inserter(all));
  } catch (const InvalidArgument&) { // the states there report it
  }
  return all;
}

} // namespace

estimate::Notes assumptions_of(const std::vector<Layer>& layers, double deepest) {
  std::vector<std::pair<const Layer*, estimate::Notes>> assumed;
  for (auto layer = layers.begin(); layer != layers.end() && layer->top < deepest; ++layer) {
    const double end = layer + 1 == layers.end() ? deepest : (layer + 1)->top;
    assumed.emplace_back(&*layer, assumptions_of(*layer, std::min(end, deepest), layers.size() == 1));
  }
  const auto everywhere = [&](const estimate::Note& note) {
    return std::all_of(assumed.begin(), assumed.end(), [&](const auto& one) {
      return std::find(one.second.begin(), one.second.end(), note) != one.second.end();
    });
  };
  estimate::Notes all, of_layers;
  for (const auto& [layer, notes] : assumed)
    for (const estimate::Note& note : notes)
      if (!everywhere(note))
        add_sentence(of_layers, fmt::format("from {} m: {}", short_text(layer->top), note.sentence()));
      else if (layer == assumed.front().first)
        all.push_back(note);
  all.insert(all.end(), of_layers.begin(), of_layers.end());
  return all;
}

namespace {

bool is_of(const DepthState& at, estimate::GrainShape shape) {
  return at.state.answer && at.state.answer->question.grain_shape == shape;
}
bool is_sand(const DepthState& at) { return is_of(at, estimate::GrainShape::sand); }

estimate::Notes depth_remarks(const std::vector<Layer>& layers, const std::vector<DepthState>& states) {
  estimate::Notes remarks = assumptions_of(layers, states.back().point.depth);
  const bool sand = std::any_of(states.begin(), states.end(), is_sand),
             spheres = std::any_of(states.begin(), states.end(), [](const DepthState&at) {
               return is_of(at, estimate::GrainShape::sphere);
             });
  const bool unequal = std::any_of(layers.begin(), layers.end(), [](const Layer& layer) {
    return layer.ground.ground.earth_pressure_at_rest != 1;
  });
  if (unequal && sand)
    add_sentence(
        remarks,
        "G in a vertical plane grows as sigma_v^n sigma_h^m; n + m is the exponent s under equal stresses");
  if (unequal && spheres)
    add_sentence(remarks,
                 "unequal stresses act on each contact by its direction (rung 2, relaxed); they do not "
                 "change the contacts: --fabric is that of the ground at rest");
  const auto shallow = [](const DepthState& at) {
    const double p = at.point.stress.effective.mean();
    return is_sand(at) && p > 0 && p < sands::least_tested_stress;
  };
  if (const auto last = std::find_if(states.rbegin(), states.rend(), shallow); last != states.rend())
    add_sentence(
        remarks,
        fmt::format(
            "no sand was tested below p' = 25 kPa, here at depths of {} m and less: the range is wider "
            "there, up to a factor of 1.6",
            short_text(last->point.depth)));
  if (states.front().point.stress.effective.v == 0)
    add_sentence(
        remarks,
        "without stress a packing has no stiffness: at the surface G and V_s are 0, although suction "
        "and cement stiffen real ground");
  return remarks;
}

// ---- picture

plot::Chart panel(const std::string& title, const std::string& x, double unit) {
  return {.title = title,
          .x = {.title = x, .unit = unit},
          .y = {.title = "depth [m]", .reversed = true},
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
                      .style = chart.series.size(), // dashes
                      .tone = colour ? plot::Tone::full : plot::Tone::grey,
                      .colour = colour};
    for (const DepthState& at : states)
      line.add(of(at.point), at.point.depth);
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
  std::vector<double> depths;
  std::vector<const SweptState*> all;
  for (const DepthState& at : states) {
    depths.push_back(at.point.depth);
    all.push_back(&at.state);
  }
  if (field == Field::shear_modulus)
    add_law_band(chart, o, depths, all, true);
  add_band(chart, band_of(field, depths, all, answer_in), true);
  return chart;
}

/// Depths close enough for smooth curves, with the jumps at the water table and between layers.
std::vector<double> picture_depths(const std::vector<double>& asked, const std::vector<Layer>& layers) {
  constexpr std::size_t count = 121;
  const double first = asked.front(), last = asked.back();
  std::vector<double> depths;
  for (const double share : spread(0, 1, count, false))
    depths.push_back(first +
                     (last - first) * share * share * share); // V_s is a root of the depth at the surface
  depths.back() = last;
  const auto add_jump = [&](double above, double below) {
    if (above > first && below < last)
      depths.insert(depths.end(), {above, below});
  };
  if (const auto& table = layers.front().ground.ground.water_table)
    add_jump(*table, std::nextafter(*table, last));
  for (const Layer& layer : layers)
    add_jump(std::nextafter(layer.top, first), layer.top);
  std::sort(depths.begin(), depths.end());
  return depths;
}

std::vector<plot::Chart> picture_of(const SweepOptions& o, const std::vector<double>& depths,
                                    const std::vector<Layer>& layers) {
  const std::vector<DepthState> states = states_at(layers, picture_depths(depths, layers));
  return {stress_panel(states), field_panel(o, states, Field::shear_modulus, "G [MPa]", 1e6),
          field_panel(o, states, Field::shear_wave_speed, "V_s [m/s]", 1),
          field_panel(o, states, Field::compression_wave_speed, "V_p [m/s]", 1)};
}

/// What the site's response needs; a note where a depth has no V_s.
void add_site(Document& document, const std::vector<Layer>& layers, double base) {
  try {
    const SiteResponse site = site_response(layers, base);
    document.add(Seen::always, site_items(site));
    document.comments.emplace_back("site", site_text(site));
  } catch (const InvalidArgument& error) {
    document.add(Seen::data, Data{"site", nullptr});
    document.add_notes(std::vector{fmt::format("no travel time of a shear wave: {}", error.what())});
  }
}

Tally tally_of(const std::vector<DepthState>& states) {
  Tally tally;
  for (const DepthState& at : states)
    tally.count(at.state, pretty(at.point.depth, Dimension::length));
  return tally;
}

} // namespace

ExitCode sweep_depth(const SweepOptions& o) {
  Outlets to = outlets_of(o);
  to.csv_on_screen = false;
  to.full = true;
  require_free(to);
  const std::vector<double> depths = depths_of(o);
  const std::vector<Layer> layers = layers_of(o);
  const std::vector<DepthState> states = states_at(layers, depths);
  const DepthState* const answered = last_answered(states);
  if (answered == nullptr)
    throw InvalidArgument(fmt::format("at {}: {}", pretty(states.front().point.depth, Dimension::length),
                                      states.front().state.error));
  const DepthState& last = *answered;
  const Tally tally = tally_of(states);
  Document document = rows_of(o, states).document(depth_remarks(layers, states));
  document.title = depth_title(layers, *last.state.answer);
  document.add(Seen::always, ground_lines(layers));
  document.add(Seen::always, depth_table(states));
  document.add(Seen::always, strain_table(states));
  add_site(document, layers, depths.back());
  document.add(Seen::always, depth_legend(states));
  add_packing(document, last.point.layer->options.inputs, last.state.answer->question.state,
              !known_shape(last.point.layer->options.inputs));
  document.add(Seen::data, Data{"ground", ground_json(layers)});
  add_sources(document);
  document.sentences = {sentence_at(last), what_a_range_means};
  for (const Layer& layer : layers)
    document.warnings.merge(layer.ground.validity);
  document.warnings.merge(tally.validity());
  if (to.draws())
    document.add(Seen::data, Picture{picture_of(o, depths, layers)});
  return tally.conclude(deliver_sweep(to, document));
}

} // namespace granum::cli

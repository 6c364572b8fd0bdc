// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cctype>
#include <cmath>
#include <numbers>

#include <fmt/core.h>
#include <granum/core/error.hpp>
#include <granum/core/text.hpp>
#include <granum/stress/stress.hpp>

#include "cli/frame/json_members.hpp"
#include "cli/options/likely_mistakes.hpp"
#include "cli/options/packing_json.hpp"
#include "sweep.hpp"

namespace granum::cli {

namespace {

using nlohmann::ordered_json;
using stress::AxialStress;
using stress::ShearPath;

/// A state of stress on the path.
struct PathPoint {
  AxialStress stress;
  double eta;
};

io::Columns<PathPoint> point_columns() {
  return {{"p_Pa", "p", [](const PathPoint& at) { return at.stress.mean(); }},
          {"q_Pa", "q", [](const PathPoint& at) { return at.stress.deviator(); }},
          {"eta", "eta", [](const PathPoint& at) { return at.eta; }},
          {"sigma_v_Pa", "sigma_v", [](const PathPoint& at) { return at.stress.v; }},
          {"sigma_h_Pa", "sigma_h", [](const PathPoint& at) { return at.stress.h; }}};
}

/// The path and its points.
struct Path {
  std::string text; ///< "TXC from 100 kPa to eta = 0.6"
  bool isotropic = true;
  bool logarithmic = true;
  std::vector<PathPoint> points;
};

Path isotropic_path(const SweepOptions& o) {
  if (!o.to.given())
    throw InvalidArgument("--to is missing: the mean stress at the end of the path");
  const bool logarithmic = o.spacing != "linear";
  for (const Number* end : {&o.from, &o.to}) {
    require_non_negative(end->name, end->value, "Pa");
    if (logarithmic && end->value == 0)
      throw InvalidArgument(end->name + " = 0 has no logarithm; use --spacing linear");
  }
  Path path{.text = fmt::format("ISO from {} to {}", pretty(o.from.value, Dimension::pressure),
                                pretty(o.to.value, Dimension::pressure)),
            .logarithmic = logarithmic,
            .points = {}};
  for (const double p : spread(o.from.value, o.to.value, o.points, logarithmic))
    path.points.push_back({{p, p}, 0});
  return path;
}

ShearPath shear_path(const std::string& option) {
  return *std::find_if(stress::all_shear_paths.begin(), stress::all_shear_paths.end(),
                       [&option](ShearPath path) {
                         std::string lower(stress::name(path));
                         for (char& c : lower)
                           c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
                         return lower == option;
                       });
}

Path path_to_ratio(const SweepOptions& o) {
  if (o.spacing == "log")
    throw InvalidArgument("--spacing log goes with --path iso: other paths start at eta = 0");
  if (!o.eta.given() && !o.friction_angle.given())
    throw InvalidArgument("give one of --eta and --friction-angle: the end of the path");
  require_positive(o.from.name, o.from.value, "Pa");
  const ShearPath kind = shear_path(o.path);
  if (o.friction_angle.given())
    require_open(o.friction_angle.name, o.friction_angle.value * 180 / std::numbers::pi, 0, 90, "deg");
  const double end = o.eta.given() ? o.eta.value : stress::failure_ratio(kind, o.friction_angle.value);
  (void)stress::stress_on_path(kind, o.from.value, end); // reports the end itself, not a point before it
  Path path{.text = fmt::format("{} from {} to eta = {}", stress::name(kind),
                                pretty(o.from.value, Dimension::pressure), short_text(end)),
            .isotropic = false,
            .logarithmic = false,
            .points = {}};
  for (const double eta : spread(0, end, o.points, false))
    path.points.push_back({stress::stress_on_path(kind, o.from.value, eta), eta});
  return path;
}

Path make_path(const SweepOptions& o) {
  if (!o.from.given())
    throw InvalidArgument("give --from, the mean stress at the start of a path, or --depth or --table");
  return o.path == "iso" ? isotropic_path(o) : path_to_ratio(o);
}

plot::Chart chart_of(const SweepOptions& o, const Path& path, const std::vector<SweptState>& states,
                     const Rungs& rungs) {
  const SweptQuantity& quantity = swept_quantity(o.picture_of.empty() ? "G_hv" : o.picture_of);
  const plot::Scale scale = path.logarithmic ? plot::Scale::logarithmic : plot::Scale::linear;
  plot::Chart chart{.title = path.text, .x = {.title = "\u03b7 = q/p'"}, .y = {.title = quantity.name}};
  if (path.isotropic)
    chart.x = {.title = "p' [kPa]", .scale = scale, .unit = 1e3};
  if (quantity.dimension == Dimension::pressure)
    chart.y = {.title = quantity.name + std::string(" [MPa]"), .scale = scale, .unit = 1e6};
  std::vector<double> places;
  std::vector<const SweptState*> all;
  for (std::size_t k = 0; k < states.size(); ++k) {
    places.push_back(path.isotropic ? path.points[k].stress.mean() : path.points[k].eta);
    all.push_back(&states[k]);
  }
  if (quantity.field == estimate::Field::shear_modulus)
    add_law_band(chart, o, places, all, false);
  const bool both = std::ranges::any_of(
      states, [](const SweptState& state) { return state.answer && state.answer->sand_answer; });
  if (both)
    add_band(chart, band_of(quantity.field, places, all, sand_in), false, "sand", plot::Colour::measured);
  add_band(chart, band_of(quantity.field, places, all, both ? beads_in : answer_in), false,
           both ? "beads" : "answer");
  for (std::size_t r = 0; r < rungs.size(); ++r) {
    if (rungs[r]->name == effective::RungName::relaxed) // the answer itself
      continue;
    plot::Series series{
        .name = effective::label(*rungs[r]), .style = r, .colour = plot::Colour::uniform_strain};
    for (std::size_t k = 0; k < states.size(); ++k) {
      const auto& answer = states[k].rungs[r];
      series.add(places[k], answer ? quantity.of(*answer).value_or(nothing) : nothing);
    }
    chart.series.push_back(std::move(series));
  }
  return chart;
}

/// The first state whose answers are complete, or else the first with an answer; 0 where none has one: an
/// error of the packing occurs at every state, and is reported once.
std::size_t first_answered(const std::vector<SweptState>& states) {
  std::size_t first = 0;
  for (std::size_t k = states.size(); k-- > 0;)
    if (states[k].answer && (states[k].answer->beads_refused.empty() || !states[first].answer))
      first = k;
  return first;
}

} // namespace

ExitCode sweep_path(const SweepOptions& o, const Rungs& rungs) {
  const Outlets to = outlets_of(o);
  require_free(to);
  const Path path = make_path(o);
  const io::Columns<PathPoint> columns = SweptRows::in_units(point_columns(), o);
  std::vector<std::string> headings = io::headings_of(columns);
  for (const char* heading : {"e", "C_n", "a"})
    headings.emplace_back(heading);
  SweptRows output(o, rungs, headings, asked_of(o.inputs));
  std::vector<SweptState> states;
  Tally tally;
  for (const PathPoint& point : path.points) {
    const SweptState& state = states.emplace_back(swept(at_stress(o.inputs, point.stress), rungs));
    std::vector<io::CsvCell> cells;
    io::add_cells(cells, columns, point);
    const effective::State* packing = state.answer ? &state.answer->answer.state() : nullptr;
    for (const double number : {packing != nullptr ? packing->void_ratio : nothing,
                                packing != nullptr ? *packing->coordination_number : nothing,
                                packing != nullptr ? packing->fabric_anisotropy : nothing})
      cells.emplace_back(o.si ? number : practice_number(number));
    output.add(std::move(cells), members(columns, point), state);
    tally.count(state, fmt::format("state {}", states.size()));
  }
  const AnswerCase first = solve_answer(at_stress(o.inputs, path.points[first_answered(states)].stress), {});
  Document document = std::move(output).document(remarks_on(o, first.assumptions));
  document.title = "Stiffness along a stress path";
  add_packing(document, o.inputs, first.question.state, !known_shape(o.inputs));
  document.add(Seen::data, Data{"path", path.text});
  add_sources(document);
  document.warnings = tally.validity();
  for (const Number* end : {&o.from, &o.to})
    document.warnings.merge(likely_mistakes(*end));
  if (to.draws())
    document.add(Seen::data, Picture{{chart_of(o, path, states, rungs)}});
  return tally.conclude(deliver_sweep(to, document));
}

} // namespace granum::cli

// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cctype>
#include <cmath>
#include <filesystem>

#include <fmt/core.h>
#include <granum/core/check.hpp>
#include <granum/core/error.hpp>
#include <granum/core/number.hpp>
#include <granum/io/output_file.hpp>
#include <granum/plot/chart.hpp>
#include <granum/stress/shear_path.hpp>

#include "cli/options/likely_mistakes.hpp"
#include "sweep.hpp"

namespace granum::cli {

namespace {

using nlohmann::ordered_json;
using stress::AxialStress;
using stress::ShearPath;
namespace fs = std::filesystem;

/// A state of stress on the path.
struct PathPoint {
  AxialStress stress;
  double eta;
};

/// The path and its points.
struct Path {
  std::string text; ///< "TXC from 100 kPa to eta = 0.6"
  bool isotropic = true;
  bool logarithmic = true;
  std::vector<PathPoint> points;
};

Path isotropic_path(const SweepOptions& o) {
  if (!o.to.given())
    throw InvalidArgument("--to is missing: the mean stress at which the path ends");
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
    throw InvalidArgument("give one of --eta and --friction-angle, where the path ends");
  const ShearPath kind = shear_path(o.path);
  const double end = o.eta.given() ? o.eta.value : stress::failure_ratio(kind, o.friction_angle.value);
  (void)stress::stress_on_path(kind, o.from.value, end); // refuses the end itself, not a point before it
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
    throw InvalidArgument("--from is missing: the mean stress at which the path begins, or --table");
  return o.path == "iso" ? isotropic_path(o) : path_to_ratio(o);
}

/// Everything that the sweep found.
struct PathSweep {
  Path path;
  ordered_json inputs;
  std::vector<std::string> remarks;
  effective::State packing; ///< its stress is that of the first point
  std::vector<StateResult> results;
  Tally tally;
};

PathSweep solve(const SweepOptions& o, const Rungs& rungs) {
  const Path path = make_path(o);
  const AxialStress& first = path.points.front().stress;
  // What is wrong with the packing is wrong at the first, isotropic point too, and said once.
  PathSweep sweep{.path = path,
                  .inputs = {},
                  .remarks = {},
                  .packing = resolve_state(o.packing, {first.v, first.h}),
                  .results = {},
                  .tally = {}};
  sweep.inputs = packing_json(o.packing, sweep.packing);
  sweep.remarks = assumed_inputs(o.packing, sweep.packing);
  for (const std::string& remark : assumed_coordination(o.packing, sweep.packing))
    sweep.remarks.push_back(remark);
  for (const PathPoint& point : path.points) {
    effective::RungInputs packing{sweep.packing, resolve_mechanical_coordination_number(o.packing)};
    packing.state.stress_v = point.stress.v;
    packing.state.stress_h = point.stress.h;
    sweep.results.push_back(evaluate(packing, rungs));
    sweep.tally.count(sweep.results.back(), fmt::format("state {}", sweep.results.size()));
  }
  return sweep;
}

std::string csv_of(const PathSweep& sweep, const Rungs& rungs) {
  io::CsvContent csv;
  csv.notes = csv_notes(sweep.inputs, rungs, sweep.remarks);
  csv.notes.emplace_back("path", sweep.path.text);
  csv.headings = {"p_Pa", "q_Pa", "eta", "sigma_v_Pa", "sigma_h_Pa", "e", "C_n", "a"};
  for (const std::string& heading : result_headings(rungs))
    csv.headings.push_back(heading);
  for (std::size_t k = 0; k < sweep.results.size(); ++k) {
    const auto& [stress, eta] = sweep.path.points[k];
    csv.rows.push_back({stress.mean(), stress.deviator(), eta, stress.v, stress.h, sweep.packing.void_ratio,
                        sweep.packing.coordination_number, sweep.packing.fabric_anisotropy});
    append_cells(csv.rows.back(), sweep.results[k]);
  }
  return io::csv_text(csv);
}

ordered_json json_of(const PathSweep& sweep, const Rungs& rungs) {
  ordered_json json = sweep_json_head(sweep.inputs, rungs);
  json["path"] = sweep.path.text;
  for (std::size_t k = 0; k < sweep.results.size(); ++k) {
    const auto& [stress, eta] = sweep.path.points[k];
    ordered_json state = {{"p", stress.mean()},
                          {"q", stress.deviator()},
                          {"eta", eta},
                          {"sigma_v", stress.v},
                          {"sigma_h", stress.h}};
    add_result(state, sweep.results[k], rungs);
    json["states"].push_back(std::move(state));
  }
  json["notes"] = sweep.remarks;
  for (const std::string& note : sweep.tally.validity().notes)
    json["notes"].push_back(note);
  return json;
}

plot::Chart chart_of(const PathSweep& sweep, const Rungs& rungs, const SweptQuantity& quantity) {
  const plot::Scale scale = sweep.path.logarithmic ? plot::Scale::logarithmic : plot::Scale::linear;
  const bool modulus = quantity.dimension == Dimension::pressure;
  plot::Chart chart{
      .title = sweep.path.text, .x = {.title = "\u03b7 = q/p'"}, .y = {.title = quantity.name}, .series = {}};
  if (sweep.path.isotropic)
    chart.x = {.title = "p' [kPa]", .scale = scale, .unit = 1e3};
  if (modulus)
    chart.y = {.title = quantity.name + std::string(" [MPa]"), .scale = scale, .unit = 1e6};
  for (std::size_t r = 0; r < rungs.size(); ++r) {
    plot::Series series{.name = effective::label(*rungs[r]),
                        .x = {},
                        .y = {},
                        .style = r,
                        .colour = plot::Colour::uniform_strain};
    if (rungs[r]->name == effective::RungName::relaxed)
      series.colour = plot::Colour::closed_form;
    for (std::size_t k = 0; k < sweep.results.size(); ++k) {
      const PathPoint& point = sweep.path.points[k];
      const auto& answer = sweep.results[k].answers[r];
      series.x.push_back(sweep.path.isotropic ? point.stress.mean() : point.eta);
      series.y.push_back(answer ? quantity.of(*answer).value_or(nothing) : nothing);
    }
    chart.series.push_back(std::move(series));
  }
  return chart;
}

const SweptQuantity& pictured(const SweepOptions& o) {
  return swept_quantity(o.picture_of.empty() ? "G_hv" : o.picture_of);
}

void write_picture(const PathSweep& sweep, const Rungs& rungs, const SweepOptions& o) {
  const plot::Chart chart = chart_of(sweep, rungs, pictured(o));
  const io::Existing existing = o.output.force ? io::Existing::replace : io::Existing::keep;
  io::write_file(o.picture, plot::svg(chart), existing);
}

} // namespace

std::vector<double> spread(double first, double last, std::size_t n, bool logarithmic) {
  std::vector<double> values;
  for (std::size_t k = 0; k < n; ++k) {
    const double share = static_cast<double>(k) / static_cast<double>(n - 1);
    values.push_back(logarithmic ? first * std::pow(last / first, share) : first + (last - first) * share);
  }
  values.back() = last;
  return values;
}

ExitCode sweep_path(const SweepOptions& o, const Rungs& rungs) {
  if (!o.picture.empty()) {
    require_svg(o.picture);
    if (o.output.out.empty())
      throw InvalidArgument("--picture requires --out");
    require_free(o.output, {o.output.out, o.picture});
  }
  const PathSweep sweep = solve(o, rungs);
  Validity validity = likely_mistakes(o.packing, sweep.packing);
  validity.merge(sweep.tally.validity());
  const ExitCode code = deliver(o.output, o.output.json ? "" : csv_of(sweep, rungs),
                                o.output.json ? json_of(sweep, rungs) : ordered_json(), validity);
  if (!o.picture.empty())
    write_picture(sweep, rungs, o);
  return sweep.tally.conclude(code);
}

} // namespace granum::cli

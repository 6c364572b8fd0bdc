// SPDX-License-Identifier: GPL-3.0-or-later
#include "infer.hpp"

#include <algorithm>
#include <memory>

#include <fmt/core.h>
#include <granum/core/error.hpp>

#include "cli/estimate/answer_sections.hpp"
#include "cli/frame/help.hpp"
#include "cli/frame/messages.hpp"
#include "cli/options/input_columns.hpp"
#include "cli/options/likely_mistakes.hpp"

namespace granum::cli {

namespace {

using inverse::Quantity;

constexpr MeasuredOption options_table[] = {
    {Quantity::G_vh, "--shear-modulus", column_names::shear_modulus,
     "Shear modulus G of a vertical plane, or of an isotropic packing",
     "G g Gg gg mug modulus grainmodulus shearmodulus G0 g0 Gmax gmax"},
    {Quantity::G_hh, "--shear-modulus-hh", column_names::shear_modulus_hh,
     "Shear modulus G_hh of the horizontal plane"},
    {Quantity::K, "--bulk-modulus", column_names::bulk_modulus, "Bulk modulus K", "K k bulk"},
    {Quantity::V_s, "--shear-wave-speed,--vs", column_names::shear_wave_speed,
     "Shear wave with vertical propagation or polarisation", "v_s vs Vs shearwave"},
    {Quantity::V_s_hh, "--shear-wave-speed-hh", column_names::shear_wave_speed_hh,
     "Shear wave with horizontal propagation and polarisation"},
    {Quantity::V_p, "--compression-wave-speed,--vp", column_names::compression_wave_speed,
     "Compression wave, vertical", "v_p vp Vp pwave"},
    {Quantity::V_p_h, "--compression-wave-speed-h", column_names::compression_wave_speed_h,
     "Compression wave, horizontal"}};

void add_measured_options(Command& command, InferOptions& o) {
  constexpr const char* group = "Measured";
  for (std::size_t k = 0; k < o.measured.size(); ++k) {
    const MeasuredOption& measured = options_table[k];
    Value value = text(o.measured[k], type_name(measured.dimension()) + "[+-ERROR]");
    value.dimension = measured.dimension();
    command.add(group, {{.name = measured.option,
                         .value = std::move(value),
                         .meaning = measured.help,
                         .synonyms = {{measured.synonyms}}}});
  }
  command.add(
      group,
      {{.name = "--measurement-error",
        .value = number_without_default(o.measurement_error),
        .meaning = "Relative standard error of measurements that are given without an error, such as 2%"},
       {.name = "--table",
        .value = path(o.table, "FILE.csv"),
        .meaning = "CSV file with one or more measurements per row: p_kPa, e, V_s_m/s, V_s_error_m/s, "
                   "G_MPa, ...; or depth_m in place of the stress, for a borehole",
        .synonyms = {{"csv file input data"}}}});
}

std::vector<std::string> growth_names() {
  std::vector<std::string> names;
  for (const inverse::GrowthRule growth : inverse::all_growth_rules)
    names.emplace_back(name(growth));
  names.emplace_back(sand_growth_name);
  return names;
}

std::vector<std::string> contact_names() {
  const std::span<const std::string_view> names = inverse::unknown_contact_names();
  return {names.begin(), names.end()};
}

void add_prediction_options(Command& command, InferOptions& o) {
  Value pressures{.type = type_name(Dimension::pressure),
                  .dimension = Dimension::pressure,
                  .several = true,
                  .delimiter = ',',
                  .take = [&o](const std::string& name, const std::string& text) {
                    (void)parse_quantity(name, text, Dimension::pressure);
                    o.predict_pressure.push_back(text);
                  }};
  Value growth = choice(growth_names(), o.growth);
  growth.by_default = "sand for sands, packings for spheres";
  OptionRow uncertainty = uncertainty_row(o.uncertain);
  uncertainty.meaning = "Standard deviation of an input common to all measurements, may be repeated: "
                        "grain-shear-modulus=5%, void-ratio=0.01";
  command.add(
      "Predicted",
      {{.name = "--growth",
        .value = std::move(growth),
        .meaning = "How the stiffness changes with stress. sand: as measured on sands; packings: z* as in "
                   "packings of "
                   "spheres; fixed: constant z*; fitted: from the measurements"},
       {.name = "--contacts",
        .value = choice(contact_names(), o.contacts),
        .meaning = "Contact parameters inferred besides z*: given: none; rough: the roughness; power-law: "
                   "alpha and the softness relative to Hertz' law",
        .synonyms = {{"roughness contact law implied softness"}}},
       {.name = "--predict-pressure",
        .value = std::move(pressures),
        .meaning = "Mean stresses of the predictions, separated by commas"},
       {.name = "--predict-stress-ratio",
        .value = number_without_default(o.predict_stress_ratio),
        .meaning = "sigma_h/sigma_v of the predictions; by default that of the first measurement",
        .synonyms = {{"stressratio", "sigma_h = K_0 sigma_v"}}},
       {.name = "--predict-void-ratio",
        .value = number_without_default(o.predict_void_ratio),
        .meaning = "Predict for another packing of this void ratio, prepared in the same way"},
       std::move(uncertainty)});
}

void add_infer_options(Command& command, InferOptions& o) {
  add_measured_options(command, o);
  add_packing_options(command, o.inputs);
  add_answer_options(command, o.inputs);
  add_input(command, o.inputs, Input::k0);
  for (const char* asked : {"--coordination-number", "--mechanical-coordination-number", "--preparation"})
    command.remove(asked);
  command.row("--least-void-ratio").meaning = "Smallest void ratio e_min, for --relative-density";
  add_ground(command, o.ground, {{"--table", "--table, with a column depth_m"}});
  add_prediction_options(command, o);
  add_output_options(command, o.output);
  add_picture(command, o.picture, "Draw data, fit and prediction over the mean stress");
  add_report(command, o.report);
  std::vector<std::string> keys;
  for (const inverse::QuantityRow& row : inverse::quantities())
    keys.emplace_back(row.key);
  command.add(output_group, {{.name = "--picture-of",
                              .value = choice(keys, o.picture_of),
                              .meaning = "Quantity in the picture; by default the first measured one",
                              .needs = {{"--picture --report", "--picture or --report"}}}});
}

Quantity pictured(const InferOptions& o, const InferCase& question) {
  for (const inverse::QuantityRow& row : inverse::quantities())
    if (o.picture_of == row.key) {
      if (!is_told(question, row))
        throw InvalidArgument(fmt::format("--picture-of {}: no compression wave in wet pores", row.key));
      return row.quantity;
    }
  return question.measurements.front().quantity;
}

Inferred inferred(const InferCase& question) {
  Inferred all{.of_sand = question, .of_beads = question, .sand = {}, .beads = {}, .validity = {}};
  Validity of_sand;
  if (question.sand) {
    all.sand = inverse::infer_sand(question.measurements, *question.sand, question.sand_growth);
    of_sand = all.sand->validity();
    for (const PredictedState& predicted : question.predicted)
      of_sand.merge(doubts_of(predicted, [&] { return all.sand->doubts(predicted.state); }));
  }
  if (question.of_spheres) {
    all.beads = inverse::infer(question.measurements, question.options);
    all.validity = all.beads->validity;
    if (all.beads->together)
      all.validity.merge(complete_predictions(all.of_beads, *all.beads->together));
  }
  for (const std::string& note : of_sand.notes)
    all.validity.add((all.both() ? "sand: " : "") + note);
  return all;
}

/// The predictions for a state, from a sand or a packing of spheres.
using Forecast = std::function<Measured(const effective::State& state, inverse::AskedPacking specimen)>;

/// Data, fit and its band over the mean stress, with the kind of grains in the title.
/// \param    void_ratio_at   of the measured packing at another mean stress
plot::Chart chart_of(const InferCase& question, Quantity quantity, estimate::GrainShape shape,
                     const Forecast& forecast, const std::function<double(double)>& void_ratio_at) {
  constexpr std::size_t curve_points = 60;
  const inverse::QuantityRow& row = inverse::row_of(quantity);
  plot::Chart chart{.title = std::string(row.meaning) +
                             (shape == estimate::GrainShape::sand ? ", sand" : ", beads (spheres)"),
                    .x = {.title = "p' [kPa]", .scale = plot::Scale::logarithmic, .unit = 1e3},
                    .y = {.title = std::string(row.key) + (row.speed ? " [m/s]" : " [MPa]"),
                          .scale = plot::Scale::logarithmic,
                          .unit = row.speed ? 1 : 1e6}};
  plot::Series data{
      .name = "measured", .mark = plot::Mark::marker, .style = 1, .colour = plot::Colour::measured};
  plot::Series points{.name = "predicted",
                      .mark = plot::Mark::marker,
                      .style = 1,
                      .tone = plot::Tone::hollow,
                      .colour = plot::Colour::closed_form};
  double least = question.measurements.front().state.mean_stress(), most = least;
  const auto add = [&](plot::Series& to, const effective::State& state, const Measured& value) {
    to.add(state.mean_stress(), value.value, value.standard_error);
  };
  for (const inverse::Observation& m : question.measurements) {
    least = std::min(least, m.state.mean_stress());
    most = std::max(most, m.state.mean_stress());
    if (m.quantity == quantity)
      add(data, m.state, m.value);
  }
  for (const auto& [state, specimen] : question.predicted) {
    least = std::min(least, state.mean_stress());
    most = std::max(most, state.mean_stress());
    add(points, state, forecast(state, specimen));
  }
  if (least == most) {
    least /= 3;
    most *= 3;
  }
  if (least >= 1e6)
    chart.x = {.title = "p' [MPa]", .scale = plot::Scale::logarithmic, .unit = 1e6};
  plot::Series curve{
      .name = "fit", .mark = plot::Mark::line, .style = 0, .colour = plot::Colour::closed_form};
  plot::Series low = curve;
  low.name = "its standard error";
  low.tone = plot::Tone::faint;
  plot::Series high = low;
  high.name.clear();
  const effective::State& first = question.measurements.front().state;
  for (const double p : spread(least, most, curve_points, true)) {
    effective::State state = first;
    state.stress_v *= p / first.mean_stress();
    state.stress_h *= p / first.mean_stress();
    state.void_ratio = void_ratio_at(p);
    const Measured value = forecast(state, inverse::AskedPacking::same);
    curve.add(p, value.value);
    low.add(p, value.value - value.standard_error);
    high.add(p, value.value + value.standard_error);
  }
  chart.x.asked = points.x;
  chart.x.asked.insert(chart.x.asked.end(), data.x.begin(), data.x.end());
  for (plot::Series* series : {&curve, &low, &high, &data, &points})
    if (!series->x.empty())
      chart.series.push_back(std::move(*series));
  return chart;
}

/// Data, fit and predictions, in a chart for each kind of grains.
std::vector<plot::Chart> charts_of(const Inferred& all, Quantity of_picture) {
  std::vector<plot::Chart> charts;
  if (all.sand)
    charts.push_back(chart_of(
        all.of_sand, of_picture, estimate::GrainShape::sand,
        [&](const effective::State& state, inverse::AskedPacking) {
          return all.sand->predict(of_picture, state);
        },
        [&](double) { return all.of_sand.measurements.front().state.void_ratio; }));
  if (all.beads)
    charts.push_back(chart_of(
        all.of_beads, of_picture, estimate::GrainShape::sphere,
        [&](const effective::State& state, inverse::AskedPacking specimen) {
          return all.beads->together->predict(of_picture, state, specimen);
        },
        [&](double p) { return all.beads->together->void_ratio_at(p); }));
  return charts;
}

std::string title_text(const Inferred& all) {
  if (all.both())
    return "Sand or beads? Both follow; --grain-shape sand (or sphere) prints one of them";
  return all.sand ? "Stiffness of a sand by what was measured of it"
                  : "Contacts implied by measured stiffness";
}

ExitCode run(const InferOptions& o) {
  Outlets to{.output = o.output, .picture = o.picture, .report = o.report, .full = true, .always_csv = true};
  require_free(to);
  const InferCase question = infer_case(o);
  const Quantity of_picture = pictured(o, question);
  const Inferred all = inferred(question);
  Document document{.command = "infer", .title = title_text(all)};
  document.warnings = likely_mistakes(o.inputs, question.measurements.front().state);
  document.warnings.merge(question.ground);
  for (const std::string& pressure : o.predict_pressure)
    document.warnings.merge(
        likely_mistakes(Number{.value = parse_quantity("--predict-pressure", pressure, Dimension::pressure),
                               .dimension = Dimension::pressure,
                               .name = "--predict-pressure",
                               .typed = true}));
  document.warnings.merge(all.validity);
  add_inferred(document, all);
  if (!document.sentences.empty())
    document.sentences.emplace_back(what_an_error_means);
  const bool explained = !all.beads || all.beads->together;
  if (explained && to.draws())
    document.add(Seen::data, Picture{charts_of(all, of_picture), "Measured, fitted and forecast; from low to "
                                                                 "high is one standard error to each side."});
  add_sources(document);
  if (!explained)
    to.picture.clear();
  const ExitCode code = deliver(to, document);
  if (explained)
    return code;
  say("error", "no measurement can be explained by contacts between these grains");
  return code == ExitCode::ok ? ExitCode::fell_short : code;
}

} // namespace

Dimension MeasuredOption::dimension() const { return dimension_of(inverse::row_of(quantity)); }

std::span<const MeasuredOption> measured_options() { return options_table; }

Command make_infer() {
  auto options = std::make_shared<InferOptions>();
  Command command{
      .name = "infer",
      .meaning = "Contacts per grain from a measured modulus or wave speed, and predictions for other states",
      .notes = "Examples:\n"
               "  granum infer --void-ratio 0.6 --pressure 100kPa --vs 280m/s+-2%\n"
               "    --predict-pressure 50kPa,400kPa\n"
               "  granum infer --table speeds.csv --void-ratio 0.6",
      .run = [options] { return run(*options); }};
  add_infer_options(command, *options);
  return command;
}

} // namespace granum::cli

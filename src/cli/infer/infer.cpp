// SPDX-License-Identifier: GPL-3.0-or-later
#include "infer.hpp"

#include <memory>

#include <fmt/core.h>
#include <granum/core/error.hpp>
#include <granum/io/output_file.hpp>

#include "cli/frame/help.hpp"
#include "cli/frame/messages.hpp"
#include "cli/options/column_names.hpp"
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
                   "G_MPa, ...",
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
        .meaning =
            "Change with stress. sand: G as in measured sands; packings: z* as in packings of spheres; "
            "fixed: z* constant; fitted: from the measurements"},
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
        .synonyms = {{"k0 ko stressratio", "sigma_h = K_0 sigma_v"}}},
       {.name = "--predict-void-ratio",
        .value = number_without_default(o.predict_void_ratio),
        .meaning = "Predict for another packing of this void ratio, prepared in the same way"},
       std::move(uncertainty)});
}

void add_infer_options(Command& command, InferOptions& o) {
  add_measured_options(command, o);
  add_packing_options(command, o.packing);
  add_answer_options(command, o.grains);
  for (const char* asked : {"--coordination-number", "--mechanical-coordination-number", "--preparation"})
    command.remove(asked);
  add_prediction_options(command, o);
  add_output_options(command, o.output);
  add_picture(command, o.picture, "Draw data, fit and prediction over the mean stress");
  std::vector<std::string> keys;
  for (const inverse::QuantityRow& row : inverse::quantities())
    keys.emplace_back(row.key);
  command.add(output_group, {{.name = "--picture-of",
                              .value = choice(keys, o.picture_of),
                              .meaning = "Quantity in the picture; by default the first measured one",
                              .needs = {{"--picture"}}}});
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

/// The answer if the grains are sand.
/// \param    doubts   on the predictions
ExitCode run_sand(const InferOptions& o, const InferCase& question, const inverse::SandInference& sand,
                  const Validity& doubts, Quantity of_picture) {
  Validity validity = likely_mistakes(o.packing, question.measurements.front().state);
  validity.merge(likely_mistakes(o.grains.grain_density));
  validity.merge(sand.validity());
  validity.merge(doubts);
  std::string text = sand_inference_text(question, sand) + "\n";
  for (const std::string& note : question.assumptions)
    text += "note: " + note + "\n";
  nlohmann::ordered_json json = json_head("infer");
  json["grain_shape"] = name(estimate::GrainShape::sand);
  json["sand"] = sand_inference_json(question, sand);
  json["inputs"] = question.packing;
  json["notes"] = question.assumptions;
  const bool csv = !o.output.out.empty() && !o.output.json;
  const ExitCode code =
      deliver(o.output, csv ? sand_inference_csv(question, sand) : within_width(text), json, validity);
  if (!o.picture.empty())
    io::write_file(o.picture,
                   plot::svg(infer_chart(
                       question, of_picture,
                       [&](const effective::State& state, inverse::AskedPacking) {
                         return sand.predict(of_picture, state);
                       },
                       [&](double) { return question.measurements.front().state.void_ratio; })),
                   existing(o.output.force));
  return code;
}

ExitCode run(const InferOptions& o) {
  require_free(o.output, o.picture);
  InferCase question = infer_case(o);
  const Quantity of_picture = pictured(o, question);
  std::optional<inverse::SandInference> sand;
  Validity doubts; // of the sand
  if (question.sand) {
    sand = inverse::infer_sand(question.measurements, *question.sand, question.sand_growth);
    for (const PredictedState& predicted : question.predicted)
      doubts.merge(doubts_of(predicted, [&] { return sand->doubts(predicted.state); }));
  }
  if (!question.of_spheres)
    return run_sand(o, question, *sand, doubts, of_picture);
  const inverse::InferenceAnswer answer = inverse::infer(question.measurements, question.options);
  Validity validity = likely_mistakes(o.packing, question.measurements.front().state);
  validity.merge(likely_mistakes(o.grains.grain_density));
  validity.merge(answer.validity);
  const InferCase of_sand = question; // whose predictions keep the void ratio; spheres are compressed
  if (answer.together)
    validity.merge(complete_predictions(question, *answer.together));
  std::string text = infer_table(question, answer);
  nlohmann::ordered_json json = infer_json(question, answer);
  json["grain_shape"] = name(estimate::GrainShape::sphere);
  json["sand"] = nullptr;
  if (sand) {
    text = "The kind of grains is not given; choose with --grain-shape sand or sphere\n\n" +
           sand_inference_text(of_sand, *sand) + "\nbeads (spheres of the model)\n\n" + text;
    json["sand"] = sand_inference_json(of_sand, *sand);
    for (const std::string& note : sand->validity().notes)
      validity.add("sand: " + note);
  }
  const bool csv = !o.output.out.empty() && !o.output.json;
  const ExitCode code =
      deliver(o.output, csv ? infer_csv(question, answer) : within_width(text), json, validity);
  if (!answer.together) {
    say("error", "no measurement can be explained by contacts between these grains");
    return code == ExitCode::ok ? ExitCode::fell_short : code;
  }
  if (!o.picture.empty())
    io::write_file(o.picture,
                   plot::svg(infer_chart(
                       question, of_picture,
                       [&](const effective::State& state, inverse::AskedPacking specimen) {
                         return answer.together->predict(of_picture, state, specimen);
                       },
                       [&](double p) { return answer.together->void_ratio_at(p); })),
                   existing(o.output.force));
  return code;
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

// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cmath>

#include <fmt/format.h>
#include <granum/core/error.hpp>
#include <granum/core/text.hpp>
#include <granum/elastic/waves.hpp>
#include <granum/estimate/answer.hpp>
#include <granum/estimate/notes.hpp>
#include <granum/inverse/inference.hpp>
#include <granum/sands/pooled_law.hpp>

#include "cli/options/likely_mistakes.hpp"
#include "infer.hpp"

namespace granum::cli {

namespace {

using effective::State;
using inverse::Observation;

/// Errors of measurements without an error: speeds from arrival times, and moduli from speeds.
constexpr double assumed_speed_error = 0.02, assumed_modulus_error = 0.04;

/// Separators between a number and its error.
const std::string error_signs[] = {"+-", "\u00b1"};

bool states_error(const std::string& text) {
  return std::any_of(std::begin(error_signs), std::end(error_signs),
                     [&](const std::string& sign) { return text.find(sign) != std::string::npos; });
}

// ---- measurements

std::vector<Observation> measurements_of_options(const InferOptions& o, InferCase& question) {
  std::vector<Observation> all;
  for (std::size_t k = 0; k < o.measured.size(); ++k) {
    if (o.measured[k].empty())
      continue;
    const MeasuredOption& option = measured_options()[k];
    const std::string name(
        option.option, std::find(option.option, option.option + std::string_view(option.option).size(), ','));
    const State state = state_of(o.inputs, stresses_of(o.inputs));
    all.push_back({option.quantity,
                   parse_measured(name, o.measured[k], option.dimension(),
                                  share_of(o.measurement_error, option.dimension())),
                   state});
    note_assumed_error(o, question, states_error(o.measured[k]));
  }
  if (all.empty())
    throw InvalidArgument(
        "no measurement is given: use --shear-modulus, --vs, --vp, --bulk-modulus, or --table");
  return all;
}

// ---- uncertain inputs

/// The uncertain inputs that all measurements of spheres have in common.
std::vector<estimate::UncertainInput> uncertain_inputs_of(const InferOptions& o, const InputValues& values) {
  const std::vector<const estimate::InputRow*> shared = inverse::shared_rows(values);
  std::vector<estimate::UncertainInput> uncertain =
      uncertain_inputs(values, deviations_of(o.uncertain, values, shared,
                                             "not an input common to all measurements; these are"));
  std::erase_if(uncertain, [&](const estimate::UncertainInput& one) {
    return std::find(shared.begin(), shared.end(), &estimate::uncertain_row(one.input)) == shared.end();
  });
  return uncertain;
}

/// The deviations that a name, such as that of a mineral, brings along; those of defaults are in their notes.
void note_implied_deviations(const InputValues& values,
                             const std::vector<estimate::UncertainInput>& uncertain,
                             estimate::Notes& assumptions) {
  for (const estimate::UncertainInput& one : uncertain)
    if (const estimate::InputRow& row = estimate::uncertain_row(one.input);
        one.assumed && values.given(row.input))
      add_sentence(assumptions, fmt::format("standard deviation of {}: {}", one.input,
                                            pretty(one.deviation, row.dimension)));
}

// ---- predictions

std::vector<PredictedState> predicted_states(const InferOptions& o, const State& first) {
  std::vector<double> pressures;
  for (const std::string& text : o.predict_pressure)
    pressures.push_back(require_positive(
        "--predict-pressure", parse_quantity("--predict-pressure", text, Dimension::pressure), "Pa"));
  if (pressures.empty())
    pressures.push_back(first.mean_stress());
  double ratio = first.stress_h / first.stress_v;
  if (o.predict_stress_ratio.given()) {
    ratio = o.predict_stress_ratio.value;
    estimate::require_within(estimate::row_of(Input::k0), ratio, o.predict_stress_ratio.name);
  }
  std::vector<PredictedState> states;
  for (const double p : pressures) {
    PredictedState predicted{.state = first};
    predicted.state.stress_v = 3 * p / (1 + 2 * ratio);
    predicted.state.stress_h = ratio * predicted.state.stress_v;
    if (o.predict_void_ratio.given()) {
      predicted.state.void_ratio = require_positive(o.predict_void_ratio.name, o.predict_void_ratio.value);
      predicted.specimen = inverse::AskedPacking::prepared_alike;
    }
    states.push_back(predicted);
  }
  return states;
}

} // namespace

namespace {

const std::string fitted_growth(name(inverse::GrowthRule::fitted));

/// The option, or the column, that gives the kind of grains; as known_shape.
std::string source_of_shape(const InputValues& values) {
  if (values.grain_shape)
    return fmt::format("--grain-shape {}", name(*values.grain_shape));
  if (values.known_sand != nullptr)
    return fmt::format("--sand {}", values.known_sand->key);
  InputValues unnamed = values;
  unnamed.minerals.clear();
  if (known_shape(unnamed) != known_shape(values))
    return fmt::format("--grain {}", contact::text_of(values.minerals));
  for (const estimate::InputRow& row : estimate::inputs())
    if (row.implies == known_shape(values) && values.given(row.input))
      return row.input == Input::contact ? fmt::format("{} {}", row.option(), name(values.contact))
                                         : row.option();
  return "";
}

const char* plural(estimate::GrainShape shape) {
  return shape == estimate::GrainShape::sand ? "sands" : "spheres";
}

bool of_spheres_alone(const std::string& growth) {
  return growth == name(inverse::GrowthRule::packings) || growth == name(inverse::GrowthRule::fixed);
}

/// Sand, spheres or both, and the known properties of the sand.
void resolve_shape(const InferOptions& o, const InputValues& values, InferCase& question) {
  using estimate::GrainShape;
  std::optional<GrainShape> shape = known_shape(values);
  const std::optional<GrainShape> of_growth = o.growth == sand_growth_name ? std::optional(GrainShape::sand)
                                              : of_spheres_alone(o.growth) ? std::optional(GrainShape::sphere)
                                                                           : std::nullopt;
  if (shape && of_growth && shape != of_growth)
    throw InvalidArgument(fmt::format("--growth {} applies to {}, and {} to {}: leave one of them out",
                                      o.growth, plural(*of_growth), source_of_shape(values), plural(*shape)));
  if (of_growth)
    shape = of_growth;
  if (!shape && (!o.uncertain.empty() || o.contacts != "given"))
    shape = GrainShape::sphere; // a sand would ignore them
  question.of_spheres = shape != GrainShape::sand;
  if (shape == GrainShape::sphere)
    return;
  const InputValues sand = as_sand(values); // its grains are quartz unless others are given
  constexpr double any_stress = 1e5;        // that of the measurement follows
  State state = state_of(sand, {any_stress, any_stress});
  const State& measured = question.measurements.front().state;
  state.void_ratio = measured.void_ratio;
  state.stress_v = measured.stress_v;
  state.stress_h = measured.stress_h;
  question.sand = {.state = std::move(state),
                   .grain_density = sand.number(Input::grain_density),
                   .saturation = sand.within(Input::saturation),
                   .grain_shape = GrainShape::sand,
                   .sand = sand_of(sand)};
  question.sand_growth =
      o.growth == fitted_growth ? inverse::SandGrowth::fitted : inverse::SandGrowth::measured;
}

/// \throws   InvalidArgument for an option that a sand would ignore
void require_options_of_sand(const InferOptions& o) {
  const std::pair<bool, const char*> of_spheres[] = {
      {!o.uncertain.empty(), "--uncertainty"},
      {o.contacts != "given", "--contacts"},
      {o.inputs.given(Input::rattler_fraction), "--rattler-fraction"}};
  for (const auto& [given, option] : of_spheres)
    if (given)
      throw InvalidArgument(
          std::string(option) +
          " applies to the model of spheres, not to a sand; leave it out, or give --grain-shape sphere");
}

} // namespace

double share_of(const Number& error, Dimension dimension) {
  if (error.given())
    return require_closed(error.name, error.value, 0, 1);
  return dimension == Dimension::speed ? assumed_speed_error : assumed_modulus_error;
}

void note_assumed_error(const InferOptions& o, InferCase& question, bool stated) {
  const estimate::Note note{.name = "--measurement-error",
                            .value = "2 % of speeds, 4 % of moduli",
                            .reason = "where none is given"};
  if (!stated && !o.measurement_error.given() &&
      std::find(question.assumptions.begin(), question.assumptions.end(), note) == question.assumptions.end())
    question.assumptions.push_back(note);
}

Measured parse_measured(const std::string& name, const std::string& text, Dimension dimension,
                        double relative_error) {
  for (const std::string& sign : error_signs) {
    const std::size_t split = text.find(sign);
    if (split == std::string::npos)
      continue;
    const std::string error = text.substr(split + sign.size());
    const bool share = std::string_view(trimmed(error)).ends_with('%');
    std::string number = text.substr(0, split);
    if (const auto size = leading_number(trimmed(error)); size && !share && parse_number(number))
      number += size->rest; // in 280+-5m/s both are speeds
    const double value = parse_quantity(name, number, dimension);
    const double size = parse_quantity(name + " error", error, share ? Dimension::dimensionless : dimension);
    return {value, require_non_negative(name + " error", share ? size * std::abs(value) : size,
                                        std::string(si_symbol(dimension)))};
  }
  const double value = parse_quantity(name, text, dimension);
  return {value, relative_error * std::abs(value)};
}

Validity doubts_of(const PredictedState& predicted, const std::function<Validity()>& doubts) {
  const std::string place =
      fmt::format("prediction at p' = {}: ", pretty(predicted.state.mean_stress(), Dimension::pressure));
  Validity placed;
  try {
    for (const std::string& note : doubts().notes)
      placed.add(place + note);
  } catch (const InvalidArgument& error) {
    const auto& refused = error.refused();
    if (predicted.specimen == inverse::AskedPacking::prepared_alike && refused) {
      if (refused->name == "void_ratio")
        throw InvalidArgument("--predict-void-ratio", refused->value, refused->unit, refused->range);
      if (refused->name == "relative_density")
        throw InvalidArgument(
            fmt::format("--predict-void-ratio {}: {}", short_text(predicted.state.void_ratio), error.what()));
    }
    throw InvalidArgument(place + error.what());
  }
  return placed;
}

Validity complete_predictions(InferCase& question, const inverse::Inference& fit) {
  const State& measured = question.measurements.front().state;
  Validity doubts;
  for (PredictedState& predicted : question.predicted) {
    State& state = predicted.state;
    const bool same = predicted.specimen == inverse::AskedPacking::same;
    const double p = state.mean_stress();
    if (same)
      state.void_ratio = fit.void_ratio_at(p);
    if (!(state.void_ratio > 0))
      throw InvalidArgument(
          fmt::format("--predict-pressure = {}: at this stress the packing would be denser than its "
                      "grains (void ratio {}); --growth fixed keeps its void ratio",
                      pretty(p, Dimension::pressure), short_text(state.void_ratio)));
    const Validity here = doubts_of(predicted, [&] { return fit.doubts(state, predicted.specimen); });
    if (!same || p != measured.mean_stress()) // the notes on the measurements are reported with them
      doubts.merge(here);
  }
  return doubts;
}

namespace {

/// What the level of a sand is measured against.
void note_average_sand(const InputValues& values, InferCase& question) {
  add_sentence(question.assumptions,
               "sand: level 1 is G = " + sands::formula(question.sand->sand) +
                   ", p_a = 100 kPa, with the inferred s in place of that of average sands [Lo2021]",
               "Lo2021");
  for (const auto& [mineral, share] : values.minerals)
    add_sentence(question.assumptions,
                 std::string("grains of ") + mineral->name + " [" + mineral->source + "]", mineral->source);
}

} // namespace

InferCase infer_case(const InferOptions& given) {
  InferOptions o = given;
  InferCase question;
  if (o.table.empty()) {
    o.inputs = estimate::completed(std::move(o.inputs));
    question.measurements = measurements_of_options(o, question);
  }
  const InputValues values = o.table.empty() ? o.inputs : read_table(o, question);
  const State& first = question.measurements.front().state;
  resolve_shape(o, values, question);
  std::vector<estimate::UncertainInput> uncertain;
  if (question.of_spheres) {
    uncertain = uncertain_inputs_of(o, values);
    std::ranges::copy(assumed_of_spheres(values, first, uncertain), std::back_inserter(question.assumptions));
  } else
    require_options_of_sand(o);
  if (const std::optional<estimate::Note> density = assumed_density(values, uncertain))
    question.assumptions.push_back(*density);
  note_implied_deviations(values, uncertain, question.assumptions);
  if (question.sand)
    note_average_sand(values, question);
  question.packing = packing_json(question.of_spheres ? values : as_sand(values), first);
  if (question.of_spheres && question.sand)
    question.sand_packing = packing_json(as_sand(values), first);
  question.options = {
      .grain_density = values.number(Input::grain_density),
      .pore_density = elastic::water_density * values.within(Input::saturation),
      .growth = of_spheres_alone(o.growth) || o.growth == fitted_growth ? inverse::growth_rule_of(o.growth)
                                                                        : inverse::GrowthRule::packings,
      .inputs = question.of_spheres ? inverse::shared_inputs(values, uncertain) : inverse::SharedInputs{},
      .contacts = inverse::unknown_contacts(o.contacts)};
  if (o.contacts != "given" && o.inputs.contact != contact::Shape::sphere)
    throw InvalidArgument("--contacts " + o.contacts +
                          ": infers a contact law that replaces smooth spheres; leave "
                          "--contact out, or use --contacts given");
  question.options.rattler_fraction = o.inputs.if_given(Input::rattler_fraction);
  question.predicted = predicted_states(o, first);
  return question;
}

} // namespace granum::cli

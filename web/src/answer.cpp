// SPDX-License-Identifier: GPL-3.0-or-later
// The calculator's answer, the ladder below it, and the inference from a measurement.
#include <cmath>
#include <optional>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include <granum/core/error.hpp>
#include <granum/effective/rungs.hpp>
#include <granum/estimate/answer.hpp>
#include <granum/inverse/inference.hpp>

#include "answers.hpp"
#include "cli/options/slips.hpp"
#include "exports.hpp"

namespace granum::web {

void add(const std::optional<estimate::Range>& range) {
  const estimate::Range of = range.value_or(estimate::Range{nothing, nothing, nothing});
  numbers().insert(numbers().end(), {of.value, of.low, of.high});
}

void add(const Measured& number) { numbers().insert(numbers().end(), {number.value, number.standard_error}); }

void add(const estimate::Answer& answer) {
  for (const estimate::FieldRow& row : estimate::fields())
    add(answer.find(row.field));
  std::string names;
  for (const estimate::Share& share : answer.shares()) {
    numbers().push_back(share.share);
    names += share.input + "\n";
  }
  say(answer.validity());
  words() = names + words();
}

void add_answer(const estimate::InputValues& known) {
  const estimate::InputValues values = completed(known);
  std::vector<estimate::Spread> spreads; // a module that catches nothing cannot try smaller deviations
  for (const estimate::UncertainInput& one : uncertain_inputs(values, estimate::Deviations{}))
    spreads.push_back({.input = one.input,
                       .assumed = one.assumed,
                       .less = one.moved(-one.deviation),
                       .more = one.moved(one.deviation)});
  add(estimate::answer(question_of(values), spreads));
}

void give(estimate::InputValues& values, estimate::Input input, double number) {
  if (!std::isnan(number))
    values.give(input, number);
}

inverse::Quantity quantity_of(double place) {
  if (!(place >= 0) || !(place < static_cast<double>(inverse::quantities().size())))
    throw InvalidArgument("quantity", place, "", "the index of a measurable quantity");
  return inverse::quantities()[static_cast<std::size_t>(place)].quantity;
}

double step_of_pressure(double low, double high, double k, double points) {
  return low * std::pow(high / low, k / (points - 1));
}

} // namespace granum::web

namespace {

using namespace granum;
using web::add;
using web::nothing;
using web::quantity_of;

/// The last inference, and the state of its measurement.
struct Inferred {
  inverse::Inference packing;
  effective::State measured;
};
std::optional<Inferred> last_inferred;

/// The packing of the last inference at another pressure.
effective::State elsewhere(const Inferred& inferred, double pressure) {
  effective::State there = inferred.measured;
  there.stress_v = there.stress_h = pressure;
  there.void_ratio = inferred.packing.void_ratio_at(pressure);
  return there;
}

effective::Preparation preparation_of(double number) {
  using Kind = effective::Preparation::Kind;
  for (const Kind kind : {Kind::unknown, Kind::dense, Kind::loose})
    if (number == static_cast<double>(kind))
      return {.kind = kind};
  throw InvalidArgument("preparation", number, "", "0 (unknown), 1 (dense) or 2 (loose)");
}

/// The state of a packing, without its contacts.
effective::State state_of(const web::PageGrain& grain, double void_ratio, double anisotropy, double stress_v,
                          double stress_h) {
  return {.law = web::law_of(grain),
          .tangential_ratio = contact::mindlin_stiffness_ratio(grain.poisson_ratio),
          .radius = grain.radius,
          .void_ratio = void_ratio,
          .fabric_anisotropy = anisotropy,
          .stress_v = stress_v,
          .stress_h = stress_h};
}

} // namespace

/// The keys of the numbers of an answer, one line each.
GRANUM_EXPORT(answer_keys) void answer_keys() {
  for (const estimate::FieldRow& row : estimate::fields())
    web::words() += std::string(row.key) + "\n";
}

/// The inputs that have a default with a deviation, whatever the stress: their names as arguments, one
/// line each; as numbers the deviations.
GRANUM_EXPORT(assumed_inputs) void assumed_inputs() {
  for (const estimate::InputRow& row : estimate::inputs())
    if (row.deviation != nullptr && row.input != estimate::Input::fabric) {
      web::words() += std::string(row.name()) + "\n";
      web::numbers().push_back(row.deviation({}));
    }
}

/// The answer for beads. NaN for what is not given: it has its default, with the deviation of that;
/// saturation is a share.
GRANUM_EXPORT(answer)
void answer(double shape, double shear_modulus, double poisson_ratio, double radius, double first_number,
            double second_number, double void_ratio, double anisotropy, double stress_v, double stress_h,
            double preparation, double mechanical_coordination_number, double grain_density,
            double saturation) {
  using estimate::Input;
  estimate::InputValues known;
  known.give(Input::contact, std::string(name(web::shape_of(shape))));
  for (const estimate::InputRow& row : estimate::inputs())
    if (row.law != nullptr && row.law->shape == known.contact) {
      known.give(row.input, first_number);
      first_number = second_number;
    }
  const std::pair<Input, double> numbers[] = {
      {Input::grain_shear_modulus, shear_modulus},
      {Input::grain_poisson_ratio, poisson_ratio},
      {Input::radius, radius},
      {Input::void_ratio, void_ratio},
      {Input::fabric, anisotropy},
      {Input::stress_v, stress_v},
      {Input::stress_h, stress_h},
      {Input::mechanical_coordination_number, mechanical_coordination_number},
      {Input::grain_density, grain_density},
      {Input::saturation, saturation}};
  for (const auto& [input, number] : numbers)
    web::give(known, input, number);
  known.preparation = preparation_of(preparation);
  web::add_answer(known);
}

/// Numbers of the calculator that are probably mistakes in unit or symbol, in the words of the program; NaN
/// for those that are not typed. `graded` is 1 for grains of several sizes.
GRANUM_EXPORT(slips)
void slips(double shape, double shear_modulus, double poisson_ratio, double radius, double first_number,
           double second_number, double void_ratio, double graded, double stress_v, double stress_h,
           double mechanical_coordination_number, double grain_density) {
  Validity validity;
  if (!std::isnan(void_ratio))
    cli::judge_void_ratio({"--void-ratio", void_ratio}, graded == 1, validity);
  if (!std::isnan(mechanical_coordination_number))
    cli::judge_contacts({"--mechanical-coordination-number", mechanical_coordination_number}, true,
                        state_of({shape, shear_modulus, poisson_ratio, radius, first_number, second_number},
                                 void_ratio, 0, stress_v, stress_h),
                        validity);
  if (stress_v == stress_h)
    cli::judge_stress({"--pressure", stress_v, Dimension::pressure}, validity);
  else {
    cli::judge_stress({"--stress-v", stress_v, Dimension::pressure}, validity);
    cli::judge_stress({"--stress-h", stress_h, Dimension::pressure}, validity);
  }
  if (!std::isnan(radius))
    cli::judge_length({"--radius", radius, Dimension::length}, validity);
  if (!std::isnan(shear_modulus))
    cli::judge_modulus({"--grain-shear-modulus", shear_modulus, Dimension::pressure}, validity);
  cli::judge_density({"--grain-density", grain_density, Dimension::density}, validity);
  web::say(validity);
}

/// G_vh and its relative error (NaN if the rung states none) of every closed form, at the given contacts; the
/// words are their labels.
GRANUM_EXPORT(ladder)
void ladder(double shape, double shear_modulus, double poisson_ratio, double radius, double first_number,
            double second_number, double void_ratio, double anisotropy, double stress_v, double stress_h,
            double coordination_number, double mechanical_coordination_number) {
  effective::State packing =
      state_of({shape, shear_modulus, poisson_ratio, radius, first_number, second_number}, void_ratio,
               anisotropy, stress_v, stress_h);
  packing.coordination_number = coordination_number;
  packing.mechanical_coordination_number = mechanical_coordination_number;
  for (const effective::Rung& rung : effective::closed_forms()) {
    const effective::RungAnswer found = effective::answer(rung, packing);
    web::numbers().push_back(found.stiffness.G_vh());
    web::numbers().push_back(found.relative_error ? found.relative_error->G_vh : nothing);
    web::words() += effective::label(rung) + "\n";
  }
}

/// The contacts of an isotropic packing inferred from one measured number: 1 if contacts explain it, else 0
/// and no further numbers; z*, C_n and, at another pressure, z*, e, G, V_s and V_p, each except e with its
/// standard error; then the shares of the variance of z*, whose names are the first words. Quantities are
/// given by their index in inverse::quantities.
GRANUM_EXPORT(infer)
void infer(double shape, double shear_modulus, double poisson_ratio, double radius, double first_number,
           double second_number, double void_ratio, double pressure, double grain_density, double quantity,
           double value, double relative_error, double other_pressure) {
  const inverse::Observation measured{
      .quantity = quantity_of(quantity),
      .value = {value, relative_error * value},
      .state = state_of({shape, shear_modulus, poisson_ratio, radius, first_number, second_number},
                        void_ratio, 0, pressure, pressure)};
  const inverse::InferenceAnswer found =
      inverse::infer(std::span(&measured, 1), {.grain_density = grain_density});
  web::say(found.validity);
  web::numbers() = {found.together ? 1.0 : 0.0};
  last_inferred.reset();
  if (!found.together)
    return;
  last_inferred.emplace(Inferred{*found.together, measured.state});
  const inverse::Inference& packing = last_inferred->packing;
  const effective::State there = elsewhere(*last_inferred, other_pressure);
  const inverse::InferredPacking contacts = packing.packing(measured.state);
  add(contacts.mechanical_coordination_number);
  add(contacts.coordination_number);
  add(packing.packing(there).mechanical_coordination_number);
  web::numbers().push_back(there.void_ratio);
  for (const inverse::Quantity wanted :
       {inverse::Quantity::G_vh, inverse::Quantity::V_s, inverse::Quantity::V_p})
    add(packing.predict(wanted, there));
  std::string names;
  for (const inverse::ErrorShare& share : packing.error_shares()) {
    web::numbers().push_back(share.share);
    names += share.source + "\n";
  }
  web::words() = names + web::words();
}

/// A quantity and its standard error according to the last `infer`, at a number of pressures from low to
/// high, in equal steps of the logarithm: pressure, value, error.
/// \throws   Error without an inference
GRANUM_EXPORT(inferred_path) void inferred_path(double quantity, double low, double high, double points) {
  if (!last_inferred)
    throw Error("nothing was inferred yet");
  for (double k = 0; k < points; ++k) {
    const double pressure = web::step_of_pressure(low, high, k, points);
    web::numbers().push_back(pressure);
    add(last_inferred->packing.predict(quantity_of(quantity), elsewhere(*last_inferred, pressure)));
  }
}

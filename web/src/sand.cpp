// SPDX-License-Identifier: GPL-3.0-or-later
// The calculator's answer for a sand, published laws beside it, and the forecast from a measurement. The
// grains are of quartz, as the program assumes for sands.
#include <cmath>
#include <optional>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include <granum/contact/grains.hpp>
#include <granum/contact/power_law.hpp>
#include <granum/core/error.hpp>
#include <granum/estimate/answer.hpp>
#include <granum/inverse/sand_inference.hpp>
#include <granum/sands/known_sands.hpp>

#include "answers.hpp"
#include "exports.hpp"

namespace {

using namespace granum;

/// The last inference, and the state of its measurement.
struct Inferred {
  inverse::SandInference sand;
  effective::State measured;
};
std::optional<Inferred> last_inferred;

std::optional<double> given(double number) {
  return std::isnan(number) ? std::nullopt : std::optional<double>(number);
}

/// \param    place   index in sands::known_sands(), or -1 for a sand without a name: null
/// \throws   InvalidArgument
const sands::KnownSand* known_at(double place) {
  if (place == -1)
    return nullptr;
  if (!(place >= 0 && place < static_cast<double>(sands::known_sands().size())))
    throw InvalidArgument("sand", place, "", "an index in the table of sands, or -1");
  return &sands::known_sands()[static_cast<std::size_t>(place)];
}

/// \param    place   as known_at; without a name with the numbers that follow
sands::Sand sand_of(double place, double uniformity, double least_void_ratio, double largest_void_ratio) {
  if (const sands::KnownSand* const named = known_at(place))
    return sands::sand_of(*named);
  return {.uniformity = given(uniformity),
          .least_void_ratio = given(least_void_ratio),
          .largest_void_ratio = given(largest_void_ratio)};
}

contact::GrainMaterial quartz() { return contact::mineral("quartz").material; }

effective::State state_of(const contact::GrainMaterial& grain, double void_ratio, double stress_v,
                          double stress_h) {
  constexpr double radius = 0.1e-3; // no number of an answer depends on it
  return {.law = contact::PowerLaw::sphere(grain, radius),
          .tangential_ratio = contact::mindlin_stiffness_ratio(grain.poisson_ratio),
          .radius = radius,
          .void_ratio = void_ratio,
          .stress_v = stress_v,
          .stress_h = stress_h};
}

/// The same sand at a state after an inference.
effective::State elsewhere(const effective::State& measured, double pressure) {
  effective::State there = measured;
  there.stress_v = there.stress_h = pressure;
  return there;
}

} // namespace

/// The sands with a name: key and name of each in one line, separated by a tab; as numbers e_min and e_max.
GRANUM_EXPORT(known_sands) void known_sands() {
  for (const sands::KnownSand& sand : sands::known_sands()) {
    web::words() += std::string(sand.key) + "\t" + sand.name + "\n";
    web::numbers().push_back(sand.least_void_ratio.value_or(web::nothing));
    web::numbers().push_back(sand.largest_void_ratio.value_or(web::nothing));
  }
}

/// The void ratio at a relative density.
GRANUM_EXPORT(void_ratio)
void void_ratio(double relative_density, double least_void_ratio, double largest_void_ratio) {
  web::numbers() = {
      sands::void_ratio_of_relative_density(relative_density, least_void_ratio, largest_void_ratio)};
}

/// The answer for a sand. NaN for what is not known, and for no shear strain.
GRANUM_EXPORT(sand_answer)
void sand_answer(double place, double uniformity, double least_void_ratio, double largest_void_ratio,
                 double void_ratio, double stress_v, double stress_h, double grain_density, double saturation,
                 double shear_strain) {
  using estimate::Input;
  estimate::InputValues known;
  known.grain_shape = estimate::GrainShape::sand;
  if (const sands::KnownSand* const named = known_at(place))
    known.give(Input::sand, std::string(named->key));
  else
    for (const auto& [input, number] : {std::pair{Input::uniformity, uniformity},
                                        {Input::least_void_ratio, least_void_ratio},
                                        {Input::largest_void_ratio, largest_void_ratio}})
      web::give(known, input, number);
  for (const auto& [input, number] : {std::pair{Input::void_ratio, void_ratio},
                                      {Input::stress_v, stress_v},
                                      {Input::stress_h, stress_h},
                                      {Input::grain_density, grain_density},
                                      {Input::saturation, saturation},
                                      {Input::shear_strain, shear_strain}})
    web::give(known, input, number);
  web::add_answer(known);
}

/// The keys of the published laws, one line each.
GRANUM_EXPORT(sand_laws) void sand_laws() {
  for (const sands::MeasuredLaw& law : sands::measured_laws())
    web::words() += std::string(law.key) + "\n";
}

/// G by a published law at mean stresses from low to high, in equal steps of the logarithm; then G at the
/// middle of the logarithms, and 1 if the law was tested there.
/// \throws   InvalidArgument where the law has no modulus
GRANUM_EXPORT(sand_law)
void sand_law(double law, double place, double uniformity, double void_ratio, double low, double high,
              double points) {
  if (!(law >= 0 && law < static_cast<double>(sands::measured_laws().size())))
    throw InvalidArgument("law", law, "", "an index in the table of laws of sands");
  const sands::MeasuredLaw& row = sands::measured_laws()[static_cast<std::size_t>(law)];
  const sands::Sand sand = sand_of(place, uniformity, web::nothing, web::nothing);
  sands::SandState state{.void_ratio = void_ratio,
                         .uniformity = sand.uniformity.value_or(sands::uniform_sand)};
  state.d50 = sand.d50.value_or(state.d50);
  for (double k = 0; k < points; ++k) {
    state.mean_stress = web::step_of_pressure(low, high, k, points);
    web::numbers().push_back(sands::shear_modulus(row, state).shear_modulus);
  }
  state.mean_stress = std::sqrt(low * high);
  const sands::SandModulus middle = sands::shear_modulus(row, state);
  web::numbers().insert(web::numbers().end(), {middle.shear_modulus, middle.validity.ok() ? 1.0 : 0.0});
}

/// A sand with one measured number under isotropic stress, dry: its level, s and Poisson's ratio with their
/// standard errors; z* and contact softness there, as value, low and high; G, V_s and V_p at another
/// pressure, each with its standard error; 1 if the measurement determines the contacts. Quantities are given
/// by their index in inverse::quantities.
GRANUM_EXPORT(infer_sand)
void infer_sand(double place, double uniformity, double least_void_ratio, double largest_void_ratio,
                double void_ratio, double pressure, double grain_density, double quantity, double value,
                double relative_error, double other_pressure) {
  last_inferred.reset();
  const inverse::Observation measured{.quantity = web::quantity_of(quantity),
                                      .value = {value, relative_error * value},
                                      .state = state_of(quartz(), void_ratio, pressure, pressure)};
  inverse::SandInference sand = inverse::infer_sand(
      std::span(&measured, 1), {.state = measured.state,
                                .grain_density = grain_density,
                                .grain_shape = estimate::GrainShape::sand,
                                .sand = sand_of(place, uniformity, least_void_ratio, largest_void_ratio)});
  for (const Measured& number : {sand.level(), sand.exponent(), sand.poisson_ratio()})
    web::add(number);
  using estimate::Field;
  for (const Field field : {Field::mechanical_coordination_number, Field::contact_softness})
    web::add(sand.contacts(field, measured.state));
  const effective::State there = elsewhere(measured.state, other_pressure);
  for (const inverse::Quantity wanted :
       {inverse::Quantity::G_vh, inverse::Quantity::V_s, inverse::Quantity::V_p})
    web::add(sand.predict(wanted, there));
  web::numbers().push_back(sand.tells_contacts() ? 1 : 0);
  Validity notes = sand.validity();
  notes.merge(sand.doubts(there));
  notes.keep_each_once();
  web::say(notes);
  last_inferred.emplace(Inferred{std::move(sand), measured.state});
}

/// As inferred_path, according to the last infer_sand.
/// \throws   Error without an inference
GRANUM_EXPORT(inferred_sand_path)
void inferred_sand_path(double quantity, double low, double high, double points) {
  if (!last_inferred)
    throw Error("nothing was inferred yet");
  for (double k = 0; k < points; ++k) {
    const double pressure = web::step_of_pressure(low, high, k, points);
    web::numbers().push_back(pressure);
    web::add(last_inferred->sand.predict(web::quantity_of(quantity),
                                         elsewhere(last_inferred->measured, pressure)));
  }
}

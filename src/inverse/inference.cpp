// SPDX-License-Identifier: GPL-3.0-or-later
#include <granum/inverse/inference.hpp>

#include <algorithm>
#include <cmath>
#include <utility>

#include <granum/core/error.hpp>
#include <granum/core/stop.hpp>
#include <granum/core/text.hpp>
#include <granum/effective/contact_prior.hpp>
#include <granum/elastic/waves.hpp>
#include <granum/estimate/answer.hpp>

#include "contact_model.hpp"

namespace granum::inverse {

namespace {

using effective::Explained;

/// Probability below which deviations count as a contradiction.
constexpr double improbable = 0.003;
/// A starting z* from which the least squares converge.
constexpr double any_contacts = 5;

double bulk_density(const Observation& m, const InferenceOptions& options) {
  return elastic::bulk_density({.grain_density = *options.grain_density,
                                .void_ratio = m.state.void_ratio,
                                .pore_density = detail::pore_density(options, m.saturation)});
}

double modulus_of(const Observation& m, const InferenceOptions& options) {
  if (!row_of(m.quantity).speed)
    return m.value.value;
  const double modulus = bulk_density(m, options) * m.value.value * m.value.value;
  if (!(modulus > 0 && std::isfinite(modulus)))
    throw InvalidArgument(std::string(row_of(m.quantity).key) + " = " + short_text(m.value.value) +
                          " m/s implies a modulus that exceeds the range of a double");
  return modulus;
}

std::string named(const Observation& m) {
  const QuantityRow& row = row_of(m.quantity);
  const double p = m.state.mean_stress();
  const std::string value = row.speed ? granum::detail::formatted("%.4g m/s", m.value.value)
                                      : granum::detail::formatted("%.4g MPa", m.value.value / 1e6);
  return std::string(row.key) + " = " + value + granum::detail::formatted(" at %.4g kPa", p / 1e3);
}

std::string bound_text(const Observation& m, const InferenceOptions& options, double bound) {
  if (!row_of(m.quantity).speed)
    return granum::detail::formatted("%.4g MPa", bound / 1e6);
  return granum::detail::formatted("%.4g m/s", std::sqrt(bound / bulk_density(m, options)));
}

void note_unexplained(const Observation& m, const InferenceOptions& options,
                      const effective::ImpliedCoordination& implied, Validity& validity) {
  if (implied.explained == Explained::too_stiff)
    validity.add("no coordination number explains " + named(m) +
                 ": with 12 contacts per grain, the largest number for equal "
                 "spheres, it would be " +
                 bound_text(m, options, implied.stiffest) +
                 "; the grains may be bonded, flat at their contacts, or stiffer than given");
  if (implied.explained == Explained::too_soft)
    validity.add("no coordination number explains " + named(m) +
                 ": the loosest rigid network of contacts "
                 "would have " +
                 bound_text(m, options, implied.softest) +
                 "; the contacts may be rough or damaged, or the grains softer than given");
}

/// A measured state without its contacts, which are to be inferred.
effective::State uncounted(effective::State state) {
  state.coordination_number.reset();
  state.mechanical_coordination_number.reset();
  return state;
}

/// Notes on the states; only those of the first are listed, since a table may have thousands.
void note_states(const Inference& all, std::span<const Observation> measurements, Validity& validity) {
  std::size_t noted = 0;
  for (const Observation& m : measurements) {
    stop_point();
    const Validity own = all.doubts(uncounted(m.state));
    if (!own.ok() && ++noted == 1)
      validity.merge(own);
  }
  if (noted > 1)
    validity.add(granum::detail::formatted("notes of this kind apply to %.0f of %.0f measurements",
                                           static_cast<double>(noted),
                                           static_cast<double>(measurements.size())));
}

/// Adds a note if the coordination number is unusual for packings of that void ratio.
void note_density(const Inference& all, const effective::State& first, Validity& validity) {
  const effective::ContactPrior prior = effective::contact_prior(first);
  const Measured z = all.packing(first).mechanical_coordination_number;
  const double room = 2 * std::hypot(z.standard_error, prior.coordination_error);
  const double most = prior.densest.mechanical_coordination_number;
  const double least = prior.loosest.mechanical_coordination_number;
  if (z.value > most + room || z.value < least - room)
    validity.add(granum::detail::formatted(
                     "z* = %.3g is %s than in packings of spheres of void ratio %.3g at "
                     "this stress, %.3g to %.3g: ",
                     z.value, z.value > most ? "larger" : "smaller", first.void_ratio, least, most) +
                 (z.value > most ? "grains of other shape have more contacts, or their contacts are stiffer"
                                 : "their contacts may be softer than given, or the grains crushed"));
}

void note_contradiction(const Inference& all, std::span<const Observation> measurements, Validity& validity) {
  if (all.probability() >= improbable)
    return;
  std::size_t worst = 0;
  for (std::size_t k = 1; k < measurements.size(); ++k)
    if (std::abs(all.measurements()[k].deviation) > std::abs(all.measurements()[worst].deviation))
      worst = k;
  const double deviation = all.measurements()[worst].deviation;
  validity.add(
      "the measurements contradict each other: no single coordination number explains them all within their "
      "errors and that of rung 3 (" +
      granum::detail::formatted("chi^2 %.3g at %.0f degrees of freedom); ", all.chi_square(),
                                static_cast<double>(all.degrees_of_freedom())) +
      "the largest deviation is that of " + named(measurements[worst]) +
      granum::detail::formatted(", %.2g standard errors ", std::abs(deviation)) +
      (deviation > 0 ? "stiffer" : "softer") + " than according to the others");
}

/// \throws   NotConverged if the least squares leave the range of possible packings, e.g. of the contact
///           number or the fabric. Each state and each value has been checked before.
Inference solve_together(const std::shared_ptr<const detail::ContactModel>& model, double start,
                         std::span<const Observation> measurements, std::span<const AloneAnswer> alone) {
  try {
    return detail::ContactModel::solve(model, start);
  } catch (const InvalidArgument&) {
    std::string unexplained;
    for (std::size_t k = 0; k < measurements.size(); ++k)
      if (!alone[k].implied.mechanical_coordination_number)
        unexplained += (unexplained.empty() ? "; alone, none explains " : ", ") + named(measurements[k]);
    throw NotConverged(
        "no single coordination number can be fitted to the measurements: they contradict each other "
        "by far more than their errors" +
        unexplained);
  }
}

} // namespace

Validity Inference::doubts(const effective::State& at, AskedPacking specimen) const {
  estimate::Question asked{.state = at};
  asked.state.mechanical_coordination_number = packing(at, specimen).mechanical_coordination_number.value;
  return estimate::answer(asked).validity();
}

InferenceAnswer infer(std::span<const Observation> measurements, const InferenceOptions& options) {
  const auto model = std::make_shared<const detail::ContactModel>(measurements, options);
  detail::require_possible_together(measurements, options.grain_density);
  for (const Observation& m : measurements)
    estimate::require_valid({.state = uncounted(m.state)});
  InferenceOptions one_alone = options;
  one_alone.growth = GrowthRule::fixed;
  one_alone.contacts = {};
  InferenceAnswer answer;
  std::optional<double> start;
  for (const Observation& m : measurements) {
    const QuantityRow& row = row_of(m.quantity);
    AloneAnswer alone{effective::implied_coordination(m.state, row.modulus, modulus_of(m, options),
                                                      options.rattler_fraction),
                      std::nullopt};
    if (const auto z = alone.implied.mechanical_coordination_number) {
      const auto own = std::make_shared<const detail::ContactModel>(std::span(&m, 1), one_alone);
      alone.mechanical_coordination_number =
          detail::ContactModel::solve(own, *z).packing(m.state).mechanical_coordination_number;
      start = start ? start : z;
    }
    if (options.contacts.numbers.empty())
      note_unexplained(m, options, alone.implied, answer.validity);
    answer.alone.push_back(std::move(alone));
  }
  if (!options.contacts.numbers.empty())
    start = start.value_or(any_contacts); // if the law is inferred, the law of the states may fit none
  if (!start)
    return answer;
  answer.together = solve_together(model, *start, measurements, answer.alone);
  constexpr double largest_error = 0.5; // of g, that of the exponent of G is half of it
  if (options.growth == GrowthRule::fitted)
    detail::require_determined_growth(*answer.together->growth_exponent(), largest_error);
  note_states(*answer.together, measurements, answer.validity);
  note_density(*answer.together, answer.together->state(measurements.front().state), answer.validity);
  answer.validity.keep_each_once();
  note_contradiction(*answer.together, measurements, answer.validity);
  return answer;
}

} // namespace granum::inverse

namespace granum::inverse::detail {

namespace {

using effective::Modulus;

bool at_one_state(const Observation& a, const Observation& b) {
  return a.state.stress_v == b.state.stress_v && a.state.stress_h == b.state.stress_h &&
         a.state.void_ratio == b.state.void_ratio;
}

/// Of a wave that travels by compression, over that of another measurement; 0: they are independent.
double least_ratio(Modulus compression, Modulus other) {
  if (compression != Modulus::C33 && compression != Modulus::C11)
    return 0;
  return other == Modulus::G_vh || other == Modulus::G_hh ? 4.0 / 3 : other == Modulus::K ? 1 : 0;
}

} // namespace

void require_possible_together(std::span<const Observation> all, std::optional<double> grain_density) {
  // Two speeds are compared without the density, which cancels.
  const auto modulus = [&](const Observation& m) {
    if (!row_of(m.quantity).speed)
      return m.value.value;
    return m.value.value * m.value.value *
           elastic::bulk_density(
               {.grain_density = grain_density.value_or(1), .void_ratio = m.state.void_ratio});
  };
  const auto error = [](const Observation& m) {
    return (row_of(m.quantity).speed ? 2 : 1) * m.value.standard_error / m.value.value;
  };
  const auto is_shear = [](const Observation& m) {
    const Modulus of = row_of(m.quantity).modulus;
    return of == Modulus::G_vh || of == Modulus::G_hh;
  };
  for (const Observation& wave : all) {
    stop_point();
    if (is_shear(wave))
      continue; // nothing is too slow for another
    for (const Observation& other : all) {
      const double least = least_ratio(row_of(wave.quantity).modulus, row_of(other.quantity).modulus);
      if (least == 0 || !at_one_state(wave, other) || !(row_of(other.quantity).speed || grain_density))
        continue;
      const double ratio = modulus(wave) / modulus(other);
      if (ratio * std::exp(3 * std::hypot(error(wave), error(other))) >= least)
        continue;
      const QuantityRow &of_wave = row_of(wave.quantity), &of_other = row_of(other.quantity);
      throw InvalidArgument(of_wave.key, wave.value.value, "m/s",
                            "[" + short_text(wave.value.value * std::sqrt(least / ratio)) +
                                ", inf): beside the measured " + of_other.key + " no stable solid has less");
    }
  }
}

void require_determined_growth(const Measured& exponent, double limit) {
  const double room = 2 * exponent.standard_error;
  const bool determined = exponent.standard_error <= limit;
  if (determined && exponent.value >= -room && exponent.value <= 1 + room)
    return;
  throw InvalidArgument("growth fitted: the exponent of stress would be " + short_text(exponent.value, 2) +
                        " +- " + short_text(exponent.standard_error, 2) +
                        (determined
                             ? ", and no packing has one outside of 0 to 1: the measurements contradict "
                               "each other"
                             : ": the measurements do not determine it; their stresses are too close, or "
                               "their errors too large"));
}

} // namespace granum::inverse::detail

namespace granum::inverse {

namespace {

using effective::State;
using estimate::Input;
using estimate::InputRow;
using estimate::InputValues;

bool is_shared(const InputRow& row) {
  switch (row.input) {
  case Input::grain_shear_modulus:
  case Input::grain_poisson_ratio:
  case Input::grain_bulk_modulus:
  case Input::radius:
  case Input::d50:
  case Input::tangential_ratio:
  case Input::rolling:
  case Input::void_ratio:
  case Input::porosity:
  case Input::solid_fraction:
  case Input::fabric:
  case Input::grain_density:
    return true;
  default:
    return row.law != nullptr;
  }
}

/// An input that may be changed, and its standard deviation.
struct Uncertain {
  Input input;
  double deviation = 0;
};

double moved(const InputValues& values, const Uncertain& one, double deviations) {
  const double value = values.number(one.input);
  const bool positive = value > 0 && one.input != Input::fabric && one.input != Input::grain_poisson_ratio;
  const double there =
      positive ? value * std::exp(one.deviation / value * deviations) : value + one.deviation * deviations;
  return one.input == Input::rolling ? std::clamp(there, 0.0, 1.0) : there;
}

State state_at_any_stress(const InputValues& values) {
  constexpr double any_stress = 1e5; // neither law nor density depends on it
  return state_of(values, {any_stress, any_stress});
}

void move_all(const InputValues& before, const std::vector<Uncertain>& uncertain,
              std::span<const double> deviations, State& state, double& density) {
  InputValues after = before;
  for (std::size_t k = 0; k < uncertain.size(); ++k)
    if (uncertain[k].input == Input::grain_density)
      density *= std::exp(uncertain[k].deviation / density * deviations[k]);
    else
      after.set(uncertain[k].input, moved(after, uncertain[k], deviations[k]));
  const State from = state_at_any_stress(before), to = state_at_any_stress(after);
  state.law = to.law;
  state.tangential_ratio = to.tangential_ratio;
  state.rolling = to.rolling;
  state.radius = to.radius;
  state.contacts = to.contacts;
  state.fabric_anisotropy += to.fabric_anisotropy - from.fabric_anisotropy;
  state.void_ratio *= to.void_ratio / from.void_ratio;
}

} // namespace

std::vector<const InputRow*> shared_rows(const InputValues& completed) {
  std::vector<const InputRow*> rows;
  for (const InputRow* const row : estimate::uncertain_rows())
    if (is_shared(*row) && in_use(completed, *row) &&
        !(completed.law && (row->input == Input::radius || row->input == Input::d50))) // sizes are the law's
      rows.push_back(row);
  return rows;
}

SharedInputs shared_inputs(const InputValues& completed, std::span<const estimate::UncertainInput> inputs) {
  SharedInputs out;
  std::vector<Uncertain> uncertain;
  for (const estimate::UncertainInput& one : inputs) {
    const InputRow& row = estimate::uncertain_row(one.input);
    if (!is_shared(row))
      continue;
    out.keys.push_back(one.input);
    uncertain.push_back({row.input, one.deviation});
  }
  out.move = [completed, uncertain](State& state, double& density, std::span<const double> deviations) {
    move_all(completed, uncertain, deviations, state, density);
  };
  return out;
}

} // namespace granum::inverse

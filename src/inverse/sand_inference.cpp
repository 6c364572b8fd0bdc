// SPDX-License-Identifier: GPL-3.0-or-later
#include <granum/inverse/sand_inference.hpp>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <string>

#include <Eigen/LU>
#include <granum/core/error.hpp>
#include <granum/core/stop.hpp>
#include <granum/core/text.hpp>

#include "contact_model.hpp"
#include "core/compiled_once.hpp"

namespace granum::inverse {

namespace {

using estimate::Field;
using estimate::Question;
using Parameters = Eigen::Vector3d; ///< ln level, shift of s, shift of nu

Field field_of(Quantity quantity) {
  switch (quantity) {
  case Quantity::G_vh:
    return Field::shear_modulus;
  case Quantity::G_hh:
    return Field::horizontal_shear_modulus;
  case Quantity::K:
    return Field::bulk_modulus;
  case Quantity::V_s:
    return Field::shear_wave_speed;
  case Quantity::V_s_hh:
    return Field::horizontal_shear_wave_speed;
  case Quantity::V_p:
    return Field::compression_wave_speed;
  case Quantity::V_p_h:
    return Field::horizontal_compression_wave_speed;
  }
  throw InvalidArgument("quantity is none of the known ones");
}

bool compresses(Quantity quantity) {
  return quantity == Quantity::K || quantity == Quantity::V_p || quantity == Quantity::V_p_h;
}

/// The sand at the void ratio and stresses of a state, with changed level, exponent and Poisson's ratio.
Question moved(const Question& known, const effective::State& at, const Parameters& x) {
  Question q = known;
  if (q.sand.relative_density) { // it moves with the void ratio, between usual limits or those of the sand
    const sands::UsualLimits usual = sands::usual_limits(q.sand.uniformity);
    *q.sand.relative_density -=
        (at.void_ratio - known.state.void_ratio) /
        (q.sand.largest_void_ratio.value_or(usual.largest) - q.sand.least_void_ratio.value_or(usual.least));
  }
  q.state.void_ratio = at.void_ratio;
  q.state.stress_v = at.stress_v;
  q.state.stress_h = at.stress_h;
  q.state.coordination_number.reset();
  q.state.mechanical_coordination_number.reset();
  q.sand.level_factor *= std::exp(x[0]);
  q.sand.exponent_shift += x[1];
  q.sand.poisson_shift += x[2];
  return q;
}

/// Where a quantity is measured or asked for.
struct Place {
  const effective::State& state;
  std::optional<double> saturation; ///< of its pores, if it is not that of the sand

  explicit Place(const Observation& m) : state(m.state), saturation(m.saturation) {}
  Place(const effective::State& at, std::optional<double> water) : state(at), saturation(water) {}
};

double value_of(const Question& known, Quantity quantity, const Place& at, const Parameters& x) {
  Question q = moved(known, at.state, x);
  q.saturation = at.saturation.value_or(q.saturation);
  return estimate::answer(q)[field_of(quantity)].value;
}

/// Derivatives of ln of a quantity by the parameters, central differences.
Parameters slopes(const Question& known, Quantity quantity, const Place& at, const Parameters& x) {
  constexpr double step = 1e-4;
  Parameters out;
  for (int k = 0; k < 3; ++k) {
    Parameters up = x, down = x;
    up[k] += step;
    down[k] -= step;
    out[k] = std::log(value_of(known, quantity, at, up) / value_of(known, quantity, at, down)) / (2 * step);
  }
  return out;
}

/// Half of the variance from test to test belongs to each of two compared tests; speeds have half the
/// deviation.
double own_error(Quantity quantity) {
  return (row_of(quantity).speed ? 0.5 : 1) * sands::scatter_within_a_sand / std::numbers::sqrt2;
}

double relative_error(const Measured& value) {
  constexpr double least = 1e-4;
  return std::max(least, value.standard_error / value.value);
}

struct LeastSquares {
  Parameters x = Parameters::Zero();
  Eigen::Matrix3d covariance;
};

/// Gauss-Newton: the model is nearly linear in these parameters.
LeastSquares solve(std::span<const Observation> all, const Question& known, const Parameters& deviations) {
  LeastSquares fit;
  for (int round = 0; round < 20; ++round) {
    Eigen::Matrix3d normal = Eigen::Matrix3d::Zero();
    Parameters right = Parameters::Zero();
    for (int k = 0; k < 3; ++k)
      if (std::isfinite(deviations[k])) {
        const double weight = 1 / (deviations[k] * deviations[k]);
        normal(k, k) += weight;
        right[k] -= weight * fit.x[k];
      }
    for (const Observation& one : all) {
      stop_point();
      const double error = std::hypot(relative_error(one.value), own_error(one.quantity));
      const Parameters slope = slopes(known, one.quantity, Place(one), fit.x);
      const double miss =
          std::log(one.value.value / value_of(known, one.quantity, Place(one), fit.x)) / (error * error);
      normal += slope * slope.transpose() / (error * error);
      right += slope * miss;
    }
    fit.covariance = normal.inverse();
    const Parameters step = fit.covariance * right;
    fit.x += step;
    if (step.cwiseAbs().maxCoeff() < 1e-12)
      break;
  }
  return fit;
}

void require_wave_of_sand(Quantity quantity, double saturation) {
  if (row_of(quantity).speed && compresses(quantity) && saturation > 0)
    throw InvalidArgument(
        "a compression wave in wet pores travels in the water and does not depend on the sand");
}

bool at_one_stress(std::span<const Observation> all) {
  return std::all_of(all.begin(), all.end(), [&](const Observation& one) {
    return one.state.mean_stress() == all.front().state.mean_stress();
  });
}

void require_observations(std::span<const Observation> all, const Question& known, SandGrowth growth) {
  if (all.empty())
    throw InvalidArgument("no measurement is given");
  for (const Observation& one : all) {
    require_measured(row_of(one.quantity), one.value);
    require_positive("mean stress of a measurement", one.state.mean_stress(), "Pa");
    if (row_of(one.quantity).speed && !known.grain_density)
      throw InvalidArgument("grain_density is not given [kg/m3]: wave speeds need it");
    require_wave_of_sand(one.quantity, one.saturation.value_or(known.saturation));
  }
  detail::require_possible_together(all, known.grain_density);
  if (growth == SandGrowth::fitted && at_one_stress(all))
    throw InvalidArgument("growth fitted needs measurements at two pressures");
}

} // namespace

Question SandInference::question(const effective::State& at) const {
  return moved(known_, at, Parameters::Zero());
}

Validity SandInference::doubts(const effective::State& at) const {
  return estimate::answer(question(at)).validity();
}

Measured SandInference::predict(Quantity quantity, const effective::State& at,
                                std::optional<double> saturation) const {
  require_wave_of_sand(quantity, saturation.value_or(known_.saturation));
  const double value = value_of(known_, quantity, {at, saturation}, Parameters::Zero());
  const Parameters slope = slopes(known_, quantity, {at, saturation}, Parameters::Zero());
  const Eigen::Map<const Eigen::Matrix3d> covariance(covariance_.data());
  const double own = own_error(quantity);
  return {value, value * std::sqrt(std::max(0.0, slope.dot(covariance * slope)) + own * own)};
}

estimate::Range SandInference::contacts(estimate::Field field, const effective::State& at) const {
  const auto of = [&](const Parameters& x) { return estimate::answer(moved(known_, at, x))[field].value; };
  const double value = of(Parameters::Zero());
  double variance = 0;
  constexpr double step = 1e-3;
  Parameters slope;
  for (int k = 0; k < 3; ++k) {
    Parameters up = Parameters::Zero();
    up[k] = step;
    slope[k] = std::log(of(up) / of(-up)) / (2 * step);
  }
  const Eigen::Map<const Eigen::Matrix3d> covariance(covariance_.data());
  variance = std::max(0.0, slope.dot(covariance * slope));
  const double factor = std::exp(std::sqrt(variance));
  return {value, value / factor, value * factor};
}

SandInference infer_sand(std::span<const Observation> measurements, const Question& sand, SandGrowth growth) {
  const std::span<const Observation> all = measurements;
  require_observations(all, sand, growth);
  SandInference found(sand);
  found.known_.grain_shape = estimate::GrainShape::sand;
  found.known_.shear_strain.reset();
  found.known_.state.void_ratio = all.front().state.void_ratio;
  const effective::State& first = all.front().state;
  const double p = first.mean_stress();
  const double s_deviation = sands::growth_exponent(sand.sand, p).deviation;
  const double nu_deviation = sands::poisson_ratio(sand.sand, p).deviation;
  constexpr double unknown = std::numeric_limits<double>::infinity();
  const Parameters deviations{unknown, growth == SandGrowth::fitted ? unknown : s_deviation, nu_deviation};
  const LeastSquares fit = solve(all, found.known_, deviations);
  found.known_ = moved(found.known_, first, fit.x);

  for (std::size_t k = 0; k < all.size(); ++k) {
    stop_point();
    const Observation& one = all[k];
    const double fitted = value_of(found.known_, one.quantity, Place(one), Parameters::Zero());
    const double error = std::hypot(relative_error(one.value), own_error(one.quantity));
    const double off = std::log(one.value.value / fitted) / error;
    found.fitted_.push_back({.value = {fitted, 0}, .deviation = off});
    found.chi_square_ += off * off;
  }
  for (int k = 1; k < 3; ++k)
    if (std::isfinite(deviations[k]))
      found.chi_square_ += fit.x[k] * fit.x[k] / (deviations[k] * deviations[k]);
  const std::size_t free = growth == SandGrowth::fitted ? 2 : 1; // the others have measured priors
  found.degrees_of_freedom_ = all.size() > free ? all.size() - free : 0;
  if (found.degrees_of_freedom_ > 0) {
    found.probability_ = p_value(found.chi_square_, found.degrees_of_freedom_);
    found.widening_ =
        std::max(1.0, std::sqrt(found.chi_square_ / static_cast<double>(found.degrees_of_freedom_)));
  }
  const Eigen::Matrix3d covariance = fit.covariance * found.widening_ * found.widening_;
  Eigen::Map<Eigen::Matrix3d>(found.covariance_.data()) = covariance;
  for (FittedObservation& one : found.fitted_) {
    stop_point();
    const auto k = static_cast<std::size_t>(&one - found.fitted_.data());
    const Parameters slope = slopes(found.known_, all[k].quantity, Place(all[k]), Parameters::Zero());
    one.value.standard_error = one.value.value * std::sqrt(std::max(0.0, slope.dot(covariance * slope)));
  }
  const double level = found.known_.sand.level_factor;
  found.level_ = {level, level * std::sqrt(covariance(0, 0))};
  constexpr double above_knee = 100e3;
  found.exponent_ = {sands::growth_exponent(found.known_.sand, above_knee).value,
                     std::sqrt(covariance(1, 1))};
  constexpr double largest_error = 0.25; // five times the scatter from sand to sand
  if (growth == SandGrowth::fitted)
    detail::require_determined_growth(found.exponent_, largest_error);
  found.poisson_ratio_ = {sands::poisson_ratio(found.known_.sand, p).value, std::sqrt(covariance(2, 2))};
  found.tells_contacts_ = std::sqrt(fit.covariance(2, 2)) < 0.7 * nu_deviation;

  for (const Observation& one : all)
    found.validity_.merge(found.doubts(one.state));
  found.validity_.keep_each_once();
  constexpr double unlikely = 0.01;
  if (found.probability_ < unlikely)
    found.validity_.add(
        "the measurements contradict each other if all are of one sand: one level of G does not fit them, "
        "chi^2 " +
        short_text(found.chi_square_, 3) + " at " + std::to_string(found.degrees_of_freedom_) +
        " degrees of freedom; errors are enlarged " + short_text(found.widening_, 2) + " times" +
        (growth == SandGrowth::measured && !at_one_stress(all)
             ? "; a fitted exponent, --growth fitted, may agree"
             : ""));
  constexpr double stiffest_contacts = 2; // conforming grains of dry sands have up to 1.6
  if (const std::string remark = sands::level_remark(level); !remark.empty())
    found.validity_.add(remark);
  else if (found.tells_contacts_ &&
           found.contacts(estimate::Field::contact_softness, first).low > stiffest_contacts)
    found.validity_.add(
        "Poisson's ratio and G together imply contacts " +
        short_text(found.contacts(estimate::Field::contact_softness, first).value, 2) +
        " times as stiff as those of smooth spheres: more than possible without bonds; the ground is "
        "cemented, or a value has another unit or is from another place");
  return found;
}

} // namespace granum::inverse

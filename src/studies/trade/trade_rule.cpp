// SPDX-License-Identifier: GPL-3.0-or-later
#include "studies/trade/trade_rule.hpp"

#include <algorithm>
#include <cmath>

#include <granum/core/check.hpp>
#include <granum/core/error.hpp>

namespace granum::studies {

namespace {

using triaxial::Density;
using Column = std::optional<Deviation> TradeRow::*;

std::vector<TradeRow> select(const std::vector<TradeRow>& rows, Varied varied, Density density) {
  std::vector<TradeRow> chosen;
  std::copy_if(rows.begin(), rows.end(), std::back_inserter(chosen), [&](const TradeRow& row) {
    return row.varied == varied && row.boundary == Boundary::periodic && row.density == density;
  });
  return chosen;
}

struct Slope {
  double value = 0;
  double standard_error = 0;
};

/// Bias against x(value), zero at the reference, weighted by the standard errors.
template <class X>
Slope slope_of(const std::vector<TradeRow>& rows, Column figure, const X& x) {
  const auto reference =
      std::find_if(rows.begin(), rows.end(), [](const TradeRow& row) { return row.reference; });
  if (reference == rows.end())
    return {};
  double xx = 0, xy = 0;
  for (const TradeRow& row : rows) {
    const std::optional<Deviation>& d = row.*figure;
    if (row.reference || !d || !(d->standard_error > 0))
      continue;
    const double distance = x(row.value) - x(reference->value);
    const double weight = 1 / (d->standard_error * d->standard_error);
    xx += weight * distance * distance;
    xy += weight * distance * d->bias;
  }
  return xx > 0 ? Slope{xy / xx, 1 / std::sqrt(xx)} : Slope{};
}

double scatter_of(const std::vector<TradeRow>& rows, Column figure) {
  double sum = 0, freedom = 0;
  for (const TradeRow& row : rows)
    if (const std::optional<Deviation>& d = row.*figure) {
      const double degrees = static_cast<double>(row.specimens) - 1;
      sum += degrees * d->scatter * d->scatter * row.value;
      freedom += degrees;
    }
  return freedom > 0 ? std::sqrt(sum / freedom) : 0;
}

ErrorLaw law_of(const std::vector<TradeRow>& rows, Density density, Column figure, Varied rate_kind) {
  const std::vector<TradeRow> sizes = select(rows, Varied::grains, density);
  const std::vector<TradeRow> rates = select(rows, rate_kind, density);
  const Slope size = slope_of(sizes, figure, [](double grains) { return 1 / grains; });
  const Slope rate = slope_of(rates, figure, [](double inertial_number) { return inertial_number; });
  const auto [smallest, largest] = std::minmax_element(
      sizes.begin(), sizes.end(), [](const TradeRow& a, const TradeRow& b) { return a.value < b.value; });
  return {.size = {.scatter = scatter_of(sizes, figure),
                   .bias = size.value,
                   .bias_error = size.standard_error,
                   .smallest = sizes.empty() ? 0 : smallest->value,
                   .largest = sizes.empty() ? 0 : largest->value},
          .rate = {rate.value, rate.standard_error}};
}

/// Two significant digits, upwards.
std::size_t rounded_up(double value) {
  const double unit = std::pow(10, std::max(0.0, std::floor(std::log10(value)) - 1));
  return static_cast<std::size_t>(std::ceil(value / unit) * unit);
}

} // namespace

TradeLaws laws_of(const std::vector<TradeRow>& rows) {
  const auto law = [&](Density density, Column figure, Varied rate) {
    return law_of(rows, density, figure, rate);
  };
  return {.dense_modulus = law(Density::dense, &TradeRow::shear_modulus, Varied::compression),
          .dense_exponent = law(Density::dense, &TradeRow::exponent, Varied::compression),
          .loose_modulus = law(Density::loose, &TradeRow::shear_modulus, Varied::compression),
          .loose_exponent = law(Density::loose, &TradeRow::exponent, Varied::compression),
          .dense_peak = law(Density::dense, &TradeRow::peak_ratio, Varied::shear)};
}

const TradeLaws& recorded_laws() {
  static const TradeLaws laws{
      .dense_modulus = {.size = {0.2817, -2.548, 0.7801, 250, 16000}, .rate = {0.007396, 0.001287}},
      .dense_exponent = {.size = {0.06387, -0.2971, 0.1769, 250, 16000}, .rate = {0.0007718, 0.0003914}},
      .loose_modulus = {.size = {1.328, 1.146, 3.679, 250, 16000}, .rate = {2.147, 1.155}},
      .loose_exponent = {.size = {0.544, -6.011, 1.507, 250, 16000}, .rate = {-2.255, 0.5819}},
      .dense_peak = {.size = {1.198, 6.263, 3.319, 250, 16000}, .rate = {9.555, 0.3031}},
  };
  return laws;
}

double scatter_of(const ErrorLaw& law, double grains) { return law.size.scatter / std::sqrt(grains); }
double size_bias_of(const ErrorLaw& law, double grains) { return law.size.bias / grains; }
double rate_bias_of(const ErrorLaw& law, double inertial_number) { return law.rate.bias * inertial_number; }

double expected_error(const ErrorLaw& law, std::size_t grains, std::size_t specimens,
                      double inertial_number) {
  const double count = require_positive("grains", static_cast<double>(grains));
  const double number = require_positive("specimens", static_cast<double>(specimens));
  require_non_negative("inertial_number", inertial_number);
  const double variance = law.size.scatter * law.size.scatter / count / number;
  return std::sqrt(variance + std::pow(size_bias_of(law, count) + rate_bias_of(law, inertial_number), 2));
}

Recipe recipe_for(const ErrorLaw& law, double error, std::size_t specimens) {
  require_positive("error", error);
  const double number = require_positive("specimens", static_cast<double>(specimens));
  constexpr double fastest = 1e-2, share = 1.0 / 3;
  const double rate = std::abs(law.rate.bias);
  const double inertial_number = rate * fastest > share * error ? share * error / rate : fastest;
  // c^2/(n N) + b^2/N^2 = e^2, in which the bias of the rate adds a tenth to e^2 at most.
  const double c = law.size.scatter * law.size.scatter / number, b = law.size.bias;
  const double grains = (c + std::sqrt(c * c + 4 * b * b * error * error)) / (2 * error * error);
  return {.grains = rounded_up(std::max(40.0, grains)), .inertial_number = inertial_number};
}

} // namespace granum::studies

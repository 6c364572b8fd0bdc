// SPDX-License-Identifier: GPL-3.0-or-later
#include "seed_mean.hpp"

#include <algorithm>
#include <cmath>

namespace granum::studies {

std::optional<TableValue> mean_over_seeds(const std::vector<TableValue>& each, const KnownScatter& known) {
  if (each.empty())
    return std::nullopt;
  const double count = static_cast<double>(each.size());
  TableValue mean;
  double own = 0, scatter = 0;
  bool has_error = each.size() > 1 || known.degrees > 0;
  for (const TableValue& one : each) {
    mean.value += one.value / count;
    own += one.standard_error ? *one.standard_error * *one.standard_error / count : 0;
    has_error = has_error || one.standard_error;
  }
  const double degrees = count - 1 + known.degrees;
  for (const TableValue& one : each)
    scatter += (one.value - mean.value) * (one.value - mean.value) / std::max(1.0, degrees);
  if (degrees > 0)
    scatter += known.degrees / degrees * known.deviation * known.deviation;
  if (has_error)
    mean.standard_error = std::sqrt(std::max(own, scatter) / count);
  return mean;
}

namespace {

constexpr double measured_grains = 1000, measured_degrees = 15;

struct Deviations {
  double closed_form, network, probe;
};

Deviations deviations(contact::Shape contact, triaxial::Density density) {
  const bool loose = density == triaxial::Density::loose;
  if (contact == contact::Shape::cone)
    return loose ? Deviations{0.0021, 0.0083, 0.0137} : Deviations{0.0007, 0.0023, 0.0029};
  if (contact == contact::Shape::sphere)
    return loose ? Deviations{0.0045, 0.0198, 0.0218} : Deviations{0.0008, 0.0017, 0.0026};
  // Flat contacts, which scatter most; others are assumed to scatter no more.
  return loose ? Deviations{0.0066, 0.0299, 0.0253} : Deviations{0.0014, 0.0030, 0.0034};
}

} // namespace

KnownScatter exponent_scatter(contact::Shape contact, triaxial::Density density, ExponentRoute route,
                              std::size_t grains) {
  const Deviations of = deviations(contact, density);
  const double deviation = route == ExponentRoute::closed_form ? of.closed_form
                           : route == ExponentRoute::network   ? of.network
                                                               : of.probe;
  return {.deviation = deviation * std::sqrt(measured_grains / static_cast<double>(grains)),
          .degrees = measured_degrees};
}

} // namespace granum::studies

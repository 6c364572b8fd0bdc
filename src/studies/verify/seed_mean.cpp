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

/// Standard deviation of s of one route, and its mean.
struct KnownExponent {
  double deviation, mean;
};
struct ExponentsByRoute {
  KnownExponent closed_form, network, probe;
};

ExponentsByRoute known_routes(contact::Shape contact, triaxial::Density density) {
  const bool loose = density == triaxial::Density::loose;
  if (contact == contact::Shape::cone)
    return loose ? ExponentsByRoute{{0.0021, 0.5365}, {0.0083, 0.7148}, {0.0137, 0.7216}}
                 : ExponentsByRoute{{0.0007, 0.5059}, {0.0023, 0.5408}, {0.0029, 0.5453}};
  if (contact == contact::Shape::sphere)
    return loose ? ExponentsByRoute{{0.0045, 0.3706}, {0.0198, 0.5656}, {0.0218, 0.5686}}
                 : ExponentsByRoute{{0.0008, 0.3365}, {0.0017, 0.3608}, {0.0026, 0.3658}};
  // Flat contacts, which scatter most; others are assumed to scatter no more.
  return loose ? ExponentsByRoute{{0.0066, 0.0676}, {0.0299, 0.3151}, {0.0253, 0.3154}}
               : ExponentsByRoute{{0.0014, 0.0062}, {0.0030, 0.0099}, {0.0034, 0.0100}};
}

} // namespace

KnownScatter exponent_scatter(contact::Shape contact, triaxial::Density density, ExponentRoute route,
                              std::size_t grains) {
  const ExponentsByRoute of = known_routes(contact, density);
  const KnownExponent known = route == ExponentRoute::closed_form ? of.closed_form
                              : route == ExponentRoute::network   ? of.network
                                                                  : of.probe;
  const bool measured =
      contact == contact::Shape::cone || contact == contact::Shape::sphere || contact == contact::Shape::flat;
  return {.deviation = known.deviation * std::sqrt(measured_grains / static_cast<double>(grains)),
          .degrees = measured_degrees,
          .mean = measured ? std::optional(known.mean) : std::nullopt};
}

} // namespace granum::studies

// SPDX-License-Identifier: GPL-3.0-or-later
#include "possible.hpp"

#include <cmath>

#include <granum/core/error.hpp>
#include <granum/core/text.hpp>
#include <granum/elastic/waves.hpp>

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
  for (const Observation& wave : all)
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

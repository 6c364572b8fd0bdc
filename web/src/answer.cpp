// SPDX-License-Identifier: GPL-3.0-or-later
// The calculator's answer.
#include <cmath>
#include <optional>
#include <vector>

#include <granum/core/error.hpp>
#include <granum/effective/answer.hpp>

#include "exports.hpp"

namespace {

using namespace granum;

effective::Preparation preparation_of(double number) {
  using Kind = effective::Preparation::Kind;
  for (const Kind kind : {Kind::unknown, Kind::dense, Kind::loose})
    if (number == static_cast<double>(kind))
      return {.kind = kind};
  throw InvalidArgument("preparation", number, "", "0 (unknown), 1 (dense) or 2 (loose)");
}

void add(const std::optional<effective::Range>& range) {
  constexpr double none = effective::State::unset;
  const effective::Range of = range.value_or(effective::Range{none, none, none});
  web::numbers().insert(web::numbers().end(), {of.value, of.low, of.high});
}

} // namespace

/// Value, low and high of G, K, E, nu, V_s, V_p and z*; then the shares of the range, whose names are the
/// first words. A mechanical coordination number that is not a number is not given; saturation is a share.
GRANUM_EXPORT(answer)
void answer(double shape, double shear_modulus, double poisson_ratio, double radius, double cone_slope,
            double punch_radius, double void_ratio, double pressure, double preparation,
            double mechanical_coordination_number, double grain_density, double saturation) {
  effective::PackingQuestion question{
      .state = {.law = web::law_of({shape, shear_modulus, poisson_ratio, radius, cone_slope, punch_radius}),
                .tangential_ratio = contact::mindlin_stiffness_ratio(poisson_ratio),
                .radius = radius,
                .void_ratio = void_ratio,
                .stress_v = pressure,
                .stress_h = pressure},
      .preparation = preparation_of(preparation),
      .grain_density = grain_density,
      .saturation = saturation};
  if (!std::isnan(mechanical_coordination_number))
    question.mechanical_coordination_number = mechanical_coordination_number;
  const effective::PackingAnswer found = effective::answer(question);
  for (const std::optional<effective::Range>& range :
       {std::optional(found.shear_modulus), std::optional(found.bulk_modulus),
        std::optional(found.young_modulus), std::optional(found.poisson_ratio), found.shear_wave_speed,
        found.compression_wave_speed, std::optional(found.mechanical_coordination_number)})
    add(range);
  web::say(found.validity);
  std::string names;
  for (const effective::Share& share : found.shares) {
    web::numbers().push_back(share.share);
    names += share.input + "\n";
  }
  web::words() = names + web::words();
}

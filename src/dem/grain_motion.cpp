// SPDX-License-Identifier: GPL-3.0-or-later
// Notation: x centre, v own velocity, w angular velocity; f force, t torque. Rows as in grain_rows.hpp.
#include "grain_motion.hpp"

#include <algorithm>
#include <cstddef>

#include "vector_level.hpp"

namespace granum::dem {

namespace {

/// Sum of v f + t w from its parts by their places in the rows, and the part of y of w, which has none.
GRANUM_INLINE double sum_of(const Four& push, const Four& turn, double turn_y) {
  return push[0] + push[1] + push[2] + (push[3] + turn_y + turn[3]);
}

GRANUM_INLINE void move_at_level(Grains& grains, const Mat3& stretch, double dt) {
  const Mat3& a = stretch;
  const Four x{a(0, 0), a(1, 0), a(2, 0), 0}, y{a(0, 1), a(1, 1), a(2, 1), 0},
      z{a(0, 2), a(1, 2), a(2, 2), 0};
  const Four own{dt, dt, dt, 0}, spin{0, 0, 0, 1};
  for (MotionRow& grain : grains.row) {
    const Four place = grain.place;
    grain.place = place[0] * x + place[1] * y + place[2] * z + own * grain.rate + spin * place;
  }
}

GRANUM_INLINE double power_at_level(const Grains& grains, const std::vector<LoadRow>& load) {
  Four push{}, turn{};
  double turn_y = 0;
  for (std::size_t g = 0; g < grains.size(); ++g) {
    push += grains.row[g].rate * load[g].push;
    turn += grains.row[g].place * load[g].turn;
    turn_y += grains.spin_y[g] * load[g].turn[0];
  }
  return sum_of(push, turn, turn_y);
}

GRANUM_INLINE MotionSums kick_at_level(Grains& grains, const std::vector<LoadRow>& load, const Kick& kick,
                                       double mass, double inertia) {
  const Four keep{kick.keep, kick.keep, kick.keep, kick.keep}, keep_spin{1, 1, 1, kick.keep};
  const Four push{kick.push, kick.push, kick.push, kick.turn}, turn{0, 0, 0, kick.turn};
  Four squares{}, spin_squares{}, push_power{}, turn_power{};
  double squares_y = 0, power_y = 0, fastest = 0;
  for (std::size_t g = 0; g < grains.size(); ++g) {
    MotionRow& grain = grains.row[g];
    const LoadRow on = load[g];
    const Four rate = keep * grain.rate + push * on.push;
    const Four place = keep_spin * grain.place + turn * on.turn;
    const double spin_y = kick.keep * grains.spin_y[g] + kick.turn * on.turn[0];
    grain.rate = rate;
    grain.place = place;
    grains.spin_y[g] = spin_y;
    const Four square = rate * rate;
    squares += square;
    spin_squares += place * place;
    squares_y += spin_y * spin_y;
    push_power += rate * on.push;
    turn_power += place * on.turn;
    power_y += spin_y * on.turn[0];
    fastest = std::max(fastest, square[0] + square[1] + square[2]);
  }
  return {.kinetic = mass * (squares[0] + squares[1] + squares[2]) +
                     inertia * (squares[3] + squares_y + spin_squares[3]),
          .power = sum_of(push_power, turn_power, power_y),
          .speed_squared = fastest};
}

} // namespace

void move_grains(Grains& grains, const Mat3& stretch, double dt) {
  at_vector_level([&]() __attribute__((always_inline)) { move_at_level(grains, stretch, dt); });
}

double power(const Grains& grains, const std::vector<LoadRow>& load) {
  double sum = 0;
  at_vector_level([&]() __attribute__((always_inline)) { sum = power_at_level(grains, load); });
  return sum;
}

MotionSums kick_grains(Grains& grains, const std::vector<LoadRow>& load, const Kick& kick, double mass,
                       double inertia) {
  MotionSums sums;
  at_vector_level([&]() __attribute__((always_inline)) {
    sums = kick_at_level(grains, load, kick, mass, inertia);
  });
  return sums;
}

} // namespace granum::dem

// SPDX-License-Identifier: GPL-3.0-or-later
// Notation: x centre, v own velocity, w angular velocity; f force, t torque. Rows as in grain_rows.hpp.
#include "grain_motion.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>

#include "core/vector/rows.hpp"

namespace granum::dem {

namespace {

/// Sum of v f + t w from components as in the rows, and the part of w_y, which is not in the rows.
GRANUM_INLINE double sum_of(const Four& turn, const Four& push, double turn_y) {
  return push[0] + push[1] + push[2] + (push[3] + turn_y + turn[3]);
}

GRANUM_INLINE Four all(double value) { return Four{value, value, value, value}; }

GRANUM_INLINE void move_at_level(Grains& grains, Range range, const Mat3& stretch, double dt) {
  const Mat3& a = stretch;
  const Four x{a(0, 0), a(1, 0), a(2, 0), 0}, y{a(0, 1), a(1, 1), a(2, 1), 0},
      z{a(0, 2), a(1, 2), a(2, 2), 0};
  const Four own{dt, dt, dt, 0}, spin{0, 0, 0, 1};
  for (std::size_t g = range.begin; g < range.end; ++g) {
    MotionRow& grain = grains.row[g];
    const Four place = grain.place;
    grain.place = place[0] * x + place[1] * y + place[2] * z + own * grain.rate + spin * place;
  }
}

template <class Level>
GRANUM_INLINE void add_spare_rows(const Range& range, const std::vector<Addition>& additions,
                                  std::vector<LoadRow>& load) {
  for (std::size_t k = range.begin; k < range.end; ++k) {
    LoadRow& on = load[additions[k].grain];
    Level::put(&on, Level::get(&on) + Level::get(&load[additions[k].row]));
  }
}

template <class Level>
GRANUM_INLINE double settle_at_level(const Grains& grains, const Chunk& chunk,
                                     const std::vector<Addition>& additions, std::vector<LoadRow>& load) {
  add_spare_rows<Level>(chunk.additions, additions, load);
  auto sum = Level::row(Four{}, Four{});
  double turn_y = 0;
  for (std::size_t g = chunk.grains.begin; g < chunk.grains.end; ++g) {
    sum = sum + Level::get(&grains.row[g]) * Level::get(&load[g]);
    turn_y += grains.spin_y[g] * load[g].turn[0];
  }
  return sum_of(low(sum), high(sum), turn_y);
}

/// Sum of the three components that a vector has.
GRANUM_INLINE double sum_of_three(const Four& row) { return row[0] + row[1] + row[2]; }

/// Sums of three components, one of each of four rows.
GRANUM_INLINE Four sums_of_three(Four (&rows)[4]) {
  transpose(rows[0], rows[1], rows[2], rows[3]);
  return rows[0] + rows[1] + rows[2];
}

template <bool equal>
GRANUM_INLINE PushSums pushes_at_level(const TranslatingGrains& grains, const Chunk& chunk,
                                       const std::vector<Addition>& additions, std::vector<PushRow>& load) {
  for (std::size_t k = chunk.additions.begin; k < chunk.additions.end; ++k) {
    Four& spare = load[additions[k].row].push;
    load[additions[k].grain].push += spare;
    spare = Four{};
  }
  Four power{}, squares{}, components{};
  for (std::size_t g = chunk.grains.begin; g < chunk.grains.end; ++g) {
    const Four push = load[g].push;
    const Four square = push * push;
    power += push * grains.rate[g].rate;
    if constexpr (equal)
      squares += square;
    else
      squares += square * all(grains.own[g].per_mass);
    components += push > 0 ? push : -push;
  }
  return {
      .power = sum_of_three(power), .squares = sum_of_three(squares), .components = sum_of_three(components)};
}

template <bool equal>
GRANUM_INLINE GlideSums glide_at_level(TranslatingGrains& grains, std::vector<PushRow>& load,
                                       const Glide& glide) {
  const Four keep = all(glide.keep), push = all(glide.push), dt = all(glide.dt), growth = all(glide.growth);
  Four squares{};
  double fastest = 0;
  for (std::size_t g = 0; g < grains.size(); ++g) {
    Four rate;
    if constexpr (equal)
      rate = keep * grains.rate[g].rate + push * load[g].push;
    else
      rate = keep * grains.rate[g].rate + push * (load[g].push * all(grains.own[g].per_mass));
    load[g].push = Four{};
    const double square = sum_of_three(rate * rate);
    fastest = std::max(fastest, square);
    if (square > glide.largest * glide.largest)
      rate *= all(glide.largest / std::sqrt(square));
    if constexpr (equal)
      squares += rate * rate;
    else
      squares += rate * rate * all(grains.own[g].mass);
    grains.rate[g].rate = rate;
    grains.place[g].place = growth * (grains.place[g].place + dt * rate);
  }
  return {.squares = sum_of_three(squares), .fastest = std::sqrt(fastest)};
}

template <class Level>
GRANUM_INLINE MotionSums kick_at_level(Grains& grains, Range range, const std::vector<LoadRow>& load,
                                       const Kick& kick, double mass, double inertia) {
  const auto keep = Level::row(Four{1, 1, 1, kick.keep}, all(kick.keep));
  const auto push = Level::row(Four{0, 0, 0, kick.turn}, Four{kick.push, kick.push, kick.push, kick.turn});
  const LoadRow* const loads = load.data();
  MotionRow* const rows = grains.row.data();
  double* const spins_y = grains.spin_y.data();
  auto squares = Level::row(Four{}, Four{}), powers = squares;
  double squares_y = 0, power_y = 0;
  Four fastest{}; // each of every fourth grain
  const auto kicked = [&](std::size_t g) __attribute__((always_inline)) {
    const auto on = Level::get(&loads[g]);
    const auto grain = keep * Level::get(&rows[g]) + push * on;
    const double on_y = loads[g].turn[0];
    const double spin_y = kick.keep * spins_y[g] + kick.turn * on_y;
    Level::put(&rows[g], grain);
    spins_y[g] = spin_y;
    const auto square = grain * grain;
    squares = squares + square;
    powers = powers + grain * on;
    squares_y += spin_y * spin_y;
    power_y += spin_y * on_y;
    return high(square);
  };
  std::size_t g = range.begin;
  for (; g + 4 <= range.end; g += 4) {
    Four of_rates[4] = {kicked(g), kicked(g + 1), kicked(g + 2), kicked(g + 3)};
    const Four sums = sums_of_three(of_rates);
    fastest = fastest < sums ? sums : fastest;
  }
  for (; g < range.end; ++g)
    fastest[0] = std::max(fastest[0], sum_of_three(kicked(g)));
  const Four spin_squares = low(squares), rate_squares = high(squares);
  return {.kinetic =
              mass * sum_of_three(rate_squares) + inertia * (rate_squares[3] + squares_y + spin_squares[3]),
          .power = sum_of(low(powers), high(powers), power_y),
          .speed_squared = std::max({fastest[0], fastest[1], fastest[2], fastest[3]})};
}

/// For unequal grains: R w and v change in the same way, each grain with its own mass.
template <class Level>
GRANUM_INLINE MotionSums kick_unequal_at_level(Grains& grains, Range range, const std::vector<LoadRow>& load,
                                               const Kick& kick) {
  const auto keep = Level::row(Four{1, 1, 1, kick.keep}, all(kick.keep));
  auto kinetic = Level::row(Four{}, Four{}), powers = kinetic;
  double kinetic_y = 0, power_y = 0, fastest = 0;
  for (std::size_t g = range.begin; g < range.end; ++g) {
    const OwnSize& own = grains.own[g];
    const double push = kick.push * own.per_mass;
    const auto on = Level::get(&load[g]);
    const auto grain = keep * Level::get(&grains.row[g]) + Level::row(Four{0, 0, 0, push}, all(push)) * on;
    const double on_y = load[g].turn[0];
    const double spin_y = kick.keep * grains.spin_y[g] + push * on_y;
    Level::put(&grains.row[g], grain);
    grains.spin_y[g] = spin_y;
    const auto square = grain * grain;
    kinetic = kinetic + Level::row(all(own.mass), all(own.mass)) * square;
    powers = powers + grain * on;
    kinetic_y += own.mass * (spin_y * spin_y);
    power_y += spin_y * on_y;
    fastest = std::max(fastest, sum_of_three(high(square)));
  }
  const Four of_spins = low(kinetic), of_rates = high(kinetic);
  return {.kinetic = sum_of_three(of_rates) + (of_rates[3] + kinetic_y + of_spins[3]),
          .power = sum_of(low(powers), high(powers), power_y),
          .speed_squared = fastest};
}

template <class Level, bool equal>
GRANUM_INLINE double pull_at_level(const Grains& grains, Range range, const std::vector<LoadRow>& load,
                                   double mass, double inertia) {
  auto squares = Level::row(Four{}, Four{});
  for (std::size_t g = range.begin; g < range.end; ++g) {
    const auto on = Level::get(&load[g]);
    if constexpr (equal)
      squares = squares + on * on;
    else
      squares = squares + Level::row(all(grains.own[g].per_mass), all(grains.own[g].per_mass)) * (on * on);
  }
  const Four turn = low(squares), push = high(squares);
  const double of_forces = sum_of_three(push), of_torques = push[3] + turn[0] + turn[3];
  return equal ? of_forces / mass + of_torques / inertia : of_forces + of_torques;
}

} // namespace

MotionSums& MotionSums::operator+=(const MotionSums& other) {
  kinetic += other.kinetic;
  power += other.power;
  speed_squared = std::max(speed_squared, other.speed_squared);
  return *this;
}

void move_grains(Grains& grains, Range range, const Mat3& stretch, double dt) {
  at_vector_level([&](auto) __attribute__((always_inline)) { move_at_level(grains, range, stretch, dt); });
}

double settle_loads(const Grains& grains, const Chunk& chunk, const std::vector<Addition>& additions,
                    std::vector<LoadRow>& load) {
  double power = 0;
  at_vector_level([&]<VectorLevel level>(AtLevel<level>) __attribute__((always_inline)) {
    power = settle_at_level<Rows<level>>(grains, chunk, additions, load);
  });
  return power;
}

PushSums& PushSums::operator+=(const PushSums& other) {
  power += other.power;
  squares += other.squares;
  components += other.components;
  return *this;
}

PushSums settle_pushes(const TranslatingGrains& grains, const Chunk& chunk,
                       const std::vector<Addition>& additions, std::vector<PushRow>& load) {
  PushSums sums;
  at_vector_level([&](auto) __attribute__((always_inline)) {
    sums = grains.own.empty() ? pushes_at_level<true>(grains, chunk, additions, load)
                              : pushes_at_level<false>(grains, chunk, additions, load);
  });
  return sums;
}

double lengths_of_forces(const Chunk& chunk, const std::vector<PushRow>& load) {
  double lengths = 0;
  for (std::size_t g = chunk.grains.begin; g < chunk.grains.end; ++g)
    lengths += norm(force(load[g]));
  return lengths;
}

GlideSums glide_grains(TranslatingGrains& grains, std::vector<PushRow>& load, const Glide& glide) {
  GlideSums sums;
  at_vector_level([&](auto) __attribute__((always_inline)) {
    sums = grains.own.empty() ? glide_at_level<true>(grains, load, glide)
                              : glide_at_level<false>(grains, load, glide);
  });
  return sums;
}

double pull_of(const Grains& grains, Range range, const std::vector<LoadRow>& load, double mass,
               double inertia) {
  double pull = 0;
  at_vector_level([&]<VectorLevel level>(AtLevel<level>) __attribute__((always_inline)) {
    pull = grains.own.empty() ? pull_at_level<Rows<level>, true>(grains, range, load, mass, inertia)
                              : pull_at_level<Rows<level>, false>(grains, range, load, mass, inertia);
  });
  return pull;
}

void hold_free_grains(Grains& grains, Range range, const std::vector<LoadRow>& load) {
  for (std::size_t g = range.begin; g < range.end; ++g) {
    const Vec3 f = force(load[g]);
    if (dot(f, f) == 0) {
      grains.set_velocity(g, {});
      grains.set_spin(g, {});
    }
  }
}

MotionSums kick_grains(Grains& grains, Range range, const std::vector<LoadRow>& load, const Kick& kick,
                       double mass, double inertia) {
  MotionSums sums;
  at_vector_level([&]<VectorLevel level>(AtLevel<level>) __attribute__((always_inline)) {
    sums = grains.own.empty() ? kick_at_level<Rows<level>>(grains, range, load, kick, mass, inertia)
                              : kick_unequal_at_level<Rows<level>>(grains, range, load, kick);
  });
  return sums;
}

} // namespace granum::dem

// SPDX-License-Identifier: GPL-3.0-or-later
#include <granum/contact/adhesion.hpp>

#include <algorithm>
#include <cmath>
#include <numbers>

#include <granum/core/error.hpp>

namespace granum::contact {

namespace {

/// Constants of a pair, checked.
struct Pair {
  AdhesionModel model;
  double R;          ///< R*
  double E;          ///< E*
  double s;          ///< (pi gamma/E*)^(1/2), of JKR [m^(1/2)]
  double attraction; ///< 4 pi gamma R*, of DMT [N]
};

Pair pair_of(const Adhesion& adhesion, const GrainMaterial& grain, double pair_radius) {
  require_positive("grain_shear_modulus", grain.shear_modulus, "Pa");
  require_poisson_ratio("grain_poisson_ratio", grain.poisson_ratio);
  require_positive("pair_radius", pair_radius, "m");
  require_valid(adhesion);
  const double gamma = adhesion.surface_energy, E = grain.shear_modulus / (1 - grain.poisson_ratio);
  const bool jkr = adhesion.model == AdhesionModel::jkr;
  return {.model = adhesion.model,
          .R = pair_radius / 2,
          .E = E,
          .s = jkr ? std::sqrt(std::numbers::pi * gamma / E) : 0,
          .attraction = jkr ? 0 : 4 * std::numbers::pi * gamma * (pair_radius / 2)};
}

/// The state of a contact area, from the root of its radius: all numbers are powers of a^(1/2).
AdhesiveContact state_at(const Pair& p, double root_a) {
  const double a = root_a * root_a, root_a3 = root_a * a;
  if (root_a == 0)
    return {.force = -p.attraction};
  // df/da = (4 E a^2/R) (1 - 3 q/2), dd/da = (2 a/R) (1 - q/2)
  const double q = p.s * p.R / root_a3;
  return {.radius = a,
          .overlap = a * a / p.R - 2 * p.s * root_a,
          .force = 4 * p.E * root_a3 * (root_a3 / (3 * p.R) - p.s) - p.attraction,
          .stiffness = 2 * p.E * a * (1 - 1.5 * q) / (1 - q / 2),
          .hertz_stiffness = 2 * p.E * a};
}

} // namespace

void require_valid(const Adhesion& adhesion) {
  require_finite("adhesion", require_non_negative("adhesion", adhesion.surface_energy, "J/m2"), "J/m2");
}

double pull_off_force(const Adhesion& adhesion, double pair_radius) {
  require_positive("pair_radius", pair_radius, "m");
  require_valid(adhesion);
  const double factor = adhesion.model == AdhesionModel::jkr ? 3 : 4;
  return factor * std::numbers::pi * adhesion.surface_energy * (pair_radius / 2);
}

AdhesiveContact adhesive_contact_at_force(const Adhesion& adhesion, const GrainMaterial& grain,
                                          double pair_radius, double force) {
  const Pair p = pair_of(adhesion, grain, pair_radius);
  require_finite("force", force, "N");
  // A square of a^(3/2): 4 E a^3/(3 R) - 4 s E a^(3/2) = F + attraction.
  const double half = 1.5 * p.R * p.s;
  const double square = half * half + 3 * p.R * (force + p.attraction) / (4 * p.E);
  return state_at(p, std::cbrt(half + std::sqrt(std::max(square, 0.0))));
}

AdhesiveContact adhesive_contact_at_overlap(const Adhesion& adhesion, const GrainMaterial& grain,
                                            double pair_radius, double overlap) {
  const Pair p = pair_of(adhesion, grain, pair_radius);
  require_finite("overlap", overlap, "m");
  if (p.s == 0) // a^2 = R d
    return overlap > 0 ? state_at(p, std::sqrt(std::sqrt(p.R * overlap))) : AdhesiveContact{};
  // u^4 - 2 s R u - R d = 0 of u = a^(1/2): convex, and rising beyond the least d
  const double least = std::cbrt(p.s * p.R / 2);
  const auto value = [&](double u) { return u * (u * u * u - 2 * p.s * p.R) - p.R * overlap; };
  if (value(least) > 0)
    return {};
  double u =
      std::sqrt(std::sqrt(p.R * std::max(overlap, 0.0))) + std::cbrt(2 * p.s * p.R); // not below the root
  constexpr int most = 100;
  for (int step = 0; step < most; ++step) {
    const double next = u - value(u) / (4 * u * u * u - 2 * p.s * p.R);
    if (!(next < u) || next < least)
      break; // from above Newton's steps only fall, until rounding
    u = next;
  }
  return state_at(p, u);
}

} // namespace granum::contact

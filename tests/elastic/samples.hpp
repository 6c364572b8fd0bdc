// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cmath>
#include <random>

#include <granum/core/vec3.hpp>
#include <granum/elastic/stiffness.hpp>
#include <granum/elastic/transverse_isotropic.hpp>

/// A triclinic, symmetric, positive definite stiffness without any small entry [Pa].
inline granum::elastic::VoigtStiffness triclinic_sample() {
  granum::elastic::VoigtStiffness c;
  c.matrix << 310, 118, 133, 12, -7, 9, //
      118, 345, 127, -11, 14, 5,        //
      133, 127, 402, 8, 6, -13,         //
      12, -11, 8, 121, 10, -4,          //
      -7, 14, 6, 10, 115, 3,            //
      9, 5, -13, -4, 3, 96;
  c.matrix *= 1e6;
  return c;
}

/// Stiffer along the vertical, as a packing under triaxial compression [Pa].
inline granum::elastic::TransverselyIsotropic layered_sample() {
  return {.C11 = 310e6, .C33 = 402e6, .C12 = 118e6, .C13 = 133e6, .C44 = 121e6};
}

/// Rotation by `angle` [rad] about the direction of `axis` (Rodrigues' formula).
inline granum::Mat3 rotation_about(granum::Vec3 axis, double angle) {
  using namespace granum;
  axis *= 1 / norm(axis);
  const Mat3 skew{{{0, -axis.z, axis.y}, {axis.z, 0, -axis.x}, {-axis.y, axis.x, 0}}};
  return Mat3::identity() + std::sin(angle) * skew + (1 - std::cos(angle)) * (skew * skew);
}

/// A number in [low, high) from the generator's own bits, the same with every standard library.
inline double uniform(std::mt19937_64& random, double low, double high) {
  return low + (high - low) * static_cast<double>(random() >> 11) * 0x1p-53;
}

inline granum::Vec3 random_vector(std::mt19937_64& random) {
  const double x = uniform(random, -1, 1), y = uniform(random, -1, 1), z = uniform(random, -1, 1);
  return {x, y, z};
}

/// A positive definite material whose shear moduli are between 1/50 and 1 of C33 = 400 MPa, and whose
/// C13 is `low` to `high` of the largest that it can have.
inline granum::elastic::TransverselyIsotropic random_layered(std::mt19937_64& random, double low,
                                                             double high) {
  const double C33 = 400e6;
  const double C44 = C33 * std::pow(50, uniform(random, -1, 0));
  const double C66 = C33 * std::pow(50, uniform(random, -1, 0));
  const double C11 = C66 + C33 * uniform(random, 0.3, 1.5);
  const double C12 = C11 - 2 * C66;
  const double C13 = uniform(random, low, high) * std::sqrt(C33 * (C11 + C12) / 2);
  return {.C11 = C11, .C33 = C33, .C12 = C12, .C13 = C13, .C44 = C44};
}

/// Distance of a result from its reference in units of the last place of a double there.
inline double ulps(double value, long double reference) {
  const long double place = std::ldexp(1.0L, std::ilogb(reference) - 52);
  return static_cast<double>(std::abs(static_cast<long double>(value) - reference) / place);
}

namespace granum::test {

/// What a few products of 6 x 6 lose.
constexpr double rounding = 1e-14;
inline const Mat3 tilt = rotation_about({1, -2, 0.5}, 0.8);

} // namespace granum::test

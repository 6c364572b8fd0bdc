// SPDX-License-Identifier: GPL-3.0-or-later
// Notation: n unit direction; s, c sine and cosine of its angle with axis 3; s2, c2 their squares. g11, g13,
// g33 Christoffel matrix in the plane of n and axis 3, p and sv its eigenvalues, sh the third.
#include <granum/elastic/christoffel.hpp>

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>
#include <cstdio>

#include <granum/core/error.hpp>
#include <granum/elastic/mandel.hpp>

#include "core/compiled_once.hpp"
#include "direction.hpp"

namespace granum::elastic {

namespace {

constexpr double semidefinite_tolerance = 1e-12; // above the rounding of whatever made the matrix

void require_semidefinite(const VoigtStiffness& stiffness) {
  const double smallest = relative_smallest_eigenvalue(mandel(stiffness));
  if (!(smallest >= -semidefinite_tolerance)) {
    char text[160];
    std::snprintf(
        text, sizeof text,
        "no wave speeds: the stiffness is not positive semidefinite, its smallest eigenvalue is %.3g "
        "of the largest",
        smallest);
    throw InvalidArgument(text);
  }
}

/// The 3 x 6 matrix that contracts a Voigt stress with a vector, and by its transpose makes the engineering
/// strain of the displacement gradient u n^T from u.
Eigen::Matrix<double, 3, 6> contraction(const Vec3& n) {
  Eigen::Matrix<double, 3, 6> m;
  m << n.x, 0, 0, 0, n.z, n.y, //
      0, n.y, 0, n.z, 0, n.x,  //
      0, 0, n.z, n.y, n.x, 0;
  return m;
}

Matrix6 symmetric_part(const VoigtStiffness& c) { return c.matrix / 2 + c.matrix.transpose() / 2; }

/// a d - b c with an error of 1.5 ulp, whatever cancels. [Jeannerod2013]
double difference_of_products(double a, double d, double b, double c) {
  const double bc = b * c;
  const double rounding = std::fma(-b, c, bc);
  return std::fma(a, d, -bc) + rounding;
}

/// The power of two below the largest modulus, its bits without the fraction: moduli over it have products
/// within the range of doubles, and their own digits.
double unit_of(const TransverselyIsotropic& c) {
  const double largest = std::max({c.C11, c.C33, c.C44});
  constexpr std::uint64_t exponent = 0x7ff0000000000000;
  const auto unit = std::bit_cast<double>(std::bit_cast<std::uint64_t>(largest) & exponent);
  return unit > 0 ? unit : 1; // 1 for a modulus of zero, or too small to have an exponent
}

TransverselyIsotropic over(const TransverselyIsotropic& c, double unit) {
  const double f = 1 / unit;
  return {.C11 = f * c.C11, .C33 = f * c.C33, .C12 = f * c.C12, .C13 = f * c.C13, .C44 = f * c.C44};
}

/// Semidefinite beyond doubt; the full matrix decides where rounding could.
bool clearly_semidefinite(const TransverselyIsotropic& c) {
  return c.C44 >= 0 && c.C11 >= std::abs(c.C12) && c.C33 >= 0 &&
         c.C33 * (c.C11 + c.C12) - 2 * c.C13 * c.C13 >= 0 && std::isfinite(c.C11 + c.C33 + c.C44);
}

/// density v^2 of the three waves.
struct Eigenvalues {
  double p, sv, sh;
};

/// Unit vector (horizontal, vertical) of the quasi-P wave in the plane of n and the axis.
struct InPlane {
  double h, v;
};

InPlane unit(double h, double v) {
  const double length = std::sqrt(h * h + v * v);
  return {h / length, v / length};
}

} // namespace

PlaneWaves plane_waves(const VoigtStiffness& stiffness, double bulk_density, const Vec3& direction) {
  require_positive("bulk_density", bulk_density, "kg/m3");
  const Vec3 n = unit_along("direction", direction);
  require_semidefinite(stiffness);
  const Eigen::Matrix<double, 3, 6> m = contraction(n);
  const Eigen::Matrix3d gamma = m * symmetric_part(stiffness) * m.transpose();
  const SymmetricEigen<3> system = symmetric_eigen<3>(gamma);
  const auto wave = [&](int k) { // eigenvalues come in ascending order
    const auto u = system.vectors.col(k);
    return PlaneWave{.speed = std::sqrt(std::max(system.values[k], 0.0) / bulk_density),
                     .polarisation = {u[0], u[1], u[2]}};
  };
  PlaneWaves waves{.fastest = wave(2), .middle = wave(1), .slowest = wave(0)};
  if (dot(waves.fastest.polarisation, n) < 0)
    waves.fastest.polarisation = -waves.fastest.polarisation;
  return waves;
}

std::array<PlaneWaves, 3> plane_waves_along_axes(const VoigtStiffness& stiffness, double bulk_density) {
  return {plane_waves(stiffness, bulk_density, {1, 0, 0}), plane_waves(stiffness, bulk_density, {0, 1, 0}),
          plane_waves(stiffness, bulk_density, {0, 0, 1})};
}

TransverselyIsotropicWaves plane_waves(const TransverselyIsotropic& stiffness, double bulk_density,
                                       const Vec3& direction) {
  require_positive("bulk_density", bulk_density, "kg/m3");
  const Vec3 n = unit_along("direction", direction);
  const double scale = unit_of(stiffness);
  const TransverselyIsotropic c = over(stiffness, scale);
  if (!clearly_semidefinite(c))
    require_semidefinite(voigt(stiffness));

  const double s2 = n.x * n.x + n.y * n.y, c2 = n.z * n.z, s = std::sqrt(s2);
  const bool on_axis = s < 1e-140; // below it the squares of n1 and n2 lose their digits
  const double cos_azimuth = on_axis ? 1 : n.x / s, sin_azimuth = on_axis ? 0 : n.y / s;

  const double half_difference = ((c.C11 - c.C44) * s2 - (c.C33 - c.C44) * c2) / 2; // of g11 and g33
  const double g13 = (c.C13 + c.C44) * s * n.z;
  const double root = std::sqrt(half_difference * half_difference + g13 * g13);
  const double p = ((c.C11 + c.C44) * s2 + (c.C33 + c.C44) * c2) / 2 + root;
  // g11 g33 - g13^2 in two sums, each of which is a product of small factors where it is small: the quotient
  // gives a slow root its digits, which mean - root would lose.
  const double determinant = c.C44 * ((c.C11 * s2 - c.C13 * c2) * s2 + (c.C33 * c2 - c.C13 * s2) * c2) +
                             difference_of_products(c.C11, c.C33, c.C13, c.C13) * s2 * c2;
  const Eigenvalues eigenvalues{
      .p = p, .sv = p > 0 ? std::min(determinant / p, p) : 0, .sh = c.C66() * s2 + c.C44 * c2};

  const InPlane along = root == 0              ? unit(s, n.z)
                        : half_difference >= 0 ? unit(half_difference + root, g13)
                                               : unit(g13, root - half_difference);
  const double sense = along.h * s + along.v * n.z < 0 ? -1 : 1;
  const double h = sense * along.h, v = sense * along.v;

  const auto speed = [&](double eigenvalue) {
    return std::sqrt(std::max(eigenvalue, 0.0) * (scale / bulk_density));
  };
  return {.quasi_p = {speed(eigenvalues.p), {h * cos_azimuth, h * sin_azimuth, v}},
          .quasi_s = {speed(eigenvalues.sv), {v * cos_azimuth, v * sin_azimuth, -h}},
          .pure_s = {speed(eigenvalues.sh), {-sin_azimuth, cos_azimuth, 0}}};
}

Vec3 group_velocity(const VoigtStiffness& stiffness, double bulk_density, const Vec3& direction,
                    const PlaneWave& wave) {
  require_positive("bulk_density", bulk_density, "kg/m3");
  require_positive("speed of the wave", wave.speed, "m/s");
  require_symmetric<6>("stiffness", stiffness.matrix);
  const Eigen::Vector3d p(wave.polarisation.x, wave.polarisation.y, wave.polarisation.z);
  const Eigen::Vector<double, 6> strain = contraction(unit_along("direction", direction)).transpose() * p;
  const Eigen::Vector3d flux = contraction(wave.polarisation) * (symmetric_part(stiffness) * strain);
  const double f = 1 / (bulk_density * wave.speed);
  return {f * flux[0], f * flux[1], f * flux[2]};
}

} // namespace granum::elastic

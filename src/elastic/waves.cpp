// SPDX-License-Identifier: GPL-3.0-or-later
#include <granum/elastic/waves.hpp>

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>
#include <cstdio>

#include <granum/core/error.hpp>
#include <granum/core/text.hpp>
#include <granum/elastic/stiffness.hpp>

#include "core/compiled_once.hpp"
#include "parts.hpp"

namespace granum::elastic {

double bulk_density(const GrainsAndPores& packing) {
  const double grains = require_positive("grain_density", packing.grain_density, "kg/m3");
  const double e = require_non_negative("void_ratio", packing.void_ratio);
  const double pores = require_non_negative("pore_density", packing.pore_density, "kg/m3");
  return (grains + e * pores) / (1 + e);
}

WaveSpeeds wave_speeds(const Isotropic& solid, double bulk_density) {
  require_positive("bulk_density", bulk_density, "kg/m3");
  if (std::isinf(solid.bulk_modulus()))
    throw InvalidArgument("an incompressible solid (Poisson's ratio 0.5) has no finite P-wave speed");
  const double axial = solid.bulk_modulus() + 4 * solid.shear_modulus() / 3;
  return {.p = std::sqrt(axial / bulk_density), .s = std::sqrt(solid.shear_modulus() / bulk_density)};
}

double shear_modulus_from_speed(double shear_wave_speed, double bulk_density) {
  require_non_negative("shear_wave_speed", shear_wave_speed, "m/s");
  require_positive("bulk_density", bulk_density, "kg/m3");
  return bulk_density * (shear_wave_speed * shear_wave_speed);
}

Isotropic isotropic_from_speeds(const WaveSpeeds& speeds, double bulk_density) {
  const double V_s = require_positive("shear_wave_speed", speeds.s, "m/s");
  const double V_p = require_positive("compression_wave_speed", speeds.p, "m/s");
  const double shear_modulus = shear_modulus_from_speed(V_s, bulk_density);
  const double bulk_modulus = bulk_density * ((V_p - V_s) * (V_p + V_s) - V_s * V_s / 3);
  if (!(bulk_modulus > 0))
    throw InvalidArgument("compression_wave_speed", V_p, "m/s", "(sqrt(4/3) shear_wave_speed, inf)");
  return Isotropic::from_bulk_and_shear(bulk_modulus, shear_modulus);
}

// Notation: n unit direction; s, c sine and cosine of its angle with axis 3; s2, c2 their squares. g11, g13,
// g33 Christoffel matrix in the plane of n and axis 3, p and sv its eigenvalues, sh the third.

namespace {

constexpr double semidefinite_tolerance = 1e-12; // above the rounding of whatever made the matrix

/// Whether a matrix has a Cholesky factor: then no eigenvalue is below 0 by more than rounding.
bool has_cholesky_factor(Matrix6 m) {
  for (int k = 0; k < 6; ++k) {
    if (!(m(k, k) > 0))
      return false;
    for (int i = k + 1; i < 6; ++i) {
      const double f = m(i, k) / m(k, k);
      for (int j = k + 1; j <= i; ++j)
        m(i, j) -= f * m(j, k);
    }
  }
  return true;
}

void require_semidefinite(const VoigtStiffness& stiffness) {
  const MandelStiffness c = mandel(stiffness);
  require_symmetric<6>("stiffness", c.matrix);
  if (has_cholesky_factor(c.matrix / 2 + c.matrix.transpose() / 2))
    return; // as every stiffness does that is not nearly singular: eigenvalues take ten times as long
  const double smallest = relative_smallest_eigenvalue(c);
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
  // g11 g33 - g13^2 in two sums, each a product of small factors where it is small: the quotient
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

namespace {

/// a + b + c with the rounding of both additions put back: exact but for the last place, even where the sum
/// is a small remainder of its terms.
double compensated_sum(double a, double b, double c) {
  const auto rounding = [](double x, double y, double sum) {
    const double x_in_sum = sum - y;
    return (x - x_in_sum) + (y - (sum - x_in_sum));
  };
  const double ab = a + b;
  const double abc = ab + c;
  return abc + (rounding(a, b, ab) + rounding(ab, c, abc));
}

void require_positive_definite(const TransverselyIsotropic& c) {
  if (!c.positive_definite())
    throw InvalidArgument("Thomsen parameters need a finite and positive definite stiffness");
}

/// C13 less its isotropic value C33 - 2 C44.
double excess(const TransverselyIsotropic& c) { return compensated_sum(c.C13, 2 * c.C44, -c.C33); }

ThomsenParameters with_delta(const TransverselyIsotropic& c, double delta) {
  return {.epsilon = (c.C11 - c.C33) / (2 * c.C33),
          .delta = delta,
          .gamma = compensated_sum(c.C11, -c.C12, -2 * c.C44) / (4 * c.C44)};
}

} // namespace

ThomsenParameters thomsen_parameters(const TransverselyIsotropic& c) {
  require_positive_definite(c);
  if (!(c.C33 > c.C44))
    throw InvalidArgument("C33", c.C33, "Pa", "(C44, inf): Thomsen's delta needs V_p0 > V_s0");
  // (C13+C44)^2 - (C33-C44)^2 = (C13 + 2 C44 - C33)(C13 + C33)
  return with_delta(c, excess(c) / (2 * c.C33) * ((c.C13 + c.C33) / (c.C33 - c.C44)));
}

ThomsenParameters weak_thomsen_parameters(const TransverselyIsotropic& c) {
  require_positive_definite(c);
  return with_delta(c, excess(c) / c.C33);
}

ThomsenSolid thomsen_solid(const TransverselyIsotropic& c, double bulk_density) {
  require_positive("bulk_density", bulk_density, "kg/m3");
  const ThomsenParameters parameters = thomsen_parameters(c);
  return {.bulk_density = bulk_density,
          .vertical_p_speed = std::sqrt(c.C33 / bulk_density),
          .vertical_s_speed = std::sqrt(c.C44 / bulk_density),
          .anisotropy = parameters};
}

TransverselyIsotropic transversely_isotropic(const ThomsenSolid& solid) {
  const double density = require_positive("bulk_density", solid.bulk_density, "kg/m3");
  const double V_s = require_positive("vertical_s_speed", solid.vertical_s_speed, "m/s");
  const double V_p = require_positive("vertical_p_speed", solid.vertical_p_speed, "m/s");
  if (!(V_p > V_s))
    throw InvalidArgument("vertical_p_speed", V_p, "m/s", "(vertical_s_speed, inf)");
  const double epsilon = require_finite("epsilon", solid.anisotropy.epsilon);
  const double delta = require_finite("delta", solid.anisotropy.delta);
  const double gamma = require_finite("gamma", solid.anisotropy.gamma);

  const double C33 = density * V_p * V_p, C44 = density * V_s * V_s;
  const double difference = density * (V_p - V_s) * (V_p + V_s); // C33 - C44
  const double square = difference * (difference + 2 * delta * C33);
  if (!(square >= 0))
    throw InvalidArgument("delta", delta, "", "[-(1 - V_s0^2/V_p0^2)/2, inf)");
  TransverselyIsotropic c{.C11 = C33 * (1 + 2 * epsilon), .C33 = C33, .C12 = 0, .C13 = 0, .C44 = C44};
  c.C12 = c.C11 - 2 * C44 * (1 + 2 * gamma);
  // sqrt(square) - C44, as a quotient without cancellation
  c.C13 = C33 * ((difference - C44) + 2 * delta * difference) / (std::sqrt(square) + C44);
  if (!c.positive_definite())
    throw InvalidArgument("no positive definite stiffness has these Thomsen parameters");
  return c;
}

namespace {

constexpr double water = 2.18e9, air = 0.142e6; // [Pa]

} // namespace

double water_and_air_bulk_modulus(double saturation) {
  require_closed("saturation", saturation, 0, 1);
  return 1 / (saturation / water + (1 - saturation) / air);
}

double saturation_of_bulk_density(double bulk_density, double grain_density, double void_ratio) {
  const double rho = require_positive("bulk_density", bulk_density, "kg/m3");
  const double rho_s = require_positive("grain_density", grain_density, "kg/m3");
  const double e = require_positive("void_ratio", void_ratio);
  return ((1 + e) * rho - rho_s) / (e * water_density);
}

TransverselyIsotropic saturated(const TransverselyIsotropic& c, const SaturatedPores& pores) {
  const double K_s = require_positive("grain_bulk_modulus", pores.grain_bulk_modulus, "Pa");
  const double K_f = require_positive("fluid_bulk_modulus", pores.fluid_bulk_modulus, "Pa");
  const double n = require_positive("void_ratio", pores.void_ratio) / (1 + pores.void_ratio);
  if (!(c.bulk_modulus() <= K_s))
    throw InvalidArgument("grain_bulk_modulus", K_s, "Pa",
                          "[" + short_text(c.bulk_modulus()) +
                              ", inf): no skeleton is stiffer than its grains");
  const double a_h = 1 - (c.C11 + c.C12 + c.C13) / (3 * K_s);
  const double a_v = 1 - (2 * c.C13 + c.C33) / (3 * K_s);
  const double M = 1 / ((1 - c.bulk_modulus() / K_s - n) / K_s + n / K_f);
  return {.C11 = c.C11 + a_h * a_h * M,
          .C33 = c.C33 + a_v * a_v * M,
          .C12 = c.C12 + a_h * a_h * M,
          .C13 = c.C13 + a_h * a_v * M,
          .C44 = c.C44};
}

} // namespace granum::elastic

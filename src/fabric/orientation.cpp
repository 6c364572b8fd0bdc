// SPDX-License-Identifier: GPL-3.0-or-later
// Notation: a anisotropy of E(gamma) = 3 (1 + a cos 2 gamma)/(4 pi (3 - a)), with
// (3-a) P(t) = linear t + cubic t^3.
#include <granum/fabric/orientation.hpp>

#include <algorithm>
#include <cmath>
#include <numbers>

#include <boost/random/mersenne_twister.hpp>
#include <boost/random/uniform_real_distribution.hpp>

#include <granum/core/error.hpp>
#include <granum/core/stop.hpp>
#include <granum/core/text.hpp>

namespace granum::fabric {

double density(double polar_angle, double anisotropy) {
  require_finite("polar_angle", polar_angle, "rad");
  const double a = require_closed("fabric_anisotropy", anisotropy, -1, 1);
  return 3 * (1 + a * std::cos(2 * polar_angle)) / (4 * std::numbers::pi * (3 - a));
}

SecondMoments second_moments(double anisotropy) {
  const double a = require_closed("fabric_anisotropy", anisotropy, -5, 5.0 / 3);
  const double scale = 5 * (3 - a);
  return {.F11 = (5 - 3 * a) / scale, .F33 = (5 + a) / scale};
}

FourthMoments fourth_moments(double anisotropy) {
  const double a = require_closed("fabric_anisotropy", anisotropy, -7.0 / 3, 7.0 / 5);
  const double scale = 35 * (3 - a);
  return {.n1111 = 3 * (7 - 5 * a) / scale,
          .n3333 = 3 * (7 + 3 * a) / scale,
          .n1122 = (7 - 5 * a) / scale,
          .n1133 = (7 - a) / scale};
}

double anisotropy_from_F33(double F33) {
  require_closed("F33", F33, 0, 1);
  return 5 * (3 * F33 - 1) / (5 * F33 + 1);
}

Validity anisotropy_validity(double anisotropy) {
  Validity validity;
  if (std::abs(anisotropy) > 1)
    validity.add("fabric anisotropy " + detail::refused_text(anisotropy, "[-1, 1]", 4) +
                 " is outside [-1, 1]: the density of contact normals is negative in some directions");
  return validity;
}

double cumulative_probability(double polar_cosine, double anisotropy) {
  const double t = require_closed("polar_cosine", polar_cosine, 0, 1);
  const double a = require_closed("fabric_anisotropy", anisotropy, -1, 1);
  return t * (3 * (1 - a) + 2 * a * (t * t)) / (3 - a);
}

double polar_cosine_quantile(double probability, double anisotropy) {
  require_closed("probability", probability, 0, 1);
  const double a = require_closed("fabric_anisotropy", anisotropy, -1, 1);
  if (probability == 0 || probability == 1)
    return probability;
  const double linear = 3 * (1 - a), cubic = 2 * a, target = (3 - a) * probability;
  // Newton's rule from the root of the linear term alone. P is convex for a >= 0, where that root or 1 is an
  // upper bound, and concave for a < 0, where it is a lower one: the iterates run one way until rounding
  // stops them.
  double t = target < linear ? target / linear : 1;
  for (;;) {
    const double square = t * t;
    const double slope = linear + 3 * cubic * square;
    if (slope <= 0) // t = 1 at a = -1
      return t;
    const double next = std::min(t - (t * (linear + cubic * square) - target) / slope, 1.0);
    if (a >= 0 ? !(next < t) : !(next > t))
      return t;
    t = next;
  }
}

namespace {

/// Every measure from the coefficient of P2; its caller puts the measure that was given back in place. Clamps
/// undo the rounding at the ends of the range of unit vectors.
FabricMeasures from_coefficient(double a_c) {
  FabricMeasures m{.anisotropy = 3 * a_c / (4 + a_c),
                   .F11 = std::clamp((5 - a_c) / 15, 0.0, 0.5),
                   .F33 = std::clamp((5 + 2 * a_c) / 15, 0.0, 1.0),
                   .P2_coefficient = a_c,
                   .mean_cos_2gamma = std::clamp((4 * a_c - 5) / 15, -1.0, 1.0),
                   .validity = {}};
  return m;
}

FabricMeasures with_validity(FabricMeasures m) {
  m.validity = anisotropy_validity(m.anisotropy);
  return m;
}

} // namespace

FabricMeasures measures_from_anisotropy(double anisotropy) {
  const double a = require_closed("fabric_anisotropy", anisotropy, -5, 5.0 / 3);
  FabricMeasures m = from_coefficient(4 * a / (3 - a));
  m.anisotropy = a;
  return with_validity(m);
}

FabricMeasures measures_from_F33(double F33) {
  require_closed("F33", F33, 0, 1);
  FabricMeasures m = from_coefficient(2.5 * std::fma(3, F33, -1));
  m.F33 = F33;
  return with_validity(m);
}

FabricMeasures measures_from_P2_coefficient(double P2_coefficient) {
  return with_validity(from_coefficient(require_closed("P2_coefficient", P2_coefficient, -2.5, 5)));
}

FabricMeasures measures_from_mean_cos_2gamma(double mean_cos_2gamma) {
  require_closed("mean_cos_2gamma", mean_cos_2gamma, -1, 1);
  FabricMeasures m = from_coefficient(1.25 * std::fma(3, mean_cos_2gamma, 1));
  m.mean_cos_2gamma = mean_cos_2gamma;
  return with_validity(m);
}

Mat3 contact_tensor(const Mat3& fabric) {
  require_symmetric<3>("fabric", fabric);
  require_closed("trace of the fabric tensor", trace(fabric), 1 - 1e-6, 1 + 1e-6);
  return 7.5 * (fabric + (-1.0 / 3) * Mat3::identity());
}

Mat3 fabric_from_contact_tensor(const Mat3& contact_tensor) {
  require_symmetric<3>("contact_tensor", contact_tensor);
  require_closed("trace of the contact tensor", trace(contact_tensor), -1e-5, 1e-5);
  return (1 / 7.5) * contact_tensor + (1.0 / 3) * Mat3::identity();
}

std::vector<Vec3> sample_normals(double anisotropy, std::size_t count, std::uint64_t seed) {
  require_closed("fabric_anisotropy", anisotropy, -1, 1);
  boost::random::mt19937_64 bits(seed);
  boost::random::uniform_real_distribution<double> signed_unit(-1, 1);

  std::vector<Vec3> normals;
  normals.reserve(count);
  while (normals.size() < count) {
    stop_point(normals.size());
    const double height = signed_unit(bits);
    const double z = std::copysign(polar_cosine_quantile(std::abs(height), anisotropy), height);
    double x = 0, y = 0, square = 0;
    do {
      x = signed_unit(bits);
      y = signed_unit(bits);
      square = x * x + y * y;
    } while (square > 1 || square < 1e-20); // too near the centre the direction would lose digits
    const double stretch = std::sqrt((1 - z) * (1 + z) / square);
    normals.push_back({stretch * x, stretch * y, z});
  }
  return normals;
}

} // namespace granum::fabric

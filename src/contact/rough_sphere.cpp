// SPDX-License-Identifier: GPL-3.0-or-later
// Notation: s = 1/X, which is (f/f_1)^(2/3); m = 1/sqrt(h); E = d ln h/d ln X; L(s) = d/u0 - 1. With
// 1/k_n = u0/f (1 + s m) and f = f_1 s^(3/2), dL/d ln s = 3/2 (1 + s m): all rough spheres are one curve.
#include <granum/contact/rough_sphere.hpp>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

#include <granum/core/error.hpp>
#include <granum/core/numerics.hpp>
#include <granum/core/text.hpp>

namespace granum::contact {

namespace {

/// h(X) of the class, calibrated by validation/rough_contact. The expansion for small X begins with 4/3, and
/// s0 takes in what follows it.
constexpr double s0 = 1.316734, c = 0.834395, n = 1.090329;
constexpr double of_rough = 2 * std::numbers::pi / 3;

/// s at the onset of a contact, and beyond which roughness is below rounding.
constexpr int first_octave = -18, smooth_octave = 60;

struct CurveFactors {
  double m;
  double E;
  double by_log; ///< dE/d ln X
};

CurveFactors curve_factors(double X) {
  const double rough = 1 / (1 + std::pow(c * X, -n)); // q/(1 + q)
  const double S = s0 + (of_rough - s0) * rough;
  const double S1 = (of_rough - s0) * n * rough * (1 - rough); // dS/d ln X
  const double S2 = S1 * n * (1 - 2 * rough);
  const double h = 1 + X * S;
  const double E = X * (S + S1) / h;
  return {.m = 1 / std::sqrt(h), .E = E, .by_log = X * (S + 2 * S1 + S2) / h - E * E};
}

double power_3_2(double s) { return s * std::sqrt(s); }

/// L(s) and the energy over f_1 u0, as sums over octaves of s with a rule within the last.
class Curve {
 public:
  Curve() {
    Sums sum{};
    for (int octave = first_octave; octave < smooth_octave; ++octave) {
      sums_.push_back(sum);
      const double s = std::ldexp(1.0, octave);
      sum = at(2 * s, sum, s);
    }
    sums_.push_back(sum);
    fill_cells();
  }

  struct Sums {
    double length; ///< L
    double energy; ///< from the onset on
  };

  [[nodiscard]] Sums at(double s) const {
    const int octave = std::ilogb(s);
    return at(s, sums_[static_cast<std::size_t>(octave - first_octave)], std::ldexp(1.0, octave));
  }
  /// s where L(s) has a value, from a guess.
  [[nodiscard]] double s_of_length(double length, double guess) const {
    double s = guess;
    for (int round = 0; round < 60; ++round) {
      const double step = (length - at(s).length) / slope(s);
      s *= std::exp(step);
      if (std::abs(step) < 1e-9) // the next would be its square
        break;
    }
    return s;
  }
  [[nodiscard]] const RoughSphereKernel::Cell* cells() const { return cells_.data(); }

 private:
  static double slope(double s) { return 1.5 * (1 + s * curve_factors(1 / s).m); }

  /// From the sums at another s of the same octave.
  static Sums at(double s, const Sums& from, double start) {
    static const std::vector<QuadratureNode> rule = gauss_legendre(12);
    const double half = std::log(s / start) / 2;
    Sums sums{.length = from.length + 3 * half, .energy = from.energy + power_3_2(s) - power_3_2(start)};
    for (const auto& [x, weight] : rule) {
      const double here = start * std::exp(half * (1 + x));
      const double part = weight * half * 1.5 * here * curve_factors(1 / here).m;
      sums.length += part;
      sums.energy += power_3_2(here) * part;
    }
    return sums;
  }

  struct Node {
    double force, slope, curvature; ///< over f_1, by y
  };
  static Node node(double s) {
    const RoughStiffness rough = rough_stiffness(1 / s);
    const double force = power_3_2(s), slope = force / (1 + s * curve_factors(1 / s).m);
    return {force, slope, slope * slope * rough.exponent / force};
  }

  void fill_cells() {
    cells_.reserve(static_cast<std::size_t>(RoughSphereKernel::octaves) *
                   RoughSphereKernel::cells_per_octave);
    cells_.push_back({0, RoughSphereKernel::onset});
    double s = std::ldexp(1.0, first_octave);
    Node left = node(s);
    for (int octave = 0; octave < RoughSphereKernel::octaves; ++octave)
      for (int cell = 0; cell < RoughSphereKernel::cells_per_octave; ++cell) {
        const double end = std::ldexp(1 + (cell + 1.0) / RoughSphereKernel::cells_per_octave, octave);
        s = s_of_length(end - 1, s);
        const Node right = node(s);
        cells_.push_back(hermite(left, right, std::ldexp(1.0 / RoughSphereKernel::cells_per_octave, octave)));
        left = right;
      }
  }

  /// The polynomial with the values, slopes and curvatures of both ends.
  static RoughSphereKernel::Cell hermite(const Node& a, const Node& b, double w) {
    const double rise = b.force - a.force - w * (a.slope + w / 2 * a.curvature);
    const double turn = w * (b.slope - a.slope - w * a.curvature);
    const double bend = w * w * (b.curvature - a.curvature);
    const double w3 = w * w * w;
    return {a.force,
            a.slope,
            a.curvature / 2,
            (10 * rise - 4 * turn + bend / 2) / w3,
            (-15 * rise + 7 * turn - bend) / (w3 * w),
            (6 * rise - 3 * turn + bend / 2) / (w3 * w * w)};
  }

  std::vector<Sums> sums_;
  std::vector<RoughSphereKernel::Cell> cells_;
};

const Curve& curve() {
  static const Curve the_curve;
  return the_curve;
}

} // namespace

RoughStiffness rough_stiffness(double X) {
  const auto [m, E, by_log] = curve_factors(X);
  const double ratio = 1 / (X + m);
  const double A = X - m * E / 2; // -d ratio/d ln X over ratio^2
  const double dA = X + m * (E * E / 4 - by_log / 2);
  return {.ratio = ratio,
          .exponent = 1.0 / 3 + 2.0 / 3 * ratio * A,
          .exponent_slope = -4.0 / 9 * ratio * (dA - ratio * A * A)};
}

RoughSphere::RoughSphere(const GrainMaterial& grain, double radius, double roughness)
    : RoughSphere(PowerLaw::sphere(grain, radius),
                  require_closed("roughness", roughness, 0,
                                 std::min(largest_roughness, require_positive("radius", radius, "m")), "m")) {
}

RoughSphere::RoughSphere(const PowerLaw& smooth, double roughness)
    : smooth_(smooth), roughness_(roughness),
      // k_H = f/u0: with f = c d^(3/2) and k_H = 3/2 f/d that is d = 3/2 u0.
      transition_force_(smooth.coefficient() * power_3_2(1.5 * roughness)) {}

RoughSphere RoughSphere::of_numbers(const GrainMaterial& grain, const std::array<double, 3>& numbers) {
  if (numbers[0] != 2)
    throw InvalidArgument("alpha of a rough sphere", numbers[0], "", "2");
  return {PowerLaw::of_numbers(grain, {numbers[0], numbers[1]}),
          require_closed("roughness", numbers[2], 0, largest_roughness, "m")};
}

RoughSphere RoughSphere::of_grain(const GrainMaterial& grain) const {
  return {smooth_.of_grain(grain), roughness_};
}

RoughSphere RoughSphere::of(const GrainMaterial& grain, double radius) const {
  return {grain, radius, roughness_};
}

RoughSphere RoughSphere::of_pair_radius(double ratio) const {
  return {smooth_.of_pair_radius(ratio), roughness_};
}

double RoughSphere::roughness_number(double force) const {
  return roughness_ * smooth_.stiffness_at_force(force) / force;
}

bool RoughSphere::is_smooth(double force) const {
  return is_smooth() || (force > 0 && roughness_number(force) < std::ldexp(1.0, -smooth_octave));
}

double RoughSphere::smoothness_at_overlap(double overlap) const {
  const double y = overlap / roughness_;
  const double guess =
      y < 0x1p31 ? std::cbrt(RoughSphereKernel{1, 1, curve().cells()}(y).force) : std::sqrt(y / 1.5);
  return curve().s_of_length(y - 1, guess * guess);
}

double RoughSphere::force(double overlap) const {
  if (is_smooth())
    return smooth_.force(overlap);
  require_non_negative("overlap", overlap, "m");
  if (overlap <= roughness_)
    return RoughSphereKernel::onset * transition_force_ * (overlap / roughness_);
  if (overlap / roughness_ > std::ldexp(1.5, smooth_octave))
    return smooth_.force(overlap);
  return transition_force_ * power_3_2(smoothness_at_overlap(overlap));
}

double RoughSphere::overlap(double force) const {
  require_non_negative("force", force, "N");
  if (is_smooth(force))
    return smooth_.overlap(force);
  const double first = RoughSphereKernel::onset * transition_force_;
  if (force <= first)
    return roughness_ * (force / first);
  const double s = std::max(1 / roughness_number(force), std::ldexp(1.0, first_octave));
  return roughness_ * (1 + curve().at(s).length);
}

double RoughSphere::stiffness_at_overlap(double overlap) const {
  return is_smooth() ? smooth_.stiffness_at_overlap(overlap) : stiffness_at_force(force(overlap));
}

double RoughSphere::stiffness_at_force(double force) const {
  const double smooth = smooth_.stiffness_at_force(force);
  if (is_smooth())
    return smooth;
  const double first = RoughSphereKernel::onset * transition_force_;
  if (force < first)
    return first / roughness_;
  return smooth * rough_stiffness(roughness_ * smooth / force).ratio;
}

double RoughSphere::exponent_at_force(double force) const {
  require_non_negative("force", force, "N");
  if (is_smooth())
    return smooth_.stiffness_exponent();
  return force < RoughSphereKernel::onset * transition_force_
             ? 0
             : rough_stiffness(roughness_number(force)).exponent;
}

double RoughSphere::exponent_slope_at_force(double force) const {
  require_non_negative("force", force, "N");
  if (is_smooth() || force < RoughSphereKernel::onset * transition_force_)
    return 0;
  return rough_stiffness(roughness_number(force)).exponent_slope;
}

Surface RoughSphere::surface() const {
  return {.stiffening = is_smooth() ? Stiffening::power_law : Stiffening::rough,
          .begins_at_touch = is_smooth(),
          .transition_force = transition_force_};
}

double RoughSphere::first_stiffness() const { return stiffness_at_force(0x1p-10 * transition_force_); }

std::optional<double> RoughSphere::constant_exponent() const {
  return is_smooth() ? smooth_.constant_exponent() : std::nullopt;
}

double RoughSphere::energy(double overlap) const {
  const double f = force(overlap);
  if (is_smooth(f))
    return smooth_.energy(overlap);
  if (overlap <= roughness_)
    return f * overlap / 2;
  const double unit = transition_force_ * roughness_;
  return unit * (RoughSphereKernel::onset / 2 + curve().at(smoothness_at_overlap(overlap)).energy);
}

RoughSphere::Kernel RoughSphere::kernel() const {
  // c = 2 G sqrt(2R)/(3(1-nu)).
  const double per_modulus =
      1.5 * smooth_.coefficient() * (1 - grain().poisson_ratio) / grain().shear_modulus;
  const double radius = per_modulus * per_modulus / 2;
  if (is_smooth() || roughness_ < 0x1p-30 * radius)
    return SphereKernel{smooth_.coefficient()};
  return RoughSphereKernel{transition_force_, 1 / roughness_, curve().cells()};
}

std::string RoughSphere::text() const {
  return "RoughSphere(roughness=" + exact_text(roughness_) + ", smooth=" + smooth_.text() + ")";
}

} // namespace granum::contact

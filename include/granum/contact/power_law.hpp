// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cmath>
#include <optional>
#include <string>
#include <variant>

#include <granum/contact/solid.hpp>

/// Normal contact of two identical elastic grains whose profiles are z = A r^alpha near the contact.
/// Overlap is always the full approach d of the two grain centres; compression is positive.
namespace granum::contact {

/// Normal force and its derivative at one overlap.
struct NormalResponse {
  double force = 0;     ///< f [N]
  double stiffness = 0; ///< k_n = df/dd [N/m]
};

/// The kernels f = c d^(1+1/alpha), k_n = (1+1/alpha) f/d: unchecked, noexcept, one small type a law so that
/// a sweep over contacts is compiled for its law. Assumes overlap >= 0. One that depends on the size of the
/// grains has of_pair_radius.
struct ConeKernel {
  double coefficient;
  NormalResponse operator()(double overlap) const noexcept {
    const double cd = coefficient * overlap;
    return {cd * overlap, 2 * cd};
  }
};
struct SphereKernel {
  double coefficient;
  NormalResponse operator()(double overlap) const noexcept {
    const double root = coefficient * std::sqrt(overlap);
    return {root * overlap, 1.5 * root};
  }
  /// The kernel of a pair whose pair_radius is this multiple of this kernel's; c is proportional to its root.
  [[nodiscard]] SphereKernel of_pair_radius(double ratio) const noexcept {
    return {coefficient * std::sqrt(ratio)};
  }
};
struct FlatKernel {
  double coefficient;
  NormalResponse operator()(double overlap) const noexcept { return {coefficient * overlap, coefficient}; }
};
struct GeneralKernel {
  double coefficient;
  double inverse_alpha;
  NormalResponse operator()(double overlap) const noexcept {
    const double root = coefficient * std::pow(overlap, inverse_alpha);
    return {root * overlap, (1 + inverse_alpha) * root};
  }
};

/// Power-law contact f = c d^(1+1/alpha) of two identical elastic grains. [Galin1946; Sneddon1965; Chung2014]
/// Assumes   identical grains, contact radius small against the grain, monotonic loading.
/// Checked by tests/contact/test_power_law.cpp
class PowerLaw {
 public:
  using Kernel = std::variant<ConeKernel, SphereKernel, FlatKernel, GeneralKernel>;

  /// alpha = 1: cones, c = G/(pi (1-nu) A_1).                                                   [Sneddon1965]
  /// \param    slope   A_1 > 0, tangent of the flank angle [1]
  /// \throws   InvalidArgument if grain or slope is out of range
  /// Accuracy  3 ulp.  Checked by tests/contact/test_power_law.cpp
  [[nodiscard]] static PowerLaw cone(const GrainMaterial& grain, double slope);
  /// alpha = 2: spheres, A_2 = 1/(2R), c = 2 G sqrt(2R)/(3(1-nu)).                                [Hertz1882]
  /// \param    radius   R > 0 of each sphere [m]
  /// \throws   InvalidArgument if grain or radius is out of range
  /// Accuracy  3 ulp.  Checked by tests/contact/test_power_law.cpp
  [[nodiscard]] static PowerLaw sphere(const GrainMaterial& grain, double radius);
  /// alpha = infinity: flat punches, c = 2 G a/(1-nu) = k_n at every force.                     [Sneddon1965]
  /// \param    punch_radius   a > 0 [m]
  /// \throws   InvalidArgument if grain or radius is out of range
  /// Accuracy  2 ulp.  Checked by tests/contact/test_power_law.cpp
  [[nodiscard]] static PowerLaw flat(const GrainMaterial& grain, double punch_radius);
  /// Any finite alpha: c = 2 G/(1-nu) alpha/(alpha+1) (g/A)^(1/alpha), g = Gamma((alpha+1)/2)/(2 sqrt(pi)
  /// Gamma(alpha/2+1)), which tends to the flat punch of radius A^(-1/alpha).        [Galin1946; Sneddon1965]
  /// Below 1 the profile is a cusp, b from 1/2 to 1: for closed forms and networks of given forces alone.
  /// \param    alpha              0 < alpha < infinity
  /// \param    profile_constant   A_alpha > 0 of one grain [m^(1-alpha)]
  /// \throws   InvalidArgument for alpha <= 0, infinite alpha (use flat), a constant that is out of range
  /// Accuracy  8 ulp, for alpha = 1 and 2 as cone and sphere.  Checked by tests/contact/test_power_law.cpp
  [[nodiscard]] static PowerLaw general(const GrainMaterial& grain, double alpha, double profile_constant);
  /// The law with these numbers(), 0 < alpha <= infinity and c > 0, to the bit.
  /// \throws   InvalidArgument if one is out of range.  Checked by tests/contact/test_laws.cpp
  [[nodiscard]] static PowerLaw of_numbers(const GrainMaterial& grain, const std::array<double, 2>& numbers);

  /// The same profile of another solid: c is proportional to G/(1-nu).
  /// \throws   InvalidArgument if grain is out of range
  /// Accuracy  3 ulp more than this law.  Checked by tests/contact/test_power_law.cpp
  [[nodiscard]] PowerLaw of_grain(const GrainMaterial& grain) const;
  /// The law of two equal grains of another solid and size: of spheres, alpha = 2, sphere(grain, radius); any
  /// other profile is one of the surface, of_grain(grain).
  /// \throws   InvalidArgument as those.  Accuracy  that of those.  Checked by tests/contact/test_laws.cpp
  [[nodiscard]] PowerLaw of(const GrainMaterial& grain, double radius) const;
  /// Whether the law of a pair depends on the sizes of its grains: alpha = 2. Any other profile is one of the
  /// surface, A_alpha being given in absolute terms: all pairs have the law of two equal grains.
  [[nodiscard]] bool depends_on_size() const { return alpha_ == 2; }
  /// The law of a pair whose pair_radius is so many times that of this law's pair (grains.hpp).
  /// \throws   InvalidArgument if the ratio is not positive and finite
  [[nodiscard]] PowerLaw of_pair_radius(double ratio) const;
  /// The law of another coefficient, c times a factor; pairs of grains of different sizes: grains.hpp.
  /// \throws   InvalidArgument if the factor is not positive and finite
  /// Accuracy  1 ulp.  Checked by tests/contact/test_pair.cpp
  [[nodiscard]] PowerLaw times(double factor) const;

  /// alpha in (0, inf]; infinity for the flat punch.
  [[nodiscard]] double alpha() const { return alpha_; }
  /// 1/(1+alpha): the exponent b of k_n ~ f^b, 0 for the flat punch.
  [[nodiscard]] double stiffness_exponent() const { return 1 / (1 + alpha_); }
  /// That b is the same at every force.
  [[nodiscard]] std::optional<double> constant_exponent() const { return stiffness_exponent(); }
  [[nodiscard]] static Surface surface() { return {}; }
  [[nodiscard]] const PowerLaw& closing_law() const { return *this; }
  [[nodiscard]] static double first_stiffness() { return 0; }
  [[nodiscard]] double exponent_at_force(double /*force*/) const { return stiffness_exponent(); }
  [[nodiscard]] static double exponent_slope_at_force(double /*force*/) { return 0; }
  /// 1 + 1/alpha: the exponent of f ~ d^(1+1/alpha).
  [[nodiscard]] double force_exponent() const { return 1 + 1 / alpha_; }
  /// c in f = c d^(1+1/alpha) with d the full approach [N m^-(1+1/alpha)].
  [[nodiscard]] double coefficient() const { return coefficient_; }
  /// A_alpha of one grain, from c [m^(1-alpha)]; infinite if it exceeds a double.
  /// Accuracy  relative alpha 1e-15.  Checked by tests/contact/test_power_law.cpp
  [[nodiscard]] double profile_constant() const;
  [[nodiscard]] const GrainMaterial& grain() const { return grain_; } ///< material of both grains

  /// Normal force of the overlap.                                                          [Chung2014, Eq. 3]
  /// \param    overlap   d >= 0, full approach [m]
  /// \return   f [N]
  /// \throws   InvalidArgument if the overlap is negative or not finite
  /// Accuracy  8 ulp.  Checked by tests/contact/test_power_law.cpp and validation/accuracy
  [[nodiscard]] double force(double overlap) const;
  /// Overlap at a force, the inverse of force().
  /// \param    force   f >= 0 [N]
  /// \return   d [m], 0 at zero force
  /// \throws   InvalidArgument if the force is negative or not finite
  /// Accuracy  8 ulp.  Checked by tests/contact/test_power_law.cpp and validation/accuracy
  [[nodiscard]] double overlap(double force) const;
  /// Tangent stiffness k_n = df/dd = 2 G a/(1-nu).
  /// \param    overlap   d >= 0, full approach [m]
  /// \return   k_n [N/m]
  /// \throws   InvalidArgument if the overlap is negative or not finite
  /// Accuracy  8 ulp.  Checked by tests/contact/test_power_law.cpp and validation/accuracy
  [[nodiscard]] double stiffness_at_overlap(double overlap) const;
  /// The same at a force: k_n = (1+1/alpha) c^(alpha/(1+alpha)) f^(1/(1+alpha)).   [Chung2014, Eq. 4, halved]
  /// \param    force   f >= 0 [N]
  /// \return   k_n [N/m]; 0 at zero force except for the flat punch
  /// \throws   InvalidArgument if the force is negative or not finite
  /// Accuracy  8 ulp.  Checked by tests/contact/test_power_law.cpp and validation/accuracy
  [[nodiscard]] double stiffness_at_force(double force) const;
  /// Elastic energy alpha/(2 alpha+1) f d, the integral of the force.
  /// \param    overlap   d >= 0, full approach [m]
  /// \return   U [J]
  /// \throws   InvalidArgument if the overlap is negative or not finite
  /// Accuracy  8 ulp.  Checked by tests/contact/test_power_law.cpp and validation/accuracy
  [[nodiscard]] double energy(double overlap) const;
  /// Radius of the contact disc, k_n (1-nu)/(2 G).
  /// \param    overlap   d >= 0, full approach [m]
  /// \return   a [m]
  /// \throws   InvalidArgument if the overlap is negative or not finite
  /// Accuracy  8 ulp.  Checked by tests/contact/test_power_law.cpp
  [[nodiscard]] double contact_radius(double overlap) const;

  /// The unchecked kernel of this law, for sweeps; within 1e-14 of force() and stiffness_at_overlap().
  [[nodiscard]] Kernel kernel() const;
  [[nodiscard]] const PowerLaw* power_law() const { return this; }
  /// alpha and c: laws of the same ones have the same forces.
  [[nodiscard]] std::array<double, 2> numbers() const { return {alpha_, coefficient_}; }
  /// "PowerLaw(alpha=2, coefficient=...)": kind and numbers, for people who compare two.
  [[nodiscard]] std::string text() const;

  /// Same profile of same grains.
  bool operator==(const PowerLaw&) const = default;

 private:
  PowerLaw(const GrainMaterial& grain, double alpha, double coefficient);

  GrainMaterial grain_;
  double alpha_ = 2;
  double coefficient_ = 0;
  double unit_force_stiffness_ = 0; ///< k_n at f = 1 N: k_n = unit_force_stiffness_ f^b
};

/// k_t/k_n = 2(1-nu)/(2-nu) of the no-slip contact of identical grains, any axisymmetric profile.
///                                                                            [Mindlin1949; Chung2014, Eq. 8]
/// \param    poisson_ratio   nu_g of the grain, -1 < nu_g <= 0.5
/// \throws   InvalidArgument outside that range
/// Accuracy  3 ulp.  Checked by tests/contact/test_power_law.cpp
[[nodiscard]] double mindlin_stiffness_ratio(double poisson_ratio);

/// A ratio k_t/k_n that the caller knows, checked: 0 is the frictionless contact.
/// \throws   InvalidArgument unless 0 <= ratio and finite
[[nodiscard]] double given_stiffness_ratio(double ratio);

} // namespace granum::contact

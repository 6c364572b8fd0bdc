// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cmath>
#include <variant>

/// Normal contact of two identical elastic grains whose profiles are z = A r^alpha near the contact.
/// Overlap is always the full approach d of the two grain centres; compression is positive.
namespace granum::contact {

/// Isotropic elastic solid of a grain.
struct GrainMaterial {
  double shear_modulus = 0; ///< G_g > 0 [Pa]
  double poisson_ratio = 0; ///< -1 < nu_g <= 0.5
};

/// Normal force and its derivative at one overlap.
struct NormalResponse {
  double force = 0;     ///< f [N]
  double stiffness = 0; ///< k_n = df/dd [N/m]
};

/// The kernels f = c d^(1+1/alpha), k_n = (1+1/alpha) f/d: unchecked, noexcept, one small type a law so that
/// a sweep over contacts is compiled for its law. Assumes overlap >= 0.
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
using NormalKernel = std::variant<ConeKernel, SphereKernel, FlatKernel, GeneralKernel>;

/// Power-law contact f = c d^(1+1/alpha) of two identical elastic grains.
/// [paper Eq. 3; Galin1946; Sneddon1965]
/// Assumes   identical grains, contact radius small against the grain, monotonic loading.
/// Checked by tests/contact/test_power_law.cpp
class PowerLaw {
 public:
  /// alpha = 1: cones of slope A_1 > 0 (tangent of the flank angle) [1].
  static PowerLaw cone(const GrainMaterial& grain, double slope);
  /// alpha = 2: spheres of radius R > 0 [m], A_2 = 1/(2R); Hertz's law.
  static PowerLaw sphere(const GrainMaterial& grain, double radius);
  /// alpha = infinity: flat punches of radius a > 0 [m]; constant stiffness 2 G a/(1-nu).
  static PowerLaw flat(const GrainMaterial& grain, double punch_radius);
  /// Any finite alpha >= 1 with profile constant A_alpha > 0 [m^(1-alpha)].
  /// \throws InvalidArgument for alpha < 1, infinite alpha (use flat), or a constant that is not positive.
  static PowerLaw general(const GrainMaterial& grain, double alpha, double profile_constant);

  /// alpha in [1, inf]; infinity for the flat punch.
  [[nodiscard]] double alpha() const { return alpha_; }
  /// 1/(1+alpha): the exponent b of k_n ~ f^b, 0 for the flat punch.
  [[nodiscard]] double stiffness_exponent() const { return 1 / (1 + alpha_); }
  /// 1 + 1/alpha: the exponent of f ~ d^(1+1/alpha).
  [[nodiscard]] double force_exponent() const { return 1 + 1 / alpha_; }
  /// c in f = c d^(1+1/alpha) with d the full approach [N m^-(1+1/alpha)].
  [[nodiscard]] double coefficient() const { return coefficient_; }
  [[nodiscard]] const GrainMaterial& grain() const { return grain_; }

  /// f [N] at overlap d >= 0 [m].
  [[nodiscard]] double force(double overlap) const;
  /// d [m] at force f >= 0 [N].
  [[nodiscard]] double overlap(double force) const;
  /// k_n = df/dd [N/m] at overlap d >= 0 [m].
  [[nodiscard]] double stiffness_at_overlap(double overlap) const;
  /// k_n [N/m] at force f >= 0 [N]: (1+1/alpha) c^(alpha/(1+alpha)) f^(1/(1+alpha)).    [paper Eq. 4, halved]
  [[nodiscard]] double stiffness_at_force(double force) const;
  /// Elastic energy alpha/(2 alpha+1) f d [J] stored at overlap d >= 0 [m].
  [[nodiscard]] double energy(double overlap) const;
  /// Radius of the contact disc [m]: a = k_n (1-nu)/(2 G).
  [[nodiscard]] double contact_radius(double overlap) const;

  /// The unchecked kernel of this law, for sweeps.
  [[nodiscard]] NormalKernel kernel() const;

 private:
  PowerLaw(const GrainMaterial& grain, double alpha, double coefficient);

  GrainMaterial grain_;
  double alpha_ = 2;
  double coefficient_ = 0;
};

/// k_t/k_n = 2(1-nu)/(2-nu) of the no-slip contact of identical grains, any axisymmetric profile.
/// [paper Eq. 8]
/// \throws InvalidArgument unless -1 < poisson_ratio <= 0.5.
[[nodiscard]] double mindlin_stiffness_ratio(double poisson_ratio);

} // namespace granum::contact

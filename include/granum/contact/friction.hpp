// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace granum::contact {

/// Coulomb friction between grains: |f_t| <= mu f_n with mu = tan(angle).
/// A value is always a checked coefficient, so that angle and coefficient cannot be confused.
/// Checked by tests/contact/test_friction.cpp
class Friction {
 public:
  /// \param    coefficient   mu >= 0 [1]
  /// \throws   InvalidArgument if it is negative or not finite
  [[nodiscard]] static Friction from_coefficient(double coefficient);
  /// \param    angle   phi_mu in [0, pi/2) [rad]
  /// \throws   InvalidArgument outside that range
  [[nodiscard]] static Friction from_angle(double angle);

  /// mu = tan(phi_mu) [1].
  [[nodiscard]] double coefficient() const { return coefficient_; }
  /// phi_mu [rad]. Accuracy 1 ulp.
  [[nodiscard]] double angle() const;

  bool operator==(const Friction&) const = default;

 private:
  explicit Friction(double coefficient) : coefficient_(coefficient) {}

  double coefficient_ = 0;
};

} // namespace granum::contact

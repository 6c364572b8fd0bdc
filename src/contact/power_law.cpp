// SPDX-License-Identifier: GPL-3.0-or-later
// Notation: G, nu of the grain; A profile constant; c coefficient of the full approach d; c_half of Eq. 3,
// which is written in half of d: c = c_half 2^-(1+1/alpha).
#include <granum/contact/power_law.hpp>

#include <cmath>
#include <limits>
#include <numbers>

#include <granum/core/error.hpp>
#include <granum/core/text.hpp>

#include "core/compiled_once.hpp"

namespace granum::contact {

namespace {

const GrainMaterial& checked(const GrainMaterial& grain) {
  require_positive("grain_shear_modulus", grain.shear_modulus, "Pa");
  require_poisson_ratio("grain_poisson_ratio", grain.poisson_ratio);
  return grain;
}

/// Gamma((alpha+1)/2)/Gamma(alpha/2+1). A difference of two lgamma overflows for huge alpha and loses digits
/// before; the ratio does not. Beyond 1e8 it is z^(-1/2), z = (alpha+1)/2: the next term 1/(8z) is lost in
/// the alpha-th root.
double gamma_ratio(double alpha) {
  const double z = alpha / 2 + 0.5;
  return alpha < 1e8 ? gamma_ratio_half(z) : 1 / std::sqrt(z);
}

/// g = Gamma((alpha+1)/2)/(2 sqrt(pi) Gamma(alpha/2+1)).
double profile_factor(double alpha) { return gamma_ratio(alpha) / (2 * std::sqrt(std::numbers::pi)); }

/// An exponent as the sum of two doubles: forces span so many decades that the rounding of the exponent alone
/// would cost a hundred units in the last place.
struct Exponent {
  double high;
  double low;
};

/// x/(y+z).
Exponent quotient(double x, double y, double z) {
  if (y < z)
    return quotient(x, z, y);
  const double sum = y + z;
  const double high = x / sum;
  const double remainder = std::fma(-high, sum, x) - high * (z - (sum - y));
  return {high, remainder / sum};
}

/// x^n for x >= 0.
double power(double x, Exponent n) {
  const double leading = std::pow(x, n.high);
  return x > 0 ? leading + leading * (n.low * std::log(x)) : leading;
}

/// x^(1/(1+alpha)): 1 for the flat punch, at x = 0 too.
double stiffness_root(double x, double alpha) {
  if (alpha == 1)
    return std::sqrt(x);
  if (alpha == 2)
    return std::cbrt(x);
  return std::isinf(alpha) ? 1.0 : power(x, quotient(1, alpha, 1));
}

} // namespace

PowerLaw::PowerLaw(const GrainMaterial& grain, double alpha, double coefficient)
    : grain_(grain), alpha_(alpha), coefficient_(coefficient),
      unit_force_stiffness_(force_exponent() * (coefficient / stiffness_root(coefficient, alpha))) {}

PowerLaw PowerLaw::cone(const GrainMaterial& grain, double slope) {
  const auto& [shear, nu] = checked(grain);
  require_positive("slope", slope);
  return {grain, 1.0, shear / (std::numbers::pi * (1 - nu) * slope)};
}

PowerLaw PowerLaw::sphere(const GrainMaterial& grain, double radius) {
  const auto& [shear, nu] = checked(grain);
  require_positive("radius", radius, "m");
  return {grain, 2.0, 2 * shear * std::sqrt(2 * radius) / (3 * (1 - nu))};
}

PowerLaw PowerLaw::flat(const GrainMaterial& grain, double punch_radius) {
  const auto& [shear, nu] = checked(grain);
  require_positive("punch_radius", punch_radius, "m");
  return {grain, std::numeric_limits<double>::infinity(), 2 * shear * punch_radius / (1 - nu)};
}

PowerLaw PowerLaw::general(const GrainMaterial& grain, double alpha, double profile_constant) {
  const auto& [shear, nu] = checked(grain);
  if (!(alpha > 0) || std::isinf(alpha))
    throw InvalidArgument("alpha", alpha, "",
                          "(0, inf); infinite alpha is the flat punch (--contact flat, PowerLaw::flat)");
  require_positive("profile_constant", profile_constant, "m^(1-alpha)");
  const double root = std::pow(profile_factor(alpha), 1 / alpha) * std::pow(profile_constant, -1 / alpha);
  if (!(root > 0) || std::isinf(root)) // of cusps, whose exponent 1/alpha is large
    throw InvalidArgument("profile_constant", profile_constant, "m^(1-alpha)",
                          "the values allowed for alpha = " + short_text(alpha) +
                              ": forces exceed the range of a double");
  return {grain, alpha, 2 * shear / (1 - nu) / (1 + 1 / alpha) * root};
}

PowerLaw PowerLaw::of_grain(const GrainMaterial& grain) const {
  const auto& [shear, nu] = checked(grain);
  const double stiffer = shear / grain_.shear_modulus * ((1 - grain_.poisson_ratio) / (1 - nu));
  return {grain, alpha_, coefficient_ * stiffer};
}

PowerLaw PowerLaw::of(const GrainMaterial& grain, double radius) const {
  return depends_on_size() ? sphere(grain, radius) : of_grain(grain);
}

PowerLaw PowerLaw::of_pair_radius(double ratio) const {
  require_positive("ratio", ratio);
  return depends_on_size() ? times(std::sqrt(ratio)) : *this;
}

PowerLaw PowerLaw::of_numbers(const GrainMaterial& grain, const std::array<double, 2>& numbers) {
  static_cast<void>(checked(grain));
  if (!(numbers[0] > 0))
    throw InvalidArgument("alpha", numbers[0], "", "(0, inf]");
  return {grain, numbers[0], require_positive("coefficient", numbers[1])};
}

PowerLaw PowerLaw::times(double factor) const {
  return {grain_, alpha_, coefficient_ * require_positive("factor", factor)};
}

double PowerLaw::profile_constant() const {
  const double root = // (g/A)^(1/alpha)
      coefficient_ * force_exponent() * (1 - grain_.poisson_ratio) / (2 * grain_.shear_modulus);
  return profile_factor(alpha_) * std::pow(root, -alpha_);
}

double PowerLaw::force(double overlap) const {
  require_non_negative("overlap", overlap, "m");
  if (alpha_ != 1 && alpha_ != 2 && std::isfinite(alpha_))
    return coefficient_ * (overlap * power(overlap, quotient(1, alpha_, 0)));
  return std::visit([&](const auto& law) { return law(overlap).force; }, kernel());
}

double PowerLaw::overlap(double force) const {
  require_non_negative("force", force, "N");
  const double power_of_overlap = force / coefficient_;
  if (alpha_ == 2) {
    const double root = std::cbrt(power_of_overlap);
    return root * root;
  }
  if (std::isinf(alpha_))
    return power_of_overlap;
  return alpha_ == 1 ? std::sqrt(power_of_overlap) : power(power_of_overlap, quotient(alpha_, alpha_, 1));
}

double PowerLaw::stiffness_at_overlap(double overlap) const {
  require_non_negative("overlap", overlap, "m");
  if (alpha_ != 1 && alpha_ != 2 && std::isfinite(alpha_))
    return force_exponent() * (coefficient_ * power(overlap, quotient(1, alpha_, 0)));
  return std::visit([&](const auto& law) { return law(overlap).stiffness; }, kernel());
}

double PowerLaw::stiffness_at_force(double force) const {
  require_non_negative("force", force, "N");
  return unit_force_stiffness_ * stiffness_root(force, alpha_);
}

double PowerLaw::energy(double overlap) const { return force(overlap) * overlap / (1 + force_exponent()); }

double PowerLaw::contact_radius(double overlap) const {
  return stiffness_at_overlap(overlap) * (1 - grain_.poisson_ratio) / (2 * grain_.shear_modulus);
}

PowerLaw::Kernel PowerLaw::kernel() const {
  if (alpha_ == 1)
    return ConeKernel{coefficient_};
  if (alpha_ == 2)
    return SphereKernel{coefficient_};
  if (std::isinf(alpha_))
    return FlatKernel{coefficient_};
  return GeneralKernel{coefficient_, 1 / alpha_};
}

std::string PowerLaw::text() const {
  return "PowerLaw(alpha=" + short_text(alpha_) + ", coefficient=" + exact_text(coefficient_) +
         ", shear_modulus=" + exact_text(grain_.shear_modulus) +
         ", poisson_ratio=" + exact_text(grain_.poisson_ratio) + ")";
}

double mindlin_stiffness_ratio(double poisson_ratio) {
  require_poisson_ratio("poisson_ratio", poisson_ratio);
  return 2 * (1 - poisson_ratio) / (2 - poisson_ratio);
}

double given_stiffness_ratio(double ratio) { return require_non_negative("tangential_ratio", ratio); }

} // namespace granum::contact

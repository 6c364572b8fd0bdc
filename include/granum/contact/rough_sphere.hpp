// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <bit>
#include <cstdint>
#include <optional>
#include <string>
#include <variant>

#include <granum/contact/power_law.hpp>

namespace granum::contact {

/// The kernel of rough spheres: force and stiffness over f_1 and f_1/u0, as functions of y = d/u0 alone,
/// tabulated once. Below y = 1 the force is proportional to y: that is the first cell. From there each octave
/// has 128 cells with a polynomial of degree 5 each, of the same value, slope and curvature as the law at
/// both ends.
/// Accuracy  force 1e-9, stiffness 1e-7, for y < 2^31.  Checked by tests/contact/test_rough_sphere.cpp
struct RoughSphereKernel {
  static constexpr int octaves = 31;
  static constexpr int cells_per_octave = 128;
  /// f_1 of the onset: 2^-27.
  static constexpr double onset = 0x1p-27;
  /// Coefficients of the powers of y less that at the cell's left end; the last two are not used.
  struct alignas(64) Cell : std::array<double, 8> {};

  /// Where y >= 0 lies.
  struct Place {
    std::int64_t cell;
    double beyond; ///< its left end
  };
  [[nodiscard, gnu::always_inline]] static Place place_of(double y) noexcept {
    constexpr int dropped = 45; // bits of the mantissa; the other 7 are the cell
    constexpr auto before = static_cast<std::int64_t>(std::bit_cast<std::uint64_t>(1.0) >> dropped) - 1;
    constexpr std::int64_t last = octaves * cells_per_octave;
    const std::uint64_t kept = std::bit_cast<std::uint64_t>(y) >> dropped;
    const std::int64_t cell = static_cast<std::int64_t>(kept) - before;
    const double end = std::bit_cast<double>(kept << dropped);
    return {.cell = cell < 0 ? 0 : (cell < last ? cell : last), .beyond = y - (y < 1 ? 0.0 : end)};
  }
  /// Force over f_1 and its derivative by y of a cell's coefficients.
  [[nodiscard, gnu::always_inline]] static double force_in(double c0, double c1, double c2, double c3,
                                                           double c4, double c5, double x) noexcept {
    return c0 + x * (c1 + x * (c2 + x * (c3 + x * (c4 + x * c5))));
  }
  [[nodiscard, gnu::always_inline]] static double slope_in(double c1, double c2, double c3, double c4,
                                                           double c5, double x) noexcept {
    return c1 + x * (2 * c2 + x * (3 * c3 + x * (4 * c4 + x * (5 * c5))));
  }

  double transition_force; ///< f_1 [N]
  double per_roughness;    ///< 1/u0 [1/m]
  const Cell* cells;       ///< those of the law, the same ones for all numbers

  NormalResponse operator()(double overlap) const noexcept {
    const Place place = place_of(overlap * per_roughness);
    const Cell& c = cells[place.cell];
    return {transition_force * force_in(c[0], c[1], c[2], c[3], c[4], c[5], place.beyond),
            transition_force * per_roughness * slope_in(c[1], c[2], c[3], c[4], c[5], place.beyond)};
  }
  /// The kernel of a pair whose pair_radius is this multiple of this one's; f_1 is proportional to its root.
  [[nodiscard]] RoughSphereKernel of_pair_radius(double ratio) const noexcept {
    return {transition_force * std::sqrt(ratio), per_roughness, cells};
  }
};

/// Two equal elastic spheres with rough surfaces. Between the two half spaces lies an interface that carries
/// the pressure p_0 exp(-gap/u0), as nominally flat rough surfaces do [Persson2007] [Akarapu2011], and is as
/// stiff as p/u0. The stiffness of both together depends on one number, X = u0 k_H/f, with k_H that of smooth
/// spheres:
///   1/k_n = u0/f + 1/(k_H sqrt(h)),   h = 1 + X (s0 + (2 pi/3) q)/(1 + q),   q = (c X)^n.
/// Both limits are exact to leading order (docs/theory.md); s0, c and n are calibrated on solutions of the
/// elastic problem, which k_n is within 1.3e-4 of for X from 0.003 to 100 (validation/rough_contact). b falls
/// from 1, where X is large and roughness decides, to 1/3, where X is small and the spheres are as smooth.
///
/// A contact begins at the force 2^-27 f_1, f_1 that where X = 1; below, the force is proportional to the
/// overlap, which is u0 there. Without this an exponential interface would have no first touch.
/// u0 = 0 is the smooth sphere, to the bit.
/// Assumes   identical grains, contact radius small against the grain, monotonic loading; u0 is that of both
///           surfaces together, small against the grain, and many asperities touch.
/// Checked by tests/contact/test_rough_sphere.cpp
class RoughSphere {
 public:
  using Kernel = std::variant<SphereKernel, RoughSphereKernel>;

  static constexpr double largest_roughness = 10e-6; ///< [m]; beyond, few asperities touch

  /// \param    radius      R > 0 of each sphere [m]
  /// \param    roughness   u0 from 0 to largest_roughness and R [m]; 0.4 to 0.5 of the rms of both surfaces
  /// \throws   InvalidArgument if one is out of range
  RoughSphere(const GrainMaterial& grain, double radius, double roughness);

  /// The same surface on grains of another solid. \throws InvalidArgument if grain is out of range
  [[nodiscard]] RoughSphere of_grain(const GrainMaterial& grain) const;
  /// The same surface on two equal grains of another solid and radius. \throws InvalidArgument as RoughSphere
  [[nodiscard]] RoughSphere of(const GrainMaterial& grain, double radius) const;
  [[nodiscard]] static bool depends_on_size() { return true; }
  /// The law of a pair whose pair_radius is so many times that of this law's pair (grains.hpp).
  /// \throws   InvalidArgument if the ratio is not positive and finite
  [[nodiscard]] RoughSphere of_pair_radius(double ratio) const;

  /// u0 [m].
  [[nodiscard]] double roughness() const { return roughness_; }
  /// The contact without roughness: what roughness adds to the overlap, up to 70 times as much where forces
  /// are small, makes no contact that counts (validation/contact_prior).
  [[nodiscard]] const PowerLaw& closing_law() const { return smooth_; }
  /// f_1 = u0^(3/2) sqrt(3 R) G/(1 - nu), where X = 1 [N].
  /// Accuracy  8 ulp.  Checked by tests/contact/test_rough_sphere.cpp
  [[nodiscard]] double transition_force() const { return transition_force_; }
  /// Material of both grains.
  [[nodiscard]] const GrainMaterial& grain() const { return smooth_.grain(); }

  /// Normal force of the overlap.
  /// \param    overlap   d >= 0, full approach [m]
  /// \return   f [N]
  /// \throws   InvalidArgument if the overlap is negative or not finite
  /// Accuracy  relative 1e-13.  Checked by tests/contact/test_rough_sphere.cpp
  [[nodiscard]] double force(double overlap) const;
  /// Overlap at a force, the integral of 1/k_n from no force on.
  /// \param    force   f >= 0 [N]
  /// \return   d [m]
  /// \throws   InvalidArgument if the force is negative or not finite
  /// Accuracy  relative 1e-14.  Checked by tests/contact/test_rough_sphere.cpp
  [[nodiscard]] double overlap(double force) const;
  /// k_n = df/dd at d >= 0 [N/m].
  /// \throws   InvalidArgument if the overlap is negative or not finite
  /// Accuracy  relative 1e-13.  Checked by tests/contact/test_rough_sphere.cpp
  [[nodiscard]] double stiffness_at_overlap(double overlap) const;
  /// k_n at a force, the formula above.
  /// \param    force   f >= 0 [N]
  /// \return   k_n [N/m]
  /// \throws   InvalidArgument if the force is negative or not finite
  /// Accuracy  4 ulp of the formula.  Checked by tests/contact/test_rough_sphere.cpp
  [[nodiscard]] double stiffness_at_force(double force) const;
  /// b = d ln k_n/d ln f at f >= 0 [1]; 0 below the onset.
  /// \throws   InvalidArgument if the force is negative or not finite
  /// Accuracy  1e-14.  Checked by tests/contact/test_rough_sphere.cpp
  [[nodiscard]] double exponent_at_force(double force) const;
  /// d b/d ln f at f >= 0 [1].
  /// \throws   InvalidArgument if the force is negative or not finite
  /// Accuracy  1e-14.  Checked by tests/contact/test_rough_sphere.cpp
  [[nodiscard]] double exponent_slope_at_force(double force) const;
  [[nodiscard]] std::optional<double> constant_exponent() const; ///< empty where the surfaces are rough
  /// The transition force is f_1; the onset is a convention, unless u0 = 0.
  [[nodiscard]] Surface surface() const;
  [[nodiscard]] double first_stiffness() const; ///< k_n at 2^-10 f_1: much softer than under load
  /// Elastic energy, the integral of the force up to d >= 0 [J].
  /// \throws   InvalidArgument if the overlap is negative or not finite
  /// Accuracy  relative 1e-13.  Checked by tests/contact/test_rough_sphere.cpp
  [[nodiscard]] double energy(double overlap) const;

  /// The unchecked kernel of this law, for sweeps. That of smooth spheres where u0 is below 2^-30 R, which
  /// changes forces by less than the table does.
  [[nodiscard]] Kernel kernel() const;
  /// The smooth law where u0 = 0, else none.
  [[nodiscard]] const PowerLaw* power_law() const { return is_smooth() ? &smooth_ : nullptr; }
  /// alpha and c of the smooth contact, and u0: laws of the same ones have the same forces.
  [[nodiscard]] std::array<double, 3> numbers() const {
    return {smooth_.alpha(), smooth_.coefficient(), roughness_};
  }
  /// The law with these numbers(), to the bit.
  /// \throws   InvalidArgument if one is out of range
  /// Checked by tests/contact/test_laws.cpp
  [[nodiscard]] static RoughSphere of_numbers(const GrainMaterial& grain,
                                              const std::array<double, 3>& numbers);
  /// "RoughSphere(...)": kind and numbers, for people who compare two.
  [[nodiscard]] std::string text() const;

  bool operator==(const RoughSphere&) const = default;

 private:
  RoughSphere(const PowerLaw& smooth, double roughness);

  /// Whether there is no roughness, or so little that f_1 is beyond the range of a double.
  [[nodiscard]] bool is_smooth() const { return transition_force_ < 1e-270; }
  /// Whether the law of smooth spheres is valid at this force: smooth, or X < 2^-60.
  [[nodiscard]] bool is_smooth(double force) const;
  /// X at a force > 0.
  [[nodiscard]] double roughness_number(double force) const;
  /// 1/X at an overlap > u0.
  [[nodiscard]] double smoothness_at_overlap(double overlap) const;

  PowerLaw smooth_;
  double roughness_ = 0;
  double transition_force_ = 0;
};

/// Phi = k_n/k_H of rough spheres and its derivatives, by X = u0 k_H/f.
struct RoughStiffness {
  double ratio = 0;          ///< Phi, in (0, 1)
  double exponent = 0;       ///< b = d ln k_n/d ln f, from 1/3 to 1
  double exponent_slope = 0; ///< d b/d ln f
};

/// \param    X   in (0, inf), not checked
/// Accuracy  4 ulp of the formula, b and its slope 1e-14.  Checked by tests/contact/test_rough_sphere.cpp
[[nodiscard]] RoughStiffness rough_stiffness(double X);

} // namespace granum::contact

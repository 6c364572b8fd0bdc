// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

#include <granum/contact/normal_law.hpp>
#include <granum/contact/power_law.hpp>
#include <granum/core/numerics.hpp>

/// Minerals of grains, pairs of unequal grains, and the friction between them.
namespace granum::contact {

/// A solid that grains are often made of.
struct Mineral {
  const char* key;    ///< on a command line
  const char* name;   ///< for people
  const char* source; ///< entry of validation/references.bib
  GrainMaterial material;
  double density = 0; ///< [kg/m3]
  /// Standard deviation of G_g over G_g [1]: how far pieces of that name differ, a judgement.
  double modulus_spread = 0;
};

/// Quartz, feldspar, calcite, dolomite, glass and steel. Of minerals the averages over all directions of a
/// crystal.                                                        [Mavko2009; Makse2004; BudynasNisbett2011]
[[nodiscard]] std::span<const Mineral> minerals();
/// The one of that key.
/// \throws   InvalidArgument for an unknown key; the text lists the known ones
/// Checked by tests/contact/test_minerals.cpp
[[nodiscard]] const Mineral& mineral(std::string_view key);

/// The part of a mineral in grains of several.
struct MineralShare {
  const Mineral* mineral = nullptr;
  double share = 1; ///< by volume [1]
};
/// Grains of one mineral, "quartz", or of several, each grain of one of them: "quartz:70%,calcite:30%".
/// \throws   InvalidArgument for an unknown key, a share that is not above 0, a mineral that is named twice,
///           and shares that do not add up to 1
/// Checked by tests/contact/test_minerals.cpp
[[nodiscard]] std::vector<MineralShare> mineral_shares(std::string_view text);
/// The text of these shares.
[[nodiscard]] std::string text_of(std::span<const MineralShare> minerals);

/// K_s = 2 G_g (1 + nu_g)/(3 (1 - 2 nu_g)) of a grain's solid [Pa]; the largest number for nu_g = 0.5.
/// \throws   InvalidArgument if the material is out of range
/// Accuracy  4 ulp over 1 - 2 nu_g.  Checked by tests/contact/test_minerals.cpp
[[nodiscard]] double bulk_modulus(const GrainMaterial& grain);

/// \file
/// Two grains that differ, as two that are equal: every law of this module is one of equal grains.

/// Radius of the two equal spheres that touch as a pair of unequal ones does, 2 R* with 1/R* = 1/R_i + 1/R_j:
/// their contact has the same law, PowerLaw::sphere of this radius. [Hertz1882]
/// Assumes   radii > 0 [m], not checked: sweeps call it for every contact.
/// \return   2 R* [m]; exactly R of two equal grains
/// Accuracy  2 ulp.  Checked by tests/contact/test_pair.cpp
[[nodiscard]] constexpr double pair_radius(double radius_i, double radius_j) noexcept {
  return harmonic_mean(radius_i, radius_j);
}

/// The unchecked kernel of two grains of these sizes, radii over that of the kernel's two equal grains [1]:
/// the kernel itself where it does not depend on them.
/// Assumes   sizes > 0.
/// Accuracy  3 ulp; exactly the kernel where both sizes are 1.  Checked by tests/contact/test_pair.cpp
template <class Kernel>
requires requires(const Kernel& kernel) { kernel(0.0); }
[[nodiscard]] Kernel of_sizes(Kernel kernel, [[maybe_unused]] double i, [[maybe_unused]] double j) noexcept {
  if constexpr (requires { kernel.of_pair_radius(i); })
    return kernel.of_pair_radius(pair_radius(i, j));
  else
    return kernel;
}

/// The same of a law.
/// \throws   InvalidArgument if a size is not positive and finite
/// Accuracy  as above.  Checked by tests/contact/test_pair.cpp
[[nodiscard]] NormalLaw of_sizes(const NormalLaw& law, double i, double j);

/// The one material of two grains whose contact is that of two different ones, normal and tangential alike:
/// G/(1-nu) = 2/((1-nu_i)/G_i + (1-nu_j)/G_j) and G/(2-nu) = 2/((2-nu_i)/G_i + (2-nu_j)/G_j).
///                                                                                  [Hertz1882; Mindlin1949]
/// Assumes   no coupling of normal and tangential displacement, which unlike materials have a little of.
/// \throws   InvalidArgument if a material is out of range
/// Accuracy  4 ulp; exactly the material of two equal grains, the same bits in either order.
/// Checked by tests/contact/test_pair.cpp
[[nodiscard]] GrainMaterial pair_material(const GrainMaterial& i, const GrainMaterial& j);

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

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>
#include <vector>

#include <granum/contact/power_law.hpp>

/// Packings whose grains are of several materials. Under uniform strain the stiffnesses of their contacts add
/// up; in a real packing soft contacts take more of the strain, and the packing is softer than the mean.
namespace granum::effective {

/// The contacts between grains of two materials, or of one, in a packing of several.
struct PairShare {
  double share = 1;     ///< of all contacts; of unequal grains weighed by the squares of their branches [1]
  double stiffness = 1; ///< k_n over that of State::law, the mean of all kinds, at the same force [1]
  double force = 1;     ///< mean normal force over that of all contacts, 1 where it is not known [1]
};

/// Grains of two materials that touch, as the one material of two equal grains (contact::pair_material).
struct MaterialPair {
  contact::GrainMaterial material;
  double weight = 1; ///< number of such contacts, in any unit; of unequal grains the sum of l^2
  double force = 1;  ///< their mean normal force, in any unit
};

/// Contacts of several materials, beside the one material that has the mean of their stiffnesses.
struct MixedContacts {
  contact::GrainMaterial mean;        ///< k_n at a force and k_t/k_n are the means over the contacts
  std::vector<PairShare> pair_shares; ///< of State; empty where all materials are the same
};

/// k_n between grains of a pair of materials over that of others, at the same force: the power 1 - b of the
/// ratio of G_g/(1-nu_g).
/// Assumes   contacts of one power law of the same shape.
[[nodiscard]] double relative_stiffness(const contact::GrainMaterial& pair,
                                        const contact::GrainMaterial& over, double stiffness_exponent);

/// The kinds of contacts and their mean, for k_n ~ (G_g/(1-nu_g))^(1-b) f^b. Pairs of the same material are
/// one kind.
/// Assumes   contacts of one power law of the same shape; k_t/k_n of no slip.
/// \param    stiffness_exponent   b in [0, 1) [1]
/// \throws   InvalidArgument without pairs, for an impossible material, weights or forces that are negative,
///           weights whose sum is 0, and an exponent out of range
/// Accuracy  relative 1e-14.  Checked by tests/effective/test_mixture.cpp
[[nodiscard]] MixedContacts mixed_contacts(std::span<const MaterialPair> pairs, double stiffness_exponent);
/// The same for equal grains of several materials that are mixed at random: two materials touch as often as
/// the product of their shares says.
/// \param    shares   of the grains, one for each material, >= 0, their sum 1 [1]
/// \throws   InvalidArgument also unless there is one share for each material and their sum is 1 within 1e-6
[[nodiscard]] MixedContacts mixed_contacts(std::span<const contact::GrainMaterial> materials,
                                           std::span<const double> shares, double stiffness_exponent);

/// k that contacts of one stiffness would need, for the packing to be as stiff as with these kinds: the root
/// of sum share_i (k_i - k)/((1 - exchange) k + exchange k_i) = 0, the effective medium of one contact among
/// others [Kirkpatrick1973; Feng1985]. It falls from the mean of the k_i at exchange 0, where all contacts
/// have the same strain, to their harmonic mean at exchange 1, where they have the same force.
/// \param    exchange   in [0, 1]: how far the others follow one contact that is softened [1]
/// \throws   InvalidArgument as require_valid(kinds), and for an exchange out of range
/// \return   in the unit of the stiffnesses; 1 without kinds
/// Accuracy  relative 1e-14 of the root.  Checked by tests/effective/test_mixture.cpp
[[nodiscard]] double effective_stiffness(std::span<const PairShare> kinds, double exchange);

/// \throws   InvalidArgument for a share, force or stiffness that is negative or not finite, a stiffness of
///           0, and unless the shares add up to 1 within 1e-6; a State also asks that the mean stiffness be 1
void require_valid(std::span<const PairShare> kinds);

} // namespace granum::effective

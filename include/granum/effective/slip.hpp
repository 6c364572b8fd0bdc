// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <granum/effective/state.hpp>

/// Where slip at contacts begins to soften a packing under cycles of shear.
namespace granum::effective {

/// What a contact does on its way to the Coulomb limit.
enum class ContactSlip {
  partial, ///< slips from its edge inwards, as elastic spheres do                    [MindlinDeresiewicz1953]
  sliding  ///< sticks up to the limit, then slides as a whole: dem::Engine, as most DEM codes
};

/// The numbers that determine how slip softens a packing. All are dimensionless.
struct SlipOnset {
  double reference_strain = 0; ///< shear strain at which k_t l strain is mu f, l the branch, f the mean force
  double tangential_share = 0; ///< d ln G/d ln k_t of rung 3: share of the shear energy in k_t
  /// Mean of (tangential displacement/(l strain))^2, weighted by k_t: 0.1 under uniform strain.
  double mean_square = 0;
  /// Stress lost over stress shed by the slipping contacts, z*/(z* - z_iso): the closer a packing is to the
  /// isostatic point, the less its other contacts take over.
  double amplification = 0;
  double exponent = 0; ///< b of k_n ~ f^b
};

/// \param    state      of the packing; its mean stress is used, its fabric, rolling and pair_shares are
///                      ignored
/// \param    mechanical_coordination_number   z* above isostatic_coordination_number [1]
/// \param    friction_coefficient             mu > 0 of the grains [1]
/// \throws   InvalidArgument as require_valid(State), for contacts or stress that are 0, k_t = 0, mu that is
///           not positive, or z* at which a packing is not rigid
/// Checked by tests/effective/test_slip.cpp
[[nodiscard]] SlipOnset slip_onset(const State& state, double mechanical_coordination_number,
                                   double friction_coefficient);

/// The largest loss for which slip_loss is valid.
inline constexpr double largest_slip_loss = 0.05;

/// 1 - G/G0 in shear cycles of that amplitude, to first order in the loss: amplification x tangential_share x
/// the mean loss of a contact. Forces are distributed as x^2 exp(-3 x), x = f/<f>, whose variance of 1/3 lies
/// between that of dense (0.12) and loose packings (0.41); squared displacements are distributed
/// exponentially. With partial slip the loss is proportional to the strain. With sliding it stays below 0.1 %
/// up to half of the reference strain, and then grows steeply.
/// Assumes   an isotropic packing, well above the isostatic point, whose contacts are not at their limit
///           before it is sheared, or no longer so after some cycles.
/// \param    strain   amplitude of the shear strain >= 0 [1]
/// \return   at most 1; underestimated beyond largest_slip_loss
/// \throws   InvalidArgument for a negative strain
/// Accuracy  sliding contacts in dense packings (z* 6): within 0.5 % of G0 of DEM, up to a loss of 5 %. Loose
///           packings (z* 4.6) lose 1 % at a seventh and a 25th of the strain predicted here (two seeds), 5 %
///           at a quarter of it. Partial slip: the first order differs by 5 % of the loss at a loss of 5 %.
///           Rounding: relative 1e-12.
/// Checked by tests/effective/test_slip.cpp, validation/slip_onset
[[nodiscard]] double slip_loss(const SlipOnset& onset, double strain, ContactSlip slip);

/// The strain at which slip_loss of partial slip reaches `loss`. Below it, G is the small-strain modulus.
/// \param    loss   in (0, largest_slip_loss] [1]
/// \throws   InvalidArgument for another loss
/// Checked by tests/effective/test_slip.cpp
[[nodiscard]] double strain_of_slip_loss(const SlipOnset& onset, double loss);

} // namespace granum::effective

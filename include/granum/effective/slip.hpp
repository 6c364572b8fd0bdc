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

/// What decides how slip softens a packing. All but the first are pure numbers.
struct SlipOnset {
  double reference_strain = 0; ///< shear strain at which k_t l strain is mu f, l the branch, f the mean force
  double tangential_share = 0; ///< d ln G/d ln k_t of rung 3: of the energy of shear, what k_t bears
  /// Of the square of tangential displacement over (l strain), weighed by k_t: 0.1 under uniform strain.
  double mean_square = 0;
  /// By how much more stress is lost than one contact sheds, z*/(z* - z_iso): the fewer contacts a packing
  /// has to spare, the less the others take over.
  double amplification = 0;
  double exponent = 0; ///< b of k_n ~ f^b
};

/// \param    state      of the packing, taken at its mean stress and without fabric
/// \param    mechanical_coordination_number   z* above isostatic_coordination_number [1]
/// \param    friction_coefficient             mu > 0 of the grains [1]
/// \throws   InvalidArgument as require_valid(State), for contacts or stress that are 0, k_t = 0, mu that is
///           not positive, or z* at which a packing is not rigid
/// Checked by tests/effective/test_slip.cpp
[[nodiscard]] SlipOnset slip_onset(const State& state, double mechanical_coordination_number,
                                   double friction_coefficient);

/// The largest loss that slip_loss answers for.
inline constexpr double largest_slip_loss = 0.05;

/// 1 - G/G0 of shear cycles of that amplitude, to first order in the loss: amplification x tangential_share x
/// the mean over contacts of what one of them sheds. Forces are spread by x^2 exp(-3 x), x = f/<f>, whose
/// variance of 1/3 lies between dense (0.12) and loose packings (0.41), squares of displacements
/// exponentially. With partial slip the loss grows as the strain. With sliding it stays far below 1 % up to
/// strains of a third of the reference, and then grows steeply.
/// Assumes   an isotropic packing, well above the isostatic point, whose contacts are not at their limit
///           before it is sheared, or no longer so after some cycles.
/// \param    strain   amplitude of the shear strain >= 0 [1]
/// \return   at most 1; beyond largest_slip_loss it is too small
/// \throws   InvalidArgument for a negative strain
/// Accuracy  of sliding contacts in dense packings (z* 6): see validation/slip_onset; of loose ones (z* 4.6)
///           DEM loses 1 % of G at a third of the strain that is said here. Rounding: relative 1e-12.
/// Checked by tests/effective/test_slip.cpp, validation/slip_onset
[[nodiscard]] double slip_loss(const SlipOnset& onset, double strain, ContactSlip slip);

/// The strain at which slip_loss is that of partial slip: below it G is that of small strain.
/// \param    loss   in (0, largest_slip_loss] [1]
/// \throws   InvalidArgument for another loss
/// Checked by tests/effective/test_slip.cpp
[[nodiscard]] double strain_of_slip_loss(const SlipOnset& onset, double loss);

} // namespace granum::effective

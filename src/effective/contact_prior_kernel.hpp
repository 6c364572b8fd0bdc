// SPDX-License-Identifier: GPL-3.0-or-later
// Unchecked formulas of the contact prior, templates on the number type. Private to src/effective and to
// validation/contact_prior, which fits the coefficients of contact_prior_coefficients.hpp.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>

#include <granum/effective/contact_prior.hpp>

#include "relaxation_kernel.hpp"
#include "stiffening_kernel.hpp"

namespace granum::effective::kernel {

/// contact_prior of a state that a standard deviation may have moved beyond what its preparation allows.
ContactPrior possible_contact_prior(const State& state, const Preparation& preparation);

/// Coefficients of the contacts, in this order: e_d, e_l, bend, squeeze, growth, further growth, mu_0, its
/// power, closing, opening.
template <class T>
using ContactCoefficients = std::array<T, 10>;
/// c, k and w_r of the rattlers.
template <class T>
using RattlerCoefficients = std::array<T, 3>;

/// z* of rigid grains without friction, and the smallest z* of grains with much friction.
inline constexpr double most_rigid_contacts = frictionless_isostatic;
inline constexpr double fewest_rigid_contacts = shear_coefficients[7];
/// The relative overlap at which friction is assumed to have determined z*: that of quartz at about 10 kPa.
inline constexpr double reference_overlap = 5e-5;
/// Void ratio above which no packing of spheres is the densest of its grains.
inline constexpr double loosest_densest = 0.58;
/// Largest value among the packings of the fit.
inline constexpr double largest_overlap = 0.01;

/// Void ratio of the packing at zero pressure: overlaps make it denser.
template <class T>
T rigid_void_ratio(double void_ratio, double overlap, const ContactCoefficients<T>& c) {
  return (1 + void_ratio) * (1.0 + overlap * c[3]) - 1.0;
}

/// The void ratio of equal spheres as far above their densest packing as these grains are above their own,
/// all without overlaps.
template <class T>
T as_of_equal(const T& rigid_void_ratio, const T& densest, const ContactCoefficients<T>& c) {
  return (1.0 + rigid_void_ratio) * (1.0 + c[0]) / (1.0 + densest) - 1.0;
}

/// What the shape of contacts and the sizes of grains add to z* of packings with friction, above the densest
/// packing of the same grains.
/// \param    b   exponent of k_n ~ f^b without force
/// \param    branch_variance   as the function of that name
/// \param    c   constant, over b, over the square root of the variance
inline double shift_by_grains(double b, double branch_variance, const std::array<double, 3>& c) {
  return c[0] + c[1] * up_to_half(b) + c[2] * std::sqrt(branch_variance);
}

/// z* of rigid grains that only friction keeps from packing denser: largest at e_d and below, smallest at e_l
/// and above.
template <class T>
T densest_rigid_contacts(const T& rigid_void_ratio, const ContactCoefficients<T>& c) {
  using std::exp;
  using std::log;
  const T share = (c[1] - rigid_void_ratio) / (c[1] - c[0]);
  if (share >= 1.0)
    return T(most_rigid_contacts);
  if (!(share > 0.0))
    return T(fewest_rigid_contacts);
  const T logarithm = log(share);
  const T power = c[2] * logarithm;
  return fewest_rigid_contacts + (most_rigid_contacts - fewest_rigid_contacts) * T(exp(power));
}

/// z* of rigid grains compressed from a gas with that friction.
template <class T>
T rigid_contacts_of_friction(double friction, const ContactCoefficients<T>& c) {
  using std::exp;
  using std::log;
  if (!(friction > 0))
    return T(most_rigid_contacts);
  const T power = c[7] * (std::log(friction) - T(log(c[6])));
  const T decay = -T(exp(power));
  return fewest_rigid_contacts + (most_rigid_contacts - fewest_rigid_contacts) * T(exp(decay));
}

/// Contacts added by overlaps to those of the packing with rigid grains. Packings with few contacts gain
/// more, up to the largest overlap of the fit, but never overtake a packing with more contacts at the same
/// overlap.
template <class T>
T contacts_of_overlap(const T& rigid_contacts, double overlap, const ContactCoefficients<T>& c) {
  return c[4] * std::sqrt(overlap) +
         c[5] * (most_rigid_contacts - rigid_contacts) * std::sqrt(std::min(overlap, largest_overlap));
}

/// The contacts of a packing of z* if its grains were rigid: the inverse of contacts_of_overlap.
template <class T>
T without_overlap(double z, double overlap, const ContactCoefficients<T>& c) {
  const T share = c[5] * std::sqrt(std::min(overlap, largest_overlap));
  return (z - c[4] * std::sqrt(overlap) - most_rigid_contacts * share) / (1.0 - share);
}

/// Square root of the distance between two overlaps, the distance being the change of the square root of the
/// overlap. The error of a z* carried to another stress is proportional to it, as in a random walk.
inline double root_of_way(double overlap_before, double overlap) {
  return std::sqrt(std::abs(std::sqrt(overlap) - std::sqrt(overlap_before)));
}

/// Contacts of the densest line minus those of the packing, both with rigid grains, after the overlap has
/// changed. The square root of this difference decreases linearly with the square root of the overlap, faster
/// in packings near the densest line. Above the line (missing < 0) it does not change.
template <class T>
T missing_contacts(const T& missing, const T& rigid_void_ratio, double overlap_before, double overlap,
                   const ContactCoefficients<T>& c) {
  using std::exp;
  using std::sqrt;
  if (!(missing > 0.0))
    return missing;
  const T loosened = (rigid_void_ratio - c[0]) / c[9];
  const T rate = loosened > 0.0 ? T(c[8] * exp(T(-loosened))) : c[8];
  const T root = sqrt(missing) - rate * (std::sqrt(overlap) - std::sqrt(overlap_before));
  return root > 0.0 ? T(root * root) : T(0.0);
}

/// z* of a packing of the densest line.
template <class T>
T densest_contacts(const T& rigid_void_ratio, double overlap, const ContactCoefficients<T>& c) {
  const T rigid = densest_rigid_contacts(rigid_void_ratio, c);
  return rigid + contacts_of_overlap(rigid, overlap, c);
}

/// z* of a packing compressed with that friction: never above the densest line, nor below the z* of grains
/// with much friction. At overlaps below the reference the contacts are those of the friction. Therefore a
/// denser packing of one friction never has fewer contacts at one overlap.
template <class T>
T contacts_of_friction(double friction, const T& rigid_void_ratio, double overlap,
                       const ContactCoefficients<T>& c) {
  const T densest = densest_rigid_contacts(rigid_void_ratio, c);
  const T missing = missing_contacts(T(densest - rigid_contacts_of_friction(friction, c)), rigid_void_ratio,
                                     reference_overlap, std::max(overlap, reference_overlap), c);
  const T rigid = missing < 0.0 ? densest : T(densest - missing);
  return rigid + contacts_of_overlap(rigid, overlap, c);
}

/// z* of a packing after the overlap has changed.
template <class T>
T carried_contacts(double z, const T& rigid_void_ratio, double overlap_before, double overlap,
                   const ContactCoefficients<T>& c) {
  const T densest = densest_rigid_contacts(rigid_void_ratio, c);
  const T missing = densest - without_overlap(z, overlap_before, c);
  const T rigid = densest - missing_contacts(missing, rigid_void_ratio, overlap_before, overlap, c);
  return rigid + contacts_of_overlap(rigid, overlap, c);
}

/// Share of rattlers of a packing of z* at that overlap.
template <class T>
T rattlers_of_contacts(double mechanical_coordination, double overlap, const RattlerCoefficients<T>& c) {
  using std::exp;
  const T power = -c[1] * (mechanical_coordination - fewest_rigid_contacts) - c[2] * std::sqrt(overlap);
  return c[0] * T(exp(power));
}

} // namespace granum::effective::kernel

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>
#include <vector>

#include <granum/sizes/distribution.hpp>

/// Which sizes touch which, and the resulting means over contacts for closed forms.
namespace granum::sizes {

/// Means over the contacts of a packing, and its mean grain, over those of equal grains of a reference
/// radius R:
/// the default, in which every member is exactly 1.
/// Spheres of one force have k_n ~ R*^(1/3), R* = R_i R_j/(R_i + R_j), and sums over contacts weight it by
/// l^2. Large grains have both long branches and a large R*, so the pair radius is that of these sums.
struct ContactMeans {
  double branch = 1;        ///< <l>/(2 R), l = R_i + R_j of a contact [1]
  double branch_square = 1; ///< <l^2>/(4 R^2) [1]
  double pair_radius = 1;   ///< 2 (<R*^(1/3) l^2>/<l^2>)^3/R: of the law that represents all pairs [1]
  double grain_volume = 1;  ///< <V_g>/(4/3 pi R^3), over all grains, those without contact as well [1]

  bool operator==(const ContactMeans&) const = default;
};

/// Checks the means: each positive, and no mean square below the square of the mean (but for rounding).
/// \throws   InvalidArgument naming the first that is not
/// Checked by tests/sizes/test_contact_means.cpp
void require_valid(const ContactMeans& means);

/// Two grains that touch.
struct TouchingPair {
  double radius_i = 0; ///< [m]
  double radius_j = 0; ///< [m]
};

/// Counted in a packing: over its contacts, and over its grains.
/// \param    radii       of all grains, each > 0 [m]
/// \param    contacts    of those grains, at least one
/// \param    reference   R > 0 that the means refer to [m]
/// \throws   InvalidArgument for an empty list or a radius that is not positive
/// Accuracy  rounding; exactly 1 where all radii are the reference.
///           Checked by tests/sizes/test_contact_means.cpp
[[nodiscard]] ContactMeans counted_contact_means(std::span<const double> radii,
                                                 std::span<const TouchingPair> contacts, double reference);

/// Contacts of a grain of radius x = r/<r> over those of a grain of the mean radius: Omega(1)/Omega(x), with
/// Omega(x) = 1 - sqrt(1 - 1/(1 + x)^2) the fraction of its solid angle that a mean neighbour covers.
/// [Shaebani2012]
/// Assumes   the coverage of grains does not depend on their size, and that no grain is a rattler.
/// \param    x   > 0, not checked
/// Accuracy  4 ulp.  Checked by tests/sizes/test_contact_means.cpp
[[nodiscard]] double relative_contact_number(double x);

/// The means of a distribution. The number of contacts follows relative_contact_number, except for the
/// rattlers: with c(x) that number, a grain is one with the probability exp(-k (c(x) - c(0))), which is 1 for
/// a grain that is a point and falls with its size, faster the fewer rattlers there are. Partners are
/// independent of each other's size. R is the mean radius by number.
/// \param    rattler_fraction   x_0 in [0, 1), over all grains: many small ones where sizes differ much
/// \throws   InvalidArgument for a fraction out of range
/// Accuracy  of the quadrature 1e-10. Compared with counts in packings of LAMMPS, x_0 from 0.14 to 0.39:
///           validation/sizes.  Checked by tests/sizes/test_contact_means.cpp
[[nodiscard]] ContactMeans expected_contact_means(const Distribution& sizes, double rattler_fraction = 0);
/// The same of the radii of grains, e.g. of a file without contacts; R is their mean. The pair radius of more
/// than 1,024 grains is counted in as many classes of equal number.
/// \throws   InvalidArgument also for no radii, or one that is not positive
/// Accuracy  of the classes 1e-4.  Checked by tests/sizes/test_contact_means.cpp
[[nodiscard]] ContactMeans expected_contact_means(std::span<const double> radii, double rattler_fraction = 0);

/// The same means referred to another radius, R' = scale R.
/// \throws   InvalidArgument unless scale > 0
/// Checked by tests/sizes/test_contact_means.cpp
[[nodiscard]] ContactMeans with_reference(const ContactMeans& means, double scale);

} // namespace granum::sizes

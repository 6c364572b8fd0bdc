// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include <granum/contact/normal_law.hpp>
#include <granum/packing/assembly.hpp>

/// What the contact forces of a packing say: its stress, their balance, distribution and moments, their work.
namespace granum::packing {

/// Mean stress tensor of an assembly, compression positive.
struct ContactStress {
  Mat3 symmetric; ///< [Pa]
  Mat3 tensor;    ///< as summed, before symmetrisation; codes print one half of it [Pa]
  /// Norm of the antisymmetric part over norm of the symmetric part [1]; 0 without stress.
  double asymmetry = 0;

  /// p = trace/3 [Pa].
  [[nodiscard]] double mean() const { return trace(symmetric) / 3; }
};

/// Love-Weber stress, sigma_ij = (1/V) sum over contacts of f_i l_j, f exerted by i on j, l from i to j, or
/// from the centre to the wall.                                                                    [Love1927]
/// Assumes   quasi-static state: no momentum flux. Grains in moment equilibrium give asymmetry 0.
/// \return   zero for an assembly without contacts
/// \throws   InvalidArgument for an assembly that require_valid rejects
/// Accuracy  rounding.  Checked by tests/packing/test_stress.cpp
[[nodiscard]] ContactStress contact_stress(const Assembly& assembly);

/// Mean stress in each grain, (1/V_g) sum over its contacts, walls included, of f_i r_j, with V_g the volume
/// of the solid grain, not that of a cell of space around it, and r from its centre to the contact point.
/// Contact points divide branches as the radii do: the sum over the grains of V_g times the stress is the
/// volume of the packing times ContactStress::tensor.
/// Assumes   as contact_stress; the stress is symmetric in grains whose moments balance.
/// \return   one for each grain, zero for grains without contacts [Pa]
/// \throws   InvalidArgument for an assembly that require_valid rejects
/// Accuracy  rounding.  Checked by tests/packing/test_stress.cpp
[[nodiscard]] std::vector<Mat3> grain_stresses(const Assembly& assembly);

/// Unbalanced force and moment of the contacts of one grain.
struct Residual {
  Vec3 force;  ///< [N]
  Vec3 moment; ///< about the centre, contact points dividing the branch as the radii do [N m]
};

/// Sum of contact forces and moments on each grain.
/// \throws   InvalidArgument for an assembly that require_valid rejects
/// Checked by tests/packing/test_stress.cpp
[[nodiscard]] std::vector<Residual> residuals(const Assembly& assembly);

/// How far an assembly is from equilibrium, by its bodies where grains are parts of them.
struct Unbalance {
  double force_ratio = 0;  ///< mean |residual force| over grains / mean |contact force| [1]
  double moment_ratio = 0; ///< mean |residual moment| over grains / (mean |contact force| x mean radius) [1]
};

/// \return   zeros for an assembly without contact forces
/// \throws   InvalidArgument for an assembly that require_valid rejects
/// Checked by tests/packing/test_stress.cpp
[[nodiscard]] Unbalance unbalance(const Assembly& assembly);

/// Normal forces of all contacts, in their order [N].
[[nodiscard]] std::vector<double> normal_forces(const Assembly& assembly);

/// One bin of a histogram over x = f_n/<f_n>.
struct ForceBin {
  double low = 0; ///< x
  double high = 0;
  std::size_t count = 0;    ///< contacts with low <= x < high
  double density = 0;       ///< share of the pressing contacts over the width of the bin [1]
  double density_error = 0; ///< sqrt(count) over the same [1]
};

/// How normal forces are distributed about their mean.
struct ForceDistribution {
  std::size_t pressing = 0;   ///< contacts with f_n > 0: those of the histogram and of the mean
  std::size_t unloaded = 0;   ///< f_n = 0
  std::size_t in_tension = 0; ///< f_n < 0
  double mean = 0;            ///< <f_n> [N]; 0 if none presses
  double largest = 0;         ///< [N]
  std::vector<ForceBin> bins; ///< of equal width
  std::size_t beyond = 0;     ///< pressing contacts above the last bin
};

/// \param    forces     normal forces, compression positive, finite [N]
/// \param    bins       in [1, 1000]
/// \param    range      upper end of the last bin, f_n/<f_n> > 0 [1]
/// \throws   InvalidArgument outside these ranges
/// Accuracy  rounding.  Checked by tests/packing/test_force_distribution.cpp
[[nodiscard]] ForceDistribution force_distribution(std::span<const double> forces, std::size_t bins = 32,
                                                   double range = 8);

/// Z(x) = <f_n^x>/<f_n>^x over the contacts that carry force.                             [AgnolinRoux2007c]
/// Assumes   f_n >= 0; contacts with f_n = 0 are left out.
/// \param    exponent  x, any finite number [1]
/// \throws   InvalidArgument if a contact is in tension, or none carries force
/// Checked by tests/packing/test_force_moments.cpp
[[nodiscard]] double normal_force_moment(const Assembly& assembly, double exponent);

/// Q = ln(sum k_n l^2/(k_n(f) sum l^2)), f = sum f_n l/sum l: how much stiffer these contacts are under
/// uniform strain than contacts that all carry the mean force, effective::Unevenness. Of equal grains it is
/// ln(<f^b>/<f>^b).
/// Assumes   contacts of that law, whose forces are known; those between grains alone, walls left out.
/// \param    law          of the pair that represents all
/// \param    law_radius   of the two equal grains that the law is of [m]; pairs of others by
///                       contact::of_sizes
/// \param    relative_stiffness   of grains of several materials, k_n of each contact over that of the law at
///                       the same force [1]: contacts of one such number are compared with each other, at
///                       the mean force of their own; empty: all are of the law
/// \return   0 without a contact that presses; contacts that do not press have k_n at zero force
/// \throws   InvalidArgument for an assembly that require_valid rejects, a relative stiffness that is not
///           positive, and unless there is one for each contact
/// Accuracy  that of the law.  Checked by tests/packing/test_force_moments.cpp
[[nodiscard]] double force_unevenness(const Assembly& assembly, const contact::NormalLaw& law,
                                      double law_radius, std::span<const double> relative_stiffness = {});

/// Two-sided bound on a bulk modulus [Pa].
struct BulkModulusBounds {
  double lower = 0;
  double upper = 0;
};

/// K_Reuss <= K <= K_Voigt from the forces and stiffnesses of the present state, any contact law: upper
/// (1/(9V)) sum k_n l^2 (uniform strain), lower p^2 V/sum (f_n^2/k_n + f_t^2/k_t) (forces scaled with p).
///                                                                                        [AgnolinRoux2007c]
/// Assumes   isotropic stress; grains in force and moment equilibrium (else the lower value is only an
///           estimate); no prestress term, contacts sticking. Contacts that carry no force count in the upper
///           bound only.
/// \return   zeros without contacts; lower = 0 if a contact has a force without the corresponding stiffness
/// \throws   InvalidArgument for an assembly that require_valid rejects
/// Accuracy  rounding.  Checked by tests/packing/test_force_moments.cpp
[[nodiscard]] BulkModulusBounds bulk_modulus_bounds(const Assembly& assembly);

/// Mean stress by the work of the cell, p = -dU/dV, U the elastic energy of the contacts under a uniform
/// change of size: the independent route to the mean of contact_stress. Tangential forces do no work in it,
/// because they are normal to the branches.
/// Assumes   contacts of the given law, with overlaps as listed; walls are rigid planes, at which a grain
///           has a contact as with its mirror image.
/// \param    law_radius   of the two equal grains that the law is of [m]; pairs of others by
/// contact::of_sizes
/// \return   p [Pa], compression positive; 0 without contacts
/// Accuracy  1e-8 relative: a central difference over 1e-6 of the mean overlap. A contact that opens within
///           that, of flat punches the worst, adds 3e-7 of its share.
///           Checked by tests/packing/test_cell_work.cpp
[[nodiscard]] double pressure_by_cell_work(const Assembly& assembly, const contact::NormalLaw& law,
                                           double law_radius);

} // namespace granum::packing

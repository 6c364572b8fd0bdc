// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include <granum/packing/assembly.hpp>

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

} // namespace granum::packing

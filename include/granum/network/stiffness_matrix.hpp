// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <vector>

#include <Eigen/SparseCore>

#include <granum/network/linear_response.hpp>
#include <granum/packing/assembly.hpp>

/// The stiffness matrix of a contact network, the Hessian of its elastic energy.
namespace granum::network {

/// H of a load-bearing network. Unknowns of a grain are those of GrainMotion, u and then R w, so that every
/// element is a force over a length.
struct StiffnessMatrix {
  Eigen::SparseMatrix<double> matrix; ///< symmetric, both triangles [N/m]
  std::vector<std::uint32_t> grain;   ///< of each block of rows: number in the assembly, or among its bodies
  int unknowns_per_grain = 6;         ///< rows of a block; 3, without spins, if no contact resists them
};

/// H as linear_response solves with it: of the grains that carry load, in the order of their numbers.
/// Assumes   as linear_response, but stiffnesses are used as they are, however far apart.
/// \param    options   sliding and prestress count
/// \return   a matrix without rows where no grain carries load
/// \throws   InvalidArgument for an assembly that require_valid rejects, and prestress of rigid bodies
/// Accuracy  rounding; symmetric to the bit.  Checked by tests/network/test_stiffness_matrix.cpp,
///           python/tests/test_networks.py (energy of the motions)
[[nodiscard]] StiffnessMatrix stiffness_matrix(const packing::Assembly& assembly,
                                               const ResponseOptions& options = {});

} // namespace granum::network

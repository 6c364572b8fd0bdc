// SPDX-License-Identifier: GPL-3.0-or-later
// The network response by other means: one dense matrix in dimensional unknowns u, w, no grain left out, and
// a pseudo-inverse by eigenvalues. Slow and short.
#pragma once

#include <granum/elastic/stiffness.hpp>
#include <granum/packing/assembly.hpp>

namespace granum::twin {

using elastic::Matrix6;

/// Rows are the unknowns of the grains, 3 of u [m] and 3 of w each; of the bodies where there are some.
using Unknowns = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic>;

struct Response {
  Matrix6 affine; ///< over all contacts, rattlers' too; of bodies where their first grains are moved
  Matrix6 relaxed;
  Unknowns stiffness, motions; ///< H, and q = -H^+ W in its columns
};

/// Contacts inside of bodies cost nothing in any case.
/// Walls count without prestress.
Response response(const packing::Assembly& a, bool prestress);

/// The closed sum over contacts, uniform strain, no spin. [Walton1987]
Matrix6 contact_sum(const packing::Assembly& a);

/// Largest difference relative to the largest element.
double distance(const Matrix6& a, const Matrix6& b);

/// Of a symmetric matrix.
double smallest_eigenvalue(const Matrix6& m);

} // namespace granum::twin

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <functional>
#include <vector>

#include "network/backbone.hpp"
#include "network/lanes.hpp"

namespace granum::bench {

/// A vector over all grains with spins, for each of the six load cases.
using Motions = network::Field<6>;

/// z = M^-1 r
using Preconditioner = std::function<void(const Motions& r, Motions& z)>;

/// The stiffness matrix H of a network in compressed rows, both halves; unknowns of grain g are 6 g to
/// 6 g + 5: u, and R times the spin. Dimensionless, as Backbone says.
struct Matrix {
  std::vector<int> row_start, column; ///< columns rise in each row
  std::vector<double> value;

  [[nodiscard]] int rows() const { return static_cast<int>(row_start.size()) - 1; }
};

/// \param    shift   added to the diagonal, over its mean
[[nodiscard]] Matrix assembled(const network::Backbone& backbone, double shift);

/// The rigid motions of the whole network, three translations and three rotations about the cell's origin, as
/// columns one after the other. Not free where the network closes on itself through the periodic cell.
[[nodiscard]] std::vector<double> rigid_motions(const network::Backbone& backbone);

/// One load case as a plain vector, and back.
void take_case(const Motions& from, int load_case, double* to);
void put_case(const double* from, int load_case, Motions& to);

/// The preconditioner that treats one load case after the other: solve(r, z) on plain vectors.
[[nodiscard]] Preconditioner
case_by_case(int rows, std::function<void(const std::vector<double>& r, std::vector<double>& z)> solve);

} // namespace granum::bench

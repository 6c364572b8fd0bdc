// SPDX-License-Identifier: GPL-3.0-or-later
// Private to src/network. The stiffness matrix H of a backbone, never assembled as a whole, and
// energies of its contacts.
#pragma once

#include <vector>

#include <granum/elastic/stiffness.hpp>

#include "backbone.hpp"
#include "lanes.hpp"

namespace granum::network {

/// y = H x. Unknowns of a grain: u (3), and for Dof = 6 also R w (3), both displacements.
/// \param    hold   stiffness of a spring from each unknown to the ground, over the mean k_n
template <int Dof>
void apply_stiffness(const Backbone& backbone, const Workers& workers, double hold, const Field<Dof>& x,
                     Field<Dof>& y);

/// W: forces and moments on the grains under unit uniform strains.
template <int Dof>
[[nodiscard]] Field<Dof> affine_forces(const Backbone& backbone);

/// Size of the terms that cancel in W: root of the sum of squares of the contact forces, per load case.
[[nodiscard]] PerCase affine_force_scale(const Backbone& backbone);

/// A = sum over contacts of E^T K E, dimensionless.
[[nodiscard]] elastic::Matrix6 affine_energy(const Backbone& backbone);

/// Blocks of one link: contributions to the diagonal of both grains, and the coupling of b (rows) to a.
template <int Dof>
struct LinkBlocks {
  Block<Dof> diagonal_a;
  Block<Dof> diagonal_b;
  Block<Dof> coupling_ba;
};
template <int Dof>
[[nodiscard]] LinkBlocks<Dof> link_blocks(const Link& link, const Joint* joint);

/// Contribution of a contact with a wall to the diagonal of its grain.
template <int Dof>
[[nodiscard]] Block<Dof> wall_block(const Link& link, const Joint* joint);

/// The diagonal of H: the block of each grain with itself.
template <int Dof>
[[nodiscard]] std::vector<Block<Dof>> diagonal_blocks(const Backbone& backbone);

/// The two parts of ForceTerms, dimensionless.
struct ForceEnergies {
  elastic::Matrix6 geometric = elastic::Matrix6::Zero();
  elastic::Matrix6 shedding = elastic::Matrix6::Zero();
};

/// Contribution of the contact forces to the energies of the motions q under unit uniform strains.
template <int Dof>
[[nodiscard]] ForceEnergies force_energies(const Backbone& backbone, const Field<Dof>& q);

} // namespace granum::network

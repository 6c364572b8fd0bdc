// SPDX-License-Identifier: GPL-3.0-or-later
// Private to src/network.
#pragma once

#include <cstdint>
#include <vector>

#include <granum/network/linear_response.hpp>
#include <granum/packing/assembly.hpp>

#include "network/numbering/numbering.hpp"

namespace granum::network {

/// One contact of the load-bearing network, made dimensionless by Backbone's two scales; a < b. At a wall b
/// is the wall, which moves with the uniform strain and has no unknowns.
struct Link {
  std::uint32_t a = 0;
  std::uint32_t b = 0;
  Vec3 normal;       ///< from a to b
  double length = 0; ///< of the branch
  double lever = 0;  ///< |branch| / (R_a + R_b): the contact point divides the branch as the radii do; at a
                     ///< wall |branch| / R_a
  double normal_stiffness = 0;
  double tangential_stiffness = 0;
  double prestress = 0; ///< f_n / |branch|, or 0 when the prestress term is left out
};

/// Additional data of a contact that resists rolling or twisting, or joins bodies of several grains; in the
/// units of Backbone. Spins are t = R w with the body's radius R.
struct Joint {
  Vec3 branch;         ///< from the centre of a to that of b, or to the foot on the wall
  Vec3 arm_a, arm_b;   ///< from either centre to the contact point, over the body's R
  double rolling = 0;  ///< k_r
  double twisting = 0; ///< about the normal
  double per_radius_a = 0, per_radius_b = 0; ///< 1/R
};

/// Forces of a contact between two grains, in the units of Backbone.
struct LoadedContact {
  std::uint32_t i = 0;
  std::uint32_t j = 0;
  Vec3 branch;                 ///< from i to j
  double lever = 0;            ///< as of Link
  double normal_force = 0;     ///< compression positive
  Vec3 tangential_force;       ///< on j
  double tangential_share = 0; ///< d ln k_t over d overlap
};

/// The grains that carry load, renumbered.
struct Backbone {
  std::size_t grain_count = 0;
  std::size_t moving_count = 0;           ///< of the whole assembly: grains, or bodies if grains form them
  bool rotations = false;                 ///< some contact has tangential stiffness
  double stiffness_scale = 1;             ///< mean k_n [N/m]
  double length_scale = 1;                ///< mean branch length [m]
  std::vector<Link> links;                ///< sorted by (b, a)
  std::vector<Link> wall_links;           ///< sorted by a; b is a's number too
  std::vector<Joint> joints;              ///< of the links; empty if none is needed
  std::vector<Joint> wall_joints;         ///< of the wall links; empty if none is needed
  std::vector<LoadedContact> loaded;      ///< empty unless options.force_terms
  std::vector<std::vector<Piece>> stages; ///< pieces of the numbering
  std::vector<std::uint32_t> grain;       ///< number in the assembly, or among its bodies
  std::vector<Vec3> centre;               ///< of each grain, inside the cell
  std::vector<double> radius;
  Mat3 cell; ///< columns are its three edges

  /// Of one of `links` or `wall_links`; null if it has none.
  [[nodiscard]] const Joint* joint_of(const Link& link) const {
    return joints.empty() ? nullptr : &joints[static_cast<std::size_t>(&link - links.data())];
  }
  [[nodiscard]] const Joint* wall_joint_of(const Link& link) const {
    return wall_joints.empty() ? nullptr : &wall_joints[static_cast<std::size_t>(&link - wall_links.data())];
  }
};

/// Removes rattlers and units, and treats sliding contacts according to the options.
/// \param    soft   for each grain of the assembly: number it as weakly supported; or empty
/// \throws   InvalidArgument for prestress of rigid bodies
[[nodiscard]] Backbone load_bearing_network(const packing::Assembly& assembly, const ResponseOptions& options,
                                            const std::vector<bool>& soft = {});

/// The network of all contacts, those of rattlers too. Grains keep their order, and there are no stages.
[[nodiscard]] Backbone network_with_rattlers(const packing::Assembly& assembly,
                                             const ResponseOptions& options);

} // namespace granum::network

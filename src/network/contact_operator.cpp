// SPDX-License-Identifier: GPL-3.0-or-later
// Notation: delta = u_b - u_a + s n x (t_a + t_b), t = R w, s the lever; f = k_n (n.delta) n + k_t (1 - n n)
// delta. The prestress term acts on v = u_b - u_a alone: -g (1 - n n) v.
//
// A contact with a joint has delta = u_b - u_a + t_b x r_b - t_a x r_a, r its arms, and a moment
// k_r (1 - n n) + k_twist n n on the turn t_b/R_b - t_a/R_a.
//
// A contact with a wall has u_b = t_b = 0. Its normal turns with the wall, opposite to the rotation of a
// line of grains, and never with the grain: with h' = n'.(F (x - p) + u) for the distance from a plane of
// points p, n' ~ F^-T n, F = 1 + E, the second order of U(h') has +3 g in (E b, E b), where two grains have
// -g; the opposite sign in (E b, u); and nothing in (u, u).
#include "contact_operator.hpp"

#include <algorithm>
#include <cmath>
#include <span>

#include "core/vector/level.hpp"
#include "link_forces.hpp"
#include "strains.hpp"

namespace granum::network {

namespace {

template <int Dof>
GRANUM_INLINE void sweep(const Link* links, std::size_t count, const Joint* joints, const Rows<Dof>* x,
                         Rows<Dof>* y) {
  if (joints == nullptr)
    for (std::size_t c = 0; c < count; ++c)
      add_link_forces<Dof>(links[c], x[links[c].a], x[links[c].b], y[links[c].a], y[links[c].b]);
  else
    for (std::size_t c = 0; c < count; ++c)
      add_link_forces<Dof>(links[c], joints[c], x[links[c].a], x[links[c].b], y[links[c].a], y[links[c].b]);
}

template <int Dof>
GRANUM_INLINE void sweep_walls(const Link* links, std::size_t count, const Joint* joints, const Rows<Dof>* x,
                               Rows<Dof>* y) {
  for (std::size_t c = 0; c < count; ++c)
    add_wall_forces<Dof>(links[c], joints == nullptr ? nullptr : joints + c, x[links[c].a], y[links[c].a]);
}

using Matrix3 = Eigen::Matrix3d;
Matrix3 contact_stiffness(double along, double across, const Vec3& n) {
  return across * Matrix3::Identity() + (along - across) * eigen(n) * eigen(n).transpose();
}

Matrix3 elastic_stiffness(const Link& l) {
  return contact_stiffness(l.normal_stiffness, l.tangential_stiffness, l.normal);
}

Matrix3 turning_stiffness(const Link& l, const Joint& joint) {
  return contact_stiffness(joint.twisting, joint.rolling, l.normal);
}

Matrix3 prestress_stiffness(const Link& l) { return contact_stiffness(0, -l.prestress, l.normal); }

/// delta = B x: the two halves of B, for the grains a and b.
template <int Dof>
using Kinematics = Eigen::Matrix<double, 3, Dof>;

template <int Dof>
Kinematics<Dof> kinematics(const Link& l, const Joint* joint, double sign) {
  Kinematics<Dof> b;
  b.template leftCols<3>() = sign * Matrix3::Identity();
  if constexpr (Dof == 6)
    b.template rightCols<3>() = joint == nullptr
                                    ? Matrix3(l.lever * cross_matrix(l.normal))
                                    : Matrix3(-sign * cross_matrix(sign < 0 ? joint->arm_a : joint->arm_b));
  return b;
}

/// The branch that deforms with the cell: that between the bodies.
Vec3 branch_of(const Link& l, const Joint* joint) {
  return joint == nullptr ? l.length * l.normal : joint->branch;
}

template <int Dof>
Block<Dof> block(const Eigen::Matrix<double, Dof, Dof>& m) {
  Block<Dof> b;
  for (int r = 0; r < Dof; ++r)
    for (int c = 0; c < Dof; ++c)
      b.at[r][c] = m(r, c);
  return b;
}

template <int Rows_, int Dof>
void add(const Eigen::Matrix<double, Rows_, load_cases>& m, Rows<Dof>& target) {
  for (int r = 0; r < Rows_; ++r)
    for (int c = 0; c < load_cases; ++c)
      target.row[r][c] += m(r, c);
}

/// The links whose `end` is in the piece; they are sorted by it.
std::span<const Link> links_of(const std::vector<Link>& links, Piece piece, std::uint32_t Link::*end) {
  const auto before = [end](const Link& l, std::uint32_t g) { return l.*end < g; };
  const auto first = std::lower_bound(links.begin(), links.end(), piece.first, before);
  return {first, std::lower_bound(first, links.end(), piece.last, before)};
}

} // namespace

template <int Dof>
void apply_stiffness(const Backbone& backbone, const Workers& workers, double hold, const Field<Dof>& x,
                     Field<Dof>& y) {
  y.resize(x.size());
  for (const std::vector<Piece>& stage : backbone.stages)
    workers.each(stage.size(), [&](std::size_t k) {
      const Piece piece = stage[k];
      for (std::size_t g = piece.first; g < piece.last; ++g)
        for (int d = 0; d < Dof; ++d)
          y[g].row[d] = hold * x[g].row[d];
      // the earlier end of a link is in this piece, or in an earlier stage and linked to no other piece of
      // this stage
      const auto links = links_of(backbone.links, piece, &Link::b);
      const auto walls = links_of(backbone.wall_links, piece, &Link::a);
      const Joint* joints = links.empty() ? nullptr : backbone.joint_of(links.front());
      const Joint* wall_joints = walls.empty() ? nullptr : backbone.wall_joint_of(walls.front());
      at_vector_level([&](auto) __attribute__((always_inline)) {
        sweep<Dof>(links.data(), links.size(), joints, x.data(), y.data());
        sweep_walls<Dof>(walls.data(), walls.size(), wall_joints, x.data(), y.data());
      });
    });
}

template <int Dof>
Field<Dof> affine_forces(const Backbone& backbone) {
  Field<Dof> w(backbone.grain_count);
  for (const Link& l : backbone.links) {
    const Joint* joint = backbone.joint_of(l);
    const Strain strain = branch_strain(branch_of(l, joint));
    const Strain contact_force = elastic_stiffness(l) * strain;
    const Strain prestress_force = prestress_stiffness(l) * strain;
    using Forces = Eigen::Matrix<double, Dof, load_cases>;
    const Forces on_a = kinematics<Dof>(l, joint, -1).transpose() * contact_force;
    const Forces on_b = kinematics<Dof>(l, joint, +1).transpose() * contact_force;
    add(on_a, w[l.a]);
    add(on_b, w[l.b]);
    add(Strain(-prestress_force), w[l.a]);
    add(prestress_force, w[l.b]);
  }
  for (const Link& l : backbone.wall_links) {
    const Joint* joint = backbone.wall_joint_of(l);
    const Strain strain = branch_strain(branch_of(l, joint));
    const Strain contact_force = elastic_stiffness(l) * strain;
    using Forces = Eigen::Matrix<double, Dof, load_cases>;
    const Forces on_a = kinematics<Dof>(l, joint, -1).transpose() * contact_force;
    add(on_a, w[l.a]);
    add(Strain(prestress_stiffness(l) * strain), w[l.a]);
  }
  return w;
}

PerCase affine_force_scale(const Backbone& backbone) {
  Eigen::Matrix<double, 1, load_cases> squares = Eigen::Matrix<double, 1, load_cases>::Zero();
  const auto add = [&](const Link& l, const Joint* joint) {
    squares += (elastic_stiffness(l) * branch_strain(branch_of(l, joint))).colwise().squaredNorm();
  };
  for (const Link& l : backbone.links)
    add(l, backbone.joint_of(l));
  for (const Link& l : backbone.wall_links)
    add(l, backbone.wall_joint_of(l));
  PerCase scale{};
  for (std::size_t c = 0; c < scale.size(); ++c)
    scale[c] = std::sqrt(squares[static_cast<Eigen::Index>(c)]);
  return scale;
}

elastic::Matrix6 affine_energy(const Backbone& backbone) {
  elastic::Matrix6 energy = elastic::Matrix6::Zero();
  for (const Link& l : backbone.links) {
    const Strain strain = branch_strain(branch_of(l, backbone.joint_of(l)));
    energy += strain.transpose() * (elastic_stiffness(l) + prestress_stiffness(l)) * strain;
  }
  for (const Link& l : backbone.wall_links) {
    const Strain strain = branch_strain(branch_of(l, backbone.wall_joint_of(l)));
    energy += strain.transpose() * (elastic_stiffness(l) - 3 * prestress_stiffness(l)) * strain;
  }
  return energy;
}

template <int Dof>
LinkBlocks<Dof> link_blocks(const Link& link, const Joint* joint) {
  const Kinematics<Dof> at_a = kinematics<Dof>(link, joint, -1), at_b = kinematics<Dof>(link, joint, +1);
  const Matrix3 k = elastic_stiffness(link), g = prestress_stiffness(link);
  using Square = Eigen::Matrix<double, Dof, Dof>;
  Square aa = at_a.transpose() * k * at_a, bb = at_b.transpose() * k * at_b, ba = at_b.transpose() * k * at_a;
  aa.template topLeftCorner<3, 3>() += g;
  bb.template topLeftCorner<3, 3>() += g;
  ba.template topLeftCorner<3, 3>() -= g;
  if constexpr (Dof == 6)
    if (joint != nullptr) {
      const Matrix3 turning = turning_stiffness(link, *joint);
      const double a = joint->per_radius_a, b = joint->per_radius_b;
      aa.template bottomRightCorner<3, 3>() += a * a * turning;
      bb.template bottomRightCorner<3, 3>() += b * b * turning;
      ba.template bottomRightCorner<3, 3>() -= a * b * turning;
    }
  return {block<Dof>(aa), block<Dof>(bb), block<Dof>(ba)};
}

template <int Dof>
Block<Dof> wall_block(const Link& link, const Joint* joint) {
  const Kinematics<Dof> at_a = kinematics<Dof>(link, joint, -1);
  using Square = Eigen::Matrix<double, Dof, Dof>;
  Square aa = at_a.transpose() * elastic_stiffness(link) * at_a;
  if constexpr (Dof == 6)
    if (joint != nullptr)
      aa.template bottomRightCorner<3, 3>() +=
          joint->per_radius_a * joint->per_radius_a * turning_stiffness(link, *joint);
  return block<Dof>(aa);
}

template <int Dof>
std::vector<Block<Dof>> diagonal_blocks(const Backbone& backbone) {
  std::vector<Block<Dof>> diagonal(backbone.grain_count);
  for (const Link& l : backbone.links) {
    const auto blocks = link_blocks<Dof>(l, backbone.joint_of(l));
    add(blocks.diagonal_a, diagonal[l.a]);
    add(blocks.diagonal_b, diagonal[l.b]);
  }
  for (const Link& l : backbone.wall_links)
    add(wall_block<Dof>(l, backbone.wall_joint_of(l)), diagonal[l.a]);
  return diagonal;
}

template void apply_stiffness<3>(const Backbone&, const Workers&, double, const Field<3>&, Field<3>&);
template void apply_stiffness<6>(const Backbone&, const Workers&, double, const Field<6>&, Field<6>&);
template Field<3> affine_forces<3>(const Backbone&);
template Field<6> affine_forces<6>(const Backbone&);
template LinkBlocks<3> link_blocks<3>(const Link&, const Joint*);
template LinkBlocks<6> link_blocks<6>(const Link&, const Joint*);
template Block<3> wall_block<3>(const Link&, const Joint*);
template Block<6> wall_block<6>(const Link&, const Joint*);
template std::vector<Block<3>> diagonal_blocks<3>(const Backbone&);
template std::vector<Block<6>> diagonal_blocks<6>(const Backbone&);

} // namespace granum::network

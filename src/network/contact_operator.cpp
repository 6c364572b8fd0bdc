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
//
// Energies of the forces, with v = E b + u_j - u_i, omega = s (t_i + t_j) and the force f n + s on j; primes
// mark the motion that a change of forces works on. With motions v, omega the force on j changes by
// f dn - n (s.dn), dn = (1 - n n) v/l, because the engine keeps s normal to the new n. The torque on either
// grain, -a n x s, changes by the terms of v x s and n x ds. The energy of the forces per contact is
//   -(f/l) v_t.v_t' + (s.v)(n.v')/l + v.(s x omega')/l,
// which is 0 for a grain that rotates about the line through its two contacts. Contacts that unload lose s in
// proportion to k_t, half of that in the mean of loading and unloading: a force -s kappa (n.v)/2 against
// v' + n x omega'. The change of the cell adds, with the mean stress S of these forces, the sum of f.(E' E b)
// as branches turn and stretch, and S tr E as the volume grows.
#include "contact_operator.hpp"

#include <algorithm>
#include <cmath>
#include <span>

#include "core/vector/level.hpp"
#include "link_forces.hpp"

namespace granum::network {

namespace {

using elastic::Matrix6;

// Unit strains in the order 11 22 33 23 13 12, engineering shears, and what they do.

/// A vector for each load case.
using Strain = Eigen::Matrix<double, 3, load_cases>;

Eigen::Vector3d eigen(const Vec3& v) { return {v.x, v.y, v.z}; }

/// n x, as a matrix.
Eigen::Matrix3d cross_matrix(const Vec3& n) {
  Eigen::Matrix3d m;
  m << 0, -n.z, n.y, n.z, 0, -n.x, -n.y, n.x, 0;
  return m;
}

Eigen::Matrix3d unit_strain(int load_case) {
  constexpr int rows[] = {0, 1, 2, 1, 0, 0}, columns[] = {0, 1, 2, 2, 2, 1};
  Eigen::Matrix3d e = Eigen::Matrix3d::Zero();
  e(rows[load_case], columns[load_case]) += 0.5;
  e(columns[load_case], rows[load_case]) += 0.5;
  return e;
}

/// Relative displacement of the two ends of a branch b for unit strains.
Strain branch_strain(const Vec3& b) {
  Strain e;
  e << b.x, 0, 0, 0, b.z / 2, b.y / 2, //
      0, b.y, 0, b.z / 2, 0, b.x / 2,  //
      0, 0, b.z, b.y / 2, b.x / 2, 0;
  return e;
}

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

/// Motions of a contact's two sides against each other in all load cases.
struct Motion {
  Strain v, omega;
};

template <int Dof>
Motion motion_of(const LoadedContact& c, const Field<Dof>& q) {
  Motion m{branch_strain(c.branch), Strain::Zero()};
  for (int row = 0; row < 3; ++row)
    for (int k = 0; k < load_cases; ++k) {
      m.v(row, k) += q[c.j].row[row][k] - q[c.i].row[row][k];
      if constexpr (Dof == 6)
        m.omega(row, k) = c.lever * (q[c.i].row[3 + row][k] + q[c.j].row[3 + row][k]);
    }
  return m;
}

/// Contribution of the change of the cell, with the sum of force (x) branch.
Matrix6 cell_energy(const Eigen::Matrix3d& stress) {
  Matrix6 energy;
  for (int a = 0; a < load_cases; ++a)
    for (int b = 0; b < load_cases; ++b) {
      const Eigen::Matrix3d first = unit_strain(a), second = unit_strain(b);
      energy(a, b) =
          -(stress * (first * second + second * first)).trace() / 2 +
          ((stress * first).trace() * second.trace() + (stress * second).trace() * first.trace()) / 2;
    }
  return energy;
}

Matrix6 symmetric(const Matrix6& m) { return (m + m.transpose()) / 2; }

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

template <int Dof>
ForceEnergies force_energies(const Backbone& backbone, const Field<Dof>& q) {
  ForceEnergies sum;
  Eigen::Matrix3d stress = Eigen::Matrix3d::Zero();
  for (const LoadedContact& c : backbone.loaded) {
    const auto [v, omega] = motion_of<Dof>(c, q);
    const double length = norm(c.branch);
    const Eigen::Vector3d n = eigen(c.branch) / length, s = eigen(c.tangential_force);
    const Eigen::Matrix<double, 1, load_cases> along = n.transpose() * v, by_s = s.transpose() * v;
    const Strain across = v - n * along;
    sum.geometric += (along.transpose() * by_s - c.normal_force * across.transpose() * across +
                      (cross_matrix(c.tangential_force) * omega).transpose() * v) /
                     length;
    const Strain slip = v + cross_matrix((1 / length) * c.branch) * omega;
    sum.shedding += c.tangential_share / 2 * (s.transpose() * slip).transpose() * along;
    stress += (c.normal_force * n + s) * eigen(c.branch).transpose();
  }
  return {.geometric = symmetric(sum.geometric + cell_energy((stress + stress.transpose()) / 2)),
          .shedding = symmetric(sum.shedding)};
}

template ForceEnergies force_energies<3>(const Backbone&, const Field<3>&);
template ForceEnergies force_energies<6>(const Backbone&, const Field<6>&);

} // namespace granum::network

// SPDX-License-Identifier: GPL-3.0-or-later
// Notation: as in contact_operator.cpp, with v = E b + u_j - u_i, omega = s (t_i + t_j) and the force f n + s
// on j; primes mark the motion that a change of forces works on. With motions v, omega the force on j changes
// by f dn - n (s.dn), dn = (1 - n n) v/l, because the engine keeps s normal to the new n. The torque on
// either grain, -a n x s, changes by the terms of v x s and n x ds. The energy of the forces per contact is
//   -(f/l) v_t.v_t' + (s.v)(n.v')/l + v.(s x omega')/l,
// which is 0 for a grain that rotates about the line through its two contacts. Contacts that unload lose s in
// proportion to k_t, half of that in the mean of loading and unloading: a force -s kappa (n.v)/2 against
// v' + n x omega'. The change of the cell adds, with the mean stress S of these forces, the sum of f.(E' E b)
// as branches turn and stretch, and S tr E as the volume grows.
#include "force_energies.hpp"

#include "strains.hpp"

namespace granum::network {

namespace {

using elastic::Matrix6;

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

// SPDX-License-Identifier: GPL-3.0-or-later
// Private to src/network. Forces of one contact, for all load cases; notation as in contact_operator.cpp.
#pragma once

#include <array>

#include "backbone.hpp"
#include "core/vector/level.hpp"
#include "lanes.hpp"

namespace granum::network {

using Vec = std::array<Lanes, 3>;

GRANUM_INLINE Vec cross(const Vec3& n, const Vec& t) {
  return {n.y * t[2] - n.z * t[1], n.z * t[0] - n.x * t[2], n.x * t[1] - n.y * t[0]};
}

GRANUM_INLINE Vec anisotropic(double along, double across, const Vec3& n, const Vec& d) {
  const Lanes excess = (along - across) * (n.x * d[0] + n.y * d[1] + n.z * d[2]);
  return {across * d[0] + n.x * excess, across * d[1] + n.y * excess, across * d[2] + n.z * excess};
}

/// Adds the forces of a contact, y += H x, for the displacements of its two sides.
template <int Dof>
GRANUM_INLINE void add_link_forces(const Link& link, const Rows<Dof>& xa, const Rows<Dof>& xb, Rows<Dof>& ya,
                                   Rows<Dof>& yb) {
  const Vec v{xb.row[0] - xa.row[0], xb.row[1] - xa.row[1], xb.row[2] - xa.row[2]};
  Vec delta = v;
  if constexpr (Dof == 6) {
    const Vec spin =
        cross(link.normal, {xa.row[3] + xb.row[3], xa.row[4] + xb.row[4], xa.row[5] + xb.row[5]});
    for (unsigned k = 0; k < 3; ++k)
      delta[k] += link.lever * spin[k];
  }
  Vec force = anisotropic(link.normal_stiffness, link.tangential_stiffness, link.normal, delta);
  if constexpr (Dof == 6) {
    const Vec turn = cross(link.normal, force);
    for (unsigned k = 0; k < 3; ++k) {
      const Lanes moment = link.lever * turn[k];
      ya.row[3 + k] -= moment;
      yb.row[3 + k] -= moment;
    }
  }
  if (link.prestress != 0) {
    const Vec geometric = anisotropic(0, -link.prestress, link.normal, v);
    for (unsigned k = 0; k < 3; ++k)
      force[k] += geometric[k];
  }
  for (unsigned k = 0; k < 3; ++k) {
    ya.row[k] -= force[k];
    yb.row[k] += force[k];
  }
}

GRANUM_INLINE Vec spin_of(const Vec3& arm, const Vec& t) {
  const Vec turn = cross(arm, t); // t x arm is its negative
  return {-turn[0], -turn[1], -turn[2]};
}

/// The same for a contact with a joint.
template <int Dof>
GRANUM_INLINE void add_link_forces(const Link& link, const Joint& joint, const Rows<Dof>& xa,
                                   const Rows<Dof>& xb, Rows<Dof>& ya, Rows<Dof>& yb) {
  if constexpr (Dof == 6) {
    const Vec ta{xa.row[3], xa.row[4], xa.row[5]}, tb{xb.row[3], xb.row[4], xb.row[5]};
    const Vec moved_a = spin_of(joint.arm_a, ta), moved_b = spin_of(joint.arm_b, tb);
    Vec delta, turned;
    for (unsigned k = 0; k < 3; ++k) {
      delta[k] = xb.row[k] - xa.row[k] + moved_b[k] - moved_a[k];
      turned[k] = joint.per_radius_b * tb[k] - joint.per_radius_a * ta[k];
    }
    const Vec force = anisotropic(link.normal_stiffness, link.tangential_stiffness, link.normal, delta);
    const Vec moment = anisotropic(joint.twisting, joint.rolling, link.normal, turned);
    const Vec on_a = cross(joint.arm_a, force), on_b = cross(joint.arm_b, force);
    for (unsigned k = 0; k < 3; ++k) {
      ya.row[k] -= force[k];
      yb.row[k] += force[k];
      ya.row[3 + k] -= on_a[k] + joint.per_radius_a * moment[k];
      yb.row[3 + k] += on_b[k] + joint.per_radius_b * moment[k];
    }
    if (link.prestress != 0) {
      const Vec geometric =
          anisotropic(0, -link.prestress, link.normal,
                      {xb.row[0] - xa.row[0], xb.row[1] - xa.row[1], xb.row[2] - xa.row[2]});
      for (unsigned k = 0; k < 3; ++k) {
        ya.row[k] -= geometric[k];
        yb.row[k] += geometric[k];
      }
    }
  } else {
    add_link_forces<Dof>(link, xa, xb, ya, yb); // without spins a joint has no effect
  }
}

/// With its joint, if it has one.
template <int Dof>
GRANUM_INLINE void add_link_forces(const Link& link, const Joint* joint, const Rows<Dof>& xa,
                                   const Rows<Dof>& xb, Rows<Dof>& ya, Rows<Dof>& yb) {
  if (joint != nullptr)
    add_link_forces<Dof>(link, *joint, xa, xb, ya, yb);
  else
    add_link_forces<Dof>(link, xa, xb, ya, yb);
}

/// Adds the forces of a contact with a wall on its grain.
template <int Dof>
GRANUM_INLINE void add_wall_forces(Link link, const Joint* joint, const Rows<Dof>& x, Rows<Dof>& y) {
  link.prestress = 0; // no part in (u, u): see contact_operator.cpp
  const Rows<Dof> at_rest = {};
  Rows<Dof> reaction = {};
  add_link_forces<Dof>(link, joint, x, at_rest, y, reaction);
}

} // namespace granum::network

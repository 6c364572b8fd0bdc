// SPDX-License-Identifier: GPL-3.0-or-later
// Notation: s tangential force on the grain.
#include "wall_contacts.hpp"

#include <algorithm>
#include <cmath>
#include <span>
#include <tuple>
#include <type_traits>
#include <variant>

namespace granum::dem {

namespace {

/// The tangential force after a step with the displacement `slip` of the surface along the wall, within
/// Coulomb's limit; as for two grains (contact_sweep.cpp), with the wall's normal.
bool turn_and_limit(WallHistory& contact, const Vec3& normal, const Vec3& slip, double stiffness,
                    double limit) {
  const double keep =
      stiffness < contact.tangential_stiffness ? stiffness / contact.tangential_stiffness : 1.0;
  Vec3 s = keep * contact.tangential_force - stiffness * slip;
  s -= dot(s, normal) * normal;
  const double size = norm(s);
  const bool slides = size > limit;
  contact.tangential_force = slides ? (limit / size) * s : s;
  contact.tangential_stiffness = stiffness;
  return slides;
}

/// The same from the motion of grain and wall. The wall is a rigid plate: its tangential velocity is that of
/// its centre, and its rotation is normal to itself.
bool drag_along(WallHistory& contact, const WallPlane& plane, const SweepInput& in, const Vec3& arm,
                const contact::NormalResponse& response, double friction) {
  const Vec3 wall = in.gradient * plane.centre;
  const Vec3 surface = in.gradient * in.grains.centre(contact.grain) + in.grains.velocity(contact.grain) +
                       cross(in.grains.spin(contact.grain), arm);
  return turn_and_limit(contact, plane.normal, in.elapsed * (surface - wall),
                        in.tangential_ratio * response.stiffness, friction * response.force);
}

} // namespace

template <class AnyGrains>
void WallContacts::list(const Mat3& cell, const AnyGrains& grains, double radius, double gap,
                        const std::vector<WallHistory>& history) {
  const std::array<WallPlane, wall_count> planes = wall_planes(cell);
  std::vector<WallHistory> listed;
  auto past = history.begin();
  for (std::uint32_t g = 0; g < grains.size(); ++g)
    for (std::uint32_t w = 0; w < wall_count; ++w) {
      if (wall_distance(planes[w], grains.centre(g)) >= grains.radius_or(radius, g) + gap)
        continue;
      while (past != history.end() && std::tie(past->grain, past->wall) < std::tie(g, w))
        ++past;
      const bool known = past != history.end() && past->grain == g && past->wall == w;
      listed.push_back(known ? *past : WallHistory{g, w, {}, 0});
    }
  contacts_ = std::move(listed);
}

template void WallContacts::list(const Mat3&, const Grains&, double, double, const std::vector<WallHistory>&);
template void WallContacts::list(const Mat3&, const TranslatingGrains&, double, double,
                                 const std::vector<WallHistory>&);

template <class Input, class Load, class Sums>
WallForces WallContacts::sweep_all(const contact::NormalKernel& law, const Input& in, Range of_grains,
                                   bool rough, std::vector<Load>& load, Sums& sums) {
  const std::array<WallPlane, wall_count> planes = wall_planes(in.cell);
  WallForces forces;
  const auto before = [](const WallHistory& contact, std::size_t grain) { return contact.grain < grain; };
  const auto first = std::lower_bound(contacts_.begin(), contacts_.end(), of_grains.begin, before);
  const auto last = std::lower_bound(first, contacts_.end(), of_grains.end, before);
  for (WallHistory& contact : std::span(first, last)) {
    const WallPlane& plane = planes[contact.wall];
    const double distance = wall_distance(plane, in.grains.centre(contact.grain));
    const double overlap = in.grains.radius_or(in.diameter / 2, contact.grain) - distance;
    if (!(overlap > 0)) {
      contact.tangential_force = {};
      contact.tangential_stiffness = 0;
      continue;
    }
    const contact::NormalResponse response = std::visit(
        [&](const auto& kernel) { return wall_response(kernel, in.grains, contact.grain, overlap); }, law);
    const Vec3 arm = -distance * plane.normal;
    Vec3 force = response.force * plane.normal;
    if constexpr (std::is_same_v<Input, SweepInput>) {
      if (rough) {
        forces.sliding += drag_along(contact, plane, in, arm, response, friction_);
        force += contact.tangential_force;
        add_torque(load[contact.grain], in.grains.stored_torque(contact.grain, cross(arm, force)));
      }
    }
    add_force(load[contact.grain], force);
    forces.force[contact.wall] += force;
    ++forces.contacts;
    // The grain exerts -force on the wall, with the branch `arm`.
    if constexpr (std::is_same_v<Sums, SweepSums>) {
      sums.stress += outer(-force, arm);
      sums.stiffness += response.stiffness * distance * distance;
    } else {
      sums.virial += dot(-force, arm);
    }
    sums.normal_force += response.force;
    sums.stiffest = std::max(sums.stiffest, response.stiffness);
  }
  return forces;
}

WallForces WallContacts::sweep(const contact::NormalKernel& law, const SweepInput& input, Range of_grains,
                               bool tangential, std::vector<LoadRow>& load, SweepSums& sums) {
  return sweep_all(law, input, of_grains, tangential && friction_ > 0, load, sums);
}

WallForces WallContacts::descent_sweep(const contact::NormalKernel& law, const DescentInput& input,
                                       Range of_grains, std::vector<PushRow>& load, DescentSums& sums) {
  return sweep_all(law, input, of_grains, false, load, sums);
}

std::vector<WallHistory> WallContacts::history() const {
  std::vector<WallHistory> out;
  std::copy_if(contacts_.begin(), contacts_.end(), std::back_inserter(out),
               [](const WallHistory& contact) { return contact.tangential_stiffness > 0; });
  return out;
}

} // namespace granum::dem

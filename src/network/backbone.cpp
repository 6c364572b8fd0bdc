// SPDX-License-Identifier: GPL-3.0-or-later
#include "backbone.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <optional>
#include <tuple>
#include <utility>

#include <granum/core/error.hpp>
#include <granum/core/stop.hpp>
#include <granum/packing/assembly.hpp>
#include <granum/packing/coordination.hpp>

namespace granum::network {

namespace {

constexpr std::uint32_t unset = Numbering::unset;

double effective_tangential_stiffness(const packing::Contact& c, SlidingContacts sliding) {
  return c.sliding && sliding == SlidingContacts::release ? 0 : c.tangential_stiffness;
}

/// In the units of the contact.
Link link(const packing::Contact& c, std::uint32_t i, std::uint32_t j, double radii,
          const ResponseOptions& options) {
  const double length = norm(c.branch);
  return {.a = std::min(i, j),
          .b = std::max(i, j),
          .normal = i <= j ? normal(c) : -normal(c),
          .length = length,
          .lever = length / radii,
          .normal_stiffness = c.normal_stiffness,
          .tangential_stiffness = effective_tangential_stiffness(c, options.sliding),
          .prestress = options.prestress ? c.normal_force / length : 0};
}

LoadedContact loaded(const packing::Contact& c, std::uint32_t i, std::uint32_t j, double radii) {
  // k_n ~ overlap^(1/alpha), 1 + 1/alpha = k_n overlap/f, and k_t is proportional to k_n
  const bool pressed = c.normal_force > 0 && c.overlap > 0;
  return {.i = i,
          .j = j,
          .branch = c.branch,
          .lever = norm(c.branch) / radii,
          .normal_force = c.normal_force,
          .tangential_force = c.tangential_force,
          .tangential_share = pressed ? c.normal_stiffness / c.normal_force - 1 / c.overlap : 0};
}

bool resists_turning(const packing::Contact& c) {
  return c.rolling_stiffness > 0 || c.twisting_stiffness > 0;
}

template <class Holds>
bool any_contact(const packing::Assembly& assembly, const Holds& holds) {
  return std::any_of(assembly.contacts.begin(), assembly.contacts.end(), holds) ||
         std::any_of(assembly.wall_contacts.begin(), assembly.wall_contacts.end(), holds);
}

/// The grains of an assembly, and the rigid bodies that they form, if any.
class Grains {
 public:
  explicit Grains(const packing::Assembly& assembly) : assembly_(assembly) {
    if (!assembly.body.empty())
      bodies_ = packing::bodies(assembly);
  }

  /// The assembly with each body as one grain.
  [[nodiscard]] const packing::Assembly& moving() const { return bodies_ ? bodies_->assembly : assembly_; }
  /// The contact between grains that belongs to contact k of moving().
  [[nodiscard]] const packing::Contact& contact(std::size_t k) const {
    return assembly_.contacts[bodies_ ? bodies_->contact[k] : k];
  }

  /// Unit vector from the first body to the second.
  [[nodiscard]] Vec3 contact_normal(const packing::Contact& moving, std::size_t k) const {
    return is_turned(moving, k) ? -normal(contact(k)) : normal(contact(k));
  }
  /// \param    moving   number k of moving()
  [[nodiscard]] Joint joint(const packing::Contact& moving, std::size_t k) const {
    const packing::Contact& c = contact(k);
    const bool turned = is_turned(moving, k);
    const Vec3 at_i = to_body(c.i) + share(c.i, c.j) * c.branch,
               at_j = to_body(c.j) - share(c.j, c.i) * c.branch;
    return joint(moving.branch, turned ? at_j : at_i, turned ? at_i : at_j, radius(moving.i),
                 radius(moving.j), moving);
  }
  /// \param    moving   with a wall, number k of moving()
  [[nodiscard]] Joint wall_joint(const packing::Contact& moving, std::size_t k) const {
    const packing::Contact& c = assembly_.wall_contacts[k];
    return joint(moving.branch, to_body(c.i) + c.branch, {}, radius(moving.i), radius(moving.i), moving);
  }

 private:
  [[nodiscard]] bool is_turned(const packing::Contact& moving, std::size_t k) const {
    return bodies_ && assembly_.body[contact(k).i] != moving.i;
  }
  [[nodiscard]] double radius(std::uint32_t body) const { return moving().radius[body]; }
  [[nodiscard]] Vec3 to_body(std::uint32_t grain) const { return bodies_ ? bodies_->offset[grain] : Vec3{}; }
  [[nodiscard]] double share(std::uint32_t of, std::uint32_t other) const {
    return assembly_.radius[of] / (assembly_.radius[of] + assembly_.radius[other]);
  }
  static Joint joint(const Vec3& branch, const Vec3& at_a, const Vec3& at_b, double radius_a, double radius_b,
                     const packing::Contact& c) {
    return {.branch = branch,
            .arm_a = (1 / radius_a) * at_a,
            .arm_b = (1 / radius_b) * at_b,
            .rolling = c.rolling_stiffness,
            .twisting = c.twisting_stiffness,
            .per_radius_a = 1 / radius_a,
            .per_radius_b = 1 / radius_b};
  }

  const packing::Assembly& assembly_;
  std::optional<packing::Bodies> bodies_;
};

/// With both sides exchanged.
Joint turned(const Joint& j) {
  return {.branch = -j.branch,
          .arm_a = j.arm_b,
          .arm_b = j.arm_a,
          .rolling = j.rolling,
          .twisting = j.twisting,
          .per_radius_a = j.per_radius_b,
          .per_radius_b = j.per_radius_a};
}

/// Sorts links, and their joints, if any.
template <class Before>
void sort_links(std::vector<Link>& links, std::vector<Joint>& joints, const Before& before) {
  std::vector<std::size_t> order(joints.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::stable_sort(order.begin(), order.end(),
                   [&](std::size_t k, std::size_t l) { return before(links[k], links[l]); });
  std::vector<Joint> sorted;
  sorted.reserve(joints.size());
  for (const std::size_t k : order)
    sorted.push_back(joints[k]);
  joints = std::move(sorted);
  std::stable_sort(links.begin(), links.end(), before);
}

/// Every centre, moved into the cell.
std::vector<Vec3> inside(const packing::Assembly& assembly) {
  const Mat3 to_parts = inverse_of(assembly.cell);
  std::vector<Vec3> centre;
  centre.reserve(assembly.grain_count());
  for (const Vec3& x : assembly.position) {
    Vec3 part = to_parts * x;
    for (int k = 0; k < 3; ++k)
      part[k] -= std::floor(part[k]);
    centre.push_back(assembly.cell * part);
  }
  return centre;
}

void remove_units(Backbone& backbone) {
  double stiffness_sum = 0, length_sum = 0;
  for (const auto* links : {&backbone.links, &backbone.wall_links})
    for (const Link& l : *links) {
      stiffness_sum += l.normal_stiffness;
      length_sum += l.length;
    }
  const auto count = static_cast<double>(backbone.links.size() + backbone.wall_links.size());
  backbone.length_scale = length_sum / count;
  if (stiffness_sum > 0)
    backbone.stiffness_scale = stiffness_sum / count;
  for (auto* links : {&backbone.links, &backbone.wall_links})
    for (Link& l : *links) {
      l.length /= backbone.length_scale;
      l.normal_stiffness /= backbone.stiffness_scale;
      l.tangential_stiffness /= backbone.stiffness_scale;
      l.prestress /= backbone.stiffness_scale;
    }
  for (auto* joints : {&backbone.joints, &backbone.wall_joints})
    for (Joint& j : *joints) {
      j.branch *= 1 / backbone.length_scale;
      j.per_radius_a *= backbone.length_scale;
      j.per_radius_b *= backbone.length_scale;
      j.rolling /= backbone.stiffness_scale * backbone.length_scale * backbone.length_scale;
      j.twisting /= backbone.stiffness_scale * backbone.length_scale * backbone.length_scale;
    }
  const double per_force = 1 / (backbone.stiffness_scale * backbone.length_scale);
  for (LoadedContact& c : backbone.loaded) {
    c.branch *= 1 / backbone.length_scale;
    c.normal_force *= per_force;
    c.tangential_force *= per_force;
    c.tangential_share *= backbone.length_scale;
  }
  for (Vec3& x : backbone.centre)
    x *= 1 / backbone.length_scale;
  backbone.cell = (1 / backbone.length_scale) * backbone.cell;
  for (double& r : backbone.radius)
    r /= backbone.length_scale;
}

bool turns(const packing::Assembly& assembly, const Grains& grains, const ResponseOptions& options) {
  return any_contact(grains.moving(),
                     [&](const packing::Contact& c) {
                       return effective_tangential_stiffness(c, options.sliding) > 0 || resists_turning(c);
                     }) ||
         !assembly.body.empty();
}

/// The grains that have a number, and the contacts between them.
void fill(Backbone& backbone, const packing::Assembly& assembly, const Grains& grains,
          const std::vector<Vec3>& centre, const std::vector<std::uint32_t>& number,
          const ResponseOptions& options) {
  const packing::Assembly& moving = grains.moving();
  const bool joined = !assembly.body.empty() || any_contact(moving, resists_turning);
  backbone.cell = moving.cell;
  backbone.grain.resize(backbone.grain_count);
  backbone.centre.resize(backbone.grain_count);
  backbone.radius.resize(backbone.grain_count);
  for (std::uint32_t g = 0; g < number.size(); ++g)
    if (number[g] != unset) {
      backbone.grain[number[g]] = g;
      backbone.centre[number[g]] = centre[g];
      backbone.radius[number[g]] = moving.radius[g];
    }
  for (std::size_t k = 0; k < moving.contacts.size(); ++k) {
    stop_point(k);
    const packing::Contact &c = moving.contacts[k], &between = grains.contact(k);
    const std::uint32_t i = number[c.i], j = number[c.j];
    if (i == unset || j == unset)
      continue;
    const double radii = assembly.radius[between.i] + assembly.radius[between.j];
    backbone.links.push_back(link(c, i, j, radii, options));
    if (joined) {
      const Joint joint = grains.joint(c, k);
      backbone.joints.push_back(i <= j ? joint : turned(joint));
      const Vec3 n = grains.contact_normal(c, k);
      backbone.links.back().normal = i <= j ? n : -n;
    }
    if (options.force_terms)
      backbone.loaded.push_back(loaded(c, i, j, radii));
  }
  for (std::size_t k = 0; k < moving.wall_contacts.size(); ++k) {
    const packing::Contact& c = moving.wall_contacts[k];
    const std::uint32_t i = number[c.i];
    if (i == unset)
      continue;
    const packing::Contact& of_grain = assembly.wall_contacts[k];
    backbone.wall_links.push_back(link(of_grain, i, i, assembly.radius[of_grain.i], options));
    if (joined)
      backbone.wall_joints.push_back(grains.wall_joint(c, k));
  }
  remove_units(backbone);
  sort_links(backbone.links, backbone.joints,
             [](const Link& l, const Link& m) { return std::pair(l.b, l.a) < std::pair(m.b, m.a); });
  sort_links(backbone.wall_links, backbone.wall_joints,
             [](const Link& l, const Link& m) { return l.a < m.a; });
}

} // namespace

Backbone load_bearing_network(const packing::Assembly& assembly, const ResponseOptions& options,
                              const std::vector<bool>& soft) {
  if (options.prestress && !assembly.body.empty())
    throw InvalidArgument("prestress: not implemented for grains that are parts of rigid bodies");
  Backbone backbone;
  const Grains grains(assembly);
  const packing::Assembly& moving = grains.moving();
  backbone.rotations = turns(assembly, grains, options);
  const auto mechanics = mechanical_coordination(
      moving, backbone.rotations ? packing::ContactKind::frictional : packing::ContactKind::frictionless);
  backbone.grain_count = moving.grain_count() - mechanics.rattler_count;
  backbone.moving_count = moving.grain_count();
  if (mechanics.contact_count + mechanics.wall_contact_count == 0)
    return backbone;

  const std::vector<Vec3> centre = inside(moving);
  auto [number, stages] = number_grains(moving, mechanics.rattler, centre, soft);
  backbone.stages = std::move(stages);
  fill(backbone, assembly, grains, centre, number, options);
  return backbone;
}

Backbone network_with_rattlers(const packing::Assembly& assembly, const ResponseOptions& options) {
  Backbone backbone;
  const Grains grains(assembly);
  const packing::Assembly& moving = grains.moving();
  backbone.rotations = turns(assembly, grains, options);
  backbone.grain_count = moving.grain_count();
  if (moving.contacts.empty() && moving.wall_contacts.empty())
    return backbone;

  std::vector<std::uint32_t> number(moving.grain_count());
  std::iota(number.begin(), number.end(), std::uint32_t{0});
  fill(backbone, assembly, grains, inside(moving), number, options);
  return backbone;
}

} // namespace granum::network

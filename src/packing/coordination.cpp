// SPDX-License-Identifier: GPL-3.0-or-later
#include <granum/packing/coordination.hpp>

#include <algorithm>
#include <vector>

#include <granum/core/error.hpp>
#include <granum/core/stop.hpp>
#include <granum/packing/forces.hpp>

namespace granum::packing {

double coordination_number(const Assembly& assembly) {
  require_valid(assembly);
  if (assembly.grain_count() == 0)
    throw InvalidArgument("coordination_number: the assembly has no grains");
  return 2 * static_cast<double>(assembly.contacts.size()) / static_cast<double>(assembly.grain_count());
}

MechanicalCoordination mechanical_coordination(const Assembly& assembly, ContactKind kind) {
  require_valid(assembly);
  const std::size_t fewest = kind == ContactKind::frictional ? 2 : 4;
  const std::size_t grains = assembly.grain_count();
  std::vector<std::vector<std::uint32_t>> neighbours(grains);
  for (const Contact& c : assembly.contacts) {
    neighbours[c.i].push_back(c.j);
    neighbours[c.j].push_back(c.i);
  }
  std::vector<std::size_t> degree(grains);
  for (const Contact& c : assembly.wall_contacts)
    ++degree[c.i];
  std::vector<std::size_t> removed;
  MechanicalCoordination result{.rattler = std::vector<bool>(grains, false)};
  for (std::size_t g = 0; g < grains; ++g) {
    stop_point(g);
    degree[g] += neighbours[g].size();
    if (degree[g] < fewest) {
      result.rattler[g] = true;
      removed.push_back(g);
    }
  }
  for (std::size_t head = 0; head < removed.size(); ++head)
    for (const std::uint32_t h : neighbours[removed[head]])
      if (--degree[h] < fewest && !result.rattler[h]) {
        result.rattler[h] = true;
        removed.push_back(h);
      }

  result.rattler_count = removed.size();
  for (const Contact& c : assembly.contacts)
    result.contact_count += !result.rattler[c.i] && !result.rattler[c.j];
  for (const Contact& c : assembly.wall_contacts)
    result.wall_contact_count += !result.rattler[c.i];
  if (grains > 0)
    result.rattler_fraction = static_cast<double>(result.rattler_count) / static_cast<double>(grains);
  if (result.rattler_count < grains)
    result.coordination_number =
        2 * static_cast<double>(result.contact_count) / static_cast<double>(grains - result.rattler_count);
  return result;
}

std::vector<Vec3> contact_normals(const Assembly& assembly) {
  require_valid(assembly);
  std::vector<Vec3> normals;
  normals.reserve(assembly.contacts.size());
  for (const Contact& c : assembly.contacts)
    normals.push_back(normal(c));
  return normals;
}

Mat3 fabric_tensor(const Assembly& assembly) { return fabric_tensor(contact_normals(assembly)); }

Mat3 fabric_tensor(std::span<const Vec3> normals) {
  if (normals.empty())
    throw InvalidArgument("fabric_tensor: the assembly has no contacts");
  const auto count = static_cast<double>(normals.size());
  Mat3 mean;
  for (const Vec3& n : normals)
    for (int i = 0; i < 3; ++i)
      for (int j = 0; j < 3; ++j)
        mean(i, j) += n[i] * n[j] / count;
  return mean;
}

namespace {

/// f_t/f_n of the contacts that press, ascending.
std::vector<double> force_ratios(const Assembly& assembly) {
  require_valid(assembly);
  constexpr double hardly = 1e-3;
  const double mean = force_distribution(normal_forces(assembly), 1).mean;
  std::vector<double> ratios;
  for (const Contact& c : assembly.contacts)
    if (c.normal_force > 0 && c.normal_force >= hardly * mean)
      ratios.push_back(norm(c.tangential_force) / c.normal_force);
  std::sort(ratios.begin(), ratios.end());
  return ratios;
}

/// How many values of an ascending list lie in [low, high].
double count_within(const std::vector<double>& sorted, double low, double high) {
  const auto begin = std::lower_bound(sorted.begin(), sorted.end(), low);
  return static_cast<double>(std::upper_bound(begin, sorted.end(), high) - begin);
}

} // namespace

std::optional<FrictionEstimate> estimate_friction(const Assembly& assembly) {
  constexpr double window = 1e-4; // relative, below the limit; 0.9 to 0.99 of it gives the usual density
  constexpr double fewest = 5, excess = 10;
  const std::vector<double> ratios = force_ratios(assembly);
  std::optional<FrictionEstimate> found;
  for (std::size_t above = 0; above <= ratios.size() / 1000 && above < ratios.size(); ++above) {
    const double limit = ratios[ratios.size() - 1 - above];
    const double at_limit = count_within(ratios, (1 - window) * limit, limit);
    const double usual = count_within(ratios, 0.9 * limit, 0.99 * limit) * window / 0.09;
    const auto contacts = static_cast<std::size_t>(at_limit);
    if (limit > 0 && at_limit >= fewest && at_limit > excess * usual &&
        (!found || contacts > found->contacts))
      found = FrictionEstimate{limit, contacts};
  }
  return found;
}

double sliding_fraction(const Assembly& assembly, double friction_coefficient) {
  constexpr double tolerance = 1e-3;
  require_non_negative("friction_coefficient", friction_coefficient);
  const std::vector<double> ratios = force_ratios(assembly);
  if (ratios.empty() || friction_coefficient == 0)
    return 0;
  const auto first = std::lower_bound(ratios.begin(), ratios.end(), (1 - tolerance) * friction_coefficient);
  return static_cast<double>(ratios.end() - first) / static_cast<double>(ratios.size());
}

double sliding_fraction(const Assembly& assembly) {
  if (assembly.contacts.empty())
    return 0;
  const auto sliding = std::count_if(assembly.contacts.begin(), assembly.contacts.end(),
                                     [](const Contact& c) { return c.sliding; });
  return static_cast<double>(sliding) / static_cast<double>(assembly.contacts.size());
}

} // namespace granum::packing

// SPDX-License-Identifier: GPL-3.0-or-later
#include <granum/packing/stress.hpp>

#include <cmath>
#include <numeric>

#include <granum/packing/bodies.hpp>

namespace granum::packing {

namespace {

double frobenius(const Mat3& m) {
  double squares = 0;
  for (const auto& row : m.m)
    for (const double value : row)
      squares += value * value;
  return std::sqrt(squares);
}

} // namespace

ContactStress contact_stress(const Assembly& assembly) {
  require_valid(assembly);
  Mat3 sum;
  for (const auto* contacts : {&assembly.contacts, &assembly.wall_contacts})
    for (const Contact& c : *contacts)
      sum += outer(force(c), c.branch);
  const double volume = assembly.volume();
  ContactStress stress;
  Mat3 antisymmetric;
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j < 3; ++j) {
      stress.tensor(i, j) = sum(i, j) / volume;
      stress.symmetric(i, j) = (sum(i, j) + sum(j, i)) / (2 * volume);
      antisymmetric(i, j) = (sum(i, j) - sum(j, i)) / (2 * volume);
    }
  const double size = frobenius(stress.symmetric);
  if (size > 0)
    stress.asymmetry = frobenius(antisymmetric) / size;
  return stress;
}

std::vector<Residual> residuals(const Assembly& assembly) {
  require_valid(assembly);
  std::vector<Residual> result(assembly.grain_count());
  for (const Contact& c : assembly.contacts) {
    const Vec3 f = force(c);
    const Vec3 turn = cross(c.branch, f);
    const double sum = assembly.radius[c.i] + assembly.radius[c.j];
    result[c.i].force -= f;
    result[c.j].force += f;
    result[c.i].moment -= (assembly.radius[c.i] / sum) * turn;
    result[c.j].moment -= (assembly.radius[c.j] / sum) * turn;
  }
  for (const Contact& c : assembly.wall_contacts) {
    result[c.i].force -= force(c);
    result[c.i].moment -= cross(c.branch, force(c));
  }
  return result;
}

namespace {

/// Unbalanced forces of bodies from those of their grains.
std::vector<Residual> residuals_of(const Bodies& bodies, const Assembly& assembly,
                                   const std::vector<Residual>& grains) {
  std::vector<Residual> result(bodies.assembly.grain_count());
  for (std::size_t g = 0; g < grains.size(); ++g) {
    Residual& body = result[assembly.body[g]];
    body.force += grains[g].force;
    body.moment += grains[g].moment + cross(bodies.offset[g], grains[g].force);
  }
  return result;
}

} // namespace

Unbalance unbalance(const Assembly& assembly) {
  std::vector<double> radii = assembly.radius;
  auto grains = residuals(assembly);
  if (!assembly.body.empty()) {
    const Bodies joined = bodies(assembly);
    grains = residuals_of(joined, assembly, grains);
    radii = joined.assembly.radius;
  }
  double contact_force = 0;
  for (const auto* contacts : {&assembly.contacts, &assembly.wall_contacts})
    for (const Contact& c : *contacts)
      contact_force += norm(force(c));
  if (!(contact_force > 0))
    return {};
  contact_force /= static_cast<double>(assembly.contacts.size() + assembly.wall_contacts.size());
  const auto count = static_cast<double>(grains.size());
  const double radius = std::accumulate(radii.begin(), radii.end(), 0.0) / count;
  Unbalance sum;
  for (const Residual& r : grains) {
    sum.force_ratio += norm(r.force);
    sum.moment_ratio += norm(r.moment);
  }
  return {sum.force_ratio / (count * contact_force), sum.moment_ratio / (count * contact_force * radius)};
}

} // namespace granum::packing

// SPDX-License-Identifier: GPL-3.0-or-later
#include <granum/packing/force_moments.hpp>

#include <cmath>
#include <limits>

#include <granum/core/error.hpp>
#include <granum/packing/stress.hpp>

namespace granum::packing {

namespace {

/// f^2/k, the work of a force on its own displacement.
double compliance_energy(double force, double stiffness) {
  if (force == 0)
    return 0;
  return stiffness > 0 ? force * force / stiffness : std::numeric_limits<double>::infinity();
}

} // namespace

double normal_force_moment(const Assembly& assembly, double exponent) {
  require_valid(assembly);
  require_finite("exponent", exponent);
  double count = 0, sum = 0;
  for (const Contact& c : assembly.contacts) {
    require_non_negative("normal_force", c.normal_force, "N");
    count += c.normal_force > 0;
    sum += c.normal_force;
  }
  if (!(sum > 0))
    throw InvalidArgument("force moment: no contact carries force");
  const double mean = sum / count;
  double moment = 0;
  for (const Contact& c : assembly.contacts)
    if (c.normal_force > 0)
      moment += std::pow(c.normal_force / mean, exponent);
  return moment / count;
}

BulkModulusBounds bulk_modulus_bounds(const Assembly& assembly) {
  const double pressure = contact_stress(assembly).mean();
  double stiffness = 0, energy = 0;
  for (const auto* contacts : {&assembly.contacts, &assembly.wall_contacts})
    for (const Contact& c : *contacts) {
      stiffness += c.normal_stiffness * dot(c.branch, c.branch);
      energy += compliance_energy(c.normal_force, c.normal_stiffness) +
                compliance_energy(norm(c.tangential_force), c.tangential_stiffness);
    }
  const double volume = assembly.volume();
  return {.lower = energy > 0 ? pressure * pressure * volume / energy : 0, .upper = stiffness / (9 * volume)};
}

} // namespace granum::packing

// SPDX-License-Identifier: GPL-3.0-or-later
#include <granum/analysis/counted_part.hpp>

#include <vector>

namespace granum::analysis {

packing::Assembly counted_part(const packing::Assembly& assembly, const contact::NormalLaw& law) {
  packing::Assembly counted = assembly;
  if (law.constant_exponent())
    return counted;
  double mean = 0;
  for (const packing::Contact& c : assembly.contacts)
    mean += c.normal_force / static_cast<double>(assembly.contacts.size());
  if (!(mean > 0))
    return counted;
  constexpr double hardly = 0.05;
  const double least = hardly * law.stiffness_at_force(mean);
  std::erase_if(counted.contacts, [&](const packing::Contact& c) {
    return !(c.normal_force > 0 && law.stiffness_at_force(c.normal_force) >= least);
  });
  return counted;
}

} // namespace granum::analysis

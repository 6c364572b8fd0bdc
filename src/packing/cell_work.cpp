// SPDX-License-Identifier: GPL-3.0-or-later
#include <granum/packing/cell_work.hpp>

#include <algorithm>

namespace granum::packing {

namespace {

double elastic_energy(const Assembly& assembly, const contact::PowerLaw& law, double strain) {
  double sum = 0;
  for (const Contact& c : assembly.contacts)
    sum += law.energy(std::max(0.0, c.overlap - strain * norm(c.branch)));
  for (const Contact& c : assembly.wall_contacts)
    sum += law.energy(std::max(0.0, 2 * (c.overlap - strain * norm(c.branch)))) / 2;
  return sum;
}

} // namespace

double pressure_by_cell_work(const Assembly& assembly, const contact::PowerLaw& law) {
  require_valid(assembly);
  double overlap = 0, length = 0;
  for (const auto* contacts : {&assembly.contacts, &assembly.wall_contacts})
    for (const Contact& c : *contacts) {
      overlap += c.overlap;
      length += norm(c.branch);
    }
  if (!(overlap > 0))
    return 0;
  const double strain = 1e-4 * overlap / length;
  const double released = elastic_energy(assembly, law, -strain) - elastic_energy(assembly, law, strain);
  return released / (2 * strain * 3 * assembly.volume());
}

} // namespace granum::packing

// SPDX-License-Identifier: GPL-3.0-or-later
#include <granum/packing/density.hpp>

#include <numbers>

#include <granum/core/error.hpp>

namespace granum::packing {

double solid_fraction(const Assembly& assembly) {
  require_valid(assembly);
  double cubes = 0;
  for (const double radius : assembly.radius)
    cubes += radius * radius * radius;
  return 4 * std::numbers::pi / 3 * cubes / assembly.volume();
}

double void_ratio(const Assembly& assembly) {
  const double solid = solid_fraction(assembly);
  if (assembly.grain_count() == 0)
    throw InvalidArgument("void_ratio: the assembly has no grains");
  return 1 / solid - 1;
}

} // namespace granum::packing

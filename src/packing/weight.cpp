// SPDX-License-Identifier: GPL-3.0-or-later
#include <granum/packing/weight.hpp>

#include <numbers>
#include <vector>

#include <granum/packing/stress.hpp>

namespace granum::packing {

Weight common_weight(const Assembly& assembly) {
  const std::vector<Residual> left = residuals(assembly);
  std::vector<bool> touches(assembly.grain_count());
  for (const Contact& c : assembly.contacts)
    touches[c.i] = touches[c.j] = true;
  for (const Contact& c : assembly.wall_contacts)
    touches[c.i] = true;
  const auto volume = [&](std::size_t g) {
    const double radius = assembly.radius[g];
    return 4 * std::numbers::pi / 3 * radius * radius * radius;
  };
  Vec3 force{};
  double squares = 0;
  for (std::size_t g = 0; g < left.size(); ++g)
    if (touches[g]) {
      force += volume(g) * left[g].force;
      squares += volume(g) * volume(g);
    }
  if (!(squares > 0))
    return {};
  Weight weight{.per_volume = (-1 / squares) * force};
  double with = 0, without = 0;
  for (std::size_t g = 0; g < left.size(); ++g)
    if (touches[g]) {
      with += norm(left[g].force);
      without += norm(left[g].force + volume(g) * weight.per_volume);
    }
  if (with > 0)
    weight.left_over = without / with;
  return weight;
}

} // namespace granum::packing

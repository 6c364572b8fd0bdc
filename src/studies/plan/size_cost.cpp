// SPDX-License-Identifier: GPL-3.0-or-later
#include "studies/plan/size_cost.hpp"

#include <granum/core/number.hpp>
#include <granum/triaxial/specimen.hpp>

namespace granum::studies {

std::string cost_of_sizes(const Scene& scene) {
  constexpr double widest_without_note = 5, rounding = 1e-9;
  const sizes::Distribution& sizes = scene.grain.sizes;
  if (sizes.size_ratio() <= widest_without_note * (1 + rounding))
    return {};
  return "grain.sizes span 1:" + short_text(sizes.size_ratio(), 2) +
         ": a step costs about as much as with equal grains, but a packing takes 2 to 5 times as long to "
         "make; its cell, wider than four of the largest grains, needs " +
         std::to_string(triaxial::least_grains(sizes)) +
         " grains or more; and many of the small ones carry no load";
}

} // namespace granum::studies

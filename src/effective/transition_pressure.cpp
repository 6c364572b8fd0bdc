// SPDX-License-Identifier: GPL-3.0-or-later
#include <granum/effective/transition_pressure.hpp>

#include "checked_state.hpp"

namespace granum::effective {

std::optional<double> transition_pressure(const State& state) {
  const auto geometry = kernel::checked_geometry(state);
  kernel::require_contacts(state);
  const contact::RoughSphere* const law = state.law.rough_sphere();
  if (law == nullptr)
    return std::nullopt;
  return law->transition_force() / (3 * geometry.force_area);
}

} // namespace granum::effective

// SPDX-License-Identifier: GPL-3.0-or-later
// Private to src/network.
#pragma once

#include <granum/elastic/stiffness.hpp>

#include "backbone.hpp"
#include "lanes.hpp"

namespace granum::network {

/// The two parts of ForceTerms, dimensionless.
struct ForceEnergies {
  elastic::Matrix6 geometric = elastic::Matrix6::Zero();
  elastic::Matrix6 shedding = elastic::Matrix6::Zero();
};

/// Contribution of the contact forces to the energies of the motions q under unit uniform strains.
template <int Dof>
[[nodiscard]] ForceEnergies force_energies(const Backbone& backbone, const Field<Dof>& q);

} // namespace granum::network

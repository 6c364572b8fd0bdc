// SPDX-License-Identifier: GPL-3.0-or-later
// Private to src/network.
#pragma once

#include <granum/network/linear_response.hpp>
#include <granum/packing/assembly.hpp>

#include "factor_rule.hpp"
#include "incomplete_factor.hpp"
#include "network/backbone.hpp"
#include "network/workers.hpp"

namespace granum::network {

/// Incomplete factor of a rule with uses_motions, made after a numbering that loses few pivots. Dropped terms
/// falsify the stiffness of soft motions, and their pivots spoil later ones. A factor with little fill finds
/// the grains of very soft motions; numbered first, as weakly supported ones, their elimination drops
/// nothing. Then the grains of pivots that the factor itself loses are numbered first as well, a few times.
/// If it still loses many, the rule is changed to SoftPivots::coupled.
/// \param    options    a stop request ends the search; the last factor is returned
/// \param    backbone   of the assembly and the options; numbered anew
template <int Dof>
[[nodiscard]] IncompleteFactor<Dof> factor_with_soft_first(const packing::Assembly& assembly,
                                                           const ResponseOptions& options, FactorRule rule,
                                                           const Workers& workers, Backbone& backbone);

} // namespace granum::network

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

/// The incomplete factor of a rule that judges pivots, and before it a numbering in which it loses none, as
/// far as a few tries go. A motion of a few grains that hardly anything resists comes out wrong when terms
/// are dropped from its grains, and what its pivot passes on spoils those behind it. So a factor with little
/// fill shows the grains of very soft motions, and these count as barely held: eliminated first, they lose
/// nothing. Then the factor itself shows those of pivots that it still loses. Where it goes on to lose many,
/// soft pivots are coupled as their motions say.
/// \param    options    stop_requested is asked after a factor that is not good enough; then it is the answer
/// \param    backbone   of the assembly and the options; numbered anew
template <int Dof>
[[nodiscard]] IncompleteFactor<Dof> factor_with_soft_first(const packing::Assembly& assembly,
                                                           const ResponseOptions& options, FactorRule rule,
                                                           const Workers& workers, Backbone& backbone);

} // namespace granum::network

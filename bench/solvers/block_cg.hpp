// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "system.hpp"

namespace granum::bench {

struct Solved {
  Motions motions;     ///< q
  int iterations = 0;  ///< of all load cases together, or the sum where they are solved one by one
  double residual = 0; ///< worst load case over its load, recomputed at the end
};

/// H q = -load for all load cases in one Krylov space, as src/network/block_cg.cpp does it, with any
/// preconditioner. Ends at the tolerance, at the limit, or where the preconditioner is not positive definite.
[[nodiscard]] Solved block_cg(const network::Backbone& backbone, const Motions& load,
                              const Preconditioner& precondition, double tolerance, int iteration_limit);

/// Worst load case of |load + H q| over |load|.
[[nodiscard]] double residual_of(const network::Backbone& backbone, const Motions& load, const Motions& q);

} // namespace granum::bench

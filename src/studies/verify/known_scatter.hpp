// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace granum::studies {

/// What is known beforehand of the scatter between specimens of one kind.
struct KnownScatter {
  double deviation = 0; ///< standard deviation of one specimen
  double degrees = 0;   ///< of freedom that it was measured with; 0: nothing is known
};

} // namespace granum::studies

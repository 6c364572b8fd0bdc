// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace granum {

/// A measured, fitted or estimated number and its standard error, in the unit of the number.
struct Measured {
  double value = 0;
  double standard_error = 0; ///< >= 0; 0 for an exact number
};

} // namespace granum

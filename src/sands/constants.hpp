// SPDX-License-Identifier: GPL-3.0-or-later
// Units and references that laws of sands share.
#pragma once

namespace granum::sands {

inline constexpr double kPa = 1e3, MPa = 1e6, mm = 1e-3;
inline constexpr double reference_stress = 100 * kPa;        ///< p_a of most laws [Pa]
inline constexpr double standard_atmosphere = 101.325 * kPa; ///< unit atm of other laws [Pa]

} // namespace granum::sands

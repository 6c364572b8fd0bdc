// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace granum::hardin {

/// Void-ratio functions f(e) of Eq. (1) that are in use. None depends on units.
enum class VoidRatioFunction {
  hardin_richart_round,   ///< (2.17-e)^2/(1+e), rounded grains; the paper's choice  [HardinRichart1963]
  hardin_richart_angular, ///< (2.97-e)^2/(1+e), angular grains                      [HardinRichart1963]
  power_1_3,              ///< e^-1.3                                                [Jamiolkowski1991]
  hardin_blandford,       ///< 1/(0.3+0.7 e^2)                           [Hardin1978; HardinBlandford1989]
  none,                   ///< 1
};

/// f(e).
/// \param    void_ratio  e > 0 [1]; the Hardin-Richart forms also need e below 2.17 and 2.97, where
///                       they reach zero
/// \throws   InvalidArgument outside that range
/// Accuracy  4 ulp.  Checked by tests/hardin/test_void_ratio_function.cpp
[[nodiscard]] double void_ratio_value(VoidRatioFunction function, double void_ratio);

/// The names that programs accept: hardin-richart-round, hardin-richart-angular, power-1.3,
/// hardin-blandford, none.
[[nodiscard]] std::string_view name(VoidRatioFunction function);
/// \throws   InvalidArgument for an unknown name; the text lists the known ones.
[[nodiscard]] VoidRatioFunction void_ratio_function(std::string_view name);
[[nodiscard]] std::vector<VoidRatioFunction> all_void_ratio_functions();

} // namespace granum::hardin

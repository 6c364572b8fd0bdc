// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>

#include <granum/effective/state.hpp>

namespace granum::effective {

/// Mean stress p* at which X = u0 k_H/f is 1 at the mean force of rough spheres: below it roughness decides
/// how stiff contacts are, above it Hertz' law. Of equal spheres
/// sqrt(3)/(4 pi) C_n/(1+e) G/(1-nu) (u0/R)^(3/2),
/// Goddard's scaling with its constant.                                                        [Goddard1990]
/// Assumes   C_n and e of the state stay; its stresses are not read.
/// \return   p* [Pa]; nothing where the law is another
/// \throws   InvalidArgument as require_valid(State), and if C_n = 0
/// Accuracy  relative 1e-14.  Checked by tests/effective/test_transition_pressure.cpp
[[nodiscard]] std::optional<double> transition_pressure(const State& state);

} // namespace granum::effective

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <vector>

#include <granum/core/numerics.hpp>
#include <granum/hardin/fit.hpp>

namespace granum::studies {

/// s of one specimen's path: G ~ p^s by Levenberg-Marquardt on G itself, as in the paper.
/// \return   empty with fewer than three states, or if the fit does not converge
/// \throws   InvalidArgument if a modulus or a stress is not positive
[[nodiscard]] std::optional<Measured>
fitted_exponent(const std::vector<hardin::MeasuredModulus>& states,
                hardin::VoidRatioFunction function = hardin::VoidRatioFunction::none);

} // namespace granum::studies

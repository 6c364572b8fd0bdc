// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <string>

#include <granum/hardin/fit.hpp>

/// How a modulus grows over the states of one packing.
/// Checked by tests/studies/test_frame_series.cpp
namespace granum::studies {

/// G ~ p^s over a series of states, and Eq. (1) where the stress ratio varies as well.
struct SeriesFit {
  std::size_t states = 0;
  std::optional<hardin::Fit> sum;                 ///< C and s
  std::optional<hardin::Fit> sum_with_void_ratio; ///< the same with f(e) = (2.17-e)^2/(1+e)
  std::optional<hardin::Fit> separate;            ///< C, m and n; if the stress ratio varies
  std::string separate_remark = {};               ///< why m and n are not there
  std::string remark;                             ///< why there is no fit; empty if there is one
};

/// Fits by least squares of ln G.
/// \param    states   G_ij, stresses and void ratio; a fit needs 3, and stresses that vary by a tenth
/// \param    atmospheric_pressure   p_a > 0 of C [Pa]
/// \return   without a fit, and with a remark, for states that cannot be fitted
/// \throws   InvalidArgument if the atmospheric pressure is not positive
/// Accuracy  as hardin::fit.
[[nodiscard]] SeriesFit fit_series(std::span<const hardin::MeasuredModulus> states,
                                   double atmospheric_pressure = 100e3);

} // namespace granum::studies

// SPDX-License-Identifier: GPL-3.0-or-later
// Computation of all ranges of an answer.
#pragma once

#include <span>
#include <string_view>

#include <granum/estimate/answer.hpp>

namespace granum::estimate {

/// The effect of an input on all numbers: the smallest and the largest of the values on its two sides and in
/// the middle.
Effect effect_of(std::string input, bool assumed, const Values& middle, const Values& a, const Values& b);

/// The range of a number: the effects of all inputs in quadrature, except those of one name. Never NaN, and
/// low <= value <= high. It is limited to possible values; a Poisson's ratio of an anisotropic packing may
/// exceed 0.5, then up to the largest effect of a single input.
/// Assumes   finite values and effects
Range range_of(const FieldRow& row, const Values& middle, std::span<const Effect> effects,
               std::string_view without = {});

/// Shares of the inputs in the range of a number, largest first, without shares of zero.
std::vector<Share> shares_of(Field field, std::span<const Effect> effects);

} // namespace granum::estimate

// SPDX-License-Identifier: GPL-3.0-or-later
// Ranges of an answer: the one place that makes them.
#pragma once

#include <span>
#include <string_view>

#include <granum/estimate/answer.hpp>

namespace granum::estimate {

/// An input's effect on all numbers: what it makes of them to its two sides, and the middle if both are on
/// one side of it.
Effect effect_of(std::string input, bool assumed, const Values& middle, const Values& a, const Values& b);

/// The range of a number: what the inputs make of it in quadrature, without those of one name. Never NaN,
/// and low <= value <= high. It ends where no packing has less or more; a Poisson's ratio of an anisotropic
/// packing may exceed 0.5, then as far as one input alone takes it.
/// Assumes   finite values and effects
Range range_of(const FieldRow& row, const Values& middle, std::span<const Effect> effects,
               std::string_view without = {});

/// Shares of the inputs in the range of a number, largest first, without those of nothing.
std::vector<Share> shares_of(Field field, std::span<const Effect> effects);

} // namespace granum::estimate

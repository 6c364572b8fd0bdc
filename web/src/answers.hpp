// SPDX-License-Identifier: GPL-3.0-or-later
// What the answers of beads and of sands have in common.
#pragma once

#include <optional>

#include <granum/core/numerics.hpp>
#include <granum/estimate/answer.hpp>
#include <granum/estimate/input_values.hpp>
#include <granum/inverse/quantity.hpp>

namespace granum::web {

/// A number that does not exist.
inline constexpr double nothing = effective::State::unset;

/// Value, low and high; three NaN for none.
void add(const std::optional<estimate::Range>& range);
/// Value and standard error.
void add(const Measured& number);
/// Every row of estimate::fields(), as value, low and high; then the shares of the range of G. The words are
/// the names of the shares, then the notes.
void add(const estimate::Answer& answer);
/// The same of what is known of a packing: values that are not given are assumed, with their deviations.
void add_answer(const estimate::InputValues& known);
/// Gives an input its number, unless that is NaN.
void give(estimate::InputValues& values, estimate::Input input, double number);
/// \param    place   index in inverse::quantities()
/// \throws   InvalidArgument
[[nodiscard]] inverse::Quantity quantity_of(double place);
/// The k-th of a number of pressures from low to high, in equal steps of the logarithm [Pa].
[[nodiscard]] double step_of_pressure(double low, double high, double k, double points);

} // namespace granum::web

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>
#include <vector>

#include <granum/estimate/input_values.hpp>
#include <granum/inverse/inference.hpp>

/// Uncertain inputs that all measurements of a packing have in common: its material, size and density,
/// but neither stresses nor contacts.
namespace granum::inverse {

/// The rows that all measurements share and that the packing depends on.
[[nodiscard]] std::vector<const estimate::InputRow*> shared_rows(const estimate::InputValues& completed);

/// The shared ones of uncertain inputs, as an inference takes them. Changes of positive numbers keep their
/// sign; all are changed together, because two may belong to the same contact law.
/// \param    uncertain   of uncertain_inputs(completed, ...)
/// Checked by tests/inverse/test_inference.cpp
[[nodiscard]] SharedInputs shared_inputs(const estimate::InputValues& completed,
                                         std::span<const estimate::UncertainInput> uncertain);

} // namespace granum::inverse

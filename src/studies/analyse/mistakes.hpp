// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "studies/analyse/measured_frame.hpp"

namespace granum::studies {

/// Adds a sentence for each plausible mistake that a frame shows, with its likely cause: a void ratio that no
/// packing has, radii that are diameters, contacts that are all open, rows of contacts that are missing,
/// lengths in other units than assumed, grains softer or harder than any material.
/// Checked by tests/studies/test_mistakes.cpp
void judge_mistakes(const io::ImportedPacking& packing, const MeasuredFrame& frame,
                    std::vector<std::string>& out);

/// "12.5 %": a share to three digits, in sentences on a frame.
[[nodiscard]] std::string percent(double share);

} // namespace granum::studies

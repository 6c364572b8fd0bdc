// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "studies/analyse/measured_frame.hpp"

namespace granum::studies {

/// Adds warnings about anything that invalidates comparisons with a measured frame.
void add_warnings(const io::ImportedPacking& packing, MeasuredFrame& frame);

/// Warnings about a fabric that the closed forms do not describe.
void judge_fabric(const analysis::Fabric& fabric, std::vector<std::string>& out);

/// Unbalanced force on a grain due to few digits alone, over the mean force: digits of the forces, and of the
/// directions.
[[nodiscard]] double unbalance_by_rounding(const io::ImportedPacking& packing);

} // namespace granum::studies

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "studies/analyse/measured_frame.hpp"

namespace granum::studies {

/// Adds to a measured frame what ruins comparisons with it.
void add_warnings(const io::ImportedPacking& packing, MeasuredFrame& frame);

/// What a fabric says against the closed forms.
void judge_fabric(const analysis::Fabric& fabric, std::vector<std::string>& out);

/// What digits alone may leave on a grain of some contacts, over the mean force: their own, and those of the
/// directions.
[[nodiscard]] double unbalance_by_rounding(const io::ImportedPacking& packing);

} // namespace granum::studies

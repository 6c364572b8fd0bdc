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

} // namespace granum::studies

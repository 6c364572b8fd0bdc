// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <granum/verify/analysis.hpp>

namespace granum::verify {

/// Adds to an analysis what ruins comparisons with it.
void add_warnings(const io::ImportedPacking& packing, Analysis& analysis);

} // namespace granum::verify

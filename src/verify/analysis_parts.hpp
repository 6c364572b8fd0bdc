// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <granum/verify/analysis.hpp>

namespace granum::verify {

/// Forces of an assembly, those of its contacts that press.
[[nodiscard]] ForceAnalysis analyse_forces(const Assembly& assembly, bool tangential_known,
                                           const AnalysisOptions& options);

/// Adds to an analysis what ruins comparisons with it.
void add_warnings(const io::ImportedPacking& packing, Analysis& analysis);

/// What a fabric says against the closed forms.
void judge_fabric(const FabricAnalysis& fabric, std::vector<std::string>& out);

} // namespace granum::verify

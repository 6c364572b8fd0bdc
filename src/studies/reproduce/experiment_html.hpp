// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "studies/reproduce/experiment_figures.hpp"
#include "studies/verify/findings.hpp"

namespace granum::studies {

/// Facts about a run that are not part of its results.
struct RunTime {
  double seconds = 0;   ///< wall time [s]
  bool resumed = false; ///< of the last part alone
};

/// A report for people as one HTML page that needs nothing from outside: what was run, the verdicts, tables
/// 2, 4 and 5 and further exponents beside the paper's, the figures with their captions, how to read them,
/// and what is left out. Well-formed as XML as well.
/// Checked by tests/studies/test_experiment_html.cpp
[[nodiscard]] std::string experiment_html(const Experiment& experiment, const std::vector<Verdict>& verdicts,
                                          const std::vector<Figure>& figures,
                                          const std::optional<AssemblyPicture>& assembly,
                                          const RunTime& time);

} // namespace granum::studies

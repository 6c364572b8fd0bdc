// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "studies/report/compression.hpp"
#include "studies/reproduce/figures/experiment_figures.hpp"
#include "studies/verify/findings.hpp"

namespace granum::studies {

/// Facts about a run that are not part of its results.
struct RunTime {
  double seconds = 0;   ///< wall time [s]
  bool resumed = false; ///< of the last part alone
};

[[nodiscard]] std::size_t frozen_states(const Experiment& experiment);

/// Isotropic compression of the first specimen of each kind; s of G_hv as in Table 5.
[[nodiscard]] std::vector<Compression> compressions(const Experiment& experiment);

/// The folder of the figures' files, beside the report.
inline constexpr const char* figures_folder = "figures";

/// A report for people.
struct ExperimentReport {
  std::string html;
  std::vector<Panel> panels; ///< of its first pictures, which experiment_figures does not have
};

/// One self-contained HTML page: first s and its explanation, then agreements with and differences from the
/// paper. Folded: tables 2, 4 and 5 and further exponents beside the paper's, the figures with captions, the
/// run, how to read the page, and omissions.
/// Checked by tests/studies/test_experiment_html.cpp
[[nodiscard]] ExperimentReport experiment_report(const Experiment& experiment,
                                                 const std::vector<Verdict>& verdicts,
                                                 const std::vector<Figure>& figures,
                                                 const std::optional<AssemblyPicture>& assembly,
                                                 const RunTime& time);

} // namespace granum::studies

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "studies/reproduce/experiment_findings.hpp"

#include "cli/document/document.hpp"
#include "cli/verify/compression.hpp"
#include "figures.hpp"

/// What `granum reproduce` found, as a document and files.
/// Checked by tests/cli/test_reproduce_document.cpp
namespace granum::cli {

/// Facts about a run that are not part of its results.
struct RunTime {
  double seconds = 0;   ///< wall time [s]
  bool resumed = false; ///< of the last part alone
};

using Files = std::vector<std::pair<std::string, std::string>>; ///< names and texts

/// A document with what belongs beside its page.
struct ExperimentDocument {
  Document document;
  Files files;
  std::vector<Panel> panels; ///< of its pictures
};

/// First s and its explanation, then tables 2, 4 and 5 and further exponents beside the paper's, agreements
/// and differences; folded on the page: figures with captions; for it alone what was run and omissions.
[[nodiscard]] ExperimentDocument experiment_document(const Experiment& experiment,
                                                     const std::vector<studies::Verdict>& verdicts,
                                                     const RunTime& time);

/// Ours, its standard error, the printed number, the difference, the reach, and whether ours is within it.
[[nodiscard]] Table table_of_cells(std::string key, std::string title,
                                   const std::vector<studies::Cell>& cells);

/// Isotropic compression of the first specimen of each kind; s of G_hv as in Table 5.
[[nodiscard]] std::vector<Compression> compressions(const Experiment& experiment);

} // namespace granum::cli

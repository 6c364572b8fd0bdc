// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "studies/reproduce/experiment_findings.hpp"

/// The numbers of an experiment as CSV and as text for people. Units in the headings.
/// Checked by tests/studies/test_experiment_findings.cpp
namespace granum::studies {

/// Every frozen state, a row each; columns of probes are empty where none was run.
[[nodiscard]] std::string frozen_states_csv(const Experiment& experiment);
/// Stress and strain along the paths, finer than the frozen states.
[[nodiscard]] std::string curves_csv(const Experiment& experiment);
/// Cycles of shear with friction.
[[nodiscard]] std::string loops_csv(const Experiment& experiment);
/// Contacts of every frozen state by direction and by force: contact, density, seed, path, eta, bin, count.
[[nodiscard]] std::string histograms_csv(const Experiment& experiment);
/// One cell of a table a row: ours, its standard error, the printed number, the difference, the reach.
[[nodiscard]] std::string table_csv(const std::vector<TableRow>& rows);
[[nodiscard]] std::string verdicts_csv(const std::vector<Verdict>& verdicts);

/// A table as text: ours +- standard error, in brackets the printed number; a mark where it is out of reach.
[[nodiscard]] std::string table_text(const std::string& title, const std::vector<TableRow>& rows);

} // namespace granum::studies

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "studies/reproduce/experiment_findings.hpp"
#include <granum/io/csv/columns.hpp>

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
/// A cell of a table with where it is from, as CSV, JSON, screen and page have it.
struct CellRow {
  const TableRow* row;
  const Cell* cell;
};
[[nodiscard]] std::vector<CellRow> cell_rows(const std::vector<TableRow>& rows);
/// Ours, its standard error, the printed number, the difference, the reach, and whether ours is within it.
[[nodiscard]] const io::Columns<CellRow>& cell_columns();
[[nodiscard]] std::string table_csv(const std::vector<TableRow>& rows);
[[nodiscard]] std::string table_text(const std::string& title, const std::vector<TableRow>& rows);

} // namespace granum::studies

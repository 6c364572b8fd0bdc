// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "studies/trade/trade_findings.hpp"

#include "cli/document/document.hpp"
#include "cli/options/study_options.hpp"

namespace granum::cli {

/// A finished or stopped study of speed against accuracy.
struct TradeOutcome {
  studies::TradeScene trade;
  std::vector<studies::TradeSample> samples;
  std::vector<studies::TradeRow> rows;
  std::string failures = {}; ///< empty if no sample failed
  double seconds = 0;
};

/// The rows as CSV and picture: error of G against cost, one curve for each varied quantity and density.
[[nodiscard]] Document rows_document(const std::vector<studies::TradeRow>& rows);
/// Every specimen behind them, as CSV.
[[nodiscard]] Document samples_document(const TradeOutcome& outcome);
/// Screen and JSON: a table for each varied quantity, and the power laws through the rows.
[[nodiscard]] Document trade_document(const TradeOutcome& outcome, const StudyOptions& options);

/// The rows, read from the CSV of rows_document.
/// \throws   FileError if it cannot be read or contains data not written by trade
[[nodiscard]] std::vector<studies::TradeRow> read_trade_rows(const std::filesystem::path& csv);

} // namespace granum::cli

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "studies/trade/trade_findings.hpp"
#include <nlohmann/json.hpp>

namespace granum::cli {

/// One block for each varied quantity, with the values of the others and the reference.
[[nodiscard]] std::string trade_table(const studies::TradeScene& trade,
                                      const std::vector<studies::TradeRow>& rows);

/// The power laws through the rows, and the limiting error of one specimen at the defaults of the study.
[[nodiscard]] std::string laws_table(const studies::TradeScene& trade, const studies::TradeLaws& laws);

/// The rows of the table, and every specimen behind them.
[[nodiscard]] std::string trade_csv(const std::vector<studies::TradeRow>& rows);
[[nodiscard]] std::string samples_csv(const studies::TradeScene& trade,
                                      const std::vector<studies::TradeSample>& samples);

/// The rows, read from a file of trade_csv.
/// \throws   FileError if it cannot be read or contains data not written by trade
[[nodiscard]] std::vector<studies::TradeRow> read_trade_rows(const std::filesystem::path& csv);

/// Error of G against cost, one curve for each varied quantity and density, as SVG.
[[nodiscard]] std::string trade_picture(const std::vector<studies::TradeRow>& rows);

[[nodiscard]] nlohmann::ordered_json json_of(const studies::TradeScene& trade);
[[nodiscard]] nlohmann::ordered_json json_of(const std::vector<studies::TradeRow>& rows);
[[nodiscard]] nlohmann::ordered_json json_of(const studies::TradeLaws& laws);

} // namespace granum::cli

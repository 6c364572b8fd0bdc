// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include <granum/verify/trade_findings.hpp>
#include <granum/verify/trade_rule.hpp>
#include <nlohmann/json.hpp>

namespace granum::cli {

/// One block for each varied quantity: at which values of the others, against which reference.
[[nodiscard]] std::string trade_table(const verify::TradeScene& trade,
                                      const std::vector<verify::TradeRow>& rows);

/// The power laws through the rows, and what limits one specimen at the defaults of the study.
[[nodiscard]] std::string laws_table(const verify::TradeScene& trade, const verify::TradeLaws& laws);

/// The rows of the table, and every specimen behind them.
[[nodiscard]] std::string trade_csv(const std::vector<verify::TradeRow>& rows);
[[nodiscard]] std::string samples_csv(const verify::TradeScene& trade,
                                      const std::vector<verify::TradeSample>& samples);

/// Error of G against cost, one curve for each varied quantity and density, as SVG.
[[nodiscard]] std::string trade_picture(const std::vector<verify::TradeRow>& rows);

[[nodiscard]] nlohmann::ordered_json json_of(const verify::TradeScene& trade);
[[nodiscard]] nlohmann::ordered_json json_of(const std::vector<verify::TradeRow>& rows);
[[nodiscard]] nlohmann::ordered_json json_of(const verify::TradeLaws& laws);

} // namespace granum::cli

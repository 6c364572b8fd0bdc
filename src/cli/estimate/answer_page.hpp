// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include <granum/plot/chart.hpp>

#include "answer_report.hpp"

namespace granum::cli {

/// The report of granum estimate as a page: the answer in words and its picture, every number with its range,
/// the assumptions with the keys of their sources, warnings, and the output of the terminal.
[[nodiscard]] std::string answer_page(const AnswerCase& answer, const plot::Chart& picture,
                                      const std::string& table, const Validity& validity);

} // namespace granum::cli

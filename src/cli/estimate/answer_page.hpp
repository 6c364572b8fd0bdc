// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include <granum/plot/chart.hpp>

#include "answer_report.hpp"

namespace granum::cli {

/// The report of granum estimate as a page for people: the answer in words and its picture, every number with
/// its range, what was assumed with the keys of its sources, warnings, and what the terminal shows.
[[nodiscard]] std::string answer_page(const AnswerCase& answer, const plot::Chart& picture,
                                      const std::string& table, const Validity& validity);

} // namespace granum::cli

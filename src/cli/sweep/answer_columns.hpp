// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>
#include <vector>

#include <granum/effective/answer.hpp>
#include <granum/io/csv/table.hpp>

/// The best answer as columns of a table: each number with the ends of its range.
namespace granum::cli {

/// Headings: G_answer_MPa, G_low_MPa, G_high_MPa and so on.
/// \param    all   moduli and speeds of other directions, K, E, nu, density and rattlers as well
[[nodiscard]] std::vector<std::string> answer_headings(bool all);

/// The cells below them; empty without an answer.
void append_answer_cells(std::vector<io::CsvCell>& row, const std::optional<effective::PackingAnswer>& answer,
                         bool all);

} // namespace granum::cli

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "studies/verify/findings.hpp"
#include "studies/verify/local_exponents.hpp"
#include "studies/verify/study.hpp"
#include <granum/io/csv/columns.hpp>

namespace granum::studies {

/// The columns of states, exponents and verdicts, from which CSV, JSON, screen and page are written.
[[nodiscard]] io::Columns<CompressedState> state_columns();
[[nodiscard]] io::Columns<ExponentRow> exponent_columns();
[[nodiscard]] io::Columns<Verdict> verdict_columns();

/// All states, a row each; units in the headings. Columns of probes are empty where none was run.
[[nodiscard]] std::string states_csv(const Scene& scene, const std::vector<SpecimenResult>& specimens);
/// The exponents by every route with their standard errors.
[[nodiscard]] std::string exponents_csv(const std::vector<ExponentRow>& rows);
/// The local ones.
[[nodiscard]] std::string local_exponents_csv(const std::vector<LocalExponents>& rows);

/// For people: the states of each specimen, then the exponents, then the verdicts.
[[nodiscard]] std::string states_table(const std::vector<SpecimenResult>& specimens);
[[nodiscard]] std::string exponents_table(const std::vector<ExponentRow>& rows);
/// Empty where there are no rows.
[[nodiscard]] std::string local_exponents_table(const std::vector<LocalExponents>& rows);
[[nodiscard]] std::string verdicts_table(const std::vector<Verdict>& verdicts);

} // namespace granum::studies

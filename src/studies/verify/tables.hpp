// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "studies/verify/findings.hpp"
#include "studies/verify/local_exponents.hpp"
#include "studies/verify/study.hpp"
#include <granum/io/csv/columns.hpp>

namespace granum::studies {

/// The columns of states, exponents and verdicts, from which CSV, JSON, screen and page are written.
[[nodiscard]] io::Columns<CompressedState> state_columns();
[[nodiscard]] io::Columns<ExponentRow> exponent_columns();
[[nodiscard]] io::Columns<Verdict> verdict_columns();

} // namespace granum::studies

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <granum/estimate/ladder.hpp>

#include "answer_case.hpp"
#include "cli/document/document.hpp"

/// Sections on rungs at the contacts of an answer.
namespace granum::cli {

/// Uniform strain, uniform stress and the relaxed rung side by side, "uniform_strain", "uniform_stress" and
/// "relaxed", with their remarks as notes.
/// \param    seen   on which screens
/// \return   notes of all on their validity, each once
/// \throws   InvalidArgument as effective::answer
Validity add_closed_forms(Document& to, const AnswerCase& c, Seen seen);

/// The cheapest rung within a tolerance, "ladder"; its notes are warnings.
void add_ladder(Document& to, const estimate::Ladder& ladder);

} // namespace granum::cli

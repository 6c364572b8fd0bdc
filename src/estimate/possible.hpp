// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>

#include <granum/estimate/answer.hpp>

namespace granum::estimate {

/// What a question must have for its formulas to exist, also if a standard deviation has changed it.
/// \throws   InvalidArgument
void require_possible(const Question& question);

/// A note where no soil is strong enough for the stresses: outside of K_0 0.13 to 7.5.
void note_strength(const Question& question, Validity& validity);

/// As answer, for a question that a standard deviation may have taken beyond the limits of require_valid.
[[nodiscard]] Answer possible_answer(const Question& question, std::span<const Spread> spreads = {});

} // namespace granum::estimate

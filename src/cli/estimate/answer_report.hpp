// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include <granum/effective/answer.hpp>
#include <granum/hardin/measured_sands.hpp>
#include <nlohmann/json.hpp>

#include "answer_options.hpp"

/// The answer of granum estimate in words and in JSON.
namespace granum::cli {

/// What a law of measured sands says here; nothing where it has no value.
struct SandAnswer {
  const hardin::MeasuredLaw* law;
  std::optional<hardin::SandModulus> modulus;
};

struct AnswerCase {
  effective::PackingQuestion question;
  std::vector<Spread> spreads;
  effective::PackingAnswer answer;
  double uniformity = 0; ///< C_u of the measured laws [1]
  bool uniformity_assumed = false;
  std::vector<SandAnswer> sands;        ///< empty without stress
  std::vector<std::string> assumptions; ///< of shape, grains and fabric, with their spreads
};

/// Works out the answer, without what measured sands say and without assumptions.
/// \throws   InvalidArgument as effective::answer
[[nodiscard]] AnswerCase bare_answer(const PackingOptions& packing, const AnswerOptions& options,
                                     const std::vector<std::string>& uncertainties = {});
/// Works out the answer.
/// \throws   InvalidArgument as effective::answer
[[nodiscard]] AnswerCase solve_answer(const PackingOptions& packing, const AnswerOptions& options,
                                      const std::vector<std::string>& uncertainties);

/// The object "answer", SI.
[[nodiscard]] nlohmann::ordered_json answer_json(const AnswerCase& answer);
/// The array "measured_sands", SI.
[[nodiscard]] nlohmann::ordered_json sands_json(const AnswerCase& answer);
/// What makes the range of G, and how it narrows.
[[nodiscard]] std::string range_text(const AnswerCase& answer);
[[nodiscard]] std::string answer_table(const AnswerCase& answer);

} // namespace granum::cli

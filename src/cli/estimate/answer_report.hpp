// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include <granum/estimate/answer.hpp>
#include <granum/hardin/measured_sands.hpp>
#include <granum/io/csv/columns.hpp>
#include <nlohmann/json.hpp>

#include "answer_options.hpp"

/// The answer of granum estimate in words, in JSON and as columns of a table.
namespace granum::cli {

/// What a law of measured sands gives here; nothing where it has no value.
struct SandAnswer {
  const hardin::MeasuredLaw* law;
  std::optional<hardin::SandModulus> modulus;
};

struct AnswerCase {
  estimate::Question question;
  std::vector<estimate::UncertainInput> inputs;
  estimate::Answer answer;
  double uniformity = 0; ///< C_u of the measured laws [1]
  bool uniformity_assumed = false;
  std::vector<SandAnswer> sands = {};        ///< empty without stress
  std::vector<std::string> assumptions = {}; ///< of shape, grains and fabric, with their deviations
};

/// Works out the answer, without what measured sands give and without assumptions.
/// \throws   InvalidArgument as estimate::answer
[[nodiscard]] AnswerCase bare_answer(const PackingOptions& packing, const AnswerOptions& options,
                                     const std::vector<std::string>& uncertainties = {});
/// Works out the answer.
/// \throws   InvalidArgument as estimate::answer
[[nodiscard]] AnswerCase solve_answer(const PackingOptions& packing, const AnswerOptions& options,
                                      const std::vector<std::string>& uncertainties);

/// The object "answer", SI.
[[nodiscard]] nlohmann::ordered_json answer_json(const AnswerCase& answer);
/// The array "measured_sands", SI.
[[nodiscard]] nlohmann::ordered_json sands_json(const AnswerCase& answer);
/// Columns of a table, each number with the ends of its range.
/// \param    all   every number; else G, V_s, V_p, z* and s alone
[[nodiscard]] io::Columns<estimate::Answer> answer_columns(bool all);
/// A number in the unit of a screen, with the unit: "118 MPa".
[[nodiscard]] std::string field_text(const estimate::FieldRow& row, double value);
/// What makes the range of G, and how it narrows.
[[nodiscard]] std::string range_text(const AnswerCase& answer);
[[nodiscard]] std::string answer_table(const AnswerCase& answer);

} // namespace granum::cli

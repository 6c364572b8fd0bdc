// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include <granum/core/validity.hpp>
#include <granum/effective/rungs.hpp>
#include <nlohmann/json.hpp>

#include "answer_report.hpp"

/// What granum estimate works out, and how it is put into words.
namespace granum::cli {

/// The question: a state, and where its numbers come from.
struct EstimateCase {
  effective::RungInputs subject;
  nlohmann::ordered_json packing;       ///< contact, grains and packing, SI
  std::vector<std::string> assumptions; ///< what was not given, one sentence each
};

/// A closed form that granum estimate shows, and what it calls it.
struct ShownForm {
  const char* key;   ///< in the JSON
  const char* title; ///< in tables and remarks
  const effective::Rung* rung;
};
/// The two uniform fields side by side, and the relaxed one where z* is given.
[[nodiscard]] std::vector<ShownForm> shown_forms(const effective::RungInputs& packing);

struct ShownAnswer {
  ShownForm form;
  effective::RungAnswer answer;
};

struct EstimateAnswer {
  std::vector<ShownAnswer> forms;
  Validity validity; ///< notes of all, each once
};

/// The answer first, then the inputs, the rungs and measured sands.
[[nodiscard]] nlohmann::ordered_json estimate_json(const EstimateCase& question, const EstimateAnswer& rungs,
                                                   const AnswerCase& answer);
/// Contact, grains, packing and stress.
[[nodiscard]] std::string state_text(const EstimateCase& question);
/// Uniform strain, uniform stress and the relaxed rung side by side.
[[nodiscard]] std::string rungs_table(const EstimateCase& question, const EstimateAnswer& rungs);
/// A line for each, none twice: what the answer assumes, and what the rungs do.
[[nodiscard]] std::string notes_table(const std::vector<std::string>& of_answer,
                                      const std::vector<std::string>& of_rungs);

} // namespace granum::cli

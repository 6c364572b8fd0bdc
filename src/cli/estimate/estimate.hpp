// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include <granum/core/validity.hpp>
#include <granum/effective/rungs.hpp>
#include <nlohmann/json.hpp>

#include "answer_report.hpp"

/// The computations of granum estimate, and their presentation.
namespace granum::cli {

/// A closed form shown by granum estimate, and its name.
struct ShownForm {
  const char* key;   ///< in the JSON
  const char* title; ///< in tables and remarks
  const effective::Rung* rung;
  effective::RungAnswer answer;
};

/// The two uniform fields and the relaxed one side by side, at the contacts of the answer.
struct Bounds {
  std::vector<ShownForm> forms;
  std::vector<std::string> assumptions; ///< in addition to the assumptions of the answer
  Validity validity;                    ///< notes of all, each once
};

/// \throws   InvalidArgument as effective::answer
[[nodiscard]] Bounds bounds_of(const AnswerCase& answer);

/// The answer first, then the inputs, the rungs and measured sands.
/// \param    packing   contact, grains and packing, SI
[[nodiscard]] nlohmann::ordered_json estimate_json(const nlohmann::ordered_json& packing,
                                                   const Bounds& bounds, const AnswerCase& answer);
/// Contact, grains, packing and stress.
[[nodiscard]] std::string state_text(const nlohmann::ordered_json& packing, const AnswerCase& answer);
/// Uniform strain, uniform stress and the relaxed rung side by side.
[[nodiscard]] std::string bounds_table(const effective::State& state, const Bounds& bounds);

} // namespace granum::cli

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include <granum/core/validity.hpp>
#include <granum/effective/rungs.hpp>
#include <nlohmann/json.hpp>

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

[[nodiscard]] nlohmann::ordered_json estimate_json(const EstimateCase& question,
                                                   const EstimateAnswer& answer);
[[nodiscard]] std::string estimate_table(const EstimateCase& question, const EstimateAnswer& answer);

} // namespace granum::cli

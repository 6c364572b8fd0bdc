// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include <granum/effective/state.hpp>
#include <nlohmann/json.hpp>

#include "rungs.hpp"

/// What granum estimate works out, and how it is put into words.
namespace granum::cli {

/// The question: a state, and where its numbers come from.
struct EstimateCase {
  Packing subject;
  nlohmann::ordered_json packing;       ///< contact, grains and packing, SI
  std::vector<std::string> assumptions; ///< what was not given, one sentence each
};

struct EstimateAnswer {
  FieldAnswer uniform_strain;
  FieldAnswer uniform_stress;
  std::optional<FieldAnswer> relaxed; ///< where z* is given
  Validity validity;                  ///< notes of all, each once
};

[[nodiscard]] nlohmann::ordered_json estimate_json(const EstimateCase& question,
                                                   const EstimateAnswer& answer);
[[nodiscard]] std::string estimate_table(const EstimateCase& question, const EstimateAnswer& answer);

} // namespace granum::cli

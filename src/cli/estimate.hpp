// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>
#include <vector>

#include <granum/effective/exponents.hpp>
#include <granum/effective/state.hpp>
#include <granum/effective/uniform_field.hpp>
#include <nlohmann/json.hpp>

/// What granum estimate works out, and how it is put into words.
namespace granum::cli {

/// The question: a state, and where its numbers come from.
struct EstimateCase {
  effective::State state;
  nlohmann::ordered_json contact;       ///< shape and its parameters, SI
  std::vector<std::string> assumptions; ///< what was not given, one sentence each
};

/// Answer of one hypothesis.
struct FieldAnswer {
  elastic::TransverselyIsotropic stiffness;
  /// Of G_hv; nothing where it is zero by construction, whatever the stress.
  std::optional<effective::StressExponents> exponents;
};

struct EstimateAnswer {
  FieldAnswer uniform_strain;
  FieldAnswer uniform_stress;
  Validity validity; ///< notes of both, each once
};

/// Young's modulus of a stiffness [Pa]: 0 in the limit of vanishing shear stiffness, nothing if no stable
/// material has this stiffness.
enum class Loading { vertical, horizontal };
[[nodiscard]] std::optional<double> young_modulus(const elastic::TransverselyIsotropic& stiffness,
                                                  Loading loading);

[[nodiscard]] nlohmann::ordered_json estimate_json(const EstimateCase& question,
                                                   const EstimateAnswer& answer);
[[nodiscard]] std::string estimate_table(const EstimateCase& question, const EstimateAnswer& answer);

} // namespace granum::cli

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include <granum/core/validity.hpp>
#include <granum/effective/rungs.hpp>
#include <granum/estimate/ladder.hpp>
#include <granum/plot/chart.hpp>
#include <granum/rock_physics/sphere_packing.hpp>
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

// ---- --tolerance: the cheapest rung within the tolerance, as text

[[nodiscard]] nlohmann::ordered_json ladder_json(const estimate::Ladder& ladder);
[[nodiscard]] std::string ladder_table(const estimate::Ladder& ladder);

// ---- --cement: the packing of the answer with a small amount of cement in its pores

/// Result of a model of cemented grains, dry.
struct CementModel {
  const char* key;   ///< in the JSON
  const char* title; ///< on the screen
  rock_physics::IsotropicEstimate moduli;
  double shear_wave_speed = 0, compression_wave_speed = 0; ///< [m/s]; 0 without stiffness
};

struct CementAnswer {
  double share = 0;    ///< of the whole volume that is cement [1]
  double porosity = 0; ///< remaining porosity [1]
  double coordination_number = 0;
  std::vector<CementModel> models; ///< by location of the cement, from softest to stiffest
  Validity validity;
};

/// Cement of the same mineral as the grains, at three locations: in the pores away from contacts (soft sand,
/// friable), as a layer on the grain surfaces, or at the contacts. The coordination number is that of the
/// answer for spheres.
/// \param    share   of the whole volume that is cement, > 0 and less than the porosity [1]
/// \throws   InvalidArgument naming --cement out of its range, for wet pores, and as the models
[[nodiscard]] CementAnswer cement_answer(const AnswerCase& answer, double share);
[[nodiscard]] nlohmann::ordered_json cement_json(const CementAnswer& answer);
[[nodiscard]] std::string cement_table(const CementAnswer& answer);

// ---- --report

/// The report of granum estimate as a page: the answer in words and its picture, every number with its range,
/// the assumptions with the keys of their sources, warnings, and the output of the terminal.
[[nodiscard]] std::string answer_page(const AnswerCase& answer, const plot::Chart& picture,
                                      const std::string& table, const Validity& validity);

} // namespace granum::cli

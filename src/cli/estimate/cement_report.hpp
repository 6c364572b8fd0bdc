// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include <granum/core/validity.hpp>
#include <granum/rock_physics/sphere_packing.hpp>
#include <nlohmann/json.hpp>

#include "answer_report.hpp"

/// `granum estimate --cement`: the packing of the answer with a little of its pores cemented.
namespace granum::cli {

/// What a model of cemented grains says, dry.
struct CementModel {
  const char* key;   ///< in the JSON
  const char* title; ///< on the screen
  rock_physics::IsotropicEstimate moduli;
  double shear_wave_speed = 0, compression_wave_speed = 0; ///< [m/s]; 0 without stiffness
};

struct CementAnswer {
  double share = 0;    ///< of the whole volume that is cement [1]
  double porosity = 0; ///< that is left [1]
  double coordination_number = 0;
  std::vector<CementModel> models; ///< from the softest place of the cement to the stiffest
  Validity validity;
};

/// Cement of the grains' own mineral in the pores of the packing: among the grains as one more filling (soft
/// sand, friable), in a layer on their surfaces, or at their contacts. The contacts are those of the answer's
/// spheres.
/// \param    share   of the whole volume that is cement, > 0 and less than the porosity [1]
/// \throws   InvalidArgument naming --cement out of its range, for wet pores, and as the models
[[nodiscard]] CementAnswer cement_answer(const AnswerCase& answer, double share);
[[nodiscard]] nlohmann::ordered_json cement_json(const CementAnswer& answer);
[[nodiscard]] std::string cement_table(const CementAnswer& answer);

} // namespace granum::cli

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include <granum/core/validity.hpp>
#include <granum/rock_physics/sphere_packing.hpp>
#include <nlohmann/json.hpp>

#include "answer_report.hpp"

/// `granum estimate --cement`: the packing of the answer with a small amount of cement in its pores.
namespace granum::cli {

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

} // namespace granum::cli

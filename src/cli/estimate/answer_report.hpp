// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include <granum/estimate/answer.hpp>
#include <granum/io/csv/columns.hpp>
#include <granum/sands/measured_sands.hpp>
#include <nlohmann/json.hpp>

#include "cli/options/input_options.hpp"

/// The answer of granum estimate in words, in JSON and as columns of a table.
namespace granum::cli {

/// The value of a law measured on sands; empty if it has none here.
struct SandAnswer {
  const sands::MeasuredLaw* law;
  std::optional<sands::SandModulus> modulus;
};

struct AnswerCase {
  estimate::Question question;
  std::vector<estimate::UncertainInput> inputs;
  estimate::Answer answer;
  /// The answer for a sand, if the kind of grains is not given; `answer` is then that for spheres.
  std::optional<estimate::Answer> sand_answer = std::nullopt;
  double sand_grain_modulus = 0; ///< G_g of sand_answer, if there is one [Pa]
  double uniformity = 0;         ///< C_u of the measured laws [1]
  bool uniformity_assumed = false;
  std::vector<SandAnswer> sands = {};        ///< empty without stress
  std::vector<std::string> assumptions = {}; ///< of shape, grains and fabric, with their deviations
};

/// Adds the values of published laws.
void add_measured_laws(AnswerCase& answer);
/// Whether each of them was tested in this state, in the order of sands::measured_laws().
[[nodiscard]] std::vector<bool> laws_tested(const AnswerCase& answer);
/// The range from the lowest to the highest of some of them, or of all if none is named, with the geometric
/// mean of both ends as value. Empty without stress.
[[nodiscard]] std::optional<estimate::Range> range_of_laws(const AnswerCase& answer,
                                                           const std::vector<bool>& some);

/// Computes the answer, without laws measured on sands and without assumptions.
/// \throws   InvalidArgument as estimate::answer
[[nodiscard]] AnswerCase bare_answer(const InputValues& values,
                                     const std::vector<std::string>& uncertainties = {});
/// Computes the answer.
/// \throws   InvalidArgument as estimate::answer
[[nodiscard]] AnswerCase solve_answer(const InputValues& values,
                                      const std::vector<std::string>& uncertainties);

/// The object "answer", SI.
[[nodiscard]] nlohmann::ordered_json answer_json(const AnswerCase& answer);
/// The object "sand_answer", SI: the answer for a sand if the kind of grains is not given, else null.
[[nodiscard]] nlohmann::ordered_json sand_answer_json(const AnswerCase& answer);
/// The array "measured_sands", SI.
[[nodiscard]] nlohmann::ordered_json sands_json(const AnswerCase& answer);
/// The array "strain_laws": G/G0 at the given strain; empty without one.
[[nodiscard]] nlohmann::ordered_json strain_laws_json(const AnswerCase& answer);
/// The answer for a sand, if there is one.
[[nodiscard]] const estimate::Answer* answer_of_sand(const AnswerCase& answer);
/// "sand (measured laws)" or "beads (spheres of the model)".
[[nodiscard]] const char* title_of(estimate::GrainShape shape);
/// Published laws for comparison with an answer, and laws of strain.
[[nodiscard]] std::string sands_text(const AnswerCase& answer);
/// Columns of a table, each number with the ends of its range.
/// \param    before   prefix of the headings: "sand_" for the answer for a sand next to that for spheres
/// \param    all        every number; else only G, V_s, V_p, z* and s
/// \param    strained   besides these G, G/G0 and damping at a shear strain
[[nodiscard]] io::Columns<estimate::Answer> answer_columns(bool all, bool strained,
                                                           const std::string& before = "");
/// A number in the unit of a screen, with the unit: "118 MPa".
[[nodiscard]] std::string field_text(const estimate::FieldRow& row, double value);
/// The contributions to the range of G, and how to narrow it.
[[nodiscard]] std::string range_text(const AnswerCase& answer);
/// One row: state, grain_shape, all numbers of the answer, and those of the answer for a sand.
[[nodiscard]] std::string answer_csv(const AnswerCase& answer, const nlohmann::ordered_json& packing);
[[nodiscard]] std::string answer_table(const AnswerCase& answer);

} // namespace granum::cli

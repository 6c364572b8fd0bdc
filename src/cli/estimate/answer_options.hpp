// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include <granum/contact/minerals.hpp>
#include <granum/estimate/answer.hpp>
#include <granum/sands/known_sands.hpp>

#include "cli/options/packing_options.hpp"

/// Options of granum estimate besides the packing: preparation, grains and pores, the sand, and uncertain
/// inputs.
namespace granum::cli {

struct AnswerOptions {
  effective::Preparation preparation;
  const contact::Mineral* mineral = nullptr; ///< of the grains, if given by name
  const sands::KnownSand* sand = nullptr;    ///< if given by name
  Number relative_density = number_of(Input::relative_density);
  Number least_void_ratio = number_of(Input::least_void_ratio);
  Number largest_void_ratio = number_of(Input::largest_void_ratio);
  Number grain_density = number_of(Input::grain_density);
  Number saturation = number_of(Input::saturation);
  Number earth_pressure_at_rest = number_of(Input::k0); ///< sets sigma_h from sigma_v
  Number strain = number_of(Input::shear_strain);
  std::optional<estimate::GrainShape> grain_shape = {}; ///< as given
  bool usual_limits = false; ///< the void ratio follows from D_r and usual limits of sands
  bool ground = false;       ///< the question is about the ground, which is soil
};

void add_answer_options(Command& command, AnswerOptions& options);
/// --uncertainty, key=sd.
[[nodiscard]] OptionRow uncertainty_row(std::vector<std::string>& settings);

/// Sets the numbers that follow from mineral, sand and relative density, unless they are given.
/// \throws   InvalidArgument if a relative density lacks its limits, or the density is given twice
void apply_presets(PackingOptions& packing, AnswerOptions& options);

/// The kind of grains, as given or implied by the options: a name, a relative density, limits of the void
/// ratio, a sieve curve or C_u of a soil, a shear strain and the ground imply a sand; glass, steel, numbers
/// of contacts and their shape imply spheres; empty if neither is implied.
[[nodiscard]] std::optional<estimate::GrainShape> told_shape(const PackingOptions& packing,
                                                             const AnswerOptions& options);

/// The question of the options; for spheres, if they do not determine the kind of grains.
/// \throws   InvalidArgument as resolve_state
[[nodiscard]] estimate::Question question_of(const PackingOptions& packing, const AnswerOptions& options);

/// Known properties of a sand besides its state.
[[nodiscard]] sands::Sand sand_of(const PackingOptions& packing, const AnswerOptions& options);

/// The option of a number without its hyphens: the name of an uncertain input.
[[nodiscard]] std::string key_of(const Number& number);
/// All numbers that may be uncertain, in the order of the options.
[[nodiscard]] std::vector<Number*> movable(PackingOptions& packing, AnswerOptions& options);

/// The assumed deviations of numbers that are not given, and those stated by --uncertainty, in the order of
/// the options.
/// \param    settings   key=sd; sd with the unit of the key, or in per cent of its value
/// \throws   InvalidArgument for a key that is no input of this packing, is given twice, or has a bad
///           deviation
[[nodiscard]] std::vector<estimate::UncertainInput>
uncertain_inputs_of(const PackingOptions& packing, const AnswerOptions& options,
                    const std::vector<std::string>& settings);

/// "9 GPa": the deviation of an uncertain input, for people.
[[nodiscard]] std::string deviation_text(const PackingOptions& packing, const AnswerOptions& options,
                                         const estimate::UncertainInput& input);

} // namespace granum::cli

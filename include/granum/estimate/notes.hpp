// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <span>
#include <string>
#include <vector>

#include <granum/estimate/input_values.hpp>

/// What an answer rests on besides the values that were given.
namespace granum::estimate {

/// An assumed input with its value, or a sentence: `Note{.reason = "..."}`.
struct Note {
  std::string name = {};             ///< of the input at its door, "--radius"; empty for a sentence
  std::string value = {};            ///< for people: "500 um"
  std::optional<double> number = {}; ///< in SI
  double deviation = 0;              ///< one standard deviation of the number
  Dimension dimension = Dimension::dimensionless;
  std::string reason = {}; ///< of the value; or the sentence
  std::string source = {}; ///< entries of validation/references.bib

  /// "assumed --grain-shear-modulus 30 GPa +- 9 GPa, as the grains of ...".
  [[nodiscard]] std::string sentence() const;
  bool operator==(const Note&) const = default;
};
using Notes = std::vector<Note>;
inline void add_sentence(Notes& to, std::string sentence, std::string source = {}) {
  to.push_back({.reason = std::move(sentence), .source = std::move(source)});
}

/// What is assumed of shape, grains and fabric of spheres.
/// \param    state    of the packing
/// \param    inputs   of uncertain_inputs; the notes have the deviations of those that are assumed
[[nodiscard]] Notes assumed_of_spheres(const InputValues& completed, const effective::State& state,
                                       std::span<const UncertainInput> inputs = {});
/// The assumed density of the grains; empty if it is given.
[[nodiscard]] std::optional<Note> assumed_density(const InputValues& completed,
                                                  std::span<const UncertainInput> inputs = {});
/// All notes on an answer: what is assumed, the sources of mineral and sand, and the basis of an answer for a
/// sand.
/// \param    of_sand   whether there is an answer for a sand
/// Checked by tests/estimate/test_input_values.cpp
[[nodiscard]] Notes notes_of(const InputValues& completed, const Question& question,
                             std::span<const UncertainInput> inputs, bool of_sand);

} // namespace granum::estimate

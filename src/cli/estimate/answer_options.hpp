// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>
#include <vector>

#include <granum/contact/minerals.hpp>
#include <granum/effective/answer.hpp>
#include <granum/hardin/known_sands.hpp>

#include "cli/options/packing_options.hpp"

/// What granum estimate takes beyond a packing: how it was made, what its grains and pores are, which sand.
namespace granum::cli {

struct AnswerOptions {
  effective::Preparation preparation;
  const contact::Mineral* mineral = nullptr; ///< of the grains, if it was named
  const hardin::KnownSand* sand = nullptr;   ///< if it was named
  Number relative_density{0, Dimension::dimensionless, "D_r Dr"};
  Number least_void_ratio{0, Dimension::dimensionless, "e_min"};
  Number largest_void_ratio{0, Dimension::dimensionless, "e_max"};
  Number grain_density{2650, Dimension::density, "rho_s"};
  Number saturation{0, Dimension::dimensionless, "S_r Sr"};
};

void add_answer_options(CLI::App& command, AnswerOptions& options);

/// Numbers that mineral, sand and relative density decide, where they are not given themselves.
/// \throws   InvalidArgument where a relative density lacks its limits, or the density is given twice
void apply_presets(PackingOptions& packing, AnswerOptions& options);

/// The question of the answer. C_n, z* and rattlers only where they are given.
/// \throws   InvalidArgument as resolve_state
[[nodiscard]] effective::PackingQuestion question_of(const PackingOptions& packing,
                                                     const AnswerOptions& options);

/// An input that is not exact: assumed, or said to be uncertain.
struct Spread {
  std::string key;      ///< the option without its hyphens
  std::string text;     ///< "9 GPa", for people
  double deviation = 0; ///< one standard deviation, SI
  bool assumed = false; ///< by granum, not given by --uncertainty
};

/// What is assumed of numbers that are not given, and what --uncertainty says of others, in the order of the
/// options.
/// \param    settings   key=sd, checked by propagate(), but for grain-density
[[nodiscard]] std::vector<Spread> spreads_of(const PackingOptions& packing, const AnswerOptions& options,
                                             const std::vector<std::string>& settings);

/// The answer with each of them less and more. A side that no packing can have is moved less far.
/// \throws   InvalidArgument as effective::answer
[[nodiscard]] effective::PackingAnswer answer_with_spreads(const PackingOptions& packing,
                                                           const AnswerOptions& options,
                                                           const std::vector<Spread>& spreads);

} // namespace granum::cli

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <span>
#include <string>

#include <granum/core/error.hpp>
#include <granum/effective/exponents.hpp>
#include <granum/effective/relaxation.hpp>
#include <granum/effective/state.hpp>
#include <granum/elastic/transverse_isotropic.hpp>

/// The table of rungs, the estimates of a packing's stiffness: the inputs, results and cost of each. The
/// ladder, the program's commands and their uncertainties use it. To add an estimate, add a row in rungs.cpp.
namespace granum::effective {

enum class RungName {
  isotropic,      ///< rung 0
  fabric,         ///< rung 1
  directional,    ///< rung 2
  relaxed,        ///< rung 3
  uniform_stress, ///< not on the ladder
  network,        ///< rung 4, analysis of a packing of grains
  probe           ///< rung 5, simulation of one
};

/// The result of a closed form for a packing.
struct RungAnswer {
  elastic::TransverselyIsotropic stiffness;
  Validity validity;
  std::optional<ModulusErrors> relative_error = std::nullopt; ///< standard errors, if the rung states them
  /// Exponents of G_vh, set by answer_with_exponents only; empty where G_vh vanishes at every stress.
  std::optional<StressExponents> exponents = std::nullopt;
};

/// One row of the table.
struct Rung {
  RungName name;
  std::optional<int> number = std::nullopt; ///< place on the ladder, if it has one
  const char* key;                          ///< on a command line
  const char* column;                       ///< in headings and JSON
  const char* title;
  const char* description;
  const char* needs;               ///< inputs besides contact law, C_n, e and mean stress, in symbols
  bool needs_fabric = false;       ///< a measured a, on which its result depends
  bool needs_coordination = false; ///< z*
  bool needs_packing = false;      ///< grains and contacts; no closed form, refused by the functions below
  double typical_time;             ///< of one evaluation, as measured in validation/ladder [s]
  const char* error_source;        ///< source of its stated errors

  // Called by the functions below for a packing with all inputs of the rung; null where it needs a packing.
  RungAnswer (*answer)(const State& packing) = nullptr;
  StressExponents (*exponents)(const State& packing, Modulus which) = nullptr;
};

/// All rows: rungs 0 to 3, uniform stress, rungs 4 and 5.
[[nodiscard]] std::span<const Rung> rungs();
/// The closed forms, which need no packing of grains.
[[nodiscard]] std::span<const Rung> closed_forms();
/// "rung 2", or the key of an estimate that is not on the ladder.
[[nodiscard]] std::string label(const Rung& rung);
/// The row of that name.
[[nodiscard]] const Rung& rung(RungName name);

/// Whether the packing has all inputs of the rung; its fabric is assumed to be known.
[[nodiscard]] bool has_inputs(const State& packing, const Rung& rung);

/// Evaluates a closed form. Without contacts the stiffness is 0.
/// \throws   InvalidArgument as require_valid(State) and relaxed, if the packing lacks an input of the rung,
///           or if the moduli exceed the range of a double
/// Accuracy  as uniform_strain, uniform_stress and relaxed.  Checked by tests/effective/test_rungs.cpp
[[nodiscard]] RungAnswer answer(const Rung& rung, const State& packing);
/// The same with the exponents of G_vh.
[[nodiscard]] RungAnswer answer_with_exponents(const Rung& rung, const State& packing);

/// Whether a calibrated rung is not evaluated because z* does not exceed the isostatic point, below which a
/// contact network is not rigid. Its moduli are then zero, without a stated error.
[[nodiscard]] bool declines(const RungAnswer& answer);

/// Exponents of a modulus at frozen contacts: C_n, z* and a do not change with stress. At zero stress, the
/// limit along the isotropic path. Empty where the modulus vanishes at every stress: without contacts, below
/// the isostatic point, for shear moduli of uniform stress at k_t = 0, and for C12 and C13 of uniform strain
/// at k_t = k_n.
/// \throws   InvalidArgument as answer
/// Accuracy  1e-12 absolute, 1e-10 of rung 3.  Checked by tests/effective/test_rungs.cpp
[[nodiscard]] std::optional<StressExponents> exponents(const Rung& rung, const State& packing, Modulus which);

} // namespace granum::effective

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <span>
#include <string>

#include <granum/core/validity.hpp>
#include <granum/effective/exponents.hpp>
#include <granum/effective/relaxation.hpp>
#include <granum/effective/state.hpp>
#include <granum/elastic/transverse_isotropic.hpp>

/// The table of rungs: what each estimate of a packing's stiffness asks for, says, and costs. The ladder, the
/// program's commands and their uncertainties read it; to add an estimate, add its row in rungs.cpp.
namespace granum::effective {

enum class RungName {
  isotropic,      ///< rung 0
  fabric,         ///< rung 1
  directional,    ///< rung 2
  relaxed,        ///< rung 3
  uniform_stress, ///< beside the ladder
  network,        ///< rung 4, analysis of a packing of grains
  probe           ///< rung 5, simulation of one
};

/// What a closed form says of a packing.
struct RungAnswer {
  elastic::TransverselyIsotropic stiffness;
  Validity validity;
  std::optional<ModulusErrors> relative_error = std::nullopt; ///< where it states standard errors of its own
  /// Of G_vh, from answer_with_exponents alone; nothing where G_vh vanishes whatever the stress.
  std::optional<StressExponents> exponents = std::nullopt;
};

/// One row of the table.
struct Rung {
  RungName name;
  std::optional<int> number = std::nullopt; ///< on the ladder, where it is on it
  const char* key;                          ///< on a command line
  const char* column;                       ///< in headings and JSON
  const char* title;
  const char* description;
  const char* needs;               ///< beyond contact law, C_n, e and the mean stress, in symbols
  bool needs_fabric = false;       ///< a that was measured: its answer depends on it
  bool needs_coordination = false; ///< z*
  bool needs_packing = false;      ///< grains and contacts, no closed form: the functions below refuse it
  double typical_time;             ///< of one evaluation, as measured in validation/ladder [s]
  const char* error_source;        ///< where its stated errors come from

  // What the functions below call, at a packing that has what the rung needs; null where it needs a packing.
  RungAnswer (*answer)(const State& packing) = nullptr;
  StressExponents (*exponents)(const State& packing, Modulus which) = nullptr;
};

/// All rows: rungs 0 to 3, uniform stress, rungs 4 and 5.
[[nodiscard]] std::span<const Rung> rungs();
/// Those that are a closed form: they need no packing of grains.
[[nodiscard]] std::span<const Rung> closed_forms();
/// "rung 2", or the key of one that is not on the ladder.
[[nodiscard]] std::string label(const Rung& rung);
/// The row of that name.
[[nodiscard]] const Rung& rung(RungName name);

/// Whether the packing has what the rung needs; its fabric is taken to be known.
[[nodiscard]] bool has_inputs(const State& packing, const Rung& rung);

/// What a closed form says of a packing. No contacts, no stiffness.
/// \throws   InvalidArgument as require_valid(State) and relaxed, if the packing lacks what the rung needs,
///           or if the moduli are beyond what a double holds
/// Accuracy  as uniform_strain, uniform_stress and relaxed.  Checked by tests/effective/test_rungs.cpp
[[nodiscard]] RungAnswer answer(const Rung& rung, const State& packing);
/// The same with the exponents of G_vh.
[[nodiscard]] RungAnswer answer_with_exponents(const Rung& rung, const State& packing);

/// Whether a calibrated rung declines: z* is not above the isostatic point, where a network of contacts is
/// not rigid. Its moduli are then zero, and it states no error of them.
[[nodiscard]] bool declines(const RungAnswer& answer);

/// Exponents of a modulus at frozen contacts: C_n, z* and a do not grow. At zero stress those of the
/// isotropic path, their limit. Nothing where the modulus vanishes whatever the stress: without contacts,
/// shear moduli of uniform stress at k_t = 0, C12 and C13 of uniform strain at k_t = k_n, or below the
/// isostatic point.
/// \throws   InvalidArgument as answer
/// Accuracy  1e-12 absolute, 1e-10 of rung 3.  Checked by tests/effective/test_rungs.cpp
[[nodiscard]] std::optional<StressExponents> exponents(const Rung& rung, const State& packing, Modulus which);

} // namespace granum::effective

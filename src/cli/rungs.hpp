// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <span>

#include <granum/effective/exponents.hpp>
#include <granum/effective/relaxation.hpp>
#include <granum/effective/state.hpp>
#include <granum/elastic/transverse_isotropic.hpp>

/// The closed forms that the program offers, in one table.
namespace granum::cli {

/// Young's modulus of a stiffness [Pa]: 0 in the limit of vanishing shear stiffness, nothing if no stable
/// material has this stiffness.
enum class Loading { vertical, horizontal };
[[nodiscard]] std::optional<double> young_modulus(const elastic::TransverselyIsotropic& stiffness,
                                                  Loading loading);

/// What closed forms are asked about.
struct Packing {
  effective::State state;
  std::optional<double> mechanical_coordination_number; ///< z*, where it is known
};

/// What a closed form says of a packing.
struct FieldAnswer {
  elastic::TransverselyIsotropic stiffness;
  /// Of G_hv; at zero stress those of the isotropic path; nothing where G_hv is zero by construction,
  /// whatever the stress.
  std::optional<effective::StressExponents> exponents;
  Validity validity;
  std::optional<effective::ModulusErrors> relative_error = std::nullopt; ///< standard errors, where stated
};

/// One closed form. To add one, add its row to the table in rungs.cpp.
struct Rung {
  const char* key;    ///< on the command line
  const char* column; ///< in headings and JSON
  const char* title;
  const char* needs; ///< what it asks of a packing beyond contact law, C_n, e and p'
  bool needs_mechanical_coordination_number;
  FieldAnswer (*answer)(const Packing& packing);
};

[[nodiscard]] std::span<const Rung> all_rungs();

/// The answer of a closed form.
/// \throws   InvalidArgument if the packing is not valid, if it lacks what the rung needs, or if the moduli
///           overflow
[[nodiscard]] FieldAnswer answer(const Rung& rung, const Packing& packing);

/// Rung 2 and its counterpart under uniform stress, the two sides of granum estimate.
[[nodiscard]] const Rung& uniform_strain_rung();
[[nodiscard]] const Rung& uniform_stress_rung();
/// Rung 3, which granum estimate adds where z* is given.
[[nodiscard]] const Rung& relaxed_rung();

/// Leaves out notes that stand there before.
void keep_each_once(Validity& validity);

} // namespace granum::cli

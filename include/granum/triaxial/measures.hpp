// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <granum/assembly/assembly.hpp>
#include <granum/dem/state.hpp>
#include <granum/elastic/stiffness.hpp>

/// What is measured on a specimen at a point of its path.
namespace granum::triaxial {

/// The contact network in numbers.
struct Microstructure {
  double coordination_number = 0;            ///< C_n, all grains
  double mechanical_coordination_number = 0; ///< z*, rattlers left out
  double rattler_fraction = 0;
  double fabric_anisotropy = 0;       ///< a of E(gamma; a)
  double fabric_anisotropy_error = 0; ///< standard error
  double sliding_fraction = 0;        ///< contacts at the Coulomb limit

  bool operator==(const Microstructure&) const = default;
};

/// \param    assembly  with at least 2 contacts, frictional ones
/// \throws   InvalidArgument for an assembly that require_valid rejects, or fewer contacts
/// Checked by tests/triaxial/test_shear_test.cpp
[[nodiscard]] Microstructure microstructure(const Assembly& assembly);

/// Elastic answer of the state frozen in place.
struct FrozenModuli {
  elastic::VoigtStiffness relaxed; ///< of the network, every grain in equilibrium [Pa]
  elastic::VoigtStiffness affine;  ///< under uniform strain [Pa]
  Mat3 stress;                     ///< contact stress of the frozen state [Pa]
  double unbalanced_force_ratio = 0;

  [[nodiscard]] double G_hh() const { return relaxed.matrix(5, 5); }
  /// G_hv = G_vh, mean of both vertical planes.
  [[nodiscard]] double G_vh() const { return (relaxed.matrix(3, 3) + relaxed.matrix(4, 4)) / 2; }
};

/// Brings the state to rest at fixed cell with no contact sliding, and solves its network.
/// \throws   NotConverged if the state does not come to rest (unbalanced force ratio 1e-6), or the network
///           is not solved
/// Checked by tests/triaxial/test_shear_test.cpp
[[nodiscard]] FrozenModuli frozen_moduli(const dem::State& state, const dem::Material& material);

} // namespace granum::triaxial

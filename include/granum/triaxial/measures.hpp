// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>

#include <granum/assembly/assembly.hpp>
#include <granum/core/stop_request.hpp>
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

/// The part of a specimen between walls that keeps a distance from them, where walls do not order the grains.
struct InteriorMeasures {
  std::size_t grains = 0; ///< with their centres inside
  double void_ratio = 0;  ///< of the inside, from the volumes of all grains there, whole or cut [1]
  /// C_n, z* and rattlers: of these grains and all their contacts; a and sliding: of contacts whose middle is
  /// inside.
  Microstructure micro;
  Mat3 stress; ///< contact stress, walls', too, each contact with the share of its branch that is inside [Pa]
};

/// \param    layer  left out at every wall [m]; two diameters are the custom
/// \throws   InvalidArgument if the layers leave too little: no grain, or fewer than 2 contacts
/// Accuracy  the stress is above that of the walls by up to (L/(L - 2R))^2, L the edge of the box: within R
///           of a side wall no contact between grains bears force along it.
/// Checked by tests/triaxial/test_walls.cpp
[[nodiscard]] InteriorMeasures interior_measures(const dem::State& state, const dem::Material& material,
                                                 double layer);

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
/// Assumes   a periodic cell, or walls as network::linear_response takes them.
/// \param    force_tolerance  unbalanced force ratio of the frozen state > 0 [1]
///           1e-6 changes the moduli of 1,000 walled grains by 1e-4 (dense) to 5e-4 (loose), 1e-5 by up to
///           5e-3; loose ones seldom rest beyond 5e-7, for all of 40,000 steps
/// \throws   NotConverged if the state does not come to rest (within rest_bound, or force_tolerance if
///           larger), or the network is not solved; Stopped if so asked
/// Checked by tests/triaxial/test_shear_test.cpp, tests/triaxial/test_walled_moduli.cpp
[[nodiscard]] FrozenModuli frozen_moduli(const dem::State& state, const dem::Material& material,
                                         double force_tolerance = 1e-8,
                                         const StopRequest& stop_requested = {});

} // namespace granum::triaxial

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "studies/running/probes.hpp"
#include "studies/running/run_control.hpp"
#include "studies/scene/scene.hpp"
#include <granum/analysis/measurement.hpp>
#include <granum/elastic/isotropic.hpp>

namespace granum::studies {

/// One state of isotropic compression.
struct CompressedState {
  double pressure = 0;           ///< requested [Pa]
  double contact_pressure = 0;   ///< mean contact stress at the end of the stage [Pa]
  double sliding_fraction = 0;   ///< contacts at the Coulomb limit when the stage ended
  analysis::Measurement packing; ///< of the frozen state: network, bounds and the pressure by work as well
  double G_closed = 0; ///< uniform strain in closed form from C_n, e and the requested pressure [Pa]
  double K_closed = 0;
  std::optional<Probes> probes;

  std::size_t steps = 0; ///< of the stage and its rest
  double unbalanced_force_ratio = 0;
  double largest_inertial_number = 0;

  /// Isotropic part of the network: relaxed, and under uniform strain.
  [[nodiscard]] elastic::Isotropic network() const { return packing.solved_network().isotropic_relaxed(); }
  [[nodiscard]] elastic::Isotropic uniform_strain() const {
    return packing.solved_network().isotropic_affine();
  }
};

/// G_vh of rung 3 with the measured contacts and unevenness of forces [Pa]; empty where z* permits none.
/// Checked by tests/studies/test_local_exponents.cpp
[[nodiscard]] std::optional<double> relaxed_modulus(const CompressedState& state);
/// Shear moduli of the network in the planes that the probes shear, 12 and 13 [Pa].
[[nodiscard]] double G_hh_network(const CompressedState& state);
[[nodiscard]] double G_vh_network(const CompressedState& state);
/// Contribution of the contact forces to them, as measured by a probe (network::ForceTerms) [Pa].
[[nodiscard]] double G_hh_by_forces(const CompressedState& state);
[[nodiscard]] double G_vh_by_forces(const CompressedState& state);
/// The contribution of the forces relative to the network; the larger of two [1].
[[nodiscard]] double largest_force_share(const CompressedState& state);
/// Relative difference between probes, which the state has, and network with its contact forces [1].
[[nodiscard]] double probe_error(const CompressedState& state);
/// Difference up to which probe and network agree: contacts with very small forces open in one half of the
/// cycle, a larger share of them in small and in loose specimens.
[[nodiscard]] double probe_limit(const Scene& scene, triaxial::Density density);

/// One specimen on its isotropic path.
struct SpecimenResult {
  contact::Shape contact = contact::Shape::sphere;
  triaxial::Density density = triaxial::Density::dense;
  std::uint64_t seed = 0;
  std::vector<CompressedState> states; ///< as far as it came
  std::string failure;                 ///< empty when the whole path was run
  std::vector<std::string> left_out{}; ///< states and probes that did not come to rest: pressure, and why
};

/// "flat loose #3".
[[nodiscard]] std::string title(const SpecimenResult& specimen);

/// Runs the study: a frictionless packing for each contact and seed, from it a dense and a loose specimen,
/// each compressed through the pressures, frozen at each, analysed, solved as a network, and probed where
/// asked. Specimens run at the same time on the scene's number of threads; each is the work of one thread
/// from start to end, so the results are the same bits for any number of threads.
/// \return   specimens in the order contact, density, seed; those that failed or were stopped contain a
///           message
/// \throws   InvalidArgument for an impossible scene
/// Checked by tests/studies/test_study.cpp
[[nodiscard]] std::vector<SpecimenResult> run_study(const Scene& scene, const RunControl& control = {});

} // namespace granum::studies

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <atomic>
#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include <granum/verify/scene.hpp>

namespace granum::verify {

/// Shear moduli of the three probes of one frozen state [Pa].
struct Probes {
  double G_hh = 0;
  double G_hv = 0;
  double G_vh = 0;
  double amplitude = 0; ///< shear strain [1]

  bool operator==(const Probes&) const = default;
};

/// One frozen state: what was measured on it and what the estimates say of it.
struct StateResult {
  double pressure = 0;             ///< target [Pa]
  double contact_pressure = 0;     ///< mean contact stress at the end of the stage [Pa]
  double pressure_by_work = 0;     ///< the frozen state's, by the work of the cell [Pa]
  double pressure_by_contacts = 0; ///< the frozen state's, by its contact forces [Pa]
  double void_ratio = 0;
  double coordination_number = 0;            ///< C_n, all grains
  double mechanical_coordination_number = 0; ///< z*, rattlers left out
  double rattler_fraction = 0;
  double fabric_anisotropy = 0;
  double fabric_anisotropy_error = 0; ///< standard error
  double sliding_fraction = 0;        ///< contacts at the Coulomb limit when the stage ended

  double G_closed = 0; ///< uniform strain in closed form from C_n, e and p [Pa]
  double K_closed = 0;
  double G_uniform_strain = 0; ///< uniform strain of the network at hand [Pa]
  double K_uniform_strain = 0;
  double G_network = 0; ///< relaxed, isotropic projection [Pa]
  double K_network = 0;
  double G_hh_network = 0;
  double G_vh_network = 0; ///< in the plane of x and z, as the probes shear
  double K_lower = 0;      ///< refined uniform-stress bound [Pa]
  double K_upper = 0;      ///< uniform-strain bound [Pa]
  int network_iterations = 0;
  double network_residual = 0;
  std::optional<Probes> probes;

  std::size_t steps = 0; ///< of the stage and its rest
  double unbalanced_force_ratio = 0;
  double largest_inertial_number = 0;

  bool operator==(const StateResult&) const = default;
};

/// One specimen on its isotropic path.
struct SpecimenResult {
  contact::Shape contact = contact::Shape::sphere;
  triaxial::Density density = triaxial::Density::dense;
  std::uint64_t seed = 0;
  std::vector<StateResult> states; ///< as far as it came
  std::string failure;             ///< empty when the whole path was run

  bool operator==(const SpecimenResult&) const = default;
};

struct Progress {
  double done = 0; ///< share of the predicted work, 0..1
  std::string what;
  double done_before = 0; ///< share that checkpoints of an earlier run held
};

struct RunControl {
  std::function<void(const Progress&)> report = {}; ///< called from worker threads, one at a time
  const std::atomic<bool>* stop = nullptr; ///< set it to end the study early; what is finished is kept
};

/// Runs the study: a frictionless packing for each contact and seed, from it a dense and a loose specimen,
/// each compressed through the pressures, frozen at each, analysed, solved as a network, and probed where
/// asked. Specimens run side by side on as many threads as the scene says; each is one thread's work from
/// start to end, so the results are the same bits for any number of threads.
/// \return   specimens in the order contact, density, seed; those that failed or were stopped say so
/// \throws   InvalidArgument for an impossible scene
/// Checked by tests/verify/test_study.cpp
[[nodiscard]] std::vector<SpecimenResult> run_study(const Scene& scene, const RunControl& control = {});

} // namespace granum::verify

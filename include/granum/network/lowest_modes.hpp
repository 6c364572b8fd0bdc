// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <vector>

#include <granum/network/linear_response.hpp>
#include <granum/packing/assembly.hpp>

/// Free oscillations of a contact network.
namespace granum::network {

/// A small free oscillation.
struct Mode {
  double frequency = 0; ///< f; the eigenvalue of H and the masses is (2 pi f)^2 [Hz]
  /// (sum e)^2/(N sum e^2), e the kinetic energy of each grain and N the number that carry load: 1 if all
  /// have the same, 1/N if one grain has all [1]                                              [BellDean1970]
  double participation_ratio = 0;
  /// Of each grain of the assembly, in motions of u^T M u = 1 kg m^2; zero for those without load.
  std::vector<GrainMotion> motion;
};

/// The modes of lowest frequency, from the lowest on: H v = (2 pi f)^2 M v, with the mass m of a solid sphere
/// for u and its moment of inertia 2/5 m R^2, so 2/5 m for R w.
/// Assumes   as stiffness_matrix; motions without stiffness are left out: those with (2 pi f)^2 below
///           1e-4/N^(2/3) of the mean stiffness over the largest mass, as translations of a periodic packing,
///           and turns of a grain about its only two contacts.
/// \param    grain_density   of the solid, > 0 [kg/m^3]
/// \param    count   of modes, at least 1
/// \param    options   sliding, prestress and stop_requested count
/// \return   at most `count`: fewer if the network has no more
/// \throws   InvalidArgument as stiffness_matrix, for grains that form bodies and arguments out of range;
///           NotConverged for an unstable network; Stopped
/// Accuracy  1e-9 of (2 pi f)^2; modes of one frequency are found as often as it occurs. Time and memory are
///           those of a direct factor, 2 s for 1,000 grains, 5 min and 0.9 GB for 10,000.
///           Checked by tests/network/test_lowest_modes.cpp, python/tests/test_networks.py (residuals)
[[nodiscard]] std::vector<Mode> lowest_modes(const packing::Assembly& assembly, double grain_density,
                                             std::size_t count, const ResponseOptions& options = {});

} // namespace granum::network

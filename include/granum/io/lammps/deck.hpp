// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>
#include <vector>

#include <granum/contact/normal_law.hpp>
#include <granum/packing/assembly.hpp>

/// An experiment handed over to LAMMPS, for packings that are too large for one machine.
/// Checked by tests/io/lammps/test_deck.cpp; against LAMMPS itself by tests/peer/lammps
namespace granum::io {

/// State of the grains of a deck.
enum class LammpsStart {
  packed,   ///< jammed, or just below jamming: friction and servo start at once
  scattered ///< far from each other: the box is first made smaller
};

/// A triaxial test from the last pressure on: one stress is driven at constant inertial number, one is
/// constant.
struct LammpsPath {
  std::string name;              ///< of its states, letters and digits: TXC
  bool drives_vertical = true;   ///< else both horizontal stresses
  bool compresses = true;        ///< the stress that is driven grows
  double inertial_number = 2e-4; ///< driven strain rate times 2R sqrt(density/p), in (0, 0.1) [1]
  double eta_step = 0.1;         ///< a state at each first passage of a multiple of this q/p, >= 0.001 [1]
  double largest_strain = 0.03;  ///< axial strain, either sense, at which the test ends, in (0, 1) [1]
};

/// One specimen: spheres, isotropic compression with snapshots, a stress path, small-strain probes.
struct LammpsExperiment {
  contact::NormalLaw law;          ///< of spheres of `radius`
  double radius = 0;               ///< R > 0 [m], of all grains or of those that the law is of, their mean
  double density = 2650;           ///< of the grains [kg/m^3]; sets the time scale, no quasi-static result
  double tangential_ratio = 0;     ///< k_t/k_n >= 0 [1]
  double friction_coefficient = 0; ///< mu >= 0 [1]
  LammpsStart start = LammpsStart::packed;
  bool friction_while_prepared = false;  ///< false: switched on at the first pressure, for dense specimens
  std::vector<double> pressures;         ///< rising, at least one [Pa]
  std::vector<double> probe_pressures{}; ///< some of the pressures [Pa]
  std::optional<LammpsPath> path{};      ///< all its states are probed
};

/// A file of a deck, by its name in the folder of the deck.
struct DeckFile {
  std::string name;
  std::string text;
};

/// Everything that LAMMPS (2021 or later, package GRANULAR) needs, on any number of processors: grains.data,
/// the numbers of the scene with their units, in.prepare, in.iso, in.probe, in.path and in.path-probe, in.all
/// that runs the five, and README.txt. LammpsDump reads its output.
///
/// Contacts: pair_style granular, hertz/material with tangential mindlin/force. That variant adds k_t du to
/// the force carried so far; mindlin without /force rescales the whole force with k_t, so that a frozen state
/// has another k_t than a contact network. Time step, drag and servo follow from the pressure.
/// Assumes   `start` is periodic on all faces.
/// Grains of unequal radii have their diameters in grains.data; LAMMPS computes R* of each pair.
/// Its time step then follows the smallest grain.
/// \param    start   grains; contacts and forces are not used
/// \throws   InvalidArgument as lammps_data; for a law that is not that of spheres of the radius (LAMMPS
///           has no other of this family), a ratio, friction,
///           pressure or number of the path out of range
[[nodiscard]] std::vector<DeckFile> lammps_deck(const packing::Assembly& start,
                                                const LammpsExperiment& experiment);

} // namespace granum::io

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include <granum/assembly/assembly.hpp>
#include <granum/contact/power_law.hpp>

/// An experiment handed over to LAMMPS, for packings that are too large for one machine.
/// Checked by tests/io/test_lammps_deck.cpp; against LAMMPS itself by tests/peer/lammps
namespace granum::io {

/// In what state the grains of a deck are.
enum class LammpsStart {
  packed,   ///< jammed, or just below jamming: friction and servo start at once
  scattered ///< far from each other: the box is first made smaller
};

/// One specimen: equal spheres, isotropic compression with snapshots, small-strain probes of some states.
struct LammpsExperiment {
  contact::PowerLaw law;       ///< of spheres of `radius`
  double radius = 0;           ///< R > 0 [m], all grains
  double density = 2650;       ///< of the grains [kg/m^3]; sets the time scale, not the quasi-static answer
  double tangential_ratio = 0; ///< k_t/k_n >= 0 [1]
  double friction_coefficient = 0; ///< mu >= 0 [1]
  LammpsStart start = LammpsStart::packed;
  bool friction_while_prepared = false;  ///< false: switched on at the first pressure, for dense specimens
  std::vector<double> pressures;         ///< rising, at least one [Pa]
  std::vector<double> probe_pressures{}; ///< some of the pressures [Pa]
};

/// A file of a deck, by its name in the folder of the deck.
struct DeckFile {
  std::string name;
  std::string text;
};

/// Everything that LAMMPS (2021 or later, package GRANULAR) needs, on any number of processors: grains.data,
/// the numbers of the scene with their units, in.prepare, in.iso and in.probe, in.all that runs the three,
/// and README.txt. What it writes is read back by LammpsDump.
///
/// Contacts: pair_style granular, hertz/material with tangential mindlin/force. That variant adds k_t du to
/// the force carried so far; mindlin without /force rescales the whole force with k_t, so that a frozen state
/// answers with another k_t than a contact network has. Time step, drag and servo follow from the pressure.
/// Assumes   `start` is periodic on all faces.
/// \param    start   grains of equal radius; contacts and forces are not taken over
/// \throws   InvalidArgument as lammps_data; for a law that is not that of spheres of the radius (LAMMPS
///           has no other of this family), a radius that is not that of the grains, a ratio, friction or
///           pressure out of range
[[nodiscard]] std::vector<DeckFile> lammps_deck(const Assembly& start, const LammpsExperiment& experiment);

} // namespace granum::io

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>

#include <granum/contact/normal_law.hpp>
#include <granum/core/stop.hpp>
#include <granum/dem/specimen.hpp>

namespace granum::dem {

struct MinimiseOptions {
  double force_tolerance = 1e-9;    ///< mean residual force on a grain / mean contact force [1]
  double pressure_tolerance = 1e-9; ///< relative, where a pressure is prescribed [1]
  double overlap_tolerance =
      1e-7; ///< largest overlap, over the radius of a grain of size 1, that is neglected [1]
  std::size_t max_steps = 200000;
  StopRequest stop_requested = {}; ///< true ends the relaxation early; the report has `stopped` then
};

/// Result of a relaxation. Its state is the last good one in any case.
struct [[nodiscard]] RelaxReport {
  bool converged = false;
  bool stopped = false; ///< by stop_requested
  std::size_t steps = 0;
  double unbalanced_force_ratio =
      0;                    ///< mean residual force on a grain / mean contact force; 0 without contacts
  double last_pressure = 0; ///< mean contact stress at the end, converged or not [Pa]

  /// Mean contact stress of the relaxed state [Pa].
  /// \throws   NotConverged unless converged
  [[nodiscard]] double pressure() const;
};

/// Minimises the elastic energy of frictionless spheres in a fixed cell by FIRE.
/// [Bitzek2006]
/// Assumes   no friction, also at walls. Rotations and contact histories are cleared in the state.
/// Converged when forces are in balance, or when no overlap exceeds the tolerance (below jamming).
/// \throws   InvalidArgument for a state that is empty or too small for its cell
/// Checked by tests/dem/test_minimise.cpp
RelaxReport minimise_energy(Specimen& state, const contact::NormalLaw& law,
                            const MinimiseOptions& options = {});

/// Minimises the enthalpy (energy + p V) over the positions and the size of the cell.
/// \param    pressure  p > 0 [Pa]
RelaxReport minimise_enthalpy(Specimen& state, const contact::NormalLaw& law, double pressure,
                              const MinimiseOptions& options = {});

} // namespace granum::dem

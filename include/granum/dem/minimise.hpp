// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>

#include <granum/contact/normal_law.hpp>
#include <granum/core/stop_request.hpp>
#include <granum/dem/specimen.hpp>

namespace granum::dem {

struct MinimiseOptions {
  double force_tolerance = 1e-9;    ///< mean residual force on a grain / mean contact force [1]
  double pressure_tolerance = 1e-9; ///< relative, where a pressure is prescribed [1]
  double overlap_tolerance =
      1e-7; ///< largest overlap over the radius of a grain of size 1 that counts as none [1]
  std::size_t max_steps = 200000;
  StopRequest stop_requested = {}; ///< true ends the relaxation early: the report then says so
};

/// How a relaxation ended. The state it belongs to is the last good one in any case.
struct [[nodiscard]] RelaxReport {
  bool converged = false;
  bool stopped = false; ///< stop_requested said so
  std::size_t steps = 0;
  double unbalanced_force_ratio =
      0;                    ///< mean residual force on a grain / mean contact force; 0 without contacts
  double last_pressure = 0; ///< mean contact stress at the end, converged or not [Pa]

  /// Mean contact stress of the relaxed state [Pa].
  /// \throws   NotConverged unless converged
  [[nodiscard]] double pressure() const;
};

/// Minimises the elastic energy of frictionless spheres at fixed cell by FIRE.
/// [Bitzek2006]
/// Assumes   no friction, at walls neither: positions only, no rotations and no histories are modelled; both
/// are cleared in the state.
/// Converged when forces balance, or when no overlap beyond the tolerance is left (below jamming).
/// \throws   InvalidArgument for a state that is empty or too small for its cell
/// Checked by tests/dem/test_minimise.cpp
RelaxReport minimise_energy(Specimen& state, const contact::NormalLaw& law,
                            const MinimiseOptions& options = {});

/// Minimises the enthalpy (energy + p V) over positions and an isotropic change of the cell's size.
/// \param    pressure  p > 0 [Pa]
RelaxReport minimise_enthalpy(Specimen& state, const contact::NormalLaw& law, double pressure,
                              const MinimiseOptions& options = {});

} // namespace granum::dem

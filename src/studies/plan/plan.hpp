// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <string>

#include "studies/scene/scene.hpp"

namespace granum::studies {

/// Predicted work of the parts of a study, in grain-steps of the frictional engine. The numbers of steps are
/// those of 1,000 grains, three seeds, averaged (validation/verify_default/), and grow as N^(1/3) like the
/// travel time of sound through a specimen.
[[nodiscard]] double preparation_work(const Scene& scene);
/// Compression to the pressure of that index, rest, network and, if requested, probes.
[[nodiscard]] double stage_work(const Scene& scene, triaxial::Density density, contact::Shape shape,
                                std::size_t stage);
[[nodiscard]] double specimen_work(const Scene& scene, triaxial::Density density, contact::Shape shape);
[[nodiscard]] double total_work(const Scene& scene);

/// Work of a study, and its predicted cost on this machine.
struct Plan {
  std::size_t packings = 0;
  std::size_t specimens = 0;
  std::size_t network_solutions = 0;
  std::size_t probes = 0;
  double grain_steps = 0;            ///< predicted
  double seconds_per_grain_step = 0; ///< that was given
  double seconds = 0;                ///< predicted wall time [s]
  double memory = 0;                 ///< predicted peak [bytes]
};

/// Measures the engine for about a tenth of a second, with the scene's law: seconds a grain and step [s]. The
/// one number here that depends on the machine and its other load.
/// \throws   InvalidArgument for an impossible scene
[[nodiscard]] double measured_speed(const Scene& scene);

/// Predicts time and memory of a study from the engine's speed.
/// \param    seconds_per_grain_step  > 0, as measured_speed() finds it [s]
/// Accuracy  a factor of two for the default scene on a quiet machine.
/// \throws   InvalidArgument for an impossible scene, or a speed that is not positive
/// Checked by tests/studies/test_plan.cpp
[[nodiscard]] Plan plan(const Scene& scene, double seconds_per_grain_step);

/// Additional cost of the scene's grain sizes compared with equal ones, in a sentence or two; empty if the
/// largest radius is 5 times the smallest, or less. As measured in bench/README.md.
/// Checked by tests/studies/test_plan.cpp
[[nodiscard]] std::string cost_of_sizes(const Scene& scene);

} // namespace granum::studies

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include <granum/stress/stress.hpp>

#include "sweep.hpp"

/// The ground of granum sweep --depth, and of tables whose rows are depths.
namespace granum::cli {

/// The ground given by the options.
struct GroundCase {
  stress::Ground ground;
  double saturation = 0; ///< of the pores above the water table
  estimate::Notes assumptions;
  Validity validity; ///< where weights and void ratio contradict each other
};

/// A layer of the ground, with the weight of the layers above as surcharge.
struct Layer {
  double top = 0;       ///< depth of its top [m]
  SweepOptions options; ///< of its soil
  GroundCase ground;    ///< depths and water table relative to its top, the layers above as surcharge
};

/// An answer in the ground.
struct GroundState {
  stress::GroundStress stress;
  SweptState state;
};

void add_ground_options(Command& command, GroundOptions& options);

/// The depths of --depth [m].
/// \throws   InvalidArgument
[[nodiscard]] std::vector<double> depths_of(const SweepOptions& options);

/// \throws   InvalidArgument for options that contradict each other or are out of range
[[nodiscard]] GroundCase resolve_ground(const SweepOptions& options);

/// The layers of --layers from the surface down; without the option a single layer.
/// \throws   as resolve_ground; FileError for a table whose tops do not begin at 0 or do not increase
[[nodiscard]] std::vector<Layer> layers_of(const SweepOptions& options);

/// The layer at a depth; at a boundary the lower one.
[[nodiscard]] const Layer& layer_at(const std::vector<Layer>& layers, double depth);
/// The assumptions of all layers down to the deepest depth, and then those of single layers.
[[nodiscard]] estimate::Notes assumptions_of(const std::vector<Layer>& layers, double deepest);

/// The inputs at an effective stress, with the saturation of a depth.
/// \param    depth   from the top of the ground [m]
[[nodiscard]] InputValues values_in_ground(const SweepOptions& options, const GroundCase& ground,
                                           double depth, const stress::AxialStress& effective);
/// The answer, as of granum estimate, at the stresses and saturation of a depth.
/// \param    depth   from the top of the ground [m]
[[nodiscard]] GroundState state_in_ground(const SweepOptions& options, const GroundCase& ground, double depth,
                                          const Rungs& rungs);

} // namespace granum::cli

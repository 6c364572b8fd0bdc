// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "sweep.hpp"

/// The ground of granum sweep --depth, and of tables whose rows are depths.
namespace granum::cli {

/// A layer of the ground, with the weight of the layers above as surcharge.
struct Layer {
  double top = 0;       ///< depth of its top [m]
  SweepOptions options; ///< of its soil
  GroundCase ground;    ///< depths and water table relative to its top, the layers above as surcharge
};

/// The depths of --depth [m].
/// \throws   InvalidArgument
[[nodiscard]] std::vector<double> depths_of(const SweepOptions& options);

/// The layers of --layers from the surface down; without the option a single layer.
/// \throws   as resolve_ground; FileError for a table whose tops do not begin at 0 or do not increase
[[nodiscard]] std::vector<Layer> layers_of(const SweepOptions& options);

/// The layer at a depth; at a boundary the lower one.
[[nodiscard]] const Layer& layer_at(const std::vector<Layer>& layers, double depth);
/// The assumptions of all layers down to the deepest depth, and then those of single layers.
[[nodiscard]] estimate::Notes assumptions_of(const std::vector<Layer>& layers, double deepest);

/// The inputs at a depth of the ground [m], with its effective stress and its saturation.
[[nodiscard]] InputValues values_at(const std::vector<Layer>& layers, double depth);

} // namespace granum::cli

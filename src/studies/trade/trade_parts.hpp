// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "studies/trade/trade.hpp"

/// The pieces of work behind the samples of a trade study. Each is done once, by one thread.
namespace granum::studies::trade {

/// In the order in which they need each other: a shear test and probes each follow a compression.
enum class Kind { packing, compression, shear, probing };

/// What a part is done with; what its kind does not depend on is 0.
struct Settings {
  Boundary boundary = Boundary::periodic;
  std::size_t grains = 0;
  std::uint64_t seed = 0;
  triaxial::Density density = triaxial::Density::dense;
  double compression = 0; ///< inertial number
  double time_step = 0;   ///< fraction of its limit
  double shear = 0;       ///< inertial number
  double probe = 0;       ///< amplitude, in mean overlaps over the diameter

  bool operator==(const Settings&) const = default;
};

inline constexpr std::size_t none = static_cast<std::size_t>(-1);

struct Part {
  Kind kind = Kind::packing;
  Settings settings;
  std::size_t before = none; ///< the part that it starts from
  bool probed_later = false;
  bool sheared_later = false;

  std::string failure = {}; ///< empty when it is whole
  double cpu_seconds = 0;
  std::size_t steps = 0;
  dem::Specimen state = {}; ///< not frozen: a packing, or at the highest pressure for a shear test
  std::vector<dem::Specimen> frozen = {}; ///< where probes follow
  // at each pressure of a compression, of frozen states; G_vh also of probes and of a shear test at eta = 0.8
  std::vector<double> void_ratio = {};
  std::vector<double> isotropic = {}; ///< G of the network [Pa]; none between walls
  std::vector<double> planes = {};    ///< mean of G_hh and G_vh, by network or, between walls, by probes [Pa]
  std::vector<double> vertical = {};  ///< G_vh [Pa]
  double network_seconds = 0;         ///< of one solution
  std::optional<double> peak_ratio = {};
};

/// One sample and the parts that it is read from.
struct Source {
  TradeSample sample;               ///< varied, boundary, value, density, seed
  std::vector<std::size_t> charged; ///< whose cost is its own
  std::size_t path = none;          ///< compression of the void ratios for s; none: no s
  std::size_t measured = none;      ///< the part with its moduli
  std::vector<double> Part::*moduli = nullptr;
};

/// All samples of a study, and the parts that they need, each once.
struct PlannedWork {
  std::vector<Part> parts;
  std::vector<Source> sources;
};

[[nodiscard]] PlannedWork planned_work(const TradeScene& trade);

/// Predicted work of a part, and of a whole study, in grain-steps of the engine with friction.
[[nodiscard]] double predicted_work(const TradeScene& trade, const Part& part);
[[nodiscard]] double predicted_work(const TradeScene& trade);

} // namespace granum::studies::trade

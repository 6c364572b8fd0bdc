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

struct Part {
  std::string failure; ///< empty when it is whole
  double cpu_seconds = 0;
  std::size_t steps = 0;
};

struct Packing : Part {
  Boundary boundary = Boundary::periodic;
  std::size_t grains = 0;
  std::uint64_t seed = 0;
  dem::Specimen state;
};

/// A specimen on its isotropic path.
struct Compression : Part {
  std::size_t packing = 0;
  triaxial::Density density = triaxial::Density::dense;
  double inertial_number = 0;
  double time_step_fraction = 0;

  std::vector<double> void_ratio;    ///< of the frozen states, as all below
  std::vector<double> isotropic;     ///< G of the network [Pa]; none between walls
  std::vector<double> planes;        ///< mean of G_hh and G_vh, by network or, between walls, by probes [Pa]
  std::vector<double> vertical;      ///< G_vh of the network [Pa]
  std::vector<dem::Specimen> frozen; ///< where probes follow
  dem::Specimen last;                ///< at the highest pressure, not frozen, where a shear test follows
  bool probed_later = false;
  bool sheared_later = false;
  double network_seconds = 0; ///< of one solution
};

struct Shear : Part {
  std::size_t compression = 0;
  double inertial_number = 0;
  double time_step_fraction = 0;
  double peak_ratio = 0;
  std::optional<double> vertical; ///< G_vh at eta = 0.8 [Pa]
};

/// Probes of one amplitude, in the plane of x and z, at every pressure.
struct Probing : Part {
  std::size_t compression = 0;
  double amplitude = 0; ///< in mean overlaps over the diameter
  std::vector<double> shear_modulus;
};

/// The parts of a study.
struct Work {
  std::vector<Packing> packings;
  std::vector<Compression> compressions;
  std::vector<Shear> shears;
  std::vector<Probing> probings;
};

/// One sample and the parts that it is read from; none is marked by `none`.
inline constexpr std::size_t none = static_cast<std::size_t>(-1);

struct Source {
  TradeSample sample; ///< varied, boundary, value, density, seed
  std::size_t compression = none;
  std::size_t shear = none;
  std::size_t probing = none;
};

/// All samples of a study, and the parts that they need, each once.
struct PlannedWork {
  Work work;
  std::vector<Source> sources;
};

[[nodiscard]] PlannedWork planned_work(const TradeScene& trade);

/// Predicted work of a part, in grain-steps of the engine with friction.
[[nodiscard]] double predicted_work(const TradeScene& trade, const Work& work, const Packing& part);
[[nodiscard]] double predicted_work(const TradeScene& trade, const Work& work, const Compression& part);
[[nodiscard]] double predicted_work(const TradeScene& trade, const Work& work, const Shear& part);
[[nodiscard]] double predicted_work(const TradeScene& trade, const Work& work, const Probing& part);
[[nodiscard]] double predicted_work(const TradeScene& trade, const Work& work);

} // namespace granum::studies::trade

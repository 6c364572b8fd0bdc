// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "studies/running/run_control.hpp"
#include "studies/scene/scene.hpp"
#include <granum/dem/engine.hpp>

/// Speed against accuracy: the same specimens with one setting varied at a time, the effect on moduli,
/// exponents and peaks, and the cost.
namespace granum::studies {

/// The quantity that is varied.
enum class Varied {
  grains,      ///< N, periodic cell; many specimens of each size
  compression, ///< inertial number of isotropic compression
  shear,       ///< inertial number of the shear path
  time_step,   ///< of both, as a fraction of the stability limit
  probe,       ///< strain amplitude of the cyclic probe, in mean overlaps over the diameter; 0: the network
  boundary,    ///< six rigid walls of N grains, against the periodic cell; probed
};

inline constexpr std::array all_varied{Varied::grains,    Varied::compression, Varied::shear,
                                       Varied::time_step, Varied::probe,       Varied::boundary};

[[nodiscard]] std::string_view name(Varied varied);

/// Boundary of a specimen.
enum class Boundary { periodic, smooth_walls, rough_walls };

[[nodiscard]] std::string_view name(Boundary boundary);

/// The values of each varied quantity, with the others at their defaults.
struct TradeScene {
  /// Grains, pressures, first seed and threads of the study, and its contact shape; scene.study.grains is the
  /// default of N, scene.study.seeds the number of specimens that have it.
  Scene scene;
  double compression_inertial_number = 5e-4;
  double shear_inertial_number = 2e-4;
  double time_step_fraction = dem::default_time_step_fraction;
  double shear_strain = 0.004; ///< axial strain at which a test ends: past the peak of dense specimens

  std::vector<std::size_t> grains{250, 500, 1000, 2000};
  std::vector<double> compression{4e-3, 2e-3, 1e-3, 5e-4, 2.5e-4};
  std::vector<double> shear{5e-3, 2e-3, 1e-3, 5e-4, 2e-4, 1e-4};
  std::vector<double> time_step{1.0, 0.8, 0.4};
  std::vector<double> probe{1e-5, 1e-4, 1e-3, 1e-2, 1e-1};
  std::vector<std::size_t> walls{250};
};

/// The study of `granum trade` without options: spheres at 10, 20, 50 and 100 kPa, four seeds of 500 grains.
[[nodiscard]] TradeScene default_trade();
/// A minute's worth of it, and the whole of it, with up to 16,000 grains.
[[nodiscard]] TradeScene quick_trade();
[[nodiscard]] TradeScene full_trade();

/// \throws   InvalidArgument naming the value that no study can have; numbers of grains too few for the sizes
///           of the scene among them
void require_valid(const TradeScene& trade);

/// The same study with numbers of grains, also those between walls, that their sizes allow: the least number
/// (triaxial::least_grains) in place of all that are less.
[[nodiscard]] TradeScene with_enough_grains(TradeScene trade);

/// Specimens of N grains, so that every N has about as many grains in all as the default one; at least 2.
[[nodiscard]] std::size_t specimens_of(const TradeScene& trade, std::size_t grains);

/// One specimen with one value of one varied quantity.
struct TradeSample {
  Varied varied = Varied::grains;
  Boundary boundary = Boundary::periodic;
  double value = 0; ///< of the varied quantity; N for grains and boundary
  triaxial::Density density = triaxial::Density::dense;
  std::uint64_t seed = 0;
  /// At each pressure of the scene. Grains, compression, time step: isotropic projection of the network.
  /// Probe, boundary: mean of the planes that were probed. Shear: one, G_vh at a stress ratio of 0.8. [Pa]
  std::vector<double> shear_modulus;
  std::optional<double> exponent;   ///< s of these
  std::optional<double> peak_ratio; ///< largest q/p' in triaxial compression, dense specimens
  double cpu_seconds = 0;           ///< processor time of the parts that depend on it [s]
  std::size_t steps = 0;            ///< of them, minimiser's included
  std::string failure;              ///< why values are missing; empty where none are
};

/// The scene without the largest of its grains, until the predicted wall time of the
/// study within a budget [s]; two sizes stay.
/// \param    seconds_per_grain_step  of the engine: measured_speed() of plan.hpp [s]
/// \throws   InvalidArgument with the budget that the smallest two sizes need
[[nodiscard]] TradeScene within_budget(TradeScene trade, double seconds, double seconds_per_grain_step);

/// Runs all studies. Samples that need the same run share it. Specimens run side by side; the numbers, but
/// for the times, are the same bits for any number of threads.
/// \return   samples in the order varied, boundary, value, density, seed
/// \throws   InvalidArgument for an impossible scene
/// Checked by tests/studies/test_trade.cpp
[[nodiscard]] std::vector<TradeSample> run_trade(const TradeScene& trade, const RunControl& control = {});

} // namespace granum::studies

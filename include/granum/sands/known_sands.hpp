// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <string_view>

/// Sands that are often used in laboratories.
namespace granum::sands {

/// Fit to the tests of one sand: G = level F^power at 100 kPa, F = (2.17-e)^2/(1+e), and its exponent.
struct SandTests {
  double level = 0;      ///< [Pa]
  double power = 0;      ///< of F [1]
  double exponent = 0;   ///< s of G ~ p^s [1]
  std::size_t count = 0; ///< of tests
  double void_ratio_low = 0, void_ratio_high = 0;

  bool operator==(const SandTests&) const = default;
};

/// Properties of a sand, as far as its sources state them. Batches of one name differ.
struct KnownSand {
  const char* key;                               ///< on a command line
  const char* name;                              ///< for people
  const char* source;                            ///< entries of validation/references.bib
  const char* mineral;                           ///< key of contact::mineral
  std::optional<double> d50 = {};                ///< [m]
  std::optional<double> uniformity = {};         ///< C_u [1]
  std::optional<double> least_void_ratio = {};   ///< e_min [1]
  std::optional<double> largest_void_ratio = {}; ///< e_max [1]
  std::optional<SandTests> tests = {};           ///< of resonant columns and bender elements
};

/// Toyoura, Ottawa F-65, Ottawa 20-30, Hostun, Ticino, Nevada and Longstone sand. The tests are taken from
/// [Lo2021], whose table names no sands: they are identified by their limits of the void ratio.
/// [CubrinovskiIshihara2002; YangSze2011; CareyStoneKutter2020; Azeiteiro2017; Fioravante2015]
/// [Arulmoli1992; Tsomokos2010; Lo2021]
[[nodiscard]] std::span<const KnownSand> known_sands();
/// The one of that key.
/// \throws   InvalidArgument for an unknown key; the message lists the known ones
/// Checked by tests/sands/test_known_sands.cpp
[[nodiscard]] const KnownSand& known_sand(std::string_view key);

/// Refuses limits that no soil has: those of well graded gravels differ by 0.15, those of glass beads also.
/// \throws   InvalidArgument unless e_min >= 0.1, e_max <= 5 and e_max - e_min >= 0.05
/// Checked by tests/sands/test_known_sands.cpp
void require_void_ratio_limits(double least, double largest);

/// e of a relative density D_r, e_max - D_r (e_max - e_min).
/// \param    relative_density     D_r, in [0, 1.2]; above 1 if the sand is denser than at e_min [1]
/// \throws   InvalidArgument outside of this range, and as require_void_ratio_limits
/// Accuracy  2 ulp of e_max.  Checked by tests/sands/test_known_sands.cpp
[[nodiscard]] double void_ratio_of_relative_density(double relative_density, double least_void_ratio,
                                                    double largest_void_ratio);

} // namespace granum::sands

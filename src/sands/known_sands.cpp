// SPDX-License-Identifier: GPL-3.0-or-later
#include <granum/sands/known_sands.hpp>

#include <array>
#include <string>
#include <vector>

#include <granum/core/error.hpp>
#include <granum/core/text.hpp>

#include "constants.hpp"

namespace granum::sands {

namespace {

const std::array<KnownSand, 7> table{{
    {.key = "toyoura",
     .name = "Toyoura sand",
     .source = "CubrinovskiIshihara2002; YangSze2011",
     .mineral = "quartz",
     .d50 = 0.20 * mm,
     .uniformity = 1.39,
     .least_void_ratio = 0.616,
     .largest_void_ratio = 0.988,
     .tests = SandTests{94.8 * MPa, 1.09, 0.395, 25, 0.70, 0.93}},
    // Densities of 1754 and 1457 kg/m3, of grains of 2650.
    {.key = "ottawa",
     .name = "Ottawa F-65 sand",
     .source = "CareyStoneKutter2020",
     .mineral = "quartz",
     .d50 = 0.20 * mm,
     .least_void_ratio = 0.511,
     .largest_void_ratio = 0.819},
    {.key = "ottawa-20-30",
     .name = "Ottawa 20-30 sand",
     .source = "Lo2021",
     .mineral = "quartz",
     .d50 = 0.619 * mm,
     .uniformity = 1.46,
     .least_void_ratio = 0.502,
     .largest_void_ratio = 0.742,
     .tests = SandTests{51.9 * MPa, 1.19, 0.426, 18, 0.52, 0.67}},
    {.key = "hostun",
     .name = "Hostun sand",
     .source = "Azeiteiro2017; Lo2021",
     .mineral = "quartz",
     .d50 = 0.33 * mm,
     .uniformity = 1.40,
     .least_void_ratio = 0.660,
     .largest_void_ratio = 1.000,
     .tests = SandTests{76.5 * MPa, 0.75, 0.484, 20, 0.66, 0.79}},
    {.key = "ticino",
     .name = "Ticino sand",
     .source = "Fioravante2015",
     .mineral = "quartz",
     .least_void_ratio = 0.574,
     .largest_void_ratio = 0.923},
    {.key = "nevada",
     .name = "Nevada sand",
     .source = "Arulmoli1992",
     .mineral = "quartz",
     .least_void_ratio = 0.516,
     .largest_void_ratio = 0.894},
    {.key = "longstone",
     .name = "Longstone sand",
     .source = "Tsomokos2010",
     .mineral = "quartz",
     .d50 = 0.15 * mm,
     .uniformity = 1.4,
     .least_void_ratio = 0.614,
     .largest_void_ratio = 0.995},
}};

} // namespace

std::span<const KnownSand> known_sands() { return table; }

const KnownSand& known_sand(std::string_view key) {
  std::vector<std::string> known;
  for (const KnownSand& sand : table) {
    if (same_word(key, sand.key))
      return sand;
    known.emplace_back(sand.key);
  }
  throw InvalidArgument(unknown_word("sand", key, known));
}

void require_void_ratio_limits(double least, double largest) {
  constexpr double densest = 0.1, loosest = 5, least_distance = 0.05;
  require_closed("least_void_ratio", least, densest, loosest - least_distance);
  constexpr double rounding = 1e-9;
  if (!(largest >= least + least_distance - rounding && largest <= loosest))
    throw InvalidArgument("largest_void_ratio", largest, "",
                          detail::closed_range(least + least_distance, loosest, largest) +
                              ": e_max is larger than e_min, " + short_text(least) + ", by " +
                              short_text(least_distance) + " at least");
}

double void_ratio_of_relative_density(double relative_density, double least, double largest) {
  require_closed("relative_density", relative_density, 0, 1.2);
  require_void_ratio_limits(least, largest);
  return require_positive("void_ratio", largest - relative_density * (largest - least));
}

} // namespace granum::sands

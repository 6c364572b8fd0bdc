// SPDX-License-Identifier: GPL-3.0-or-later
#include <granum/hardin/known_sands.hpp>

#include <array>
#include <string>
#include <vector>

#include <granum/core/check.hpp>
#include <granum/core/error.hpp>
#include <granum/core/near_miss.hpp>

namespace granum::hardin {

namespace {

constexpr double mm = 1e-3;

const std::array<KnownSand, 6> table{{
    {.key = "toyoura",
     .name = "Toyoura sand",
     .source = "CubrinovskiIshihara2002; YangSze2011",
     .mineral = "quartz",
     .d50 = 0.20 * mm,
     .least_void_ratio = 0.616,
     .largest_void_ratio = 0.988},
    // Densities of 1754 and 1457 kg/m3, of grains of 2650.
    {.key = "ottawa",
     .name = "Ottawa F-65 sand",
     .source = "CareyStoneKutter2020",
     .mineral = "quartz",
     .d50 = 0.20 * mm,
     .least_void_ratio = 0.511,
     .largest_void_ratio = 0.819},
    {.key = "hostun",
     .name = "Hostun sand",
     .source = "Azeiteiro2017",
     .mineral = "quartz",
     .d50 = 0.33 * mm},
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
    if (key == sand.key)
      return sand;
    known.emplace_back(sand.key);
  }
  throw InvalidArgument(unknown_word("sand", key, known));
}

double void_ratio_of_relative_density(double relative_density, double least, double largest) {
  require_closed("relative_density", relative_density, 0, 1.2);
  require_positive("least_void_ratio", least);
  require_positive("largest_void_ratio - least_void_ratio", largest - least);
  return require_positive("void_ratio", largest - relative_density * (largest - least));
}

} // namespace granum::hardin

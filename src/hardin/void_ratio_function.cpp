// SPDX-License-Identifier: GPL-3.0-or-later
#include <granum/hardin/void_ratio_function.hpp>

#include <cmath>
#include <limits>

#include <granum/core/error.hpp>
#include <granum/sands/measured_sands.hpp>

namespace granum::hardin {

double void_ratio_value(VoidRatioFunction function, double void_ratio) {
  const double e = require_positive("void_ratio", void_ratio);
  switch (function) {
  case VoidRatioFunction::hardin_richart_round:
    return sands::hardin_richart_factor(2.17, e);
  case VoidRatioFunction::hardin_richart_angular:
    return sands::hardin_richart_factor(2.97, e);
  case VoidRatioFunction::power_1_3:
    return std::pow(e, -1.3);
  case VoidRatioFunction::hardin_blandford:
    return 1 / (0.3 + 0.7 * e * e);
  case VoidRatioFunction::none:
    return 1;
  }
  throw InvalidArgument("void-ratio function is not one of the known ones");
}

std::string_view name(VoidRatioFunction function) {
  switch (function) {
  case VoidRatioFunction::hardin_richart_round:
    return "hardin-richart-round";
  case VoidRatioFunction::hardin_richart_angular:
    return "hardin-richart-angular";
  case VoidRatioFunction::power_1_3:
    return "power-1.3";
  case VoidRatioFunction::hardin_blandford:
    return "hardin-blandford";
  case VoidRatioFunction::none:
    return "none";
  }
  throw InvalidArgument("void-ratio function is not one of the known ones");
}

std::vector<VoidRatioFunction> all_void_ratio_functions() {
  return {VoidRatioFunction::hardin_richart_round, VoidRatioFunction::hardin_richart_angular,
          VoidRatioFunction::power_1_3, VoidRatioFunction::hardin_blandford, VoidRatioFunction::none};
}

VoidRatioFunction void_ratio_function(std::string_view wanted) {
  std::string known;
  for (const VoidRatioFunction function : all_void_ratio_functions()) {
    if (name(function) == wanted)
      return function;
    known += (known.empty() ? "" : ", ") + std::string(name(function));
  }
  throw InvalidArgument("void-ratio function '" + std::string(wanted) + "' is unknown; known are " + known);
}

} // namespace granum::hardin

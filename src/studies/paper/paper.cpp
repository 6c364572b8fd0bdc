// SPDX-License-Identifier: GPL-3.0-or-later
#include "studies/paper/paper.hpp"

namespace granum::studies {

std::optional<PrintedSpecimen> printed(contact::Shape contact, triaxial::Density density) {
  const bool dense = density == triaxial::Density::dense;
  constexpr auto none = std::nullopt;
  if (contact == contact::Shape::cone)
    return dense ? PrintedSpecimen{5.90,
                                   0.555,
                                   {26.8, 26.7, 29.2, 29.2},
                                   {none, none, 0.475, 21.03},
                                   {0.273, 0.237, 0.510, 21.45},
                                   {0.234, 0.275, 0.509, 21.43}}
                 : PrintedSpecimen{3.91,
                                   0.567,
                                   {27.2, 27.1, 29.4, 30.6},
                                   {none, none, 0.662, 12.99},
                                   {0.322, 0.353, 0.677, 13.31},
                                   {0.354, 0.325, 0.679, 13.32}};
  if (contact == contact::Shape::sphere)
    return dense ? PrintedSpecimen{5.73,
                                   0.558,
                                   {26.0, 25.7, 28.0, 28.5},
                                   {none, none, 0.361, 71.95},
                                   {0.189, 0.160, 0.349, 73.74},
                                   {0.162, 0.190, 0.352, 73.75}}
                 : PrintedSpecimen{3.50,
                                   0.572,
                                   {26.1, 25.8, 28.3, 30.0},
                                   {none, none, 0.551, 29.92},
                                   {0.176, 0.357, 0.533, 29.59},
                                   {0.345, 0.189, 0.534, 29.56}};
  if (contact == contact::Shape::flat)
    return dense ? PrintedSpecimen{5.62,
                                   0.559,
                                   {26.2, 25.9, 28.0, 29.0},
                                   {none, none, 0.020, 99.20},
                                   {0.013, 0.012, 0.025, 100.8},
                                   {0.013, 0.013, 0.026, 100.9}}
                 : PrintedSpecimen{3.53,
                                   0.572,
                                   {26.5, 25.9, 27.3, 28.6},
                                   {none, none, 0.271, 31.36},
                                   {0.058, 0.188, 0.245, 34.11},
                                   {0.180, 0.064, 0.244, 34.07}};
  return std::nullopt;
}

} // namespace granum::studies

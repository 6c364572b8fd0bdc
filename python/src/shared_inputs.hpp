// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <map>
#include <string>

#include <granum/inverse/inference.hpp>

/// Errors common to all measurements, given by the names of arguments.
namespace granum::python {

/// \param    deviations         standard deviations by the names of infer()'s arguments and of the grains'
/// \param    first              state of the first measurement: positive numbers are changed by a share of
///                              their value
/// \param    grain_density      [kg/m3]
/// \param    tangential_ratio   whether it was given; else it follows from Poisson's ratio
/// \throws   InvalidArgument for a name that is not an input of all measurements, or a negative deviation
[[nodiscard]] inverse::SharedInputs shared_inputs(const std::map<std::string, double>& deviations,
                                                  const effective::State& first, double grain_density,
                                                  bool tangential_ratio);

} // namespace granum::python

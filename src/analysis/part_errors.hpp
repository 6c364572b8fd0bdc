// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>

#include <granum/analysis/measurement.hpp>

namespace granum::analysis {

/// Adds to the errors of rung 3 of an interior how far it may be from the whole packing of `grains` grains,
/// to which the network belongs: a part of n grains has another z*, by 1.5/sqrt(n), and another density and
/// stress (validation/interior).
/// Checked by tests/analysis/test_measure.cpp
void add_errors_of_part(Measurement& measurement, std::size_t grains);

} // namespace granum::analysis

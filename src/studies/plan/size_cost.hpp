// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "studies/scene/scene.hpp"

namespace granum::studies {

/// Additional cost of the scene's grain sizes compared with equal ones, in a sentence or two; empty if the
/// largest radius is 5 times the smallest, or less. As measured in bench/README.md.
/// Checked by tests/studies/test_size_cost.cpp
[[nodiscard]] std::string cost_of_sizes(const Scene& scene);

} // namespace granum::studies

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "rows.hpp"
#include "shared_keywords.hpp"

/// What functions of isotropic packings and paths have in common.
namespace granum::python {

struct ModuliRow {
  double bulk_modulus = nan;
  double shear_modulus = nan;
};

struct AxialStressRow {
  double v = nan;
  double h = nan;
};

inline constexpr const char* refused_numbers = "For impossible numbers; with arrays only under strict.";

/// Keywords of a packing of equal spheres: the grains' material, porosity and coordination number.
[[nodiscard]] std::vector<Keyword> equal_spheres();
[[nodiscard]] Keyword no_slip_keyword();

} // namespace granum::python

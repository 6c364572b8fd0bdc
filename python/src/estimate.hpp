// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <limits>

#include <granum/effective/rungs.hpp>

#include "rows.hpp"

/// Stiffnesses of packings with their standard errors, returned by closed forms.
namespace granum::python {

struct StiffnessRow {
  static constexpr double nan = std::numeric_limits<double>::quiet_NaN();

  elastic::TransverselyIsotropic stiffness{nan, nan, nan, nan, nan};
  effective::ModulusErrors error{nan, nan, nan};
};

struct Stiffnesses : Rows<StiffnessRow> {
  bool has_error = false;
};

/// The answer of one rung as an object of Python.
[[nodiscard]] py::object estimate_object(const effective::RungAnswer& answer);
/// Stiffnesses without errors as one.
[[nodiscard]] py::object estimate_object(Rows<StiffnessRow> rows);

} // namespace granum::python

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <limits>

#include "rows.hpp"

/// Moduli and stresses of isotropic packings and paths, returned by several functions.
namespace granum::python {

struct ModuliRow {
  double bulk_modulus = std::numeric_limits<double>::quiet_NaN();
  double shear_modulus = std::numeric_limits<double>::quiet_NaN();
};

struct AxialStressRow {
  double v = std::numeric_limits<double>::quiet_NaN();
  double h = std::numeric_limits<double>::quiet_NaN();
};

/// Moduli of a function that computes only the shear modulus.
/// \param    shear_modulus   function of the numbers of an element, and notes
template <class Model>
py::object moduli_of_shear(std::span<const Argument> columns, bool strict, const Model& shear_modulus) {
  return py::cast(answer_rows(columns, strict, ModuliRow{}, [&](const double* x, Notes& notes) {
    ModuliRow row;
    row.shear_modulus = shear_modulus(x, notes);
    return row;
  }));
}

} // namespace granum::python

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <pybind11/pybind11.h>

/// The Python module: one function per module of the library, each in the source of that name.
namespace granum::python {

namespace py = pybind11;

void bind_errors(py::module_& module);
void bind_contact(py::module_& module);
void bind_sizes(py::module_& module);
void bind_fabric(py::module_& module);
void bind_elastic(py::module_& module);
void bind_effective(py::module_& module);
void bind_batch(py::module_& module);
void bind_sensitivity(py::module_& module);
void bind_contact_prior(py::module_& module);
void bind_packing_answer(py::module_& module);
void bind_inverse(py::module_& module);
void bind_rock_physics(py::module_& module);
void bind_uniaxial(py::module_& module);
void bind_ground(py::module_& module);
void bind_sands(py::module_& module);
void bind_hardin(py::module_& module);
void bind_packing(py::module_& module);
void bind_io(py::module_& module);
void bind_analysis(py::module_& module);
void bind_measure(py::module_& module);
void bind_triaxial(py::module_& module);
void bind_studies(py::module_& module);

} // namespace granum::python

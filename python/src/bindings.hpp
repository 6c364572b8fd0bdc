// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <pybind11/pybind11.h>

/// The Python module: one function per module of the library, each in the source of that name.
namespace granum::python {

namespace py = pybind11;

using Binding = void(py::module_& module);
Binding bind_errors, bind_contact, bind_sizes, bind_fabric, bind_elastic, bind_effective, bind_batch,
    bind_sensitivity, bind_contact_prior, bind_packing_answer, bind_inverse, bind_rock_physics, bind_ground,
    bind_sands, bind_hardin, bind_packing, bind_io, bind_paraview, bind_analysis, bind_measure,
    bind_network_matrix, bind_triaxial, bind_studies;

} // namespace granum::python

// SPDX-License-Identifier: GPL-3.0-or-later
#include <pybind11/pybind11.h>
#include <pybind11/stl.h>

#include <string>

#include <granum/core/version.hpp>

#include "bindings.hpp"
#include "examples.hpp"

PYBIND11_MODULE(_granum, module) {
  using namespace granum::python;
  module.doc() = "The library granum; import granum instead.";
  module.attr("__version__") = std::string(granum::version());
  Binding* const in_order[] = {
      &bind_errors,         &bind_contact,      &bind_sizes,       &bind_fabric,        &bind_elastic,
      &bind_effective,      &bind_batch,        &bind_sensitivity, &bind_contact_prior, &bind_packing_answer,
      &bind_inverse,        &bind_rock_physics, &bind_ground,      &bind_sands,         &bind_hardin,
      &bind_packing,        &bind_io,           &bind_paraview,    &bind_analysis,      &bind_measure,
      &bind_network_matrix, &bind_triaxial,     &bind_studies};
  for (Binding* const bind : in_order)
    bind(module);
  module.attr("_examples") = examples(); // of classes, and of what is written in Python
}

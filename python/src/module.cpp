// SPDX-License-Identifier: GPL-3.0-or-later
#include <pybind11/pybind11.h>

#include <string>

#include <granum/core/version.hpp>

#include "bindings.hpp"

PYBIND11_MODULE(_granum, module) {
  using namespace granum::python;
  module.doc() = "The library granum; import granum instead.";
  module.attr("__version__") = std::string(granum::version());
  bind_errors(module);
  bind_contact(module);
  bind_sizes(module);
  bind_fabric(module);
  bind_elastic(module);
  bind_effective(module);
  bind_batch(module);
  bind_sensitivity(module);
  bind_contact_prior(module);
  bind_packing_answer(module);
  bind_inverse(module);
  bind_rock_physics(module);
  bind_uniaxial(module);
  bind_ground(module);
  bind_sands(module);
  bind_hardin(module);
  bind_packing(module);
  bind_io(module);
  bind_analysis(module);
  bind_measure(module);
  bind_triaxial(module);
  bind_studies(module);
}

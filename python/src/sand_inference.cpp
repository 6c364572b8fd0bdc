// SPDX-License-Identifier: GPL-3.0-or-later
#include <pybind11/pybind11.h>
#include <pybind11/stl.h>

#include <utility>

#include "errors.hpp"
#include "inverse.hpp"
#include "range.hpp"

namespace granum::python {

namespace {

using estimate::Field;
using inverse::SandInference;

/// What was found, with the state that predictions begin from.
struct Sand {
  SandInference found;
  effective::State first;
};

RangeView sand_contacts(const Sand& sand, Field field) {
  const estimate::Range range = sand.found.contacts(field, sand.first);
  return {py::float_(range.value), py::float_(range.low), py::float_(range.high)};
}

py::object predict_sand(const Arguments& a) {
  const auto& sand = a.as<const Sand&>(0);
  const inverse::Quantity asked = inverse::quantity_of(a.text(1));
  return predicted_rows(
      a, sand.first, [&](double) { return sand.first.void_ratio; },
      [&](const effective::State& at, std::optional<double> saturation, Notes& notes) {
        notes.add(sand.found.doubts(at));
        return sand.found.predict(asked, at, saturation);
      });
}

void bind_numbers(py::class_<Sand>& type) {
  type.def_property_readonly(
          "level", [](const Sand& s) { return s.found.level(); },
          "G of this sand over that of the pooled law of sands, or of the named sand [1].")
      .def_property_readonly(
          "stress_exponent", [](const Sand& s) { return s.found.exponent(); },
          "s of G ~ p^s, from 50 kPa on [1].")
      .def_property_readonly(
          "poisson_ratio", [](const Sand& s) { return s.found.poisson_ratio(); },
          "Of the dry or drained sand at the first measurement [1].")
      .def_property_readonly(
          "mechanical_coordination_number",
          [](const Sand& s) { return sand_contacts(s, Field::mechanical_coordination_number); },
          "z* that G and Poisson's ratio imply at the first measurement [1].")
      .def_property_readonly(
          "contact_softness", [](const Sand& s) { return sand_contacts(s, Field::contact_softness); },
          "k/k_H, contact stiffness over that of smooth spheres, which they imply there [1].")
      .def_property_readonly(
          "tells_contacts", [](const Sand& s) { return s.found.tells_contacts(); },
          "Whether the measurements determine Poisson's ratio, and with it contacts: V_p beside V_s, K "
          "beside G.")
      .def_property_readonly(
          "pressure", [](const Sand& s) { return s.first.mean_stress(); },
          "Mean stress of the first measurement [Pa].")
      .def_property_readonly(
          "fitted", [](const Sand& s) { return fitted_values(s.found.measurements()); },
          "Each measurement as all of them together have it [Pa or m/s].")
      .def_property_readonly(
          "deviations", [](const Sand& s) { return deviations(s.found.measurements()); },
          "ln of measured over fitted, in standard errors, of each measurement.")
      .def_property_readonly(
          "chi_square", [](const Sand& s) { return s.found.chi_square(); }, "Sum of squared deviations.")
      .def_property_readonly(
          "degrees_of_freedom", [](const Sand& s) { return s.found.degrees_of_freedom(); },
          "How many of them are free.")
      .def_property_readonly(
          "probability", [](const Sand& s) { return s.found.probability(); },
          "That errors as stated make chi_square so large.")
      .def_property_readonly(
          "widening", [](const Sand& s) { return s.found.widening(); },
          "By how much errors are larger than stated, because measurements contradict one another; else 1.")
      .def_property_readonly(
          "notes", [](const Sand& s) { return s.found.validity().notes; },
          "What contradicts, and what it may be, a sentence each.");
}

} // namespace

py::object sand_inference(const std::vector<inverse::Observation>& measurements,
                          const estimate::Question& sand, inverse::SandGrowth growth) {
  const auto infer = [&] {
    const Unlocked unlocked;
    return inverse::infer_sand(measurements, sand, growth);
  };
  return py::cast(Sand{infer(), measurements.front().state});
}

void bind_sand_inference(py::module_& module) {
  py::class_<Sand> type(
      module, "SandInference",
      "What measurements say of a sand: its level, how it grows with stress, Poisson's ratio.",
      py::dynamic_attr());
  bind_numbers(type);
  define_method(
      type, "predict", predict_keywords("that of the first measurement"),
      {.summary = "A quantity of the sand at other stresses, with its standard error.\n\nFrom one "
                  "measurement the standard deviation of ln G is sqrt(0.04^2 + (0.045 ln(p/p_0))^2 + "
                  "measurement^2), half of that for a\nspeed; measurements that contradict one another "
                  "make it larger.",
       .returns = "MeasuredRows",
       .refuses = "For another quantity, a wave speed without grain_density, a compression wave in wet "
                  "pores."},
      &predict_sand, 1);
  type.def("__repr__", [](const Sand& s) {
    const auto number = [](const Measured& m) {
      return std::string(py::str("{:.3f} +- {:.3f}").format(m.value, m.standard_error));
    };
    return "SandInference(level=" + number(s.found.level()) +
           ", stress_exponent=" + number(s.found.exponent()) +
           ", poisson_ratio=" + number(s.found.poisson_ratio()) + ")";
  });
}

} // namespace granum::python

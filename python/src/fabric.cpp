// SPDX-License-Identifier: GPL-3.0-or-later
#include <pybind11/pybind11.h>
#include <pybind11/stl.h>

#include <granum/fabric/anisotropy_estimate.hpp>
#include <granum/fabric/goodness_of_fit.hpp>
#include <granum/fabric/likelihood_estimate.hpp>
#include <granum/fabric/measures.hpp>
#include <granum/fabric/orientation.hpp>
#include <granum/fabric/polar_distribution.hpp>
#include <granum/fabric/rose.hpp>
#include <granum/fabric/sampling.hpp>

#include "bindings.hpp"
#include "rows.hpp"

namespace granum::python {

namespace {

using fabric::AnisotropyEstimate;
using fabric::FabricMeasures;

/// A function of two numbers, for every element of arrays; the first that is refused raises.
py::object map_two(const char* first, const py::object& x, const char* second, const py::object& y,
                   double (*f)(double, double)) {
  const Argument arguments[] = {{first, x}, {second, y}};
  return computed(
      answer_rows<double>(arguments, true, 0.0, [f](const double* v, Notes&) { return f(v[0], v[1]); }),
      [](double value) { return value; });
}

void bind_density(py::module_& module) {
  module.def(
      "fabric_density",
      [](const py::object& angle, const py::object& a) {
        return map_two("polar_angle", angle, "anisotropy", a, fabric::density);
      },
      py::kw_only(), py::arg("polar_angle"), py::arg("anisotropy"),
      "E(gamma; a), contact normals per solid angle [1/sr], at angles from axis 3 [rad]; a in [-1, 1].");
  module.def(
      "fabric_cumulative_probability",
      [](const py::object& cosine, const py::object& a) {
        return map_two("polar_cosine", cosine, "anisotropy", a, fabric::cumulative_probability);
      },
      py::kw_only(), py::arg("polar_cosine"), py::arg("anisotropy"),
      "Share of contacts with |n3| not above the polar cosine [1]; a in [-1, 1].");
  module.def(
      "fabric_polar_cosine_quantile",
      [](const py::object& probability, const py::object& a) {
        return map_two("probability", probability, "anisotropy", a, fabric::polar_cosine_quantile);
      },
      py::kw_only(), py::arg("probability"), py::arg("anisotropy"),
      "The polar cosine of a probability: the inverse of fabric_cumulative_probability.");
  module.def(
      "sample_normals",
      [](double anisotropy, std::size_t count, std::uint64_t seed) {
        const std::vector<Vec3> normals = fabric::sample_normals(anisotropy, count, seed);
        py::array_t<double> out(std::vector<py::ssize_t>{static_cast<py::ssize_t>(count), 3});
        if (count > 0)
          std::copy_n(&normals.front().x, 3 * count, out.mutable_data());
        return out;
      },
      py::kw_only(), py::arg("anisotropy"), py::arg("count"), py::arg("seed"),
      "Unit vectors drawn from E(gamma; a), (count, 3); one seed, one sample.");
}

void bind_measures(py::module_& module) {
  py::class_<FabricMeasures>(module, "FabricMeasures",
                             "One axisymmetric fabric in the notations that are in use.")
      .def_readonly("anisotropy", &FabricMeasures::anisotropy, "a of E(gamma; a) [1].")
      .def_readonly("F11", &FabricMeasures::F11, "Mean of n1^2 [1].")
      .def_readonly("F33", &FabricMeasures::F33, "Mean of n3^2 [1].")
      .def_readonly("P2_coefficient", &FabricMeasures::P2_coefficient,
                    "a_c of (1 + a_c P2(cos gamma))/(4 pi) [1].")
      .def_readonly("mean_cos_2gamma", &FabricMeasures::mean_cos_2gamma, "2 F33 - 1 [1].")
      .def_property_readonly("notes", [](const FabricMeasures& m) { return m.validity.notes; });
  static constexpr struct {
    const char* name;
    FabricMeasures (*make)(double);
  } makers[] = {{"anisotropy", fabric::measures_from_anisotropy},
                {"F33", fabric::measures_from_F33},
                {"P2_coefficient", fabric::measures_from_P2_coefficient},
                {"mean_cos_2gamma", fabric::measures_from_mean_cos_2gamma}};
  module.def(
      "fabric_measures",
      [](const py::kwargs& known) {
        for (const auto& [name, make] : makers)
          if (known.size() == 1 && known.contains(name))
            return make(number_of(name, known[name]));
        throw py::type_error(
            "fabric_measures() takes one of anisotropy, F33, P2_coefficient, mean_cos_2gamma");
      },
      "A fabric from one of its measures: anisotropy, F33, P2_coefficient or mean_cos_2gamma.");
}

void bind_estimates(py::module_& module) {
  using fabric::LikelihoodEstimate;
  py::class_<AnisotropyEstimate>(module, "AnisotropyEstimate",
                                 "a of E(gamma; a) from contact normals, by F33.")
      .def_readonly("anisotropy", &AnisotropyEstimate::anisotropy, "[1]")
      .def_readonly("standard_error", &AnisotropyEstimate::standard_error, "For independent contacts [1].")
      .def_readonly("F33", &AnisotropyEstimate::F33, "Mean of n3^2 [1].")
      .def_readonly("contacts", &AnisotropyEstimate::contacts)
      .def_property_readonly("notes", [](const AnisotropyEstimate& e) { return e.validity.notes; });
  py::class_<LikelihoodEstimate>(module, "LikelihoodEstimate", "a of E(gamma; a) by maximum likelihood.")
      .def_readonly("anisotropy", &LikelihoodEstimate::anisotropy, "In [-1, 1].")
      .def_readonly("standard_error", &LikelihoodEstimate::standard_error, "[1]")
      .def_readonly("log_likelihood_gain", &LikelihoodEstimate::log_likelihood_gain,
                    "What a explains beyond isotropy.")
      .def_readonly("at_boundary", &LikelihoodEstimate::at_boundary)
      .def_readonly("contacts", &LikelihoodEstimate::contacts)
      .def_property_readonly("notes", [](const LikelihoodEstimate& e) { return e.validity.notes; });
  const auto normals = [](const py::object& value) { return vectors_of("normals", value); };
  module.def(
      "estimate_anisotropy", [=](const py::object& n) { return fabric::estimate_anisotropy(normals(n)); },
      py::arg("normals"), "a from the mean of n3^2 of unit vectors, (N, 3), N >= 2.");
  module.def(
      "estimate_anisotropy_by_likelihood",
      [=](const py::object& n) { return fabric::estimate_anisotropy_by_likelihood(normals(n)); },
      py::arg("normals"), "a that makes unit vectors most likely, (N, 3), N >= 2.");
  module.def(
      "isotropy_p_value", [=](const py::object& n) { return fabric::test_isotropy(normals(n)).p_value; },
      py::arg("normals"), "Chance of directions as uneven as these unit vectors, (N, 3), if all were alike.");
  module.def(
      "rose",
      [=](const py::object& n, double anisotropy, std::size_t bins) {
        return fabric::rose(normals(n), anisotropy, bins);
      },
      py::arg("normals"), py::kw_only(), py::arg("anisotropy"), py::arg("bins"),
      "Histogram of the angle between unit vectors, (N, 3), and axis 3, beside E(gamma; a).");
}

} // namespace

void bind_fabric(py::module_& module) {
  py::class_<fabric::RoseBin>(module, "RoseBin", "One bin of the angles between contact normals and axis 3.")
      .def_readonly("low", &fabric::RoseBin::low, "[rad]")
      .def_readonly("high", &fabric::RoseBin::high, "[rad]")
      .def_readonly("count", &fabric::RoseBin::count)
      .def_readonly("density", &fabric::RoseBin::density, "[1/sr]")
      .def_readonly("density_error", &fabric::RoseBin::density_error, "[1/sr]")
      .def_readonly("expected_density", &fabric::RoseBin::expected_density, "[1/sr]");
  bind_density(module);
  bind_measures(module);
  bind_estimates(module);
}

} // namespace granum::python

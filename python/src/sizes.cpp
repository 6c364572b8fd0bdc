// SPDX-License-Identifier: GPL-3.0-or-later
#include <pybind11/operators.h>
#include <pybind11/pybind11.h>
#include <pybind11/stl.h>

#include <granum/core/number.hpp>
#include <granum/sizes/contact_means.hpp>
#include <granum/sizes/distribution.hpp>
#include <granum/sizes/distribution_text.hpp>
#include <granum/sizes/sampling.hpp>

#include "arrays.hpp"
#include "bindings.hpp"
#include "docstrings.hpp"
#include "errors.hpp"

namespace granum::python {

namespace {

using sizes::ContactMeans;
using sizes::Distribution;

void bind_contact_means(py::module_& module) {
  py::class_<ContactMeans>(module, "ContactMeans",
                           "Means over the contacts of unequal grains, relative to equal grains of radius R.")
      .def(py::init([](double branch, double branch_square, double pair_radius, double grain_volume) {
             const ContactMeans means{branch, branch_square, pair_radius, grain_volume};
             sizes::require_valid(means);
             return means;
           }),
           py::kw_only(), py::arg("branch") = ContactMeans{}.branch,
           py::arg("branch_square") = ContactMeans{}.branch_square,
           py::arg("pair_radius") = ContactMeans{}.pair_radius,
           py::arg("grain_volume") = ContactMeans{}.grain_volume)
      .def_readonly("branch", &ContactMeans::branch, "<l>/(2R), l = R_i + R_j [1].")
      .def_readonly("branch_square", &ContactMeans::branch_square, "<l^2>/(4R^2) [1].")
      .def_readonly("pair_radius", &ContactMeans::pair_radius,
                    "2(<R*^(1/3) l^2>/<l^2>)^3/R, for the law that represents all pairs [1].")
      .def_readonly("grain_volume", &ContactMeans::grain_volume, "<V_g>/(4/3 pi R^3) [1].")
      .def("__repr__",
           [](const ContactMeans& m) {
             return "ContactMeans(branch=" + exact_text(m.branch) +
                    ", branch_square=" + exact_text(m.branch_square) +
                    ", pair_radius=" + exact_text(m.pair_radius) +
                    ", grain_volume=" + exact_text(m.grain_volume) + ")";
           })
      .def("with_reference", &sizes::with_reference, py::arg("scale"),
           "The same means referred to another radius, scale R.")
      .def(py::self == py::self);
  module.def(
      "expected_contact_means",
      [](const Distribution& sizes, double rattler_fraction) {
        return sizes::expected_contact_means(sizes, rattler_fraction);
      },
      py::arg("sizes"), py::kw_only(), py::arg("rattler_fraction") = 0.0,
      (R"(The means over contacts of a distribution of sizes.

Parameters
----------
sizes : Distribution
    Distribution of the radii over R, their mean by number.
rattler_fraction : float
    x_0 in [0, 1) over all grains [1]; rattlers are mostly small grains.

Returns
-------
ContactMeans
)" + raises_invalid("For a share of rattlers out of range.") +
       notes("The contacts of a grain are proportional to its surface; compared with packings of LAMMPS in "
             "validation/sizes. "
             "[Shaebani2012]",
             "sizes::expected_contact_means", "sizes/contact_means.hpp"))
          .c_str());
}

void bind_gradation(py::module_& module) {
  py::class_<sizes::Gradation>(module, "Gradation", "Characteristic diameters of a sieve analysis, by mass.")
      .def_readonly("d10", &sizes::Gradation::d10, "[m]")
      .def_readonly("d50", &sizes::Gradation::d50, "[m]")
      .def_readonly("d60", &sizes::Gradation::d60, "[m]")
      .def_property_readonly("uniformity", &sizes::Gradation::uniformity, "C_u = d60/d10 [1].");
  module.def(
      "gradation", [](const py::object& radii) { return sizes::gradation(list_of("radius", radii)); },
      py::arg("radius"),
      (R"(d10, d50 and d60 of grains, as in a sieve analysis.

Parameters
----------
radius : (N,) array_like
    Of each grain, > 0 [m].

Returns
-------
Gradation
)" + raises_invalid("For no radii, or one that is not positive.") +
       notes("The smallest diameters at which 10, 50 and 60 % of the mass is finer.", "sizes::gradation",
             "sizes/distribution.hpp"))
          .c_str());
}

} // namespace

void bind_sizes(py::module_& module) {
  bind_gradation(module);
  py::class_<Distribution>(module, "Distribution", "Radii of grains over their mean by number, x = r/<r>.")
      .def(py::init([](const std::string& text) { return sizes::parse_distribution(text); }), py::arg("text"),
           "A distribution from a text, as on the command line: \"lognormal:0.35\".")
      .def_property_readonly("text", &Distribution::text, "The text that defines it.")
      .def_property_readonly("mean_radius", &Distribution::mean_radius,
                             "Mean radius of a sieve curve [m]; else None.")
      .def_property_readonly("smallest", &Distribution::smallest, "Smallest x [1].")
      .def_property_readonly("largest", &Distribution::largest, "Largest x [1].")
      .def_property_readonly("size_ratio", &Distribution::size_ratio, "Largest over smallest radius [1].")
      .def("moment", &Distribution::moment, py::arg("k"), "<x^k> by number [1].")
      .def("share_below", &Distribution::share_below, py::arg("x"), py::arg("k") = 0.0,
           "Share of grains not above x, weighted by x^k [1]; k = 3: by mass.")
      .def("quantile", &Distribution::quantile, py::arg("share"), py::arg("k") = 0.0,
           "The inverse of share_below.")
      .def(
          "sample",
          [](const Distribution& sizes, std::size_t count, std::uint64_t seed) {
            const std::vector<double> radii =
                unlocked([&] { return sizes::sample_radii(sizes, count, seed); });
            return py::array_t<double>(static_cast<py::ssize_t>(radii.size()), radii.data());
          },
          py::kw_only(), py::arg("count"), py::arg("seed"), "Radii x of a number of grains, in random order.")
      .def(
          "gradation", [](const Distribution& sizes, double r) { return sizes::gradation(sizes, r); },
          py::kw_only(), py::arg("mean_radius"), "d10, d50 and d60 for a mean radius by number [m].")
      .def(
          "mean_radius_of",
          [](const Distribution& sizes, double d50) { return sizes::mean_radius_of(sizes, d50); },
          py::kw_only(), py::arg("d50"), "Mean radius by number of grains of this d50 [m].")
      .def(py::self == py::self)
      .def("__repr__", [](const Distribution& sizes) { return "Distribution(\"" + sizes.text() + "\")"; });
  bind_contact_means(module);
}

} // namespace granum::python

// SPDX-License-Identifier: GPL-3.0-or-later
#include <pybind11/operators.h>
#include <pybind11/pybind11.h>
#include <pybind11/stl.h>

#include <granum/core/text.hpp>
#include <granum/sizes/contact_means.hpp>
#include <granum/sizes/distribution.hpp>

#include "bindings.hpp"
#include "errors.hpp"
#include "members.hpp"
#include "shared_keywords.hpp"

namespace granum::python {

namespace {

using sizes::ContactMeans;
using sizes::Distribution;

void bind_contact_means(py::module_& module) {
  ResultClass<ContactMeans> type(
      module, "ContactMeans",
      "Means over the contacts of unequal grains, relative to equal grains of radius R.");
  type.def(py::init([](double branch, double branch_square, double pair_radius, double grain_volume) {
             const ContactMeans means{branch, branch_square, pair_radius, grain_volume};
             sizes::require_valid(means);
             return means;
           }),
           py::kw_only(), py::arg("branch") = ContactMeans{}.branch,
           py::arg("branch_square") = ContactMeans{}.branch_square,
           py::arg("pair_radius") = ContactMeans{}.pair_radius,
           py::arg("grain_volume") = ContactMeans{}.grain_volume)
      .def("__repr__",
           [](const ContactMeans& m) {
             return "ContactMeans(branch=" + exact_text(m.branch) +
                    ", branch_square=" + exact_text(m.branch_square) +
                    ", pair_radius=" + exact_text(m.pair_radius) +
                    ", grain_volume=" + exact_text(m.grain_volume) + ")";
           })
      .def(py::self == py::self);
  type.show("branch", "<l>/(2R), l = R_i + R_j [1].", &ContactMeans::branch)
      .show("branch_square", "<l^2>/(4R^2) [1].", &ContactMeans::branch_square)
      .show("pair_radius", "2(<R*^(1/3) l^2>/<l^2>)^3/R, for the law that represents all pairs [1].",
            &ContactMeans::pair_radius)
      .show("grain_volume", "<V_g>/(4/3 pi R^3) [1].", &ContactMeans::grain_volume);
  define_method(type, "with_reference", {required("scale", "float", "> 0 [1].")},
                {"The same means referred to another radius, scale R.", "ContactMeans"},
                &sizes::with_reference, 1);
  define(
      module, "expected_contact_means",
      {required("sizes", "Distribution", "Distribution of the radii over R, their mean by number."),
       of_input(estimate::Input::rattler_fraction, "float").or_number(0)},
      {"The means over contacts of a distribution of sizes.", "ContactMeans",
       "For a share of rattlers out of range.",
       "The contacts of a grain are proportional to its surface; compared with packings of LAMMPS in "
       "validation/sizes. [Shaebani2012]",
       "sizes::expected_contact_means", "sizes/contact_means.hpp"},
      [](const Distribution& sizes, double rattler_fraction) {
        return sizes::expected_contact_means(sizes, rattler_fraction);
      },
      1);
}

void bind_gradation(py::module_& module) {
  using sizes::Gradation;
  ResultClass<Gradation>(module, "Gradation", "Characteristic diameters of a sieve analysis, by mass.")
      .show("d10", "[m]", &Gradation::d10)
      .show("d50", "[m]", &Gradation::d50)
      .show("d60", "[m]", &Gradation::d60)
      .show("uniformity", "C_u = d60/d10 [1].", &Gradation::uniformity);
  define(
      module, "gradation", {required("radius", "(N,) array_like", "Of each grain, > 0 [m].")},
      {"d10, d50 and d60 of grains, as in a sieve analysis.", "Gradation",
       "For no radii, or one that is not positive.",
       "The smallest diameters at which 10, 50 and 60 % of the mass is finer.", "sizes::gradation",
       "sizes/distribution.hpp"},
      [](const std::vector<double>& radii) { return sizes::gradation(radii); }, 1);
}

void bind_distribution(py::module_& module) {
  ResultClass<Distribution> type(module, "Distribution",
                                 "Radii of grains over their mean by number, x = r/<r>.");
  type.def(py::init([](const std::string& text) { return sizes::parse_distribution(text); }), py::arg("text"),
           "A distribution from a text, as on the command line: \"lognormal:0.35\".")
      .def(py::self == py::self)
      .def("__repr__", [](const Distribution& sizes) { return "Distribution(\"" + sizes.text() + "\")"; });
  type.show("text", "The text that defines it.", &Distribution::text)
      .show("mean_radius", "Mean radius of a sieve curve [m]; else None.", &Distribution::mean_radius)
      .show("smallest", "Smallest x [1].", &Distribution::smallest)
      .show("largest", "Largest x [1].", &Distribution::largest)
      .show("size_ratio", "Largest over smallest radius [1].", &Distribution::size_ratio);
  const Keyword power = required("k", "float", "Power of x [1].");
  define_method(
      type, "moment", {power}, {"<x^k> by number [1].", "float"},
      [](const Distribution& d, double k) { return d.moment(k); }, 1);
  define_method(
      type, "share_below", {required("x", "float", "r/<r> [1]."), power.or_number(0)},
      {"Share of grains not above x, weighted by x^k [1]; k = 3: by mass.", "float"},
      [](const Distribution& d, double x, double k) { return d.share_below(x, k); }, 2);
  define_method(
      type, "quantile", {required("share", "float", "In [0, 1] [1]."), power.or_number(0)},
      {"The inverse of share_below.", "float"},
      [](const Distribution& d, double share, double k) { return d.quantile(share, k); }, 2);
  define_method(type, "sample",
                {required("count", "int", "Number of grains."),
                 required("seed", "int", "The same seed gives the same sample on every machine.")},
                {"Radii x of a number of grains, in random order.", "(N,) ndarray"},
                [](const Distribution& sizes, std::size_t count, std::uint64_t seed) {
                  return array_of(unlocked([&] { return sizes::sample_radii(sizes, count, seed); }));
                });
  define_method(type, "gradation", {required("mean_radius", "float", "By number, > 0 [m].")},
                {"d10, d50 and d60 for a mean radius.", "Gradation"},
                [](const Distribution& sizes, double radius) { return sizes::gradation(sizes, radius); });
  define_method(type, "mean_radius_of", {required("d50", "float", "Median diameter by mass, > 0 [m].")},
                {"Mean radius by number of grains of this d50 [m].", "float"},
                [](const Distribution& sizes, double d50) { return sizes::mean_radius_of(sizes, d50); });
}

} // namespace

void bind_sizes(py::module_& module) {
  bind_gradation(module);
  bind_distribution(module);
  bind_contact_means(module);
}

} // namespace granum::python

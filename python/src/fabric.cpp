// SPDX-License-Identifier: GPL-3.0-or-later
#include <pybind11/pybind11.h>
#include <pybind11/stl.h>

#include <iterator>

#include <granum/fabric/anisotropy_estimate.hpp>
#include <granum/fabric/goodness_of_fit.hpp>
#include <granum/fabric/likelihood_estimate.hpp>
#include <granum/fabric/measures.hpp>
#include <granum/fabric/orientation.hpp>
#include <granum/fabric/polar_distribution.hpp>
#include <granum/fabric/rose.hpp>
#include <granum/fabric/sampling.hpp>

#include "bindings.hpp"
#include "docstrings.hpp"
#include "rows.hpp"

namespace granum::python {

namespace {

using fabric::AnisotropyEstimate;
using fabric::FabricMeasures;

const std::string out_of_range =
    raises_invalid("For the first number out of range, or shapes that cannot be broadcast.");
const std::string refused_normals =
    raises_invalid("For too few vectors, or one whose length differs from 1 by more than 1e-6.");
const std::string normals_parameter = R"(
Parameters
----------
normals : (N, 3) array_like
    One unit vector per contact, in either sense [1].
)";

/// Applies a function of two numbers to every element of arrays; the first refused element raises.
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
      (R"(E(gamma; a), the density of contact normals per solid angle.

Parameters
----------
polar_angle : array_like
    gamma, from axis 3 [rad].
anisotropy : array_like
    a in [-1, 1] [1]; > 0: more contacts near the axis.

Returns
-------
float or ndarray
    3 (1 + a cos 2 gamma)/(4 pi (3 - a)) [1/sr], of the broadcast shape.
)" + out_of_range +
       notes("[Chung2014, Eq. 10]", "fabric::density", "fabric/orientation.hpp"))
          .c_str());
  module.def(
      "fabric_cumulative_probability",
      [](const py::object& cosine, const py::object& a) {
        return map_two("polar_cosine", cosine, "anisotropy", a, fabric::cumulative_probability);
      },
      py::kw_only(), py::arg("polar_cosine"), py::arg("anisotropy"),
      (R"(The share of contact normals at an angle from axis 3 that is at least the given one.

Parameters
----------
polar_cosine : array_like
    t of |n3| <= t, in [0, 1] [1].
anisotropy : array_like
    a in [-1, 1] [1].

Returns
-------
float or ndarray
    P(t) [1], of the broadcast shape.
)" + out_of_range +
       notes("The integral of fabric_density.", "fabric::cumulative_probability",
             "fabric/polar_distribution.hpp"))
          .c_str());
  module.def(
      "fabric_polar_cosine_quantile",
      [](const py::object& probability, const py::object& a) {
        return map_two("probability", probability, "anisotropy", a, fabric::polar_cosine_quantile);
      },
      py::kw_only(), py::arg("probability"), py::arg("anisotropy"),
      (R"(The polar cosine of a probability.

Parameters
----------
probability : array_like
    In [0, 1] [1].
anisotropy : array_like
    a in [-1, 1] [1].

Returns
-------
float or ndarray
    t with P(t) = probability [1], of the broadcast shape.
)" + out_of_range +
       notes("The inverse of fabric_cumulative_probability, with the same bits on every machine.",
             "fabric::polar_cosine_quantile", "fabric/polar_distribution.hpp"))
          .c_str());
  module.def(
      "sample_normals",
      [](double anisotropy, std::size_t count, std::uint64_t seed) {
        return array_of(unlocked([&] { return fabric::sample_normals(anisotropy, count, seed); }));
      },
      py::kw_only(), py::arg("anisotropy"), py::arg("count"), py::arg("seed"),
      (R"(Unit vectors drawn from E(gamma; a).

Parameters
----------
anisotropy : float
    a in [-1, 1] [1].
count : int
    Number of vectors.
seed : int
    The same seed gives the same sample on every machine.

Returns
-------
(count, 3) ndarray
    Unit vectors, in both senses [1].
)" + raises_invalid("For an anisotropy out of range.") +
       notes("Points in the unit disc. [Marsaglia1972]", "fabric::sample_normals", "fabric/sampling.hpp"))
          .c_str());
}

void bind_measures(py::module_& module) {
  py::class_<FabricMeasures>(module, "FabricMeasures", "An axisymmetric fabric in the usual notations.")
      .def_readonly("anisotropy", &FabricMeasures::anisotropy, "a of E(gamma; a) [1].")
      .def_readonly("F11", &FabricMeasures::F11, "Mean of n1^2 [1].")
      .def_readonly("F33", &FabricMeasures::F33, "Mean of n3^2 [1].")
      .def_readonly("P2_coefficient", &FabricMeasures::P2_coefficient,
                    "a_c of (1 + a_c P2(cos gamma))/(4 pi) [1].")
      .def_readonly("mean_cos_2gamma", &FabricMeasures::mean_cos_2gamma, "2 F33 - 1 [1].")
      .def_property_readonly(
          "notes", [](const FabricMeasures& m) { return m.validity.notes; },
          "Remarks on numbers outside the range of a formula, a sentence each.");
  static constexpr struct {
    const char* name;
    FabricMeasures (*make)(double);
  } makers[] = {{"anisotropy", fabric::measures_from_anisotropy},
                {"F33", fabric::measures_from_F33},
                {"P2_coefficient", fabric::measures_from_P2_coefficient},
                {"mean_cos_2gamma", fabric::measures_from_mean_cos_2gamma}};
  module.def(
      "fabric_measures",
      [](const py::object& anisotropy, const py::object& F33, const py::object& P2_coefficient,
         const py::object& mean_cos_2gamma) {
        const py::object* const given[] = {&anisotropy, &F33, &P2_coefficient, &mean_cos_2gamma};
        const auto is_given = [](const py::object* value) { return !value->is_none(); };
        if (std::count_if(std::begin(given), std::end(given), is_given) != 1)
          throw py::type_error(
              "fabric_measures() takes one of anisotropy, F33, P2_coefficient, mean_cos_2gamma");
        const auto at = std::find_if(std::begin(given), std::end(given), is_given) - std::begin(given);
        return makers[at].make(number_of(makers[at].name, *given[at]));
      },
      py::kw_only(), py::arg("anisotropy") = py::none(), py::arg("F33") = py::none(),
      py::arg("P2_coefficient") = py::none(), py::arg("mean_cos_2gamma") = py::none(),
      (R"(An axisymmetric fabric in all notations, from one of its measures.

Parameters
----------
anisotropy : float, optional
    a of E(gamma; a) [1].
F33 : float, optional
    Mean of n3^2 [1].
P2_coefficient : float, optional
    a_c of (1 + a_c P2(cos gamma))/(4 pi) [1].
mean_cos_2gamma : float, optional
    2 F33 - 1 [1].

Returns
-------
FabricMeasures

Raises
------
TypeError
    Unless exactly one of the four is given.
InvalidArgument
    For an impossible number.
)" + notes("[Kanatani1984]", "fabric::measures_from_anisotropy", "fabric/measures.hpp"))
          .c_str());
}

void bind_estimates(py::module_& module) {
  using fabric::LikelihoodEstimate;
  py::class_<AnisotropyEstimate>(module, "AnisotropyEstimate",
                                 "a of E(gamma; a) from contact normals, by F33.")
      .def_readonly("anisotropy", &AnisotropyEstimate::anisotropy, "[1]")
      .def_readonly("standard_error", &AnisotropyEstimate::standard_error, "For independent contacts [1].")
      .def_readonly("F33", &AnisotropyEstimate::F33, "Mean of n3^2 [1].")
      .def_readonly("contacts", &AnisotropyEstimate::contacts, "Number of contacts.")
      .def_property_readonly(
          "notes", [](const AnisotropyEstimate& e) { return e.validity.notes; },
          "Remarks on numbers outside the range of a formula, a sentence each.");
  py::class_<LikelihoodEstimate>(module, "LikelihoodEstimate", "a of E(gamma; a) by maximum likelihood.")
      .def_readonly("anisotropy", &LikelihoodEstimate::anisotropy, "In [-1, 1].")
      .def_readonly("standard_error", &LikelihoodEstimate::standard_error, "[1]")
      .def_readonly("log_likelihood_gain", &LikelihoodEstimate::log_likelihood_gain,
                    "Gain of log-likelihood over isotropy.")
      .def_readonly("at_boundary", &LikelihoodEstimate::at_boundary,
                    "Whether a is -1 or 1, the boundary, with the likelihood still rising.")
      .def_readonly("contacts", &LikelihoodEstimate::contacts, "Number of contacts.")
      .def_property_readonly(
          "notes", [](const LikelihoodEstimate& e) { return e.validity.notes; },
          "Remarks on numbers outside the range of a formula, a sentence each.");
  const auto of_normals = [](const py::object& value, const auto& function) {
    const std::vector<Vec3> normals = vectors_of("normals", value);
    return unlocked([&] { return function(normals); });
  };
  module.def(
      "estimate_anisotropy",
      [=](const py::object& n) {
        return of_normals(n, [](const auto& all) { return fabric::estimate_anisotropy(all); });
      },
      py::arg("normals"),
      (R"(a of E(gamma; a) from contact normals, by the mean of n3^2.
)" + normals_parameter +
       R"(
Returns
-------
AnisotropyEstimate
    With its standard error for independent contacts; contacts of a packing scatter less.
)" + refused_normals +
       notes("Axis 3 is the axis of symmetry.", "fabric::estimate_anisotropy",
             "fabric/anisotropy_estimate.hpp"))
          .c_str());
  module.def(
      "estimate_anisotropy_by_likelihood",
      [=](const py::object& n) {
        return of_normals(n, [](const auto& all) { return fabric::estimate_anisotropy_by_likelihood(all); });
      },
      py::arg("normals"),
      (R"(a of E(gamma; a) from contact normals, by maximum likelihood.
)" + normals_parameter +
       R"(
Returns
-------
LikelihoodEstimate
    a in [-1, 1], with its standard error from the observed information.
)" + refused_normals +
       notes("Scatters less than estimate_anisotropy, the more so the further a is from 0, but assumes "
             "E(gamma; a).",
             "fabric::estimate_anisotropy_by_likelihood", "fabric/likelihood_estimate.hpp"))
          .c_str());
  module.def(
      "isotropy_p_value",
      [=](const py::object& n) {
        return of_normals(n, [](const auto& all) { return fabric::test_isotropy(all).p_value; });
      },
      py::arg("normals"),
      (R"(p-value: probability of directions at least as uneven as these, if the true fabric is isotropic.
)" + normals_parameter +
       R"(
Returns
-------
float
    p of (F33 - 1/3)/sqrt(4/(45 N)), either sign, for independent contacts [1].
)" + refused_normals +
       notes("", "fabric::test_isotropy", "fabric/goodness_of_fit.hpp"))
          .c_str());
  module.def(
      "rose",
      [=](const py::object& n, double anisotropy, std::size_t bins) {
        return of_normals(n, [&](const auto& all) { return fabric::rose(all, anisotropy, bins); });
      },
      py::arg("normals"), py::kw_only(), py::arg("anisotropy"), py::arg("bins"),
      (R"(Histogram of the angle between contact normals and axis 3, with E(gamma; a) for comparison.
)" + normals_parameter +
       R"(anisotropy : float
    a in [-1, 1] to compare with [1].
bins : int
    Of equal width, in [1, 1000].

Returns
-------
list of RoseBin
    With densities and their standard errors, in both hemispheres [1/sr].
)" + refused_normals +
       notes("", "fabric::rose", "fabric/rose.hpp"))
          .c_str());
}

} // namespace

void bind_fabric(py::module_& module) {
  py::class_<fabric::RoseBin>(module, "RoseBin", "One bin of the angles between contact normals and axis 3.")
      .def_readonly("low", &fabric::RoseBin::low, "[rad]")
      .def_readonly("high", &fabric::RoseBin::high, "[rad]")
      .def_readonly("count", &fabric::RoseBin::count, "Contacts in it.")
      .def_readonly("density", &fabric::RoseBin::density, "[1/sr]")
      .def_readonly("density_error", &fabric::RoseBin::density_error, "[1/sr]")
      .def_readonly("expected_density", &fabric::RoseBin::expected_density, "[1/sr]");
  bind_density(module);
  bind_measures(module);
  bind_estimates(module);
}

} // namespace granum::python

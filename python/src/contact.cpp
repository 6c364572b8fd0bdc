// SPDX-License-Identifier: GPL-3.0-or-later
#include <pybind11/pybind11.h>

#include <granum/contact/pair.hpp>
#include <granum/contact/power_law.hpp>
#include <granum/core/number.hpp>

#include "bindings.hpp"
#include "docstrings.hpp"
#include "keywords.hpp"
#include "rows.hpp"

namespace granum::python {

namespace {

using contact::GrainMaterial;
using contact::PowerLaw;

contact::GrainMaterial grain_of(const Arguments& a) {
  return {number_of("shear_modulus", a[0]), number_of("poisson_ratio", a[1])};
}

/// A function of one number, for every element of an array; the first that is refused raises.
template <class F>
py::object map(const char* name, const py::handle& value, const F& f) {
  const Argument arguments[] = {{name, value}};
  return computed(answer_rows<double>(arguments, true, 0.0, [&](const double* x, Notes&) { return f(x[0]); }),
                  [](double y) { return y; });
}

using Method = double (PowerLaw::*)(double) const;

template <class Class>
void add_method(Class& type, const char* name, Method method, const char* argument,
                const char* documentation) {
  type.def(
      name,
      [=](const PowerLaw& law, const py::object& x) {
        return map(argument, x, [&](double v) { return (law.*method)(v); });
      },
      py::arg(argument), documentation);
}

std::string text_of(const PowerLaw& law) {
  return "PowerLaw(alpha=" + short_text(law.alpha()) + ", coefficient=" + exact_text(law.coefficient()) +
         ", shear_modulus=" + exact_text(law.grain().shear_modulus) +
         ", poisson_ratio=" + exact_text(law.grain().poisson_ratio) + ")";
}

void bind_power_law(py::module_& module) {
  py::class_<PowerLaw> law(module, "PowerLaw",
                           R"(Normal contact of two equal elastic grains, f = c d^(1+1/alpha).

Made by sphere, cone, flat_punch and power_law. The overlap d is the full approach of two grain centres;
compression is positive. Methods take numbers or arrays.)");
  law.def_property_readonly("alpha", &PowerLaw::alpha,
                            "Exponent of the profile z = A r^alpha [1]; inf: flat punch.")
      .def_property_readonly("coefficient", &PowerLaw::coefficient,
                             "c of f = c d^(1+1/alpha) [N m^-(1+1/alpha)].")
      .def_property_readonly("force_exponent", &PowerLaw::force_exponent, "1 + 1/alpha [1].")
      .def_property_readonly("stiffness_exponent", &PowerLaw::stiffness_exponent,
                             "b = 1/(1+alpha) of k_n ~ f^b [1].")
      .def_property_readonly("profile_constant", &PowerLaw::profile_constant,
                             "A of the profile [m^(1-alpha)].")
      .def_property_readonly(
          "shear_modulus", [](const PowerLaw& l) { return l.grain().shear_modulus; },
          "G_g of the grains [Pa].")
      .def_property_readonly(
          "poisson_ratio", [](const PowerLaw& l) { return l.grain().poisson_ratio; },
          "nu_g of the grains [1].")
      .def("times", &PowerLaw::times, py::arg("factor"),
           "The law of another coefficient, c times a factor [1].")
      .def("__repr__", &text_of);
  add_method(law, "force", &PowerLaw::force, "overlap", "Normal force [N] at an overlap >= 0 [m].");
  add_method(law, "overlap", &PowerLaw::overlap, "force", "Overlap [m] at a force >= 0 [N].");
  add_method(law, "stiffness_at_overlap", &PowerLaw::stiffness_at_overlap, "overlap",
             "k_n [N/m] at an overlap >= 0 [m].");
  add_method(law, "stiffness_at_force", &PowerLaw::stiffness_at_force, "force",
             "k_n [N/m] at a force >= 0 [N].");
  add_method(law, "energy", &PowerLaw::energy, "overlap", "Elastic energy [J] at an overlap >= 0 [m].");
  add_method(law, "contact_radius", &PowerLaw::contact_radius, "overlap",
             "Radius of the contact disc [m] at an overlap >= 0 [m].");
}

constexpr const char* material = R"(
Parameters
----------
shear_modulus : float
    G_g > 0 of the grains' material [Pa].
poisson_ratio : float
    nu_g of it, -1 < nu_g <= 0.5 [1].
)";

constexpr const char* law_result = R"(
Returns
-------
PowerLaw

Raises
------
InvalidArgument
    For a number that no grain can have.
)";

} // namespace

void bind_contact(py::module_& module) {
  bind_power_law(module);
  define(module, {"sphere",
                  {{"shear_modulus"}, {"poisson_ratio"}, {"radius"}},
                  [](const Arguments& a) {
                    return py::cast(PowerLaw::sphere(grain_of(a), number_of("radius", a[2])));
                  },
                  std::string("Hertz contact of two equal spheres, c = 2 G sqrt(2R)/(3(1-nu)).\n") +
                      material + "radius : float\n    R > 0 of each sphere [m].\n" + law_result +
                      notes("Overlaps are small against R. [Hertz1882]", "contact::PowerLaw::sphere",
                            "contact/power_law.hpp")});
  define(module,
         {"cone",
          {{"shear_modulus"}, {"poisson_ratio"}, {"slope"}},
          [](const Arguments& a) { return py::cast(PowerLaw::cone(grain_of(a), number_of("slope", a[2]))); },
          std::string("Contact of two equal cones, c = G/(pi (1-nu) A_1).\n") + material +
              "slope : float\n    A_1 > 0, tangent of the flank angle [1].\n" + law_result +
              notes("[Sneddon1965]", "contact::PowerLaw::cone", "contact/power_law.hpp")});
  define(module,
         {"flat_punch",
          {{"shear_modulus"}, {"poisson_ratio"}, {"punch_radius"}},
          [](const Arguments& a) {
            return py::cast(PowerLaw::flat(grain_of(a), number_of("punch_radius", a[2])));
          },
          std::string("Contact of two flat punches, of the same stiffness at every force.\n") + material +
              "punch_radius : float\n    a > 0 of the disc [m].\n" + law_result +
              notes("c = 2 G a/(1-nu). [Sneddon1965]", "contact::PowerLaw::flat", "contact/power_law.hpp")});
  define(module, {"power_law",
                  {{"shear_modulus"}, {"poisson_ratio"}, {"alpha"}, {"profile_constant"}},
                  [](const Arguments& a) {
                    return py::cast(PowerLaw::general(grain_of(a), number_of("alpha", a[2]),
                                                      number_of("profile_constant", a[3])));
                  },
                  std::string("Contact of two profiles z = A r^alpha.\n") + material +
                      "alpha : float\n    1 <= alpha < inf [1].\n"
                      "profile_constant : float\n    A > 0 of one grain [m^(1-alpha)].\n" +
                      law_result +
                      notes("The family that holds the others. [Galin1946] [Sneddon1965]",
                            "contact::PowerLaw::general", "contact/power_law.hpp")});
  module.def(
      "mindlin_stiffness_ratio",
      [](const py::object& nu) { return map("poisson_ratio", nu, contact::mindlin_stiffness_ratio); },
      py::arg("poisson_ratio"),
      (R"(k_t/k_n = 2(1-nu)/(2-nu) of the contact without slip.

Parameters
----------
poisson_ratio : array_like
    nu_g of the grains, -1 < nu_g <= 0.5 [1].

Returns
-------
float or ndarray
    The ratio [1], of the shape of the argument.
)" + raises_invalid("For the first number out of range.") +
       notes("[Mindlin1949]", "contact::mindlin_stiffness_ratio", "contact/power_law.hpp"))
          .c_str());
  module.def("pair_radius", &contact::pair_radius, py::kw_only(), py::arg("radius_i"), py::arg("radius_j"),
             (R"(Radius of the two equal spheres that touch as two unequal ones do, 2 R*.

Parameters
----------
radius_i, radius_j : float
    Of the two spheres, > 0 [m].

Returns
-------
float
    2 R_i R_j/(R_i + R_j) [m].
)" + raises_invalid("For a radius that is not positive.") +
              notes("[Hertz1882]", "contact::pair_radius", "contact/pair.hpp"))
                 .c_str());
}

} // namespace granum::python

// SPDX-License-Identifier: GPL-3.0-or-later
#include <pybind11/pybind11.h>
#include <pybind11/stl.h>

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include <granum/contact/laws.hpp>
#include <granum/contact/minerals.hpp>
#include <granum/contact/pair.hpp>
#include <granum/core/error.hpp>
#include <granum/elastic/isotropic.hpp>

#include "bindings.hpp"
#include "docstrings.hpp"
#include "keywords.hpp"
#include "material.hpp"
#include "rows.hpp"

namespace granum::python {

namespace {

using contact::GrainMaterial;
using contact::NormalLaw;
using contact::PowerLaw;

contact::GrainMaterial grain_of(const Arguments& a) {
  return {number_of("shear_modulus", a[0]), number_of("poisson_ratio", a[1])};
}

/// Applies a function of one number to every element of an array; the first refused element raises.
template <class F>
py::object map(const char* name, const py::handle& value, const F& f) {
  const Argument arguments[] = {{name, value}};
  return computed(answer_rows<double>(arguments, true, 0.0, [&](const double* x, Notes&) { return f(x[0]); }),
                  [](double y) { return y; });
}

template <class Of>
void add_method(py::class_<NormalLaw>& type, const char* name, Of of, const char* argument,
                const char* documentation) {
  type.def(
      name,
      [=](const NormalLaw& law, const py::object& x) {
        return map(argument, x, [&](double v) { return of(law, v); });
      },
      py::arg(argument), documentation);
}

/// A property of the power family only.
const PowerLaw& power_law(const NormalLaw& law) {
  if (const PowerLaw* power = law.power_law())
    return *power;
  throw InvalidArgument(law.text() + " is not of the power family, f = c d^(1+1/alpha)");
}

template <class Value>
void add_of_power_law(py::class_<NormalLaw>& type, const char* name, Value (PowerLaw::*of)() const,
                      const char* documentation) {
  type.def_property_readonly(
      name, [of](const NormalLaw& law) { return (power_law(law).*of)(); }, documentation);
}

/// All numbers that define a law.
py::tuple state_of(const NormalLaw& law) {
  return py::make_tuple(law.kind(), law.grain().shear_modulus, law.grain().poisson_ratio,
                        py::tuple(py::cast(law.numbers())));
}

NormalLaw from_state(const py::tuple& state) {
  return NormalLaw::of_numbers(state[0].cast<std::size_t>(),
                               {state[1].cast<double>(), state[2].cast<double>()},
                               state[3].cast<std::vector<double>>());
}

void bind_normal_law(py::module_& module) {
  py::class_<NormalLaw> law(module, "NormalLaw",
                            R"(Normal contact of two equal elastic grains.

Made by sphere, cone, flat_punch, power_law, rough_sphere, or contact_law for any law by name. The overlap d
is the full approach of two grain centres; compression is positive. Methods take numbers or arrays.
Properties of the power family f = c d^(1+1/alpha) raise InvalidArgument for another law.)");
  add_of_power_law(law, "alpha", &PowerLaw::alpha,
                   "Exponent of the profile z = A r^alpha [1]; inf: flat punch.");
  add_of_power_law(law, "coefficient", &PowerLaw::coefficient,
                   "c of f = c d^(1+1/alpha) [N m^-(1+1/alpha)].");
  add_of_power_law(law, "force_exponent", &PowerLaw::force_exponent, "1 + 1/alpha [1].");
  add_of_power_law(law, "stiffness_exponent", &PowerLaw::stiffness_exponent,
                   "b = 1/(1+alpha) of k_n ~ f^b [1].");
  add_of_power_law(law, "profile_constant", &PowerLaw::profile_constant, "A of the profile [m^(1-alpha)].");
  law.def_property_readonly(
         "shear_modulus", [](const NormalLaw& l) { return l.grain().shear_modulus; },
         "G_g of the grains [Pa].")
      .def_property_readonly(
          "poisson_ratio", [](const NormalLaw& l) { return l.grain().poisson_ratio; },
          "nu_g of the grains [1].")
      .def_property_readonly(
          "bulk_modulus", [](const NormalLaw& l) { return contact::bulk_modulus(l.grain()); },
          "K_s of the grains [Pa]; the largest number for nu_g = 0.5.")
      .def(
          "times", [](const NormalLaw& l, double factor) { return NormalLaw(power_law(l).times(factor)); },
          py::arg("factor"), "The power law with the coefficient c times a factor [1].")
      .def("__repr__", &NormalLaw::text)
      .def(
          "__eq__", [](const NormalLaw& a, const NormalLaw& b) { return a == b; }, py::is_operator())
      .def("__hash__", [](const NormalLaw& l) { return py::hash(state_of(l)); })
      .def(py::pickle(&state_of, &from_state));
  add_method(law, "force", std::mem_fn(&NormalLaw::force), "overlap",
             "Normal force [N] at an overlap >= 0 [m].");
  add_method(law, "overlap", std::mem_fn(&NormalLaw::overlap), "force", "Overlap [m] at a force >= 0 [N].");
  add_method(law, "stiffness_at_overlap", std::mem_fn(&NormalLaw::stiffness_at_overlap), "overlap",
             "k_n [N/m] at an overlap >= 0 [m].");
  add_method(law, "stiffness_at_force", std::mem_fn(&NormalLaw::stiffness_at_force), "force",
             "k_n [N/m] at a force >= 0 [N].");
  add_method(law, "exponent_at_force", std::mem_fn(&NormalLaw::exponent_at_force), "force",
             "b = d ln k_n/d ln f [1] at a force >= 0 [N].");
  add_method(law, "energy", std::mem_fn(&NormalLaw::energy), "overlap",
             "Elastic energy [J] at an overlap >= 0 [m].");
  add_method(
      law, "contact_radius",
      [](const NormalLaw& l, double overlap) { return power_law(l).contact_radius(overlap); }, "overlap",
      "Radius of the contact disc [m] at an overlap >= 0 [m], of the power family.");
}

/// "tangent of the flank angle [1]."
std::string sentence_of(const contact::LawParameter& parameter) {
  const std::string unit = parameter.si_unit();
  return parameter.symbol + ", " + parameter.help + " [" + (unit.empty() ? "1" : unit) + "].";
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
NormalLaw

Raises
------
InvalidArgument
    For an impossible number.
)";

/// The law; errors about the grains contain the typed name.
NormalLaw made_of(const Arguments& a, const contact::LawRow& row, double radius,
                  const std::vector<double>& values) {
  try {
    return row.make(grain_of(a), radius, values);
  } catch (const InvalidArgument& error) {
    const Argument grain[] = {{"shear_modulus", a[0], "grain_shear_modulus"},
                              {"poisson_ratio", a[1], "grain_poisson_ratio"}};
    throw as_typed(error, grain);
  }
}

/// The function that makes a law of the table, with the numbers of the law as keywords.
void define_maker(py::module_& module, const contact::LawRow& row) {
  std::vector<Keyword> keywords{{"shear_modulus"}, {"poisson_ratio"}};
  std::string numbers;
  if (row.depends_on_size) {
    keywords.push_back({"radius"});
    numbers += "radius : float\n    R > 0 of each grain [m].\n";
  }
  for (const contact::LawParameter& parameter : row.parameters) {
    keywords.push_back({parameter.name.c_str()});
    numbers += parameter.name + " : float\n    " + sentence_of(parameter) + "\n";
  }
  const auto make = [&row](const Arguments& a) {
    std::size_t k = 2;
    const double radius = row.depends_on_size ? number_of("radius", a[k++]) : 0;
    std::vector<double> values;
    for (const contact::LawParameter& parameter : row.parameters)
      values.push_back(number_of(parameter.name.c_str(), a[k++]));
    return py::cast(made_of(a, row, radius, values));
  };
  define(module, with_bulk_modulus({row.maker.c_str(), keywords, make,
                                    row.title + "\n" + material + numbers + law_result +
                                        notes(row.source, "contact::" + row.cpp_name, row.header)}));
}

/// Any law of the table by its name.
NormalLaw contact_law(const std::string& shape, double shear_modulus, std::optional<double> poisson_ratio,
                      std::optional<double> radius, std::optional<double> bulk_modulus,
                      const py::kwargs& numbers) {
  if (poisson_ratio.has_value() == bulk_modulus.has_value())
    throw py::type_error("contact_law() takes one of poisson_ratio and bulk_modulus");
  const double ratio =
      poisson_ratio ? *poisson_ratio
                    : elastic::Isotropic::from_bulk_and_shear(*bulk_modulus, shear_modulus).poisson_ratio();
  const std::optional<contact::Shape> known = contact::find_shape(shape);
  if (!known)
    throw InvalidArgument("contact law '" + shape + "' is not one of " + contact::shape_names());
  const contact::LawRow& row = contact::row_of(*known);
  if (row.depends_on_size && !radius)
    throw py::type_error("the contact law " + shape + " needs radius");
  std::vector<double> values;
  for (const contact::LawParameter& parameter : row.parameters) {
    if (!numbers.contains(parameter.name.c_str()))
      throw py::type_error("the contact law " + shape + " needs " + parameter.name);
    values.push_back(number_of(parameter.name.c_str(), numbers[parameter.name.c_str()]));
  }
  if (numbers.size() > values.size())
    throw py::type_error("the contact law " + shape +
                         " takes no such number: " + std::string(py::str(py::list(numbers))));
  return row.make({shear_modulus, ratio}, radius.value_or(0), values);
}

void define_contact_law(py::module_& module) {
  std::string known;
  for (const contact::LawRow& row : contact::laws()) {
    known += "    " + std::string(name(row.shape)) + ": " + row.title;
    for (const contact::LawParameter& parameter : row.parameters)
      known += " " + parameter.name + ": " + sentence_of(parameter);
    known += "\n";
  }
  module.def(
      "contact_law", &contact_law, py::arg("shape"), py::kw_only(), py::arg("shear_modulus"),
      py::arg("poisson_ratio") = py::none(), py::arg("radius") = py::none(),
      py::arg("bulk_modulus") = py::none(),
      ("Contact law of two equal grains, by its name.\n\nParameters\n----------\nshape : str\n    One of " +
       contact::shape_names() + R"(, as in options and scenes of the program.
shear_modulus : float
    G_g > 0 of the grains' material [Pa].
poisson_ratio : float, optional
    nu_g of it, -1 < nu_g <= 0.5 [1]; or bulk_modulus.
radius : float, optional
    R > 0 of each grain [m], for laws that depend on it.
bulk_modulus : float, optional
    K > 0 of the grains' material [Pa], instead of Poisson's ratio.
**kwargs : float
    Parameters of the law, in SI [unit]:
)" + known +
       law_result + notes("", "contact::law_of", "contact/laws.hpp"))
          .c_str());
}

void bind_minerals(py::module_& module) {
  using contact::Mineral;
  py::class_<Mineral>(module, "Mineral", "A common material of grains.")
      .def_readonly("key", &Mineral::key, "Its name on a command line.")
      .def_readonly("name", &Mineral::name, "For people.")
      .def_readonly("source", &Mineral::source, "Key in validation/references.bib.")
      .def_property_readonly(
          "shear_modulus", [](const Mineral& m) { return m.material.shear_modulus; }, "G_g [Pa].")
      .def_property_readonly(
          "poisson_ratio", [](const Mineral& m) { return m.material.poisson_ratio; }, "nu_g [1].")
      .def_property_readonly(
          "bulk_modulus", [](const Mineral& m) { return contact::bulk_modulus(m.material); }, "K_s [Pa].")
      .def_readonly("density", &Mineral::density, "[kg/m3]")
      .def_readonly("modulus_spread", &Mineral::modulus_spread,
                    "Estimated relative scatter of G_g between samples of this mineral [1].");
  module.def(
      "minerals",
      [] {
        py::dict all;
        for (const Mineral& mineral : contact::minerals())
          all[mineral.key] = py::cast(&mineral, py::return_value_policy::reference);
        return all;
      },
      (R"(Common materials of grains, with their names in the program.

Returns
-------
dict of Mineral
    By their keys: quartz, feldspar, calcite, dolomite, glass, steel.
)" + notes("For minerals, averages over all directions of a crystal. [Mavko2009] [Makse2004] "
           "[BudynasNisbett2011]",
           "contact::minerals", "contact/minerals.hpp"))
          .c_str());
}

} // namespace

void bind_contact(py::module_& module) {
  bind_normal_law(module);
  for (const contact::LawRow& row : contact::laws())
    if (!row.maker.empty())
      define_maker(module, row);
  define_contact_law(module);
  bind_minerals(module);
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
             (R"(Radius 2 R* of two equal spheres with the same contact law as two unequal ones.

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

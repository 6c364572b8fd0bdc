// SPDX-License-Identifier: GPL-3.0-or-later
#include <pybind11/pybind11.h>
#include <pybind11/stl.h>

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include <granum/contact/grains.hpp>
#include <granum/contact/laws.hpp>
#include <granum/core/error.hpp>

#include "bindings.hpp"
#include "members.hpp"
#include "rows.hpp"
#include "shared_keywords.hpp"

namespace granum::python {

namespace {

using contact::GrainMaterial;
using contact::NormalLaw;
using contact::PowerLaw;

/// A method of one number, or of every element of an array; the first refused element raises.
template <class Of>
void add_method(const py::object& type, const char* name, Of of, const Keyword& argument, const char* says) {
  define_method(
      type, name, {argument}, {says, "float or ndarray"},
      [of](const Arguments& a) {
        const auto& law = a.as<const NormalLaw&>(0);
        return numbers_of_rows(a, [&](const double* x) { return of(law, x[0]); });
      },
      1);
}

/// A property of the power family only.
const PowerLaw& power_law(const NormalLaw& law) {
  if (const PowerLaw* power = law.power_law())
    return *power;
  throw InvalidArgument(law.text() + " is not of the power family, f = c d^(1+1/alpha)");
}

/// A property of the power family.
template <class Value>
auto of_power_law(Value (PowerLaw::*of)() const) {
  return [of](const NormalLaw& law) { return (power_law(law).*of)(); };
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
  ResultClass<NormalLaw> law(module, "NormalLaw",
                             R"(Normal contact of two equal elastic grains.

Made by sphere, cone, flat_punch, power_law, rough_sphere, or contact_law for any law by name. The overlap d
is the full approach of two grain centres; compression is positive. Methods take numbers or arrays.
Properties of the power family f = c d^(1+1/alpha) raise InvalidArgument for another law.)");
  law.show("alpha", "Exponent of the profile z = A r^alpha [1]; inf: flat punch.",
           of_power_law(&PowerLaw::alpha))
      .show("coefficient", "c of f = c d^(1+1/alpha) [N m^-(1+1/alpha)].",
            of_power_law(&PowerLaw::coefficient))
      .show("force_exponent", "1 + 1/alpha [1].", of_power_law(&PowerLaw::force_exponent))
      .show("stiffness_exponent", "b = 1/(1+alpha) of k_n ~ f^b [1].",
            of_power_law(&PowerLaw::stiffness_exponent))
      .show("profile_constant", "A of the profile [m^(1-alpha)].", of_power_law(&PowerLaw::profile_constant))
      .show("shear_modulus", "G_g of the grains [Pa].", &NormalLaw::grain, &GrainMaterial::shear_modulus)
      .show("poisson_ratio", "nu_g of the grains [1].", &NormalLaw::grain, &GrainMaterial::poisson_ratio)
      .show("bulk_modulus", "K_s of the grains [Pa]; the largest number for nu_g = 0.5.", &NormalLaw::grain,
            &contact::bulk_modulus)
      .def("__repr__", &NormalLaw::text)
      .def(
          "__eq__", [](const NormalLaw& a, const NormalLaw& b) { return a == b; }, py::is_operator())
      .def("__hash__", [](const NormalLaw& l) { return py::hash(state_of(l)); })
      .def(py::pickle(&state_of, &from_state));
  define_method(
      law, "times", {required("factor", "float", "> 0 [1].")},
      {"The power law with the coefficient c times a factor.", "NormalLaw"},
      [](const NormalLaw& l, double factor) { return NormalLaw(power_law(l).times(factor)); }, 1);
  const Keyword overlap = column("overlap", "Full approach of the centres, >= 0 [m]."),
                force = column("force", "Normal force, >= 0 [N].");
  add_method(law, "force", std::mem_fn(&NormalLaw::force), overlap, "Normal force [N].");
  add_method(law, "overlap", std::mem_fn(&NormalLaw::overlap), force, "Overlap [m].");
  add_method(law, "stiffness_at_overlap", std::mem_fn(&NormalLaw::stiffness_at_overlap), overlap,
             "k_n [N/m].");
  add_method(law, "stiffness_at_force", std::mem_fn(&NormalLaw::stiffness_at_force), force, "k_n [N/m].");
  add_method(law, "exponent_at_force", std::mem_fn(&NormalLaw::exponent_at_force), force,
             "b = d ln k_n/d ln f [1].");
  add_method(law, "energy", std::mem_fn(&NormalLaw::energy), overlap, "Elastic energy [J].");
  add_method(
      law, "contact_radius", [](const NormalLaw& l, double d) { return power_law(l).contact_radius(d); },
      overlap, "Radius of the contact disc [m], of the power family.");
}

/// "tangent of the flank angle [1]."
std::string sentence_of(const contact::LawParameter& parameter) {
  const std::string unit = parameter.si_unit();
  return parameter.symbol + ", " + parameter.help + " [" + (unit.empty() ? "1" : unit) + "].";
}

std::vector<Keyword> material_keywords() {
  std::vector<Keyword> out = solid_keywords("", "grains' material", "float");
  for (Keyword& keyword : out)
    keyword.in_library = keyword.name == "shear_modulus" ? "grain_shear_modulus" : "grain_poisson_ratio";
  return out;
}

/// The function that makes a law of the table, with the numbers of the law as keywords.
void define_maker(py::module_& module, const contact::LawRow& row) {
  std::vector<Keyword> keywords = material_keywords();
  if (row.depends_on_size)
    keywords.push_back(required("radius", "float", "R > 0 of each grain [m]."));
  for (const contact::LawParameter& parameter : row.parameters)
    keywords.push_back(required(parameter.name, "float", sentence_of(parameter)));
  const auto make = [&row](const Arguments& a) {
    const double shear_modulus = a.number(0), poisson_ratio = a.number(1);
    std::size_t k = 2;
    const double radius = row.depends_on_size ? a.number(k++) : 0;
    std::vector<double> values;
    for (std::size_t p = 0; p < row.parameters.size(); ++p)
      values.push_back(a.number(k++));
    return py::cast(row.make({shear_modulus, poisson_ratio}, radius, values));
  };
  define_of_solid(module, row.maker.c_str(), keywords,
                  {row.title, "NormalLaw", "For an impossible number.", row.source,
                   "contact::" + row.cpp_name, row.header},
                  make);
}

/// The keywords of contact_law: those of all laws.
std::vector<Keyword> law_keywords() {
  std::vector<Keyword> out = std::vector{required("shape", "str",
                                                  "One of " + contact::shape_names() +
                                                      ", as in options and scenes of the program.")} +
                             material_keywords();
  out.push_back(optional("radius", "float", "R > 0 of each grain [m], for laws that depend on it."));
  for (const contact::LawRow& row : contact::laws())
    for (const contact::LawParameter& parameter : row.parameters)
      out.push_back(optional(parameter.name, "float",
                             "Of " + std::string(name(row.shape)) + ": " + sentence_of(parameter)));
  return out;
}

/// Any law of the table by its name.
NormalLaw contact_law(const Arguments& a) {
  constexpr std::size_t radius_at = 3, first_parameter = 4;
  const std::optional<contact::Shape> known = contact::find_shape(a.text(0));
  if (!known)
    throw InvalidArgument("shape '" + a.text(0) + "' is not one of " + contact::shape_names());
  const contact::LawRow& row = contact::row_of(*known);
  const std::string law = "the contact law " + a.text(0);
  if (row.depends_on_size && !a.given(radius_at))
    throw py::type_error(law + " needs radius");
  std::vector<double> values;
  std::size_t k = first_parameter;
  for (const contact::LawRow& other : contact::laws())
    for (std::size_t p = 0; p < other.parameters.size(); ++p, ++k)
      if (&other == &row && !a.given(k))
        throw py::type_error(law + " needs " + a.name(k));
      else if (&other == &row)
        values.push_back(a.number(k));
      else if (a.given(k))
        throw py::type_error(law + " takes no such number: " + a.name(k));
  return row.make({a.number(1), a.number(2)}, a.number(radius_at), values);
}

void bind_minerals(py::module_& module) {
  using contact::Mineral;
  ResultClass<Mineral>(module, "Mineral", "A common material of grains.")
      .show("key", "Its name on a command line.", &Mineral::key)
      .show("name", "For people.", &Mineral::name)
      .show("source", "Key of references().", &Mineral::source)
      .show("shear_modulus", "G_g [Pa].", &Mineral::material, &GrainMaterial::shear_modulus)
      .show("poisson_ratio", "nu_g [1].", &Mineral::material, &GrainMaterial::poisson_ratio)
      .show("bulk_modulus", "K_s [Pa].", &Mineral::material, &contact::bulk_modulus)
      .show("density", "[kg/m3]", &Mineral::density)
      .show("modulus_spread", "Estimated relative scatter of G_g between samples of this mineral [1].",
            &Mineral::modulus_spread);
  define_table(module, "minerals", contact::minerals(),
               {"Common materials of grains, with their names in the program.",
                "dict of Mineral\n    By their keys: quartz, feldspar, calcite, dolomite, glass, steel.", "",
                "For minerals, averages over all directions of a crystal. [Mavko2009] [Makse2004] "
                "[BudynasNisbett2011]",
                "contact::minerals", "contact/grains.hpp"});
}

} // namespace

void bind_contact(py::module_& module) {
  bind_normal_law(module);
  for (const contact::LawRow& row : contact::laws())
    if (!row.maker.empty())
      define_maker(module, row);
  define(module,
         with_bulk_modulus(function(
             "contact_law", law_keywords(),
             {"Contact law of two equal grains, by its name.", "NormalLaw",
              "For an impossible number, or an unknown name.", "", "contact::law_of", "contact/laws.hpp"},
             [](const Arguments& a) { return py::cast(contact_law(a)); }, 1)));
  bind_minerals(module);
  define(
      module, "mindlin_stiffness_ratio",
      {column("poisson_ratio", "nu_g of the grains, -1 < nu_g <= 0.5 [1].").called("grain_poisson_ratio")},
      {"k_t/k_n = 2(1-nu)/(2-nu) of the contact without slip.",
       "float or ndarray\n    The ratio [1], of the shape of the argument.",
       "For the first number out of range.", "[Mindlin1949]", "contact::mindlin_stiffness_ratio",
       "contact/power_law.hpp"},
      [](const Arguments& a) {
        return numbers_of_rows(a, [](const double* x) { return contact::mindlin_stiffness_ratio(x[0]); });
      },
      1);
  define(module, "pair_radius",
         {required("radius_i", "float", ""), required("radius_j", "float", "Of the two spheres, > 0 [m].")},
         {"Radius 2 R* of two equal spheres with the same contact law as two unequal ones.",
          "float\n    2 R_i R_j/(R_i + R_j) [m].", "For a radius that is not positive.", "[Hertz1882]",
          "contact::pair_radius", "contact/grains.hpp"},
         [](double i, double j) {
           return contact::pair_radius(require_positive("radius_i", i, "m"),
                                       require_positive("radius_j", j, "m"));
         });
}

} // namespace granum::python

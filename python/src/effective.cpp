// SPDX-License-Identifier: GPL-3.0-or-later
#include <pybind11/pybind11.h>
#include <pybind11/stl.h>

#include <cstddef>
#include <limits>

#include <granum/effective/kinematic_field.hpp>
#include <granum/effective/relaxation.hpp>
#include <granum/effective/rungs.hpp>
#include <granum/effective/uniform_field.hpp>
#include <granum/elastic/transverse_isotropic.hpp>

#include "bindings.hpp"
#include "docstrings.hpp"
#include "estimate.hpp"
#include "state.hpp"

namespace granum::python {

namespace {

using effective::RungAnswer;
using elastic::Loading;
using elastic::TransverselyIsotropic;

constexpr double nan = std::numeric_limits<double>::quiet_NaN();

// ---- stiffness with its errors

/// A Young's modulus or Poisson's ratio: NaN where the stiffness has none.
double where_stable(const TransverselyIsotropic& c, double (TransverselyIsotropic::*get)() const) {
  return c.positive_definite() ? (c.*get)() : nan;
}

py::object matrices(const Stiffnesses& rows) {
  if (rows.scalar)
    return array_of(elastic::voigt(rows.front().stiffness).matrix);
  std::vector<py::ssize_t> shape = rows.shape;
  shape.insert(shape.end(), {6, 6});
  py::array_t<double> out(shape);
  double* to = out.mutable_data();
  for (std::size_t k = 0; k < rows.rows.size(); ++k) {
    hear_signals(k);
    const elastic::Matrix6 matrix = elastic::voigt(rows.rows[k].stiffness).matrix;
    for (int i = 0; i < 6; ++i)
      for (int j = 0; j < 6; ++j)
        *to++ = matrix(i, j);
  }
  return out;
}

/// Members of Rows<StiffnessRow> for the derived class.
py::object number(const py::object& result, std::size_t offset) {
  return member<StiffnessRow>(result, offset);
}

template <class Class, class Get>
void show(Class& type, const char* name, const Get& get, const char* documentation) {
  type.def_property_readonly(
      name,
      [get](const Stiffnesses& rows) {
        return computed<StiffnessRow>(rows, [&](const StiffnessRow& row) { return get(row.stiffness); });
      },
      documentation);
}

/// Errors of three moduli, a view of their result.
struct ErrorView {
  py::object result;
};

std::string text_of(const Stiffnesses& rows) {
  if (!rows.scalar)
    return "<Estimate of shape " + std::string(py::str(py::object(py::tuple(py::cast(rows.shape))))) + ">";
  const TransverselyIsotropic& c = rows.front().stiffness;
  return py::str("Estimate(K={:.4g}, G_vh={:.4g}, G_hh={:.4g})").format(c.bulk_modulus(), c.G_vh(), c.G_hh());
}

void bind_estimate(py::module_& module) {
  result_class<StiffnessRow>(module, "_StiffnessRows", "Members of all estimates.");
  py::class_<Stiffnesses, Rows<StiffnessRow>> type(module, "Estimate",
                                                   R"(Stiffness of packings, symmetric about axis 3.

Members are floats if all arguments are numbers, and arrays of the broadcast shape if any is an array.)");
  constexpr std::size_t c = offsetof(StiffnessRow, stiffness);
  const std::pair<const char*, std::size_t> constants[] = {
      {"C11", c + offsetof(TransverselyIsotropic, C11)}, {"C33", c + offsetof(TransverselyIsotropic, C33)},
      {"C12", c + offsetof(TransverselyIsotropic, C12)}, {"C13", c + offsetof(TransverselyIsotropic, C13)},
      {"C44", c + offsetof(TransverselyIsotropic, C44)}, {"G_vh", c + offsetof(TransverselyIsotropic, C44)}};
  for (const auto& [name, offset] : constants)
    type.def_property_readonly(
        name, [offset = offset](const py::object& result) { return number(result, offset); },
        "Elastic constant [Pa]; G_vh = C44 is the shear modulus of vertical planes.");
  show(
      type, "C66", [](const TransverselyIsotropic& s) { return s.C66(); }, "(C11-C12)/2 [Pa].");
  show(
      type, "G_hh", [](const TransverselyIsotropic& s) { return s.G_hh(); },
      "Shear modulus of the horizontal plane, C66 [Pa].");
  show(
      type, "bulk_modulus", [](const TransverselyIsotropic& s) { return s.bulk_modulus(); }, "K [Pa].");
  show(
      type, "E_v",
      [](const TransverselyIsotropic& s) { return young_modulus(s, Loading::vertical).value_or(nan); },
      "Young's modulus of vertical loading [Pa]; NaN if it does not exist.");
  show(
      type, "E_h",
      [](const TransverselyIsotropic& s) { return young_modulus(s, Loading::horizontal).value_or(nan); },
      "Young's modulus of horizontal loading [Pa]; NaN if it does not exist.");
  show(
      type, "nu_vh",
      [](const TransverselyIsotropic& s) { return where_stable(s, &TransverselyIsotropic::nu_vh); },
      "Vertical loading: -e_h/e_v [1]; NaN where the stiffness is not positive definite.");
  show(
      type, "nu_hv",
      [](const TransverselyIsotropic& s) { return where_stable(s, &TransverselyIsotropic::nu_hv); },
      "Horizontal loading: -e_v/e_h [1]; NaN where the stiffness is not positive definite.");
  show(
      type, "nu_hh",
      [](const TransverselyIsotropic& s) { return where_stable(s, &TransverselyIsotropic::nu_hh); },
      "Horizontal loading: -e_h2/e_h1 [1]; NaN where the stiffness is not positive definite.");
  type.def_property_readonly("stiffness", &matrices,
                             "6 x 6 Voigt matrices [Pa], order 11 22 33 23 13 12: (..., 6, 6).");
  type.def_property_readonly(
      "relative_error",
      [](const py::object& result) -> py::object {
        return result.cast<const Stiffnesses&>().has_error ? py::cast(ErrorView{result}) : py::none();
      },
      "Relative standard errors of the moduli, if the estimate states them; else None.");
  type.def("__repr__", &text_of);

  py::class_<ErrorView> errors(module, "ModulusErrors", "Relative standard errors of moduli [1].");
  constexpr std::size_t e = offsetof(StiffnessRow, error);
  const std::pair<const char*, std::size_t> moduli[] = {
      {"bulk_modulus", e + offsetof(effective::ModulusErrors, bulk_modulus)},
      {"G_hh", e + offsetof(effective::ModulusErrors, G_hh)},
      {"G_vh", e + offsetof(effective::ModulusErrors, G_vh)}};
  for (const auto& [name, offset] : moduli)
    errors.def_property_readonly(
        name, [offset = offset](const ErrorView& view) { return number(view.result, offset); },
        "Relative standard error [1].");
}

// ---- closed forms

template <class Answer>
py::object stiffnesses(const StateArguments& arguments, bool has_error, const Answer& answer) {
  Stiffnesses out{answer_rows(arguments.columns(), arguments.strict(), StiffnessRow{}, answer)};
  out.has_error = has_error;
  return py::cast(std::move(out));
}

template <effective::Estimate (*form)(const effective::State&)>
py::object field(const Arguments& a) {
  const StateArguments arguments(a);
  return stiffnesses(arguments, false, [&](const double* x, Notes& notes) {
    const effective::Estimate estimate = form(arguments.state(x));
    notes.add(estimate.validity);
    return StiffnessRow{.stiffness = estimate.stiffness};
  });
}

StiffnessRow row_of(const RungAnswer& answer, Notes& notes) {
  notes.add(answer.validity);
  StiffnessRow row{.stiffness = answer.stiffness};
  if (answer.relative_error)
    row.error = *answer.relative_error;
  return row;
}

py::object ask(const effective::Rung& rung, const StateArguments& arguments) {
  return stiffnesses(arguments, rung.name == effective::RungName::relaxed,
                     [&](const double* x, Notes& notes) {
                       return row_of(effective::answer(rung, arguments.state(x)), notes);
                     });
}

/// \param    source   section Notes
std::string documentation(const char* what, const std::string& source, const char* more = "") {
  return std::string(what) + "\n" + state_parameters + more + R"(
Returns
-------
Estimate

Raises
------
InvalidArgument
    For impossible numbers; with arrays only under strict.
)" + source;
}

std::string of_field(const char* remarks, const char* function) {
  return notes(remarks, std::string("effective::") + function, "effective/uniform_field.hpp");
}

std::string of_kinematic_field(const char* function) {
  return notes("Tangential forces follow from the strain, too. [NorrisJohnson1997] [JenkinsStrack1993]",
               std::string("effective::") + function, "effective/kinematic_field.hpp");
}

void bind_closed_forms(py::module_& module) {
  define(module, {"uniform_strain", state_keywords(), field<effective::uniform_strain>,
                  documentation("Stiffness if all grains follow the mean strain: rung 2, an upper bound.",
                                of_field("[ChangLiao1994] [Chang1995] [YimsiriSoga2000] [Walton1987]",
                                         "uniform_strain"))});
  define(module,
         {"free_spin", state_keywords(), field<effective::free_spin>,
          documentation("Uniform strain with a free mean spin: a tighter upper bound.",
                        of_field("The mean spin of the grains takes the value of least energy; it differs "
                                 "with fabric or unequal stresses. [ChangLiao1994]",
                                 "free_spin"))});
  define(module, {"uniform_stress", state_keywords(), field<effective::uniform_stress>,
                  documentation("Stiffness if all contacts carry the forces of the mean stress.",
                                of_field("[ChangLiao1994] [Chang1995]", "uniform_stress"))});
  define(module, {"uniform_strain_kinematic", state_keywords(), field<effective::uniform_strain_kinematic>,
                  documentation("Uniform strain with the contact forces of a uniform strain.",
                                of_kinematic_field("uniform_strain_kinematic"))});
  define(module, {"uniform_stress_kinematic", state_keywords(), field<effective::uniform_stress_kinematic>,
                  documentation("Uniform stress with the contact forces of a uniform strain.",
                                of_kinematic_field("uniform_stress_kinematic"))});
  define(module,
         {"relaxed", state_keywords(),
          [](const Arguments& a) {
            return ask(effective::rung(effective::RungName::relaxed), StateArguments(a));
          },
          documentation("Rung 3: uniform strain times relaxation factors of contact networks, with its "
                        "standard errors.\n\nNeeds mechanical_coordination_number or rattler_fraction.",
                        notes("The factors were calibrated on contact networks of granum's own packings: "
                              "validation/relaxation. z* as [AgnolinRoux2007a].",
                              "effective::relaxed", "effective/relaxation.hpp"))});
  define(
      module,
      {"answer", state_keywords({{"rung"}}),
       [](const Arguments& a) { return ask(closed_form_of(a[state_keyword_count]), StateArguments(a)); },
       documentation("Evaluates a rung, given by its number or name.",
                     notes("The table of rungs, see rungs(), lists the inputs of each and the source of its "
                           "errors.",
                           "effective::answer", "effective/rungs.hpp"),
                     "rung : int or str\n    0 to 3, or isotropic, fabric, directional, relaxed, "
                     "uniform_stress.\n")});
}

// ---- the table of rungs

void bind_rungs(py::module_& module) {
  using effective::Rung;
  py::class_<Rung>(module, "Rung", "A row of the table of rungs.")
      .def_readonly("number", &Rung::number, "Number on the ladder; None if not on it.")
      .def_readonly("key", &Rung::key, "Its name on a command line.")
      .def_readonly("title", &Rung::title, "Short description.")
      .def_readonly("description", &Rung::description, "Full description.")
      .def_readonly("needs", &Rung::needs, "Inputs besides contact law, C_n, e and the mean stress.")
      .def_readonly("typical_time", &Rung::typical_time, "Time of one evaluation [s].")
      .def_readonly("error_source", &Rung::error_source, "Source of its stated errors.")
      .def("__repr__",
           [](const Rung& rung) { return "<" + effective::label(rung) + ": " + rung.title + ">"; });
  module.def(
      "rungs",
      [] {
        py::list all;
        for (const Rung& rung : effective::rungs())
          all.append(py::cast(&rung, py::return_value_policy::reference));
        return all;
      },
      (R"(All rungs of the ladder, from the cheapest to the most expensive, and uniform stress.

Returns
-------
list of Rung
)" + notes("", "effective::rungs", "effective/rungs.hpp"))
          .c_str());
}

} // namespace

py::object estimate_object(const RungAnswer& answer) {
  Notes notes;
  Stiffnesses out;
  out.rows.push_back(row_of(answer, notes));
  out.notes = notes.take();
  out.has_error = answer.relative_error.has_value();
  return py::cast(std::move(out));
}

void bind_effective(py::module_& module) {
  bind_estimate(module);
  bind_closed_forms(module);
  bind_rungs(module);
}

} // namespace granum::python

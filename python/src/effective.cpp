// SPDX-License-Identifier: GPL-3.0-or-later
#include <pybind11/pybind11.h>
#include <pybind11/stl.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>

#include <granum/effective/batch.hpp>
#include <granum/effective/relaxation.hpp>
#include <granum/effective/rungs.hpp>
#include <granum/effective/uniform_field.hpp>
#include <granum/elastic/transverse_isotropic.hpp>

#include "bindings.hpp"
#include "errors.hpp"
#include "estimate.hpp"
#include "members.hpp"
#include "rows.hpp"
#include "shared_keywords.hpp"
#include "state.hpp"

namespace granum::python {

namespace {

using effective::RungAnswer;
using elastic::Loading;
using elastic::TransverselyIsotropic;

// ---- stiffness with its errors

/// A Young's modulus or Poisson's ratio: NaN where the stiffness has none.
double where_stable(const TransverselyIsotropic& c, double (TransverselyIsotropic::*get)() const) {
  return c.positive_definite() ? (c.*get)() : nan;
}

py::array matrices(const Stiffnesses& rows) {
  if (rows.scalar)
    return array_of(elastic::voigt(rows.front().stiffness).matrix);
  std::vector<py::ssize_t> shape = rows.shape;
  shape.insert(shape.end(), {6, 6});
  py::array_t<double> out(shape);
  double* to = out.mutable_data();
  for (std::size_t k = 0; k < rows.rows.size(); ++k) {
    hear_signals(k);
    const TransverselyIsotropic& stiffness = rows.rows[k].stiffness;
    const bool refused = std::isnan(stiffness.C11);
    const elastic::Matrix6 matrix =
        refused ? elastic::Matrix6::Constant(nan).eval() : elastic::voigt(stiffness).matrix;
    for (int i = 0; i < 6; ++i)
      for (int j = 0; j < 6; ++j)
        *to++ = matrix(i, j);
  }
  return out;
}

/// A number of the rows, for the derived class.
template <class Class>
void show(Class& type, const char* name, std::size_t offset, const char* says) {
  type.def_property_readonly(
      name, [offset](const py::object& result) { return member<StiffnessRow>(result, offset); }, says);
}

using Number = double (*)(const TransverselyIsotropic&);

/// Numbers that follow from the five constants.
constexpr struct {
  const char *name, *says;
  Number of;
} derived[] = {
    {"C66", "(C11-C12)/2 [Pa].", [](const TransverselyIsotropic& s) { return s.C66(); }},
    {"G_hh", "Shear modulus of the horizontal plane, C66 [Pa].",
     [](const TransverselyIsotropic& s) { return s.G_hh(); }},
    {"bulk_modulus", "K [Pa].", [](const TransverselyIsotropic& s) { return s.bulk_modulus(); }},
    {"E_v", "Young's modulus of vertical loading [Pa]; NaN if it does not exist.",
     [](const TransverselyIsotropic& s) { return young_modulus(s, Loading::vertical).value_or(nan); }},
    {"E_h", "Young's modulus of horizontal loading [Pa]; NaN if it does not exist.",
     [](const TransverselyIsotropic& s) { return young_modulus(s, Loading::horizontal).value_or(nan); }},
    {"nu_vh", "Vertical loading: -e_h/e_v [1]; NaN where the stiffness is not positive definite.",
     [](const TransverselyIsotropic& s) { return where_stable(s, &TransverselyIsotropic::nu_vh); }},
    {"nu_hv", "Horizontal loading: -e_v/e_h [1]; NaN where the stiffness is not positive definite.",
     [](const TransverselyIsotropic& s) { return where_stable(s, &TransverselyIsotropic::nu_hv); }},
    {"nu_hh", "Horizontal loading: -e_h2/e_h1 [1]; NaN where the stiffness is not positive definite.",
     [](const TransverselyIsotropic& s) { return where_stable(s, &TransverselyIsotropic::nu_hh); }}};

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
    show(type, name, offset, "Elastic constant [Pa]; G_vh = C44 is the shear modulus of vertical planes.");
  for (const auto& [name, says, of] : derived)
    type.def_property_readonly(
        name,
        [of = of](const Stiffnesses& rows) {
          return computed<StiffnessRow>(rows, [of](const StiffnessRow& row) { return of(row.stiffness); });
        },
        says);
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
        name, [offset = offset](const ErrorView& view) { return member<StiffnessRow>(view.result, offset); },
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

constexpr const char *of_field = "effective/uniform_field.hpp",
                     *of_kinematic_field = "effective/uniform_field.hpp",
                     *refused = "For impossible numbers; with arrays only under strict.";

void bind_fields(py::module_& module) {
  const auto define_field = [&module](const char* name, py::object (*of)(const Arguments&),
                                      const char* summary, const char* remarks, const char* header) {
    define(module, name, state_keywords(),
           {summary, "Estimate", refused, remarks, std::string("effective::") + name, header}, of);
  };
  define_field("uniform_strain", field<effective::uniform_strain>,
               "Stiffness if all grains follow the mean strain: rung 2, an upper bound.",
               "[ChangLiao1994] [Chang1995] [YimsiriSoga2000] [Walton1987]", of_field);
  define_field("free_spin", field<effective::free_spin>,
               "Uniform strain with a free mean spin: a tighter upper bound.",
               "The mean spin of the grains takes the value of least energy; it differs with fabric or "
               "unequal stresses. [ChangLiao1994]",
               of_field);
  define_field("uniform_stress", field<effective::uniform_stress>,
               "Stiffness if all contacts carry the forces of the mean stress.",
               "[ChangLiao1994] [Chang1995]", of_field);
  const char* const remarks =
      "Tangential forces follow from the strain, too. [NorrisJohnson1997] [JenkinsStrack1993]";
  define_field("uniform_strain_kinematic", field<effective::uniform_strain_kinematic>,
               "Uniform strain with the contact forces of a uniform strain.", remarks, of_kinematic_field);
  define_field("uniform_stress_kinematic", field<effective::uniform_stress_kinematic>,
               "Uniform stress with the contact forces of a uniform strain.", remarks, of_kinematic_field);
}

void bind_rung_functions(py::module_& module) {
  define(module, "relaxed", state_keywords(),
         {"Rung 3: uniform strain times relaxation factors of contact networks, with its standard "
          "errors.\n\nNeeds mechanical_coordination_number or rattler_fraction.",
          "Estimate", refused,
          "The factors were calibrated on contact networks of granum's own packings: validation/relaxation. "
          "z* as [AgnolinRoux2007a].",
          "effective::relaxed", "effective/relaxation.hpp"},
         [](const Arguments& a) {
           return ask(effective::rung(effective::RungName::relaxed), StateArguments(a));
         });
  define(module, "answer", state_keywords({rung_keyword()}),
         {"Evaluates a rung, given by its number or name.", "Estimate", refused,
          "The table of rungs, see rungs(), lists the inputs of each and the source of its errors.",
          "effective::answer", "effective/rungs.hpp"},
         [](const Arguments& a) { return ask(closed_form_of(a[state_keyword_count]), StateArguments(a)); });
}

// ---- the table of rungs

void bind_rungs(py::module_& module) {
  using effective::Rung;
  ResultClass<Rung>(module, "Rung", "A row of the table of rungs.")
      .show("number", "Number on the ladder; None if not on it.", &Rung::number)
      .show("key", "Its name on a command line.", &Rung::key)
      .show("title", "Short description.", &Rung::title)
      .show("description", "Full description.", &Rung::description)
      .show("needs", "Inputs besides contact law, C_n, e and the mean stress.", &Rung::needs)
      .show("typical_time", "Time of one evaluation [s].", &Rung::typical_time)
      .show("error_source", "Source of its stated errors.", &Rung::error_source)
      .def("__repr__",
           [](const Rung& rung) { return "<" + effective::label(rung) + ": " + rung.title + ">"; });
  define(module, "rungs", {},
         {"All rungs of the ladder, from the cheapest to the most expensive, and uniform stress.",
          "list of Rung", "", "", "effective::rungs", "effective/rungs.hpp"},
         [] {
           py::list all;
           for (const Rung& rung : effective::rungs())
             all.append(py::cast(&rung, py::return_value_policy::reference));
           return all;
         });
}

struct Moduli {
  py::array_t<double> bulk_modulus, shear_modulus;
  std::vector<py::ssize_t> shape;
  std::map<std::size_t, std::string> errors;
};

bool share_memory(const py::array& a, const py::array& b) {
  return py::module_::import("numpy").attr("may_share_memory")(a, b).cast<bool>();
}

/// A column of the batch: a number, or an array of the shape of the results, contiguous by rows.
class BatchColumn {
 public:
  BatchColumn(const char* name, const py::handle& value) : array_(numbers_of(name, value)) {}

  [[nodiscard]] const py::array& array() const { return array_; }
  [[nodiscard]] bool varies() const { return array_.ndim() > 0; }
  /// Copies an array whose memory is about to be written, because rows may be read twice.
  void leave(const py::array& written) {
    if (varies() && share_memory(array_, written))
      array_ = array_.attr("copy")();
  }
  void spread(const std::vector<py::ssize_t>& shape) {
    if (!varies())
      return;
    if (!std::equal(shape.begin(), shape.end(), array_.shape(), array_.shape() + array_.ndim()))
      array_ = py::module_::import("numpy").attr("broadcast_to")(array_, py::tuple(py::cast(shape)));
    array_ = py::array_t<double, py::array::c_style>(array_);
  }
  [[nodiscard]] effective::BatchInput rows(std::size_t first, std::size_t count) const {
    return varies() ? effective::BatchInput(std::span(array_.data() + first, count))
                    : effective::BatchInput(*array_.data());
  }

 private:
  py::array_t<double> array_;
};

/// An array of the caller for results of a shape.
/// \throws   TypeError unless it is a writable, contiguous array of float64; InvalidArgument for another
///           shape
py::array_t<double> array_to_write(const py::handle& value, const std::vector<py::ssize_t>& shape) {
  const bool plain = Py_TYPE(value.ptr()) == py::detail::npy_api::get().PyArray_Type_;
  if (!plain || !py::array_t<double>::check_(value))
    throw py::type_error("out is no two arrays of float64");
  const auto array = py::reinterpret_borrow<py::array>(value);
  if (!array.writeable() || (array.flags() & py::array::c_style) == 0)
    throw py::type_error(
        "out holds an array that cannot be written, or whose rows do not follow one another");
  if (!std::equal(shape.begin(), shape.end(), array.shape(), array.shape() + array.ndim()))
    throw InvalidArgument("out has the shape " + shape_text(array) + ", the results have " +
                          std::string(py::str(py::object(py::tuple(py::cast(shape))))));
  return py::reinterpret_borrow<py::array_t<double>>(value);
}

/// The rows of a batch, and the messages of refused rows.
class Batch {
 public:
  explicit Batch(const Arguments& a)
      : law_(a.as<const contact::NormalLaw&>(0)),
        contacts_(taken<std::optional<sizes::ContactMeans>>(a, 6).value_or(sizes::ContactMeans{})),
        tangential_ratio_(
            a.number_if_given(5).value_or(contact::mindlin_stiffness_ratio(law_.grain().poisson_ratio))),
        radius_(a.number(1)), pressure_("pressure", a[4]), coordination_number_("coordination_number", a[3]),
        porosity_("porosity", a[2]) {
    const Columns columns(columns_of(a));
    out_.shape = columns.shape();
    rows_ = columns.rows();
    for (BatchColumn* column : {&pressure_, &coordination_number_, &porosity_})
      column->spread(out_.shape);
    if (a.given(out_at)) {
      write_to(a[out_at]);
    } else {
      out_.bulk_modulus = py::array_t<double>(out_.shape);
      out_.shear_modulus = py::array_t<double>(out_.shape);
    }
    bulk_ = out_.bulk_modulus.mutable_data();
    shear_ = out_.shear_modulus.mutable_data();
  }

  Moduli run() && {
    const Unlocked unlocked;
    const effective::BatchReport report = solve(0, rows_);
    if (report.failed == report.errors.size()) {
      take_errors(report, 0);
    } else { // more than fit in one report: in pieces small enough for a report
      for (std::size_t first = 0; first < rows_; first += effective::BatchReport::most_errors)
        take_errors(solve(first, std::min(rows_ - first, effective::BatchReport::most_errors)), first);
    }
    return std::move(out_);
  }

 private:
  static constexpr std::size_t out_at = 8;

  void write_to(const py::handle& given) {
    if (!py::isinstance<py::sequence>(given) || py::len(given) != 2)
      throw py::type_error("out is no two arrays of float64");
    const auto two = py::reinterpret_borrow<py::sequence>(given);
    out_.bulk_modulus = array_to_write(two[0], out_.shape);
    out_.shear_modulus = array_to_write(two[1], out_.shape);
    if (share_memory(out_.bulk_modulus, out_.shear_modulus))
      throw InvalidArgument("out holds two arrays of the same memory");
    for (BatchColumn* column : {&pressure_, &coordination_number_, &porosity_})
      for (const py::array& written : {out_.bulk_modulus, out_.shear_modulus})
        column->leave(written);
  }
  effective::BatchReport solve(std::size_t first, std::size_t count) {
    return effective::uniform_strain({.law = law_,
                                      .tangential_ratio = tangential_ratio_,
                                      .radius = radius_,
                                      .pressure = pressure_.rows(first, count),
                                      .coordination_number = coordination_number_.rows(first, count),
                                      .porosity = porosity_.rows(first, count),
                                      .contacts = contacts_},
                                     {std::span(bulk_ + first, count), std::span(shear_ + first, count)});
  }
  void take_errors(const effective::BatchReport& report, std::size_t first) {
    for (const effective::RowError& error : report.errors) {
      const std::size_t row = first + error.row;
      bulk_[row] = shear_[row] = nan;
      out_.errors.emplace(row, error.message);
    }
  }

  const contact::NormalLaw& law_;
  sizes::ContactMeans contacts_;
  double tangential_ratio_, radius_;
  BatchColumn pressure_, coordination_number_, porosity_;
  std::size_t rows_ = 0;
  Moduli out_;
  double* bulk_ = nullptr;
  double* shear_ = nullptr;
};

py::object shown(const py::array_t<double>& array) {
  return array.ndim() == 0 ? py::object(py::float_(*array.data())) : py::object(array);
}

} // namespace

py::object estimate_object(const RungAnswer& answer) {
  Notes notes;
  Stiffnesses out;
  out.rows.push_back(row_of(answer, notes));
  out.notes = notes.take(1, true);
  out.has_error = answer.relative_error.has_value();
  return py::cast(std::move(out));
}

py::object estimate_object(Rows<StiffnessRow> rows) { return py::cast(Stiffnesses{std::move(rows)}); }

void bind_effective(py::module_& module) {
  bind_estimate(module);
  bind_fields(module);
  bind_rung_functions(module);
  bind_rungs(module);
}

void bind_batch(py::module_& module) {
  ResultClass<Moduli>(module, "Moduli", "Bulk and shear modulus of isotropic packings.")
      .show("bulk_modulus", "K [Pa].", [](const Moduli& m) { return shown(m.bulk_modulus); })
      .show("shear_modulus", "G [Pa].", [](const Moduli& m) { return shown(m.shear_modulus); })
      .show("errors", "Messages of the elements that were refused, by index; their moduli are NaN.",
            [](const Moduli& m) { return errors_by_index(m.errors, m.shape); });
  define(
      module, "uniform_strain_moduli",
      {law_keyword(), of_input(estimate::Input::radius, "float"),
       column("porosity", "Voids in the volume, in (0, 1) [1]."),
       column("coordination_number", "C_n in [0, 1e6] [1]."), column("pressure", "p in [0, 1e200] [Pa]."),
       tangential_ratio_keyword(), contact_means_keyword(), strict_keyword(),
       optional("out", "(2,) sequence of ndarray",
                "Arrays for K and G, of float64, contiguous, of the shape of the results; may be arrays of "
                "the arguments. Default: new arrays, whose allocation takes longer than the calculation.")},
      {"K and G under uniform strain of many isotropic packings at isotropic stress, rung 0.\n\nFast for "
       "large arrays; equal to answer(rung=0) within 1e-14.",
       "Moduli\n    Its arrays are those of out, if given.",
       "For impossible numbers (with arrays only under strict), or an out of another shape.",
       "K = C_n k_n/(6 pi R (1+e)) at the mean contact force, G = 3 (2 + 3 k_t/k_n)/10 K. [Walton1987]",
       "effective::uniform_strain", "effective/batch.hpp",
       "TypeError\n    Unless out is two writable arrays of float64.\n"},
      [](const Arguments& a) {
        const bool strict = is_strict(a);
        Moduli moduli = Batch(a).run();
        if (!moduli.errors.empty() && (strict || moduli.shape.empty()))
          throw InvalidArgument(moduli.errors.begin()->second);
        return py::cast(std::move(moduli));
      });
}

} // namespace granum::python

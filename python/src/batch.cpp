// SPDX-License-Identifier: GPL-3.0-or-later
// Many packings in one call.
#include <pybind11/pybind11.h>
#include <pybind11/stl.h>

#include <algorithm>
#include <limits>

#include <granum/effective/batch.hpp>

#include "bindings.hpp"
#include "errors.hpp"
#include "members.hpp"
#include "rows.hpp"
#include "shared_keywords.hpp"

namespace granum::python {

namespace {

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
      bulk_[row] = shear_[row] = std::numeric_limits<double>::quiet_NaN();
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
       optional(
           "out", "(2,) sequence of ndarray",
           "Arrays for K and G, of float64, contiguous, of the shape of the results; may be arrays of the\n"
           "    arguments. Default: new arrays, whose allocation takes longer than the calculation.")},
      {"K and G under uniform strain of many isotropic packings at isotropic stress, rung 0.\n\nFast for "
       "large "
       "arrays; equal to answer(rung=0) within 1e-14.",
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

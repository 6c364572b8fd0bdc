// SPDX-License-Identifier: GPL-3.0-or-later
#include "arrays.hpp"

#include <algorithm>
#include <limits>

#include <granum/core/error.hpp>

namespace granum::python {

namespace {

[[noreturn]] void refuse_type(const char* name, const std::string& what) {
  throw py::type_error(std::string(name) + what);
}

[[noreturn]] void refuse_shape(const char* name, const py::array& array, const std::string& expected) {
  throw InvalidArgument(std::string(name) + " has the shape " + shape_text(array) + ", not " + expected);
}

/// A column of pandas in which numbers may be missing, as NaN.
py::array without_missing(const char* name, const py::handle& column) {
  try {
    return column.attr("to_numpy")(py::arg("dtype") = "float64",
                                   py::arg("na_value") = std::numeric_limits<double>::quiet_NaN());
  } catch (py::error_already_set&) { // of texts
    refuse_type(name, " is not an array of numbers");
  }
}

} // namespace

py::array read_only(py::array array) {
  py::detail::array_proxy(array.ptr())->flags &= ~py::detail::npy_api::NPY_ARRAY_WRITEABLE_;
  return array;
}

py::array array_of(const Vec3& v) { return py::array_t<double>(3, &v.x); }

py::array array_of(const Mat3& m) { return py::array_t<double>({3, 3}, &m.m[0][0]); }

py::array array_of(const std::vector<double>& numbers) {
  return py::array_t<double>(static_cast<py::ssize_t>(numbers.size()), numbers.data());
}

py::array array_of(const std::vector<Vec3>& vectors) {
  const double* const first = vectors.empty() ? nullptr : &vectors.front().x;
  return py::array_t<double>({static_cast<py::ssize_t>(vectors.size()), py::ssize_t{3}}, first);
}

py::array array_of(const elastic::Matrix6& matrix) {
  py::array_t<double> out({6, 6});
  auto to = out.mutable_unchecked<2>();
  for (py::ssize_t i = 0; i < 6; ++i)
    for (py::ssize_t j = 0; j < 6; ++j)
      to(i, j) = matrix(i, j);
  return out;
}

std::string shape_text(const py::array& array) { return py::str(py::object(array.attr("shape"))); }

py::array_t<double> numbers_of(const char* name, const py::handle& value) {
  if (!value || value.is_none())
    refuse_type(name, " is None, where a number or an array of numbers is needed");
  const bool plain = Py_TYPE(value.ptr()) == py::detail::npy_api::get().PyArray_Type_;
  if (!plain && py::isinstance(value, py::module_::import("numpy.ma").attr("MaskedArray")))
    refuse_type(name, " is a masked array: fill it or take its compressed() values");
  py::array any = py::array::ensure(value);
  if (any && any.dtype().kind() == 'O' && !plain && py::hasattr(value, "to_numpy"))
    any = without_missing(name, value);
  if (!any) {
    PyErr_Clear();
    refuse_type(name, " is not an array of numbers");
  }
  const char kind = any.dtype().kind();
  if (kind != 'f' && kind != 'i' && kind != 'u')
    refuse_type(name, " is not an array of real numbers, in SI, but of " + std::string(py::str(any.dtype())));
  return py::array_t<double>(any);
}

py::array_t<double> table_of(const char* name, const py::handle& value, py::ssize_t columns) {
  const py::array_t<double, py::array::c_style | py::array::forcecast> array = numbers_of(name, value);
  if (columns == 0 ? array.ndim() != 1 : array.ndim() != 2 || array.shape(1) != columns)
    refuse_shape(name, array, columns == 0 ? "(N,)" : "(N, " + std::to_string(columns) + ")");
  return array;
}

std::vector<double> list_of(const char* name, const py::handle& value) {
  const py::array_t<double> array = table_of(name, value, 0);
  return {array.data(), array.data() + array.size()};
}

std::vector<Vec3> vectors_of(const char* name, const py::handle& value) {
  const py::array_t<double> array = table_of(name, value, 3);
  std::vector<Vec3> out(static_cast<std::size_t>(array.shape(0)));
  const double* from = array.data();
  for (Vec3& v : out) {
    v = {from[0], from[1], from[2]};
    from += 3;
  }
  return out;
}

namespace {

/// The numbers of an array of one shape, by rows.
py::array_t<double, py::array::c_style | py::array::forcecast>
of_shape(const char* name, const py::handle& value, const std::vector<py::ssize_t>& shape) {
  py::array_t<double, py::array::c_style | py::array::forcecast> array = numbers_of(name, value);
  const bool same = array.ndim() == static_cast<py::ssize_t>(shape.size()) &&
                    std::equal(shape.begin(), shape.end(), array.shape());
  if (!same)
    refuse_shape(name, array, py::str(py::object(py::tuple(py::cast(shape)))));
  return array;
}

} // namespace

Vec3 vector_of(const char* name, const py::handle& value) {
  const auto array = of_shape(name, value, {3});
  return {array.data()[0], array.data()[1], array.data()[2]};
}

Mat3 matrix_of(const char* name, const py::handle& value) {
  const auto array = of_shape(name, value, {3, 3});
  Mat3 out;
  std::copy_n(array.data(), 9, &out.m[0][0]);
  return out;
}

elastic::VoigtStiffness stiffness_of(const char* name, const py::handle& value) {
  const auto array = of_shape(name, value, {6, 6});
  elastic::VoigtStiffness out;
  for (int i = 0; i < 6; ++i)
    for (int j = 0; j < 6; ++j)
      out.matrix(i, j) = array.data()[6 * i + j];
  return out;
}

double number_of(const char* name, const py::handle& value) {
  if (value && PyFloat_Check(value.ptr()))
    return PyFloat_AS_DOUBLE(value.ptr());
  if (value && PyLong_CheckExact(value.ptr())) { // of any length
    const double number = PyLong_AsDouble(value.ptr());
    if (PyErr_Occurred() != nullptr)
      throw py::error_already_set();
    return number;
  }
  const py::array_t<double> array = numbers_of(name, value);
  if (array.ndim() != 0)
    refuse_type(name, " is an array of shape " + shape_text(array) + ", where one number is needed");
  return *array.data();
}

} // namespace granum::python

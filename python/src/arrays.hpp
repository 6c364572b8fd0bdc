// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <pybind11/numpy.h>
#include <pybind11/pybind11.h>
#include <pybind11/stl.h>

#include <optional>
#include <span>
#include <string>
#include <vector>

#include <granum/core/vec3.hpp>
#include <granum/elastic/stiffness.hpp>

/// Numbers of the library as numpy arrays, and back.
namespace granum::python {

namespace py = pybind11;

template <class Type>
inline constexpr bool is_optional = false;
template <class Type>
inline constexpr bool is_optional<std::optional<Type>> = true;

/// The array, read-only: its memory belongs to a result.
[[nodiscard]] py::array read_only(py::array array);

/// A view of numbers that lie `stride` bytes apart; `owner` keeps them alive.
template <class Number>
[[nodiscard]] py::array view(const std::vector<py::ssize_t>& shape, const std::vector<py::ssize_t>& strides,
                             const Number* first, const py::handle& owner) {
  return read_only(py::array(py::dtype::of<Number>(), shape, strides, first, owner));
}

/// One number of every element of a vector of structs, without a copy.
template <class Element, class Number>
[[nodiscard]] py::array member_view(const std::vector<Element>& elements, const Number Element::*member,
                                    const py::handle& owner) {
  const Number* first = elements.empty() ? nullptr : &(elements.front().*member);
  if (first == nullptr)
    return py::array(py::dtype::of<Number>(), std::vector<py::ssize_t>{0});
  return view<Number>({static_cast<py::ssize_t>(elements.size())}, {sizeof(Element)}, first, owner);
}
/// The same of a vector, as rows of three numbers.
template <class Element>
[[nodiscard]] py::array member_view(const std::vector<Element>& elements, const Vec3 Element::*member,
                                    const py::handle& owner) {
  if (elements.empty())
    return py::array(py::dtype::of<double>(), std::vector<py::ssize_t>{0, 3});
  return view<double>({static_cast<py::ssize_t>(elements.size()), 3}, {sizeof(Element), sizeof(double)},
                      &(elements.front().*member).x, owner);
}

/// Copies.
[[nodiscard]] py::array array_of(const Vec3& vector);
[[nodiscard]] py::array array_of(const Mat3& matrix);
[[nodiscard]] py::array array_of(const std::vector<double>& numbers);
/// (N, 3), one vector a row.
[[nodiscard]] py::array array_of(const std::vector<Vec3>& vectors);
[[nodiscard]] py::array array_of(const elastic::Matrix6& matrix);

/// A numpy array of float64 from any real numbers; None and other objects are refused.
/// \throws   TypeError naming the argument for a masked array and for anything but an array of real numbers
[[nodiscard]] py::array_t<double> numbers_of(const char* name, const py::handle& value);

/// The same, contiguous by rows.
/// \param    columns   numbers in a row; 0 for a plain list
/// \throws   InvalidArgument naming the argument for another shape; TypeError as numbers_of
[[nodiscard]] py::array_t<double> table_of(const char* name, const py::handle& value, py::ssize_t columns);

/// \throws   as table_of
[[nodiscard]] std::vector<double> list_of(const char* name, const py::handle& value);
[[nodiscard]] std::vector<Vec3> vectors_of(const char* name, const py::handle& value);
[[nodiscard]] Vec3 vector_of(const char* name, const py::handle& value);
[[nodiscard]] Mat3 matrix_of(const char* name, const py::handle& value);
[[nodiscard]] elastic::VoigtStiffness stiffness_of(const char* name, const py::handle& value);
/// One number.
/// \throws   TypeError naming the argument for anything but a number
[[nodiscard]] double number_of(const char* name, const py::handle& value);

/// "(3, 6)"
[[nodiscard]] std::string shape_text(const py::array& array);

} // namespace granum::python

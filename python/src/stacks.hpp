// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <pybind11/numpy.h>
#include <pybind11/pybind11.h>

#include <cstddef>
#include <string>
#include <vector>

#include <granum/core/vec3.hpp>
#include <granum/elastic/stiffness.hpp>

#include "rows.hpp"

/// Arguments whose elements are matrices or vectors: (..., 6, 6), (..., 3, 3) or (..., 3). All axes but the
/// last ones are broadcast with the columns of the call.
/// Checked by python/tests/test_stacks.py
namespace granum::python {

class Stack {
 public:
  /// \param    axes   lengths of the last axes
  /// \throws   InvalidArgument naming the keyword for another shape; TypeError as numbers_of
  Stack(const Arguments& arguments, std::size_t keyword, const std::vector<py::ssize_t>& axes);

  /// The column of the elements' places, for Columns.
  [[nodiscard]] Argument column() const;
  /// The numbers of the element at a place, by rows.
  [[nodiscard]] const double* at(double place) const {
    return numbers_.data() + size_ * static_cast<std::size_t>(place);
  }

 private:
  const char* name_;
  py::array_t<double, py::array::c_style | py::array::forcecast> numbers_;
  std::size_t size_ = 1; ///< numbers of an element
  py::object places_;    ///< none for a single element
};

/// A matrix of numbers by rows.
[[nodiscard]] elastic::VoigtStiffness stiffness_at(const double* numbers);
/// (..., 6, 6), or (6, 6) of a single element.
[[nodiscard]] py::array matrices_of(const std::vector<py::ssize_t>& shape,
                                    const std::vector<elastic::Matrix6>& all);

} // namespace granum::python

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <pybind11/pybind11.h>

namespace granum::python {

namespace py = pybind11;

/// A Range of Python: floats, or arrays that keep alive what they are views of.
struct RangeView {
  py::object value, low, high;
};

} // namespace granum::python

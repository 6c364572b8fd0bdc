// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <pybind11/pybind11.h>

#include <exception>

#include <granum/core/stop_request.hpp>

/// Errors of the library as exceptions of Python.
namespace granum::python {

/// Sets Python's error indicator from a C++ exception.
void set_python_error(std::exception_ptr error) noexcept;

/// Whether Ctrl-C was pressed; called periodically by long work, with the interpreter's lock released. The
/// work then throws Stopped, which becomes the exception of the signal.
[[nodiscard]] StopRequest stop_on_signal();

/// Raises the exception of the signal that ended some work; for work that returns early instead of throwing.
void throw_if_signalled();

} // namespace granum::python

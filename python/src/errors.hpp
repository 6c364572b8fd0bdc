// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <pybind11/pybind11.h>

#include <exception>

#include <granum/core/stop_request.hpp>

/// Errors of the library as exceptions of Python.
namespace granum::python {

/// Sets Python's error indicator to what a C++ exception says.
void set_python_error(std::exception_ptr error) noexcept;

/// What long work asks now and then, with the interpreter's lock released: whether Ctrl-C was pressed. The
/// work then throws Stopped, which becomes the exception of the signal.
[[nodiscard]] StopRequest stop_on_signal();

/// Raises what the signal that ended some work has raised; for work that returns early instead of throwing.
void throw_if_signalled();

} // namespace granum::python

// SPDX-License-Identifier: GPL-3.0-or-later
#include "errors.hpp"

#include <chrono>
#include <filesystem>

#include <granum/core/error.hpp>

#include "bindings.hpp"

namespace granum::python {

namespace {

/// The class of that name in granum/_errors.py.
py::object error_class(const char* name) { return py::module_::import("granum._errors").attr(name); }

void raise(const py::object& type, const py::object& error) { PyErr_SetObject(type.ptr(), error.ptr()); }

void raise(const char* name, const std::exception& error) {
  const py::object type = error_class(name);
  raise(type, type(decoded(error.what())));
}

void raise(const InvalidArgument& error) {
  const py::object type = error_class("InvalidArgument");
  py::object object = type(decoded(error.what()));
  if (const auto& refused = error.refused()) {
    object.attr("name") = decoded(refused->name);
    object.attr("value") = refused->value;
    object.attr("unit") = refused->unit;
    object.attr("range") = refused->range;
  }
  raise(type, object);
}

void raise(const FileError& error) {
  const auto path = py::reinterpret_steal<py::object>(PyUnicode_DecodeFSDefaultAndSize(
      error.path().data(), static_cast<py::ssize_t>(error.path().size()))); // a name that open() takes
  const py::object line = error.line() > 0 ? py::object(py::int_(error.line())) : py::none();
  const py::object object = error_class("_file_error")(decoded(error.what()), path, line);
  raise(py::type::of(object), object);
}

void set_error(const std::exception_ptr& error) {
  try {
    std::rethrow_exception(error);
  } catch (py::error_already_set& e) {
    e.restore();
  } catch (const py::builtin_exception& e) {
    e.set_error();
  } catch (const InvalidArgument& e) {
    raise(e);
  } catch (const FileError& e) {
    raise(e);
  } catch (const NotConverged& e) {
    raise("NotConverged", e);
  } catch (const Stopped& e) {
    if (PyErr_Occurred() == nullptr) // of a signal, see stop_on_signal
      raise("Stopped", e);
  } catch (const Error& e) {
    raise("Error", e);
  } catch (const std::bad_alloc&) {
    PyErr_NoMemory();
  } catch (const std::exception& e) {
    PyErr_SetObject(PyExc_RuntimeError, decoded(e.what()).ptr());
  }
}

} // namespace

py::str decoded(std::string_view text) {
  return py::reinterpret_steal<py::str>(
      PyUnicode_DecodeUTF8(text.data(), static_cast<py::ssize_t>(text.size()), "backslashreplace"));
}

void set_python_error(std::exception_ptr error) noexcept {
  try {
    set_error(error);
  } catch (py::error_already_set& e) {
    e.restore();
  }
}

StopRequest stop_on_signal() {
  using Clock = std::chrono::steady_clock;
  const auto pause = std::chrono::milliseconds(50); // asking for the lock may take another thread's turn
  return [pause, next = Clock::now() + pause, stopped = false]() mutable {
    if (stopped || Clock::now() < next)
      return stopped;
    const py::gil_scoped_acquire lock;
    stopped = PyErr_Occurred() != nullptr || PyErr_CheckSignals() != 0;
    next = Clock::now() + pause;
    return stopped;
  };
}

void throw_if_signalled() {
  if (PyErr_Occurred() != nullptr)
    throw py::error_already_set();
}

void hear_signals(std::size_t step) {
  if (step % 4096 == 0 && PyErr_CheckSignals() != 0)
    throw py::error_already_set();
}

void bind_errors(py::module_&) {
  py::register_exception_translator([](std::exception_ptr error) {
    if (!error)
      return;
    try {
      std::rethrow_exception(error);
    } catch (const Error&) {
      set_python_error(error);
    } catch (const std::filesystem::filesystem_error&) { // names files, too
      set_python_error(error);
    }
  });
}

} // namespace granum::python

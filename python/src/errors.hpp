// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <pybind11/pybind11.h>

#include <exception>
#include <string_view>

#include <granum/core/stop.hpp>

/// Errors of the library as exceptions of Python.
namespace granum::python {

namespace py = pybind11;

/// A text of the library: it may name files and their columns, which are bytes in any encoding. Bytes that
/// are no UTF-8 become "\xff".
[[nodiscard]] py::str decoded(std::string_view text);

/// Sets Python's error indicator from a C++ exception.
void set_python_error(std::exception_ptr error) noexcept;

/// Whether Ctrl-C was pressed; called periodically by long work, with the interpreter's lock released. The
/// work then throws Stopped, which becomes the exception of the signal.
[[nodiscard]] StopRequest stop_on_signal();

/// Raises the exception of the signal that ended some work; for work that returns early instead of throwing.
void throw_if_signalled();

/// Handles signals in loops of short steps that hold the interpreter's lock.
void hear_signals(std::size_t step);

/// Long work of the library: other threads of Python run meanwhile, and Ctrl-C ends it at its next
/// stop_point.
class Unlocked {
 public:
  Unlocked() : scope_(stop_on_signal()) {}

 private:
  py::gil_scoped_release released_;
  StopScope scope_;
};

/// Long work as a function.
template <class Work>
auto unlocked(const Work& work) {
  const Unlocked scope;
  return work();
}

/// Keeps other threads out of an iterator whose step releases the interpreter's lock.
class OneStep {
 public:
  /// \param    running   of the iterator; read and written with the interpreter's lock only
  /// \throws   ValueError while another step runs, as generators of Python
  explicit OneStep(bool& running) : running_(running) {
    if (running)
      throw py::value_error("the iterator is already executing a step, in another thread");
    running = true;
  }
  ~OneStep() { running_ = false; }
  OneStep(const OneStep&) = delete;
  OneStep& operator=(const OneStep&) = delete;

 private:
  bool& running_;
};

} // namespace granum::python

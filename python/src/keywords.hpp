// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <pybind11/pybind11.h>

#include <cstddef>
#include <functional>
#include <initializer_list>
#include <span>
#include <string>
#include <vector>

/// Functions that take keywords, called without the overload resolution of pybind11, which takes longer
/// than a closed form: a name is compared by its address.
namespace granum::python {

namespace py = pybind11;

struct KeywordFunction;

/// The objects of a call in the order of the function's keywords; null where one was left out.
class Arguments {
 public:
  Arguments(const KeywordFunction& function, std::span<PyObject* const> values)
      : function_(function), values_(values) {}

  [[nodiscard]] bool given(std::size_t k) const { return values_[k] != nullptr && values_[k] != Py_None; }
  /// Whether a value was given.
  [[nodiscard]] bool is_none(std::size_t k) const { return values_[k] == Py_None; }
  [[nodiscard]] py::handle operator[](std::size_t k) const { return values_[k]; }
  /// The given value, as a value of the library.
  /// \param    expected   in words, "a contact law"
  /// \throws   TypeError that names the keyword, for an object of another kind or None
  template <class Value>
  [[nodiscard]] Value as(std::size_t k, const char* expected) const {
    if (values_[k] == Py_None)
      refuse(k, expected);
    try {
      return py::handle(values_[k]).cast<Value>();
    } catch (const py::cast_error&) {
      refuse(k, expected);
    }
  }
  [[nodiscard]] std::string text(std::size_t k) const { return as<std::string>(k, "a string"); }
  /// True if it was given and is true.
  [[nodiscard]] bool flag(std::size_t k) const { return given(k) && as<bool>(k, "True or False"); }

 private:
  [[noreturn]] void refuse(std::size_t k, const char* expected) const;

  const KeywordFunction& function_;
  std::span<PyObject* const> values_;
};

/// A keyword of a function, and the displayed default; null: it is required.
struct Keyword {
  const char* name;
  const char* shown_default = nullptr;
};

/// A function that takes keywords.
struct KeywordFunction {
  const char* name;
  std::vector<Keyword> keywords;
  std::function<py::object(const Arguments& arguments)> call;
  std::string documentation;
  std::size_t positional = 0; ///< number of arguments that may be given without names
};

/// Puts the function in the module. Its signature can be inspected.
void define(py::module_& module, KeywordFunction function);

} // namespace granum::python

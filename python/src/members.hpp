// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <pybind11/pybind11.h>
#include <pybind11/stl.h>

#include <concepts>
#include <functional>
#include <optional>
#include <type_traits>
#include <utility>

#include <granum/core/error.hpp>

#include "functions.hpp"

/// Results that are plain structs, as classes of Python with a property a member.
namespace granum::python {

namespace py = pybind11;

/// The end of a path of members and functions without arguments; std::nullopt behind a part that is missing.
template <class Object, class First, class... Rest>
[[nodiscard]] decltype(auto) end_of(const Object& object, First first, Rest... rest) {
  if constexpr (is_optional<Object>) {
    using Value = std::remove_cvref_t<decltype(end_of(*object, first, rest...))>;
    return object ? std::optional<Value>(end_of(*object, first, rest...)) : std::optional<Value>();
  } else if constexpr (sizeof...(rest) == 0) {
    return std::invoke(first, object);
  } else if constexpr (std::is_reference_v<decltype(std::invoke(first, object))>) {
    return end_of(std::invoke(first, object), rest...);
  } else {
    const auto part = std::invoke(first, object);
    using Value = std::remove_cvref_t<decltype(end_of(part, rest...))>;
    return Value(end_of(part, rest...));
  }
}

/// A class of Python for a struct of results.
template <class Type, class... Holder>
class ResultClass : public py::class_<Type, Holder...> {
 public:
  using py::class_<Type, Holder...>::class_;

  /// A property: the end of a path of members, or what a function of the struct gives. Vectors and matrices
  /// become arrays, a validity its notes.
  template <class... Path>
  ResultClass& show(const char* name, const char* says, Path... path) {
    using End = std::remove_cvref_t<decltype(end_of(std::declval<const Type&>(), path...))>;
    if constexpr (std::same_as<End, Validity>)
      return show(name, says, path..., &Validity::notes);
    else if constexpr (std::same_as<End, Vec3> || std::same_as<End, Mat3> ||
                       std::same_as<End, elastic::Matrix6>)
      this->def_property_readonly(
          name, [path...](const Type& value) { return array_of(end_of(value, path...)); }, says);
    else
      this->def_property_readonly(
          name, [path...](const Type& value) -> decltype(auto) { return end_of(value, path...); }, says);
    return *this;
  }
  ResultClass& show_notes() {
    return show("notes", "Remarks on numbers outside the range of a formula, a sentence each.",
                &Type::validity);
  }
};

/// A class of iterators over what next() of the struct gives.
template <class Type>
ResultClass<Type> iterator_class(const py::object& module, const char* name, const char* says) {
  ResultClass<Type> type(module, name, says);
  type.def("__iter__", [](const py::object& self) { return self; }).def("__next__", &Type::next);
  return type;
}

/// A function without arguments that returns the rows of a table of the library, by their keys.
template <class Table>
void define_table(const py::object& module, const char* name, Table table, Docstring text) {
  define(module, name, {}, std::move(text), [table] {
    py::dict all;
    for (const auto& row : table)
      all[py::str(row.key)] = py::cast(&row, py::return_value_policy::reference);
    return all;
  });
}

} // namespace granum::python

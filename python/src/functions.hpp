// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <pybind11/pybind11.h>

#include <concepts>
#include <cstddef>
#include <functional>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <type_traits>
#include <utility>
#include <vector>

#include <granum/core/error.hpp>

#include "arrays.hpp"

/// Functions and methods of Python: signature, docstring and errors come from one list of keywords.
/// They are called without the overload resolution of pybind11, which takes longer than a closed form, names
/// no argument in its errors, and gives no signature to inspect.
namespace granum::python {

namespace py = pybind11;

/// A keyword of a function, and its entry in the docstring.
struct Keyword {
  std::string name;
  const char* shown_default = nullptr; ///< null: it is required
  std::string type = {};               ///< of numpydoc; each "array_like" is a column of the call
  std::string says = {};               ///< empty: the text of the next keyword
  const char* in_library = nullptr;    ///< its name in messages of the library, if different
  double number = 0;                   ///< of a number that is left out

  /// The same with another name in messages of the library.
  [[nodiscard]] Keyword called(const char* name_in_library) const;
  /// The same with a default: None, or a number.
  [[nodiscard]] Keyword or_none() const;
  [[nodiscard]] Keyword or_number(double number) const;
};

[[nodiscard]] Keyword required(std::string name, std::string type, std::string says);
/// None by default; the type gets ", optional".
[[nodiscard]] Keyword optional(std::string name, std::string type, std::string says);
[[nodiscard]] Keyword with_default(std::string name, const char* shown, std::string type, std::string says);
/// A number of every element of a call.
[[nodiscard]] Keyword column(std::string name, std::string says);
/// Entries of the section Parameters.
[[nodiscard]] std::string entries(const std::vector<Keyword>& keywords);

/// A docstring but for the entries of the keywords.
struct Docstring {
  std::string summary = {}; ///< one line; paragraphs may follow
  std::string returns = {}; ///< the type; an indented text may follow
  std::string refuses = {}; ///< when InvalidArgument is raised
  std::string remarks = {}; ///< with keys of validation/references.bib
  std::string function = {}, header = {};
  std::string more_errors = {}; ///< entries of the section Raises
};

struct KeywordFunction;

/// The objects of a call in the order of the function's keywords; null where one was left out.
class Arguments {
 public:
  Arguments(const KeywordFunction& function, std::span<PyObject* const> values)
      : function_(function), values_(values) {}

  [[nodiscard]] const KeywordFunction& function() const { return function_; }
  [[nodiscard]] const Keyword& keyword(std::size_t k) const;
  [[nodiscard]] const char* name(std::size_t k) const { return keyword(k).name.c_str(); }
  /// The place of a keyword, for functions that take longer than a search.
  [[nodiscard]] std::size_t at(std::string_view keyword_name) const;
  /// Whether a value was given.
  [[nodiscard]] bool given(std::size_t k) const { return values_[k] != nullptr && values_[k] != Py_None; }
  [[nodiscard]] bool is_none(std::size_t k) const { return values_[k] == Py_None; }
  [[nodiscard]] py::handle operator[](std::size_t k) const { return values_[k]; }
  /// The given value, as a value of the library.
  /// \param    expected   in words, "a contact law"; empty: the type of the keyword
  /// \throws   TypeError that names the keyword, for an object of another kind or None
  template <class Value>
  [[nodiscard]] Value as(std::size_t k, std::string_view expected = {}) const {
    if (values_[k] == Py_None)
      refuse(k, expected);
    if constexpr (std::is_base_of_v<py::array, Value>) {
      if (Value array = Value::ensure(values_[k]))
        return array;
      refuse(k, expected);
    }
    try {
      return py::handle(values_[k]).cast<Value>();
    } catch (const py::cast_error&) {
      refuse(k, expected);
    }
  }
  [[nodiscard]] std::string text(std::size_t k) const { return as<std::string>(k, "a string"); }
  /// True if it was given and is true.
  [[nodiscard]] bool flag(std::size_t k) const { return given(k) && as<bool>(k, "True or False"); }
  /// \throws   TypeError as number_of
  [[nodiscard]] double number(std::size_t k) const {
    return !given(k) && keyword(k).shown_default != nullptr ? keyword(k).number
                                                            : number_of(name(k), values_[k]);
  }
  [[nodiscard]] std::optional<double> number_if_given(std::size_t k) const {
    return given(k) ? std::optional(number(k)) : std::nullopt;
  }
  /// The value of a word.
  /// \throws   InvalidArgument that names the keyword and its words
  template <class Value, std::size_t count>
  [[nodiscard]] Value choice(std::size_t k, const std::pair<const char*, Value> (&all)[count]) const {
    const std::string word = text(k);
    std::string known;
    for (const auto& [name, value] : all) {
      if (word == name)
        return value;
      known += std::string(known.empty() ? "" : ", ") + name;
    }
    throw InvalidArgument(keyword(k).name + " is one of " + known + ", not " + word);
  }

 private:
  [[noreturn]] void refuse(std::size_t k, std::string_view expected) const;

  const KeywordFunction& function_;
  std::span<PyObject* const> values_;
};

/// A function that takes keywords.
struct KeywordFunction {
  const char* name;
  std::vector<Keyword> keywords;
  std::function<py::object(const Arguments& arguments)> call;
  std::string documentation;
  std::size_t positional = 0; ///< number of arguments that may be given without names
  Docstring text = {};        ///< with the entries of the keywords, where there is no documentation
  std::vector<std::size_t> columns = {};  ///< places of the keywords that are array_like
  std::optional<std::size_t> strict = {}; ///< the place of the flag
};

/// The function with its columns and its flag found.
[[nodiscard]] KeywordFunction indexed(KeywordFunction function);

/// \throws   std::logic_error for a name that the function has not
[[nodiscard]] std::size_t place_of(const KeywordFunction& function, std::string_view name);
inline const Keyword& Arguments::keyword(std::size_t k) const { return function_.keywords[k]; }

template <class Type>
inline constexpr bool is_shared = false;
template <class Type>
inline constexpr bool is_shared<std::shared_ptr<Type>> = true;

/// An argument as a parameter of C++.
template <class Parameter>
[[nodiscard]] decltype(auto) taken(const Arguments& a, std::size_t k) {
  using Value = std::remove_cvref_t<Parameter>;
  if constexpr (is_optional<Value>)
    return a.given(k) ? Value(taken<typename Value::value_type>(a, k)) : Value();
  else if constexpr (std::same_as<Value, py::object>)
    return a.given(k) ? py::reinterpret_borrow<py::object>(a[k]) : py::object(py::none());
  else if constexpr (std::same_as<Value, double>)
    return a.number(k);
  else if constexpr (std::same_as<Value, bool>)
    return a.flag(k);
  else if constexpr (std::same_as<Value, std::string>)
    return a.text(k);
  else if constexpr (std::integral<Value>)
    return a.as<Value>(k, "a whole number, 0 or more");
  else if constexpr (std::same_as<Value, Vec3>)
    return vector_of(a.name(k), a[k]);
  else if constexpr (std::same_as<Value, Mat3>)
    return matrix_of(a.name(k), a[k]);
  else if constexpr (std::same_as<Value, elastic::VoigtStiffness>)
    return stiffness_of(a.name(k), a[k]);
  else if constexpr (std::same_as<Value, std::vector<Vec3>>)
    return vectors_of(a.name(k), a[k]);
  else if constexpr (std::same_as<Value, std::vector<double>>)
    return list_of(a.name(k), a[k]);
  else if constexpr (is_shared<Value>)
    return a.as<Value>(k);
  else
    return a.as<const Value&>(k);
}

/// A call with the arguments converted to the parameters of a function.
template <class Result, class Function, class... Parameters>
[[nodiscard]] py::object called(const Function& function, const Arguments& a,
                                const std::function<Result(Parameters...)>&) {
  return [&]<std::size_t... k>(std::index_sequence<k...>)->py::object {
    if constexpr (std::is_base_of_v<py::object, Result>)
      return function(taken<Parameters>(a, k)...);
    else
      return py::cast(function(taken<Parameters>(a, k)...));
  }
  (std::index_sequence_for<Parameters...>());
}

/// A function of C++ with a docstring: of Arguments, or of one parameter a keyword, each converted by taken.
template <class Function>
[[nodiscard]] KeywordFunction function(const char* name, std::vector<Keyword> keywords, Docstring text,
                                       const Function& of, std::size_t positional = 0) {
  KeywordFunction out{name, std::move(keywords), {}, {}, positional, std::move(text)};
  if constexpr (std::is_invocable_v<Function, const Arguments&>)
    out.call = [of](const Arguments& a) { return py::object(of(a)); };
  else
    out.call = [of, type = decltype(std::function(of))()](const Arguments& a) { return called(of, a, type); };
  return indexed(std::move(out));
}

/// Puts a function in the module, or a method in a class. Its signature can be inspected.
void define(const py::object& scope, KeywordFunction function);
/// The same of a function of C++.
template <class Function>
void define(const py::object& scope, const char* name, std::vector<Keyword> keywords, Docstring text,
            const Function& of, std::size_t positional = 0) {
  define(scope, function(name, std::move(keywords), std::move(text), of, positional));
}
/// A method; the keywords are those after self.
template <class Function>
void define_method(const py::object& type, const char* name, std::vector<Keyword> keywords, Docstring text,
                   const Function& of, std::size_t positional = 0) {
  keywords.insert(keywords.begin(), required("self", "", ""));
  define(type, function(name, std::move(keywords), std::move(text), of, positional + 1));
}

} // namespace granum::python

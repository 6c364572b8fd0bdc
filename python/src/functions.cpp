// SPDX-License-Identifier: GPL-3.0-or-later
#include "functions.hpp"

#include <algorithm>
#include <array>
#include <deque>
#include <stdexcept>
#include <utility>

#include <granum/core/text.hpp>

#include "docstrings.hpp"
#include "errors.hpp"
#include "examples.hpp"

namespace granum::python {

namespace {

constexpr std::size_t most_keywords = 40;

/// Record of a function for its calls. Never freed: a module lives until the interpreter ends.
struct Record {
  KeywordFunction function;
  std::vector<PyObject*> names; ///< interned
  std::string text;
  PyMethodDef definition;
};

std::size_t place_of(const Record& record, PyObject* name) {
  for (std::size_t k = 0; k < record.names.size(); ++k)
    if (record.names[k] == name)
      return k;
  for (std::size_t k = 0; k < record.names.size(); ++k) // a name that was put together while running
    if (PyUnicode_Compare(record.names[k], name) == 0)
      return k;
  std::vector<std::string> known;
  for (const Keyword& keyword : record.function.keywords)
    known.push_back(keyword.name);
  const std::string typed = py::str(py::handle(name));
  throw py::type_error(std::string(record.function.name) + "() got an unexpected keyword argument '" + typed +
                       "'" + did_you_mean(typed, known));
}

/// The error with the name of the keyword as typed.
InvalidArgument typed_error(const InvalidArgument& error, const Arguments& a) {
  if (const auto& refused = error.refused())
    for (std::size_t k = 0; k < a.function().keywords.size(); ++k)
      if (const char* const name = a.keyword(k).in_library;
          name != nullptr && a.given(k) && refused->name == name)
        return {a.keyword(k).name, refused->value, refused->unit, refused->range};
  return error;
}

py::object call(const Record& record, PyObject* const* arguments, Py_ssize_t positional, PyObject* names) {
  const auto before = static_cast<std::size_t>(positional);
  if (before > record.function.positional)
    throw py::type_error(std::string(record.function.name) + "() takes " +
                         (record.function.positional == 0 ? "keyword arguments only"
                                                          : "other arguments by their keywords only"));
  std::array<PyObject*, most_keywords> values{};
  std::copy_n(arguments, before, values.begin());
  const Py_ssize_t count = names == nullptr ? 0 : PyTuple_GET_SIZE(names);
  for (Py_ssize_t k = 0; k < count; ++k) {
    PyObject*& value = values[place_of(record, PyTuple_GET_ITEM(names, k))];
    if (value != nullptr)
      throw py::type_error(std::string(record.function.name) + "() got multiple values for an argument");
    value = arguments[positional + k];
  }
  const auto& keywords = record.function.keywords;
  for (std::size_t k = 0; k < keywords.size(); ++k)
    if (values[k] == nullptr && keywords[k].shown_default == nullptr)
      throw py::type_error(std::string(record.function.name) + "() needs the keyword argument '" +
                           keywords[k].name + "'");
  const Arguments given(record.function, std::span(values.data(), keywords.size()));
  try {
    return record.function.call(given);
  } catch (const InvalidArgument& error) {
    throw typed_error(error, given);
  }
}

extern "C" PyObject* call_record(PyObject* self, PyObject* const* arguments, Py_ssize_t positional,
                                 PyObject* names) {
  try {
    const auto* record = static_cast<const Record*>(PyCapsule_GetPointer(self, nullptr));
    return call(*record, arguments, positional, names).release().ptr();
  } catch (...) {
    set_python_error(std::current_exception());
    return nullptr;
  }
}

std::string signature(const KeywordFunction& function) {
  std::string text = std::string(function.name) + "(";
  for (std::size_t k = 0; k < function.keywords.size(); ++k) {
    const Keyword& keyword = function.keywords[k];
    text += k == function.positional ? (k == 0 ? "*, " : ", *, ") : (k == 0 ? "" : ", ");
    text += keyword.name;
    if (keyword.shown_default != nullptr)
      text += std::string("=") + keyword.shown_default;
  }
  return text + ")\n--\n\n";
}

std::string documentation_of(const Docstring& text, const std::vector<Keyword>& keywords) {
  std::string out = text.summary + "\n";
  if (const std::string all = entries(keywords); !all.empty())
    out += "\nParameters\n----------\n" + all;
  if (!text.returns.empty())
    out += "\nReturns\n-------\n" + text.returns + "\n";
  if (!text.refuses.empty() || !text.more_errors.empty())
    out += "\nRaises\n------\n" +
           (text.refuses.empty() ? "" : "InvalidArgument\n    " + text.refuses + "\n") + text.more_errors;
  return out + (text.function.empty() ? "" : notes(text.remarks, text.function, text.header));
}

} // namespace

std::size_t place_of(const KeywordFunction& function, std::string_view name) {
  for (std::size_t k = 0; k < function.keywords.size(); ++k)
    if (function.keywords[k].name == name)
      return k;
  throw std::logic_error(std::string(function.name) + " has no " + std::string(name));
}

KeywordFunction indexed(KeywordFunction function) {
  for (std::size_t k = 0; k < function.keywords.size(); ++k)
    if (function.keywords[k].type.starts_with("array_like"))
      function.columns.push_back(k);
    else if (function.keywords[k].name == "strict")
      function.strict = k;
  return function;
}

Keyword Keyword::called(const char* name_in_library) const {
  Keyword out = *this;
  out.in_library = name_in_library;
  return out;
}

Keyword Keyword::or_none() const {
  Keyword out = *this;
  out.shown_default = "None";
  out.type += ", optional";
  return out;
}

Keyword Keyword::or_number(double otherwise) const {
  static auto& texts = *new std::deque<std::string>; // keywords point to them
  Keyword out = *this;
  out.shown_default = texts.emplace_back(py::repr(py::float_(otherwise))).c_str();
  out.number = otherwise;
  return out;
}

Keyword required(std::string name, std::string type, std::string says) {
  return with_default(std::move(name), nullptr, std::move(type), std::move(says));
}

Keyword optional(std::string name, std::string type, std::string says) {
  return required(std::move(name), std::move(type), std::move(says)).or_none();
}

Keyword with_default(std::string name, const char* shown, std::string type, std::string says) {
  return {std::move(name), shown, std::move(type), std::move(says)};
}

Keyword column(std::string name, std::string says) {
  return required(std::move(name), "array_like", std::move(says));
}

/// The text in indented lines.
std::string indented(std::string text) {
  constexpr std::size_t width = 108;
  for (std::size_t begin = 0; text.size() - begin > width;) {
    const std::size_t end = text.rfind(' ', begin + width);
    if (end == std::string::npos || end < begin) // a longer word
      break;
    text.replace(end, 1, "\n    ");
    begin = end + 5;
  }
  return "    " + std::move(text) + "\n";
}

std::string entries(const std::vector<Keyword>& keywords) {
  std::string text, names;
  for (const Keyword& keyword : keywords) {
    if (keyword.type.empty()) // self
      continue;
    names += (names.empty() ? "" : ", ") + keyword.name;
    if (keyword.says.empty()) // that of the next
      continue;
    text += names + " : " + keyword.type + "\n" + indented(keyword.says);
    names.clear();
  }
  return text;
}

std::size_t Arguments::at(std::string_view keyword_name) const { return place_of(function_, keyword_name); }

void Arguments::refuse(std::size_t k, std::string_view expected) const {
  const std::string& type = keyword(k).type;
  const std::string kind = type.starts_with("NormalLaw") ? "contact law" : type.substr(0, type.find(','));
  throw py::type_error(std::string(function_.name) + "(): " + keyword(k).name + " must be " +
                       (expected.empty() ? "a " + kind : std::string(expected)) + ", not " +
                       Py_TYPE(values_[k])->tp_name);
}

void define(const py::object& scope, KeywordFunction function) {
  static auto& records = *new std::deque<Record>;
  Record& record = records.emplace_back();
  record.function = std::move(function);
  if (record.function.keywords.size() > most_keywords)
    throw std::length_error(std::string(record.function.name) + " has too many keywords");
  for (const Keyword& keyword : record.function.keywords)
    record.names.push_back(PyUnicode_InternFromString(keyword.name.c_str()));
  record.text =
      signature(record.function) + (record.function.documentation.empty()
                                        ? documentation_of(record.function.text, record.function.keywords)
                                        : record.function.documentation);
  if (PyModule_Check(scope.ptr()) != 0)
    record.text += examples_section(record.function.name);
  record.definition = {record.function.name,
                       reinterpret_cast<PyCFunction>(reinterpret_cast<void (*)()>(call_record)),
                       METH_FASTCALL | METH_KEYWORDS, record.text.c_str()};
  const auto self = py::reinterpret_steal<py::object>(PyCapsule_New(&record, nullptr, nullptr));
  const auto name = py::reinterpret_steal<py::object>(PyUnicode_InternFromString("granum"));
  auto made =
      py::reinterpret_steal<py::object>(PyCFunction_NewEx(&record.definition, self.ptr(), name.ptr()));
  if (PyType_Check(scope.ptr()) != 0)
    made = py::reinterpret_steal<py::object>(PyInstanceMethod_New(made.ptr()));
  scope.attr(record.function.name) = made;
}

} // namespace granum::python

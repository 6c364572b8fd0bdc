// SPDX-License-Identifier: GPL-3.0-or-later
#include "keywords.hpp"

#include <algorithm>
#include <array>
#include <deque>
#include <utility>

#include <granum/core/near_miss.hpp>

#include "errors.hpp"

namespace granum::python {

namespace {

constexpr std::size_t most_keywords = 32;

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
    known.emplace_back(keyword.name);
  const std::string typed = py::str(py::handle(name));
  throw py::type_error(std::string(record.function.name) + "() got an unexpected keyword argument '" + typed +
                       "'" + did_you_mean(typed, known));
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
  return record.function.call(Arguments(record.function, std::span(values.data(), keywords.size())));
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

} // namespace

void Arguments::refuse(std::size_t k, const char* expected) const {
  throw py::type_error(std::string(function_.name) + "(): " + function_.keywords[k].name + " must be " +
                       expected + ", not " + Py_TYPE(values_[k])->tp_name);
}

void define(py::module_& module, KeywordFunction function) {
  static auto& records = *new std::deque<Record>;
  Record& record = records.emplace_back();
  record.function = std::move(function);
  if (record.function.keywords.size() > most_keywords)
    throw std::length_error(std::string(record.function.name) + " has too many keywords");
  for (const Keyword& keyword : record.function.keywords)
    record.names.push_back(PyUnicode_InternFromString(keyword.name));
  record.text = signature(record.function) + record.function.documentation;
  record.definition = {record.function.name,
                       reinterpret_cast<PyCFunction>(reinterpret_cast<void (*)()>(call_record)),
                       METH_FASTCALL | METH_KEYWORDS, record.text.c_str()};
  const py::capsule self(&record, nullptr, nullptr);
  const auto name = py::reinterpret_steal<py::object>(PyUnicode_InternFromString("granum"));
  module.attr(record.function.name) =
      py::reinterpret_steal<py::object>(PyCFunction_NewEx(&record.definition, self.ptr(), name.ptr()));
}

} // namespace granum::python

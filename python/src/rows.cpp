// SPDX-License-Identifier: GPL-3.0-or-later
#include "rows.hpp"

#include <algorithm>
#include <stdexcept>

namespace granum::python {

void Notes::add(const Validity& validity) {
  for (const std::string& note : validity.notes) {
    std::string kind = note;
    std::erase_if(kind, [](char c) { return (c >= '0' && c <= '9') || c == '.' || c == '-' || c == '+'; });
    const auto [place, fresh] = places_.emplace(std::move(kind), in_order_.size());
    if (fresh)
      in_order_.push_back({.first_note = note, .elements = 1, .first = element_, .last = element_});
    Kind& known = in_order_[place->second];
    known.elements += known.last != element_;
    known.last = element_;
  }
}

std::vector<std::string> Notes::take(std::size_t elements, bool scalar) const {
  std::vector<std::string> out;
  for (const Kind& kind : in_order_)
    out.push_back(scalar || elements == 1
                      ? kind.first_note
                      : "at " + std::to_string(kind.elements) + " of " + std::to_string(elements) +
                            " elements (" +
                            (kind.elements == 1 ? "number " + std::to_string(kind.first)
                                                : "numbers " + std::to_string(kind.first) + " to " +
                                                      std::to_string(kind.last) + ", the first") +
                            "): " + kind.first_note);
  return out;
}

std::vector<Argument> columns_of(const Arguments& a) {
  std::vector<Argument> out;
  out.reserve(a.function().columns.size());
  for (const std::size_t k : a.function().columns) {
    const Keyword& keyword = a.keyword(k);
    out.push_back({keyword.name.c_str(), keyword.number, keyword.in_library});
    if (a.given(k) || keyword.shown_default == nullptr)
      out.back().value = a[k];
  }
  return out;
}

bool is_strict(const Arguments& a) { return !a.function().strict || a.flag(*a.function().strict); }

InvalidArgument as_typed(const InvalidArgument& error, std::span<const Argument> arguments) {
  if (const auto& refused = error.refused())
    for (const Argument& argument : arguments)
      if (argument.in_library != nullptr && refused->name == argument.in_library)
        return {argument.name, refused->value, refused->unit, refused->range};
  return error;
}

Columns::Columns(std::span<const Argument> arguments) {
  if (arguments.size() > most)
    throw std::length_error("too many columns");
  for (std::size_t k = 0; k < arguments.size(); ++k) {
    if (const double* number = std::get_if<double>(&arguments[k].value)) {
      number_[k] = *number;
      continue;
    }
    const py::handle value = std::get<py::handle>(arguments[k].value);
    if (value && PyFloat_Check(value.ptr())) {
      number_[k] = PyFloat_AS_DOUBLE(value.ptr());
      continue;
    }
    if (value && PyLong_CheckExact(value.ptr())) { // of any length
      number_[k] = number_of(arguments[k].name, value);
      continue;
    }
    py::array_t<double> array = numbers_of(arguments[k].name, value);
    if (array.ndim() == 0) {
      number_[k] = *array.data();
      continue;
    }
    scalar_ = false;
    varying_.push_back(k);
    arrays_.push_back(std::move(array));
  }
  if (!scalar_)
    broadcast(arguments);
}

void Columns::broadcast(std::span<const Argument> arguments) {
  for (const py::array& array : arrays_)
    shape_.resize(std::max(shape_.size(), static_cast<std::size_t>(array.ndim())), 1);
  std::vector<std::size_t> owner(shape_.size(), 0);
  for (std::size_t a = 0; a < arrays_.size(); ++a) {
    const auto axes = static_cast<std::size_t>(arrays_[a].ndim());
    for (std::size_t axis = 0; axis < axes; ++axis) {
      const std::size_t of_result = shape_.size() - axes + axis;
      const py::ssize_t length = arrays_[a].shape(static_cast<py::ssize_t>(axis));
      if (length == 1 || length == shape_[of_result])
        continue;
      if (shape_[of_result] != 1)
        throw InvalidArgument(std::string(arguments[varying_[a]].name) + " of shape " +
                              shape_text(arrays_[a]) + " cannot be broadcast with " +
                              arguments[varying_[owner[of_result]]].name + " of shape " +
                              shape_text(arrays_[owner[of_result]]));
      shape_[of_result] = length;
      owner[of_result] = a;
    }
  }
  rows_ = 1;
  for (const py::ssize_t length : shape_)
    rows_ *= static_cast<std::size_t>(length);
  for (std::size_t a = 0; a < arrays_.size(); ++a) {
    const std::size_t k = varying_[a];
    const auto axes = static_cast<std::size_t>(arrays_[a].ndim());
    first_[k] = reinterpret_cast<const char*>(arrays_[a].data());
    step_[k].assign(shape_.size(), 0);
    for (std::size_t axis = 0; axis < axes; ++axis)
      if (arrays_[a].shape(static_cast<py::ssize_t>(axis)) != 1)
        step_[k][shape_.size() - axes + axis] = arrays_[a].strides(static_cast<py::ssize_t>(axis));
  }
}

py::dict errors_by_index(const std::map<std::size_t, std::string>& errors,
                         const std::vector<py::ssize_t>& shape) {
  py::dict out;
  for (const auto& [row, message] : errors) {
    hear_signals(out.size());
    py::tuple index(shape.size());
    std::size_t rest = row;
    for (std::size_t axis = shape.size(); axis-- > 0;) {
      index[axis] = rest % static_cast<std::size_t>(shape[axis]);
      rest /= static_cast<std::size_t>(shape[axis]);
    }
    out[index] = decoded(message);
  }
  return out;
}

} // namespace granum::python

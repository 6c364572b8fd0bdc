// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <pybind11/numpy.h>
#include <pybind11/pybind11.h>

#include <array>
#include <cstddef>
#include <limits>
#include <map>
#include <span>
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include <granum/core/error.hpp>

#include "errors.hpp"
#include "functions.hpp"
#include "members.hpp"

/// Calls a function of the library for every element of arrays, broadcast as in numpy.
namespace granum::python {

/// A number that an element does not have.
inline constexpr double nan = std::numeric_limits<double>::quiet_NaN();

/// An argument of a call: the value given by the caller, or a number.
struct Argument {
  const char* name;
  std::variant<py::handle, double> value;
  const char* in_library = nullptr; ///< its name in the library, if different
};

/// The columns of a call: the values of all keywords that are array_like, in their order.
[[nodiscard]] std::vector<Argument> columns_of(const Arguments& arguments);
/// The flag `strict`; true for a function that has none.
[[nodiscard]] bool is_strict(const Arguments& arguments);

/// The error with the name of the argument as typed.
[[nodiscard]] InvalidArgument as_typed(const InvalidArgument& error, std::span<const Argument> arguments);

/// The numbers of every element of a call, one per argument.
class Columns {
 public:
  static constexpr std::size_t most = 32;

  /// \throws   TypeError for anything but numbers; InvalidArgument for shapes that cannot be broadcast;
  ///           std::length_error for more than `most` arguments
  explicit Columns(std::span<const Argument> arguments);

  /// Whether only numbers were given, no arrays: one element.
  [[nodiscard]] bool is_scalar() const { return scalar_; }
  [[nodiscard]] std::size_t rows() const { return rows_; }
  [[nodiscard]] const std::vector<py::ssize_t>& shape() const { return shape_; }
  /// The numbers of one call without arrays.
  [[nodiscard]] const double* numbers() const { return number_.data(); }

  /// Calls see(element, numbers) for all elements in the order of rows, without Python's lock.
  template <class See>
  void for_each(const See& see) const {
    std::array<double, most> numbers = number_;
    std::array<const char*, most> place = first_;
    std::vector<py::ssize_t> index(shape_.size());
    for (std::size_t row = 0; row < rows_; ++row) {
      if (row % 16 == 0) // a row may take a millisecond
        stop_point();
      for (const std::size_t k : varying_)
        numbers[k] = *reinterpret_cast<const double*>(place[k]);
      see(row, numbers.data());
      advance(index, place);
    }
  }

 private:
  void advance(std::vector<py::ssize_t>& index, std::array<const char*, most>& place) const {
    for (std::size_t axis = shape_.size(); axis-- > 0;) {
      for (const std::size_t k : varying_)
        place[k] += step_[k][axis];
      if (++index[axis] < shape_[axis])
        return;
      index[axis] = 0;
      for (const std::size_t k : varying_)
        place[k] -= step_[k][axis] * shape_[axis];
    }
  }
  void broadcast(std::span<const Argument> arguments);

  bool scalar_ = true;
  std::size_t rows_ = 1;
  std::vector<py::ssize_t> shape_;
  std::array<double, most> number_{};
  std::array<const char*, most> first_{};
  std::vector<std::size_t> varying_;                ///< arguments that are arrays
  std::vector<py::array_t<double>> arrays_;         ///< of them
  std::array<std::vector<py::ssize_t>, most> step_; ///< in bytes along each axis of the result
};

/// Results of a function for every element of a call.
template <class Row>
struct Rows {
  bool scalar = true;
  std::vector<py::ssize_t> shape;
  std::vector<Row> rows;
  std::map<std::size_t, std::string> errors; ///< of refused elements
  std::vector<std::string> notes;            ///< one of each kind, see Notes

  [[nodiscard]] const Row& front() const { return rows.front(); }
};

/// What is of one element, as the result of a call with numbers.
template <class Row>
[[nodiscard]] Rows<Row> of_one(Row row) {
  Rows<Row> rows;
  rows.rows.push_back(std::move(row));
  return rows;
}

/// Notes on the elements of a call: one of each kind, which is a note without its numbers.
class Notes {
 public:
  /// The element that the next notes are on.
  void go_to(std::size_t element) { element_ = element; }
  void add(const Validity& validity);
  /// The first note of each kind, and for arrays on how many elements there is one, with the first and the
  /// last of them.
  [[nodiscard]] std::vector<std::string> take(std::size_t elements, bool scalar) const;

 private:
  struct Kind {
    std::string first_note;
    std::size_t elements = 0, first = 0, last = 0;
  };
  std::size_t element_ = 0;
  std::map<std::string, std::size_t> places_; ///< of the kinds in the list
  std::vector<Kind> in_order_;
};

/// Calls `answer`(numbers, notes) for every element. A refused element gets `refused` and a message; calls
/// with numbers only raise, and so do arrays under `strict`.
template <class Row, class Answer>
Rows<Row> answer_rows(std::span<const Argument> arguments, bool strict, const Row& refused,
                      const Answer& answer) {
  const Columns columns(arguments);
  Rows<Row> out;
  Notes notes;
  if (columns.is_scalar()) {
    try {
      out.rows.push_back(answer(columns.numbers(), notes));
    } catch (const InvalidArgument& error) {
      throw as_typed(error, arguments);
    }
    out.notes = notes.take(1, true);
    return out;
  }
  out.scalar = false;
  out.shape = columns.shape();
  const Unlocked unlocked;
  out.rows.resize(columns.rows(), refused);
  columns.for_each([&](std::size_t row, const double* numbers) {
    notes.go_to(row);
    try {
      out.rows[row] = answer(numbers, notes);
    } catch (const InvalidArgument& error) {
      const InvalidArgument typed = as_typed(error, arguments);
      if (strict)
        throw typed;
      out.errors.emplace(row, typed.what());
    }
  });
  out.notes = notes.take(out.rows.size(), false);
  return out;
}

/// The messages of refused elements by their indices in the arrays.
[[nodiscard]] py::dict errors_by_index(const std::map<std::size_t, std::string>& errors,
                                       const std::vector<py::ssize_t>& shape);

/// A number of every element: a float, or a view of the result's memory.
template <class Row>
[[nodiscard]] py::object member(const py::object& result, std::size_t offset) {
  const auto& rows = result.cast<const Rows<Row>&>();
  if (rows.scalar)
    return py::float_(
        *reinterpret_cast<const double*>(reinterpret_cast<const char*>(rows.rows.data()) + offset));
  std::vector<py::ssize_t> strides(rows.shape.size());
  py::ssize_t step = sizeof(Row);
  for (std::size_t axis = strides.size(); axis-- > 0; step *= rows.shape[axis])
    strides[axis] = step;
  if (rows.rows.empty())
    return py::array_t<double>(rows.shape);
  return view<double>(
      rows.shape, strides,
      reinterpret_cast<const double*>(reinterpret_cast<const char*>(rows.rows.data()) + offset), result);
}

/// The same for a number computed from the element.
template <class Row, class Get>
[[nodiscard]] py::object computed(const Rows<Row>& rows, const Get& get) {
  if (rows.scalar)
    return py::float_(get(rows.front()));
  py::array_t<double> out(rows.shape);
  double* const to = out.mutable_data();
  for (std::size_t k = 0; k < rows.rows.size(); ++k) {
    hear_signals(k);
    to[k] = get(rows.rows[k]);
  }
  return out;
}

/// A result of rows: `answer`(numbers, notes) for every element of the columns of a call.
template <class Row, class Answer>
[[nodiscard]] py::object rows_of(const Arguments& arguments, const Row& refused, const Answer& answer) {
  return py::cast(answer_rows(columns_of(arguments), is_strict(arguments), refused, answer));
}

/// A float or an array: `formula`(numbers) for every element of the columns of a call.
template <class Formula>
[[nodiscard]] py::object numbers_of_rows(std::span<const Argument> columns, const Formula& formula) {
  return computed(
      answer_rows<double>(columns, true, 0.0, [&](const double* x, Notes&) { return formula(x); }),
      [](double number) { return number; });
}
template <class Formula>
[[nodiscard]] py::object numbers_of_rows(const Arguments& arguments, const Formula& formula) {
  return numbers_of_rows(columns_of(arguments), formula);
}

/// A class of results of rows.
template <class Row>
class RowsClass : public py::class_<Rows<Row>> {
 public:
  using py::class_<Rows<Row>>::class_;

  /// A view of a number of the rows.
  RowsClass& show(const char* name, const char* says, double Row::*number) {
    const Row row{};
    const std::size_t offset = static_cast<std::size_t>(reinterpret_cast<const char*>(&(row.*number)) -
                                                        reinterpret_cast<const char*>(&row));
    this->def_property_readonly(
        name, [offset](const py::object& result) { return member<Row>(result, offset); }, says);
    return *this;
  }
};

/// A class of results with the members of all results.
template <class Row>
RowsClass<Row> result_class(py::module_& module, const char* name, const char* documentation) {
  RowsClass<Row> type(module, name, documentation);
  type.def_property_readonly(
          "errors", [](const Rows<Row>& rows) { return errors_by_index(rows.errors, rows.shape); },
          "Messages of refused elements, by index; their numbers are NaN.")
      .def_property_readonly(
          "notes", [](const Rows<Row>& rows) { return rows.notes; },
          "Notes on values that are possible but outside the range of a formula, each once.")
      .def_property_readonly(
          "shape", [](const Rows<Row>& rows) { return py::tuple(py::cast(rows.shape)); },
          "Shape of the arrays; () for a call with numbers only.");
  return type;
}

} // namespace granum::python

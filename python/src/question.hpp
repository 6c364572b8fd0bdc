// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include <granum/estimate/answer.hpp>
#include <granum/estimate/input_values.hpp>

#include "state.hpp"

/// The question of granum estimate, as keywords of Python: rows of the table of inputs, and a contact law as
/// an object.
namespace granum::python {

/// Keywords of a question in the order in which QuestionArguments reads them, followed by those of one
/// function.
[[nodiscard]] std::vector<Keyword> question_keywords(const std::vector<Keyword>& more = {});
/// How many keywords a question has: the index of the first keyword of a function.
[[nodiscard]] std::size_t question_keyword_count();
/// Keywords of the properties of a sand: its name, C_u, limits, relative density, fines and d50, in order.
/// \param    type_of_name   "str", or that of several
[[nodiscard]] std::vector<Keyword> sand_keywords(const char* type_of_name = "str");
/// Those of them that are numbers.
inline constexpr estimate::Input numbers_of_sand[] = {estimate::Input::uniformity,
                                                      estimate::Input::least_void_ratio,
                                                      estimate::Input::largest_void_ratio,
                                                      estimate::Input::relative_density,
                                                      estimate::Input::fines,
                                                      estimate::Input::d50};

/// Values of a law, without other inputs, whose names in messages are those of Python.
[[nodiscard]] estimate::InputValues values_of_law(const contact::NormalLaw& law);
/// Gives the input of a keyword its word, if that was given.
/// \throws   InvalidArgument for a word that is unknown
void give_word(estimate::InputValues& values, estimate::Input input, const Arguments& arguments,
               std::size_t at);
/// Stated standard deviations, by the names of inputs.
/// \throws   InvalidArgument for a name that is not one of the rows, or a negative deviation
[[nodiscard]] estimate::Deviations deviations_of(const Arguments& arguments, std::size_t at,
                                                 std::span<const estimate::InputRow* const> rows,
                                                 const std::string& other);

/// The keywords of a question, read.
class QuestionArguments {
 public:
  explicit QuestionArguments(const Arguments& arguments);

  [[nodiscard]] std::span<const Argument> columns() const { return columns_; }
  [[nodiscard]] bool strict() const { return strict_; }
  /// The numbers of a call without arrays.
  /// \throws   TypeError if there are arrays
  [[nodiscard]] const double* one_packing(const char* function);
  /// The answer for one element, with the ranges that the program gives.
  [[nodiscard]] estimate::Answer answer(const double* numbers) const;

 private:
  void take_sands(py::handle names);
  void require_in_use() const;

  estimate::InputValues values_;                ///< of all elements, but for the names of several sands
  std::vector<estimate::InputValues> of_sands_; ///< of each name, where the last column says which
  py::object sand_places_;                      ///< that column
  estimate::Deviations deviations_;
  std::vector<Argument> columns_;
  std::vector<estimate::Input> inputs_; ///< of the columns
  std::vector<double> numbers_;
  bool strict_;
};

} // namespace granum::python

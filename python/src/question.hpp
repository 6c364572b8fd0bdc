// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <map>
#include <string>
#include <vector>

#include <granum/estimate/answer.hpp>
#include <granum/sands/known_sands.hpp>

#include "state.hpp"

/// The question of granum estimate, as keywords of Python.
namespace granum::python {

/// Keywords of a question in the order in which QuestionArguments reads them, followed by those of one
/// function.
[[nodiscard]] std::vector<Keyword> question_keywords(std::initializer_list<Keyword> more = {});
/// Their number, the index of the first keyword of a function.
inline constexpr std::size_t question_keyword_count = state_keyword_count + 11;
/// The docstring of these keywords.
extern const std::string question_parameters;

/// The keywords of a question, read.
class QuestionArguments {
 public:
  explicit QuestionArguments(const Arguments& arguments);

  [[nodiscard]] std::span<const Argument> columns() const { return columns_; }
  [[nodiscard]] bool strict() const { return state_.strict(); }
  /// The numbers of a call without arrays.
  /// \throws   TypeError if there are arrays
  [[nodiscard]] const double* one_packing(const char* function);
  /// The answer for one element, with the ranges that the program gives.
  [[nodiscard]] estimate::Answer answer(const double* numbers) const;

 private:
  [[nodiscard]] estimate::Question question(const double* numbers) const;
  [[nodiscard]] estimate::UncertainInput input(const std::string& name, double deviation, bool assumed,
                                               const double* numbers) const;

  StateArguments state_;
  effective::Preparation preparation_;
  bool has_density_ = false;
  estimate::GrainShape grain_shape_ = estimate::GrainShape::sphere;
  const sands::KnownSand* sand_ = nullptr;
  std::array<bool, 5> told_of_sand_{}; ///< which of the numbers of a sand are given
  std::map<std::string, double> deviations_;
  std::vector<Argument> columns_;
  std::vector<double> numbers_;
};

} // namespace granum::python

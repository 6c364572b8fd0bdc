// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <iterator>
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
/// The kind of grains, by the keywords grain_shape and sand.
struct Grains {
  estimate::GrainShape shape = estimate::GrainShape::sphere;
  const sands::KnownSand* sand = nullptr; ///< if it was named

  /// The properties of the named sand.
  [[nodiscard]] sands::Sand known() const { return sand != nullptr ? sands::sand_of(*sand) : sands::Sand{}; }
};
/// \throws   InvalidArgument for a shape or a sand that is unknown
[[nodiscard]] Grains grains_of(const Arguments& arguments, std::size_t grain_shape_at, std::size_t sand_at);

/// A number of a sand, and its keyword.
struct SandNumber {
  const char* keyword;
  std::optional<double> sands::Sand::*member;
};
inline constexpr SandNumber numbers_of_sand[] = {{"uniformity", &sands::Sand::uniformity},
                                                 {"least_void_ratio", &sands::Sand::least_void_ratio},
                                                 {"largest_void_ratio", &sands::Sand::largest_void_ratio},
                                                 {"relative_density", &sands::Sand::relative_density},
                                                 {"d50", &sands::Sand::d50}};

/// How many keywords a question has: the index of the first keyword of a function.
inline constexpr std::size_t question_keyword_count = state_keyword_count + 7 + std::size(numbers_of_sand);

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
  bool has_density_ = false, has_strain_ = false;
  Grains grains_;
  std::array<bool, std::size(numbers_of_sand)> has_number_of_sand_{};
  std::map<std::string, double> deviations_;
  std::vector<Argument> columns_;
  std::vector<double> numbers_;
};

} // namespace granum::python

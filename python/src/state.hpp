// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <optional>
#include <vector>

#include <granum/effective/exponents.hpp>
#include <granum/effective/rungs.hpp>
#include <granum/effective/state.hpp>
#include <granum/estimate/question.hpp>

#include "functions.hpp"
#include "rows.hpp"

/// The state of a packing as keywords of Python, common to all closed forms.
namespace granum::python {

/// Keywords of a state in the order in which StateArguments reads them, followed by those of one function.
[[nodiscard]] std::vector<Keyword> state_keywords(std::initializer_list<Keyword> more = {});
/// Their number, the index of the first keyword of a function.
inline constexpr std::size_t state_keyword_count = 15;

/// The docstring of these keywords, for all closed forms.
[[nodiscard]] std::string state_parameters();

/// The stress of one direction: `pressure` if given, else `stress`, whose keyword is `name`.
/// \throws   TypeError if both or none are given
[[nodiscard]] Argument stress_argument(const Arguments& arguments, std::size_t pressure, std::size_t stress_v,
                                       std::size_t stress_h, bool vertical);

/// The keywords of a state, read.
class StateArguments {
 public:
  /// C_n of state_keywords is needed; that of question_keywords (question.hpp) may be left out.
  enum class CoordinationNumber { needed, optional };
  explicit StateArguments(const Arguments& arguments,
                          CoordinationNumber coordination_number = CoordinationNumber::needed);

  [[nodiscard]] std::span<const Argument> columns() const { return columns_; }
  [[nodiscard]] bool strict() const { return strict_; }
  /// Whether z* or the share of rattlers was given.
  [[nodiscard]] bool knows_rattlers() const { return coordination_ != Coordination::unknown; }
  /// The packing of one element, with z* if it follows from C_n and the share of rattlers.
  [[nodiscard]] effective::State state(const double* numbers) const;
  /// The packing of one element, with given numbers only.
  [[nodiscard]] estimate::Question question(const double* numbers) const;
  /// Whether fabric_anisotropy was given.
  [[nodiscard]] bool knows_fabric() const { return knows_fabric_; }
  /// Whether k_t/k_n was given; else the no-slip value is used.
  [[nodiscard]] bool knows_tangential_ratio() const { return knows_tangential_ratio_; }

 private:
  enum class Coordination { unknown, mechanical, rattlers };

  const contact::NormalLaw* law_;
  sizes::ContactMeans contacts_;
  Coordination coordination_ = Coordination::unknown;
  bool knows_coordination_number_ = true;
  bool knows_fabric_, knows_tangential_ratio_, knows_unevenness_ = false;
  std::array<Argument, 10> columns_;
  bool strict_;
};

/// The keyword rung, which closed_form_of reads.
[[nodiscard]] Keyword rung_keyword();
/// The closed form of a number, "rung3", or a name: isotropic, fabric, directional, relaxed, uniform_stress.
/// \throws   InvalidArgument for another one
[[nodiscard]] const effective::Rung& closed_form_of(const py::handle& name);

} // namespace granum::python

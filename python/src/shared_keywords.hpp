// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include <granum/estimate/inputs.hpp>

#include "functions.hpp"

/// Keywords that several functions take.
namespace granum::python {

/// A row of the library's table of inputs: its name, meaning, unit and limits. It is required.
[[nodiscard]] Keyword of_input(estimate::Input input, std::string type = "array_like");

/// How beads were brought together, or None.
[[nodiscard]] Keyword preparation_keyword();
/// The contact law, required.
[[nodiscard]] Keyword law_keyword();
/// The means of unequal grains, or None.
[[nodiscard]] Keyword contact_means_keyword();
/// k_t/k_n, or None.
[[nodiscard]] Keyword tangential_ratio_keyword(std::string type = "float");
/// The flag of functions of arrays.
[[nodiscard]] Keyword strict_keyword();
/// A stiffness as a matrix.
[[nodiscard]] Keyword stiffness_keyword();

/// The two numbers of a solid, <prefix>shear_modulus and <prefix>poisson_ratio. They are those of a grain in
/// messages of the library.
/// \param    solid   "grain"
[[nodiscard]] std::vector<Keyword> solid_keywords(const std::string& prefix, const std::string& solid,
                                                  const std::string& type = "array_like");
/// A function that takes these two, with the keyword <prefix>bulk_modulus after its others, as an alternative
/// to Poisson's ratio.
[[nodiscard]] KeywordFunction with_bulk_modulus(KeywordFunction function, const std::string& prefix = "");

/// Defines such a function.
template <class Function>
void define_of_solid(const py::object& scope, const char* name, std::vector<Keyword> keywords, Docstring text,
                     const Function& of) {
  define(scope, with_bulk_modulus(function(name, std::move(keywords), std::move(text), of)));
}

/// The keywords of both lists.
[[nodiscard]] std::vector<Keyword> operator+(std::vector<Keyword> first, const std::vector<Keyword>& more);

} // namespace granum::python

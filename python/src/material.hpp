// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "keywords.hpp"

/// The two numbers of a solid: its shear modulus, and Poisson's ratio or its bulk modulus.
namespace granum::python {

/// A function that takes <prefix>shear_modulus and <prefix>poisson_ratio, with the keyword
/// <prefix>bulk_modulus after its others, as an alternative to Poisson's ratio; its docstring has a separate
/// entry.
/// \param    prefix   "", "cement_", "grain_"
[[nodiscard]] KeywordFunction with_bulk_modulus(KeywordFunction function, const std::string& prefix = "");

} // namespace granum::python

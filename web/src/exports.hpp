// SPDX-License-Identifier: GPL-3.0-or-later
// Functions called by the page's scripts. Numbers are passed as arguments, in SI, and returned in one row of
// doubles, in which NaN means "not given" or "does not exist".
#pragma once

#include <string>
#include <vector>

#include <granum/contact/laws.hpp>
#include <granum/core/error.hpp>

#define GRANUM_EXPORT(name) extern "C" __attribute__((export_name(#name)))

namespace granum::web {

/// The result of the last call.
std::vector<double>& numbers();
/// The notes of the last call, one line each.
std::string& words();
void say(const Validity& validity);

/// Two grains of a shape, by its place in contact::laws().
struct PageGrain {
  double shape;
  double shear_modulus; ///< G_g [Pa]
  double poisson_ratio; ///< nu_g [1]
  double radius;        ///< R [m]
  double first;         ///< first number of the law, in the order of its row; not used if it has none
  double second;        ///< second number of the law
};
/// \throws   InvalidArgument
contact::Shape shape_of(double place);
contact::NormalLaw law_of(const PageGrain& grain);

} // namespace granum::web

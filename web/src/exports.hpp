// SPDX-License-Identifier: GPL-3.0-or-later
// What the page's scripts call. Numbers go in as arguments, in SI, and come out in one row of doubles; "not a
// number" stands for "not given" and "there is none", as a row of numbers has no other word for it.
#pragma once

#include <string>
#include <vector>

#include <granum/contact/laws.hpp>
#include <granum/core/validity.hpp>

#define GRANUM_EXPORT(name) extern "C" __attribute__((export_name(#name)))

namespace granum::web {

/// The answer of the last call.
std::vector<double>& numbers();
/// The notes of the last call, a line each.
std::string& words();
void say(const Validity& validity);

/// Two grains of a shape, by its place in contact::laws().
struct PageGrain {
  double shape;
  double shear_modulus; ///< G_g [Pa]
  double poisson_ratio; ///< nu_g [1]
  double radius;        ///< R [m]
  double first;         ///< of the numbers of the law, in the order of its row; not read where it has none
  double second;        ///< likewise
};
/// \throws   InvalidArgument
contact::Shape shape_of(double place);
contact::NormalLaw law_of(const PageGrain& grain);

} // namespace granum::web

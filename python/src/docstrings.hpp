// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

/// Sections of docstrings in the format of numpydoc. Checked by python/tests/test_docstrings.py
namespace granum::python {

/// The section Notes, the last one: remarks with the keys of their sources in validation/references.bib, and
/// the called function of the library.
/// \param    remarks    may be empty
/// \param    function   "effective::uniform_strain"
/// \param    header     "effective/uniform_field.hpp"
[[nodiscard]] inline std::string notes(const std::string& remarks, const std::string& function,
                                       const std::string& header) {
  return "\nNotes\n-----\n" + remarks + (remarks.empty() ? "" : "\n\n") + "In C++: granum::" + function +
         " of granum/" + header + ".\n";
}

/// The section Raises of functions that may refuse arguments.
[[nodiscard]] inline std::string raises_invalid(const std::string& when) {
  return "\nRaises\n------\nInvalidArgument\n    " + when + "\n";
}

/// Section Parameters of a function of one stiffness; more may follow.
inline constexpr const char* stiffness_parameter = R"(
Parameters
----------
stiffness : (6, 6) array_like
    Voigt matrix, order 11 22 33 23 13 12, engineering shear strains [Pa]. Symmetric: both halves may differ
    by 1e-3 of the largest entry, as if they were rounded to four digits.
)";

/// Section Parameters of the classical models, a packing of equal spheres; more follow.
inline constexpr const char* equal_spheres_parameters = R"(
Parameters
----------
shear_modulus : array_like
    G_g > 0 of the grain [Pa].
poisson_ratio : array_like
    nu_g of the grain, -1 < nu_g <= 0.5 [1].
porosity : array_like
    Pore volume by total volume, in [0, 1) [1].
coordination_number : array_like
    C_n = 2 N_c/N >= 0 [1].
)";
inline constexpr const char* no_slip_parameter = R"(no_slip_fraction : array_like
    Share of contacts without slip, in [0, 1] [1]: 1 rough, 0 smooth grains.
)";
inline constexpr const char* strict_parameter = R"(strict : bool
    Raise at the first element that is refused, instead of NaN and a message in `errors`.
)";

} // namespace granum::python

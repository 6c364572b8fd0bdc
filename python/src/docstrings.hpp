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
    Voigt matrix, order 11 22 33 23 13 12, engineering shear strains [Pa].
)";

} // namespace granum::python

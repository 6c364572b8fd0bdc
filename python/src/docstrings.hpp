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

} // namespace granum::python

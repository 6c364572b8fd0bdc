// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>
#include <string_view>
#include <vector>

/// The sources of formulas, data and methods, which tables, notes and docstrings cite by their keys,
/// "Lo2021".
/// Checked by tests/core/test_references.cpp
namespace granum {

/// A source as it is printed; UTF-8.
struct Reference {
  std::string_view key;    ///< "Lo2021", of validation/references.bib
  std::string_view text;   ///< "Lo, M. K., Wei, X., Chian, S. C. and Ku, T. (2021): Bayesian network ..."
  std::string_view link;   ///< its address, "https://doi.org/..."; may be empty
  std::string_view remark; ///< what of it was not checked, and why its number can be used; may be empty
};

/// All of them, sorted by key.
[[nodiscard]] std::span<const Reference> references();

/// Those whose keys occur in a text, in the same order.
[[nodiscard]] std::vector<Reference> references_in(std::string_view text);

} // namespace granum

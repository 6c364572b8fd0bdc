// SPDX-License-Identifier: GPL-3.0-or-later
#include <granum/core/references.hpp>

namespace granum {

namespace {

constexpr Reference all[] = {
#include "references.inc"
};

} // namespace

std::span<const Reference> references() { return all; }

std::vector<Reference> references_in(std::string_view text) {
  std::vector<Reference> found;
  for (const Reference& one : all)
    if (text.find(one.key) != std::string_view::npos)
      found.push_back(one);
  return found;
}

} // namespace granum

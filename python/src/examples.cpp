// SPDX-License-Identifier: GPL-3.0-or-later
#include "examples.hpp"

#include <string_view>

#include <granum/core/text.hpp>

namespace granum::python {

namespace {

constexpr std::string_view text =
#include "examples.inc"
    ;

/// The part before a separator, which is taken away from the rest with it.
std::string_view cut(std::string_view& rest, std::string_view separator) {
  const std::string_view part = rest.substr(0, rest.find(separator));
  rest.remove_prefix(std::min(rest.size(), part.size() + separator.size()));
  return part;
}

} // namespace

const std::map<std::string, std::string, std::less<>>& examples() {
  static const auto all = [] {
    std::map<std::string, std::string, std::less<>> by_name;
    std::string_view blocks = text;
    cut(blocks, "\n== ");
    while (!blocks.empty()) {
      std::string_view block = cut(blocks, "\n== ");
      for (std::string_view names = cut(block, "\n"); !names.empty();)
        by_name.emplace(trimmed(cut(names, ",")), trimmed(block));
    }
    return by_name;
  }();
  return all;
}

std::string examples_section(const std::string& name) {
  const auto found = examples().find(name);
  return found == examples().end() ? "" : "\nExamples\n--------\n" + found->second + "\n";
}

} // namespace granum::python

// SPDX-License-Identifier: GPL-3.0-or-later
#include "sources.hpp"

namespace granum::cli {

namespace {

struct Source {
  std::string_view key, text;
};
constexpr Source table[] = {
#include "sources_table.inc"
};

} // namespace

std::vector<std::string> sources_in(std::string_view text) {
  std::vector<std::string> all;
  for (const Source& source : table)
    if (text.find(source.key) != std::string_view::npos)
      all.push_back(std::string(source.key) + ": " + std::string(source.text));
  return all;
}

} // namespace granum::cli

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <string>
#include <string_view>
#include <vector>

/// Whether each tag is closed by its own name, there is one root, and every '&' begins a known entity.
inline bool well_formed(std::string_view xml) {
  std::vector<std::string> open;
  int roots = 0;
  for (std::size_t k = 0; k < xml.size(); ++k) {
    if (xml[k] == '&') {
      const std::string_view rest = xml.substr(k);
      if (!rest.starts_with("&amp;") && !rest.starts_with("&lt;") && !rest.starts_with("&gt;") &&
          !rest.starts_with("&quot;"))
        return false;
    }
    if (xml[k] == '>')
      return false; // one that closes no tag
    if (xml[k] != '<')
      continue;
    const std::size_t end = xml.find('>', k);
    if (end == std::string_view::npos)
      return false;
    const std::string_view tag = xml.substr(k + 1, end - k - 1);
    k = end;
    if (tag.starts_with('?') || tag.starts_with('!'))
      continue;
    if (std::count(tag.begin(), tag.end(), '"') % 2 != 0 || tag.find('<') != std::string_view::npos)
      return false;
    if (tag.starts_with('/')) {
      if (open.empty() || open.back() != tag.substr(1))
        return false;
      open.pop_back();
    } else {
      roots += open.empty();
      if (!tag.ends_with('/'))
        open.emplace_back(tag.substr(0, tag.find(' ')));
    }
  }
  return open.empty() && roots == 1;
}

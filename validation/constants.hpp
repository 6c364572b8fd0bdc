// SPDX-License-Identifier: GPL-3.0-or-later
// Numbers of fits, of which headers of the library hold printed copies.
#pragma once

#include <cmath>
#include <concepts>
#include <cstdio>
#include <string>
#include <vector>

/// Some numbers of such a header, between what is printed before and after them.
struct Constant {
  std::string before;
  std::vector<double> fitted, recorded; ///< recorded: as the library has them
  std::string after = "};\n";
  int digits = 9;
  std::vector<double> scales = {}; ///< that differences are relative to; empty: the recorded numbers
};

/// Numbers and lists of numbers, one after the other.
template <class... Parts>
std::vector<double> joined(const Parts&... parts) {
  std::vector<double> all;
  const auto add = [&all](const auto& part) {
    if constexpr (std::convertible_to<decltype(part), double>)
      all.push_back(part);
    else
      all.insert(all.end(), std::begin(part), std::end(part));
  };
  (add(parts), ...);
  return all;
}

/// The header; `intro` ends in the opened namespace.
inline void print_header(const std::string& intro, const std::vector<Constant>& constants) {
  std::printf("// SPDX-License-Identifier: GPL-3.0-or-later\n%s", intro.c_str());
  for (const Constant& c : constants) {
    std::printf("%s", c.before.c_str());
    for (std::size_t k = 0; k < c.fitted.size(); ++k)
      std::printf("%s%.*g", k > 0 ? ", " : "", c.digits, c.fitted[k]);
    std::printf("%s", c.after.c_str());
  }
  std::printf("\n} // namespace granum::effective::kernel\n");
}

/// What is printed before the first numbers that differ by more from those of the library; empty: none.
inline std::string first_other(const std::vector<Constant>& constants, double relative) {
  for (const Constant& c : constants)
    for (std::size_t k = 0; k < c.fitted.size(); ++k) {
      const double scale = c.scales.empty() ? std::abs(c.recorded.at(k)) : c.scales[k];
      if (!(std::abs(c.fitted[k] - c.recorded.at(k)) <= relative * scale))
        return c.before;
    }
  return "";
}

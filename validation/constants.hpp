// SPDX-License-Identifier: GPL-3.0-or-later
// Numbers of fits: headers of the library (src/effective) hold printed copies.
#pragma once

#include <algorithm>
#include <cmath>
#include <concepts>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <stdexcept>
#include <string>
#include <vector>

#include <granum/core/text.hpp>

/// Some numbers of such a header.
struct Constant {
  std::string before; ///< what the header has in front of them
  std::vector<double> fitted;
  int digits = 9;
  std::vector<double> scales = {}; ///< that differences are relative to; empty: the numbers themselves
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

/// The header with other texts for its numbers.
/// \param    replacement   takes a constant, the place of a number in it and what the header has there
template <class Replacement>
std::string header_with(const std::filesystem::path& path, const std::vector<Constant>& constants,
                        const Replacement& replacement) {
  std::ostringstream text;
  text << std::ifstream(path).rdbuf();
  std::string header = text.str();
  std::size_t at = 0;
  for (const Constant& c : constants) {
    at = header.find(c.before, at);
    if (at == std::string::npos)
      throw std::runtime_error(path.string() + " lacks " + c.before);
    at += c.before.size();
    for (std::size_t k = 0; k < c.fitted.size(); ++k) {
      const std::size_t begin = header.find_first_of("-0123456789", at);
      std::size_t end = header.find_first_not_of("+-.e0123456789", begin);
      end -= header[end - 1] == '.'; // of a sentence
      const std::string number = replacement(c, k, header.substr(begin, end - begin));
      header.replace(begin, end - begin, number);
      at = begin + number.size();
    }
  }
  return header;
}

inline void write_header(const std::filesystem::path& path, const std::vector<Constant>& constants) {
  const std::string header =
      header_with(path, constants, [](const Constant& c, std::size_t k, const std::string&) {
        return granum::short_text(c.fitted[k], c.digits);
      });
  std::ofstream(path) << header;
}

/// What is before the first numbers that differ from those of the header by more, relative, or by more than
/// their last digit; empty: none.
inline std::string first_other(const std::filesystem::path& path, const std::vector<Constant>& constants,
                               double relative) {
  std::string other;
  header_with(path, constants, [&](const Constant& c, std::size_t k, const std::string& number) {
    const double recorded = std::stod(number), scale = c.scales.empty() ? std::abs(recorded) : c.scales[k];
    if (!(std::abs(c.fitted[k] - recorded) <= std::max(relative, std::pow(10, 1 - c.digits)) * scale) &&
        other.empty())
      other = c.before;
    return number;
  });
  return other;
}

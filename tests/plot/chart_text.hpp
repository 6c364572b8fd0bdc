// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <sstream>
#include <string>
#include <utility>
#include <vector>

#include <granum/plot/chart.hpp>

/// What tests read out of the text of a picture.
namespace chart_text {

using namespace granum::plot;

/// Contents of all texts of a class; a power of ten is written 10^n.
inline std::vector<std::string> texts(const std::string& svg, const std::string& text_class) {
  std::vector<std::string> found;
  const std::string begin = "<text class=\"" + text_class + "\"";
  for (std::size_t at = svg.find(begin); at != std::string::npos; at = svg.find(begin, at + 1)) {
    const std::size_t from = svg.find('>', at) + 1;
    std::string text = svg.substr(from, svg.find("</text>", from) - from);
    if (const std::size_t span = text.find("<tspan"); span != std::string::npos) {
      const std::size_t power = text.find('>', span) + 1;
      text = text.substr(0, span) + "^" + text.substr(power, text.find('<', power) - power);
    }
    found.push_back(text);
  }
  return found;
}

/// The first number of that name in a text.
inline double attribute(const std::string& text, const std::string& name) {
  return std::stod(text.substr(text.find(" " + name + "=\"") + name.size() + 3));
}

/// That number of every element that begins so and has it.
inline std::vector<double> all(const std::string& picture, const std::string& begin,
                               const std::string& name) {
  std::vector<double> found;
  for (std::size_t at = picture.find(begin); at != std::string::npos; at = picture.find(begin, at + 1)) {
    const std::string element = picture.substr(at, picture.find('>', at) - at);
    if (element.find(" " + name + "=\"") != std::string::npos)
      found.push_back(attribute(element, name));
  }
  return found;
}

/// The numbers of the path of the first element with that piece.
inline std::vector<double> path_numbers(const std::string& picture, const std::string& piece) {
  const std::size_t at = picture.find(" d=\"", picture.find(piece)) + 4;
  std::string path = picture.substr(at, picture.find('"', at) - at);
  for (char& c : path)
    c = std::string("MLAHVZ,").find(c) == std::string::npos ? c : ' ';
  std::vector<double> found;
  std::istringstream text(path);
  for (double number = 0; text >> number;)
    found.push_back(number);
  return found;
}

inline std::size_t count(const std::string& text, const std::string& piece) {
  std::size_t found = 0;
  for (std::size_t at = text.find(piece); at != std::string::npos; at = text.find(piece, at + 1))
    ++found;
  return found;
}

using Texts = std::vector<std::string>;

inline Chart chart_of(std::vector<double> x, std::vector<double> y, Scale scale = Scale::linear) {
  return {.title = "",
          .x = {.title = "x", .scale = scale},
          .y = {.title = "y", .scale = scale},
          .series = {{.name = "", .x = std::move(x), .y = std::move(y)}}};
}

} // namespace chart_text

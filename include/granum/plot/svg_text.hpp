// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include <granum/plot/palette.hpp>

/// Pieces of SVG text.  Checked by tests/plot/test_chart.cpp
namespace granum::plot {

/// Names and values; values are escaped when they are written.
using SvgAttributes = std::vector<std::pair<std::string_view, std::string>>;

/// A coordinate with two decimals, the same in every locale.
[[nodiscard]] std::string svg_number(double value);
/// Text as XML allows it: markup escaped; control characters and bytes that are not UTF-8 as '?'.
[[nodiscard]] std::string svg_escaped(std::string_view text);
/// Signs that a terminal has no letters for, as they are printed: "+-" is "±", "<=" and ">=" one sign each,
/// and alpha, sigma_v and sigma_h are Greek where they are words of their own.
/// Checked by tests/plot/test_page.cpp
[[nodiscard]] std::string printed_signs(std::string_view text);
/// An element without content.
[[nodiscard]] std::string svg_element(std::string_view name, const SvgAttributes& attributes);
/// A text of a class; `content` is markup. Nothing if it is empty.
[[nodiscard]] std::string svg_text(std::string_view text_class, const SvgAttributes& attributes,
                                   std::string_view content);
/// Elements in a group. Nothing if there are none.
[[nodiscard]] std::string svg_group(const SvgAttributes& attributes, std::string_view content);

/// Class and colour of a group in a colour of the palette, as that of a series (plot/chart.hpp): its elements
/// are drawn in "currentColor".
[[nodiscard]] SvgAttributes svg_colour(Colour colour);

/// A picture that is no chart, on the same paper.
struct SvgPicture {
  double width = 0;
  double height = 0;
  std::string finding; ///< what a reader sees in it, for those who cannot
  std::string content; ///< elements; what is not in a group of svg_colour has that of texts
};
/// As a file of its own, light or dark as its reader wants.
[[nodiscard]] std::string svg(const SvgPicture& picture);
/// As a part of a page of html_page (plot/page.hpp).
[[nodiscard]] std::string svg_in_page(const SvgPicture& picture);

} // namespace granum::plot

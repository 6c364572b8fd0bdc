// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include <granum/plot/chart.hpp>

/// Reports as pages of HTML: one look for all of them, light and dark, wide and narrow, on paper, and without
/// anything from outside. A script, without which all is there to be read, gives values under the pointer,
/// fades series and switches between pictures of a choice.  Checked by tests/plot/test_page.cpp
namespace granum::plot {

/// An element with markup inside, of a class unless that is empty.
[[nodiscard]] std::string html_element(const std::string& tag, const std::string& content,
                                       const std::string& text_class = {});

/// Content that may be wider than the screen: it scrolls, by keyboard too, and shows where more follows.
[[nodiscard]] std::string html_wide(const std::string& content);

/// Plain text, escaped, with printed_signs, as a paragraph.
[[nodiscard]] std::string html_paragraph(std::string_view text, const std::string& text_class = {});

/// Plain texts as a list, likewise.
[[nodiscard]] std::string html_list(const std::vector<std::string>& items);

/// Plain text line by line as it is, in letters of one width.
[[nodiscard]] std::string html_preformatted(std::string_view text);

/// A section under a heading, which `id` names for links.
[[nodiscard]] std::string html_section(const std::string& id, std::string_view title,
                                       const std::string& content);

/// Content that is folded away under its title until it is asked for. On paper it stays folded.
[[nodiscard]] std::string html_folded(std::string_view title, const std::string& content);

/// A table that scrolls sideways where it is too wide. Numbers are the cells that begin with a
/// digit or sign and are no sentence.
/// \param    rows    plain texts, as many in each as there are headings
[[nodiscard]] std::string html_table(const std::vector<std::string>& headings,
                                     const std::vector<std::vector<std::string>>& rows);

/// One picture of a figure.
struct PagePicture {
  std::string svg;         ///< of svg_in_page
  std::string choice = {}; ///< "G_hv": of the pictures of one figure one choice is shown at a time
};

/// A file that the numbers or the drawing of a figure are in.
struct PageFile {
  std::string name;
  std::string address; ///< as seen from the page
};

/// Pictures with what is to be said of them.
struct PageFigure {
  std::string title = {};
  std::string caption = {};
  std::vector<PagePicture> pictures = {};
  std::vector<PageFile> files = {};
};
[[nodiscard]] std::string html_figure(const PageFigure& figure);

/// What a reader sees first: the question, the answer in a few sentences, and one figure.
[[nodiscard]] std::string html_first_screen(std::string_view question, const std::vector<std::string>& answer,
                                            const PageFigure& figure);

/// A whole page.
/// \param    title   plain text, in the title of the window
/// \param    body    of the functions above
[[nodiscard]] std::string html_page(std::string_view title, const std::string& body);

} // namespace granum::plot

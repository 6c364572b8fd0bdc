// SPDX-License-Identifier: GPL-3.0-or-later
#include <granum/plot/page.hpp>

#include <algorithm>

#include <granum/plot/svg_text.hpp>

#include "look.hpp"
#include "page_parts.hpp"

namespace granum::plot {

namespace {

constexpr std::string_view missing = "-";

bool is_number(const std::string& cell) {
  const std::size_t first = cell.starts_with('-') || cell.starts_with('+') ? 1 : 0;
  return cell.size() > first && cell[first] >= '0' && cell[first] <= '9';
}

std::string link(const PageFile& file) {
  return "<a href=\"" + svg_escaped(file.address) + "\">" + svg_escaped(file.name) + "</a>";
}

std::string panel(const PagePicture& picture) {
  const std::string choice =
      picture.choice.empty() ? "" : " data-choice=\"" + svg_escaped(picture.choice) + "\"";
  return "<div class=\"panel\"" + choice + ">\n" + picture.svg + "</div>\n";
}

} // namespace

std::string html_element(const std::string& tag, const std::string& content, const std::string& text_class) {
  return "<" + tag + (text_class.empty() ? "" : " class=\"" + text_class + "\"") + ">" + content + "</" +
         tag + ">\n";
}

std::string html_paragraph(std::string_view text, const std::string& text_class) {
  return html_element("p", svg_escaped(printed_signs(text)), text_class);
}

std::string html_list(const std::vector<std::string>& items) {
  std::string content;
  for (const std::string& item : items)
    content += html_element("li", svg_escaped(printed_signs(item)));
  return html_element("ul", content);
}

std::string html_preformatted(std::string_view text) {
  std::string lines; // one by one, since line ends are no characters that an element of SVG may have
  while (!text.empty()) {
    const std::size_t end = std::min(text.find('\n'), text.size());
    lines += svg_escaped(text.substr(0, end)) + "\n";
    text.remove_prefix(std::min(end + 1, text.size()));
  }
  return html_element("div", "<pre>" + lines + "</pre>\n", "wide");
}

std::string html_section(const std::string& id, std::string_view title, const std::string& content) {
  return "<section id=\"" + svg_escaped(id) + "\">\n" + html_element("h2", svg_escaped(title)) + content +
         "</section>\n";
}

std::string html_folded(std::string_view title, const std::string& content) {
  return html_element("details", html_element("summary", svg_escaped(title)) + content);
}

std::string html_table(const std::vector<std::string>& headings,
                       const std::vector<std::vector<std::string>>& rows) {
  // A column of numbers is one still where some of them are missing.
  std::vector<bool> numbers(headings.size()), words(headings.size());
  for (const std::vector<std::string>& row : rows)
    for (std::size_t k = 0; k < std::min(row.size(), headings.size()); ++k)
      if (is_number(row[k]))
        numbers[k] = true;
      else if (row[k] != missing && !row[k].empty())
        words[k] = true;
  const auto of_numbers = [&](std::size_t k) { return k < numbers.size() && numbers[k] && !words[k]; };
  std::string head;
  for (std::size_t k = 0; k < headings.size(); ++k)
    head += html_element(headings[k].empty() ? "td" : "th", svg_escaped(headings[k]),
                         of_numbers(k) ? "number" : "");
  std::string body;
  for (const std::vector<std::string>& row : rows) {
    std::string cells;
    for (std::size_t k = 0; k < row.size(); ++k)
      cells += html_element("td", svg_escaped(row[k]), is_number(row[k]) || of_numbers(k) ? "number" : "");
    body += html_element("tr", cells);
  }
  return "<div class=\"wide\" tabindex=\"0\">" + html_element("table", html_element("tr", head) + body) +
         "</div>\n";
}

std::string html_figure(const PageFigure& figure) {
  std::string panels, files;
  for (const PagePicture& picture : figure.pictures)
    panels += panel(picture);
  for (const PageFile& file : figure.files)
    files += (files.empty() ? " " : ", ") + link(file);
  const std::string title = figure.title.empty() ? "" : html_element("h3", svg_escaped(figure.title));
  return html_element("figure", title + html_element("div", panels, "panels") +
                                    html_element("figcaption", svg_escaped(figure.caption) + files));
}

std::string html_first_screen(std::string_view question, const std::vector<std::string>& answer,
                              const PageFigure& figure) {
  std::string sentences;
  for (const std::string& sentence : answer)
    sentences += html_paragraph(sentence);
  return html_element("header",
                      html_element("h1", svg_escaped(question)) + html_element("div", sentences, "answer") +
                          html_figure(figure),
                      "first");
}

std::string html_page(std::string_view title, const std::string& body) {
  return "<!DOCTYPE html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\"/>\n"
         "<meta name=\"viewport\" content=\"width=device-width, initial-scale=1\"/>\n" +
         html_element("title", svg_escaped(title)) +
         html_element("style", page_style() + dark_rules() + "\n") + "</head>\n<body>\n" +
         html_element("main", body) + html_element("script", page_script()) + "</body>\n</html>\n";
}

} // namespace granum::plot

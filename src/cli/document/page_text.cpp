// SPDX-License-Identifier: GPL-3.0-or-later
#include "page_text.hpp"

#include <algorithm>
#include <functional>

#include <granum/plot/page.hpp>
#include <granum/plot/svg_text.hpp>

namespace granum::cli {

namespace {

bool is_digit(char c) { return c >= '0' && c <= '9'; }
bool is_letter(char c) { return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z'); }

/// Applies a change to what is between the tags.
std::string with_words(const std::string& html,
                       const std::function<std::string(std::string_view words)>& changed) {
  std::string out;
  for (std::size_t at = 0; at < html.size();) {
    const std::size_t tag = std::min(html.find('<', at), html.size());
    out += changed(std::string_view(html).substr(at, tag - at));
    std::size_t end = std::min(html.find('>', tag), html.size() - 1) + 1;
    for (const std::string name : {"style", "script"})
      if (html.compare(tag, name.size() + 1, "<" + name) == 0)
        end = std::min(html.find("</" + name, tag), html.size());
    out += html.substr(tag, end - tag);
    at = end;
  }
  return out;
}

/// The end of the run of letters, digits and `more` that begins at a place.
std::size_t end_of_run(std::string_view text, std::size_t at, std::string_view more = "") {
  while (at < text.size() && (is_digit(text[at]) || is_letter(text[at]) || more.find(text[at]) < more.size()))
    ++at;
  return at;
}

std::string link_to(std::string_view address) {
  const std::string text = plot::svg_escaped(address);
  return "<a href=\"" + text + "\">" + text + "</a>";
}

} // namespace

std::string with_source_links(const std::string& html, std::span<const Reference> sources) {
  return with_words(html, [&](std::string_view words) {
    std::string out;
    for (std::size_t at = 0; at < words.size();) {
      const std::size_t end = std::max(end_of_run(words, at), at + 1);
      const std::string word(words.substr(at, end - at));
      const bool known = std::ranges::find(sources, word, &Reference::key) != sources.end();
      out += known ? "<a href=\"#" + word + "\">" + word + "</a>" : word;
      at = end;
    }
    return out;
  });
}

std::string with_decimal_commas(const std::string& html) {
  return with_words(html, [](std::string_view words) {
    std::string out;
    for (std::size_t at = 0; at < words.size();) {
      const std::size_t end = std::max(end_of_run(words, at, "."), at + 1);
      std::string word(words.substr(at, end - at));
      const std::size_t point = word.find('.');
      const bool decimal = point < word.size() - 1 && point == word.rfind('.') && is_digit(word[point + 1]) &&
                           (point == 0 || is_digit(word[point - 1]));
      if (decimal)
        word[point] = ',';
      out += word;
      at = end;
    }
    return out;
  });
}

std::string html_linked(std::string_view text) {
  std::string out;
  while (!text.empty()) {
    const std::size_t at = std::min(text.find("https://"), text.size());
    std::size_t end = std::min(text.find_first_of(" ;,", at), text.size());
    out += plot::svg_escaped(text.substr(0, at));
    if (at < end)
      out += link_to(text.substr(at, end - at));
    text.remove_prefix(end);
  }
  return out;
}

std::string html_sources(std::span<const Reference> sources) {
  if (sources.empty())
    return "";
  const bool remarks = std::ranges::any_of(sources, [](const Reference& one) { return !one.remark.empty(); });
  std::string rows = plot::html_element("th", "cited as") + plot::html_element("th", "reference");
  if (remarks)
    rows += plot::html_element("th", "what of it was not checked, and why its number can be used");
  rows = plot::html_element("tr", rows);
  for (const Reference& one : sources) {
    std::string cells = "<td id=\"" + std::string(one.key) + "\">" + std::string(one.key) + "</td>\n";
    const std::string text = plot::svg_escaped(one.text);
    cells += plot::html_element("td", one.link.empty() ? text : text + " " + link_to(one.link));
    if (remarks)
      cells += plot::html_element("td", html_linked(one.remark));
    rows += plot::html_element("tr", cells);
  }
  return plot::html_wide(plot::html_element("table", rows, "sources"));
}

} // namespace granum::cli

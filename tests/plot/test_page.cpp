// SPDX-License-Identifier: GPL-3.0-or-later
#include <granum/plot/page.hpp>

#include <granum/plot/svg_text.hpp>

#include "unit.hpp"
#include "well_formed.hpp"

using namespace granum::plot;

namespace {

/// The page without its script, which is no markup.
std::string markup(std::string page) {
  const std::size_t from = page.find("<script>"), end = page.find("</script>");
  return page.erase(from, end + 9 - from);
}

std::string figure() {
  return html_figure(
      {.title = "Moduli <of all>",
       .caption = "What is seen.",
       .pictures = {{.svg = "<svg></svg>\n", .choice = "G_hv"}, {.svg = "<svg></svg>\n", .choice = "G_hh"}},
       .files = {{"a.csv", "figures/a.csv"}, {"a.gp", "figures/a.gp"}}});
}

bool contains(const std::string& text, const std::string& piece) {
  return text.find(piece) != std::string::npos;
}

} // namespace

TEST_CASE("a page is well-formed, carries all it needs, and asks for nothing from outside") {
  const std::string page = html_page(
      "a < b",
      html_first_screen("Why?", {"Because & so."}, {.caption = "c", .pictures = {{.svg = "<svg></svg>\n"}}}) +
          html_section("more", "More", html_paragraph("x") + html_list({"one", "<two>"})) + figure());
  CHECK(well_formed(markup(page)));
  CHECK(contains(page, "<title>a &lt; b</title>"));
  CHECK(contains(page, "Because &amp; so."));
  CHECK(contains(page, "&lt;two&gt;"));
  CHECK(contains(page, "prefers-color-scheme: dark"));
  CHECK(contains(page, "@media print"));
  for (const char* piece : {"http:", "https:", "src=", "<link", "@import", "fetch(", "XMLHttp"}) {
    CAPTURE(piece);
    CHECK_FALSE(contains(page, piece));
  }
}

TEST_CASE("a figure has its pictures, its caption and its files, and labels each choice") {
  const std::string html = figure();
  CHECK(well_formed(html));
  CHECK(contains(html, "Moduli &lt;of all&gt;"));
  CHECK(contains(html, "<div class=\"panel\" data-choice=\"G_hv\">"));
  CHECK(contains(html, "<div class=\"panel\" data-choice=\"G_hh\">"));
  CHECK(
      contains(html, "What is seen. <a href=\"figures/a.csv\">a.csv</a>, <a href=\"figures/a.gp\">a.gp</a>"));
  CHECK(html.find("<svg") < html.find("<figcaption"));
}

TEST_CASE("folded content is below its title") {
  CHECK(html_folded("Table <2>", html_paragraph("x")) ==
        "<details><summary>Table &lt;2&gt;</summary>\n<p>x</p>\n</details>\n");
}

TEST_CASE("signs of a terminal are printed as such on a page, and names of columns stay") {
  CHECK(printed_signs("s = 0.5 +- 0.1 <= 1/(1+alpha), of sigma_v") ==
        "s = 0.5 \u00b1 0.1 \u2264 1/(1+\u03b1), of \u03c3_v");
  CHECK(printed_signs("alphabet my_alpha sigma_v_kPa sigma_h") == "alphabet my_alpha sigma_v_kPa \u03c3_h");
  CHECK(printed_signs("") == "");
  CHECK(html_list({"1 +- 2"}) == "<ul><li>1 \u00b1 2</li>\n</ul>\n");
}

TEST_CASE("columns of numbers are right-aligned, where some are missing too, and cells are escaped") {
  const std::string html = html_table({"what", "s", "none"}, {{"cone & co", "-", "-"}, {"-", "-0.1", "-"}});
  CHECK(well_formed(html));
  for (const char* cell :
       {"<th class=\"number\">s</th>", "<td>cone &amp; co</td>", "<td class=\"number\">-0.1</td>",
        "<td class=\"number\">-</td>", "<td>-</td>"}) // in a column of words
    CHECK(contains(html, cell));
}

TEST_CASE("a sentence that begins with a digit is text in a table, a number with its unit or range is none") {
  const auto cell = [](const std::string& text) {
    const std::string table = html_table({"what"}, {{text}, {"words"}});
    return table.find("<td class=\"number\">" + text) != std::string::npos;
  };
  for (const char* number : {"12.5", "12.5 MPa", "-3", "+0.12", "4.50 to 4.99 kPa", "0.336 kg/m3"})
    CHECK(cell(number));
  for (const char* text :
       {"6 of 200 grains", "2 specimens of 60 grains", "none", "-", "3 grains are left out: 1, 2"})
    CHECK_FALSE(cell(text));
  for (const std::string& wide : {html_table({"a"}, {{"b"}}), html_preformatted("a"), html_wide("a")})
    CHECK(wide.starts_with("<div class=\"wide\" tabindex=\"0\">"));
}

// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/document/page_text.hpp"

#include "unit.hpp"

using namespace granum::cli;

namespace {

constexpr Reference sources[] = {
    {"Lo2021", "Lo (2021): A <title>.", "https://doi.org/10.1", ""},
    {"Menq2003", "Menq (2003): B.", "", "as cited by Kottke, https://github.com/a/b; not read"}};

} // namespace

TEST_CASE("page text: a key of a source leads to its row") {
  CHECK(with_source_links("<p title=\"Lo2021\">[Lo2021; of2021]</p>", sources) ==
        "<p title=\"Lo2021\">[<a href=\"#Lo2021\">Lo2021</a>; of2021]</p>");
  CHECK(with_source_links("<style>Lo2021</style>", sources) == "<style>Lo2021</style>");
  CHECK(with_source_links("", sources).empty());
}

TEST_CASE("page text: numbers get decimal commas where words are") {
  CHECK(with_decimal_commas("<path d=\"M1.5\"/><p>0.7 (-0.5 to 1.25e-05), .5 of 3.5mm in 1.</p>") ==
        "<path d=\"M1.5\"/><p>0,7 (-0,5 to 1,25e-05), ,5 of 3,5mm in 1.</p>");
  CHECK(with_decimal_commas("<p>granum 0.2.0, table.csv, e.g. V_s.</p>") ==
        "<p>granum 0.2.0, table.csv, e.g. V_s.</p>");
}

TEST_CASE("page text: the table of sources has references with their addresses, and what was not checked") {
  const std::string html = html_sources(sources);
  for (const char* part : {"<td id=\"Lo2021\">Lo2021</td>",
                           "A &lt;title&gt;. <a href=\"https://doi.org/10.1\">https://doi.org/10.1</a>",
                           "<a href=\"https://github.com/a/b\">https://github.com/a/b</a>; not read"})
    CHECK_MESSAGE(html.find(part) != std::string::npos, part, " is missing in ", html);
  CHECK(html_sources({}).empty());
}

// SPDX-License-Identifier: GPL-3.0-or-later
// Colours, kinds, triangles, findings and roses of charts.
#include <granum/plot/chart.hpp>

#include <cstdio>
#include <set>

#include "chart_text.hpp"
#include "unit.hpp"
#include "well_formed.hpp"

using namespace granum::plot;
using namespace chart_text;

TEST_CASE("a colour may differ from the style, and a kind is listed once in grey") {
  Chart chart = chart_of({1, 2}, {1, 2});
  chart.series[0] = {.name = "cone",
                     .mark = Mark::marker,
                     .x = {1, 2},
                     .y = {1, 2},
                     .style = 2,
                     .colour = Colour::cone,
                     .kind = "probe"};
  chart.series.push_back(chart.series[0]);
  chart.series[1].name = "sphere";
  chart.series[1].colour = Colour::sphere;
  const std::string picture = svg(chart);
  CHECK(well_formed(picture));
  CHECK(texts(picture, "legend") == Texts{"cone", "sphere", "probe"});
  CHECK(count(picture, "class=\"series c1\"") == 1);
  CHECK(count(picture, "class=\"series c0\"") == 1);
  CHECK(count(picture, "class=\"cg\"") == 1);        // the sample of the kind
  CHECK(count(picture, "data-kind=\"probe\"") == 3); // two series and a name
  CHECK(count(picture, "<circle") == 0);             // style 2 has diamonds
}

TEST_CASE("a marker of each shape has its point in its middle, and none is larger than twice another") {
  Chart chart = chart_of({1, 2}, {1, 2});
  chart.series.clear();
  for (std::size_t style = 0; style < 4; ++style)
    chart.series.push_back({.name = "", .mark = Mark::marker, .x = {1}, .y = {1}, .style = style});
  const std::string picture = svg(chart);
  const double x = all(picture, "<circle", "cx").front(), y = all(picture, "<circle", "cy").front(),
               r = all(picture, "<circle", "r").front();
  const std::size_t square = picture.find("<rect", picture.find("<circle"));
  const std::string rect = picture.substr(square, picture.find('>', square) - square);
  CHECK(attribute(rect, "width") == relative(2 * r, 1e-12));
  CHECK(attribute(rect, "height") == relative(2 * r, 1e-12));
  CHECK(attribute(rect, "x") + r == relative(x, 1e-3));
  CHECK(attribute(rect, "y") + r == relative(y, 1e-3));
  std::size_t corners = 4; // of a diamond, then of a triangle
  for (std::size_t at = picture.find("d=\"M", square); corners > 2; at = picture.find("d=\"M", at + 1)) {
    REQUIRE(at != std::string::npos);
    double px = 0, py = 0, left = 1e9, right = 0, top = 1e9, foot = 0;
    int read = 0;
    const char* text = picture.c_str() + at + 4;
    for (std::size_t k = 0; k < corners && std::sscanf(text, "%lf,%lf%n", &px, &py, &read) == 2; ++k) {
      text += read + 1;
      left = std::min(left, px), right = std::max(right, px), top = std::min(top, py),
      foot = std::max(foot, py);
    }
    CHECK((left + right) / 2 == relative(x, 1e-3));
    CHECK((top < y && y < foot && right - left > 2 * r && right - left < 4 * r));
    CHECK(foot - top == relative(right - left, 0.1)); // nearly as high as wide
    --corners;
  }
}

TEST_CASE("every colour has the contrast of text and a name, and none occurs twice") {
  const auto luminance = [](std::string_view colour) {
    const double weights[] = {0.2126, 0.7152, 0.0722};
    double sum = 0;
    for (std::size_t k = 0; k < 3; ++k) {
      const double share = std::stoi(std::string(colour.substr(1 + 2 * k, 2)), nullptr, 16) / 255.0;
      sum += weights[k] * (share <= 0.03928 ? share / 12.92 : std::pow((share + 0.055) / 1.055, 2.4));
    }
    return sum;
  };
  // The ratio of WCAG 2.1, 1.4.3.
  const auto contrast = [&](std::string_view a, std::string_view b) {
    const auto [low, high] = std::minmax({luminance(a), luminance(b)});
    return (high + 0.05) / (low + 0.05);
  };
  CHECK(contrast("#000000", "#ffffff") == relative(21, 1e-12));
  std::set<std::string_view> seen;
  std::vector<PaletteRow> all(std::begin(palette), std::end(palette));
  CHECK(all.size() == static_cast<std::size_t>(Colour::force) + 1);
  all.push_back(reference_grey);
  for (const PaletteRow& row : all) {
    CAPTURE(std::string(row.name));
    CHECK(contrast(row.light, "#ffffff") >= 4.5);
    CHECK(contrast(row.dark, "#15181c") >= 4.5);
    for (const std::string_view text : {row.name, row.light, row.dark})
      CHECK(seen.insert(text).second);
  }
  CHECK(std::string_view(palette[static_cast<std::size_t>(Colour::measured)].name) == "measured");
  CHECK(std::string_view(palette[static_cast<std::size_t>(Colour::closed_form)].name) == "closed_form");
}

TEST_CASE("a slope triangle has its labelled slope, and its text lies inside the picture") {
  Chart chart = chart_of({1, 100}, {1, 100}, Scale::logarithmic);
  chart.triangles = {{.x0 = 10, .x1 = 100, .y0 = 1, .slope = 0.5, .text = "s = 0.50"},
                     {.x0 = 10, .x1 = 100, .y0 = 1.01, .slope = 0.5, .text = "s = 0.51"}};
  const std::string picture = svg(chart);
  const std::size_t path = picture.find("stroke-width=\"1.3\" d=\"M");
  REQUIRE(path != std::string::npos);
  double x0 = 0, y0 = 0, x1 = 0, y1 = 0, x2 = 0, y2 = 0;
  REQUIRE(std::sscanf(picture.c_str() + picture.find("d=\"M", path), "d=\"M%lf,%lfL%lf,%lfL%lf,%lf", &x0, &y0,
                      &x1, &y1, &x2, &y2) == 6);
  // The plot is 520 wide and 380 high for two decades each way, and a margin of 4 % at either end.
  CHECK(x1 - x0 == relative(520 / 2.16, 1e-3));
  CHECK(y0 == y1);
  CHECK(x2 == x1);
  CHECK(y1 - y2 == relative(0.5 * 380 / 2.16, 1e-3));
  CHECK(texts(picture, "slope") == Texts{"s = 0.50", "s = 0.51"});
  const auto y = all(picture, "<text class=\"slope\"", "y");
  REQUIRE(y.size() == 2);
  CHECK(std::abs(y[0] - y[1]) >= 15.9); // they would lie upon each other
  CHECK(picture.find("class=\"slope c") == std::string::npos);

  chart.triangles[1].colour = Colour::sphere; // its text has this colour too
  const std::string coloured = svg(chart);
  const std::size_t label = coloured.find("class=\"slope c");
  REQUIRE(label != std::string::npos);
  const std::string tag = coloured.substr(label, coloured.find('<', label) - label);
  CHECK(tag.find("fill=\"currentColor\"") != std::string::npos);
  CHECK(tag.find("color=\"" + std::string(palette[static_cast<std::size_t>(Colour::sphere)].light) + "\"") !=
        std::string::npos);
  CHECK(tag.find("s = 0.51") != std::string::npos);
}

TEST_CASE("a picture has a text description: its finding, or the ends of its series") {
  Chart chart = chart_of({1, 2}, {10, 30});
  chart.title = "Moduli";
  chart.series[0].name = "rung 2";
  CHECK(svg(chart).find("aria-label=\"Moduli; rung 2: 10 at 1, 30 at 2\"") != std::string::npos);
  chart.finding = "G triples";
  CHECK(svg(chart).find("aria-label=\"G triples\"") != std::string::npos);
  CHECK(svg(chart).find("prefers-color-scheme:dark") != std::string::npos);
  const std::string part = svg_in_page(chart);
  CHECK(part.starts_with("<svg "));
  CHECK(well_formed(part));
  CHECK(part.find("<style") == std::string::npos);
}

TEST_CASE("titles are broken where they are too long, and labels that would touch are left out") {
  Chart chart = chart_of({123456, 123456.01}, {0, 1});
  chart.width = 200;
  chart.title = "a title that is so very much longer than the picture below it is wide";
  const std::string picture = svg(chart);
  CHECK(texts(picture, "title").size() == 3);
  CHECK(texts(picture, "x-label").size() == 2);
}

TEST_CASE("a rose shows its series in all four quadrants, errors in one") {
  Chart chart{
      .title = "",
      .x = {.title = "angle"},
      .y = {.title = "E"},
      .series =
          {{.name = "counted", .mark = Mark::marker, .x = {0.4, 1.2}, .y = {1, 2}, .y_error = {0.1, 0.2}},
           {.name = "fitted", .mark = Mark::line, .x = {0, 0.7, 1.5}, .y = {1, 1.5, 2}}},
      .width = 300,
      .height = 300,
      .rose = true};
  const std::string picture = svg(chart);
  CHECK(well_formed(picture));
  CHECK(count(picture, "class=\"error\"") == 3); // two bars, one in the legend
  const std::size_t sectors = picture.find("class=\"sectors\"");
  REQUIRE(sectors != std::string::npos);
  CHECK(count(picture.substr(sectors, picture.find("/>", sectors) - sectors), "A") == 8);
  CHECK(texts(picture, "legend") == Texts{"counted", "fitted"});
  // The longest is 2.2 with its error, and the rose has a radius of 150: 2 in the sector, 1 in the line.
  CHECK(picture.find("A136.36,136.36") != std::string::npos);
  CHECK(picture.find("data-most=\"2.2\"") != std::string::npos);
  CHECK(picture.find("data-values=\"0.4 1 0.1;1.2 2 0.2\"") != std::string::npos);
  // Of markers and lines: points all around, errors in one quadrant, no sectors.
  chart.series[0].mark = Mark::both;
  const std::string points = svg(chart);
  CHECK(count(points, "<circle") == count(picture, "<circle") + 8 + 1); // one in the legend
  CHECK(count(points, "class=\"error\"") == 3);
  CHECK(count(points, "class=\"sectors\"") == 0);
  chart.series.clear();
  CHECK(well_formed(svg(chart)));
}

TEST_CASE("titles are in the middle of their axes, ticks outside, legends go down, and all is inside of the "
          "picture") {
  Chart chart = chart_of({1, 3, 10}, {1, 5, 10}, Scale::logarithmic);
  chart.series[0].name = "one";
  chart.series.push_back({.name = "two", .x = {1, 10}, .y = {2, 3}});
  chart.triangles = {{.x0 = 2, .x1 = 5, .y0 = 2, .slope = 0.5, .text = "s"}};
  Chart rose = chart_of({0, 0.7, 1.5}, {1, 1.5, 2});
  rose.title = "a rose below a title of so many words that it is broken into several lines, each of them "
               "above the rose";
  rose.rose = true;
  for (const Chart& one : {chart, rose}) {
    const std::string picture = svg(one);
    for (const auto& [size, names] : {std::pair("width", std::array{"x", "x1", "x2", "cx"}),
                                      {"height", std::array{"y", "y1", "y2", "cy"}}})
      for (const char* const name : names)
        for (const double place : all(picture, "<", name))
          CHECK((place >= 0 && place <= attribute(picture, size)));
    for (const double r : all(picture, "<circle", "r"))
      CHECK(all(picture, "<circle", "cy").front() - r >
            (one.rose ? all(picture, "<text class=\"title\"", "y").back() : 0));
  }
  const std::string picture = svg(chart);
  const auto x1 = all(picture, "<line", "x1"), x2 = all(picture, "<line", "x2"),
             y1 = all(picture, "<line", "y1"), y2 = all(picture, "<line", "y2");
  double top = 1e9, foot = 0;
  std::vector<double> ticks; // of the axis below
  for (std::size_t k = 0; k < x1.size(); ++k)
    if (x1[k] == x2[k] && y2[k] - y1[k] > 50)
      top = std::min(top, y1[k]), foot = std::max(foot, y2[k]);
  for (std::size_t k = 0; k < x1.size(); ++k)
    if (x1[k] == x2[k] && y1[k] == foot)
      ticks.push_back(y2[k] - foot);
  CHECK(ticks.size() == 10);
  CHECK(*std::min_element(ticks.begin(), ticks.end()) > 0);
  CHECK(static_cast<std::size_t>(
            std::count(ticks.begin(), ticks.end(), *std::max_element(ticks.begin(), ticks.end()))) ==
        texts(picture, "x-label").size());
  CHECK(all(picture, "<text class=\"y-title\"", "y").front() == relative((top + foot) / 2, 1e-3));
  const double paper = all(picture, "<rect class=\"paper\"", "y").front(),
               text = all(picture, "<text class=\"slope\"", "y").front();
  CHECK((paper < text && text < paper + all(picture, "<rect class=\"paper\"", "height").front()));
  const auto legend = all(picture, "<text class=\"legend\"", "y");
  REQUIRE(legend.size() == 2);
  CHECK(legend[1] > legend[0]);
  double from = 0, y = 0, to = -1; // of the line in the legend
  for (std::size_t at = picture.find("d=\"M"); at != std::string::npos && to < 0;
       at = picture.find("d=\"M", at + 1))
    if (std::sscanf(picture.c_str() + at, "d=\"M%lf,%lfH%lf", &from, &y, &to) < 3)
      to = -1;
  CHECK((to > from && to < all(picture, "<text class=\"legend\"", "x").front()));
}

// SPDX-License-Identifier: GPL-3.0-or-later
// Colours, kinds, triangles, findings and roses of charts.
#include <granum/plot/chart.hpp>

#include <array>
#include <cmath>
#include <cstdio>
#include <numbers>
#include <set>

#include "chart_text.hpp"
#include "plot/look.hpp"
#include "unit.hpp"
#include "well_formed.hpp"

using namespace granum::plot;
using namespace chart_text;

namespace {

constexpr double pi = std::numbers::pi;

}

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
  for (std::size_t style = 0; style < 5; ++style) // the fifth looks like the first
    chart.series.push_back({.name = "", .mark = Mark::marker, .x = {1}, .y = {1}, .style = style});
  const std::string picture = svg(chart);
  const double x = all(picture, "<circle", "cx").front(), y = all(picture, "<circle", "cy").front(),
               r = all(picture, "<circle", "r").front();
  CHECK(count(picture, "<circle") == 2);
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
    CHECK(std::abs((left + right) / 2 - x) < 0.02);
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
  CHECK(texts(picture, "legend") == Texts{"counted", "fitted"});
  // The longest is 2.2 with its error, and the rose has a radius of 150.
  const double cx = attribute(picture, "cx"), cy = attribute(picture, "cy"), scale = 150 / 2.2;
  const auto turned = [](double angle, std::size_t side) { // of the quarter: to the right, left, below
    return std::array{angle, pi - angle, pi + angle, 2 * pi - angle}.at(side);
  };
  const auto is_at = [&](double x, double y, double angle, double length) {
    return std::hypot(x - cx - scale * length * std::sin(angle), y - cy + scale * length * std::cos(angle)) <
           0.02;
  };
  const std::vector<double> sectors = path_numbers(picture, "class=\"sectors\"");
  REQUIRE(sectors.size() == 8 * 11); // from the centre to one end, around to the other
  for (std::size_t k = 0; k < 8; ++k) {
    const double* const n = &sectors[11 * k];
    const std::size_t side = k / 2, j = side % 2 == 0 ? k % 2 : 1 - k % 2;
    const double angle = turned(j == 0 ? 0.4 : 1.2, side), length = j == 0 ? 1 : 2;
    CHECK((is_at(n[0], n[1], 0, 0) && is_at(n[2], n[3], angle - 0.4, length)));
    CHECK((is_at(n[9], n[10], angle + 0.4, length) && std::abs(n[4] - scale * length) < 0.01));
  }
  const std::vector<double> line = path_numbers(picture, "class=\"line\"");
  REQUIRE(line.size() == 12 * 2);
  for (std::size_t k = 0; k < 12; ++k) {
    const std::size_t side = k / 3, j = side % 2 == 0 ? k % 3 : 2 - k % 3;
    CHECK(is_at(line[2 * k], line[2 * k + 1], turned(std::array{0.0, 0.7, 1.5}.at(j), side),
                1 + 0.5 * static_cast<double>(j)));
  }
  // The first error, from 0.9 to 1.1 along its direction, with caps across.
  const std::vector<double> bar = path_numbers(picture, "class=\"error\"");
  REQUIRE(bar.size() == 12);
  CHECK((is_at(bar[4], bar[5], 0.4, 0.9) && is_at(bar[6], bar[7], 0.4, 1.1)));
  for (const std::size_t cap : {0U, 8U}) {
    const double length = cap == 0 ? 0.9 : 1.1;
    CHECK(is_at((bar[cap] + bar[cap + 2]) / 2, (bar[cap + 1] + bar[cap + 3]) / 2, 0.4, length));
    CHECK((bar[cap + 2] - bar[cap]) * std::sin(0.4) ==
          relative((bar[cap + 3] - bar[cap + 1]) * std::cos(0.4), 1e-2));
  }
  // Circles at round lengths, the last one labelled; two diameters, with their names at the ends.
  const auto circles = all(picture, "<circle class=\"grid\"", "r");
  REQUIRE(circles.size() == 4);
  for (std::size_t k = 0; k < 4; ++k)
    CHECK(std::abs(circles[k] - 0.5 * scale * static_cast<double>(k + 1)) < 0.02);
  CHECK(texts(picture, "y-label") == Texts{"2"});
  CHECK(is_at(all(picture, "<text class=\"y-label\"", "x").at(0) - 6,
              all(picture, "<text class=\"y-label\"", "y").at(0) - 14, 0.75 * pi, 2));
  for (const std::size_t k : {0U, 1U}) {
    const auto end = [&](const char* name) { return all(picture, "<line class=\"grid\"", name).at(k); };
    CHECK((is_at(end("x1"), end("y1"), k == 0 ? 0 : pi / 2, 2.2) &&
           is_at(end("x2"), end("y2"), k == 0 ? pi : 1.5 * pi, 2.2)));
  }
  const auto name_x = all(picture, "<text class=\"x-label\"", "x"),
             name_y = all(picture, "<text class=\"x-label\"", "y");
  CHECK((std::abs(name_x.at(0) - cx) < 0.01 && name_y.at(0) < cy - 150 && name_y[0] > cy - 175));
  CHECK(all(picture, "<text class=\"x-title\"", "y").at(0) - font_size > cy + 150);
  CHECK((name_x.at(1) > cx + 150 && name_x[1] < cx + 175 && std::abs(name_y.at(1) - cy) < 8));
  CHECK(picture.find("data-most=\"2.2\"") != std::string::npos);
  CHECK(picture.find("data-values=\"0.4 1 0.1;1.2 2 0.2\"") != std::string::npos);
  // Of markers and lines: points all around, errors in one quadrant, no sectors.
  chart.series[0].mark = Mark::both;
  const std::string points = svg(chart);
  CHECK(count(points, "<circle") == count(picture, "<circle") + 8 + 1); // one in the legend
  CHECK(count(points, "class=\"error\"") == 3);
  CHECK(count(points, "class=\"sectors\"") == 0);
  // One sector fills its quarter; a circle on the edge counts, though rounding may put it outside.
  chart.series = {{.name = "", .mark = Mark::marker, .x = {0.5}, .y = {0.3}}};
  const std::vector<double> quarter = path_numbers(svg(chart), "class=\"sectors\"");
  CHECK(is_at(quarter.at(9), quarter.at(10), 0.5 + pi / 4, 2.2));
  CHECK(all(svg(chart), "<circle class=\"grid\"", "r").back() == relative(150, 1e-4));
  chart.series.clear();
  CHECK(well_formed(svg(chart)));
}

TEST_CASE("texts of a picture lie inside of it, and none upon another") {
  Chart dense = chart_of({1e-5, 3e-5}, {0.1234, 0.1239});
  dense.title =
      "a title that is so long that it takes more than one line, were the picture not so wide as it is";
  dense.width = dense.height = 150;
  dense.series[0].name = "a long name of a series";
  dense.x.asked = {1.21e-5, 1.3e-5, 2.9e-5};
  for (int k = 0; k < 7; ++k)
    dense.series.push_back(
        {.name = "series of number " + std::to_string(k), .x = {1e-5 + 1e-7 * k}, .y = {0.1235}});
  dense.triangles = {{.x0 = 1e-5, .x1 = 2e-5, .y0 = 0.1234, .slope = 0.005, .text = "s = 0.50"},
                     {.x0 = 1e-5, .x1 = 2e-5, .y0 = 0.12345, .slope = 0.005, .text = "s = 0.51"}};
  Chart wide = chart_of({1, 1e9}, {1e-7, 1e9}, Scale::logarithmic), rose = dense;
  wide.height = 60;
  wide.x.reversed = wide.y.reversed = true;
  rose.rose = true;
  rose.width = rose.height = 300;
  rose.triangles.clear();
  std::vector<Chart> charts{dense, wide, rose};
  charts.push_back(dense);
  charts.back().legend_below = true;
  charts.push_back(charts.back());
  charts.back().series[3].name = "a name that is longer than the plot and all of its labels are wide, by far";
  for (const Chart& chart : charts) {
    const std::string picture = svg(chart);
    std::vector<std::array<double, 4>> boxes; // left, right, top and foot
    for (std::size_t at = picture.find("<text "); at != std::string::npos;
         at = picture.find("<text ", at + 1)) {
      const std::string tag = picture.substr(at, picture.find('>', at) - at),
                        text = picture.substr(at + tag.size() + 1,
                                              picture.find("</text>", at) - at - tag.size() - 1);
      const double size =
          tag.find("font-size") != std::string::npos ? attribute(tag, "font-size") : font_size;
      const std::size_t power = text.find("<tspan");
      const double length = power == std::string::npos
                                ? text_width(text, size)
                                : text_width(text.substr(0, power)) +
                                      text_width(text.substr(text.rfind('>', text.size() - 9) + 1), 11) -
                                      text_width("</tspan>", 11);
      const double x = attribute(tag, "x"), y = attribute(tag, "y");
      const double left = tag.find("middle") != std::string::npos    ? x - length / 2
                          : tag.find("\"end\"") != std::string::npos ? x - length
                                                                     : x;
      if (tag.find("rotate") != std::string::npos)
        boxes.push_back({x - 0.8 * size, x + 0.2 * size, y - length / 2, y + length / 2});
      else
        boxes.push_back({left, left + length, y - 0.8 * size, y + 0.2 * size});
      CAPTURE(text);
      const std::array<double, 4>& box = boxes.back();
      CHECK((box[0] >= 0 && box[1] <= attribute(picture, "width")));
      CHECK((box[2] >= 0 && box[3] <= attribute(picture, "height")));
      for (std::size_t k = 0; k + 1 < boxes.size(); ++k)
        CHECK((boxes[k][1] <= box[0] || box[1] <= boxes[k][0] || boxes[k][3] <= box[2] ||
               box[3] <= boxes[k][2]));
    }
    CHECK(boxes.size() > 8);
    // Papers hide what lies behind their texts; lines of the grid cross the whole plot.
    const auto paper = all(picture, "<rect class=\"paper\"", "x"),
               paper_width = all(picture, "<rect class=\"paper\"", "width"),
               slope = all(picture, "<text class=\"slope\"", "x");
    for (std::size_t k = 0; k < paper.size(); ++k)
      CHECK((paper[k] <= slope.at(k) && paper[k] + paper_width[k] >= slope[k] + text_width("s = 0.50")));
    if (chart.rose)
      continue;
    const std::string frame = picture.substr(picture.find("<rect class=\"frame\""));
    const double left = attribute(frame, "x"), top = attribute(frame, "y");
    const auto end = [&](const char* name) { return all(picture, "<line class=\"grid\"", name); };
    const auto x1 = end("x1"), x2 = end("x2"), y1 = end("y1"), y2 = end("y2");
    for (std::size_t k = 0; k < x1.size(); ++k)
      CHECK((x1[k] == x2[k]
                 ? std::abs(y1[k] - top) < 0.011 && std::abs(y2[k] - top - chart.height) < 0.011
                 : std::abs(x1[k] - left) < 0.011 && std::abs(x2[k] - left - chart.width) < 0.011));
  }
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
  CHECK(all(picture.substr(picture.find("class=\"key\"")), "<circle", "cx").front() == (from + to) / 2);
}

// SPDX-License-Identifier: GPL-3.0-or-later
#include <granum/plot/chart.hpp>

#include <cstdio>
#include <span>

#include <granum/core/text.hpp>

#include "chart_text.hpp"
#include "unit.hpp"
#include "well_formed.hpp"

using namespace granum::plot;
using namespace chart_text;

namespace {

constexpr double nothing = std::numeric_limits<double>::quiet_NaN();
constexpr double largest = std::numeric_limits<double>::max();

/// The number that a label shows.
double shown(std::string label) {
  const std::string ten = "10^";
  const std::size_t at = label.find(ten);
  if (at == std::string::npos)
    return parse_number(label).value();
  const std::string mantissa = at == 0 ? "1" : label.substr(0, label.find("\u00b7"));
  return parse_number(mantissa + "e" + label.substr(at + ten.size())).value();
}

} // namespace

TEST_CASE("a chart becomes one well-formed SVG with its texts, and the same bytes again") {
  Chart chart = chart_of({1, 2, 3}, {10, 30, 20});
  chart.title = "Moduli";
  chart.x.title = "p' [kPa]";
  chart.series[0].name = "rung 2";
  chart.series.push_back({.name = "points", .mark = Mark::marker, .x = {1, 2}, .y = {15, 25}});
  const std::string picture = svg(chart);
  CHECK(well_formed(picture));
  CHECK(texts(picture, "title") == std::vector<std::string>{"Moduli"});
  CHECK(texts(picture, "x-title") == std::vector<std::string>{"p' [kPa]"});
  CHECK(texts(picture, "legend") == std::vector<std::string>{"rung 2", "points"});
  CHECK(svg(chart) == picture);
  CHECK(picture.find("href") == std::string::npos);
  CHECK_FALSE(well_formed(picture.substr(0, picture.size() - 8)));
}

TEST_CASE("requested numbers have ticks, and round ones are omitted next to them") {
  Chart chart = chart_of({2.76, 34.47}, {587, 1003}, Scale::logarithmic);
  const auto labels = [&chart] { return texts(svg(chart), "x-label"); };
  CHECK(labels() == std::vector<std::string>{"5", "10", "20"});
  chart.x.asked = {6.89, 34.47, 2.76, 100};
  CHECK(labels() == std::vector<std::string>{"2.76", "5", "6.89", "10", "20", "34.47"});
  chart.x.asked = {20.1, 20.2};
  CHECK(labels() == std::vector<std::string>{"5", "10", "20.1"});
}

TEST_CASE("texts from outside cannot break the file") {
  Chart chart = chart_of({1, 2}, {1, 2});
  chart.title = "a < b & \"c\" > d\x01\n \xff \u03c3";
  chart.series[0].name = "</svg><script>\xed\xa0\x80";
  const std::string picture = svg(chart);
  CHECK(well_formed(picture));
  CHECK(texts(picture, "title") ==
        std::vector<std::string>{"a &lt; b &amp; &quot;c&quot; &gt; d?? ? \u03c3"});
  CHECK(texts(picture, "legend") == std::vector<std::string>{"&lt;/svg&gt;&lt;script&gt;???"});
}

TEST_CASE("linear ticks are round numbers in equal steps") {
  CHECK(texts(svg(chart_of({0, 1}, {0, 0.37})), "x-label") ==
        std::vector<std::string>{"0", "0.2", "0.4", "0.6", "0.8", "1"});
  CHECK(texts(svg(chart_of({-120, 130}, {0, 1})), "x-label") ==
        std::vector<std::string>{"-100", "-50", "0", "50", "100"});
  CHECK(texts(svg(chart_of({0, 3e7}, {0, 1})), "x-label") ==
        std::vector<std::string>{"0", "0.5\u00b710^7", "1\u00b710^7", "1.5\u00b710^7", "2\u00b710^7",
                                 "2.5\u00b710^7", "3\u00b710^7"});
  // far from zero, labels still tell the ticks apart
  const auto close = texts(svg(chart_of({123456, 123456.01}, {0, 1})), "x-label");
  CHECK(close.front() == "123456");
  CHECK(close.at(1) == "123456.002");
}

TEST_CASE("logarithmic ticks are powers of ten, with 2 and 5 where there is room") {
  CHECK(texts(svg(chart_of({1, 1e6}, {1, 2}, Scale::logarithmic)), "x-label") ==
        std::vector<std::string>{"10^0", "10^1", "10^2", "10^3", "10^4", "10^5", "10^6"});
  CHECK(texts(svg(chart_of({10, 1000}, {1, 2}, Scale::logarithmic)), "x-label") ==
        std::vector<std::string>{"10", "20", "50", "100", "200", "500", "1000"});
  CHECK(texts(svg(chart_of({1e-3, 1e-2}, {1, 2}, Scale::logarithmic)), "x-label") ==
        std::vector<std::string>{"0.001", "0.002", "0.005", "0.01"});
  CHECK(texts(svg(chart_of({2e7, 6e8}, {1, 2}, Scale::logarithmic)), "x-label") ==
        std::vector<std::string>{"2\u00b710^7", "5\u00b710^7", "10^8", "2\u00b710^8", "5\u00b710^8"});
  // less than a decade: equal steps
  CHECK(texts(svg(chart_of({100, 200}, {1, 2}, Scale::logarithmic)), "x-label") ==
        std::vector<std::string>{"100", "120", "140", "160", "180", "200"});
}

TEST_CASE("any range gets at least two labels, in order and well-formed") {
  constexpr double tiny = std::numeric_limits<double>::denorm_min();
  constexpr double smallest = std::numeric_limits<double>::min();
  using Ranges = std::vector<std::pair<double, double>>;
  const Ranges linear = {{0, 1},
                         {-largest, largest},
                         {0, largest},
                         {-1e-300, 1e-300},
                         {0, tiny},
                         {1e15, 1000000000000001},
                         {1, 1.00000000001},
                         {5, 5},
                         {-7e8, -7e8},
                         {0, 0},
                         {largest, largest},
                         {1e-20, 3e-20},
                         {0.0123, 0.0124}};
  const Ranges logarithmic = {{tiny, largest}, {smallest, 1}, {1, 1},           {1, 6.3},
                              {1, 6.4},        {3, 30},       {9.9, 160},       {1, 1e9},
                              {1e-5, 3e-5},    {tiny, tiny},  {1e-290, 1e-290}, {largest, largest},
                              {1e300, largest}};
  for (const Scale scale : {Scale::linear, Scale::logarithmic})
    for (const auto& [low, high] : scale == Scale::linear ? linear : logarithmic) {
      const std::vector<double> range{low, high};
      CAPTURE(range[0]);
      CAPTURE(range[1]);
      const std::string picture = svg(chart_of(range, range, scale));
      CHECK(well_formed(picture));
      CHECK(picture.find("inf") == std::string::npos);
      CHECK(picture.find("nan") == std::string::npos);
      const auto labels = texts(picture, "y-label");
      REQUIRE(labels.size() >= 2);
      CHECK(labels.size() <= 10);
      for (std::size_t k = 1; k < labels.size(); ++k)
        CHECK(shown(labels[k]) > shown(labels[k - 1]));
    }
}

TEST_CASE("points are at their numbers, in the unit of the axis") {
  Chart chart = chart_of({0, 500e3, 1000e3}, {0, 1, 2});
  chart.x.unit = 1e3;
  chart.series[0].mark = Mark::line;
  const std::string picture = svg(chart);
  CHECK(texts(picture, "x-label") == std::vector<std::string>{"0", "200", "400", "600", "800", "1000"});
  // 520 x 380 units from (66.04, 14): labels of three letters, no title; 4 % of the range is margin
  CHECK(picture.find("M85.30,379.93L326.04,204.00L566.78,28.07") != std::string::npos);
}

TEST_CASE("rows that cannot be drawn are left out, and the line has a gap there") {
  Chart chart = chart_of({1, 2, 3, 4, 5, 6}, {1, 2, nothing, 4, 5, largest * 10});
  const std::string picture = svg(chart);
  CHECK(well_formed(picture));
  CHECK(count(picture, "<circle") == 4);
  const std::size_t line = picture.find(" d=\"M") + 4;
  const std::string path = picture.substr(line, picture.find('"', line) - line);
  CHECK(count(path, "M") == 2);
  CHECK(count(path, "L") == 2);

  chart = chart_of({-1, 0, 1, 10}, {1, 1, 0, 10}, Scale::logarithmic);
  CHECK(count(svg(chart), "<circle") == 1);
}

TEST_CASE("empty series and charts give only axes, and one point is drawn") {
  for (const Scale scale : {Scale::linear, Scale::logarithmic}) {
    Chart chart = chart_of({}, {}, scale);
    CHECK(well_formed(svg(chart)));
    CHECK(texts(svg(chart), "x-label").size() >= 2);
    CHECK(count(svg(chart), "<circle") == 0);
    chart.series.clear();
    CHECK(well_formed(svg(chart)));
    chart = chart_of({nothing}, {nothing}, scale);
    CHECK(count(svg(chart), "<circle") == 0);
    chart = chart_of({3}, {4}, scale);
    CHECK(well_formed(svg(chart)));
    CHECK(count(svg(chart), "<circle") == 1);
    const std::string picture = svg(chart);
    const std::string frame = picture.substr(picture.find("class=\"frame\""));
    const double x = attribute(frame, "x") + 520 / 2.0, y = attribute(frame, "y") + 380 / 2.0;
    CHECK(attribute(picture.substr(picture.find("<circle")), "cx") == relative(x, 1e-4)); // in the middle
    CHECK(attribute(picture.substr(picture.find("<circle")), "cy") == relative(y, 1e-4));
  }
}

TEST_CASE("error bars are drawn if there is an error, and lie within the axis") {
  Chart chart = chart_of({1, 2, 3, 4}, {10, 10, 10, 10});
  chart.series[0].y_error = {10, 0, nothing, 5};
  const std::string picture = svg(chart);
  CHECK(well_formed(picture));
  CHECK(count(picture, "class=\"error\"") == 2);
  CHECK(texts(picture, "y-label") == std::vector<std::string>{"0", "5", "10", "15", "20"});

  // the lower end of a bar that a logarithmic axis cannot show lies on its edge
  chart = chart_of({1, 10}, {1, 10}, Scale::logarithmic);
  chart.series[0].y_error = {2, 0};
  const std::string log_picture = svg(chart);
  CHECK(count(log_picture, "class=\"error\"") == 1);
  CHECK(log_picture.find("V394.00M") != std::string::npos);
  CHECK(log_picture.find("nan") == std::string::npos);
}

TEST_CASE("a chart that contradicts itself is refused") {
  Chart chart = chart_of({1, 2}, {1});
  CHECK_THROWS_AS((void)svg(chart), InvalidArgument);
  chart = chart_of({1, 2}, {1, 2});
  chart.series[0].y_error = {1};
  CHECK_THROWS_AS((void)svg(chart), InvalidArgument);
  chart = chart_of({1, 2}, {1, 2});
  chart.y.unit = 0;
  CHECK_THROWS_AS((void)svg(chart), InvalidArgument);
}

TEST_CASE("series of one style look alike, and tones differ from the full one") {
  Chart chart = chart_of({1, 2}, {1, 2});
  chart.series[0].style = 3;
  chart.series.push_back(chart.series[0]);
  const auto colours = [&] { return count(svg(chart), "color=\"#6b3fa0\""); };
  const std::string alike = svg(chart);
  CHECK(count(alike, "stroke=\"currentColor\" stroke-width=\"2\" stroke-dasharray=\"10 3 2 3\"") == 2);
  CHECK(count(alike, "color=\"#0072b2\"") == 0);
  const auto all = colours();
  chart.series[1].tone = Tone::grey;
  CHECK(colours() == all / 2);
  CHECK(count(svg(chart), "color=\"#6b6f75\"") == 1);
  chart.series[1].tone = Tone::hollow;
  CHECK(count(svg(chart), "fill=\"white\" stroke=\"currentColor\"") == 1);
  chart.series[1].tone = Tone::faint;
  CHECK(count(svg(chart), "opacity=\"0.55\"") == 1);
  CHECK(well_formed(svg(chart)));
}

TEST_CASE("a legend below the plot makes the picture higher and not wider") {
  Chart chart = chart_of({1, 2}, {1, 2});
  chart.width = 300;
  chart.height = 200;
  chart.legend_below = true;
  chart.series[0].name = "";
  const double width = attribute(svg(chart), "width");
  for (int k = 0; k < 6; ++k) {
    chart.series.push_back(chart.series[0]);
    chart.series.back().name = "a series of number " + std::to_string(k);
    chart.series.back().y[0] = 1 + 0.1 * k;
  }
  const std::string picture = svg(chart);
  CHECK(attribute(picture, "width") == width);
  CHECK(texts(picture, "legend").size() == 6);
  // Each row of the legend lies inside the picture, under the title of the x axis.
  const double height = attribute(picture, "height");
  std::vector<std::pair<double, double>> places;
  for (std::size_t at = picture.find("<text class=\"legend\""); at != std::string::npos;
       at = picture.find("<text class=\"legend\"", at + 1)) {
    const double x = std::stod(picture.substr(picture.find("x=\"", at) + 3));
    const double y = std::stod(picture.substr(picture.find("y=\"", at) + 3));
    CHECK(x > 0);
    CHECK(x < width);
    CHECK(y > 14 + 200 + 50);
    CHECK(y < height);
    places.emplace_back(y, x);
  }
  REQUIRE(places.size() == 6);
  CHECK(std::is_sorted(places.begin(), places.end())); // row by row, from left to right
  CHECK(std::adjacent_find(places.begin(), places.end()) == places.end());
  CHECK(places.front().first < places.back().first);
  chart.height = 0;
  CHECK_THROWS_AS((void)svg(chart), InvalidArgument);
}

namespace {

/// Corners of the first path of a class.
std::vector<std::pair<double, double>> corners(const std::string& svg, const std::string& path_class) {
  const std::size_t at = svg.find("<path class=\"" + path_class + "\"");
  REQUIRE(at != std::string::npos);
  const std::size_t from = svg.find(" d=\"", at) + 4;
  std::string path = svg.substr(from, svg.find('"', from) - from);
  std::vector<std::pair<double, double>> found;
  std::string_view rest = path;
  while (rest.size() > 1) {
    const auto x = leading_number(rest.substr(1));
    const auto y = leading_number(x.value().rest.substr(1));
    found.emplace_back(x->value, y.value().value);
    rest = y->rest;
  }
  return found;
}

} // namespace

TEST_CASE("a reversed axis puts its smallest number on top, or right, and mirrors everything") {
  Chart chart = chart_of({1, 4}, {0, 10});
  chart.series[0].mark = Mark::area;
  const auto up = corners(svg(chart), "area");
  chart.y.reversed = true;
  const auto down = corners(svg(chart), "area");
  CHECK(up[0].second > up[1].second);
  CHECK(down[0].second < down[1].second);
  CHECK(std::abs(up[0].second - down[1].second) < 0.02); // two decimals are written
  CHECK(up[0].first == down[0].first);
  chart.x.reversed = true;
  const auto left = corners(svg(chart), "area");
  CHECK(std::abs(left[0].first - down[1].first) < 0.02);
  CHECK(left[0].second == down[0].second);
}

TEST_CASE("an error bar on a reversed axis reaches the edge on the side of its end") {
  Chart chart = chart_of({1, 2}, {1, 10}, Scale::logarithmic);
  chart.series[0].y_error = {2, 1}; // down to -1, which has no logarithm
  chart.y.reversed = true;
  const std::string picture = svg(chart);
  CHECK(well_formed(picture));
  const auto end = [](const std::string& text) { // of the first bar
    const std::size_t bar = text.find("class=\"error\"");
    return leading_number(std::string_view(text).substr(text.find('V', bar) + 1)).value().value;
  };
  const double upper_edge = 14, lower_edge = upper_edge + chart.height;
  CHECK(end(picture) == upper_edge);
  chart.y.reversed = false;
  CHECK(end(svg(chart)) == lower_edge);
}

TEST_CASE("an area is a closed surface without markers or outline, also in the legend") {
  Chart chart = chart_of({1, 2, 3}, {1, 3, 2});
  chart.series[0].mark = Mark::area;
  chart.series[0].name = "range";
  const std::string picture = svg(chart);
  CHECK(well_formed(picture));
  CHECK(count(picture, "<path class=\"area\"") == 2);
  CHECK(count(picture, "<circle") == 0);
  CHECK(count(picture, "stroke-width") == 0);
  CHECK(count(picture, "Z\"") == 2);
}

TEST_CASE("charts side by side are as wide as all of them, as high as the highest") {
  Chart one = chart_of({1, 2}, {1, 2}), two = chart_of({1, 2}, {5, 6});
  one.title = "one";
  two.title = "two";
  two.height = 500;
  const Chart both[] = {one, two};
  const std::string picture = svg(both);
  CHECK(well_formed(picture));
  CHECK(texts(picture, "title") == std::vector<std::string>{"one", "two"});
  const auto attribute = [](const std::string& text, const std::string& name) {
    return leading_number(std::string_view(text).substr(text.find(" " + name + "=\"") + name.size() + 3))
        .value()
        .value;
  };
  CHECK(attribute(picture, "width") == attribute(svg(one), "width") + attribute(svg(two), "width"));
  CHECK(attribute(picture, "height") == attribute(svg(two), "height"));
  CHECK(svg(std::span(both, 1)) == svg(one));
  CHECK_THROWS_AS((void)svg(std::span<const Chart>()), InvalidArgument);
  CHECK_THROWS_AS((void)svg(both, 0), InvalidArgument);
  // one below the other
  CHECK(attribute(svg(both, 1), "height") == attribute(svg(one), "height") + attribute(svg(two), "height"));
  CHECK(attribute(svg(both, 1), "width") ==
        std::max(attribute(svg(one), "width"), attribute(svg(two), "width")));
}

TEST_CASE("coinciding lines are drawn once, as stated by the legend") {
  using Texts = std::vector<std::string>;
  Chart chart = chart_of({1, 2, 3}, {10, 30, 20}); // 380 pixels for 20
  chart.series[0].name = "G_hh";
  chart.series.push_back({.name = "G_hv", .x = {1, 2, 3}, .y = {10.07, 30, 20}});
  chart.series.push_back({.name = "E_v", .x = {1, 2, 3}, .y = {10.14, 30, 20}});
  CHECK(texts(svg(chart), "legend") == Texts{"G_hh, G_hv: one curve", "E_v"});
  chart.series[1].y[0] = 10.1; // nearer to the last one
  CHECK(texts(svg(chart), "legend") == Texts{"G_hh", "G_hv, E_v: one curve"});
  chart.y.scale = Scale::logarithmic; // 346 pixels for a factor of e
  CHECK(texts(svg(chart), "legend") == Texts{"G_hh", "G_hv, E_v: one curve"});
  chart.series[2].y[0] = 10.04;
  CHECK(texts(svg(chart), "legend") == Texts{"G_hh, E_v: one curve", "G_hv"});

  chart.series[2].tone = Tone::faint; // what looks otherwise is another thing
  CHECK(texts(svg(chart), "legend") == Texts{"G_hh", "G_hv", "E_v"});
  chart.series[2].tone = Tone::full;

  // What stands for data is drawn as often as it is there.
  const Texts each{"G_hh", "G_hv", "E_v"};
  for (Series& series : chart.series)
    series.mark = Mark::marker;
  CHECK(texts(svg(chart), "legend") == each);
  for (Series& series : chart.series) {
    series.mark = Mark::both;
    series.y_error = {1, 1, 1};
  }
  CHECK(texts(svg(chart), "legend") == each);
  // Gaps belong to the curve; curves without any point are left as they are.
  for (Series& series : chart.series)
    series = {.name = series.name, .x = {1, 2, 3}, .y = {10, nothing, 20}};
  CHECK(texts(svg(chart), "legend") == Texts{"G_hh, G_hv, E_v: one curve"});
  chart.series[1].y = {10, 15, 20};
  CHECK(texts(svg(chart), "legend") == Texts{"G_hh, E_v: one curve", "G_hv"});
  for (Series& series : chart.series)
    series.y = {nothing, nothing, nothing};
  CHECK(texts(svg(chart), "legend") == each);
}

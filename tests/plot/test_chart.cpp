// SPDX-License-Identifier: GPL-3.0-or-later
#include <granum/plot/chart.hpp>

#include <cstdio>
#include <span>

#include <granum/core/text.hpp>

#include "chart_text.hpp"
#include "plot/picture.hpp"
#include "thresholds.hpp"
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
  CHECK(texts(picture, "title") == Texts{"Moduli"});
  CHECK(texts(picture, "x-title") == Texts{"p' [kPa]"});
  CHECK(texts(picture, "legend") == Texts{"rung 2", "points"});
  CHECK(svg(chart) == picture);
  CHECK(picture.find("href") == std::string::npos);
  CHECK_FALSE(well_formed(picture.substr(0, picture.size() - 8)));
}

TEST_CASE("requested numbers have ticks, and round ones are omitted next to them") {
  Chart chart = chart_of({2.76, 34.47}, {587, 1003}, Scale::logarithmic);
  const auto labels = [&chart] { return texts(svg(chart), "x-label"); };
  CHECK(labels() == Texts{"5", "10", "20"});
  chart.x.asked = {6.89, 34.47, 2.76, 100};
  CHECK(labels() == Texts{"2.76", "5", "6.89", "10", "20", "34.47"});
  chart.x.asked = {20.1, 20.2};
  CHECK(labels() == Texts{"5", "10", "20.1"});
}

TEST_CASE("texts from outside cannot break the file") {
  Chart chart = chart_of({1, 2}, {1, 2});
  chart.title = "a < b & \"c\" > d\x01\n \xff \u03c3";
  chart.series[0].name = "</svg><script>\xed\xa0\x80";
  const std::string picture = svg(chart);
  CHECK(well_formed(picture));
  CHECK(texts(picture, "title") == Texts{"a &lt; b &amp; &quot;c&quot; &gt; d?? ? \u03c3"});
  CHECK(texts(picture, "legend") == Texts{"&lt;/svg&gt;&lt;script&gt;???"});
}

TEST_CASE("ticks are round numbers in equal steps, or powers of ten with 2 and 5 where there is room") {
  struct Row {
    double low, high;
    Scale scale;
    Texts labels;
  };
  const Row rows[] = {
      {0, 1, Scale::linear, {"0", "0.2", "0.4", "0.6", "0.8", "1"}},
      {-120, 130, Scale::linear, {"-100", "-50", "0", "50", "100"}},
      {0,
       3e7,
       Scale::linear,
       {"0", "0.5\u00b710^7", "1\u00b710^7", "1.5\u00b710^7", "2\u00b710^7", "2.5\u00b710^7", "3\u00b710^7"}},
      {1, 1e6, Scale::logarithmic, {"10^0", "10^1", "10^2", "10^3", "10^4", "10^5", "10^6"}},
      {10, 1000, Scale::logarithmic, {"10", "20", "50", "100", "200", "500", "1000"}},
      {1e-3, 1e-2, Scale::logarithmic, {"0.001", "0.002", "0.005", "0.01"}},
      {2e7, 6e8, Scale::logarithmic, {"2\u00b710^7", "5\u00b710^7", "10^8", "2\u00b710^8", "5\u00b710^8"}},
      // less than a decade: equal steps
      {100, 200, Scale::logarithmic, {"100", "120", "140", "160", "180", "200"}}};
  for (const Row& row : rows)
    CHECK(texts(svg(chart_of({row.low, row.high}, {1, 2}, row.scale)), "x-label") == row.labels);
  // far from zero, labels still distinguish the ticks
  const auto close = texts(svg(chart_of({123456, 123456.01}, {0, 1})), "x-label");
  CHECK((close.front() == "123456" && close.at(1) == "123456.002"));
}

TEST_CASE("an axis holds its values with a margin of 4 % at either end, one value with room around it") {
  struct Row {
    Scale scale;
    std::vector<double> values;
    double low, high;
  };
  for (const Row& row :
       std::vector<Row>{{Scale::linear, {3, 1, 2}, 0.92, 3.08},
                        {Scale::logarithmic, {1, 100}, -0.08, 2.08},
                        {Scale::linear, {5}, 4.5, 5.5},
                        {Scale::linear, {-5, -5}, -5.5, -4.5},
                        {Scale::linear, {0}, -1, 1},
                        {Scale::linear, {1e-291}, -1, 1},
                        {Scale::logarithmic, {10}, 0.5, 1.5},
                        {Scale::linear, {1, 1 + 1.9e-12}, 0.9, 1.1}, // half of it is rounding
                        {Scale::linear, {1, 1 + 2.1e-12}, 1, 1},
                        {Scale::linear, {}, 0, 1}}) {
    const AxisRange range(row.scale, row.values);
    CHECK(std::abs(range.low() - row.low) < 1e-11);
    CHECK(std::abs(range.high() - row.high) < 1e-11);
    const auto number = [&](double place) {
      return row.scale == Scale::linear ? place : std::pow(10, place);
    };
    CHECK(range.fraction(number(0.75 * range.low() + 0.25 * range.high())) ==
          doctest::Approx(0.25).epsilon(1e-3));
  }
  check_threshold(1e-290, [](double value) { return AxisRange::drawable(Scale::logarithmic, value); });
}

TEST_CASE("any range gets at least two labels, in order and well-formed") {
  constexpr double tiny = std::numeric_limits<double>::denorm_min();
  using Ranges = std::vector<std::pair<double, double>>;
  const Ranges linear = {
      {-largest, largest}, {0, largest},    {-1e-300, 1e-300}, {0, tiny}, {1e15, 1000000000000001},
      {1, 1.00000000001},  {5, 5},          {-7e8, -7e8},      {0, 0},    {largest, largest},
      {1e-20, 3e-20},      {0.0123, 0.0124}};
  const Ranges logarithmic = {{tiny, largest},  {std::numeric_limits<double>::min(), 1},
                              {1, 1},           {1, 6.3},
                              {1, 6.4},         {3, 30},
                              {9.9, 160},       {1, 1e9},
                              {1e-5, 3e-5},     {tiny, tiny},
                              {1e-290, 1e-290}, {largest, largest},
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
  CHECK(texts(picture, "x-label") == Texts{"0", "200", "400", "600", "800", "1000"});
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
    const double x = all(picture, "<rect class=\"frame\"", "x").at(0) + 520 / 2.0,
                 y = all(picture, "<rect class=\"frame\"", "y").at(0) + 380 / 2.0;
    CHECK(all(picture, "<circle", "cx").at(0) == relative(x, 1e-4)); // in the middle
    CHECK(all(picture, "<circle", "cy").at(0) == relative(y, 1e-4));
  }
}

TEST_CASE("error bars are drawn if there is an error, and lie within the axis") {
  Chart chart = chart_of({1, 2, 3, 4}, {10, 10, 10, 10});
  chart.series[0].y_error = {10, 0, nothing, 0.5};
  const std::string picture = svg(chart);
  CHECK(well_formed(picture));
  CHECK(count(picture, "class=\"error\"") == 2);
  CHECK(texts(picture, "y-label") == Texts{"0", "5", "10", "15", "20"});
  const std::vector<double> bar = path_numbers(picture, "class=\"error\""); // cap, line and cap
  REQUIRE(bar.size() == 9);
  CHECK((bar[0] + bar[2] == relative(2 * bar[3], 1e-4) && bar[6] + bar[8] == relative(2 * bar[3], 1e-4)));
  CHECK((bar[1] == bar[4] && bar[5] == bar[7] && bar[5] - bar[4] == relative(380 / 1.08, 1e-4)));

  // an end that a logarithmic axis cannot show, here of -1, is on the edge at its side
  chart = chart_of({1, 10}, {1, 10}, Scale::logarithmic);
  chart.series[0].y_error = {2, 0};
  for (const bool reversed : {false, true}) {
    chart.y.reversed = reversed;
    const std::string log_picture = svg(chart);
    CHECK(well_formed(log_picture));
    CHECK(count(log_picture, "class=\"error\"") == 1);
    CHECK(log_picture.find(reversed ? "V14.00M" : "V394.00M") != std::string::npos); // 14 + height
    CHECK(log_picture.find("nan") == std::string::npos);
  }
}

TEST_CASE("a chart that contradicts itself is refused") {
  void (*const wrong[])(Chart&) = {
      [](Chart& chart) { chart.series[0].y = {1}; }, [](Chart& chart) { chart.series[0].y_error = {1}; },
      [](Chart& chart) { chart.y.unit = 0; }, [](Chart& chart) { chart.height = 0; }};
  for (const auto& change : wrong) {
    Chart chart = chart_of({1, 2}, {1, 2});
    change(chart);
    CHECK_THROWS_AS((void)svg(chart), InvalidArgument);
  }
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
  // Each row of the legend is inside the picture, under the title of the x axis.
  const auto x = all(picture, "<text class=\"legend\"", "x"), y = all(picture, "<text class=\"legend\"", "y");
  std::vector<std::pair<double, double>> places;
  for (std::size_t k = 0; k < 6; ++k) {
    CHECK((0 < x.at(k) && x[k] < width));
    CHECK((14 + 200 + 50 < y.at(k) && y[k] < attribute(picture, "height")));
    places.emplace_back(y[k], x[k]);
  }
  CHECK(std::is_sorted(places.begin(), places.end())); // row by row, from left to right
  CHECK(std::adjacent_find(places.begin(), places.end()) == places.end());
  CHECK(y.front() < y.back());
}

TEST_CASE("a reversed axis puts its smallest number on top, or right, and mirrors everything") {
  Chart chart = chart_of({1, 4}, {0, 10});
  const auto places = [&] {
    const std::string picture = svg(chart);
    return std::pair(all(picture, "<circle", "cx"), all(picture, "<circle", "cy"));
  };
  const auto [x, up] = places();
  chart.y.reversed = true;
  const auto [same_x, down] = places();
  chart.x.reversed = true;
  const auto [left, same_y] = places();
  REQUIRE((x.size() == 2 && down.size() == 2 && left.size() == 2));
  CHECK(up[0] > up[1]);
  CHECK(std::abs(up[0] - down[1]) < 0.02); // two decimals are written
  CHECK(std::abs(up[1] - down[0]) < 0.02);
  CHECK(std::abs(x[0] - left[1]) < 0.02);
  CHECK((same_x == x && same_y == down));
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
  CHECK(texts(picture, "title") == Texts{"one", "two"});
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
  for (const bool across : {false, true}) // from 1.5 pixels on they are two
    check_threshold(1.5, [across](double pixels) {
      Chart two = chart_of({0, 1}, {0, 1});
      two.series[0].name = "a";
      two.series.push_back(two.series[0]);
      (across ? two.series[1].x : two.series[1].y)[1] -= pixels / (across ? two.width : two.height);
      return texts(svg(two), "legend").size();
    });
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

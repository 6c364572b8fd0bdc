// SPDX-License-Identifier: GPL-3.0-or-later
#include "picture.hpp"

#include <algorithm>

namespace granum::plot {

DrawnSeries::DrawnSeries(const Chart& chart, const Series& series) {
  bool gap = false;
  for (std::size_t k = 0; k < series.x.size(); ++k) {
    const Spot p{series.x[k] / chart.x.unit, series.y[k] / chart.y.unit};
    if (AxisRange::drawable(chart.x.scale, p.x) && AxisRange::drawable(chart.y.scale, p.y)) {
      points.push_back(p);
      joined.push_back(!gap && !joined.empty());
      const double error = series.y_error.empty() ? 0 : std::abs(series.y_error[k] / chart.y.unit);
      errors.push_back(std::isfinite(error) ? error : 0);
      gap = false;
    } else {
      gap = true;
    }
  }
}

std::string svg_grid_line(const Spot& from, const Spot& to) {
  return svg_element("line", {{"class", "grid"},
                              {"x1", svg_number(from.x)},
                              {"y1", svg_number(from.y)},
                              {"x2", svg_number(to.x)},
                              {"y2", svg_number(to.y)},
                              {"stroke", "#dfe3e8"}});
}

std::string Canvas::drawn() const {
  std::string out;
  double y = 30;
  for (const std::string& line : title) {
    out += svg_text("title",
                    {{"x", svg_number(width / 2)},
                     {"y", svg_number(y)},
                     {"text-anchor", "middle"},
                     {"font-size", svg_number(title_size)}},
                    svg_escaped(line));
    y += title_line;
  }
  return out + content;
}

std::string Canvas::text(bool of_its_own) const {
  const std::string w = svg_number(width), h = svg_number(height);
  SvgAttributes root;
  if (of_its_own)
    root = {{"xmlns", "http://www.w3.org/2000/svg"}};
  root.insert(root.end(), {{"class", "chart"},
                           {"role", "img"},
                           {"aria-label", finding},
                           {"width", w},
                           {"height", h},
                           {"viewBox", "0 0 " + w + " " + h},
                           {"font-family", "Helvetica, Arial, sans-serif"},
                           {"font-size", svg_number(font_size)},
                           {"color", "#1c1f23"},
                           {"fill", "currentColor"}});
  std::string tag = svg_element("svg", root);
  tag.replace(tag.rfind("/>"), 2, ">");
  return (of_its_own ? "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n" : "") + tag +
         (of_its_own ? "<style>" + dark_rules() + "</style>\n" : "") +
         svg_element("rect", {{"class", "paper"}, {"width", "100%"}, {"height", "100%"}, {"fill", "white"}}) +
         drawn() + "</svg>\n";
}

std::string svg(const SvgPicture& picture) {
  return Canvas{.width = picture.width,
                .height = picture.height,
                .content = picture.content,
                .finding = picture.finding}
      .text(true);
}

std::string svg_in_page(const SvgPicture& picture) {
  return Canvas{.width = picture.width,
                .height = picture.height,
                .content = picture.content,
                .finding = picture.finding}
      .text(false);
}

} // namespace granum::plot

// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <string>
#include <vector>

#include <fmt/format.h>
#include <granum/core/error.hpp>
#include <granum/core/text.hpp>
#include <granum/dem/neighbours.hpp>
#include <granum/plot/svg_text.hpp>

#include "figures.hpp"

namespace granum::cli {

namespace {

constexpr double size = 520;  // of the picture's longer side
constexpr double margin = 14; // around the drawing
constexpr int shades = 6;     // from the nearest grains to the farthest
constexpr double hidden = 8;  // radii behind the seen faces
constexpr double azimuth = 30 * std::numbers::pi / 180;
constexpr double elevation = 22 * std::numbers::pi / 180;

/// Parallel projection: x to the right, y up, depth towards the viewer.
struct Projected {
  double x = 0;
  double y = 0;
  double depth = 0;
};

Projected seen(const Vec3& p) {
  const double along = p.x * std::cos(azimuth) + p.y * std::sin(azimuth); // towards the eye, level
  const double across = p.y * std::cos(azimuth) - p.x * std::sin(azimuth);
  return {across, p.z * std::cos(elevation) - along * std::sin(elevation),
          along * std::cos(elevation) + p.z * std::sin(elevation)};
}

/// Frame and scale of the drawing.
struct View {
  double left = 0, right = 0, low = 0, high = 0; // the origin is a corner
  double scale = 1;

  View(const Mat3& cell, double radius) {
    for (int corner = 0; corner < 8; ++corner) {
      const Projected s =
          seen(cell * Vec3{(corner & 1) * 1.0, ((corner >> 1) & 1) * 1.0, ((corner >> 2) & 1) * 1.0});
      left = std::min(left, s.x - radius);
      right = std::max(right, s.x + radius);
      low = std::min(low, s.y - radius);
      high = std::max(high, s.y + radius);
    }
    scale = (size - 2 * margin) / std::max(right - left, high - low);
  }
  [[nodiscard]] std::string x(const Projected& s) const {
    return plot::svg_number(margin + (s.x - left) * scale);
  }
  [[nodiscard]] std::string y(const Projected& s) const {
    return plot::svg_number(margin + (high - s.y) * scale);
  }
};

std::string shade_name(int shade) { return "granum-grain-" + std::to_string(shade); }

/// Fillings that are bright towards the upper left; far grains are darker.
std::string gradients() {
  std::string stops;
  for (int shade = 0; shade < shades; ++shade) {
    const double light = 1 - 0.55 * shade / (shades - 1);
    const auto colour = [light](double red, double green, double blue) {
      const auto part = [light](double value) { return std::to_string(std::lround(light * value)); };
      return "rgb(" + part(red) + "," + part(green) + "," + part(blue) + ")";
    };
    stops += "<radialGradient id=\"" + shade_name(shade) + "\" cx=\"0.36\" cy=\"0.32\" r=\"0.72\">\n" +
             plot::svg_element("stop", {{"offset", "0"}, {"stop-color", colour(255, 250, 238)}}) +
             plot::svg_element("stop", {{"offset", "0.45"}, {"stop-color", colour(226, 196, 148)}}) +
             plot::svg_element("stop", {{"offset", "1"}, {"stop-color", colour(112, 84, 52)}}) +
             "</radialGradient>\n";
  }
  return "<defs>\n" + stops + "</defs>\n";
}

struct Drawn {
  Projected centre;
  double radius = 0;
};

/// Farthest first.
std::vector<Drawn> drawn_grains(const dem::Specimen& state) {
  const Vec3 corner = state.cell * Vec3{1, 1, 1};
  std::vector<Vec3> centres = state.position;
  if (!state.walls)
    dem::wrap(state.cell, centres);
  std::vector<Drawn> out;
  for (std::size_t g = 0; g < centres.size(); ++g) {
    const Vec3 behind = corner - centres[g]; // the faces at x, y and z of the far corner are seen
    if (std::min({behind.x, behind.y, behind.z}) < hidden * state.radius)
      out.push_back({seen(centres[g]), state.radius_of(g)});
  }
  std::stable_sort(out.begin(), out.end(),
                   [](const Drawn& a, const Drawn& b) { return a.centre.depth < b.centre.depth; });
  return out;
}

/// "1.2 mm", or "0.8 to 2.1 mm": diameters.
std::string diameters(const dem::Specimen& state) {
  const double least = smallest_size(state), most = largest_size(state);
  const auto text = [&](double times) { return short_text(2e3 * state.radius * times, 3); };
  return (least == most ? "" : text(least) + " to ") + text(most) + " mm";
}

/// The three edges that meet in the corner that is farthest from the eye, or the other nine.
std::string edges(const View& view, const Mat3& cell, bool far) {
  std::string out;
  for (int axis = 0; axis < 3; ++axis)
    for (int other = 0; other < 4; ++other) {
      Vec3 from;
      from[(axis + 1) % 3] = other & 1;
      from[(axis + 2) % 3] = other >> 1;
      Vec3 to = from;
      to[axis] = 1;
      if ((other == 0) != far)
        continue;
      const Projected a = seen(cell * from), b = seen(cell * to);
      out += plot::svg_element("line",
                               {{"x1", view.x(a)}, {"y1", view.y(a)}, {"x2", view.x(b)}, {"y2", view.y(b)}});
    }
  return plot::svg_group({{"stroke", "currentColor"},
                          {"stroke-opacity", far ? "0.5" : "0.9"},
                          {"stroke-width", far ? "0.8" : "1"}},
                         out);
}

} // namespace

plot::SvgPicture assembly_drawing(const dem::Specimen& state) {
  if (state.position.empty())
    throw InvalidArgument("no picture: the specimen has no grains");
  const View view(state.cell, state.radius * largest_size(state));
  std::string svg = gradients() + edges(view, state.cell, true);
  const std::vector<Drawn> grains = drawn_grains(state);
  if (grains.empty())
    throw InvalidArgument("no picture: the specimen has no grain near its visible faces");
  const double far = grains.front().centre.depth, near = grains.back().centre.depth;
  std::string painted, same_shade;
  int shade = shades - 1;
  const auto finish_shade = [&] {
    painted += plot::svg_group({{"fill", "url(#" + shade_name(shade) + ")"}}, same_shade);
    same_shade.clear();
  };
  for (const auto& [centre, radius] : grains) {
    const double behind = near > far ? (near - centre.depth) / (near - far) : 0;
    const int own = std::min(shades - 1, static_cast<int>(behind * shades));
    if (own != shade)
      finish_shade();
    shade = own;
    same_shade += plot::svg_element(
        "circle",
        {{"cx", view.x(centre)}, {"cy", view.y(centre)}, {"r", plot::svg_number(radius * view.scale)}});
  }
  finish_shade();
  svg += plot::svg_group({{"stroke", "#4a3a26"}, {"stroke-width", "0.4"}}, painted) +
         edges(view, state.cell, false);
  return {.width = 2 * margin + (view.right - view.left) * view.scale,
          .height = 2 * margin + (view.high - view.low) * view.scale,
          .finding = "Grains of a specimen in their cell, seen from above and aside.",
          .content = svg};
}

std::optional<AssemblyPicture> assembly_picture(const Experiment& experiment) {
  const ExperimentSpecimen* shown = nullptr;
  bool wanted = false;
  for (const ExperimentSpecimen& specimen : experiment.specimens)
    if (!wanted && !specimen.end_of_iso.position.empty()) {
      wanted = specimen.contact == contact::Shape::sphere && specimen.density == triaxial::Density::dense;
      if (shown == nullptr || wanted)
        shown = &specimen;
    }
  if (shown == nullptr)
    return std::nullopt;
  const dem::Specimen& state = shown->end_of_iso;
  const Kind kind{.contact = shown->contact, .density = shown->density, .specimen = shown};
  const auto edge_length = [&state](int axis) { return short_text(1e3 * state.cell(axis, axis), 3); };
  AssemblyPicture out{.stem = "fig03_" + kind.key(), .drawing = assembly_drawing(state)};
  out.drawing.finding = fmt::format(
      "The specimen {} at the end of isotropic compression: {} grains of {} in {} of {} x {} x {} mm{}",
      kind.title(), state.grain_count(), diameters(state),
      state.walls ? "a box of six rigid walls" : "a periodic cell", edge_length(0), edge_length(1),
      edge_length(2), state.walls ? "." : "; grains that stick out at one face come in at the opposite one.");
  return out;
}

} // namespace granum::cli

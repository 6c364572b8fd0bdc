// SPDX-License-Identifier: GPL-3.0-or-later
#include "studies/report/compression.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <utility>

#include <granum/core/text.hpp>
#include <granum/effective/relaxation.hpp>

namespace granum::studies {

namespace {

using triaxial::Density;

/// As a fraction where it is one: "1/3".
std::string contact_exponent_text(const Compression& c) {
  const double b = c.contact_exponent, parts = std::round(1 / b);
  if (b > 0 && std::abs(b * parts - 1) < 1e-12)
    return "1/" + short_text(parts);
  return short_text(b, 3);
}

std::string with_error(const Measured& m) {
  return detail::formatted("%.3f \u00b1 %.3f", m.value, m.standard_error);
}

/// "0.543 ± 0.005 for cones (1/2), 0.364 ± 0.005 for spheres (1/3)".
std::string exponents_text(const std::vector<Compression>& all, Density density, bool with_law) {
  std::string text;
  for (const Compression& c : all)
    if (c.density == density && c.exponent)
      text += (text.empty() ? "" : ", ") + with_error(*c.exponent) + " for " + plural(c.contact) +
              (with_law ? " (" + contact_exponent_text(c) + ")" : "");
  return text;
}

struct Range {
  double first = 0;
  double last = 0;
};

/// Means over the specimens of a density at the start and at the end.
std::optional<Range> mean_range(const std::vector<Compression>& all, Density density,
                                const std::function<std::optional<double>(const RouteState&)>& of) {
  Range sum;
  int count = 0;
  for (const Compression& c : all) {
    if (c.density != density || c.states.size() < 2)
      continue;
    const auto first = of(c.states.front()), last = of(c.states.back());
    if (!first || !last)
      continue;
    sum.first += *first;
    sum.last += *last;
    ++count;
  }
  if (count == 0)
    return std::nullopt;
  return Range{sum.first / count, sum.last / count};
}

std::optional<double> z_star(const RouteState& s) { return s.mechanical_coordination_number; }
std::optional<double> softening(const RouteState& s) { return s.softening; }

std::string from_to(const Range& range) {
  return detail::formatted("from %.2f to %.2f", range.first, range.last);
}

/// "dense packings from 6.03 to 6.25, loose ones from 4.26 to 5.59", of the densities that were run.
std::string from_to(const std::vector<Compression>& all,
                    const std::function<std::optional<double>(const RouteState&)>& of) {
  const auto dense = mean_range(all, Density::dense, of), loose = mean_range(all, Density::loose, of);
  std::string text;
  if (dense)
    text = "dense packings " + from_to(*dense);
  if (loose)
    text += (dense ? ", loose ones " : "loose packings ") + from_to(*loose);
  return text;
}

/// Largest distance of s from the exponent of a contact, over the specimens of a density.
double largest_distance(const std::vector<Compression>& all, Density density) {
  double largest = 0;
  for (const Compression& c : all)
    if (c.density == density && c.exponent)
      largest = std::max(largest, std::abs(c.exponent->value - c.contact_exponent));
  return largest;
}

/// Whether s of every specimen of a density is larger than the exponent of its contacts, by two standard
/// errors.
bool exceeds_contact_law(const std::vector<Compression>& all, Density density) {
  return std::all_of(all.begin(), all.end(), [&](const Compression& c) {
    return c.density != density || !c.exponent ||
           c.exponent->value - c.contact_exponent > 2 * c.exponent->standard_error;
  });
}

/// Largest relative difference of a route from the network, or nothing where they have no state in common.
std::optional<double> largest_difference(const std::vector<Compression>& all, std::size_t modulus,
                                         ShearModuli RouteState::*route) {
  std::optional<double> largest;
  for (const Compression& c : all)
    for (const RouteState& state : c.states)
      if (const auto& network = state.network[modulus], &other = (state.*route)[modulus]; network && other)
        largest = std::max(largest.value_or(0), std::abs(*other / *network - 1));
  return largest;
}

const char* density_name(const Compression& c) { return c.density == Density::dense ? "dense" : "loose"; }

/// A line or markers of one specimen: the shape has the colour, loose packings are hollow or dashed.
plot::Series series_of(const Compression& c, plot::Mark mark,
                       const std::function<std::optional<double>(const RouteState&)>& x,
                       const std::function<std::optional<double>(const RouteState&)>& y) {
  const bool loose = c.density == Density::loose;
  plot::Series out{.mark = mark,
                   .style = mark == plot::Mark::line && loose ? 1 : 0,
                   .tone = mark != plot::Mark::line && loose ? plot::Tone::hollow : plot::Tone::full,
                   .colour = colour_of(c.contact)};
  for (const RouteState& state : c.states) {
    const auto across = x(state), up = y(state);
    if (across && up)
      out.add(*across, *up);
  }
  return out;
}

std::optional<double> pressure(const RouteState& s) { return s.pressure; }

std::string key_of(const Compression& c) {
  std::string text = std::string(name(c.contact)) + "_" + density_name(c);
  std::replace(text.begin(), text.end(), '-', '_');
  return text;
}

Quantity pressures() {
  return {"p_Pa", {.title = "p' [kPa]", .scale = plot::Scale::logarithmic, .unit = 1e3}};
}

/// Below the last part of a curve, where the network has s.
std::optional<plot::SlopeTriangle> triangle(const Compression& c, std::size_t modulus) {
  if (!c.exponent || c.states.size() < 3)
    return std::nullopt;
  const RouteState& last = c.states.back();
  if (!last.network[modulus])
    return std::nullopt;
  const double x0 = last.pressure / 2, s = c.exponent->value;
  const double y1 = *last.network[modulus];
  return plot::SlopeTriangle{.x0 = x0,
                             .x1 = last.pressure,
                             .y0 = y1 * std::pow(x0 / last.pressure, s),
                             .slope = s,
                             .text = detail::formatted("s = %.2f", s),
                             .colour = colour_of(c.contact)};
}

std::string modulus_finding(const std::vector<Compression>& all, std::size_t modulus) {
  std::string exponents;
  for (const Compression& c : all)
    if (c.exponent)
      exponents += (exponents.empty() ? "" : ", ") + detail::formatted("%.2f", c.exponent->value) + " for " +
                   density_name(c) + " " + plural(c.contact);
  std::string text = std::string(shear_modulus_names[modulus]) + " against p' on logarithmic axes.";
  if (!exponents.empty())
    text += " s, the slope: " + exponents + ".";
  constexpr std::pair<const char*, ShearModuli RouteState::*> routes[] = {{"Rung 3", &RouteState::relaxed},
                                                                          {"The probe", &RouteState::probe}};
  for (const auto& [route, moduli] : routes)
    if (const auto largest = largest_difference(all, modulus, moduli))
      text += std::string(" ") + route + " is within " + detail::formatted("%.2g", 100 * *largest) +
              " % of the network.";
  return text;
}

/// The shapes that were run, each once.
std::vector<contact::Shape> shapes_of(const std::vector<Compression>& all) {
  std::vector<contact::Shape> out;
  for (const Compression& c : all)
    if (std::find(out.begin(), out.end(), c.contact) == out.end())
      out.push_back(c.contact);
  return out;
}

Panel contact_law_panel(const Scene& scene, const std::vector<Compression>& all) {
  Panel out = panel(
      "contact_law", "One contact", {"f_N", {.title = "normal force [N]", .scale = plot::Scale::logarithmic}},
      {"k_n_N_per_m", {.title = "stiffness k_n [N/mm]", .scale = plot::Scale::logarithmic, .unit = 1e3}});
  constexpr double force = 0.01; // N, near the mean of the default scene at 10 kPa, and a decade up
  out.chart.finding = "Stiffness of a contact against its force; the numbers are slopes.";
  for (const contact::Shape shape : shapes_of(all)) {
    const contact::NormalLaw contact_law = law(scene, shape);
    plot::Series line{
        .name = std::string(name(shape)), .mark = plot::Mark::line, .style = 0, .colour = colour_of(shape)};
    for (int k = 0; k <= 20; ++k) {
      const double f = force * std::pow(10, k / 20.0);
      line.add(f, contact_law.stiffness_at_force(f));
    }
    const double b = contact_law.exponent_at_force(line.x[15]);
    out.chart.triangles.push_back({.x0 = line.x[10],
                                   .x1 = line.x[20],
                                   .y0 = line.y[10],
                                   .slope = b,
                                   .text = detail::formatted("%.2f", b),
                                   .colour = colour_of(shape)});
    add(out, std::move(line), std::string(name(shape)));
  }
  return out;
}

void list_shapes_and_densities(Panel& out, const std::vector<Compression>& all) {
  std::vector<contact::Shape> listed;
  for (std::size_t k = 0; k < out.chart.series.size(); ++k) {
    const auto c = std::find_if(all.begin(), all.end(),
                                [&](const Compression& one) { return key_of(one) == out.keys[k]; });
    if (c == all.end())
      continue;
    out.chart.series[k].kind = density_name(*c);
    if (std::find(listed.begin(), listed.end(), c->contact) == listed.end())
      out.chart.series[k].name = name(c->contact);
    listed.push_back(c->contact);
  }
}

Panel contacts_panel(const std::vector<Compression>& all) {
  Panel out = panel("contacts", "Contacts of a grain", pressures(), {"z_star", {.title = "z*"}});
  for (const Compression& c : all) {
    plot::Series series = series_of(c, plot::Mark::both, pressure, z_star);
    add(out, std::move(series), key_of(c));
  }
  list_shapes_and_densities(out, all);
  out.chart.finding = "Contacts of a grain, z*, against p': " + from_to(all, z_star) + ".";
  return out;
}

/// Largest distance between the closed form's curves of two shapes.
double largest_gap(const std::vector<plot::Series>& curves) {
  double gap = 0;
  for (const plot::Series& curve : curves)
    for (std::size_t k = 0; k < curve.y.size(); ++k)
      gap = std::max(gap, std::abs(curve.y[k] - curves.front().y[k]));
  return gap;
}

/// Curves that lie within a hundredth of each other are drawn as one.
void add_closed_forms(Panel& out, const Scene& scene, const std::vector<Compression>& all) {
  constexpr double drawn_as_one = 0.01;
  std::vector<double> z;
  for (const plot::Series& series : out.chart.series)
    z.insert(z.end(), series.x.begin(), series.x.end());
  if (z.empty())
    return;
  const auto [low, high] = std::minmax_element(z.begin(), z.end());
  std::vector<plot::Series> curves;
  for (const contact::Shape shape : shapes_of(all))
    curves.push_back(relaxation_curve(scene, shape, *low, *high, 60));
  if (largest_gap(curves) < drawn_as_one) {
    curves.resize(1);
    curves.front().name = "rung 3, of all shapes";
    curves.front().style = 0;
    curves.front().tone = plot::Tone::grey;
    add(out, std::move(curves.front()), "closed form");
    return;
  }
  for (std::size_t k = 0; k < curves.size(); ++k) {
    curves[k].style = 0;
    curves[k].colour = colour_of(shapes_of(all)[k]);
    curves[k].kind = "rung 3";
    add(out, std::move(curves[k]), "closed form " + std::string(name(shapes_of(all)[k])));
  }
}

Panel softening_panel(const Scene& scene, const std::vector<Compression>& all) {
  Panel out = panel("relaxation", "G relative to uniform strain", {"z_star", {.title = "z*"}},
                    {"G_over_uniform_strain", {.title = "G of network / uniform strain"}});
  for (const Compression& c : all)
    add(out, series_of(c, plot::Mark::marker, z_star, softening), key_of(c));
  list_shapes_and_densities(out, all);
  add_closed_forms(out, scene, all);
  out.chart.finding =
      "G of the network over G under uniform strain, against z*: " + from_to(all, softening) + ".";
  return out;
}

plot::PageFigure with_files(plot::PageFigure figure, const std::vector<Panel>& panels,
                            const std::string& folder) {
  for (const Panel& panel : panels)
    figure.files.push_back(file_of(panel, folder));
  return figure;
}

std::string why_figure(const Panel& panel, const std::string& caption, const std::string& folder) {
  return plot::html_figure(with_files(
      {.caption = caption, .pictures = {{.svg = plot::svg_in_page(panel.chart)}}}, {panel}, folder));
}

} // namespace

double shear_relaxation(const Scene& scene, contact::Shape shape, double mechanical_coordination_number) {
  return effective::relaxation(mechanical_coordination_number, tangential_ratio(scene),
                               contact_exponent(scene, shape), effective::stiffening_of(law(scene, shape)))
      .shear.value;
}

plot::Series relaxation_curve(const Scene& scene, contact::Shape shape, double low, double high, int steps) {
  plot::Series out{.mark = plot::Mark::line};
  for (int k = 0; k <= steps; ++k) {
    const double z = low + (high - low) * k / steps;
    out.add(z, shear_relaxation(scene, shape, z));
  }
  return out;
}

std::string plural(contact::Shape shape) { return contact::row_of(shape).plural; }

plot::Colour colour_of(contact::Shape shape) {
  using contact::Shape;
  constexpr std::pair<Shape, plot::Colour> own[] = {{Shape::sphere, plot::Colour::sphere},
                                                    {Shape::cone, plot::Colour::cone},
                                                    {Shape::flat, plot::Colour::flat},
                                                    {Shape::rough, plot::Colour::rough}};
  for (const auto& [known, colour] : own)
    if (shape == known)
      return colour;
  return plot::Colour::power_law;
}

std::vector<std::string> compression_answer(const std::vector<Compression>& all) {
  std::vector<std::string> answer{
      "The shear modulus of a packing grows with the pressure on it as G ~ p\u02e2, "
      "and s is the slope of its line in the picture."};
  if (const std::string dense = exponents_text(all, Density::dense, true); !dense.empty()) {
    constexpr double nearly = 0.06, hardly = 0.3; // of s, and of z*
    std::string sentence = "In dense packings s is ";
    sentence +=
        largest_distance(all, Density::dense) < nearly
            ? "nearly that of a single contact, which is 1/(1+\u03b1) (in brackets) if the surface near the "
              "contact has the profile r^\u03b1: " +
                  dense
            : dense + " (in brackets: s of a single contact of this shape, 1/(1+\u03b1) for the profile "
                      "r^\u03b1)";
    if (const auto contacts = mean_range(all, Density::dense, z_star))
      sentence +=
          (std::abs(contacts->last - contacts->first) < hardly ? "; pressure hardly adds contacts, "
                                                               : "; pressure changes the contacts, ") +
          from_to(*contacts) + " per grain that carries load";
    answer.push_back(sentence + ".");
  }
  if (const std::string loose = exponents_text(all, Density::loose, false); !loose.empty()) {
    const auto contacts = mean_range(all, Density::loose, z_star);
    const auto share = mean_range(all, Density::loose, softening);
    std::string sentence = "In loose packings s is " + loose;
    if (contacts && contacts->last > contacts->first && exceeds_contact_law(all, Density::loose))
      sentence += ", larger than s of a single contact because pressure also adds contacts, " +
                  from_to(*contacts) + " per grain that carries load";
    else if (contacts)
      sentence += "; a grain that carries load has " + from_to(*contacts) + " contacts";
    if (share)
      sentence += "; G changes " + from_to(*share) +
                  " of its value under uniform strain (all grains move with the mean strain)";
    answer.push_back(sentence + ".");
  }
  return answer;
}

Panel modulus_panel(const std::vector<Compression>& all, std::size_t modulus) {
  const std::string symbol = shear_modulus_names[modulus];
  Panel out =
      panel("log_G_log_p_" + symbol, "", pressures(),
            {symbol + "_Pa", {.title = symbol + " [MPa]", .scale = plot::Scale::logarithmic, .unit = 1e6}});
  out.chart.width = 360;
  out.chart.height = 320;
  const auto of = [modulus](ShearModuli RouteState::*route) {
    return [=](const RouteState& s) { return (s.*route)[modulus]; };
  };
  for (const Compression& c : all) {
    plot::Series line = series_of(c, plot::Mark::line, pressure, of(&RouteState::relaxed));
    line.kind = std::string("rung 3, ") + density_name(c);
    add(out, std::move(line), key_of(c) + " closed form");
  }
  for (const Compression& c : all) {
    plot::Series markers = series_of(c, plot::Mark::marker, pressure, of(&RouteState::network));
    markers.kind = std::string("network, ") + density_name(c);
    add(out, std::move(markers), key_of(c) + " network");
  }
  for (const Compression& c : all) {
    plot::Series probes = series_of(c, plot::Mark::marker, pressure, of(&RouteState::probe));
    probes.style = 2;
    probes.kind = std::string("probe, ") + density_name(c);
    add(out, std::move(probes), key_of(c) + " probe");
  }
  for (const contact::Shape shape : shapes_of(all))
    for (plot::Series& series : out.chart.series)
      if (series.colour == colour_of(shape) && series.mark == plot::Mark::line) {
        series.name = name(shape);
        break;
      }
  for (const Compression& c : all)
    if (const auto one = triangle(c, modulus))
      out.chart.triangles.push_back(*one);
  out.chart.finding = modulus_finding(all, modulus);
  return out;
}

plot::PageFile file_of(const Panel& panel, const std::string& figures) {
  return {panel.stem + ".csv", figures + "/" + panel.stem + ".csv"};
}

CompressionStory compression_story(const Scene& scene, const std::vector<Compression>& all,
                                   const std::string& figures) {
  CompressionStory story;
  plot::PageFigure first{
      .caption =
          "Isotropic compression, first specimen of each kind. Lines: rung 3, the closed form of uniform "
          "strain times a relaxation factor, from the counted contacts; circles: linear response of the "
          "contact network; diamonds: cyclic shear by DEM. Triangles have the slope s of the network."};
  for (std::size_t k = 0; k < shear_modulus_names.size(); ++k) {
    Panel one = modulus_panel(all, k);
    if (one.chart.series.empty())
      continue;
    first.pictures.push_back({.svg = plot::svg_in_page(one.chart), .choice = shear_modulus_names[k]});
    story.panels.push_back(std::move(one));
  }
  story.first_screen = plot::html_first_screen(compression_question, compression_answer(all),
                                               with_files(std::move(first), story.panels, figures));
  const Panel law = contact_law_panel(scene, all), contacts = contacts_panel(all),
              relaxation = softening_panel(scene, all);
  if (contacts.chart.series.empty())
    return story;
  story.why = plot::html_section(
      "why", "Why",
      plot::html_element(
          "div",
          why_figure(law,
                     "1. The stiffness of a contact is a power of its force that depends on its shape. "
                     "With a constant set of contacts, G of the packing would be the same power of p.",
                     figures) +
              why_figure(
                  contacts,
                  "2. Contacts per grain that carries load, z*. Each new contact makes the packing stiffer.",
                  figures) +
              why_figure(relaxation,
                         "3. Grains do not move exactly with the mean strain; the deviation is larger with "
                         "fewer contacts. New contacts reduce it and make a loose packing stiffer, in "
                         "addition to cause 1.",
                         figures),
          "trio"));
  story.panels.insert(story.panels.end(), {law, contacts, relaxation});
  return story;
}

} // namespace granum::studies

// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/verify/compression.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <utility>

#include <fmt/format.h>
#include <granum/core/text.hpp>
#include <granum/effective/relaxation.hpp>

namespace granum::cli {

namespace {

using studies::Panel;
using studies::Quantity;
using triaxial::Density;
using Compressions = std::vector<Compression>;
using NumberOf = std::function<std::optional<double>(const RouteState&)>;

std::optional<double> pressure(const RouteState& s) { return s.pressure; }
std::optional<double> z_star(const RouteState& s) { return s.mechanical_coordination_number; }
std::optional<double> softening(const RouteState& s) { return s.softening; }

const std::string& plural(const Compression& c) { return contact::row_of(c.contact).plural; }
const char* density_name(const Compression& c) { return c.density == Density::dense ? "dense" : "loose"; }

std::string key_of(const Compression& c) {
  std::string text = fmt::format("{}_{}", name(c.contact), density_name(c));
  std::replace(text.begin(), text.end(), '-', '_');
  return text;
}

// ---- the answer in words

/// As a fraction where it is one: "1/3".
std::string contact_exponent_text(const Compression& c) {
  const double b = c.contact_exponent, parts = std::round(1 / b);
  return b > 0 && std::abs(b * parts - 1) < 1e-12 ? "1/" + short_text(parts) : short_text(b, 3);
}

/// "0.543 ± 0.005 for cones (1/2), 0.364 ± 0.005 for spheres (1/3)".
std::string exponents_text(const Compressions& all, Density density, bool with_law) {
  std::string text;
  for (const Compression& c : all)
    if (c.density == density && c.exponent)
      text += fmt::format("{}{:.3f} \u00b1 {:.3f} for {}{}", text.empty() ? "" : ", ", c.exponent->value,
                          c.exponent->standard_error, plural(c),
                          with_law ? " (" + contact_exponent_text(c) + ")" : "");
  return text;
}

/// Means over the specimens of a density, at the start and at the end.
std::optional<std::pair<double, double>> mean_ends(const Compressions& all, Density density,
                                                   const NumberOf& of) {
  double first = 0, last = 0;
  int count = 0;
  for (const Compression& c : all)
    if (c.density == density && c.states.size() >= 2)
      if (const auto a = of(c.states.front()), b = of(c.states.back()); a && b) {
        first += *a;
        last += *b;
        ++count;
      }
  return count > 0 ? std::optional(std::pair(first / count, last / count)) : std::nullopt;
}

std::string from_to(const std::pair<double, double>& ends) {
  return fmt::format("from {:.2f} to {:.2f}", ends.first, ends.second);
}

/// "dense packings from 6.03 to 6.25, loose ones from 4.26 to 5.59", of the densities that were run.
std::string from_to(const Compressions& all, const NumberOf& of) {
  const auto dense = mean_ends(all, Density::dense, of), loose = mean_ends(all, Density::loose, of);
  return (dense ? "dense packings " + from_to(*dense) : "") +
         (loose ? (dense ? ", loose ones " : "loose packings ") + from_to(*loose) : "");
}

std::string dense_answer(const Compressions& all, const std::string& exponents) {
  constexpr double nearly = 0.06, hardly = 0.3; // of s, and of z*
  const bool near = std::ranges::all_of(all, [](const Compression& c) {
    return c.density != Density::dense || !c.exponent ||
           std::abs(c.exponent->value - c.contact_exponent) < nearly;
  });
  std::string sentence =
      near ? "In dense packings s is nearly that of a single contact, which is 1/(1+\u03b1) (in brackets) if "
             "the surface near the contact has the profile r^\u03b1: " +
                 exponents
           : "In dense packings s is " + exponents +
                 " (in brackets: s of a single contact of this shape, 1/(1+\u03b1) for the profile r^\u03b1)";
  if (const auto z = mean_ends(all, Density::dense, z_star))
    sentence +=
        fmt::format("; pressure {}: {}, contacts per grain that carries load",
                    std::abs(z->second - z->first) < hardly ? "hardly adds contacts" : "changes the contacts",
                    "z* " + from_to(*z));
  return sentence + ".";
}

std::string loose_answer(const Compressions& all, const std::string& exponents) {
  const bool above = std::ranges::all_of(all, [](const Compression& c) { // by two standard errors
    return c.density != Density::loose || !c.exponent ||
           c.exponent->value - c.contact_exponent > 2 * c.exponent->standard_error;
  });
  std::string sentence = "In loose packings s is " + exponents;
  if (const auto z = mean_ends(all, Density::loose, z_star))
    sentence += above && z->second > z->first
                    ? ", larger than s of a single contact because pressure also adds contacts: z* " +
                          from_to(*z) + ", contacts per grain that carries load"
                    : "; z*, the contacts per grain that carries load, goes " + from_to(*z);
  if (const auto share = mean_ends(all, Density::loose, softening))
    sentence += "; G over its value under uniform strain (all grains move with the mean strain) goes " +
                from_to(*share);
  return sentence + ".";
}

// ---- pictures

Quantity pressures() {
  return {"p_Pa", {.title = "p' [kPa]", .scale = plot::Scale::logarithmic, .unit = 1e3}};
}

/// The shapes that were run, each once.
std::vector<contact::Shape> shapes_of(const Compressions& all) {
  std::vector<contact::Shape> out;
  for (const Compression& c : all)
    if (std::ranges::find(out, c.contact) == out.end())
      out.push_back(c.contact);
  return out;
}

/// A line or markers of one specimen: the shape has the colour, loose packings are hollow or dashed.
plot::Series curve_of(const Compression& c, plot::Mark mark, const NumberOf& x, const NumberOf& y) {
  const bool loose = c.density == Density::loose, line = mark == plot::Mark::line;
  plot::Series out{.mark = mark,
                   .style = line && loose ? 1 : 0,
                   .tone = !line && loose ? plot::Tone::hollow : plot::Tone::full,
                   .colour = colour_of(c.contact)};
  for (const RouteState& state : c.states)
    if (const auto across = x(state), up = y(state); across && up)
      out.add(*across, *up);
  return out;
}

/// Below the last part of a curve, where the network has s.
void add_triangle(plot::Chart& to, const Compression& c, std::size_t modulus) {
  if (!c.exponent || c.states.size() < 3 || !c.states.back().network[modulus])
    return;
  const double x1 = c.states.back().pressure, x0 = x1 / 2, s = c.exponent->value;
  to.triangles.push_back({.x0 = x0,
                          .x1 = x1,
                          .y0 = *c.states.back().network[modulus] * std::pow(x0 / x1, s),
                          .slope = s,
                          .text = fmt::format("s = {:.2f}", s),
                          .colour = colour_of(c.contact)});
}

/// Largest relative difference of a route from the network, or nothing where they have no state in common.
std::optional<double> largest_difference(const Compressions& all, std::size_t modulus,
                                         ShearModuli RouteState::*route) {
  std::optional<double> largest;
  for (const Compression& c : all)
    for (const RouteState& state : c.states)
      if (const auto& network = state.network[modulus], &other = (state.*route)[modulus]; network && other)
        largest = std::max(largest.value_or(0), std::abs(*other / *network - 1));
  return largest;
}

std::string modulus_finding(const Compressions& all, std::size_t modulus) {
  std::string exponents,
      text = fmt::format("{} against p' on logarithmic axes.", shear_modulus_names[modulus]);
  for (const Compression& c : all)
    if (c.exponent)
      exponents += fmt::format("{}{:.2f} for {} {}", exponents.empty() ? "" : ", ", c.exponent->value,
                               density_name(c), plural(c));
  if (!exponents.empty())
    text += " s, the slope: " + exponents + ".";
  for (const auto& [route, moduli] :
       {std::pair{"Rung 3", &RouteState::relaxed}, std::pair{"The probe", &RouteState::probe}})
    if (const auto largest = largest_difference(all, modulus, moduli))
      text += fmt::format(" {} is within {:.2g} % of the network.", route, 100 * *largest);
  return text;
}

Panel contact_law_panel(const studies::Scene& scene, const Compressions& all) {
  Panel out = studies::panel(
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
                                   .text = fmt::format("{:.2f}", b),
                                   .colour = colour_of(shape)});
    add(out, std::move(line), std::string(name(shape)));
  }
  return out;
}

/// Adds a series for each specimen; a shape is listed once, and both densities.
void add_specimens(Panel& to, const Compressions& all, plot::Mark mark, const NumberOf& x,
                   const NumberOf& y) {
  std::vector<contact::Shape> listed;
  for (const Compression& c : all) {
    plot::Series series = curve_of(c, mark, x, y);
    series.kind = density_name(c);
    if (!series.x.empty() && std::ranges::find(listed, c.contact) == listed.end())
      series.name = name(listed.emplace_back(c.contact));
    add(to, std::move(series), key_of(c));
  }
}

/// Curves that lie within a hundredth of each other are drawn as one.
void add_closed_forms(Panel& to, const studies::Scene& scene, const Compressions& all) {
  constexpr double drawn_as_one = 0.01;
  std::vector<double> z;
  for (const plot::Series& series : to.chart.series)
    z.insert(z.end(), series.x.begin(), series.x.end());
  if (z.empty())
    return;
  const auto [low, high] = std::ranges::minmax(z);
  const std::vector<contact::Shape> shapes = shapes_of(all);
  std::vector<plot::Series> curves;
  double gap = 0;
  for (const contact::Shape shape : shapes) {
    curves.push_back(relaxation_curve(scene, shape, low, high, 60));
    for (std::size_t k = 0; k < curves.front().y.size(); ++k)
      gap = std::max(gap, std::abs(curves.back().y[k] - curves.front().y[k]));
  }
  const bool one = gap < drawn_as_one;
  for (std::size_t k = 0; k < (one ? 1 : curves.size()); ++k) {
    curves[k].style = 0;
    if (one) {
      curves[k].name = "rung 3, of all shapes";
      curves[k].tone = plot::Tone::grey;
    } else {
      curves[k].colour = colour_of(shapes[k]);
      curves[k].kind = "rung 3";
    }
    add(to, std::move(curves[k]), one ? "closed form" : fmt::format("closed form {}", name(shapes[k])));
  }
}

Panel contacts_panel(const Compressions& all) {
  Panel out = studies::panel("contacts", "Contacts of a grain", pressures(), {"z_star", {.title = "z*"}});
  add_specimens(out, all, plot::Mark::both, pressure, z_star);
  out.chart.finding = "Contacts of a grain, z*, against p': z* goes, for " + from_to(all, z_star) + ".";
  return out;
}

Panel softening_panel(const studies::Scene& scene, const Compressions& all) {
  Panel out = studies::panel("relaxation", "G relative to uniform strain", {"z_star", {.title = "z*"}},
                             {"G_over_uniform_strain", {.title = "G of network / uniform strain"}});
  add_specimens(out, all, plot::Mark::marker, z_star, softening);
  add_closed_forms(out, scene, all);
  out.chart.finding = "G of the network over G under uniform strain, against z*: this ratio goes, for " +
                      from_to(all, softening) + ".";
  return out;
}

} // namespace

double shear_relaxation(const studies::Scene& scene, contact::Shape shape,
                        double mechanical_coordination_number) {
  return effective::relaxation(mechanical_coordination_number, tangential_ratio(scene),
                               contact_exponent(scene, shape), law(scene, shape).surface().stiffening)
      .shear.value;
}

plot::Series relaxation_curve(const studies::Scene& scene, contact::Shape shape, double low, double high,
                              int steps) {
  plot::Series out{.mark = plot::Mark::line};
  for (int k = 0; k <= steps; ++k) {
    const double z = low + (high - low) * k / steps;
    out.add(z, shear_relaxation(scene, shape, z));
  }
  return out;
}

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
  if (const std::string dense = exponents_text(all, Density::dense, true); !dense.empty())
    answer.push_back(dense_answer(all, dense));
  if (const std::string loose = exponents_text(all, Density::loose, false); !loose.empty())
    answer.push_back(loose_answer(all, loose));
  return answer;
}

Panel modulus_panel(const std::vector<Compression>& all, std::size_t modulus) {
  const std::string symbol = shear_modulus_names[modulus];
  Panel out = studies::panel(
      "log_G_log_p_" + symbol, "", pressures(),
      {symbol + "_Pa", {.title = symbol + " [MPa]", .scale = plot::Scale::logarithmic, .unit = 1e6}});
  out.chart.width = 360;
  out.chart.height = 320;
  struct Route {
    const char *kind, *key;
    ShearModuli RouteState::*moduli;
    plot::Mark mark;
    bool diamonds;
  };
  std::vector<contact::Shape> listed;
  for (const Route& route : {Route{"rung 3", "closed form", &RouteState::relaxed, plot::Mark::line, false},
                             Route{"network", "network", &RouteState::network, plot::Mark::marker, false},
                             Route{"probe", "probe", &RouteState::probe, plot::Mark::marker, true}})
    for (const Compression& c : all) {
      plot::Series series =
          curve_of(c, route.mark, pressure, [&](const RouteState& s) { return (s.*route.moduli)[modulus]; });
      if (route.diamonds)
        series.style = 2;
      series.kind = fmt::format("{}, {}", route.kind, density_name(c));
      if (route.mark == plot::Mark::line && !series.x.empty() &&
          std::ranges::find(listed, c.contact) == listed.end())
        series.name = name(listed.emplace_back(c.contact));
      add(out, std::move(series), key_of(c) + " " + route.key);
    }
  for (const Compression& c : all)
    add_triangle(out.chart, c, modulus);
  out.chart.finding = modulus_finding(all, modulus);
  return out;
}

Picture picture_of(const std::vector<Panel>& panels, std::string caption) {
  Picture out{.charts = {}, .caption = std::move(caption)};
  for (const Panel& panel : panels) {
    out.charts.push_back(panel.chart);
    out.files.push_back(fmt::format("{}/{}.csv", figures_name, panel.stem));
    std::string& choice = out.choices.emplace_back();
    for (const char* modulus : shear_modulus_names)
      if (panel.y_heading == std::string(modulus) + "_Pa")
        choice = modulus;
  }
  return out;
}

std::vector<Panel> add_compression(Document& to, const studies::Scene& scene,
                                   const std::vector<Compression>& all) {
  to.question = "Why does the stiffness of a packing of grains grow as p\u02e2, and what is s?";
  to.sentences = compression_answer(all);
  std::vector<Panel> panels;
  for (std::size_t k = 0; k < shear_modulus_names.size(); ++k)
    if (Panel one = modulus_panel(all, k); !one.chart.series.empty())
      panels.push_back(std::move(one));
  to.add(Seen::full,
         picture_of(
             panels,
             "Isotropic compression, first specimen of each kind. Lines: rung 3, the closed form of uniform "
             "strain times a relaxation factor, from the counted contacts; circles: linear response of the "
             "contact network; diamonds: cyclic shear by DEM. Triangles have the slope s of the network."));
  const Panel contacts = contacts_panel(all);
  if (contacts.chart.series.empty())
    return panels;
  const auto add_cause = [&](const Panel& panel, const char* caption) {
    to.add(Seen::full, picture_of({panel}, caption));
    panels.push_back(panel);
  };
  add_cause(
      contact_law_panel(scene, all),
      "1. The stiffness of a contact is a power of its force that depends on its shape. With a constant "
      "set of contacts, G of the packing would be the same power of p.");
  add_cause(contacts,
            "2. Contacts per grain that carries load, z*. Each new contact makes the packing stiffer.");
  add_cause(
      softening_panel(scene, all),
      "3. Grains do not move exactly with the mean strain; the deviation is larger with fewer contacts. "
      "New contacts reduce it and make a loose packing stiffer, in addition to cause 1.");
  return panels;
}

} // namespace granum::cli

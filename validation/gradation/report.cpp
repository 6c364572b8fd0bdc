// SPDX-License-Identifier: GPL-3.0-or-later
// What the recorded packings say of G and the uniformity coefficient.
//
//     gradation_report table states.csv      G at equal void ratio and relative density, as in README.md
//     gradation_report check states.csv      exit code 0 if the routes agree and G falls with C_u at equal e
//     gradation_report picture states.csv    the same as SVG
//     gradation_report restate states.csv    the record again, with what the closed forms say of it now
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <exception>
#include <functional>
#include <map>
#include <string>
#include <vector>

#include <granum/plot/chart.hpp>
#include <granum/sands/known_sands.hpp>

#include "../claims.hpp"
#include "curves.hpp"
#include "errors.hpp"

namespace {

using namespace granum;
using gradation::Curve;
using gradation::Point;
using gradation::State;

constexpr double pressure = 100e3; // [Pa]
constexpr double relative_densities[] = {0, 0.25, 0.5, 0.75, 1};
constexpr double void_ratios[] = {0.35, 0.4, 0.45, 0.5, 0.55, 0.6, 0.65, 0.7};

struct Route {
  const char* name;
  double Point::*modulus;
};
constexpr Route routes[] = {{"closed form", &Point::closed},
                            {"closed form, contacts from sizes", &Point::from_sizes},
                            {"network", &Point::network},
                            {"probe", &Point::probe}};

/// Those gradations that have packings of that void ratio, by C_u.
std::vector<Curve> holding(const std::vector<Curve>& all, double void_ratio) {
  std::vector<Curve> some;
  for (const Curve& curve : all)
    if (curve.holds(void_ratio))
      some.push_back(curve);
  return some;
}

// ---- the tables ----

/// What sands have by their published law.
sands::SandModulus of_sands(double void_ratio, double uniformity) {
  return sands::shear_modulus(sands::measured_law("wichtmann-triantafyllidis"),
                              {void_ratio, pressure, uniformity});
}

/// In brackets beyond the tests of that law.
std::string measured_text(double void_ratio, double uniformity) {
  const sands::SandModulus sand = of_sands(void_ratio, uniformity);
  const std::string text = short_text(sand.shear_modulus / 1e6, 3);
  return sand.validity.ok() ? text : "(" + text + ")";
}

std::string moduli_text(const Point& point) {
  std::string text;
  for (const Route& route : routes)
    text += " | " +
            (std::isnan(point.*route.modulus) ? std::string() : short_text(point.*route.modulus / 1e6, 3));
  return text;
}

void print_equal_void_ratio(const std::vector<Curve>& all) {
  std::printf(
      "| e | C_u | D_r | z* | closed form | contacts from sizes | network | probe | sands, measured |\n"
      "| --- | --- | --- | --- | --- | --- | --- | --- | --- |\n");
  for (const double e : void_ratios) {
    const std::vector<Curve> some = holding(all, e);
    if (some.size() < 2)
      continue;
    for (const Curve& curve : some) {
      const Point point = curve.at(e);
      const double density = curve.relative_density_of(e);
      std::printf("| %.2f | %.1f | %.2f | %.2f%s | %s |\n", e, curve.uniformity, density, point.z_star,
                  moduli_text(point).c_str(), measured_text(e, curve.uniformity).c_str());
    }
  }
}

void print_equal_density(const std::vector<Curve>& all) {
  std::printf("| D_r | C_u | e | z* | closed form | contacts from sizes | network | probe |\n"
              "| --- | --- | --- | --- | --- | --- | --- | --- |\n");
  for (const double density : relative_densities)
    for (const Curve& curve : all) {
      const Point point = curve.at(curve.void_ratio_of(density));
      std::printf("| %.2f | %.1f | %.3f | %.2f%s |\n", density, curve.uniformity, point.void_ratio,
                  point.z_star, moduli_text(point).c_str());
    }
}

/// Means over the seeds, and why rung 3 misses the network: its error is the product of what is wrong with
/// uniform strain and with the relaxation.
void print_packings(const std::vector<Curve>& all) {
  std::printf(
      "| C_u | preparation | seeds | e | z* | rattlers | G, network | closed form over it | uniform strain | "
      "relaxation | stated | K, network | closed form over it | stated |\n"
      "| --- | --- | --- | --- | --- | --- | --- | --- | --- | --- | --- | --- | --- | --- |\n");
  for (const Curve& curve : all)
    for (const Point& p : curve.points) {
      const double whole = p.closed / p.network, strain = p.uniform_strain / p.affine;
      std::printf("| %.1f | %s | %d | %.3f | %.2f | %.2f | %s | %.2f | %.2f | %.2f | %s | %s | %.2f | %s |\n",
                  curve.uniformity, p.preparation.c_str(), p.seeds, p.void_ratio, p.z_star,
                  p.rattler_fraction, short_text(p.network / 1e6, 3).c_str(), whole, strain, whole / strain,
                  percent_text(p.stated).c_str(), short_text(p.network_bulk_modulus / 1e6, 3).c_str(),
                  p.closed_bulk_modulus / p.network_bulk_modulus, percent_text(p.stated_bulk_error).c_str());
    }
}

/// The record with the closed forms of now.
void print_restated(const io::CsvTable& table, const std::vector<State>& states) {
  const std::vector<std::string>& headings = table.headings();
  std::printf("%s", io::csv_line({headings.begin(), headings.end()}).c_str());
  for (std::size_t k = 0; k < states.size(); ++k) {
    const gradation::ClosedForms now = gradation::closed_forms(states[k]);
    const std::map<std::string, double> numbers{{"G_closed_Pa", now.relaxed},
                                                {"G_closed_stated", now.stated_error},
                                                {"G_closed_sizes_Pa", now.relaxed_from_sizes},
                                                {"G_uniform_strain_Pa", now.uniform_strain}};
    const std::vector<std::string>& fields = table.fields(k);
    std::vector<io::CsvCell> cells(fields.begin(), fields.end());
    for (std::size_t column = 0; column < headings.size(); ++column)
      if (const auto number = numbers.find(headings[column]); number != numbers.end())
        cells[column] = short_text(number->second, 7);
    std::printf("%s", io::csv_line(cells).c_str());
  }
}

// ---- the questions ----

void check_library(Claims& claims, const std::vector<State>& states) {
  constexpr double recorded_digits = 1e-5; // seven digits, and the slopes of what they are put into
  const auto same = [](double now, double then) { return std::abs(now / then - 1) < recorded_digits; };
  std::string other;
  for (const State& s : states) {
    const gradation::ClosedForms now = gradation::closed_forms(s);
    if (!same(now.relaxed, s.recorded.relaxed) || !same(now.stated_error, s.recorded.stated_error) ||
        !same(now.relaxed_from_sizes, s.recorded.relaxed_from_sizes) ||
        !same(now.uniform_strain, s.recorded.uniform_strain))
      other = s.name();
  }
  claims.require(other.empty(), "the library says of each packing what was recorded" +
                                    (other.empty() ? "" : "; not of " + other));
}

void check_probes(Claims& claims, const std::vector<State>& states) {
  const struct {
    std::string name;
    std::function<bool(const State&)> holds;
    double limit;
  } kinds[] = {{"dense", [](const State& s) { return s.dense(); }, 0.005},
               {"compressed with friction", [](const State& s) { return !s.dense(); }, 0.02}};
  claims.require(3 * std::count_if(states.begin(), states.end(), [](const State& s) { return s.probed(); }) >
                     2 * std::ssize(states),
                 "the probes of most packings settled");
  for (const auto& kind : kinds) {
    double worst = 0;
    int compared = 0, unsettled = 0;
    for (const State& s : states)
      if (kind.holds(s))
        for (const gradation::Probe& probe : s.probes) {
          unsettled += !probe.converged;
          compared += probe.converged;
          if (probe.converged)
            worst = std::max(worst, std::abs(probe.modulus / probe.network - 1));
        }
    if (compared == 0)
      continue;
    claims.require(worst <= kind.limit, kind.name + ": " + std::to_string(compared) + " probes within " +
                                            percent_text(worst) + " of the network; " +
                                            std::to_string(unsettled) + " did not settle");
  }
}

void check_coverage(Claims& claims, const std::string& what, const gradation::ModulusErrors& errors) {
  constexpr double share = 0.1; // may lie beyond two stated errors
  claims.require(errors.count() > 0 && errors.beyond_two() <= share * errors.count(),
                 "rung 3, " + what + ": " + std::to_string(errors.beyond_two()) + " of " +
                     std::to_string(errors.count()) + " packings beyond 2 stated errors, the worst at " +
                     short_text(errors.worst_in_stated(), 2));
}

/// Dense packings and those compressed with friction apart: a share of all would go with how many of them
/// happen to be dense.
void check_closed_forms(Claims& claims, const std::vector<State>& states) {
  for (const bool dense : {false, true}) {
    const std::string kind = dense ? "dense" : "compressed with friction";
    const gradation::ErrorsOfBoth errors =
        gradation::errors_of(states, [dense](const State& s) { return s.dense() == dense; });
    check_coverage(claims, "G, " + kind, errors.shear);
    check_coverage(claims, "K, " + kind, errors.bulk);
  }
}

void check_fall(Claims& claims, const std::vector<Curve>& all) {
  constexpr int fewest = 5; // pairs of neighbours in C_u at one void ratio
  for (const Route& route : routes) {
    int pairs = 0, falls = 0;
    for (const double e : void_ratios) {
      const std::vector<Curve> some = holding(all, e);
      for (std::size_t k = 1; k < some.size(); ++k) {
        const double less = some[k - 1].at(e).*route.modulus, more = some[k].at(e).*route.modulus;
        if (std::isnan(less) || std::isnan(more))
          continue;
        ++pairs;
        falls += more < less;
      }
    }
    claims.require(pairs >= fewest && falls == pairs,
                   std::string(route.name) + ": at equal void ratio G falls with C_u in " +
                       std::to_string(falls) + " of " + std::to_string(pairs) + " pairs");
  }
}

/// The same recipe with larger grains. A factor that is a power of 4 rounds alike, so that the packing is the
/// same but for its scale. Any other factor leads to another packing, one among those of other seeds.
void check_size(Claims& claims, const std::vector<State>& states) {
  int compared = 0;
  for (const State& large : states) {
    if (large.mean_radius == gradation::usual_radius)
      continue;
    ++compared;
    const double factor = large.mean_radius / gradation::usual_radius;
    const std::string what = large.name() + ", grains " + short_text(factor, 4) +
                             " times as large: G over that of the usual size ";
    std::vector<double> usual;
    double same_seed = 0;
    for (const State& s : states)
      if (s.sizes == large.sizes && s.preparation == large.preparation &&
          s.mean_radius == gradation::usual_radius) {
        usual.push_back(s.network);
        same_seed = s.seed == large.seed ? s.network : same_seed;
      }
    if (std::abs(factor - 16) < 1e-9) {
      claims.require(std::abs(large.network / same_seed - 1) <= 1e-6,
                     what + "- 1 = " + short_text(large.network / same_seed - 1, 2));
      continue;
    }
    const auto [least, most] = std::minmax_element(usual.begin(), usual.end());
    const double spread = *most - *least;
    claims.require(usual.size() > 2 && large.network > *least - spread && large.network < *most + spread,
                   what + short_text(large.network / *least, 3) + " to " +
                       short_text(large.network / *most, 3) + ", as other seeds among themselves");
  }
  claims.require(compared >= 4, "packings of larger grains: " + std::to_string(compared));
}

// ---- the picture ----

plot::Chart panel(const std::string& title, const std::string& x) {
  return {.title = title,
          .x = {x},
          .y = {"G at 100 kPa [MPa]", plot::Scale::linear, 1e6},
          .series = {},
          .width = 330,
          .height = 340,
          .legend_below = true};
}

/// A network's markers and what is set beside it: named where the chart has not named it yet.
struct Family {
  plot::Series network, closed, sands;

  Family(const plot::Chart& picture, std::size_t style, const std::string& name)
      : network{.name = name, .x = {}, .y = {}, .style = style, .colour = plot::Colour::measured},
        closed{.name = picture.series.empty() ? "closed form" : "",
               .mark = plot::Mark::line,
               .x = {},
               .y = {},
               .style = style,
               .colour = plot::Colour::closed_form},
        sands{.name = picture.series.empty() ? "measured sands" : "",
              .mark = plot::Mark::line,
              .x = {},
              .y = {},
              .style = style,
              .tone = plot::Tone::grey} {}
  void add(double x, const Point& point, double uniformity) {
    for (plot::Series* series : {&network, &closed, &sands})
      series->x.push_back(x);
    network.y.push_back(point.network);
    closed.y.push_back(point.closed);
    sands.y.push_back(of_sands(point.void_ratio, uniformity).shear_modulus);
  }
};

plot::Chart over_void_ratio(const std::vector<Curve>& all) {
  plot::Chart picture = panel("Each gradation: densest to loosest", "void ratio e");
  for (std::size_t k = 0; k < all.size(); ++k) {
    Family family(picture, k, "C_u = " + short_text(all[k].uniformity, 2));
    family.network.mark = plot::Mark::marker;
    for (const Point& point : all[k].points)
      family.add(point.void_ratio, point, all[k].uniformity);
    picture.series.insert(picture.series.end(), {family.network, family.closed});
  }
  picture.finding = "Each gradation has a curve G(e) of its own, farther left the larger C_u is. Markers: "
                    "network; lines: closed form.";
  return picture;
}

plot::Chart at_equal_void_ratio(const std::vector<Curve>& all) {
  plot::Chart picture = panel("At equal void ratio", "uniformity coefficient C_u");
  std::size_t style = 0;
  for (const double e : void_ratios) {
    const std::vector<Curve> some = holding(all, e);
    if (some.size() < 2)
      continue;
    Family family(picture, style++, "e = " + short_text(e, 2));
    for (const Curve& curve : some)
      family.add(curve.uniformity, curve.at(e), curve.uniformity);
    picture.series.insert(picture.series.end(), {family.network, family.closed, family.sands});
  }
  picture.finding = "At one void ratio G falls with C_u, in packings of spheres more steeply than in sands, "
                    "whose law is grey.";
  return picture;
}

plot::Chart at_equal_density(const std::vector<Curve>& all) {
  plot::Chart picture = panel("At equal relative density", "uniformity coefficient C_u");
  std::size_t style = 0;
  for (const double density : relative_densities) {
    Family family(picture, style++, "D_r = " + short_text(density, 2));
    for (const Curve& curve : all)
      family.add(curve.uniformity, curve.at(curve.void_ratio_of(density)), curve.uniformity);
    picture.series.insert(picture.series.end(), {family.network, family.closed});
  }
  picture.finding = "At one relative density G hardly changes with C_u; that of the densest packings grows.";
  return picture;
}

int check(const std::vector<State>& states) {
  Claims claims;
  const std::vector<Curve> all = gradation::curves(states);
  check_library(claims, states);
  check_probes(claims, states);
  check_closed_forms(claims, states);
  check_fall(claims, all);
  check_size(claims, states);
  return claims.failed() == 0 ? 0 : 1;
}

int run(int argc, char** argv) {
  const std::string what = argc == 3 ? argv[1] : "";
  if (what != "table" && what != "check" && what != "picture" && what != "restate") {
    std::fprintf(stderr, "usage: %s table|check|picture|restate states.csv\n", argv[0]);
    return 2;
  }
  const std::vector<State> states = gradation::read_states(argv[2]);
  if (what == "check")
    return check(states);
  if (what == "restate") {
    print_restated(io::read_csv(argv[2]), states);
    return 0;
  }
  const std::vector<Curve> all = gradation::curves(states);
  if (what == "picture") {
    const plot::Chart charts[] = {over_void_ratio(all), at_equal_void_ratio(all), at_equal_density(all)};
    std::printf("%s", plot::svg(charts).c_str());
    return 0;
  }
  print_equal_void_ratio(all);
  std::printf("\n");
  print_equal_density(all);
  std::printf("\n");
  print_packings(all);
  std::printf("\n");
  gradation::print_errors(states);
  std::printf("\n");
  gradation::print_scatter_of_seeds(states);
  return 0;
}

} // namespace

int main(int argc, char** argv) {
  try {
    return run(argc, argv);
  } catch (const std::exception& error) {
    std::fprintf(stderr, "%s\n", error.what());
    return 1;
  }
}

// SPDX-License-Identifier: GPL-3.0-or-later
// What the recorded packings say of G and the uniformity coefficient.
//
//     gradation_report table states.csv      G at equal void ratio and relative density, as in README.md
//     gradation_report check states.csv      exit code 0 if the routes agree and G falls with C_u at equal e
//     gradation_report picture states.csv    the same as SVG
//     gradation_report restate states.csv    the record again, with what the closed forms say of it now
#include <granum/plot/chart.hpp>
#include <granum/sands/known_sands.hpp>
#include <gsl/gsl_statistics_double.h>

#include "../common.hpp"
#include "states.hpp"

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
    const gradation::ClosedForms& now = states[k].now;
    const std::map<std::string, double> numbers{{"G_closed_Pa", now.relaxed},
                                                {"G_closed_stated", now.stated_error},
                                                {"G_closed_sizes_Pa", now.relaxed_from_sizes},
                                                {"G_uniform_strain_Pa", now.uniform_strain}};
    std::vector<io::CsvCell> cells(table.fields(k).begin(), table.fields(k).end());
    for (std::size_t column = 0; column < headings.size(); ++column)
      if (const auto number = numbers.find(headings[column]); number != numbers.end())
        cells[column] = short_text(number->second, 7);
    std::printf("%s", io::csv_line(cells).c_str());
  }
}

// ---- errors of rung 3 ----

/// C_u as the tables print it: seeds of one gradation differ in the next digit.
double printed_uniformity(const State& s) { return std::round(10 * s.uniformity) / 10; }

using Choice = std::function<bool(const State&)>;

/// Of those states that are chosen and have grains of the usual size.
ErrorsOfBoth errors_of(const std::vector<State>& states, const Choice& chosen) {
  ErrorsOfBoth errors;
  for (const State& s : states)
    if (s.usual() && chosen(s)) {
      errors.G.add(s.now.relaxed / s.network - 1, s.now.stated_error);
      errors.K.add(s.now.bulk_modulus / s.network_bulk_modulus - 1, s.now.stated_bulk_error);
    }
  return errors;
}

std::string text_of(const Errors& e) {
  return percent_text(e.rms()) + " | " + percent_text(e.lowest()) + " to " + percent_text(e.highest()) +
         " | " + percent_text(e.one()) + " | " + std::to_string(e.beyond_two()) + " | " +
         short_text(e.worst_in_stated(), 2);
}

void print_errors_of_kinds(const std::vector<State>& states) {
  constexpr double lowest_claimed = 4.1; // z*
  const auto kind = [](bool dense, double from, double to) {
    return [=](const State& s) {
      return s.dense() == dense && (dense || s.z_star >= lowest_claimed) && printed_uniformity(s) >= from &&
             printed_uniformity(s) <= to;
    };
  };
  const std::pair<const char*, Choice> kinds[] = {
      {"with friction, z* from 4.1", kind(false, 1, 4)},
      {"- C_u up to 2", kind(false, 1, 2)},
      {"- C_u up to 2, friction 0.03 to 0.3",
       [&](const State& s) { return kind(false, 1, 2)(s) && !s.preparation.ends_with("mu0.5"); }},
      {"- C_u beyond 2", kind(false, 2.5, 4)},
      {"with friction, z* below 4.1", [](const State& s) { return !s.dense() && s.z_star < lowest_claimed; }},
      {"dense", kind(true, 1, 4)},
      {"- C_u = 1", kind(true, 1, 1)},
      {"- C_u from 2 to 3", kind(true, 2, 3)},
      {"- C_u = 4", kind(true, 4, 4)}};
  std::printf("| packings | number | G rms | from, to | within one stated error | beyond two | worst, in "
              "stated errors | K rms | from, to | within one | beyond two | worst |\n"
              "| --- | --- | --- | --- | --- | --- | --- | --- | --- | --- | --- | --- |\n");
  for (const auto& [what, chosen] : kinds) {
    const ErrorsOfBoth errors = errors_of(states, chosen);
    std::printf("| %s | %d | %s | %s |\n", what, errors.G.count(), text_of(errors.G).c_str(),
                text_of(errors.K).c_str());
  }
}

/// Standard deviation of G of the network among the seeds of each gradation and preparation, over their mean.
void print_scatter_of_seeds(const std::vector<State>& states) {
  std::map<std::pair<double, std::string>, std::vector<double>> moduli;
  for (const State& s : states)
    if (s.usual())
      moduli[{printed_uniformity(s), s.preparation}].push_back(s.network);
  std::printf("| seeds of one state | G scatters by |\n| --- | --- |\n");
  for (const bool dense : {true, false}) {
    Errors scatter;
    for (const auto& [recipe, G] : moduli)
      if ((recipe.second == "dense") == dense && G.size() >= 3)
        scatter.add(gsl_stats_sd(G.data(), 1, G.size()) / gsl_stats_mean(G.data(), 1, G.size()));
    std::printf("| %s | %s to %s |\n", dense ? "dense" : "with friction",
                percent_text(scatter.lowest()).c_str(), percent_text(scatter.highest()).c_str());
  }
}

// ---- the questions ----

void check_library(Claims& claims, const std::vector<State>& states) {
  constexpr double recorded_digits = 1e-5; // seven digits, and the slopes of what they are put into
  using gradation::ClosedForms;
  std::string other;
  for (const State& s : states)
    for (const auto of : {&ClosedForms::relaxed, &ClosedForms::stated_error, &ClosedForms::relaxed_from_sizes,
                          &ClosedForms::uniform_strain})
      if (!(std::abs(s.now.*of / (s.recorded.*of) - 1) < recorded_digits))
        other = s.name();
  claims.require(other.empty(), "the library says of each packing what was recorded" +
                                    (other.empty() ? "" : "; not of " + other));
}

/// Dense packings and those compressed with friction apart: a share of all would go with how many of them
/// happen to be dense.
void check_each_kind(Claims& claims, const std::vector<State>& states) {
  constexpr double share = 0.1; // may lie beyond two stated errors
  claims.require(3 * std::ranges::count_if(states, &State::probed) > 2 * std::ssize(states),
                 "the probes of most packings settled");
  for (const bool dense : {true, false}) {
    const std::string kind = dense ? "dense" : "compressed with friction";
    Errors probes;
    int unsettled = 0;
    for (const State& s : states)
      for (const gradation::Probe& probe : s.probes) {
        if (s.dense() != dense)
          continue;
        unsettled += !probe.converged;
        if (probe.converged)
          probes.add(probe.modulus / probe.network - 1);
      }
    claims.require(probes.worst() <= (dense ? 0.005 : 0.02),
                   kind + ": " + std::to_string(probes.count()) + " probes within " +
                       percent_text(probes.worst()) + " of the network; " + std::to_string(unsettled) +
                       " did not settle");
    const ErrorsOfBoth errors = errors_of(states, [dense](const State& s) { return s.dense() == dense; });
    for (const auto& [modulus, e] : {std::pair{"G, ", &errors.G}, std::pair{"K, ", &errors.K}})
      claims.require(e->count() > 0 && e->beyond_two() <= share * e->count(),
                     "rung 3, " + (modulus + kind) + ": " + std::to_string(e->beyond_two()) + " of " +
                         std::to_string(e->count()) + " packings beyond 2 stated errors, the worst at " +
                         short_text(e->worst_in_stated(), 2));
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
    if (large.usual())
      continue;
    ++compared;
    const double factor = large.mean_radius / gradation::usual_radius;
    const std::string what = large.name() + ", grains " + short_text(factor, 4) +
                             " times as large: G over that of the usual size ";
    std::vector<double> usual;
    double same_seed = 0;
    for (const State& s : states)
      if (s.sizes == large.sizes && s.preparation == large.preparation && s.usual()) {
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

/// G over x of groups of points, each a style of its own.
class Panel {
 public:
  Panel(const std::string& title, const std::string& x, const std::string& finding)
      : chart_{.title = title,
               .x = {x},
               .y = {"G at 100 kPa [MPa]", plot::Scale::linear, 1e6},
               .width = 330,
               .height = 340,
               .legend_below = true,
               .finding = finding} {}
  /// A network's markers and what is set beside it: named where the chart has not named it yet.
  void begin(const std::string& name, plot::Mark mark, bool sands) {
    const bool first = chart_.series.empty();
    sands_ = sands;
    chart_.series.push_back({.name = name, .mark = mark, .style = style_, .colour = plot::Colour::measured});
    chart_.series.push_back({.name = first ? "closed form" : "",
                             .mark = plot::Mark::line,
                             .style = style_,
                             .colour = plot::Colour::closed_form});
    if (sands)
      chart_.series.push_back({.name = first ? "measured sands" : "",
                               .mark = plot::Mark::line,
                               .style = style_,
                               .tone = plot::Tone::grey});
    ++style_;
  }
  void add(double x, const Point& point, double uniformity) {
    const auto last = chart_.series.end();
    (last - (sands_ ? 3 : 2))->add(x, point.network);
    (last - (sands_ ? 2 : 1))->add(x, point.closed);
    if (sands_)
      (last - 1)->add(x, of_sands(point.void_ratio, uniformity).shear_modulus);
  }
  [[nodiscard]] const plot::Chart& chart() const { return chart_; }

 private:
  plot::Chart chart_;
  std::size_t style_ = 0;
  bool sands_ = false;
};

std::string picture(const std::vector<Curve>& all) {
  using plot::Mark;
  Panel each("Each gradation: densest to loosest", "void ratio e",
             "Each gradation has a curve G(e) of its own, farther left the larger C_u is. Markers: "
             "network; lines: closed form.");
  for (const Curve& curve : all) {
    each.begin("C_u = " + short_text(curve.uniformity, 2), Mark::marker, false);
    for (const Point& point : curve.points)
      each.add(point.void_ratio, point, curve.uniformity);
  }
  Panel at_void_ratio(
      "At equal void ratio", "uniformity coefficient C_u",
      "At one void ratio G falls with C_u, in packings of spheres more steeply than in sands, "
      "whose law is grey.");
  for (const double e : void_ratios)
    if (const std::vector<Curve> some = holding(all, e); some.size() >= 2) {
      at_void_ratio.begin("e = " + short_text(e, 2), Mark::both, true);
      for (const Curve& curve : some)
        at_void_ratio.add(curve.uniformity, curve.at(e), curve.uniformity);
    }
  Panel at_density("At equal relative density", "uniformity coefficient C_u",
                   "At one relative density G hardly changes with C_u; that of the densest packings grows.");
  for (const double density : relative_densities) {
    at_density.begin("D_r = " + short_text(density, 2), Mark::both, false);
    for (const Curve& curve : all)
      at_density.add(curve.uniformity, curve.at(curve.void_ratio_of(density)), curve.uniformity);
  }
  const plot::Chart charts[] = {each.chart(), at_void_ratio.chart(), at_density.chart()};
  return plot::svg(charts);
}

void print_tables(const std::vector<State>& states) {
  const std::vector<Curve> all = gradation::curves(states);
  print_equal_void_ratio(all);
  std::printf("\n");
  print_equal_density(all);
  std::printf("\n");
  print_packings(all);
  std::printf("\n");
  print_errors_of_kinds(states);
  std::printf("\n");
  print_scatter_of_seeds(states);
}

int check(const std::vector<State>& states) {
  Claims claims;
  check_library(claims, states);
  check_each_kind(claims, states);
  check_fall(claims, gradation::curves(states));
  check_size(claims, states);
  return claims.exit_code();
}

} // namespace

int main(int argc, char** argv) {
  return program(argc, argv,
                 {
                     {"table", "states.csv",
                      [](const Arguments& files) { print_tables(gradation::read_states(files[0])); }},
                     {"check", "states.csv",
                      [](const Arguments& files) { return check(gradation::read_states(files[0])); }},
                     {"picture", "states.csv",
                      [](const Arguments& files) {
                        std::printf("%s",
                                    picture(gradation::curves(gradation::read_states(files[0]))).c_str());
                      }},
                     {"restate", "states.csv",
                      [](const Arguments& files) {
                        print_restated(io::read_csv(files[0]), gradation::read_states(files[0]));
                      }},
                 });
}

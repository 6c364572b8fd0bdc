// SPDX-License-Identifier: GPL-3.0-or-later
// Fits the contact prior to the packings that validation/relaxation recorded.
//
//     contact_prior_fit coefficients states.csv unequal.csv codes.csv
//                                      writes src/effective/contact_prior_coefficients.hpp
//     contact_prior_fit check states.csv unequal.csv codes.csv published.csv rough.csv ../infer/states.csv
//                             ../verify_default/states.csv third_seed.csv gradations.csv verify.csv
//                                      fits again, compares with that file, and asks whether recipes left
//                                      out, packings of others, rough ones and verify's lie where it says
//     contact_prior_fit picture states.csv
//                                      SVG: z* over the void ratio, and of packings beside the prior
#include <cstdio>
#include <exception>
#include <functional>
#include <set>
#include <string_view>

#include <granum/contact/power_law.hpp>
#include <granum/effective/contact_prior.hpp>
#include <granum/io/csv/table.hpp>

#include "../claims.hpp"
#include "../relaxation/coverage.hpp"
#include "calibration.hpp"
#include "densest_judged.hpp"
#include "effective/contact_prior_coefficients.hpp"
#include "picture.hpp"
#include "unfitted.hpp"

namespace {

using namespace contact_prior;
using granum::effective::ContactPrior;
using granum::effective::Preparation;
using granum::effective::State;
using Coefficients = Numbers<double, size>;

std::string number(double value, int digits) {
  char text[32];
  std::snprintf(text, sizeof text, "%.*g", digits, value);
  return text;
}

// ---- coefficients ----

template <int n>
void print_fit(const char* what, const char* name, const Fit<n>& fit) {
  std::printf("/// %s\n/// Standard errors:", what);
  for (int k = 0; k < n; ++k)
    std::printf("%s %s", k > 0 ? "," : "", number(std::sqrt(fit.covariance(k, k)), 2).c_str());
  std::printf(".\ninline constexpr std::array<double, %d> %s_coefficients{\n    ", n, name);
  for (int k = 0; k < n; ++k)
    std::printf("%s%s", number(fit.coefficients[static_cast<std::size_t>(k)], 8).c_str(),
                k + 1 == n ? "};\n"
                : k == 4   ? ",\n    "
                           : ", ");
}

void print_coefficients(const Result& r, const densest::Result& d) {
  std::printf(
      "// SPDX-License-Identifier: GPL-3.0-or-later\n"
      "// Written by `contact_prior_fit coefficients states.csv unequal.csv codes.csv` from "
      "validation/relaxation;\n"
      "// the test \"validation: contact_prior\" fits them again and compares. Not to be edited by hand.\n"
      "// clang-format off\n#pragma once\n\n#include <array>\n\nnamespace granum::effective::kernel {\n\n");
  print_fit("e_d, e_l, bend, squeeze, growth, further growth, mu_0, its power, closing, opening.", "contact",
            r.contacts);
  print_fit("c, k, w_r.", "rattler", r.rattlers);
  std::printf(
      "/// Standard deviations of z* of preparations left out of the fit: of those of the densest line, of\n"
      "/// those with a friction, of carrying z* to another pressure, over root_of_way; and that of ln "
      "x_0.\n"
      "inline constexpr double line_scatter = %.5g;\ninline constexpr double friction_scatter = %.5g;\n"
      "inline constexpr double carried_scatter = %.5g;\ninline constexpr double rattler_scatter = %.5g;\n",
      r.line_scatter, r.friction_scatter, r.carried_scatter, r.rattler_scatter);
  const std::array<double, 3> shift = d.shift();
  std::printf(
      "/// What shift_by_grains takes, and of packings above the densest one of the same grains the "
      "standard\n"
      "/// deviations of z*: of preparations left out; of sizes left out, over the root of the variance of\n"
      "/// branches; between codes. Standard errors of the shift: %s, %s, %s.\n"
      "inline constexpr std::array<double, 3> grain_shift{%.5g, %.5g, %.5g};\n"
      "inline constexpr double above_densest_scatter = %.5g;\n"
      "inline constexpr double above_densest_size_scatter = %.5g;\n"
      "inline constexpr double above_densest_code_scatter = %.5g;\n"
      "\n} // namespace granum::effective::kernel\n",
      number(std::sqrt(d.shape.covariance(0, 0)), 2).c_str(),
      number(std::sqrt(d.shape.covariance(1, 1)), 2).c_str(),
      number(std::sqrt(d.sizes.covariance(0, 0)), 2).c_str(), shift[0], shift[1], shift[2], d.recipe_scatter,
      d.size_scatter, d.code_scatter);
}

// ---- errors ----

using Label = std::function<std::string(const Packing&)>;
std::string preparation_of(const Packing& p) { return p.preparation; }
std::string contact_of(const Packing& p) { return p.contact; }
std::string seed_of(const Packing& p) { return std::to_string(p.seed % 100); }

/// How far z* is missed, and how often by more than is stated.
struct Misses {
  Errors by_recipe;
  Errors carried_to_next; ///< pressure of the specimen
  Coverage of_recipes;
  Coverage of_ways; ///< carried to all larger pressures
};

void print(const std::string& what, const Misses& m) {
  std::printf(
      "  %-28s %4d | z* rms %.3f mean %+.3f worst %.2f | within one %3.0f %% two %3.0f %% | carried rms "
      "%.3f worst %.2f | %4d carried anywhere, within one %3.0f %% two %3.0f %%\n",
      what.c_str(), m.by_recipe.count(), m.by_recipe.rms(), m.by_recipe.mean(), m.by_recipe.worst(),
      100 * m.of_recipes.one(), 100 * m.of_recipes.two(), m.carried_to_next.rms(), m.carried_to_next.worst(),
      m.of_ways.count, 100 * m.of_ways.one(), 100 * m.of_ways.two());
}

double carrying_error(const Step& way, const Coefficients& c) {
  return by_carrying(*way.first, *way.later, c) - way.later->mechanical_coordination;
}

/// \param    stated   whose scatters are held against the errors of the coefficients
void judge(const std::vector<Packing>& packings, const Coefficients& c, const Result& stated,
           Misses& misses) {
  for (const Packing& p : packings) {
    const double error = by_recipe(p, c) - p.mechanical_coordination;
    misses.by_recipe.add(error);
    misses.of_recipes.add(error, on_densest_line(p) ? stated.line_scatter : stated.friction_scatter);
  }
  for (const Step& step : steps_of(packings))
    misses.carried_to_next.add(carrying_error(step, c));
  for (const Step& way : ways_of(packings))
    misses.of_ways.add(carrying_error(way, c), stated.carried_scatter * root_of(way));
}

/// Everything of one label left out of the fit in turn.
Misses left_out(const std::vector<Packing>& packings, const Result& stated, const std::string& title,
                const Label& label) {
  std::set<std::string> values;
  for (const Packing& p : packings)
    values.insert(label(p));
  Misses all;
  for (const std::string& value : values) {
    std::vector<Packing> kept, left;
    for (const Packing& p : packings)
      (label(p) == value ? left : kept).push_back(p);
    const Coefficients c = fit_contacts(kept).coefficients;
    Misses here;
    judge(left, c, stated, here);
    print("without " + value, here);
    judge(left, c, stated, all);
  }
  print("left out by " + title, all);
  return all;
}

// ---- the library ----

/// How many packings of friction up to 0.5 lie between loosest and densest, each less or more two errors.
double share_in_range(const std::vector<Packing>& packings) {
  constexpr double most_friction = 0.5;
  int inside = 0, count = 0;
  for (const Packing& p : packings) {
    if (p.friction_coefficient > most_friction)
      continue;
    ++count;
    const ContactPrior prior = granum::effective::contact_prior(p.state);
    const double z = p.mechanical_coordination, error = 2 * prior.coordination_error;
    const bool holds = z > prior.loosest.mechanical_coordination_number - error &&
                       z < prior.densest.mechanical_coordination_number + error;
    inside += holds;
    if (!holds)
      std::printf("  outside: %s #%d at %g kPa, e %.3f: z* %.2f, range %.2f to %.2f +- %.2f\n",
                  p.recipe.c_str(), p.seed, p.pressure / 1e3, p.state.void_ratio, z,
                  prior.loosest.mechanical_coordination_number, prior.densest.mechanical_coordination_number,
                  error);
  }
  return static_cast<double>(inside) / count;
}

/// Rounding aside, the library is the kernel: z* of a recipe at the measured state.
double worst_difference_of_library(const std::vector<Packing>& packings) {
  double worst = 0;
  for (const Packing& p : packings) {
    const Preparation preparation = on_densest_line(p)
                                        ? Preparation{.kind = Preparation::Kind::dense}
                                        : Preparation{.kind = Preparation::Kind::friction,
                                                      .friction_coefficient = p.friction_coefficient};
    const ContactPrior prior = granum::effective::contact_prior(p.state, preparation);
    Packing at_prior = p;
    at_prior.relative_overlap = prior.relative_overlap;
    worst = std::max(worst, std::abs(prior.middle.mechanical_coordination_number -
                                     by_recipe<double>(at_prior, kernel::contact_coefficients)));
  }
  return worst;
}

/// Loading to 3 MPa and unloading, carried from the first state on.
Errors cycles(const std::vector<Packing>& packings) {
  std::map<std::string, const Packing*> first;
  Errors errors;
  for (const Packing& p : packings)
    if (p.preparation == "cycle") {
      const auto [start, fresh] = first.try_emplace(p.specimen, &p);
      if (!fresh)
        errors.add(by_carrying<double>(*start->second, p, kernel::contact_coefficients) -
                   p.mechanical_coordination);
    }
  return errors;
}

// ---- packings of others ----

struct Published {
  std::string state;
  double void_ratio = 0, coordination = 0, pressure = 0;
  std::string preparation;
};

std::vector<Published> read_published(const std::string& path) {
  const granum::io::CsvTable table = granum::io::read_csv(path);
  std::vector<Published> states;
  for (std::size_t k = 0; k < table.row_count(); ++k) {
    const std::vector<std::string>& f = table.fields(k);
    states.push_back({f.at(0), std::stod(f.at(1)), std::stod(f.at(2)), std::stod(f.at(3)), f.at(4)});
  }
  return states;
}

/// Whether each lies in the range of its void ratio, and, where its recipe is told, by how much z* is missed.
bool compare_published(const std::vector<Published>& states) {
  bool all_inside = true;
  std::printf("states of others: z*, the range of the void ratio, and by the recipe\n");
  for (const Published& s : states) {
    const State state{
        .law = granum::contact::PowerLaw::sphere({.shear_modulus = 30e9, .poisson_ratio = 0.3}, 0.5e-3),
        .radius = 0.5e-3,
        .void_ratio = s.void_ratio,
        .stress_v = s.pressure,
        .stress_h = s.pressure};
    const ContactPrior range = granum::effective::contact_prior(state);
    const double error = 2 * range.coordination_error;
    const double low = range.loosest.mechanical_coordination_number - error;
    const double high = range.densest.mechanical_coordination_number + error;
    const bool inside = s.coordination > low && s.coordination < high;
    all_inside &= inside;
    std::printf("  %-40s e %.3f z* %.2f | %.2f to %.2f %s", s.state.c_str(), s.void_ratio, s.coordination,
                low, high, inside ? "inside" : "OUTSIDE");
    if (!s.preparation.empty()) {
      const double z =
          granum::effective::contact_prior(state, granum::effective::preparation_of(s.preparation))
              .middle.mechanical_coordination_number;
      std::printf(" | %s %.2f (%+.2f)", s.preparation.c_str(), z, z - s.coordination);
    }
    std::printf("\n");
  }
  return all_inside;
}

// ---- check ----

template <std::size_t n>
bool same(const std::array<double, n>& fitted, const std::array<double, n>& recorded) {
  for (std::size_t k = 0; k < n; ++k)
    if (!(std::abs(fitted[k] - recorded[k]) <= 1e-4 * std::abs(recorded[k])))
      return false;
  return true;
}
bool same(double fitted, double recorded) { return std::abs(fitted / recorded - 1) < 1e-4; }

int check(const std::vector<Packing>& all, const std::vector<Packing>& packings,
          const std::vector<Packing>& other_shape, const Result& result, const densest::Files& above,
          const densest::Result& of_densest, char** files) {
  Misses fitted;
  judge(packings, result.contacts.coefficients, result, fitted);
  print("all, fitted", fitted);
  std::printf("  scatter: line %.3f, friction %.3f, carried %.3f, ln of rattlers %.2f\n", result.line_scatter,
              result.friction_scatter, result.carried_scatter, result.rattler_scatter);
  const Misses by_preparation = left_out(packings, result, "preparation", preparation_of);
  const Misses by_contact = left_out(packings, result, "contact", contact_of);
  const Misses by_seed = left_out(packings, result, "seed", seed_of);
  Misses by_other_shape;
  judge(other_shape, result.contacts.coefficients, result, by_other_shape);
  print("a shape that no fit has seen", by_other_shape);
  const Errors unloaded = cycles(all);
  std::printf("  cycles to 3 MPa and back: rms %.3f worst %.2f\n", unloaded.rms(), unloaded.worst());
  const double in_range = share_in_range(packings);
  const bool published_inside = compare_published(read_published(files[0]));

  Claims claims;
  claims.require(same(result.contacts.coefficients, kernel::contact_coefficients) &&
                     same(result.rattlers.coefficients, kernel::rattler_coefficients) &&
                     same(result.line_scatter, kernel::line_scatter) &&
                     same(result.friction_scatter, kernel::friction_scatter) &&
                     same(result.carried_scatter, kernel::carried_scatter) &&
                     same(result.rattler_scatter, kernel::rattler_scatter) &&
                     same(of_densest.shift(), kernel::grain_shift) &&
                     same(of_densest.recipe_scatter, kernel::above_densest_scatter) &&
                     same(of_densest.size_scatter, kernel::above_densest_size_scatter) &&
                     same(of_densest.code_scatter, kernel::above_densest_code_scatter),
                 "the numbers of the library are those of these data");
  claims.require(worst_difference_of_library(packings) < 0.01,
                 "the library finds the measured overlaps, and so z* of the recipes, within 0.01");
  for (const Misses* m : {&by_preparation, &by_contact, &by_seed}) {
    for (const Coverage* c : {&m->of_recipes, &m->of_ways}) {
      const std::string what = c == &m->of_ways ? "carried z* of packings" : "packings";
      claims.require(c->one() >= 0.55, "at least 55 % of " + what + " left out within one stated error");
      claims.require(c->two() >= 0.90, "at least 90 % within two");
    }
    claims.require(m->carried_to_next.rms() < 0.08, "z* carried to the next pressure: 0.08 rms");
  }
  claims.require(by_other_shape.by_recipe.rms() < 2 * result.friction_scatter,
                 "alpha = 4 within two errors, rms");
  claims.require(unloaded.rms() < 0.15, "cycles retrace within 0.15 rms");
  claims.require(in_range >= 0.95,
                 "95 % of packings of friction up to 0.5 in the range of their void ratio (" +
                     number(100 * in_range, 3) + " %)");
  claims.require(published_inside, "so are those of others");
  unfitted::check_rough(files[1], files[2], claims);
  unfitted::check_verify(files[3], claims);
  densest::check(above, {.third_seed = files[4], .gradations = files[5], .verify = {files[3], files[6]}},
                 claims);
  return claims.failed() == 0 ? 0 : 1;
}

} // namespace

int main(int argc, char** argv) {
  const std::string_view command = argc > 1 ? argv[1] : "";
  if (!(command == "picture" && argc == 3) && !(command == "coefficients" && argc == 5) &&
      !(command == "check" && argc == 12)) {
    std::fprintf(stderr,
                 "usage: %s picture states.csv, or coefficients states.csv unequal.csv codes.csv, or check "
                 "states.csv unequal.csv codes.csv published.csv rough.csv ../infer/states.csv "
                 "../verify_default/states.csv third_seed.csv gradations.csv verify.csv\n",
                 argv[0]);
    return 2;
  }
  try {
    const std::vector<Packing> all = relaxation::read_packings(argv[2]);
    std::vector<Packing> packings, other_shape;
    for (const Packing& p : all)
      if (usable(p))
        (p.contact == relaxation::unfitted_contact ? other_shape : packings).push_back(p);
    if (command == "picture") {
      std::fputs(picture(packings).c_str(), stdout);
      return 0;
    }
    const densest::Files above = densest::read(packings, argv[3], argv[4]);
    const Result result = fit_everything(packings);
    const densest::Result of_densest = densest::fit(above.equal, above.unequal, above.codes, result);
    if (command == "coefficients")
      print_coefficients(result, of_densest);
    else
      return check(all, packings, other_shape, result, above, of_densest, argv + 5);
    return 0;
  } catch (const std::exception& error) {
    std::fprintf(stderr, "%s\n", error.what());
    return 1;
  }
}

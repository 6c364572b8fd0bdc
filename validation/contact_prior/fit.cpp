// SPDX-License-Identifier: GPL-3.0-or-later
// Fits the contact prior to the packings that validation/relaxation recorded.
//
//     contact_prior_fit coefficients states.csv unequal.csv codes.csv
//                                      writes the numbers of src/effective/contact_prior_coefficients.hpp
//     contact_prior_fit check states.csv unequal.csv codes.csv published.csv rough.csv ../infer/states.csv
//                             ../verify_default/states.csv third_seed.csv gradations.csv verify.csv
//                                      fits again, compares with that file, and asks whether recipes left
//                                      out, packings of others, rough ones and verify's lie where it says
//     contact_prior_fit picture states.csv
//                                      SVG: z* over the void ratio, and of packings beside the prior
#include <granum/contact/power_law.hpp>
#include <granum/effective/contact_prior.hpp>

#include "../common.hpp"
#include "../constants.hpp"
#include "calibration.hpp"
#include "densest.hpp"
#include "effective/contact_prior_coefficients.hpp"
#include "picture.hpp"
#include "unfitted.hpp"

namespace {

using namespace contact_prior;
using granum::effective::ContactPrior;
using granum::effective::Preparation;
using granum::effective::State;
using Coefficients = Numbers<double, size>;

// ---- coefficients ----

const std::string header = HEADERS "/contact_prior_coefficients.hpp"; // of the library

/// In the comments standard errors.
std::vector<Constant> constants_of(const Result& r, const densest::Result& d) {
  const auto errors = [](const auto& fit) {
    std::vector<double> all;
    for (std::size_t k = 0; k < fit.coefficients.size(); ++k)
      all.push_back(fit.error(k));
    return all;
  };
  return {{"Standard errors: ", errors(r.contacts), 2},
          {"contact_coefficients{", joined(r.contacts.coefficients), 8},
          {"Standard errors: ", errors(r.rattlers), 2},
          {"rattler_coefficients{", joined(r.rattlers.coefficients), 8},
          {"line_scatter = ", {r.line_scatter}, 5},
          {"friction_scatter = ", {r.friction_scatter}, 5},
          {"carried_scatter = ", {r.carried_scatter}, 5},
          {"rattler_scatter = ", {r.rattler_scatter}, 5},
          {"Standard errors of the shift: ", joined(errors(d.shape), errors(d.sizes)), 2},
          {"grain_shift{", joined(d.shape.coefficients, d.sizes.coefficients), 5},
          {"above_densest_scatter = ", {d.recipe_scatter}, 5},
          {"above_densest_size_scatter = ", {d.size_scatter}, 5},
          {"above_densest_code_scatter = ", {d.code_scatter}, 5}};
}

// ---- errors ----

/// How far z* is missed, and how often by more than is stated.
struct Misses {
  Errors by_recipe;
  Errors to_next;  ///< carried to the next pressure of the specimen
  Errors anywhere; ///< carried to all larger ones
};

/// \param    stated   whose scatters are held against the errors of the coefficients
void judge(const std::vector<Packing>& packings, const Coefficients& c, const Result& stated,
           Misses& misses) {
  for (const Packing& p : packings)
    misses.by_recipe.add(by_recipe(p, c) - p.mechanical_coordination,
                         on_densest_line(p) ? stated.line_scatter : stated.friction_scatter);
  for (const Step& step : steps_of(packings))
    misses.to_next.add(carrying_error(step, c));
  for (const Step& way : ways_of(packings))
    misses.anywhere.add(carrying_error(way, c), stated.carried_scatter * root_of(way));
}

void print(const std::string& what, const Misses& m) {
  print_errors("  " + what,
               {{"z*", &m.by_recipe}, {"carried to the next", &m.to_next}, {"carried anywhere", &m.anywhere}},
               1);
}

/// Packings of a fit: errors printed.
Misses judged(const std::string& what, const std::vector<Packing>& packings, const Result& result) {
  Misses misses;
  judge(packings, result.contacts.coefficients, result, misses);
  print(what, misses);
  return misses;
}

void check_left_out(const std::vector<Packing>& packings, const Result& stated, Claims& claims) {
  const std::pair<const char*, Label> labels[] = {
      {"preparation", preparation_of},
      {"contact", [](const Packing& p) { return p.contact; }},
      {"seed", [](const Packing& p) { return std::to_string(p.seed % 100); }}};
  for (const auto& [title, label] : labels) {
    Misses all;
    each_left_out(packings, label, [&](const std::string& value, const auto& left, const auto& c) {
      Misses here;
      judge(left, c, stated, here);
      print("without " + value, here);
      judge(left, c, stated, all);
    });
    print(std::string("left out by ") + title, all);
    claims.require_covered(all.by_recipe, "packings left out");
    claims.require_covered(all.anywhere, "carried z* of packings left out");
    claims.require(all.to_next.count() > 0 && all.to_next.rms() < 0.08,
                   "z* carried to the next pressure: 0.08 rms");
  }
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
Errors differences_of_library(const std::vector<Packing>& packings) {
  Errors differences;
  for (const Packing& p : packings) {
    const ContactPrior prior = granum::effective::contact_prior(
        p.state, unfitted::preparation(on_densest_line(p), p.friction_coefficient));
    Packing at_prior = p;
    at_prior.relative_overlap = prior.relative_overlap;
    differences.add(prior.middle.mechanical_coordination_number -
                    by_recipe<double>(at_prior, kernel::contact_coefficients));
  }
  return differences;
}

/// Loading to 3 MPa and unloading, carried from the first state on.
Errors cycles(const std::vector<Packing>& packings) {
  std::map<std::string, const Packing*> first;
  Errors errors;
  for (const Packing& p : packings)
    if (p.preparation == "cycle") {
      const auto [start, fresh] = first.try_emplace(p.specimen, &p);
      if (!fresh)
        errors.add(carrying_error({start->second, &p}, kernel::contact_coefficients));
    }
  return errors;
}

/// Whether each published state lies in the range of its void ratio, and, where its recipe is known, by how
/// much z* is missed.
bool compare_published(const std::string& path) {
  bool all_inside = true;
  std::printf("states of others: z*, the range of the void ratio, and by the recipe\n");
  for (const Entry& s : read_record(path)) {
    const State state{
        .law = granum::contact::PowerLaw::sphere({.shear_modulus = 30e9, .poisson_ratio = 0.3}, 0.5e-3),
        .radius = 0.5e-3,
        .void_ratio = s("void_ratio"),
        .stress_v = s("pressure_Pa"),
        .stress_h = s("pressure_Pa")};
    const ContactPrior range = granum::effective::contact_prior(state);
    const double error = 2 * range.coordination_error;
    const double low = range.loosest.mechanical_coordination_number - error;
    const double high = range.densest.mechanical_coordination_number + error;
    const bool inside = s("z_star") > low && s("z_star") < high;
    all_inside &= inside;
    std::printf("  %-40s e %.3f z* %.2f | %.2f to %.2f %s", s.text("state").c_str(), s("void_ratio"),
                s("z_star"), low, high, inside ? "inside" : "OUTSIDE");
    if (const std::string& preparation = s.text("preparation"); !preparation.empty()) {
      const double z = granum::effective::contact_prior(state, granum::effective::preparation_of(preparation))
                           .middle.mechanical_coordination_number;
      std::printf(" | %s %.2f (%+.2f)", preparation.c_str(), z, z - s("z_star"));
    }
    std::printf("\n");
  }
  return all_inside;
}

// ---- check ----

/// Packings, and the fits to them.
struct Fits {
  std::vector<Packing> all = {}, packings = {}, other_shape = {};
  densest::Files above = {};
  Result result = {};
  densest::Result of_densest = {};

  /// \param    files   states.csv, or with the fits states.csv unequal.csv codes.csv
  explicit Fits(const Arguments& files) : all(relaxation::read_packings(files[0])) {
    for (const Packing& p : all)
      if (usable(p))
        (p.contact == relaxation::unfitted_contact ? other_shape : packings).push_back(p);
    if (files.size() == 1)
      return;
    above = densest::read(packings, files[1], files[2]);
    result = fit_everything(packings);
    of_densest = densest::fit(above.equal, above.unequal, above.codes, result);
  }
};

/// \param    files   states.csv unequal.csv codes.csv published.csv rough.csv infer/states.csv
///                   verify_default/states.csv third_seed.csv gradations.csv verify.csv
int check(const Arguments& files) {
  const Fits fits(files);
  const Result& result = fits.result;
  Claims claims;
  const std::string other = first_other(header, constants_of(result, fits.of_densest), 1e-4);
  claims.require(other.empty(), "the numbers of the library are those of these data" +
                                    (other.empty() ? "" : ", but not those after: " + other));
  judged("all, fitted", fits.packings, result);
  std::printf("  scatter: line %.3f, friction %.3f, carried %.3f, ln of rattlers %.2f\n", result.line_scatter,
              result.friction_scatter, result.carried_scatter, result.rattler_scatter);
  check_left_out(fits.packings, result, claims);
  const Misses by_other_shape = judged("a shape that no fit has seen", fits.other_shape, result);
  const Errors unloaded = cycles(fits.all);
  print_errors("  cycles to 3 MPa and back", {{"z*", &unloaded}}, 1);
  const double in_range = share_in_range(fits.packings);
  claims.require(differences_of_library(fits.packings).worst() < 0.01,
                 "the library finds the measured overlaps, and so z* of the recipes, within 0.01");
  claims.require(by_other_shape.by_recipe.rms() < 2 * result.friction_scatter,
                 "alpha = 4 within two errors, rms");
  claims.require(unloaded.rms() < 0.15, "cycles retrace within 0.15 rms");
  claims.require(in_range >= 0.95,
                 granum::detail::formatted("95 %% of packings of friction up to 0.5 in the range "
                                           "of their void ratio (%.1f %%)",
                                           100 * in_range));
  claims.require(compare_published(files[3]), "states of others lie in the range of their void ratio");
  unfitted::check_rough(files[4], files[5], claims);
  unfitted::check_verify(files[6], claims);
  densest::check(fits.above, {files[7], files[8], files[6], files[9]}, claims);
  return claims.exit_code();
}

} // namespace

int main(int argc, char** argv) {
  return program(argc, argv,
                 {{"check",
                   "states.csv unequal.csv codes.csv published.csv rough.csv ../infer/states.csv "
                   "../verify_default/states.csv third_seed.csv gradations.csv verify.csv",
                   check},
                  {"coefficients", "states.csv unequal.csv codes.csv",
                   [](const Arguments& files) {
                     const Fits fits(files);
                     write_header(header, constants_of(fits.result, fits.of_densest));
                   }},
                  {"picture", "states.csv", [](const Arguments& files) {
                     std::fputs(picture(Fits(files).packings).c_str(), stdout);
                   }}});
}

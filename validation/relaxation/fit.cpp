// SPDX-License-Identifier: GPL-3.0-or-later
// Fits the relaxation factors to the recorded networks.
//
//     relaxation_fit coefficients FILES   writes src/effective/relaxation_coefficients.hpp
//     relaxation_fit check FILES          fits again, compares with that file, and asks whether errors, also
//                                         on packings left out of the fit, are in reach
//     relaxation_fit picture FILES        SVG: factors of the networks and of the library
//     relaxation_fit besides FILES        what the void ratio and the stretch do, and errors by z*
//
// FILES: states.csv unequal.csv gradations.csv codes.csv exponents.csv rough.csv
#include <cstdio>
#include <cstring>
#include <exception>
#include <iterator>
#include <set>

#include <granum/effective/relaxation.hpp>

#include "../claims.hpp"
#include "besides.hpp"
#include "calibration.hpp"
#include "coverage.hpp"
#include "exponents.hpp"
#include "factor_errors.hpp"
#include "gradations.hpp"
#include "library_errors.hpp"
#include "picture.hpp"
#include "reading.hpp"
#include "size_coverage.hpp"
#include "uneven_coverage.hpp"

namespace {

using namespace relaxation;

// ---- coefficients ----

std::string number(double value, int digits) {
  char text[32];
  std::snprintf(text, sizeof text, "%.*g", digits, value);
  return text;
}

void print_row(const char* open, int digits, const double* values, int count, const char* close) {
  std::printf("%s", open);
  for (int k = 0; k < count; ++k)
    std::printf("%s%s", k > 0 ? ", " : "", number(values[k], digits).c_str());
  std::printf("%s", close);
}

template <int n>
void print_fit(const char* name, const Fit<n>& fit) {
  std::printf("inline constexpr std::array<double, %d> %s_coefficients{\n", n, name);
  print_row("    ", 9, fit.coefficients.data(), n, "};\n");
  std::printf("inline constexpr double %s_covariance[%d][%d] = {\n", name, n, n);
  for (int row = 0; row < n; ++row) {
    const Eigen::Matrix<double, n, 1> values = fit.covariance.col(row);
    print_row("    {", 5, values.data(), n, row + 1 < n ? "},\n" : "}};\n");
  }
}

void print_gaps(const char* name, const ClosingGaps& gaps) {
  const auto& g = gaps.growth;
  const auto& x = gaps.rattlers;
  double values[7], errors[6];
  for (int k = 0; k < 6; ++k) {
    const auto i = static_cast<std::size_t>(k);
    values[k] = k < 4 ? g.coefficients[i] : x.coefficients[i - 4];
    errors[k] = std::sqrt(k < 4 ? g.covariance(k, k) : x.covariance(k - 4, k - 4));
  }
  values[6] = gaps.scatter;
  print_row("// ", 2, errors, 6, "\n");
  std::printf("inline constexpr std::array<double, 7> %s_gaps{\n", name);
  print_row("    ", 9, values, 7, "};\n");
}

void print_scatter(const char* name, const ScatterParts& parts, const Scatter& sizes) {
  std::printf("inline constexpr FactorScatter %s{\n    {%.9g, %.9g}, {%.9g, %.9g}, {%.9g, %.9g}};\n", name,
              parts.recipes.base, parts.recipes.gain, parts.packings.base, parts.packings.gain, sizes.base,
              sizes.gain);
}

void print_gain(const char* name, const KnownForces& known) {
  std::printf("inline constexpr UnevennessCoefficients<double> %s_gain{\n", name);
  print_row("    ", 9, known.gain.data(), 7, "};\n");
}

void print_beyond(const Beyond& b) {
  std::printf(
      "/// Where the packings of the fit end: what G loses by b = 1, and the power of what K loses by the "
      "scatter of\n"
      "/// forces; the further errors of G and K there, over 1 - h. Of power laws, of rough spheres.\n");
  const struct {
    const char* name;
    const kernel::GoingOn& fit;
  } kinds[] = {{"power_law", b.power_laws}, {"rough", b.rough}};
  for (const auto& [name, fit] : kinds)
    std::printf("inline constexpr std::array<double, 2> %s_losses{%.9g, %.9g};\n"
                "inline constexpr std::array<double, 2> %s_errors{%.9g, %.9g};\n",
                name, fit.shear_loss, fit.scatter_power, name, fit.errors[0], fit.errors[1]);
  std::printf("\n");
}

void print_coefficients(const Result& r) {
  std::printf(
      "// SPDX-License-Identifier: GPL-3.0-or-later\n"
      "// Written by `relaxation_fit coefficients` in validation/relaxation, whose README says from which "
      "files; the\n"
      "// test \"validation: relaxation\" fits them again and compares. Not to be edited by hand.\n"
      "// clang-format off\n#pragma once\n\n#include <array>\n\nnamespace granum::effective::kernel {\n\n");
  const struct {
    const char* name;
    int size;
  } lists[] = {{"Shear", shear_size}, {"Bulk", bulk_size}, {"Stretch", stretch_size}};
  for (const auto& [name, size] : lists)
    std::printf("template <class T>\nusing %sCoefficients = std::array<T, %d>;\n", name, size);
  std::printf("template <class T>\nusing UnevennessCoefficients = std::array<T, 7>;\n"
              "template <class T>\nusing DenseUnevenness = std::array<T, 5>;\n");
  std::printf("\n");
  print_fit("shear", r.shear);
  print_fit("bulk", r.bulk);
  print_fit("stretch", r.stretch);
  std::printf("\n"
              "/// Coefficients of gain_by_unevenness, for G and K.\n");
  print_gain("shear", r.shear_known);
  print_gain("bulk", r.bulk_known);
  std::printf("/// Coefficients of unevenness_of_dense, and the scatter about it: of equal grains, of others "
              "over the\n"
              "/// root of the relative variance of the lengths of branches.\n"
              "inline constexpr DenseUnevenness<double> dense_unevenness{\n");
  print_row("    ", 9, r.dense_forces.coefficients.data(), 5, "};\n");
  std::printf("inline constexpr std::array<double, 2> dense_unevenness_scatter{%.9g, %.9g};\n",
              r.dense_forces.scatter[0], r.dense_forces.scatter[1]);
  std::printf(
      "/// Relative scatter about a factor: base, and gain times d ln/dz* (shear) or d ln/d ln r (bulk), in\n"
      "/// quadrature; of recipes about the curve, of the packings of one recipe, and what unequal grains "
      "add: of\n"
      "/// G over the root of the relative variance of the lengths of branches, of K over "
      "bulk_size_measure.\n"
      "struct Scatter {\n  double base;\n  double gain;\n};\n"
      "struct FactorScatter {\n  Scatter recipes, packings, sizes;\n};\n");
  print_scatter("shear_scatter", r.shear_scatter, r.sizes.shear);
  print_scatter("bulk_scatter", r.bulk_scatter, {r.sizes.bulk, 0});
  std::printf("/// The same where the unevenness of forces is known.\n");
  print_scatter("shear_scatter_known", r.shear_known.scatter, r.shear_known.sizes);
  print_scatter("bulk_scatter_known", r.bulk_known.scatter, r.bulk_known.sizes);
  std::printf("/// Shift of z* in G at the isostatic point and its standard error, over the relative "
              "variance of the\n"
              "/// lengths of branches.\n"
              "inline constexpr double size_shift = %.9g;\n"
              "inline constexpr double size_shift_error = %.9g;\n"
              "/// What unequal grains lose of K, and its standard error.\n"
              "inline constexpr double size_loss = %.9g;\n"
              "inline constexpr double size_loss_error = %.9g;\n",
              r.sizes.shift, r.sizes.shift_error, r.sizes.loss, r.sizes.loss_error);
  std::printf("/// Scatter of K between codes: this times the looseness.\n"
              "inline constexpr double bulk_codes = %.9g;\n",
              r.bulk_codes);
  std::printf("/// Scatter of ln C33/C11 over ln of the stretch.\n");
  std::printf("inline constexpr double stretch_scatter = %.9g;\n", r.stretch_scatter);
  std::printf(
      "/// Further errors under unequal stresses, over |ln(stress_v/stress_h)|.\n"
      "inline constexpr double shear_by_stress = %.9g;\ninline constexpr double bulk_by_stress = %.9g;\n\n",
      r.shear_by_stress, r.bulk_by_stress);
  print_beyond(r.beyond);
  std::printf("/// z_0, A, q, s, c, k and the scatter of z* of a ClosingGapLaw; in the comments the standard "
              "errors.\n");
  print_gaps("dense", r.dense);
  print_gaps("loose", r.loose);
  std::printf("\n} // namespace granum::effective::kernel\n");
}

// ---- errors ----

using Label = std::function<std::string(const Packing&)>;

/// Every value of a label left out of the fit in turn, and the errors on what was left out.
FactorErrors cross_validate(const std::vector<Packing>& packings, const std::string& title,
                            const Label& label) {
  std::set<std::string> values;
  for (const Packing& p : packings)
    if (p.isotropic())
      values.insert(label(p));
  FactorErrors all;
  for (const std::string& value : values) {
    const Choice kept = [&](const Packing& p) { return label(p) != value; };
    const ShearFit shear = fit_shear(packings, kept);
    const BulkFit bulk = fit_bulk(packings, kept);
    const FactorErrors left_out = errors_of(packings, shear, bulk, lowest_usual_ratio, 1,
                                            [&](const Packing& p) { return label(p) == value; });
    print_errors("  without " + title + " " + value, left_out);
    all.shear.add(left_out.shear);
    all.bulk.add(left_out.bulk);
  }
  print_errors("left out by " + title + ", together", all);
  return all;
}

// ---- check ----

template <std::size_t n>
bool same(const std::array<double, n>& fitted, const std::array<double, n>& recorded) {
  for (std::size_t k = 0; k < n; ++k)
    if (!(std::abs(fitted[k] - recorded[k]) <= 1e-5 * std::abs(recorded[k])))
      return false;
  return true;
}

template <int n, std::size_t m>
bool same(const Eigen::Matrix<double, n, n>& fitted, const double (&recorded)[m][m]) {
  const Eigen::Map<const Eigen::Matrix<double, n, n>> matrix(&recorded[0][0]);
  const Eigen::Matrix<double, n, 1> errors = matrix.diagonal().cwiseSqrt();
  // Relative to the standard errors: entries near 0 have no digits of their own.
  return (fitted - matrix).cwiseQuotient(errors * errors.transpose()).cwiseAbs().maxCoeff() < 1e-3;
}

bool same(const SizeEffect& fitted) {
  return same(std::array{fitted.shift, fitted.shift_error, fitted.loss, fitted.loss_error, fitted.shear.base,
                         fitted.shear.gain, fitted.bulk},
              std::array{kernel::size_shift, kernel::size_shift_error, kernel::size_loss,
                         kernel::size_loss_error, kernel::shear_scatter.sizes.base,
                         kernel::shear_scatter.sizes.gain, kernel::bulk_scatter.sizes.base});
}

bool same(const KnownForces& fitted, const std::array<double, 7>& gain,
          const kernel::FactorScatter& scatter) {
  const auto& [recipes, packings] = fitted.scatter;
  return same(fitted.gain, gain) &&
         same(std::array{recipes.base, recipes.gain, packings.base, packings.gain, fitted.sizes.base,
                         fitted.sizes.gain},
              std::array{scatter.recipes.base, scatter.recipes.gain, scatter.packings.base,
                         scatter.packings.gain, scatter.sizes.base, scatter.sizes.gain});
}

/// Largest difference between z* and C_n/(1 - x_0), relative.
double worst_rattler_estimate(const std::vector<Packing>& packings) {
  double worst = 0;
  for (const Packing& p : packings) {
    const double z =
        granum::effective::mechanical_coordination_number(*p.state.coordination_number, p.rattler_fraction);
    worst = std::max(worst, std::abs(z / p.mechanical_coordination - 1));
  }
  return worst;
}

/// Packings of a shape that the fit never sees.
FactorErrors errors_of_unfitted(const std::vector<Packing>& packings, const Result& result) {
  const FactorErrors errors =
      errors_of(packings, result.shear, result.bulk, lowest_usual_ratio, 1, everything);
  print_errors("a shape that no fit has seen: " + (packings.empty() ? "none" : packings.front().contact),
               errors);
  return errors;
}

void claim_coverage(Claims& claims, const Coverage& c, double two, const char* of) {
  claims.require(c.one() >= 0.55 && c.one() <= 0.80,
                 std::string("55 to 80 % within one stated error: ") + of);
  claims.require(c.two() >= two, "at least " + number(100 * two, 2) + " % within two: " + of);
}

/// Whether unequal grains are what is stated of them.
void check_sizes(const std::vector<Packing>& unequal, const std::vector<Packing>& gradations,
                 const Result& result, Claims& claims) {
  const EqualFit equal = equal_fit(result);
  std::printf("unequal grains: z* shifted by %.3f +- %.3f times the relative variance of branches\n",
              result.sizes.shift, result.sizes.shift_error);
  const auto sizes = [](const Packing& p) { return p.sizes; };
  const auto preparation = [](const Packing& p) { return unsheared(p.preparation); };
  const auto by_sizes = coverage_of_left_out_sizes(unequal, gradations, equal, sizes, unequal);
  const auto by_preparation = coverage_of_left_out_sizes(unequal, gradations, equal, preparation, unequal);
  std::printf("the gradations\n");
  const auto gradations_by_sizes = coverage_of_left_out_sizes(unequal, gradations, equal, sizes, gradations);
  const auto gradations_by_preparation =
      coverage_of_left_out_sizes(unequal, gradations, equal, preparation, gradations);
  print_coverage(
      "equal grains, as small specimens",
      coverage_of(unequal, equal, result.sizes, [](const Packing& p) { return p.sizes == "equal"; }));
  print_errors("relaxed(), unequal grains, isotropic states", library_errors(unequal, is_isotropic));
  claims.require(same(result.sizes), "what the library knows of unequal grains is what these data say");
  claim_coverage(claims, by_preparation.shear, 0.90, "G, preparations of unequal grains left out");
  claim_coverage(claims, by_preparation.bulk, 0.90, "K, preparations of unequal grains left out");
  claims.require(by_sizes.shear.two() >= 0.85 && by_sizes.bulk.two() >= 0.90,
                 "distributions left out: 85 % of G and 90 % of K within two stated errors");
  for (const CoverageOfBoth* left_out : {&gradations_by_sizes, &gradations_by_preparation})
    claims.require(left_out->bulk.two() >= 0.90,
                   "gradations and their preparations left out: 90 % of K within two stated errors");
}

/// Whether what is stated holds for packings of a code that no fit has seen.
void check_codes(const std::vector<Packing>& of_codes, const std::vector<Packing>& own, const Result& result,
                 Claims& claims) {
  std::printf("packings of other codes: K scatters by %.3f times the looseness\n", result.bulk_codes);
  const auto judge = [&](const char* what, const std::vector<Packing>& packings, const Choice& chosen) {
    const CoverageOfBoth c =
        coverage_of(packings, equal_fit(result), result.sizes, chosen, result.bulk_codes);
    print_coverage(what, c);
    return c;
  };
  judge("granum's own, equal grains", own, everything);
  judge("LAMMPS", of_codes, is_calibrating_code);
  const Choice unseen = [](const Packing& p) { return !is_calibrating_code(p); };
  const CoverageOfBoth yade = judge("YADE", of_codes, unseen);
  judge("- loose", of_codes, [&](const Packing& p) { return unseen(p) && p.mechanical_coordination < 5; });
  claims.require(same(std::array{result.bulk_codes}, std::array{kernel::bulk_codes}),
                 "what the library knows of other codes is what these data say");
  for (const Coverage* c : {&yade.shear, &yade.bulk})
    claims.require(c->one() >= 0.55 && c->two() >= 0.90,
                   "YADE: 55 % or more within one stated error, 90 % within two");
}

/// Networks with every b, and rough packings, of seeds that are never fitted.
void check_stiff_contacts(const std::vector<StiffNetwork>& stiff, const Result& result, Claims& claims) {
  const auto judge = [&](const std::string& what, const StiffChoice& chosen) {
    const StiffReport r = report_of(stiff, equal_fit(result), result.bulk_codes, result.beyond, chosen);
    print_report(what, r);
    return r;
  };
  std::set<double> exponents;
  std::set<std::string> recipes;
  for (const StiffNetwork& n : stiff) {
    if (!n.rough)
      exponents.insert(n.b);
    else if (!n.fitted())
      recipes.insert(n.recipe());
  }
  for (const bool fitted : {true, false}) {
    std::printf("networks with k_n ~ f^b, %s\n", fitted ? "fitted" : "of seeds never fitted");
    for (const double b : exponents)
      (void)judge("b = " + number(b, 3),
                  [&](const StiffNetwork& n) { return !n.rough && n.b == b && n.fitted() == fitted; });
  }
  std::printf("packings of rough grains, of seeds never fitted\n");
  for (const std::string& recipe : recipes)
    (void)judge(recipe,
                [&](const StiffNetwork& n) { return n.rough && !n.fitted() && n.recipe() == recipe; });
  const StiffReport fitted_rough =
      judge("fitted, together", [](const StiffNetwork& n) { return n.rough && n.fitted(); });
  const StiffReport rough = judge("together", [](const StiffNetwork& n) { return n.rough && !n.fitted(); });
  const StiffReport powers = judge("k_n ~ f^b beyond 1/2, together", [](const StiffNetwork& n) {
    return !n.rough && !n.fitted() && n.beyond();
  });
  (void)fitted_rough;
  const auto is = [](const kernel::GoingOn& fit, const kernel::GoingOn& recorded) {
    return same(std::array{fit.shear_loss, fit.scatter_power},
                std::array{recorded.shear_loss, recorded.scatter_power}) &&
           same(fit.errors, recorded.errors);
  };
  claims.require(is(result.beyond.power_laws, kernel::power_laws) &&
                     is(result.beyond.rough, kernel::rough_spheres),
                 "what the library knows beyond b = 1/2 and of rough spheres is what these data say");
  claims.require(rough.G.count() > 0 && rough.G.rms() < 0.03 && rough.K.rms() < 0.02,
                 "rough packings of seeds never fitted: G 3 % and K 2 % rms");
  for (const StiffReport* r : {&rough, &powers})
    for (const Coverage* c : {&r->coverage.shear, &r->coverage.bulk})
      claims.require(c->one() >= 0.55 && c->two() >= 0.90,
                     "beyond b = 1/2: 55 % or more within one stated error, 90 % within two");
}

/// Whether what is stated of packings whose forces are known holds.
void check_forces(const std::vector<Packing>& packings, const std::vector<Packing>& unequal,
                  const std::vector<Packing>& gradations, const std::vector<Packing>& of_codes,
                  Claims& claims) {
  std::printf("forces known: preparations left out of all fits, equal grains, then unequal ones\n");
  std::vector<Packing> of_sizes = unequal;
  std::erase_if(of_sizes, [](const Packing& p) { return p.sizes == "equal"; });
  for (const auto& [what, judged] :
       {std::pair{"equal", &packings}, std::pair{"unequal", &std::as_const(of_sizes)}}) {
    const CoverageOfBoth left_out = coverage_of_left_out_forces(packings, unequal, gradations, *judged);
    claim_coverage(claims, left_out.shear, 0.90, (std::string("G, forces known, ") + what).c_str());
    claims.require(left_out.bulk.one() >= 0.55 && left_out.bulk.two() >= 0.90,
                   std::string("K, forces known, ") + what + ": 55 % or more within one, 90 % within two");
  }
  for (const auto& [what, judged] :
       {std::pair{"unequal grains", &std::as_const(of_sizes)},
        std::pair{"gradations, which no gain was fitted to", &gradations},
        std::pair{"packings of other codes, which no gain was fitted to", &of_codes}})
    for (const auto& [given, forces] :
         {std::pair{"", Forces::unknown}, std::pair{", forces known", Forces::measured}}) {
      const LibraryErrors errors = library_errors(*judged, is_isotropic, 0, largest_overlap, forces);
      print_errors(std::string("relaxed(), ") + what + given, errors);
      print_coverage("- coverage", errors.coverage);
    }
}

int check(const std::vector<Packing>& packings, const std::vector<Packing>& unfitted,
          const std::vector<Packing>& unequal, const std::vector<Packing>& gradations,
          const std::vector<Packing>& of_codes, const std::vector<StiffNetwork>& stiff,
          const Result& result) {
  std::printf("errors of the factors by k_t/k_n, all isotropic states\n");
  for (const double r : {0.0, 0.03, 0.1, 0.3, 0.6, 0.918918918918919, 1.0})
    print_errors("  k_t/k_n = " + number(r, 3),
                 errors_of(packings, result.shear, result.bulk, r - 1e-6, r + 1e-6, everything));
  std::printf("errors on packings left out of the fit, k_t/k_n >= %.1f\n", lowest_usual_ratio);
  const FactorErrors by_contact =
      cross_validate(packings, "contact", [](const Packing& p) { return p.contact; });
  const FactorErrors by_preparation =
      cross_validate(packings, "preparation", [](const Packing& p) { return unsheared(p.preparation); });
  const FactorErrors by_seed =
      cross_validate(packings, "seed", [](const Packing& p) { return std::to_string(p.seed % 100); });
  const FactorErrors by_unfitted = errors_of_unfitted(unfitted, result);
  std::printf(
      "do errors of k_t/k_n >= %.1f, z* >= %.1f lie within what a fit to all other preparations states?\n",
      lowest_usual_ratio, lowest_usual_coordination);
  const CoverageOfBoth coverage = coverage_of_left_out(packings);
  const LibraryErrors isotropic = library_errors(packings, is_isotropic),
                      sheared = library_errors(packings, is_sheared);
  print_errors("relaxed(), isotropic states, overlap < 1 %", isotropic);
  print_errors("relaxed(), sheared states", sheared);
  const ExponentErrors exponents = compare_exponents(packings);
  const double rattler_error = worst_rattler_estimate(packings);

  Claims claims;
  claims.require(same(result.shear.coefficients, kernel::shear_coefficients) &&
                     same(result.bulk.coefficients, kernel::bulk_coefficients) &&
                     same(result.stretch.coefficients, kernel::stretch_coefficients),
                 "the coefficients of the library are those of these data");
  claims.require(same(result.shear.covariance, kernel::shear_covariance) &&
                     same(result.bulk.covariance, kernel::bulk_covariance) &&
                     same(result.stretch.covariance, kernel::stretch_covariance),
                 "so are their covariances");
  claims.require(same(result.shear_known, kernel::shear_gain, kernel::shear_scatter_known) &&
                     same(result.bulk_known, kernel::bulk_gain, kernel::bulk_scatter_known) &&
                     same(result.dense_forces.coefficients, kernel::dense_unevenness) &&
                     same(result.dense_forces.scatter, kernel::dense_unevenness_scatter),
                 "what the library makes of uneven forces is what these data say");
  for (const FactorErrors* e : {&by_contact, &by_preparation, &by_seed, &by_unfitted}) {
    claims.require(e->shear.count() > 0 && e->shear.rms() < 0.04, "G of packings left out: 4 % rms");
    Claims::aim(e->shear.worst() < 0.10,
                "G of packings left out: 10 % at worst (" + number(100 * e->shear.worst(), 2) + " %)");
  }
  // Not claimed by contact: flat ones (b = 0) are the end of the range, and K does not extrapolate to them.
  for (const FactorErrors* e : {&by_preparation, &by_seed, &by_unfitted})
    claims.require(e->bulk.rms() < 0.02, "K of packings left out: 2 % rms");
  claims.require(isotropic.beyond_two() < 0.1 * 2 * isotropic.G.count(),
                 "one in ten G and K at most is beyond two errors");
  for (const Coverage* c : {&coverage.shear, &coverage.bulk}) {
    claim_coverage(claims, *c, 0.90, "recipes left out");
    claims.require(c->largest_stated <= 0.06, "stated errors of usual packings: 6 % at most");
  }
  claims.require(sheared.axis_ratio.rms() < 0.03, "C33/C11 of sheared states: 3 % rms");
  claims.require(exponents.dense < 0.03 && exponents.loose < 0.03, "s within 0.03, growth given");
  claims.require(rattler_error < 0.02,
                 "z* = C_n/(1-x_0) within 2 % (" + number(100 * rattler_error, 2) + " %)");
  check_sizes(unequal, gradations, result, claims);
  check_forces(packings, unequal, gradations, of_codes, claims);
  check_codes(of_codes, packings, result, claims);
  check_stiff_contacts(stiff, result, claims);
  return claims.failed() == 0 ? 0 : 1;
}

} // namespace

int main(int argc, char** argv) {
  if (argc != 8) {
    std::fprintf(
        stderr,
        "usage: %s coefficients|check|picture|besides states.csv unequal.csv gradations.csv codes.csv "
        "exponents.csv rough.csv\n",
        argv[0]);
    return 2;
  }
  try {
    const auto [packings, unfitted] = split_by_use(read_packings(argv[2]));
    const std::vector<Packing> unequal = read_packings(argv[3]);
    const std::vector<Packing> gradations = read_gradations(argv[4]);
    const std::vector<Packing> of_codes = read_packings(argv[5]);
    std::vector<StiffNetwork> stiff = read_stiff_networks(argv[6], false);
    std::ranges::move(read_stiff_networks(argv[7], true), std::back_inserter(stiff));
    const Result result = fit_everything(packings, unequal, gradations, of_codes, stiff);
    if (std::strcmp(argv[1], "coefficients") == 0) {
      print_coefficients(result);
      return 0;
    }
    if (std::strcmp(argv[1], "picture") == 0) {
      std::fputs(picture(packings).c_str(), stdout);
      return 0;
    }
    if (std::strcmp(argv[1], "besides") == 0) {
      print_void_ratio(packings, result.shear);
      print_stretch(packings, result);
      print_shortening(packings);
      print_central_forces(packings, result.shear);
      print_stated(packings, unequal, result);
      std::printf("relaxed() where contacts are few, networks of isotropic packings\n");
      print_few_contacts("states", packings);
      print_few_contacts("unequal", unequal);
      print_few_contacts("gradations", gradations);
      return 0;
    }
    if (std::strcmp(argv[1], "check") == 0)
      return check(packings, unfitted, unequal, gradations, of_codes, stiff, result);
  } catch (const std::exception& error) {
    std::fprintf(stderr, "%s\n", error.what());
    return 1;
  }
  std::fprintf(stderr, "unknown command %s\n", argv[1]);
  return 2;
}

// SPDX-License-Identifier: GPL-3.0-or-later
// Fits the relaxation factors to the recorded networks.
//
//     relaxation_fit coefficients FILES   writes the numbers of src/effective/relaxation_coefficients.hpp
//     relaxation_fit check FILES          fits again, compares with that file, and asks whether errors, also
//                                         on packings left out of the fit, are in reach
//     relaxation_fit picture FILES        SVG: factors of the networks and of the library
//     relaxation_fit besides FILES        what the void ratio and the stretch do, and errors by z*
//
// FILES: states.csv unequal.csv gradations.csv codes.csv exponents.csv rough.csv
#include "../common.hpp"
#include "besides.hpp"
#include "coefficients.hpp"
#include "exponents.hpp"
#include "library_errors.hpp"
#include "picture.hpp"

namespace {

using namespace relaxation;
using granum::short_text;

const std::string header = HEADERS "/relaxation_coefficients.hpp"; // of the library

const Choice is_unequal = [](const Packing& p) { return p.sizes != "equal"; };

/// Whether the factors predict packings left out of the fit.
void check_factors(const Records& records, const Result& result, Claims& claims) {
  std::printf("errors of the factors by k_t/k_n, all isotropic states\n");
  for (const double r : solved_ratios)
    print_errors("  k_t/k_n = " + short_text(r, 3),
                 errors_of(records.packings, result.equal, r - 1e-6, r + 1e-6, everything));
  std::printf("errors on packings left out of the fit, k_t/k_n >= %.1f\n", lowest_usual_ratio);
  const struct {
    const char* title;
    Label label;
  } labels[] = {{"contact", [](const Packing& p) { return p.contact; }},
                {"preparation", preparation_of},
                {"seed", [](const Packing& p) { return std::to_string(p.seed % 100); }}};
  std::vector<ErrorsOfBoth> all;
  for (const auto& [title, label] : labels)
    all.push_back(left_out(records.packings, title, label, [&](const Choice& left, const Choice& kept) {
      return errors_of(records.packings, fit_equal(records.packings, kept), lowest_usual_ratio, 1, left);
    }));
  all.push_back(errors_of(records.unfitted, result.equal, lowest_usual_ratio, 1, everything));
  print_errors("a shape that no fit has seen", all.back());
  for (const ErrorsOfBoth& e : all) {
    claims.require(e.G.count() > 0 && e.G.rms() < 0.04, "G of packings left out: 4 % rms");
    Claims::aim(e.G.worst() < 0.10,
                "G of packings left out: 10 % at worst (" + short_text(100 * e.G.worst(), 2) + " %)");
    // Not claimed by contact: flat ones (b = 0) are the end of the range, and K does not extrapolate to them.
    if (&e != &all.front())
      claims.require(e.K.rms() < 0.02, "K of packings left out: 2 % rms");
  }
  std::printf(
      "do errors of k_t/k_n >= %.1f, z* >= %.1f lie within what a fit to all other preparations states?\n",
      lowest_usual_ratio, lowest_usual_coordination);
  const ErrorsOfBoth stated =
      left_out(records.packings, "preparation", preparation_of, [&](const Choice& left, const Choice& kept) {
        return coverage_of(records.packings, fit_equal(records.packings, kept), {}, left);
      });
  for (const Errors* e : {&stated.G, &stated.K}) {
    claims.require_covered(*e, "recipes left out", 0.55, 0.90, 0.80);
    claims.require(e->largest_stated() <= 0.06, "stated errors of usual packings: 6 % at most");
  }
}

/// The library as a user calls it.
void check_library(const std::vector<Packing>& packings, Claims& claims) {
  const LibraryErrors isotropic = library_errors(packings, is_isotropic),
                      sheared = library_errors(packings, is_sheared);
  print_errors("relaxed(), isotropic states, overlap < 1 %", isotropic);
  print_errors("relaxed(), sheared states", sheared);
  claims.require(isotropic.G.beyond_two() + isotropic.K.beyond_two() < 0.1 * 2 * isotropic.G.count(),
                 "one in ten G and K at most is beyond two errors");
  claims.require(sheared.axis_ratio.rms() < 0.03, "C33/C11 of sheared states: 3 % rms");
  for (const auto& [preparation, worst] : compare_exponents(packings))
    claims.require(worst < 0.03, "s within 0.03, growth given: " + preparation);
  Errors rattlers; // z* = C_n/(1 - x_0)
  for (const Packing& p : packings)
    rattlers.add(
        granum::effective::mechanical_coordination_number(*p.state.coordination_number, p.rattler_fraction) /
            p.mechanical_coordination -
        1);
  claims.require(rattlers.count() > 0 && rattlers.worst() < 0.02,
                 "z* = C_n/(1-x_0) within 2 % (" + short_text(100 * rattlers.worst(), 2) + " %)");
}

/// Whether unequal grains are what is stated of them.
void check_sizes(const Records& records, const Result& result, Claims& claims) {
  std::printf("unequal grains: z* shifted by %.3f +- %.3f times the relative variance of branches\n",
              result.sizes.shift, result.sizes.shift_error);
  for (const std::vector<Packing>* judged : {&records.unequal, &records.gradations}) {
    const std::string what = judged == &records.unequal ? "" : "gradations, ";
    std::vector<Packing> unequal = *judged;
    std::erase_if(unequal, std::not_fn(is_unequal));
    const auto without = [&](const char* title, const Label& label) {
      return left_out(unequal, what + title, label, [&](const Choice& left, const Choice& kept) {
        return coverage_of(unequal, result.equal,
                           fit_size_effect(records.unequal, records.gradations, result.equal, kept), left);
      });
    };
    const ErrorsOfBoth by_sizes = without("sizes", [](const Packing&p) { return p.sizes; }),
                       by_preparation = without("preparation", preparation_of);
    if (judged == &records.unequal) {
      claims.require_covered(by_preparation.G, "G, preparations of unequal grains left out", 0.55, 0.90,
                             0.80);
      claims.require_covered(by_preparation.K, "K, preparations of unequal grains left out", 0.55, 0.90,
                             0.80);
      claims.require_covered(by_sizes.G, "G, distributions left out", 0, 0.85);
      claims.require_covered(by_sizes.K, "K, distributions left out", 0, 0.90);
    } else
      for (const ErrorsOfBoth* e : {&by_sizes, &by_preparation})
        claims.require_covered(e->K, "K, gradations and their preparations left out", 0, 0.90);
  }
  print_errors("equal grains, as small specimens",
               coverage_of(records.unequal, result.equal, result.sizes, std::not_fn(is_unequal)));
  print_errors("relaxed(), unequal grains, isotropic states", library_errors(records.unequal, is_isotropic));
}

/// Whether what is stated of packings whose forces are known holds.
void check_forces(const Records& records, Claims& claims) {
  std::printf("forces known: preparations left out of all fits, equal grains, then unequal ones\n");
  std::vector<Packing> of_sizes = records.unequal;
  std::erase_if(of_sizes, std::not_fn(is_unequal));
  for (const auto& [what, judged] :
       {std::pair{"equal", &records.packings}, std::pair{"unequal", &std::as_const(of_sizes)}}) {
    const ErrorsOfBoth left =
        coverage_of_left_out_forces(records.packings, records.unequal, records.gradations, *judged);
    claims.require_covered(left.G, std::string("G, forces known, ") + what, 0.55, 0.90, 0.80);
    claims.require_covered(left.K, std::string("K, forces known, ") + what);
  }
  for (const auto& [what, judged] :
       {std::pair{"unequal grains", &std::as_const(of_sizes)},
        std::pair{"gradations, which no gain was fitted to", &records.gradations},
        std::pair{"packings of other codes, which no gain was fitted to", &records.codes}})
    for (const auto& [given, forces] :
         {std::pair{"", Forces::unknown}, std::pair{", forces known", Forces::measured}})
      print_errors(std::string("relaxed(), ") + what + given, library_errors(*judged, is_isotropic, forces));
}

/// Whether what is stated holds for packings of a code that no fit has seen.
void check_codes(const Records& records, const Result& result, Claims& claims) {
  std::printf("packings of other codes: K scatters by %.3f times the looseness\n", result.bulk_codes);
  const auto judge = [&](const char* what, const std::vector<Packing>& packings, const Choice& chosen) {
    const ErrorsOfBoth e = coverage_of(packings, result.equal, result.sizes, chosen, result.bulk_codes);
    print_errors(what, e);
    return e;
  };
  judge("granum's own, equal grains", records.packings, everything);
  judge("LAMMPS", records.codes, is_calibrating_code);
  const ErrorsOfBoth yade = judge("YADE", records.codes, std::not_fn(is_calibrating_code));
  judge("- loose", records.codes,
        [&](const Packing& p) { return !is_calibrating_code(p) && p.mechanical_coordination < 5; });
  claims.require_covered(yade.G, "G, YADE");
  claims.require_covered(yade.K, "K, YADE");
}

/// Networks with every b, and rough packings, of seeds that are never fitted.
void check_stiff_contacts(const std::vector<StiffNetwork>& stiff, const Result& result, Claims& claims) {
  const auto judge = [&](const std::string& what, const StiffChoice& chosen) {
    return report_of(what, stiff, result.equal, result.bulk_codes, result.beyond, chosen);
  };
  std::set<double> exponents;
  std::set<std::string> recipes;
  for (const StiffNetwork& n : stiff) {
    if (!n.rough)
      exponents.insert(n.b);
    else if (!n.fitted())
      recipes.insert(n.recipe);
  }
  for (const bool fitted : {true, false}) {
    std::printf("networks with k_n ~ f^b, %s\n", fitted ? "fitted" : "of seeds never fitted");
    for (const double b : exponents)
      judge("b = " + short_text(b, 3),
            [&](const StiffNetwork& n) { return !n.rough && n.b == b && n.fitted() == fitted; });
  }
  std::printf("packings of rough grains, of seeds never fitted\n");
  for (const std::string& recipe : recipes)
    judge(recipe, [&](const StiffNetwork& n) { return n.rough && !n.fitted() && n.recipe == recipe; });
  judge("fitted, together", [](const StiffNetwork& n) { return n.rough && n.fitted(); });
  const ErrorsOfBoth rough = judge("together", [](const StiffNetwork&n) { return n.rough && !n.fitted(); }),
                     powers = judge("k_n ~ f^b beyond 1/2, together", [](const StiffNetwork&n) {
                       return !n.rough && !n.fitted() && n.beyond();
                     });
  claims.require(rough.G.count() > 0 && rough.G.rms() < 0.03 && rough.K.rms() < 0.02,
                 "rough packings of seeds never fitted: G 3 % and K 2 % rms");
  for (const ErrorsOfBoth* e : {&rough, &powers}) {
    claims.require_covered(e->G, "G beyond b = 1/2");
    claims.require_covered(e->K, "K beyond b = 1/2");
  }
}

int check(const Records& records, const Result& result) {
  Claims claims;
  const std::string other = first_other(header, constants_of(result), 1e-5);
  claims.require(other.empty(), "the numbers of the library are those of these data" +
                                    (other.empty() ? "" : ", but not those after: " + other));
  check_factors(records, result, claims);
  check_library(records.packings, claims);
  check_sizes(records, result, claims);
  check_forces(records, claims);
  check_codes(records, result, claims);
  check_stiff_contacts(records.stiff, result, claims);
  return claims.exit_code();
}

/// Of all records, and the fits to them.
template <class Run>
Command command(const char* name, const Run& run) {
  return {name, "states.csv unequal.csv gradations.csv codes.csv exponents.csv rough.csv",
          [run](const Arguments& files) {
            const Records records(files);
            return run(records, fit_everything(records));
          }};
}

} // namespace

int main(int argc, char** argv) {
  return program(
      argc, argv,
      {
          command("check", check),
          command("coefficients",
                  [](const Records&, const Result& result) { write_header(header, constants_of(result)); }),
          command("picture", [](const Records& records,
                                const Result&) { std::fputs(picture(records.packings).c_str(), stdout); }),
          command("besides", print_besides),
      });
}

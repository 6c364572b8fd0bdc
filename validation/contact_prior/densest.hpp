// SPDX-License-Identifier: GPL-3.0-or-later
// Packings with friction whose grains were also packed without: z* by the void ratio above that of their
// densest packing. What is fitted to them, and whether what is stated of z* holds for others.
#pragma once

#include <granum/effective/contact_prior.hpp>
#include <gsl/gsl_statistics_double.h>

#include "../common.hpp"
#include "calibration.hpp"

namespace contact_prior::densest {

/// Of the loose packings of LAMMPS, YADE and verify.
constexpr double usual_friction = 0.4986;

struct Packing {
  relaxation::Packing packing;
  relaxation::Packing densest;  ///< of the same grains, at its smallest pressure
  double densest_deviation = 0; ///< of its void ratio from that of the packing itself, one standard deviation
};

/// The code that made a packing; empty for granum.
inline std::string code_of(const relaxation::Packing& p) {
  for (const char* code : {"lammps", "yade"})
    if (p.preparation.starts_with(code))
      return code;
  return "";
}

/// Packings of the same grains: other codes made their densest ones of spheres alone.
inline std::string grains_of(const relaxation::Packing& p) {
  const std::string code = code_of(p);
  return p.sizes + " " + (code.empty() ? p.contact : code) + " " + std::to_string(p.seed);
}

inline bool without_friction(const relaxation::Packing& p) { return p.preparation.ends_with("dense"); }

/// The friction packings of `packings` that have a densest one among them.
/// \param    of_equal   taken for equal grains whose own was not made, or is looser than the library takes
inline std::vector<Packing> above_densest(const std::vector<relaxation::Packing>& packings,
                                          const std::optional<relaxation::Packing>& of_equal = {}) {
  std::map<std::string, const relaxation::Packing*> densest;
  for (const relaxation::Packing& p : packings)
    if (without_friction(p) && p.isotropic() && p.state.void_ratio <= kernel::loosest_densest) {
      const auto [at, fresh] = densest.try_emplace(grains_of(p), &p);
      if (!fresh && p.pressure < at->second->pressure)
        at->second = &p;
    }
  std::vector<Packing> all;
  for (const relaxation::Packing& p : packings) {
    if (without_friction(p) || !usable(p))
      continue;
    const auto own = densest.find(grains_of(p));
    if (own == densest.end() && !(of_equal && p.sizes == "equal"))
      continue;
    all.push_back(
        {.packing = p, .densest = own != densest.end() ? *own->second : *of_equal, .densest_deviation = 0});
    if (!(p.friction_coefficient > 0))
      all.back().packing.friction_coefficient = usual_friction;
  }
  return all;
}

/// z* less that of the friction at the void ratio above the densest.
inline double left_by_friction(const Packing& a, const Numbers<double, size>& c) {
  const double e = kernel::as_of_equal(rigid<double>(a.packing, c), rigid<double>(a.densest, c), c);
  return a.packing.mechanical_coordination -
         kernel::contacts_of_friction<double>(a.packing.friction_coefficient, e, a.packing.relative_overlap,
                                              c);
}

inline double variance_of(const Packing& a) { return kernel::branch_variance(a.packing.state.contacts); }
/// What the library knows of packings above their densest one.
struct Result {
  Fit<2> shape; ///< of opened packings of equal grains: constant, and over b
  Fit<1> sizes; ///< over the square root of the variance of branches
  double recipe_scatter = 0, size_scatter = 0, code_scatter = 0;

  [[nodiscard]] std::array<double, 3> shift() const {
    return {shape.coefficients[0], shape.coefficients[1], sizes.coefficients[0]};
  }
};

/// What is left beyond the shift of those fits.
inline double left_after(const Packing& a, const Numbers<double, size>& c, const Fit<2>& shape,
                         double by_sizes = 0) {
  return left_by_friction(a, c) -
         kernel::shift_by_grains(a.packing.exponent(), variance_of(a),
                                 {shape.coefficients[0], shape.coefficients[1], by_sizes});
}

/// \param    left   a preparation that is left out, or none
inline Fit<2> fit_shape(const std::vector<Packing>& equal, const Numbers<double, size>& c,
                        const std::string& left = "") {
  std::vector<Observation<2>> rows;
  for (const Packing& a : equal)
    if (!from_gas(a.packing) && a.packing.preparation != left)
      rows.push_back({[b = kernel::up_to_half(a.packing.exponent())](const Numbers<Dual<2>, 2>& s) {
                        return s[0] + s[1] * b;
                      },
                      left_by_friction(a, c), 1, a.packing.specimen});
  return relaxation::least_squares<2>(std::move(rows), {0, 0});
}

/// \param    left   sizes that are left out, or none
inline Fit<1> fit_sizes(const std::vector<Packing>& unequal, const Fit<2>& shape,
                        const Numbers<double, size>& c, const std::string& left = "") {
  std::vector<Observation<1>> rows;
  for (const Packing& a : unequal)
    if (a.packing.sizes != left)
      rows.push_back(
          {[root = std::sqrt(variance_of(a))](const Numbers<Dual<1>, 1>& s) { return s[0] * root; },
           left_after(a, c, shape), 1, a.packing.sizes});
  return relaxation::least_squares<1>(std::move(rows), {0});
}

/// \param    equal     of states.csv
/// \param    unequal   of unequal.csv
/// \param    codes     of other codes
inline Result fit(const std::vector<Packing>& equal, const std::vector<Packing>& unequal,
                  const std::vector<Packing>& codes, const contact_prior::Result& of_contacts) {
  const auto& c = of_contacts.contacts.coefficients;
  Result result{.shape = fit_shape(equal, c), .sizes = {}};
  Errors recipes;
  for (const auto& [preparation, without] : of_contacts.without) {
    const Fit<2> shape = fit_shape(equal, without, preparation);
    for (const Packing& a : equal)
      if (a.packing.preparation == preparation)
        recipes.add(left_after(a, without, shape));
  }
  result.recipe_scatter = recipes.rms();
  result.sizes = fit_sizes(unequal, result.shape, c);
  double squares = 0, variances = 0;
  for (const Packing& a : unequal) {
    const double by_sizes = fit_sizes(unequal, result.shape, c, a.packing.sizes).coefficients[0];
    squares += std::pow(left_after(a, c, result.shape, by_sizes), 2) - std::pow(result.recipe_scatter, 2);
    variances += variance_of(a);
  }
  result.size_scatter = std::sqrt(std::max(squares / variances, 0.0));
  squares = 0;
  for (const Packing& a : codes)
    squares += std::pow(left_after(a, c, result.shape, result.sizes.coefficients[0]), 2) -
               std::pow(result.recipe_scatter, 2) - std::pow(result.size_scatter, 2) * variance_of(a);
  result.code_scatter = std::sqrt(std::max(squares / static_cast<double>(codes.size()), 0.0));
  return result;
}

/// Packings that are fitted, and those of other codes that are not: their second seeds.
struct Files {
  std::vector<Packing> equal, unequal, codes, codes_left;
};

/// \param    equal   of states.csv
inline Files read(const std::vector<relaxation::Packing>& equal, const std::string& unequal_path,
                  const std::string& codes_path) {
  Files files;
  files.equal = above_densest(equal);
  files.unequal = above_densest(relaxation::read_packings(unequal_path));
  std::erase_if(files.unequal, [](const Packing& a) { return a.packing.sizes == "equal"; });
  std::optional<relaxation::Packing> spheres; // of 4,000 grains
  for (const relaxation::Packing& p : equal)
    if (p.contact == "sphere" && without_friction(p) && (!spheres || p.pressure < spheres->pressure))
      spheres = p;
  for (const Packing& a : above_densest(relaxation::read_packings(codes_path), spheres))
    (a.packing.seed == 1 ? files.codes : files.codes_left).push_back(a);
  return files;
}

// ---- on packings that were not fitted ----

/// Errors of z* with the densest packing known, and without.
struct Judged {
  Errors z, without;
};

inline Judged judge(const std::string& what, const std::vector<Packing>& all) {
  Judged judged;
  for (const Packing& a : all) {
    granum::effective::State state = a.packing.state;
    state.coordination_number.reset();
    granum::effective::Preparation preparation{.kind = granum::effective::Preparation::Kind::friction,
                                               .friction_coefficient = a.packing.friction_coefficient};
    const auto add = [&](double e, double d, Errors& errors) { // d is felt as an uncertain input is
      const auto prior_at = [&](double densest_void_ratio) {
        preparation.densest_void_ratio = densest_void_ratio;
        return granum::effective::contact_prior(state, preparation);
      };
      const auto prior = prior_at(e);
      const double felt = (prior_at(e + d).middle.mechanical_coordination_number -
                           prior_at(e - d).middle.mechanical_coordination_number) /
                          2;
      errors.add(prior.middle.mechanical_coordination_number - a.packing.mechanical_coordination,
                 std::hypot(prior.coordination_error, felt));
    };
    add(0, 0, judged.without);
    preparation.pressure = std::min(a.densest.state.mean_stress(), state.mean_stress());
    add(a.densest.state.void_ratio, a.densest_deviation, judged.z);
  }
  print_errors("  " + what, {{"z*", &judged.z}, {"by e alone", &judged.without}}, 1);
  return judged;
}

/// Loose packings of verify with the mean void ratio of the densest ones of their shape, as if their own were
/// not known, and how far those differ.
inline std::vector<Packing> above_mean(const std::vector<relaxation::Packing>& packings) {
  std::map<std::string, std::vector<const relaxation::Packing*>> densest;
  for (const relaxation::Packing& p : packings)
    if (without_friction(p) && p.pressure == 10e3)
      densest[p.contact].push_back(&p);
  std::vector<Packing> all;
  for (const relaxation::Packing& p : packings) {
    if (without_friction(p) || !usable(p))
      continue;
    const auto& of_shape = densest.at(p.contact);
    std::vector<double> e;
    for (const relaxation::Packing* d : of_shape)
      e.push_back(d->state.void_ratio);
    const double deviation = gsl_stats_sd(e.data(), 1, e.size());
    all.push_back({.packing = p, .densest = *of_shape.front(), .densest_deviation = deviation});
    all.back().densest.state.void_ratio = gsl_stats_mean(e.data(), 1, e.size());
  }
  return all;
}

/// \param    others   third_seed.csv, gradations.csv, and states of verify
inline void check(const Files& files, const std::vector<std::string>& others, Claims& claims) {
  const auto shape = [](const Packing& a) {
    return a.packing.contact + (from_gas(a.packing) ? ", from a gas" : ", opened");
  };
  const auto sizes = [](const Packing& a) { return a.packing.sizes; };
  const auto code = [](const Packing& a) { return code_of(a.packing) + " " + a.packing.sizes; };
  std::printf("above the densest packing of the same grains: fitted ones\n");
  judge_each("states, ", files.equal, shape, judge);
  judge_each("unequal, ", files.unequal, sizes, judge);
  judge_each("codes, ", files.codes, code, judge);
  std::printf("ones that were not fitted\n");
  judge_each("second seed, ", files.codes_left, code, judge);
  const auto third =
      judge_each("third seed, ", above_densest(relaxation::read_packings(others[0])), shape, judge);
  claims.require_covered(third.at("together").z, "third seed, above the densest packing");
  const auto graded =
      judge_each("gradations, ", above_densest(relaxation::read_gradations(others[1])), sizes, judge);
  claims.require_covered(graded.at("together").z, "gradations, above the densest packing");
  for (std::size_t k = 2; k < others.size(); ++k) {
    const std::vector<relaxation::Packing> packings = relaxation::read_verify_states(others[k]);
    for (const auto& [what, all] : {std::pair{"verify, ", above_densest(packings)},
                                    std::pair{"verify, mean densest, ", above_mean(packings)}})
      for (const auto& [kind, j] : judge_each(
               what, all, [](const Packing& a) { return a.packing.contact; }, judge))
        claims.require_covered(j.z, what + kind, 0.5, 0.88);
  }
}

} // namespace contact_prior::densest

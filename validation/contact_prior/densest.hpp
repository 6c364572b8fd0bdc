// SPDX-License-Identifier: GPL-3.0-or-later
// Packings with friction whose grains were also packed without: z* by the void ratio above that of their
// densest packing. What is fitted to them.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <optional>
#include <string>
#include <vector>

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
inline bool opened(const Packing& a) { return !from_gas(a.packing); }

/// What the library knows of packings above their densest one.
struct Result {
  Fit<2> shape; ///< of opened packings of equal grains: constant, and over b
  Fit<1> sizes; ///< over the square root of the variance of branches
  double recipe_scatter = 0, size_scatter = 0, code_scatter = 0;

  [[nodiscard]] std::array<double, 3> shift() const {
    return {shape.coefficients[0], shape.coefficients[1], sizes.coefficients[0]};
  }
};

inline double shift_of(const Packing& a, const std::array<double, 3>& shift) {
  return kernel::shift_by_grains(a.packing.exponent(), variance_of(a), shift);
}

/// \param    left   a preparation that is left out, or none
inline Fit<2> fit_shape(const std::vector<Packing>& equal, const Numbers<double, size>& c,
                        const std::string& left = "") {
  std::vector<Observation<2>> rows;
  for (const Packing& a : equal)
    if (opened(a) && a.packing.preparation != left)
      rows.push_back({[b = a.packing.exponent()](const Numbers<Dual<2>, 2>& s) {
                        return Dual<2>(s[0] + s[1] * kernel::up_to_half(b));
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
          {[root = std::sqrt(variance_of(a))](const Numbers<Dual<1>, 1>& s) { return Dual<1>(s[0] * root); },
           left_by_friction(a, c) - shift_of(a, {shape.coefficients[0], shape.coefficients[1], 0}), 1,
           a.packing.sizes});
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
        recipes.add(left_by_friction(a, without) -
                    shift_of(a, {shape.coefficients[0], shape.coefficients[1], 0}));
  }
  result.recipe_scatter = recipes.rms();
  const double of_recipes = recipes.rms() * recipes.rms();
  result.sizes = fit_sizes(unequal, result.shape, c);
  double squares = 0, variances = 0;
  for (const Packing& a : unequal) {
    const Fit<1> others = fit_sizes(unequal, result.shape, c, a.packing.sizes);
    const double left =
        left_by_friction(a, c) -
        shift_of(a, {result.shape.coefficients[0], result.shape.coefficients[1], others.coefficients[0]});
    squares += left * left - of_recipes;
    variances += variance_of(a);
  }
  result.size_scatter = std::sqrt(std::max(squares / variances, 0.0));
  squares = 0;
  for (const Packing& a : codes) {
    const double left = left_by_friction(a, c) - shift_of(a, result.shift());
    squares += left * left - of_recipes - result.size_scatter * result.size_scatter * variance_of(a);
  }
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

} // namespace contact_prior::densest

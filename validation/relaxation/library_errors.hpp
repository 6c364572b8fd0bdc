// SPDX-License-Identifier: GPL-3.0-or-later
// The library's relaxed() beside the contact networks, and whether the errors that it states hold.
#pragma once

#include <cmath>
#include <cstdio>
#include <string>
#include <vector>

#include <granum/effective/relaxation.hpp>

#include "coverage.hpp"
#include "factor_errors.hpp"
#include "uneven_fits.hpp"

namespace relaxation {

/// Below, the library says that it is not calibrated.
inline constexpr double lowest_coordination = 4.1;

/// Errors of relaxed() over the network, and how many of them its stated standard errors cover.
struct LibraryErrors {
  Errors G, K, axis_ratio, shear_ratio, constants;
  CoverageOfBoth coverage;

  /// G and K beyond two standard errors.
  [[nodiscard]] int beyond_two() const {
    return coverage.shear.count - coverage.shear.within_two + coverage.bulk.count - coverage.bulk.within_two;
  }
};

/// What the library is given of the forces of a packing.
enum class Forces {
  unknown,
  measured,  ///< their unevenness
  remembered ///< the pressure of preparation, of dense packings
};

/// Of packings for which the library is calibrated, at usual k_t/k_n.
/// \param    least_overlap, most_overlap   mean ones over the diameter
/// \param    least_coordination   z*, above which all are taken
inline LibraryErrors library_errors(const std::vector<Packing>& packings, const Choice& chosen,
                                    double least_overlap = 0, double most_overlap = largest_overlap,
                                    Forces forces = Forces::unknown,
                                    double least_coordination = lowest_coordination) {
  LibraryErrors errors;
  for (const Packing& p : packings)
    for (const Network& n : p.networks) {
      if (!chosen(p) || n.ratio < lowest_usual_ratio || p.relative_overlap < least_overlap ||
          p.relative_overlap > most_overlap || p.mechanical_coordination < least_coordination)
        continue;
      State state = p.state;
      state.tangential_ratio = n.ratio;
      if (forces == Forces::measured)
        state.unevenness = granum::effective::Unevenness{.value = p.unevenness};
      if (forces == Forces::remembered)
        state.unevenness =
            granum::effective::dense_unevenness(state, std::min(preparation_pressure, state.mean_stress()));
      const auto estimate = granum::effective::relaxed(state, p.mechanical_coordination);
      const TransverselyIsotropic &c = estimate.stiffness, &measured = n.stiffness;
      const double G_error = isotropic_shear_modulus(c) / isotropic_shear_modulus(measured) - 1;
      const double K_error = c.bulk_modulus() / measured.bulk_modulus() - 1;
      errors.G.add(G_error);
      errors.K.add(K_error);
      errors.coverage.shear.add(G_error, estimate.relative_error.G_vh);
      errors.coverage.bulk.add(K_error, estimate.relative_error.bulk_modulus);
      errors.axis_ratio.add(c.C33 / c.C11 / (measured.C33 / measured.C11) - 1);
      errors.shear_ratio.add(c.C66() / c.C44 / (measured.C66() / measured.C44) - 1);
      for (const auto member :
           {&TransverselyIsotropic::C11, &TransverselyIsotropic::C33, &TransverselyIsotropic::C44})
        errors.constants.add(c.*member / (measured.*member) - 1);
      errors.constants.add(c.C66() / measured.C66() - 1);
    }
  return errors;
}

inline bool is_isotropic(const Packing& p) { return p.isotropic(); }
inline bool is_sheared(const Packing& p) { return !p.isotropic(); }

inline void print_errors(const char* what, const Errors& e) {
  std::printf("  %-36s %5d | rms %5.2f %% worst %5.2f %%\n", what, e.count(), 100 * e.rms(), 100 * e.worst());
}

/// Three lines: fewer contacts than those of the usual packings, and more rattlers than grains that carry
/// force. Isotropic packings; networks with k_t/k_n >= 0.5.
inline std::vector<LibraryErrors> print_few_contacts(const std::string& what,
                                                     const std::vector<Packing>& packings) {
  std::vector<LibraryErrors> all;
  const auto add = [&](const char* which, const Choice& chosen) {
    const LibraryErrors e = library_errors(
        packings, [&](const Packing& p) { return p.isotropic() && chosen(p); }, 0, largest_overlap,
        Forces::unknown, kernel::shear_coefficients[7]);
    if (e.G.count() == 0)
      return;
    std::printf("  %-12s %-16s %3d | G rms %4.1f %% mean %+5.1f, within one %3.0f %% two %3.0f | K rms %4.1f "
                "mean %+5.1f, %3.0f %3.0f\n",
                what.c_str(), which, e.G.count(), 100 * e.G.rms(), 100 * e.G.mean(),
                100 * e.coverage.shear.one(), 100 * e.coverage.shear.two(), 100 * e.K.rms(), 100 * e.K.mean(),
                100 * e.coverage.bulk.one(), 100 * e.coverage.bulk.two());
    all.push_back(e);
  };
  add("z* 4.1 to 4.3", [](const Packing& p) {
    return p.mechanical_coordination >= lowest_coordination &&
           p.mechanical_coordination < lowest_usual_coordination;
  });
  add("z* below 4.1", [](const Packing& p) { return p.mechanical_coordination < lowest_coordination; });
  add("rattlers > 50 %", [](const Packing& p) { return p.rattler_fraction > 0.5; });
  return all;
}

inline void print_errors(const std::string& what, const LibraryErrors& e) {
  std::printf("%s\n", what.c_str());
  print_errors("G", e.G);
  print_errors("K", e.K);
  print_errors("C33/C11", e.axis_ratio);
  print_errors("G_hh/G_vh", e.shear_ratio);
  print_errors("C11, C33, G_vh, G_hh", e.constants);
  std::printf("  G or K beyond two standard errors: %d of %d\n", e.beyond_two(), 2 * e.G.count());
}

} // namespace relaxation

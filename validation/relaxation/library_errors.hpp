// SPDX-License-Identifier: GPL-3.0-or-later
// The library's relaxed() beside the contact networks, and whether the errors that it states hold.
#pragma once

#include <granum/effective/relaxation.hpp>

#include "../common.hpp"
#include "uneven_fits.hpp"

namespace relaxation {

/// Below, the library says that it is not calibrated.
inline constexpr double lowest_coordination = 4.1;

/// Errors of relaxed() over the network.
struct LibraryErrors : ErrorsOfBoth {
  Errors axis_ratio, shear_ratio, constants;
};

/// What the library is given of the forces of a packing.
enum class Forces {
  unknown,
  measured,  ///< their unevenness
  remembered ///< the pressure of preparation, of dense packings
};

/// Which packings, at usual k_t/k_n: by default those for which the library is calibrated.
struct Range {
  double least_overlap = 0, most_overlap = largest_overlap; ///< mean ones over the diameter
  double least_coordination = lowest_coordination;          ///< z*
};

inline LibraryErrors library_errors(const std::vector<Packing>& packings, const Choice& chosen,
                                    Forces forces = Forces::unknown, const Range& range = {}) {
  LibraryErrors errors;
  for (const Packing& p : packings)
    for (const Network& n : p.networks) {
      if (!chosen(p) || n.ratio < lowest_usual_ratio || p.relative_overlap < range.least_overlap ||
          p.relative_overlap > range.most_overlap || p.mechanical_coordination < range.least_coordination)
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
      errors.G.add(isotropic_shear_modulus(c) / isotropic_shear_modulus(measured) - 1,
                   estimate.relative_error.G_vh);
      errors.K.add(c.bulk_modulus() / measured.bulk_modulus() - 1, estimate.relative_error.bulk_modulus);
      errors.axis_ratio.add(c.C33 / c.C11 / (measured.C33 / measured.C11) - 1);
      errors.shear_ratio.add(c.C66() / c.C44 / (measured.C66() / measured.C44) - 1);
      for (const auto member :
           {&TransverselyIsotropic::C11, &TransverselyIsotropic::C33, &TransverselyIsotropic::C44})
        errors.constants.add(c.*member / (measured.*member) - 1);
      errors.constants.add(c.C66() / measured.C66() - 1);
    }
  return errors;
}

inline void print_errors(const std::string& what, const LibraryErrors& e) {
  ::print_errors(what, {{"G", &e.G}, {"K", &e.K}});
  ::print_errors(
      "-", {{"C33/C11", &e.axis_ratio}, {"G_hh/G_vh", &e.shear_ratio}, {"C11 C33 G_vh G_hh", &e.constants}});
  std::printf("  G or K beyond two standard errors: %d of %d\n", e.G.beyond_two() + e.K.beyond_two(),
              2 * e.G.count());
}

/// Three lines: fewer contacts than those of the usual packings, and more rattlers than grains that carry
/// force. Isotropic packings; networks with k_t/k_n >= 0.5.
inline std::vector<LibraryErrors> print_few_contacts(const char* what, const std::vector<Packing>& packings) {
  const auto between = [](double low, double high) {
    return [=](const Packing& p) {
      return p.mechanical_coordination >= low && p.mechanical_coordination < high;
    };
  };
  const struct {
    const char* name;
    Choice chosen;
  } kinds[] = {{"z* 4.1 to 4.3", between(lowest_coordination, lowest_usual_coordination)},
               {"z* below 4.1", between(0, lowest_coordination)},
               {"rattlers > 50 %", [](const Packing& p) { return p.rattler_fraction > 0.5; }}};
  std::vector<LibraryErrors> all;
  for (const auto& kind : kinds) {
    const LibraryErrors e =
        library_errors(packings, [&](const Packing& p) { return p.isotropic() && kind.chosen(p); },
                       Forces::unknown, {.least_coordination = kernel::shear_coefficients[7]});
    if (e.G.count() == 0)
      continue;
    std::printf("  %-12s %-16s %3d | G rms %4.1f %% mean %+5.1f, within one %3.0f %% two %3.0f | K rms %4.1f "
                "mean %+5.1f, %3.0f %3.0f\n",
                what, kind.name, e.G.count(), 100 * e.G.rms(), 100 * e.G.mean(), 100 * e.G.one(),
                100 * e.G.two(), 100 * e.K.rms(), 100 * e.K.mean(), 100 * e.K.one(), 100 * e.K.two());
    all.push_back(e);
  }
  return all;
}

} // namespace relaxation

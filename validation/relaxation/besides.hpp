// SPDX-License-Identifier: GPL-3.0-or-later
// What the README of validation/relaxation says besides errors and coverage: what the formula leaves out, and
// where its stated errors grow.
#pragma once

#include <granum/core/numerics.hpp>
#include <granum/effective/relaxation.hpp>
#include <granum/effective/uniform_field.hpp>

#include "../common.hpp"
#include "coefficients.hpp"
#include "library_errors.hpp"

namespace relaxation {

// ---- the void ratio ----

/// How much stiffer in G packings compressed from a gas are than others, and
/// how that goes with the void ratio.
inline void print_void_ratio(const std::vector<Packing>& packings, const FactorFit<Shear>& shear) {
  std::printf("ln G of the network over the fit, isotropic states, k_t/k_n >= %.1f\n", lowest_usual_ratio);
  for (const auto& [low, high] : {std::pair{4.3, 5.5}, std::pair{5.5, 6.0}, std::pair{4.3, 6.0}}) {
    Errors gas, others;
    std::vector<granum::Point> points;
    for (const Packing& p : packings)
      for (const Network& n : p.networks) {
        const double z = p.mechanical_coordination;
        if (!is_usual(p, n) || z < low || z >= high)
          continue;
        const double residual = std::log(Shear::measured(p, n) / value(shear, p, n));
        (p.preparation.starts_with("gas") ? gas : others).add(residual);
        points.push_back({p.state.void_ratio, residual});
      }
    std::printf("  z* from %.1f to %.1f: from a gas %+.3f (%d), others %+.3f (%d); %+.2f a unit of e\n", low,
                high, gas.mean(), gas.count(), others.mean(), others.count(),
                granum::straight_line(points).slope.value);
  }
}

// ---- the stretch ----

inline void print_stretch(const std::vector<Packing>& packings, const Result& result) {
  for (const auto& [what, stretch] : {std::pair{"by the two factors alone", Numbers<double, 2>{}},
                                      std::pair{"with the stretch", result.stretch.coefficients}}) {
    Errors errors;
    for (const Packing& p : packings)
      for (const Network& n : p.networks)
        if (!p.isotropic() && n.ratio >= lowest_usual_ratio) {
          const auto c = relaxed_state(p, n, result.equal, stretch).c;
          errors.add(std::log(c.C33 / c.C11 / (n.stiffness.C33 / n.stiffness.C11)));
        }
    std::printf("ln C33/C11 of sheared states %s: rms %.1f %%, worst %.1f %%, %d values\n", what,
                100 * errors.rms(), 100 * errors.worst(), errors.count());
  }
}

// ---- shortened branches ----

/// How much K of uniform strain, added up over the contacts of a packing, is less than the closed form with
/// branches of the diameter, over what the factor of shortened branches takes: logarithms, of equal grains.
inline void print_shortening(const std::vector<Packing>& packings) {
  std::printf(
      "ln K of uniform strain, contacts added up over closed form, over (2 - b) ln(1 - w); w from 0.1 %%\n");
  std::map<std::string, Errors> shares, overlaps;
  for (const Packing& p : packings) {
    if (!p.isotropic() || p.relative_overlap < 1e-3)
      continue;
    const double closed =
        granum::effective::uniform_strain(p.state).stiffness.bulk_modulus() * p.affine_share;
    const double expected = kernel::shortened_branches(p.relative_overlap, p.exponent());
    shares[p.contact].add(std::log(p.strain_bulk_modulus / closed) / std::log(expected));
    overlaps[p.contact].add(p.relative_overlap);
  }
  for (const auto& [contact, share] : shares)
    std::printf("  %-9s %.2f (%d, w up to %.1f %%)\n", contact.c_str(), share.mean(), share.count(),
                100 * overlaps[contact].highest());
}

// ---- without tangential forces ----

/// G of networks whose contacts have no tangential stiffness, over uniform strain: measured, of the fit, and
/// of the closed form of frictionless spheres with springs of one stiffness, from the fluctuations of their
/// positions.                                                                      [ZacconeScossaRomano2011]
inline void print_central_forces(const std::vector<Packing>& packings, const FactorFit<Shear>& shear) {
  std::printf("G over uniform strain at k_t = 0: networks, the fit, 1 - 6/z*\n");
  for (const bool equal_springs : {true, false})
    for (const auto& [low, high] : {std::pair{6.0, 6.5}, std::pair{6.5, 7.0}, std::pair{7.0, 9.0}}) {
      Errors coordination, measured, fitted, central;
      for (const Packing& p : packings)
        for (const Network& n : p.networks) {
          const double z = p.mechanical_coordination;
          if (!p.isotropic() || n.ratio > 0 || (p.contact == "flat") != equal_springs || z < low || z >= high)
            continue;
          coordination.add(z);
          measured.add(Shear::measured(p, n));
          fitted.add(value(shear, p, n));
          central.add(1 - 6 / z);
        }
      if (measured.count() > 0)
        std::printf("  %s, z* from %.1f to %.1f (mean %.2f): %.3f, %.3f, %.3f (%d)\n",
                    equal_springs ? "flat contacts" : "other shapes", low, high, coordination.mean(),
                    measured.mean(), fitted.mean(), central.mean(), measured.count());
    }
}

// ---- stated errors ----

/// The least z* from which on a stated error of relaxed() is at most `largest`.
template <class Stated>
double lowest_within(const Stated& stated, double largest) {
  double low = lowest_usual_coordination, high = 8;
  if (stated(low) <= largest)
    return low;
  while (high - low > 1e-3)
    (stated((low + high) / 2) <= largest ? high : low) = (low + high) / 2;
  return high;
}

/// What relaxed() states of a packing's like with other contacts.
inline granum::effective::RelaxedEstimate estimate_at(const Packing& like, double z) {
  State state = like.state;
  state.coordination_number = z * (1 - like.rattler_fraction);
  state.fabric_anisotropy = 0;
  return granum::effective::relaxed(state, z);
}

inline void print_stated(const std::vector<Packing>& packings, const std::vector<Packing>& unequal,
                         const Result& result) {
  std::printf("stated errors by z*, equal grains at 100 kPa, dense ones with other contacts\n");
  for (const Packing& p : packings) {
    if (p.preparation != "dense" || p.pressure != 100e3 || p.seed % 100 != 1)
      continue;
    const auto K = [&](double z) { return estimate_at(p, z).relative_error.bulk_modulus; };
    std::printf("  %-12s K %.1f %% at z* = 4.3, %.1f at 4.7, %.1f at 6; at most 6 %% from %.2f on\n",
                p.contact.c_str(), 100 * K(4.3), 100 * K(4.7), 100 * K(6), lowest_within(K, 0.06));
  }
  const auto codes = [&](double z) { return 100 * result.bulk_codes * kernel::looseness(z); };
  std::printf("  of it between codes: %.1f %% at z* = 4.3, %.1f at 4.7, %.1f at 6\n", codes(4.3), codes(4.7),
              codes(6));
  std::map<std::string, const Packing*> spheres;
  for (const Packing& p : unequal)
    if (p.isotropic() && p.contact == "sphere")
      spheres.try_emplace(p.sizes, &p);
  for (const auto& [sizes, p] : spheres) {
    const auto G = [&, like = p](double z) { return estimate_at(*like, z).relative_error.G_vh; };
    std::printf("  spheres, %-20s G at most 6 %% from z* = %.2f on\n", sizes.c_str(), lowest_within(G, 0.06));
  }
}

inline void print_besides(const Records& records, const Result& result) {
  print_void_ratio(records.packings, result.equal.shear);
  print_stretch(records.packings, result);
  print_shortening(records.packings);
  print_central_forces(records.packings, result.equal.shear);
  print_stated(records.packings, records.unequal, result);
  std::printf("relaxed() where contacts are few, networks of isotropic packings\n");
  print_few_contacts("states", records.packings);
  print_few_contacts("unequal", records.unequal);
  print_few_contacts("gradations", records.gradations);
}

} // namespace relaxation

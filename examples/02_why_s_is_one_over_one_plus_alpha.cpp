// SPDX-License-Identifier: GPL-3.0-or-later
//
// Example 02: why is s = 1/(1+alpha) in G ~ p^s?
//
// The surface of a grain near a contact is z = A r^alpha. Two such grains repel each other with a force f ~
// d^(1+1/alpha), d being their overlap. The normal stiffness of a contact then grows as k_n ~
// f^(1/(1+alpha)). Contact forces grow in proportion to the mean stress p, and the shear modulus G in
// proportion to k_n: s is the exponent of k_n in f, if nothing else changes. The number of contacts may
// change too; it grows in loose packings, and their s is larger.
#include <algorithm>
#include <cmath>
#include <cstdio>

#include <granum/effective/exponents.hpp>
#include <granum/effective/uniform_field.hpp>

using namespace granum;

namespace {

/// s between two states, from their shear moduli.
double slope(const effective::State& low, const effective::State& high) {
  const double G_low = effective::uniform_strain(low).stiffness.G_vh();
  const double G_high = effective::uniform_strain(high).stiffness.G_vh();
  return std::log(G_high / G_low) / std::log(high.stress_v / low.stress_v);
}

} // namespace

int main() {
  const contact::GrainMaterial grain{.shear_modulus = 30e9, .poisson_ratio = 0.15};
  const contact::PowerLaw shapes[] = {
      contact::PowerLaw::cone(grain, 0.4), contact::PowerLaw::general(grain, 1.5, 180),
      contact::PowerLaw::sphere(grain, 0.5e-3), contact::PowerLaw::flat(grain, 5.7e-6)};
  double worst = 0;
  std::printf("alpha   1/(1+alpha)   s, same contacts   G_hv: sigma_h + sigma_v   s, contacts ~ p^0.05\n");
  for (const contact::PowerLaw& law : shapes) {
    const double b = law.stiffness_exponent();

    // 1. A packing at 10 and at 100 kPa mean stress with the same contacts, twice the stress along the axis.
    const effective::State low{.law = law,
                               .tangential_ratio = contact::mindlin_stiffness_ratio(grain.poisson_ratio),
                               .radius = 0.5e-3,
                               .void_ratio = 0.56,
                               .coordination_number = 5,
                               .fabric_anisotropy = 0.2,
                               .stress_v = 15e3,
                               .stress_h = 7.5e3};
    effective::State high = low;
    high.stress_v *= 10;
    high.stress_h *= 10;
    const double same_contacts = slope(low, high);

    // 2. How the two stresses share that exponent, by exact derivative.
    const auto share = effective::uniform_strain_exponents(low, effective::Modulus::G_vh);

    // 3. Let the number of contacts grow as p^0.05, as it does in weakly coordinated packings. More contacts
    //    carry less force each: G ~ C_n^(1-b) p^b, so that s gains 0.05 (1-b).
    *high.coordination_number *= std::pow(10, 0.05);
    const double more_contacts = slope(low, high);
    std::printf("%5.3g   %11.4f   %16.4f   %7.4f + %.4f = %.4f   %20.4f\n", law.alpha(), b, same_contacts,
                share.stress_h, share.stress_v, share.sum(), more_contacts);

    worst = std::max({worst, std::abs(same_contacts - b), std::abs(share.sum() - b),
                      std::abs(more_contacts - b - 0.05 * (1 - b))});
  }

  // 4. Check: all three statements hold to rounding.
  std::printf("largest departure from the statements above: %.1e\n", worst);
  return worst < 1e-12 ? 0 : 1;
}

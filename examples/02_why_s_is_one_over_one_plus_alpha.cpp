// SPDX-License-Identifier: GPL-3.0-or-later
//
// Example 02: why is s = 1/(1+alpha) in G ~ p^s?
//
// The surface of a grain near a contact has the profile z = A r^alpha: z is the height at the distance r from
// the axis of the contact. Two such grains with the overlap d (the approach of their centres) repel each
// other with a force f ~ d^(1+1/alpha). So the normal stiffness of the contact is k_n ~ f^(1/(1+alpha)).
// Contact forces are proportional to the mean stress p, and the shear modulus G is proportional to k_n. If
// nothing else changes, G ~ p^s has the exponent of k_n: s = 1/(1+alpha). In loose packings the number of
// contacts also grows with p, and their s is larger.
//
// The table has one line for each shape. Its columns: s with a constant number of contacts; the exponents of
// G_hv in the horizontal stress sigma_h and in the vertical stress sigma_v, with their sum; and s if the
// number of contacts grows as p^0.05. G_hv = G_vh is the shear modulus of a vertical plane.
#include <algorithm>
#include <cmath>
#include <cstdio>

#include <granum/effective/exponents.hpp>
#include <granum/effective/uniform_field.hpp>

using namespace granum;

namespace {

/// s between two states with the same ratio of stresses, from their shear moduli.
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

    // 1. A packing at mean stresses of 10 and of 100 kPa with the same contacts. The vertical stress is twice
    //    the horizontal one; b = 1/(1+alpha) is the exponent of k_n in f.
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

    // 2. The exponents of the two stresses in G_vh, by exact derivatives. Their sum is s.
    const auto share = effective::uniform_strain_exponents(low, effective::Modulus::G_vh);

    // 3. Now the number of contacts per grain, C_n, grows as p^0.05; in packings with few contacts it grows
    //    with p. Each of more contacts carries less force: G ~ C_n^(1-b) p^b, so s increases by 0.05 (1-b).
    *high.coordination_number *= std::pow(10, 0.05);
    const double more_contacts = slope(low, high);
    std::printf("%5.3g   %11.4f   %16.4f   %7.4f + %.4f = %.4f   %20.4f\n", law.alpha(), b, same_contacts,
                share.stress_h, share.stress_v, share.sum(), more_contacts);

    worst = std::max({worst, std::abs(same_contacts - b), std::abs(share.sum() - b),
                      std::abs(more_contacts - b - 0.05 * (1 - b))});
  }

  // 4. Check: the three values of s are b, b and b + 0.05 (1-b), to rounding errors.
  std::printf("largest departure from the statements above: %.1e\n", worst);
  return worst < 1e-12 ? 0 : 1;
}

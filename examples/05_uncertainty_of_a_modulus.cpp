// SPDX-License-Identifier: GPL-3.0-or-later
//
// Example 05: how well is G known, if its inputs are known only so well?
//
// A dense packing of glass-like spheres at 100 kPa. Contacts per grain come from a tomography, the void ratio
// from weighing, the shear modulus of the grains from a data sheet: each is known to within an error. The
// derivatives of the closed form say at once what that makes of G and which input is worth measuring better;
// sampling takes longer, and shows how far the derivatives can be trusted.
#include <cmath>
#include <cstdio>

#include <granum/effective/relaxation.hpp>
#include <granum/effective/sensitivity/uncertainty.hpp>

using namespace granum;
using effective::Input;

namespace {

constexpr effective::Sampling sampling{.draws = 20000, .seed = 1};

/// The standard deviations of three inputs, all taken `times` as large.
effective::Deviations deviations(double times) {
  effective::Deviations of;
  of[Input::coordination_number] = 0.2 * times;
  of[Input::void_ratio] = 0.02 * times;
  of[Input::grain_shear_modulus] = 2e9 * times;
  return of;
}

void print(const char* name, const effective::Uncertainty& u) {
  std::printf(
      "%-24s G = %6.1f MPa   first order +- %5.1f   sampled +- %5.1f, %6.1f to %6.1f   %4.1f %% rejected\n",
      name, u.value / 1e6, u.first_order.deviation / 1e6, u.sampled.deviation / 1e6, u.sampled.low / 1e6,
      u.sampled.high / 1e6, 100.0 * static_cast<double>(u.rejected) / static_cast<double>(sampling.draws));
}

double share(const effective::Uncertainty& u, Input input) {
  return u.first_order.share(u.first_order.contributions[static_cast<std::size_t>(input)]);
}

} // namespace

int main() {
  // 1. The packing, at the best values of its inputs.
  const contact::GrainMaterial grain{.shear_modulus = 30e9, .poisson_ratio = 0.15};
  const effective::State dense{.law = contact::PowerLaw::sphere(grain, 0.5e-3),
                               .tangential_ratio = contact::mindlin_stiffness_ratio(grain.poisson_ratio),
                               .radius = 0.5e-3,
                               .void_ratio = 0.558,
                               .coordination_number = 5.73,
                               .stress_v = 100e3,
                               .stress_h = 100e3};
  const auto G = effective::Modulus::G_vh;

  // 2. Uniform strain: G ~ (C_n G_g/(1+e))^(2/3). The powers are mild, so the first order is nearly right
  //    even for errors of a third of an input, where draws begin to leave the range of what is possible.
  std::printf("uniform strain, rung 2: deviations of C_n 0.2, e 0.02, G_g 2 GPa, and multiples of them\n");
  const effective::Uncertainty u = effective::uncertainty(dense, {}, G, deviations(1), sampling);
  print("  once", u);
  for (const double times : {3.0, 8.0}) {
    char name[20];
    std::snprintf(name, sizeof name, "  %.0f times", times);
    print(name, effective::uncertainty(dense, {}, G, deviations(times), sampling));
  }
  std::printf("  of the variance: C_n %.0f %%, e %.0f %%, G_g %.0f %%\n\n",
              100 * share(u, Input::coordination_number), 100 * share(u, Input::void_ratio),
              100 * share(u, Input::grain_shear_modulus));

  // 3. Relaxed: G depends on z*, the contacts per grain without rattlers, and falls to zero near four of
  //    them. The nearer z* is to that, the more the same error matters; that of the calibration adds to it.
  std::printf("relaxed, rung 3: deviation of z* 0.2\n");
  effective::Deviations of_z;
  of_z[Input::mechanical_coordination_number] = 0.2;
  for (const double z : {6.0, 4.6, 4.1}) {
    char name[20];
    std::snprintf(name, sizeof name, "  z* = %.1f", z);
    const auto relaxed = effective::relaxed_uncertainty(dense, z, G, of_z, sampling);
    print(name, relaxed);
    std::printf("  of the variance: z* %.0f %%, calibration %.0f %%\n",
                100 * share(relaxed, Input::mechanical_coordination_number),
                100 * relaxed.first_order.share(relaxed.first_order.calibration));
  }

  // 4. First order breaks down where the error reaches the isostatic point, below which every draw has
  //    G = 0: it then promises negative moduli, which do not exist.
  const auto near = effective::relaxed_uncertainty(dense, 4.1, G, of_z, sampling);
  const double promised = near.value - near.first_order.deviation;
  std::printf("\nat z* = 4.1 first order puts 16 %% of all packings below G = %.1f MPa; sampled: %.1f MPa\n",
              promised / 1e6, near.sampled.low / 1e6);

  // 5. Check: the shares are those of the powers, and small errors sample as they are derived.
  const double by_contacts = 2.0 / 3 * 0.2 / 5.73, by_voids = 2.0 / 3 * 0.02 / 1.558,
               by_grain = 2.0 / 3 * 2 / 30;
  const double expected = std::hypot(by_contacts, by_voids, by_grain) * u.value;
  const bool derived = std::abs(u.first_order.deviation / expected - 1) < 1e-12;
  const bool sampled = std::abs(u.sampled.deviation / expected - 1) < 4 / std::sqrt(2.0 * 20000) + 0.01;
  return derived && sampled && promised < 0 && near.sampled.low == 0 ? 0 : 1;
}

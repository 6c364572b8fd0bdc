// SPDX-License-Identifier: GPL-3.0-or-later
// Needs granum::theory alone: a contact law, and an error that crosses the library's border.
#include <cmath>
#include <cstdio>

#include <granum/contact/power_law.hpp>
#include <granum/core/error.hpp>

int main() {
  using granum::contact::PowerLaw;
  // Grains of the paper's Table 1: k_n = (3 G^2 R f/(1-nu)^2)^(1/3) of Hertz's contact.
  const double shear_modulus = 30e9, poisson_ratio = 0.15, radius = 0.5e-3, force = 1;
  const auto sphere =
      PowerLaw::sphere({.shear_modulus = shear_modulus, .poisson_ratio = poisson_ratio}, radius);
  const double stiffness = sphere.stiffness_at_force(force);
  const double hertz = std::cbrt(3 * shear_modulus * shear_modulus * radius * force /
                                 ((1 - poisson_ratio) * (1 - poisson_ratio)));
  std::printf("k_n = %.6g N/m, by Hertz %.6g N/m\n", stiffness, hertz);
  if (!(std::abs(stiffness / hertz - 1) < 1e-14)) // both round off a handful of operations
    return 1;
  try {
    PowerLaw::sphere({.shear_modulus = shear_modulus, .poisson_ratio = 0.6}, radius);
  } catch (const granum::InvalidArgument& error) {
    std::printf("refused as it should be: %s\n", error.what());
    return 0;
  }
  return 1;
}

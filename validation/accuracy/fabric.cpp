// SPDX-License-Identifier: GPL-3.0-or-later
// Moments of E(gamma; a) = 3 (1 + a cos 2 gamma)/(4 pi (3-a)) as integrals of powers of x = cos gamma.
#include <granum/fabric/orientation.hpp>

#include "harness.hpp"

namespace accuracy {

namespace {

/// Mean of x^n under the density 3/(2 (3-a)) (1 - a + 2 a x^2) on [-1, 1], n even.
Real mean_power(const Real& a, int n) { return 3 / (3 - a) * ((1 - a) / (n + 1) + 2 * a / (n + 3)); }

} // namespace

void check_fabric(Table& table, std::size_t samples) {
  Draw draw(2);
  const std::string domain = "a in [-1, 1]";
  for (std::size_t k = 0; k < samples; ++k) {
    const double a = draw.anisotropy(), angle = draw.uniform(0, 3.14159);
    const Real A = a, m2 = mean_power(A, 2), m4 = mean_power(A, 4);
    const std::string at = said({{"a", a}});
    const auto second = granum::fabric::second_moments(a);
    const auto fourth = granum::fabric::fourth_moments(a);
    table.take("fabric: second_moments", domain, closed_form, second.F33, m2, at);
    table.take("fabric: second_moments", domain, closed_form, second.F11, (1 - m2) / 2, at);
    table.take("fabric: fourth_moments", domain, closed_form, fourth.n3333, m4, at);
    table.take("fabric: fourth_moments", domain, closed_form, fourth.n1111, 3 * (1 - 2 * m2 + m4) / 8, at);
    table.take("fabric: fourth_moments", domain, closed_form, fourth.n1122, (1 - 2 * m2 + m4) / 8, at);
    table.take("fabric: fourth_moments", domain, closed_form, fourth.n1133, (m2 - m4) / 2, at);
    const Real E = 3 * (1 + A * cos(2 * Real(angle))) / (4 * pi() * (3 - A));
    table.take_against("fabric: density", "a in [-1, 1], of the largest E", closed_form,
                       granum::fabric::density(angle, a), E, 3 * (1 + abs(A)) / (4 * pi() * (3 - A)),
                       at + " " + said({{"gamma", angle}}));
    const double F33 = draw.uniform_or(0.2, 0.6, {0.2, 0.6, 0.5});
    table.take_against("fabric: anisotropy_from_F33", "F33 in [0.2, 0.6], of 1", closed_form,
                       granum::fabric::anisotropy_from_F33(F33),
                       5 * (3 * Real(F33) - 1) / (5 * Real(F33) + 1), Real(1), said({{"F33", F33}}));
  }
}

} // namespace accuracy

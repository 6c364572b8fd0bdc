// SPDX-License-Identifier: GPL-3.0-or-later
// Moments of E(gamma; a) = 3 (1 + a cos 2 gamma)/(4 pi (3-a)) as integrals of powers of x = cos gamma,
// measures of the fabric, its distribution over the polar angle, and the root of the likelihood equation.
#include <granum/fabric/estimates.hpp>
#include <granum/fabric/orientation.hpp>

#include "packing.hpp"

namespace accuracy {

namespace {

using granum::fabric::FabricMeasures;

/// All measures of a: a and a_c by themselves, the others of 1.
void compare_measures(Table& table, const std::string& function, const std::string& domain,
                      const FabricMeasures& found, const Real& a, const std::string& where) {
  const At at{table, domain, where};
  const Real F33 = 3 / (3 - a) * ((1 - a) / 3 + 2 * a / 5);
  at(function + " a, P2", found.anisotropy, a);
  at(function + " a, P2", found.P2_coefficient, 4 * a / (3 - a));
  at.of(1, function + " F, cos 2 gamma (of 1)", found.F33, F33);
  at.of(1, function + " F, cos 2 gamma (of 1)", found.F11, (1 - F33) / 2);
  at.of(1, function + " F, cos 2 gamma (of 1)", found.mean_cos_2gamma, 2 * F33 - 1);
}

void check_measures(Table& table, Draw& draw) {
  using namespace granum::fabric;
  const double a = draw.uniform_or(-5, 5.0 / 3, {-5.0, -1.0, 0.0, 1.0, 1e-9});
  compare_measures(table, "measures_from_anisotropy", "a in [-5, 5/3]", measures_from_anisotropy(a), a,
                   said("a", {a}));
  const double F33 = draw.uniform_or(0, 1, {0.0, 0.2, 0.6, 1.0, 1.0 / 3});
  compare_measures(table, "measures_from_F33", "F33 in [0, 1]", measures_from_F33(F33),
                   5 * (3 * Real(F33) - 1) / (5 * Real(F33) + 1), said("F33", {F33}));
  const double c = draw.uniform_or(-2.5, 5, {-2.5, 0.0, 5.0, 1e-9});
  compare_measures(table, "measures_from_P2_coefficient", "P2 in [-5/2, 5]", measures_from_P2_coefficient(c),
                   3 * Real(c) / (4 + Real(c)), said("P2", {c}));
  const double m = draw.uniform_or(-1, 1, {-1.0, 0.0, 1.0, -1.0 / 3});
  compare_measures(table, "measures_from_mean_cos_2gamma", "mean in [-1, 1]",
                   measures_from_mean_cos_2gamma(m), 5 * (1 + 3 * Real(m)) / (7 + 5 * Real(m)),
                   said("mean", {m}));
}

/// Share of contacts with |cos gamma| below t: integral of 3/(3-a) (1 - a + 2 a x^2).
Real share(const Real& t, const Real& a) { return 3 / (3 - a) * ((1 - a) * t + 2 * a * t * t * t / 3); }

void check_polar(Table& table, Draw& draw) {
  const double a = draw.anisotropy(), t = draw.uniform_or(0, 1, {0.0, 1.0, 1e-9, 1e-300});
  At{table, "a in [-1, 1]", said("t a", {t, a})}("cumulative_probability",
                                                 granum::fabric::cumulative_probability(t, a), share(t, a));
  const double p = draw.uniform_or(0, 1, {0.0, 1.0, 1e-9, 1e-250});
  At{table, "a in [-1, 1]",
     said("p a", {p, a})}("P(polar_cosine_quantile)",
                          static_cast<double>(share(granum::fabric::polar_cosine_quantile(p, a), a)), p);
}

/// a_c where sum x/(1 + a_c x) vanishes in [-1, 2], or the end where the sum still points outwards.
Real most_likely(const std::vector<Real>& x) {
  const auto score = [&x](const Real& a_c) {
    Real sum = 0;
    for (const Real& value : x)
      sum += value / (1 + a_c * value);
    return sum;
  };
  Real low = -1, high = 2;
  if (score(high) >= 0)
    return high;
  if (score(low) <= 0)
    return low;
  for (int k = 0; k < 90; ++k) {
    const Real middle = (low + high) / 2;
    (score(middle) > 0 ? low : high) = middle;
  }
  return (low + high) / 2;
}

void check_likelihood(Table& table, Draw& draw) {
  const double a = draw.anisotropy();
  std::vector<granum::Vec3> normals;
  std::vector<Real> x;
  for (int k = 0; k < 200; ++k) {
    const double n3 = granum::fabric::polar_cosine_quantile(draw.uniform(0, 1), a);
    normals.push_back({std::sqrt((1 - n3) * (1 + n3)), 0, n3});
    const Real across = normals.back().x, along = n3, square = along * along;
    x.push_back((3 * square / (square + across * across) - 1) / 2);
  }
  const Real a_c = most_likely(x);
  At{table, "200 contacts of a in [-1, 1]", said("a", {a}), quadrature}.of(
      1, "estimate_anisotropy_by_likelihood (of 1)",
      granum::fabric::estimate_anisotropy_by_likelihood(normals).anisotropy, 3 * a_c / (4 + a_c));
}

} // namespace

void check_fabric(Table& table, Draw& draw, std::size_t /*sample*/) {
  const double a = draw.anisotropy(), angle = draw.uniform(0, 3.14159);
  const Real A = a;
  const Moments m = fabric_moments(A);
  const auto second = granum::fabric::second_moments(a);
  const auto fourth = granum::fabric::fourth_moments(a);
  const At at{table, "a in [-1, 1]", said("a", {a})};
  at("fabric: second_moments", second.F33, m.m2);
  at("fabric: second_moments", second.F11, m.n11());
  at("fabric: fourth_moments", fourth.n3333, m.m4);
  at("fabric: fourth_moments", fourth.n1111, 3 * m.n1122());
  at("fabric: fourth_moments", fourth.n1122, m.n1122());
  at("fabric: fourth_moments", fourth.n1133, m.n1133());
  At{table, "a in [-1, 1], of the largest E", at.where + " " + said("gamma", {angle})}.of(
      3 * (1 + abs(A)) / (4 * pi() * (3 - A)), "fabric: density", granum::fabric::density(angle, a),
      3 * (1 + A * cos(2 * Real(angle))) / (4 * pi() * (3 - A)));
  const double F33 = draw.uniform_or(0.2, 0.6, {0.2, 0.6, 0.5});
  At{table, "F33 in [0.2, 0.6], of 1", said("F33", {F33})}.of(1, "fabric: anisotropy_from_F33",
                                                              granum::fabric::anisotropy_from_F33(F33),
                                                              5 * (3 * Real(F33) - 1) / (5 * Real(F33) + 1));
}

void check_distribution(Table& table, Draw& draw, std::size_t k) {
  check_measures(table, draw);
  check_polar(table, draw);
  if (k % 200 == 0)
    check_likelihood(table, draw);
}

} // namespace accuracy

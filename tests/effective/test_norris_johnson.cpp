// SPDX-License-Identifier: GPL-3.0-or-later
#include <granum/effective/norris_johnson.hpp>

#include <doctest/doctest.h>

#include <array>
#include <cmath>
#include <functional>
#include <numbers>

#include <Eigen/Core>
#include <granum/core/error.hpp>
#include <granum/effective/hertz_mindlin.hpp>
#include <granum/elastic/isotropic.hpp>

#include "relative.hpp"
#include "support.hpp"

using namespace granum;
using namespace granum::effective;

namespace {

StrainedPack pack_of(double K, double G, double porosity, double C, double e0, double e3) {
  return {.grain = {G, elastic::Isotropic::from_bulk_and_shear(K, G).poisson_ratio()},
          .porosity = porosity,
          .coordination_number = C,
          .hydrostatic_strain = e0,
          .uniaxial_strain = e3};
}

/// Contacts of the strained packing over a fine grid of directions. The substitution x = t^8 puts the points
/// where the root of e0 + e3 x^2 bends.
std::vector<test::Direction> directions_of(const StrainedPack& p) {
  const double r = p.no_slip_share * contact::mindlin_stiffness_ratio(p.grain.poisson_ratio);
  const contact::PowerLaw law = contact::PowerLaw::sphere(p.grain, 1.0);
  std::vector<test::Direction> out;
  constexpr int around = 8;
  for (const auto& [y, w] : gauss_legendre(200)) {
    const double t = (y + 1) / 2, x = std::pow(t, 8), jacobian = 4 * std::pow(t, 7);
    const double k = law.stiffness_at_overlap(2 * (p.hydrostatic_strain + p.uniaxial_strain * x * x));
    for (int i = 0; i < around; ++i) {
      const double azimuth = 2 * M_PI * (i + 0.3) / around, sine = std::sqrt((1 - x) * (1 + x));
      out.push_back(
          {{sine * std::cos(azimuth), sine * std::sin(azimuth), x}, w * jacobian / around, k, r * k});
    }
  }
  return out;
}

/// 3 C_n (1-porosity)/(2 pi R), R = 1.
double contact_density(const StrainedPack& p) {
  return 3 * p.coordination_number * (1 - p.porosity) / (2 * M_PI);
}

/// Stress by following every contact along the path in small steps: f_n = c d^(3/2), df_t = k_t du_t.
std::array<double, 2> stress_in_steps(const StrainedPack& p,
                                      const std::function<std::array<double, 2>(double)>& path) {
  const contact::PowerLaw law = contact::PowerLaw::sphere(p.grain, 1.0);
  const double r = p.no_slip_share * contact::mindlin_stiffness_ratio(p.grain.poisson_ratio);
  std::array<double, 2> stress{};
  constexpr int steps = 4000;
  for (const auto& [y, w] : gauss_legendre(24)) {
    const double x = (y + 1) / 2, x2 = x * x;
    double tangential = 0; // along growing x, per x (1-x^2)^(1/2)
    for (int k = 0; k < steps; ++k) {
      const auto before = path(double(k) / steps), after = path(double(k + 1) / steps);
      const double e0 = (before[0] + after[0]) / 2, e3 = (before[1] + after[1]) / 2;
      tangential += r * law.stiffness_at_overlap(2 * (e0 + e3 * x2)) * 2 * (after[1] - before[1]);
    }
    const auto end = path(1);
    const double normal = law.force(2 * (end[0] + end[1] * x2));
    const double share = w / 2 * contact_density(p) / 2; // N_c l/V = P/l
    stress[0] += share * (normal * x2 + tangential * x2 * (1 - x2));
    stress[1] += share * (normal - tangential * x2) * (1 - x2) / 2;
  }
  return stress;
}

} // namespace

TEST_CASE("norris_johnson: printed numbers of the correct formulas") {
  const auto c = norris_johnson(pack_of(37e9, 44e9, 0.36, 6, 0.03, 0.05));
  CHECK(c.C11 == relative(11.338976e9, 5e-8));
  CHECK(c.C12 == relative(0.0857965e9, 1e-6));
  CHECK(c.C13 == relative(0.1008496e9, 1e-6));
  CHECK(c.C33 == relative(13.936804e9, 5e-8));
  CHECK(c.C44 == relative(6.269697e9, 1e-7));
  CHECK(c.C66() == relative(5.626590e9, 1e-7));
  const StrainedPack walton = pack_of(36e9, 45e9, 0.38, 8, 0, 0.01); // uniaxial strain alone
  const auto w = norris_johnson(walton);
  CHECK(w.C11 == relative(2.7878792e9, 5e-8));
  CHECK(w.C12 == relative(0.0142968e9, 5e-6));
  CHECK(w.C13 == relative(0.0285936e9, 5e-6));
  CHECK(w.C33 == relative(5.6043520e9, 5e-8));
  CHECK(w.C44 == relative(2.0873352e9, 5e-8));
  CHECK(w.C66() == relative(1.3867912e9, 5e-8));
  const auto stress = norris_johnson_stress(walton, StrainPath::together);
  CHECK(stress.vertical == relative(37.362346e6, 2e-8));
  CHECK(stress.horizontal == relative(0.190624e6, 3e-6));
}

TEST_CASE("norris_johnson: the sum over contacts, at any ratio of the strains") {
  for (const double share : {0.0, 0.4, 1.0})
    for (const double ratio : {0.0, 1e-8, 1e-4, 0.01, 0.1, 0.29, 0.31, 1.0, 3.0, 100.0, 1e4, 1e8}) {
      StrainedPack p = pack_of(37e9, 44e9, 0.36, 6, 1e-4 * ratio / (1 + ratio), 1e-4 / (1 + ratio));
      p.no_slip_share = share;
      const auto brute = test::stiffness_by_strain(contact_density(p), directions_of(p));
      CHECK(test::difference(norris_johnson(p), brute) < 1e-13);
    }
}

TEST_CASE("norris_johnson: isotropic and uniaxial limits") {
  const auto isotropic = norris_johnson(pack_of(37e9, 44e9, 0.36, 6, 2e-4, 0));
  const auto nearly = norris_johnson(pack_of(37e9, 44e9, 0.36, 6, 2e-4, 2e-18));
  CHECK(isotropic.C11 == relative(isotropic.C33, 1e-14));
  CHECK(isotropic.C44 == relative(isotropic.C66(), 1e-14));
  CHECK(test::difference(nearly, isotropic) < 1e-13);
  // The pressure of that strain brings Hertz and Mindlin's moduli.
  const StrainedPack p = pack_of(37e9, 44e9, 0.36, 6, 2e-4, 0);
  const auto stress = norris_johnson_stress(p, StrainPath::hydrostatic_first);
  CHECK(stress.horizontal == relative(stress.vertical, 1e-14));
  const IsotropicModuli moduli = hertz_mindlin({p.grain, p.porosity, p.coordination_number, stress.vertical});
  CHECK(moduli.bulk_modulus == relative(isotropic.bulk_modulus(), 1e-14));
  CHECK(moduli.shear_modulus == relative(isotropic.C44, 1e-14));

  const auto uniaxial = norris_johnson(pack_of(37e9, 44e9, 0.36, 6, 0, 1e-4));
  const auto almost = norris_johnson(pack_of(37e9, 44e9, 0.36, 6, 1e-20, 1e-4));
  CHECK(test::difference(almost, uniaxial) < 1e-13);
  // C33 = 3/2 stress/strain of a proportional path.
  CHECK(
      uniaxial.C33 ==
      relative(
          1.5 * norris_johnson_stress(pack_of(37e9, 44e9, 0.36, 6, 0, 1e-4), StrainPath::together).vertical /
              1e-4,
          1e-14));
  CHECK(norris_johnson(pack_of(37e9, 44e9, 0.36, 6, 0, 0)).C33 == 0);
  CHECK(norris_johnson_stress(pack_of(37e9, 44e9, 0.36, 6, 0, 0), StrainPath::hydrostatic_first).vertical ==
        0);
}

TEST_CASE("norris_johnson: stresses of three paths, against following the contacts in small steps") {
  const StrainedPack p = pack_of(37e9, 44e9, 0.36, 6, 0.03, 0.05);
  const double e0 = p.hydrostatic_strain, e3 = p.uniaxial_strain;
  const auto compare = [&](StrainPath path, const std::function<std::array<double, 2>(double)>& along) {
    const auto closed = norris_johnson_stress(p, path);
    const auto steps = stress_in_steps(p, along);
    CHECK(closed.vertical == relative(steps[0], 1e-6));
    CHECK(closed.horizontal == relative(steps[1], 1e-6));
    return closed;
  };
  using Point = std::array<double, 2>;
  const auto together = compare(StrainPath::together, [=](double t) { return Point{e0 * t, e3 * t}; });
  const auto hydrostatic = compare(StrainPath::hydrostatic_first, [=](double t) {
    return Point{e0 * std::min(1.0, 2 * t), e3 * std::max(0.0, 2 * t - 1)};
  });
  const auto uniaxial = compare(StrainPath::uniaxial_first, [=](double t) {
    return Point{e0 * std::max(0.0, 2 * t - 1), e3 * std::min(1.0, 2 * t)};
  });
  // The stiffer the contacts are while they are sheared, the more shear stress they keep.
  CHECK(hydrostatic.vertical > together.vertical);
  CHECK(together.vertical > uniaxial.vertical);
  CHECK(hydrostatic.horizontal < uniaxial.horizontal);
  // The mean stress does not know of tangential forces.
  CHECK(hydrostatic.vertical + 2 * hydrostatic.horizontal ==
        relative(uniaxial.vertical + 2 * uniaxial.horizontal, 1e-14));
}

TEST_CASE("norris_johnson: what no packing can have is refused by name") {
  StrainedPack p = pack_of(37e9, 44e9, 0.36, 6, 0.03, 0.05);
  p.uniaxial_strain = -0.05;
  CHECK_THROWS_WITH_AS((void)norris_johnson(p), "uniaxial_strain = -0.05 is outside [0, inf)",
                       InvalidArgument);
  p = pack_of(37e9, 44e9, 36, 6, 0.03, 0.05);
  CHECK_THROWS_AS((void)norris_johnson_stress(p, StrainPath::together), InvalidArgument);
}

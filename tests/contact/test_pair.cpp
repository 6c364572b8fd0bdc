// SPDX-License-Identifier: GPL-3.0-or-later
#include <granum/contact/grains.hpp>

#include "unit.hpp"

using namespace granum::contact;

namespace {

constexpr double ulps = 8 * std::numeric_limits<double>::epsilon();
constexpr GrainMaterial hard_quartz{.shear_modulus = 44e9, .poisson_ratio = 0.08};
constexpr GrainMaterial feldspar{.shear_modulus = 15e9, .poisson_ratio = 0.32};

/// E* of a pair, from the plane-strain moduli of both.
double contact_modulus(const GrainMaterial& i, const GrainMaterial& j) {
  return 1 / ((1 - i.poisson_ratio) / (2 * i.shear_modulus) + (1 - j.poisson_ratio) / (2 * j.shear_modulus));
}

} // namespace

TEST_CASE("the pair radius of equal grains is their radius to the bit, in either order") {
  for (const double r : {0.3e-3, 0.1, 1.0, 7e-300, 7e300})
    CHECK(pair_radius(r, r) == r);
  CHECK(pair_radius(1e-3, 3e-3) == relative(1.5e-3, ulps));
  CHECK(pair_radius(1e-3, 3e-3) == relative(pair_radius(3e-3, 1e-3), ulps));
  CHECK(pair_radius(1.0, 1e12) == relative(2.0, 1e-11)); // on a plane, R* is R
}

TEST_CASE("a pair of unequal spheres has Hertz's force, f = 4/3 E* sqrt(R*) d^(3/2)") {
  const double ri = 0.4e-3, rj = 1.3e-3, d = 2e-7;
  const double effective_radius = 1 / (1 / ri + 1 / rj);
  const PowerLaw law = PowerLaw::sphere(pair_material(hard_quartz, feldspar), pair_radius(ri, rj));
  const double hertz =
      4.0 / 3 * contact_modulus(hard_quartz, feldspar) * std::sqrt(effective_radius) * std::pow(d, 1.5);
  CHECK(law.force(d) == relative(hertz, ulps));
  // Tangentially, k_t = 8 G* a with 1/G* = (2-nu_i)/G_i + (2-nu_j)/G_j and a^2 = R* d.
  const double tangential = 8 / ((2 - 0.08) / 44e9 + (2 - 0.32) / 15e9) * std::sqrt(effective_radius * d);
  const double ratio = mindlin_stiffness_ratio(pair_material(hard_quartz, feldspar).poisson_ratio);
  CHECK(ratio * law.stiffness_at_overlap(d) == relative(tangential, ulps));
}

TEST_CASE("two grains of one material are that material to the bit") {
  const GrainMaterial same = pair_material(feldspar, feldspar);
  CHECK(same.shear_modulus == feldspar.shear_modulus);
  CHECK(same.poisson_ratio == feldspar.poisson_ratio);
  for (const double ratio : {0.1, 0.3, 3.0, 7.0, 1e5}) { // of different ones in either order
    const GrainMaterial other{.shear_modulus = ratio * hard_quartz.shear_modulus, .poisson_ratio = 0.2};
    CHECK(pair_material(hard_quartz, other) == pair_material(other, hard_quartz));
  }
  // A hard grain moves nothing: twice the modulus of the soft one.
  const GrainMaterial hard{.shear_modulus = 1e25, .poisson_ratio = 0.3};
  CHECK(pair_material(hard, feldspar).shear_modulus == relative(2 * feldspar.shear_modulus, 1e-12));
  CHECK(pair_material(hard, feldspar).poisson_ratio == relative(feldspar.poisson_ratio, 1e-12));
}

TEST_CASE("a material that cannot be is refused") {
  for (const GrainMaterial& bad : {GrainMaterial{0, 0.1}, GrainMaterial{1e9, 0.6}}) {
    CHECK_THROWS_AS((void)pair_material(hard_quartz, bad), InvalidArgument);
    CHECK_THROWS_AS((void)pair_material(bad, hard_quartz), InvalidArgument);
  }
}

TEST_CASE("laws of grains of given sizes: by Hertz for spheres, the same for all other shapes") {
  const double mean_radius = 0.5e-3, d = 1e-7;
  const PowerLaw sphere = PowerLaw::sphere(hard_quartz, mean_radius);
  for (const auto& [i, j] : {std::pair(1.0, 1.0), {0.5, 2.0}, {1.7, 0.3}, {0.2, 0.2}, {5.0, 1.0}}) {
    const PowerLaw expected = PowerLaw::sphere(hard_quartz, pair_radius(mean_radius * i, mean_radius * j));
    CHECK(of_sizes(sphere, i, j).force(d) == relative(expected.force(d), ulps));
    CHECK(of_sizes(SphereKernel{sphere.coefficient()}, i, j)(d).force == relative(expected.force(d), ulps));
    const PowerLaw cone = PowerLaw::cone(hard_quartz, 0.4); // and others: test_laws.cpp
    CHECK(of_sizes(cone, i, j) == NormalLaw(cone));
  }
  for (const double wrong : {0.0, -1.0, std::numeric_limits<double>::infinity()}) {
    CHECK_THROWS_AS((void)of_sizes(sphere, wrong, 1), InvalidArgument);
    CHECK_THROWS_AS((void)of_sizes(sphere, 1, wrong), InvalidArgument);
    CHECK_THROWS_AS((void)sphere.times(wrong), InvalidArgument);
  }
}

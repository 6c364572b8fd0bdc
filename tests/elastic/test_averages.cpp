// SPDX-License-Identifier: GPL-3.0-or-later
#include <granum/elastic/isotropic.hpp>

#include <random>

#include <Eigen/LU>
#include <granum/core/numerics.hpp>
#include <granum/elastic/stiffness.hpp>

#include "samples.hpp"
#include "unit.hpp"

using namespace granum::elastic;

namespace {

/// Mean of a tensor over all rotations, by Euler angles: a turned tensor of fourth rank has harmonics up to
/// 4, which five Gauss points in the cosine and five equal steps in each of the other angles average exactly.
Matrix6 mean_over_rotations(const Matrix6& m) {
  Matrix6 mean = Matrix6::Zero();
  const double step = 2 * std::numbers::pi / 5;
  for (const auto& [x, w] : gauss_legendre(5))
    for (int i = 0; i < 5; ++i)
      for (int j = 0; j < 5; ++j) {
        const Mat3 turn = rotation_about({0, 0, 1}, i * step) * rotation_about({0, 1, 0}, std::acos(x)) *
                          rotation_about({0, 0, 1}, j * step);
        mean += w / 50 * rotate(MandelStiffness{m}, turn).matrix;
      }
  return mean;
}

} // namespace

TEST_CASE("averages: Voigt is the mean stiffness over all rotations, Reuss the mean compliance") {
  const Matrix6 c = mandel(triclinic_sample()).matrix;
  const Matrix6 stiffness = mean_over_rotations(c), compliance = mean_over_rotations(c.inverse());
  const IsotropicAverages m = isotropic_averages(triclinic_sample());
  CHECK(relative_distance({stiffness}, mandel(voigt(m.voigt))) < 1e-14);
  CHECK(relative_distance({compliance}, {mandel(voigt(m.reuss)).matrix.inverse()}) < 1e-14);
  CHECK(m.hill.bulk_modulus() == relative((m.voigt.bulk_modulus() + m.reuss.bulk_modulus()) / 2, 1e-15));
  CHECK(m.hill.shear_modulus() == relative((m.voigt.shear_modulus() + m.reuss.shear_modulus()) / 2, 1e-15));
  CHECK(m.reuss.shear_modulus() < 0.999 * m.voigt.shear_modulus());
  CHECK(engineering_moduli(triclinic_sample()).bulk_modulus == relative(m.voigt.bulk_modulus(), 1e-14));
}

TEST_CASE("averages: the closed form of transverse isotropy is that of the full matrix") {
  std::mt19937_64 random(17);
  for (int i = 0; i < 200; ++i) {
    const TransverselyIsotropic c = random_layered(random, -0.9, 0.9);
    const IsotropicAverages closed = isotropic_averages(c), full = isotropic_averages(voigt(c));
    CHECK(projected_shear_modulus(c) == relative(full.voigt.shear_modulus(), 1e-14));
    for (const auto modulus : {&Isotropic::bulk_modulus, &Isotropic::shear_modulus}) {
      const auto of = [&](const Isotropic& solid) { return (solid.*modulus)(); };
      CHECK(of(closed.voigt) == relative(of(full.voigt), 1e-14));
      CHECK(of(closed.reuss) == relative(of(full.reuss), 1e-12)); // condition numbers up to some 1000
      CHECK(of(closed.voigt) >= of(closed.hill));
      CHECK(of(closed.hill) >= of(closed.reuss));
    }
  }
}

TEST_CASE("averages: a stiffness with a floppy mode is refused") {
  TransverselyIsotropic c = layered_sample();
  c.C44 = 0;
  CHECK_THROWS_AS((void)isotropic_averages(c), InvalidArgument);
  for (const VoigtStiffness& bad : {voigt(c), VoigtStiffness{}})
    CHECK_THROWS_AS((void)isotropic_averages(bad), InvalidArgument);
}

// SPDX-License-Identifier: GPL-3.0-or-later
#include <granum/elastic/transverse_isotropic.hpp>

#include <Eigen/LU>
#include <doctest/doctest.h>
#include <granum/core/error.hpp>
#include <relative.hpp>

using namespace granum;
using namespace granum::elastic;

namespace {

// Stiffer along the vertical, as a packing under triaxial compression [Pa].
const TransverselyIsotropic sample{.C11 = 310e6, .C33 = 402e6, .C12 = 118e6, .C13 = 133e6, .C44 = 121e6};

// Rounding of a 6 x 6 inverse of condition number below 10.
doctest::Approx near(double value) { return relative(value, 1e-14); }

} // namespace

TEST_CASE("engineering moduli are those of the inverted 6 x 6 matrix") {
  const Matrix6 s = voigt(sample).matrix.inverse();
  CHECK(sample.E_v() == near(1 / s(2, 2)));
  CHECK(sample.E_h() == near(1 / s(0, 0)));
  CHECK(sample.nu_vh() == near(-s(0, 2) / s(2, 2)));
  CHECK(sample.nu_hv() == near(-s(2, 0) / s(0, 0)));
  CHECK(sample.nu_hh() == near(-s(1, 0) / s(0, 0)));
  CHECK(sample.G_vh() == near(1 / s(3, 3)));
  CHECK(sample.G_vh() == near(1 / s(4, 4)));
  CHECK(sample.G_hh() == near(1 / s(5, 5)));
  CHECK(sample.G_hh() == near(sample.E_h() / (2 * (1 + sample.nu_hh()))));
  CHECK(sample.nu_hv() / sample.E_h() == near(sample.nu_vh() / sample.E_v()));
}

TEST_CASE("bulk modulus is the mean stress under equal strains") {
  const Eigen::Vector<double, 6> strain{1. / 3, 1. / 3, 1. / 3, 0, 0, 0};
  const Eigen::Vector<double, 6> stress = voigt(sample).matrix * strain;
  CHECK(sample.bulk_modulus() == near(stress.head<3>().sum() / 3));
}

TEST_CASE("compliance and stiffness are inverse to each other") {
  const TransverselyIsotropicCompliance s = compliance(sample);
  const Matrix6 full = voigt(sample).matrix.inverse();
  CHECK(s.S11 == near(full(0, 0)));
  CHECK(s.S33 == near(full(2, 2)));
  CHECK(s.S12 == near(full(0, 1)));
  CHECK(s.S13 == near(full(1, 2)));
  CHECK(s.S44 == near(full(4, 4)));
  CHECK(s.S66() == near(full(5, 5)));
  const TransverselyIsotropic back = stiffness(s);
  CHECK(back.C11 == near(sample.C11));
  CHECK(back.C33 == near(sample.C33));
  CHECK(back.C12 == near(sample.C12));
  CHECK(back.C13 == near(sample.C13));
  CHECK(back.C44 == near(sample.C44));
}

TEST_CASE("a value that is not positive definite has no engineering moduli") {
  TransverselyIsotropic soft = sample;
  soft.C13 = 300e6; // C33 (C11+C12) < 2 C13^2
  CHECK(sample.positive_definite());
  CHECK_FALSE(soft.positive_definite());
  CHECK_FALSE(TransverselyIsotropic{}.positive_definite());
  CHECK_THROWS_AS((void)soft.E_v(), InvalidArgument);
  CHECK_THROWS_AS((void)TransverselyIsotropic{}.nu_hh(), InvalidArgument);
  CHECK_THROWS_AS((void)compliance(soft), InvalidArgument);
  CHECK_THROWS_AS((void)stiffness(TransverselyIsotropicCompliance{}), InvalidArgument);
  soft = sample;
  soft.C44 = 0;
  CHECK_FALSE(soft.positive_definite());
}

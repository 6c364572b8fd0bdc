// SPDX-License-Identifier: GPL-3.0-or-later
#include <granum/elastic/transverse_isotropic.hpp>

#include <Eigen/LU>

#include "unit.hpp"

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

TEST_CASE("transverse isotropy: units change no digit, however small or large the moduli") {
  const TransverselyIsotropic c{.C11 = 3e8, .C33 = 4.1e8, .C12 = 1.1e8, .C13 = 0.9e8, .C44 = 1.2e8};
  for (const int power : {-1000, -700, -560, 560, 700, 990}) {
    CAPTURE(power);
    const auto unit = [power](double x) { return std::scalbn(x, power); };
    const TransverselyIsotropic other{
        .C11 = unit(c.C11), .C33 = unit(c.C33), .C12 = unit(c.C12), .C13 = unit(c.C13), .C44 = unit(c.C44)};
    REQUIRE(other.positive_definite());
    CHECK(other.E_v() == unit(c.E_v()));
    CHECK(other.E_h() == unit(c.E_h()));
    CHECK(other.nu_hv() == c.nu_hv());
    CHECK(other.nu_vh() == c.nu_vh());
    CHECK(other.nu_hh() == c.nu_hh());
    CHECK(elastic::young_modulus(other, elastic::Loading::vertical) == unit(c.E_v()));
    const auto s = elastic::compliance(other);
    CHECK(s.S11 == std::scalbn(elastic::compliance(c).S11, -power));
    CHECK(elastic::stiffness(s).C13 == relative(other.C13, 1e-14));
  }
}

// SPDX-License-Identifier: GPL-3.0-or-later
#include <granum/elastic/transverse_isotropic.hpp>

#include <Eigen/LU>

#include "samples.hpp"
#include "unit.hpp"

using namespace granum::elastic;

namespace {

const TransverselyIsotropic sample = layered_sample();

// Rounding of a 6 x 6 inverse of condition number below 10.
doctest::Approx near(double value) { return relative(value, 1e-14); }

} // namespace

TEST_CASE("engineering moduli and compliances are those of the inverted 6 x 6 matrix") {
  const Matrix6 full = voigt(sample).matrix.inverse();
  const TransverselyIsotropicCompliance s = compliance(sample);
  CHECK(s.S11 == near(full(0, 0)));
  CHECK(s.S33 == near(full(2, 2)));
  CHECK(s.S12 == near(full(0, 1)));
  CHECK(s.S13 == near(full(1, 2)));
  CHECK(s.S44 == near(full(4, 4)));
  CHECK(s.S66() == near(full(5, 5)));
  CHECK(sample.E_v() == near(1 / full(2, 2)));
  CHECK(sample.E_h() == near(1 / full(0, 0)));
  CHECK(sample.nu_vh() == near(-full(0, 2) / full(2, 2)));
  CHECK(sample.nu_hv() == near(-full(2, 0) / full(0, 0)));
  CHECK(sample.nu_hh() == near(-full(1, 0) / full(0, 0)));
  CHECK(sample.G_vh() == near(1 / full(3, 3)));
  CHECK(sample.G_hh() == near(1 / full(5, 5)));
  CHECK(sample.bulk_modulus() == near(voigt(sample).matrix.topLeftCorner<3, 3>().sum() / 9));
  CHECK((voigt(stiffness(s)).matrix - voigt(sample).matrix).norm() < 1e-14 * voigt(sample).matrix.norm());
}

TEST_CASE("a value that is not positive definite has no engineering moduli") {
  TransverselyIsotropic soft = sample, floppy = sample;
  soft.C13 = 300e6; // C33 (C11+C12) < 2 C13^2
  floppy.C44 = 0;
  for (const TransverselyIsotropic& bad : {soft, floppy, TransverselyIsotropic{}}) {
    CHECK_FALSE(bad.positive_definite());
    CHECK_THROWS_AS((void)compliance(bad), InvalidArgument);
    // without any stiffness in shear grains give way to a single stress
    for (const Loading loading : {Loading::vertical, Loading::horizontal})
      CHECK(young_modulus(bad, loading) == (bad.C11 > 0 ? std::nullopt : std::optional(0.0)));
  }
  CHECK_THROWS_AS((void)soft.E_v(), InvalidArgument);
  CHECK_THROWS_AS((void)TransverselyIsotropic{}.nu_hh(), InvalidArgument);
  CHECK_THROWS_AS((void)stiffness(TransverselyIsotropicCompliance{}), InvalidArgument);
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

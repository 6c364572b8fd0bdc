// SPDX-License-Identifier: GPL-3.0-or-later
#include <granum/elastic/isotropic.hpp>

#include <granum/elastic/stiffness.hpp>

#include "samples.hpp"
#include "unit.hpp"

using namespace granum::elastic;

namespace {

using test::rounding;
using test::tilt;

} // namespace

TEST_CASE("isotropic projection does not change under rotation, nor by projecting in two steps") {
  const Isotropic once = isotropic_projection(triclinic_sample());
  const Isotropic turned = isotropic_projection(rotate(triclinic_sample(), tilt));
  CHECK(turned.bulk_modulus() == relative(once.bulk_modulus(), rounding));
  CHECK(turned.shear_modulus() == relative(once.shear_modulus(), rounding));
  const Isotropic twice = isotropic_projection(voigt(transversely_isotropic_projection(triclinic_sample())));
  CHECK(twice.bulk_modulus() == relative(once.bulk_modulus(), rounding));
  CHECK(twice.shear_modulus() == relative(once.shear_modulus(), rounding));
}

TEST_CASE("transversely isotropic projection is the average over turns about axis 3") {
  // entries of a turned stiffness have harmonics up to 4, which eight equal steps average exactly
  MandelStiffness mean;
  for (int step = 0; step < 8; ++step)
    mean.matrix +=
        mandel(rotate(triclinic_sample(), rotation_about({0, 0, 1}, step * std::numbers::pi / 4))).matrix / 8;
  const TransverselyIsotropic projected = transversely_isotropic_projection(triclinic_sample());
  CHECK(relative_distance(mean, mandel(voigt(projected))) < rounding);
}

TEST_CASE("projection about any axis is that about axis 3 of the turned material") {
  const Mat3 turn = rotation_about({1, -2, 0.5}, 0.8);
  const Vec3 axis = column(turn, 2); // where axis 3 has gone
  const TransverselyIsotropic layered = layered_sample();
  const VoigtStiffness turned = rotate(voigt(layered), turn);
  for (const Vec3& along : {axis, -axis, 1e-200 * axis, 3e200 * axis}) {
    CHECK(relative_distance(mandel(turned), mandel(voigt(layered, along))) < rounding);
    CHECK(relative_distance(mandel(voigt(layered)),
                            mandel(voigt(transversely_isotropic_projection(turned, along)))) < rounding);
  }
  // about axis 3 and its opposite, and beside them, it is the projection above
  for (const Vec3& along : {Vec3{0, 0, 1}, Vec3{0, 0, -2}, Vec3{2e-8, 0, 1}, Vec3{0, 2e-8, -1}})
    CHECK(relative_distance(mandel(voigt(transversely_isotropic_projection(triclinic_sample()))),
                            mandel(voigt(transversely_isotropic_projection(triclinic_sample(), along)))) <
          rounding + 10 * (std::abs(along.x) + std::abs(along.y)));
  // and about axis 1 it exchanges the indices
  const TransverselyIsotropic lying = transversely_isotropic_projection(triclinic_sample(), {1, 0, 0});
  CHECK(lying.C33 == relative(310e6, rounding));
  CHECK(lying.C13 == relative((118e6 + 133e6) / 2, rounding));
  CHECK(lying.C44 == relative((115e6 + 96e6) / 2, rounding));
  CHECK_THROWS_AS((void)voigt(layered, {0, 0, 0}), InvalidArgument);
  CHECK_THROWS_AS((void)isotropic_projection(VoigtStiffness{}), InvalidArgument);
  CHECK_THROWS_AS((void)transversely_isotropic_projection(turned, {0, std::nan(""), 1}), InvalidArgument);
}

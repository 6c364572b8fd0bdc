// SPDX-License-Identifier: GPL-3.0-or-later
#include <granum/elastic/isotropic.hpp>

#include <granum/elastic/stiffness.hpp>
#include <granum/elastic/waves.hpp>

#include "samples.hpp"
#include "unit.hpp"

using namespace granum::elastic;

namespace {

constexpr double few_roundings = 1e-13;

} // namespace

TEST_CASE("engineering moduli: E is a uniaxial stress over its strain") {
  const VoigtStiffness c = triclinic_sample();
  const EngineeringModuli m = engineering_moduli(c);
  const double E[] = {m.E_1, m.E_2, m.E_3};
  for (int axis = 0; axis < 3; ++axis) {
    const Eigen::Matrix<double, 6, 1> strain =
        c.matrix.inverse().col(axis); // of a stress of 1 along the axis
    CHECK(E[axis] == relative(1 / strain[axis], few_roundings));
  }
  CHECK(m.C55 == 115e6);
}

TEST_CASE("engineering moduli: a direction that gives way has E = 0, others keep theirs") {
  VoigtStiffness c;
  c.matrix.diagonal() << 300e6, 200e6, 0, 0, 100e6, 50e6;
  const EngineeringModuli m = engineering_moduli(c);
  CHECK(m.E_1 == relative(300e6, few_roundings));
  CHECK(m.E_2 == relative(200e6, few_roundings));
  CHECK(m.E_3 == 0);
  CHECK(m.C44 == 0);
  CHECK(engineering_moduli(VoigtStiffness{}).E_1 == 0);
  c.matrix(2, 2) = std::numeric_limits<double>::quiet_NaN();
  CHECK_THROWS_AS((void)engineering_moduli(c), InvalidArgument);
}

TEST_CASE("waves along the axes: the speeds of an orthotropic solid are those of its diagonal") {
  VoigtStiffness c = voigt(Isotropic::from_bulk_and_shear(300e6, 200e6));
  c.matrix.diagonal() << 500e6, 600e6, 700e6, 90e6, 80e6, 70e6;
  constexpr double rho = 1700;
  const auto along = plane_waves_along_axes(c, rho);
  const double expected[3][3] = {{500e6, 80e6, 70e6}, {600e6, 90e6, 70e6}, {700e6, 90e6, 80e6}};
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const double speeds[] = {along[axis].fastest.speed, along[axis].middle.speed, along[axis].slowest.speed};
    for (std::size_t k = 0; k < 3; ++k)
      CHECK(speeds[k] == relative(std::sqrt(expected[axis][k] / rho), few_roundings));
  }
}

// SPDX-License-Identifier: GPL-3.0-or-later
#include <granum/elastic/stiffness.hpp>

#include <granum/elastic/isotropic.hpp>

#include "samples.hpp"
#include "unit.hpp"

using namespace granum::elastic;

namespace {

using test::rounding;
using test::tilt;
constexpr double quarter = std::numbers::pi / 2;
const Vec3 axis_1{1, 0, 0}, axis_2{0, 1, 0}, axis_3{0, 0, 1};

/// |C - mean of the turned C|/|C|
double distance_to_mean(const VoigtStiffness& c, const std::vector<Mat3>& group) {
  Matrix6 mean = Matrix6::Zero();
  for (const Mat3& turn : group)
    mean += rotate(mandel(c), turn).matrix / static_cast<double>(group.size());
  return relative_distance(mandel(c), {mean});
}

} // namespace

TEST_CASE("symmetry: a distance is that to the mean over the rotations of the class") {
  const VoigtStiffness c = triclinic_sample();
  const SymmetryDistances d = symmetry_distances(c);
  const auto turns = [](const Vec3& axis, int count) {
    std::vector<Mat3> list;
    for (int i = 0; i < count; ++i)
      list.push_back(rotation_about(axis, 4 * quarter * i / count));
    return list;
  };
  CHECK(d.transversely_isotropic == relative(distance_to_mean(c, turns(axis_3, 5)), rounding));
  // every half turn about an axis, once each: the products of {1, half turn} about 1 and about 2
  std::vector<Mat3> orthotropic;
  for (const Mat3& a : turns(axis_1, 2))
    for (const Mat3& b : turns(axis_2, 2))
      orthotropic.push_back(a * b);
  CHECK(d.orthotropic == relative(distance_to_mean(c, orthotropic), rounding));
  // the 24 rotations of the cube: 4 about axis 3 times the 6 that bring each face to the top
  std::vector<Mat3> cubic;
  std::vector<Mat3> faces = turns(axis_1, 4);
  faces.push_back(rotation_about(axis_2, quarter));
  faces.push_back(rotation_about(axis_2, -quarter));
  for (const Mat3& a : faces)
    for (const Mat3& b : turns(axis_3, 4))
      cubic.push_back(a * b);
  CHECK(d.cubic == relative(distance_to_mean(c, cubic), rounding));
  // the mean over all rotations is the projection (test_averages.cpp)
  CHECK(d.isotropic ==
        relative(relative_distance(mandel(c), mandel(voigt(isotropic_projection(c)))), rounding));
}

TEST_CASE("symmetry: only isotropy does not depend on the axes, and no distance on the unit") {
  const SymmetryDistances here = symmetry_distances(voigt(layered_sample()));
  const SymmetryDistances turned = symmetry_distances(rotate(voigt(layered_sample()), tilt));
  CHECK(turned.isotropic == relative(here.isotropic, rounding));
  CHECK(turned.transversely_isotropic > 0.01);
  CHECK_THROWS_AS((void)symmetry_distances(VoigtStiffness{}), InvalidArgument); // of nothing there is none
  for (const double unit : {1e-300, 1e-9, 1e300}) {
    const SymmetryDistances scaled = symmetry_distances({unit * (voigt(layered_sample()).matrix / 402e6)});
    CHECK(scaled.isotropic == relative(here.isotropic, rounding));
    CHECK(scaled.cubic == relative(here.cubic, rounding));
  }
}

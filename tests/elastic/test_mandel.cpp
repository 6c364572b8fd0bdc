// SPDX-License-Identifier: GPL-3.0-or-later
#include <granum/elastic/stiffness.hpp>

#include <functional>

#include <granum/elastic/isotropic.hpp>
#include <granum/elastic/transverse_isotropic.hpp>
#include <granum/elastic/waves.hpp>

#include "samples.hpp"
#include "unit.hpp"

using namespace granum::elastic;

namespace {

using test::rounding;
using test::tilt;

double distance(const VoigtStiffness& a, const VoigtStiffness& b) {
  return relative_distance(mandel(a), mandel(b));
}

/// C_ijkl of a Voigt matrix, written without any of the library's index tables.
double component(const VoigtStiffness& c, int i, int j, int k, int l) {
  const int index[3][3] = {{0, 5, 4}, {5, 1, 3}, {4, 3, 2}};
  return c.matrix(index[i][j], index[k][l]);
}

} // namespace

TEST_CASE("Voigt to Mandel and back is the identity, and the norm becomes the tensor's") {
  const VoigtStiffness c = triclinic_sample();
  CHECK(distance(c, voigt(mandel(c))) < rounding);
  double square = 0;
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j < 3; ++j)
      for (int k = 0; k < 3; ++k)
        for (int l = 0; l < 3; ++l)
          square += std::pow(component(c, i, j, k, l), 2);
  CHECK(mandel(c).matrix.squaredNorm() == relative(square, rounding));
}

TEST_CASE("rotation is that of the fourth-rank tensor") {
  const VoigtStiffness c = triclinic_sample();
  const VoigtStiffness turned = rotate(c, tilt);
  const int pairs[6][2] = {{0, 0}, {1, 1}, {2, 2}, {1, 2}, {0, 2}, {0, 1}};
  VoigtStiffness direct;
  for (int row = 0; row < 6; ++row)
    for (int column = 0; column < 6; ++column)
      for (int i = 0; i < 3; ++i)
        for (int j = 0; j < 3; ++j)
          for (int k = 0; k < 3; ++k)
            for (int l = 0; l < 3; ++l)
              direct.matrix(row, column) += tilt(pairs[row][0], i) * tilt(pairs[row][1], j) *
                                            tilt(pairs[column][0], k) * tilt(pairs[column][1], l) *
                                            component(c, i, j, k, l);
  CHECK(distance(direct, turned) < rounding);
}

TEST_CASE("only a proper rotation is accepted") {
  for (const Mat3& bad :
       {Mat3::diagonal(1, 1, -1), Mat3::diagonal(1, 1, 1.001), Mat3{}, Mat3::diagonal(1, 1, std::nan(""))})
    CHECK_THROWS_AS((void)mandel_rotation(bad), InvalidArgument);
}

TEST_CASE("definiteness is relative to the largest eigenvalue and to no axis or unit") {
  // isotropic: eigenvalues 3K once and 2G five times
  const MandelStiffness sand = mandel(voigt(Isotropic::from_bulk_and_shear(1.9e9, 2.8e9)));
  CHECK(relative_smallest_eigenvalue(sand) == relative(2 * 2.8 / (3 * 1.9), rounding));
  CHECK(positive_definite(sand));
  const MandelStiffness c = mandel(triclinic_sample());
  CHECK(relative_smallest_eigenvalue(rotate(c, tilt)) == relative(relative_smallest_eigenvalue(c), rounding));
  CHECK(relative_smallest_eigenvalue({1e-30 * c.matrix}) ==
        relative(relative_smallest_eigenvalue(c), rounding));
  CHECK(relative_smallest_eigenvalue({-c.matrix}) == relative(-1, rounding));

  MandelStiffness flat = c; // one mode without stiffness
  flat.matrix.row(5).setZero();
  flat.matrix.col(5).setZero();
  CHECK_FALSE(positive_definite(flat));
  CHECK(positive_semidefinite(flat));
  flat.matrix(5, 5) = -1e-6 * c.matrix(0, 0);
  CHECK_FALSE(positive_semidefinite(flat));
  CHECK_FALSE(positive_definite(MandelStiffness{}));
  CHECK(positive_semidefinite(MandelStiffness{}));
  flat.matrix(0, 0) = std::nan("");
  CHECK_THROWS_AS((void)positive_definite(flat), InvalidArgument);
}

TEST_CASE("symmetry residual and distance are relative") {
  MandelStiffness c = mandel(triclinic_sample());
  CHECK(symmetry_residual(c) == 0);
  c.matrix(0, 5) += 1e-3 * c.matrix.norm();
  CHECK(symmetry_residual(c) == relative(1e-3 * std::numbers::sqrt2, 1e-3));
  CHECK(symmetry_residual(MandelStiffness{}) == 0);
  CHECK(relative_distance(c, {1.25 * c.matrix}) == relative(0.25, rounding));
  CHECK_THROWS_AS((void)relative_distance(MandelStiffness{}, c), InvalidArgument);
}

TEST_CASE("every function of a full stiffness refuses one that is not symmetric, and forgives rounding") {
  using Function = std::function<void(const VoigtStiffness&)>;
  const Vec3 x{1, 0, 0};
  const Function functions[] = {
      [](const auto& c) { (void)rotate(c, tilt); },
      [](const auto& c) { (void)relative_smallest_eigenvalue(mandel(c)); },
      [](const auto& c) { (void)isotropic_projection(c); },
      [](const auto& c) { (void)transversely_isotropic_projection(c); },
      [&](const auto& c) { (void)transversely_isotropic_projection(c, x); },
      [](const auto& c) { (void)isotropic_averages(c); },
      [](const auto& c) { (void)engineering_moduli(c); },
      [](const auto& c) { (void)symmetry_distances(c); },
      [&](const auto& c) { (void)plane_waves(c, 2000, x); },
      [](const auto& c) { (void)plane_waves_along_axes(c, 2000); },
      [&](const auto& c) { (void)group_velocity(c, 2000, x, {.speed = 400, .polarisation = x}); }};
  const VoigtStiffness whole = triclinic_sample();
  VoigtStiffness upper{whole.matrix.triangularView<Eigen::Upper>()};
  VoigtStiffness lower{whole.matrix.triangularView<Eigen::Lower>()};
  VoigtStiffness mistyped = whole, four_digits = whole, infinite = whole;
  mistyped.matrix(5, 4) += 2e-3 * whole.matrix(2, 2);
  four_digits.matrix(1, 0) += 0.1e6; // of 118 MPa
  infinite.matrix(3, 2) = infinite.matrix(2, 3) = std::numeric_limits<double>::infinity();
  for (const Function& function : functions) {
    CAPTURE(&function - functions);
    for (const VoigtStiffness& wrong : {upper, lower, mistyped, infinite})
      CHECK_THROWS_AS(function(wrong), InvalidArgument);
    CHECK_NOTHROW(function(four_digits));
  }
}

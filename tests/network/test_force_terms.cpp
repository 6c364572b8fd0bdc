// SPDX-License-Identifier: GPL-3.0-or-later
// What contact forces add to a stiffness. Motions within the cell and tangential forces are tested on
// packings beside DEM probes, in tests/studies/test_study.cpp.
#include <granum/network/linear_response.hpp>

#include "../packing/sample_packings.hpp"
#include "unit.hpp"

using elastic::Matrix6;

namespace {

constexpr double overlap = 1e-3, exponent = 1.5, ratio = 0.8; // f ~ overlap^exponent, k_t/k_n

/// A lattice of spheres that touch by Hertz' law, pressed until a contact has this overlap; k_n is 1.
packing::Assembly pressed(const samples::Lattice& kind) {
  packing::Assembly a =
      samples::lattice(kind, {.normal_force = overlap / exponent, .tangential_stiffness = ratio});
  for (packing::Contact& c : a.contacts)
    c.overlap = overlap;
  return a;
}

Mat3 unit_strain(int load_case) {
  constexpr int rows[] = {0, 1, 2, 1, 0, 0}, columns[] = {0, 1, 2, 2, 2, 1};
  Mat3 e;
  e(rows[load_case], columns[load_case]) += 0.5;
  e(columns[load_case], rows[load_case]) += 0.5;
  return e;
}

/// Cauchy stress, tension positive, of the lattice whose grains move with a strain and do not spin.
Mat3 stress_at(const packing::Assembly& a, const Mat3& strain) {
  Mat3 sum;
  for (const packing::Contact& c : a.contacts) {
    const Vec3 moved = strain * c.branch, branch = c.branch + moved, before = normal(c);
    const double d = c.overlap + norm(c.branch) - norm(branch);
    const Vec3 force = c.normal_force * std::pow(d / c.overlap, exponent) / norm(branch) * branch -
                       c.tangential_stiffness * (moved - dot(before, moved) * before);
    for (int row = 0; row < 3; ++row)
      for (int col = 0; col < 3; ++col)
        sum(row, col) -= (force[row] * branch[col] + force[col] * branch[row]) / 2;
  }
  return (1 / (a.volume() * determinant(Mat3::identity() + strain))) * sum;
}

/// From the change of stress by strain.
template <class Change>
Matrix6 stiffness_of(const Change& change_by) {
  Matrix6 stiffness;
  for (int b = 0; b < 6; ++b) {
    const Mat3 change = change_by(unit_strain(b));
    for (int k = 0; k < 6; ++k)
      stiffness(k, b) = k < 3 ? change(k, k) : change(k == 3 ? 1 : 0, k == 5 ? 1 : 2);
  }
  return stiffness;
}

Matrix6 by_differences(const packing::Assembly& a) {
  constexpr double step = 1e-7;
  return stiffness_of([&](const Mat3& strain) {
    return (1 / (2 * step)) * (stress_at(a, step * strain) + -1.0 * stress_at(a, -step * strain));
  });
}

} // namespace

TEST_CASE("stiffness and force terms of a pressed lattice are how its stress changes with strain") {
  for (const samples::Lattice& kind : {samples::simple_cubic, samples::face_centred}) {
    const packing::Assembly a = pressed(kind);
    const network::Response response = network::linear_response(a, {.force_terms = true});
    REQUIRE(response.force_terms().has_value());
    const network::ForceTerms& terms = *response.force_terms();
    const Matrix6 expected = by_differences(a), found = response.relaxed().matrix + terms.geometric.matrix;
    const double size = terms.geometric.matrix.cwiseAbs().maxCoeff();
    CHECK(size > 1e-4 * expected.cwiseAbs().maxCoeff());
    CHECK((found - expected).cwiseAbs().maxCoeff() < 1e-3 * size);
    CHECK(terms.shedding.matrix.cwiseAbs().maxCoeff() == 0); // no tangential forces
    // under pressure alone K grows by two thirds of it
    CHECK(terms.geometric.matrix.topLeftCorner<3, 3>().sum() / 9 ==
          relative(-2 * stress_at(a, Mat3{})(0, 0) / 3, 1e-9));
  }
}

TEST_CASE("a contact that unloads sheds the tangential force that its stiffness no longer carries, half in "
          "the mean") {
  packing::Assembly a = pressed(samples::face_centred);
  Mat3 m;
  m(0, 0) = 0.3, m(2, 2) = -0.2, m(0, 1) = m(1, 0) = 0.1, m(1, 2) = m(2, 1) = -0.15;
  for (packing::Contact& c : a.contacts)
    c.tangential_force = c.normal_force * (m * normal(c) - dot(normal(c), m * normal(c)) * normal(c));
  const Matrix6 expected = stiffness_of([&](const Mat3& strain) { // of stress, tension positive
    Mat3 sum;
    for (const packing::Contact& c : a.contacts) {
      const double change = -dot(normal(c), strain * c.branch) / c.overlap * (exponent - 1); // of ln k_t
      for (int row = 0; row < 3; ++row)
        for (int col = 0; col < 3; ++col)
          sum(row, col) -=
              change / 2 *
              (c.tangential_force[row] * c.branch[col] + c.tangential_force[col] * c.branch[row]) / 2;
    }
    return (1 / a.volume()) * sum;
  });
  const Matrix6 found = network::linear_response(a, {.force_terms = true}).force_terms()->shedding.matrix;
  CHECK(found.norm() > 0);
  CHECK((found - (expected + expected.transpose()) / 2).norm() < 1e-9 * found.norm());
}

TEST_CASE("force terms are computed only on request, and not between walls") {
  packing::Assembly a = pressed(samples::face_centred);
  CHECK_FALSE(network::linear_response(a).force_terms().has_value());
  a.wall_contacts.push_back(a.contacts.front());
  CHECK_THROWS_WITH_AS(static_cast<void>(network::linear_response(a, {.force_terms = true})),
                       doctest::Contains("1 "), InvalidArgument);
}

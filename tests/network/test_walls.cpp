// SPDX-License-Identifier: GPL-3.0-or-later
// Networks that are closed by rigid walls.
#include <granum/network/linear_response.hpp>

#include <Eigen/Cholesky>
#include <granum/dem/specimen.hpp>

#include "dem/lattice_state.hpp"
#include "dense_twin.hpp"
#include "packing/sample_packings.hpp"
#include "unit.hpp"

using elastic::Matrix6;

namespace {

constexpr double radius = 0.5e-3;

/// A simple cubic lattice of n^3 grains that touch each other and, by the mirror law, the walls alike.
dem::Specimen boxed_lattice(int n, double overlap, double wall_friction) {
  dem::Specimen state;
  state.radius = radius;
  const double edge = 2 * radius - overlap;
  state.cell = Mat3::diagonal(n * edge, n * edge, n * edge);
  for (int p = 0; p < n; ++p)
    for (int q = 0; q < n; ++q)
      for (int r = 0; r < n; ++r)
        state.position.push_back({(p + 0.5) * edge, (q + 0.5) * edge, (r + 0.5) * edge});
  state.walls = dem::Walls{.friction_coefficient = wall_friction, .history = {}};
  return state;
}

} // namespace

TEST_CASE(
    "a simple cubic lattice between walls has the moduli of the periodic one, smooth walls less shear") {
  const dem::Material material = test::quartz(radius, 0.5);
  const double overlap = 1e-4 * radius, edge = 2 * radius - overlap;
  const double kn = material.law.stiffness_at_overlap(overlap), kt = material.tangential_ratio * kn;
  // [DuffyMindlin1957]: C11 = kn/edge, C12 = 0, C44 = kt/(2 edge).
  Matrix6 periodic = Matrix6::Zero();
  periodic.diagonal() << kn / edge, kn / edge, kn / edge, kt / (2 * edge), kt / (2 * edge), kt / (2 * edge);
  for (const int n : {1, 2, 3, 4}) {
    CAPTURE(n);
    const auto rough =
        network::linear_response(dem::contact_network(boxed_lattice(n, overlap, 0.5), material));
    CHECK(rough.report().wall_contacts == static_cast<std::size_t>(6 * n * n));
    // Overlaps are differences of lengths 1e4 times as large.
    CHECK(twin::distance(rough.affine().matrix, periodic) < 1e-10);
    CHECK(twin::distance(rough.relaxed().matrix, periodic) < 1e-10);
    // Of n tangential contacts in a row, two halves at the walls are missing.
    const auto smooth =
        network::linear_response(dem::contact_network(boxed_lattice(n, overlap, 0), material));
    Matrix6 affine = periodic;
    affine.bottomRightCorner<3, 3>() *= (n - 1.0) / n;
    CHECK(twin::distance(smooth.affine().matrix, affine) < 1e-10);
    const Matrix6 softer = smooth.relaxed().matrix;
    CHECK((softer - affine).topRows<3>().cwiseAbs().maxCoeff() < 1e-10 * periodic(0, 0));
    // Grains at a smooth wall give way to the shear force that it does not bear. Of two in a row each presses
    // on its wall, of stiffness 2 kn, until that balances what is left: kn/(kn + kt) of the affine modulus.
    if (n == 2)
      CHECK(softer(4, 4) == relative(affine(4, 4) * kn / (kn + kt), 1e-9));
    if (n == 1)
      CHECK(softer(4, 4) == 0);
  }
}

TEST_CASE("networks with walls: as their dense twins, symmetric, semidefinite, below uniform strain") {
  samples::Uniform uniform(4);
  for (const double kept : {1.0, 0.5, 0.3})
    for (const double rough : {0.0, 1.0}) {
      CAPTURE(kept);
      CAPTURE(rough);
      packing::Assembly a = samples::random_network({.seed = 9, .repeats = 2, .kept = kept});
      // Planes of any direction touch every third grain: any boundary that follows the strain will do.
      for (std::uint32_t g = 0; g < a.grain_count(); g += 3) {
        Vec3 branch = uniform.vector(1);
        branch *= 0.9 * a.radius[g] / norm(branch);
        a.wall_contacts.push_back({.i = g,
                                   .j = 0,
                                   .branch = branch,
                                   .tangential_force = {},
                                   .normal_stiffness = uniform(1, 4),
                                   .tangential_stiffness = rough * uniform(0.2, 1)});
      }
      const network::ResponseOptions to_rounding{.tolerance = 1e-12};
      const auto response = network::linear_response(a, to_rounding);
      const auto twin = twin::response(a, false);
      const Matrix6 &affine = response.affine().matrix, &soft = response.relaxed().matrix;
      const double size = affine.cwiseAbs().maxCoeff();
      CHECK((soft - twin.relaxed).cwiseAbs().maxCoeff() < 1e-9 * size);
      CHECK(response.report().symmetry_residual * soft.cwiseAbs().maxCoeff() < 1e-9 * size);
      CHECK(twin::smallest_eigenvalue(soft) > -1e-12 * size);
      CHECK(twin::smallest_eigenvalue(affine - soft) > -1e-12 * size);
    }
}

TEST_CASE("smooth walls with prestress: the second derivatives of the energy itself") {
  // Frictionless grains pressed together by 2 % of their radius, out of their places by as much.
  dem::Material material = test::quartz(radius, 0);
  material.tangential_ratio = 0;
  dem::Specimen state = boxed_lattice(2, 0.02 * radius, 0);
  samples::Uniform uniform(2);
  for (Vec3& x : state.position)
    x += uniform.vector(0.004 * radius);
  const packing::Assembly a = dem::contact_network(state, material);
  REQUIRE(a.contacts.size() == 12);
  REQUIRE(a.wall_contacts.size() == 24);
  constexpr int unknowns = 3 * 8 + 6;
  using Point = Eigen::Matrix<double, unknowns, 1>;
  // Energy at x -> (1 + E) x + u, walls moved likewise; u in radii, engineering shears.
  const auto energy = [&](const Point& at) {
    const double e1 = at[24], e2 = at[25], e3 = at[26], e4 = at[27] / 2, e5 = at[28] / 2, e6 = at[29] / 2;
    const Mat3 f{{{1 + e1, e6, e5}, {e6, 1 + e2, e4}, {e5, e4, 1 + e3}}};
    const auto moved = [&](std::uint32_t g) {
      return f * state.position[g] + radius * Vec3{at[3 * g], at[3 * g + 1], at[3 * g + 2]};
    };
    const auto walls = dem::wall_planes(f * state.cell);
    double sum = 0;
    for (const packing::Contact& c : a.contacts)
      sum += material.law.energy(2 * radius - norm(moved(c.j) - moved(c.i)));
    for (const packing::Contact& c : a.wall_contacts) {
      const double distance = dot(moved(c.i) - walls[c.j].centre, walls[c.j].normal);
      sum += material.law.energy(2 * (radius - distance)) / 2;
    }
    return sum;
  };
  // Central differences at two step sizes, extrapolated: what is left is of their fourth order.
  const auto hessian = [&](double step) {
    Eigen::Matrix<double, unknowns, unknowns> h;
    for (int p = 0; p < unknowns; ++p)
      for (int q = 0; q < unknowns; ++q) {
        double sum = 0;
        for (const double sp : {1.0, -1.0})
          for (const double sq : {1.0, -1.0}) {
            Point at = Point::Zero();
            at[p] += sp * step;
            at[q] += sq * step;
            sum += sp * sq * energy(at);
          }
        h(p, q) = sum / (4 * step * step);
      }
    return h;
  };
  const auto h = ((4 * hessian(1e-4) - hessian(2e-4)) / 3).eval();
  const Eigen::MatrixXd grains = h.topLeftCorner<24, 24>(), across = h.topRightCorner<24, 6>();
  const Matrix6 relaxed = (h.bottomRightCorner<6, 6>() - across.transpose() * grains.ldlt().solve(across)) /
                          determinant(state.cell);
  const Matrix6 affine = h.bottomRightCorner<6, 6>() / determinant(state.cell);
  const auto response = network::linear_response(a, {.prestress = true});
  CHECK(twin::distance(response.affine().matrix, affine) < 1e-6);
  CHECK(twin::distance(response.relaxed().matrix, relaxed) < 1e-6);
  // And the prestress is what the comparison has seen.
  CHECK(twin::distance(network::linear_response(a).relaxed().matrix, relaxed) > 1e-3);
}

// SPDX-License-Identifier: GPL-3.0-or-later
#include <granum/network/linear_response.hpp>

#include <granum/packing/coordination.hpp>

#include "dense_twin.hpp"
#include "packing/sample_packings.hpp"
#include "unit.hpp"

using elastic::Matrix6;

namespace {

// C is of second order in the solver's tolerance of 1e-10; what is left is rounding, amplified by the
// condition of the sparsest networks (1e4 to 1e5) on both routes.
constexpr double same = 1e-9;

Matrix6 relaxed(const packing::Assembly& a, const network::ResponseOptions& options = {}) {
  return network::linear_response(a, options).relaxed().matrix;
}

} // namespace

TEST_CASE("the sparse solver and its dense twin agree from stiff to floppy networks") {
  int rattlers = 0, two_contact_grains = 0;
  for (const double kept : {1.0, 0.6, 0.4, 0.3, 0.22}) {
    for (std::uint64_t seed = 1; seed <= 3; ++seed) {
      CAPTURE(kept);
      CAPTURE(seed);
      const packing::Assembly a = samples::random_network({.seed = seed, .repeats = 2, .kept = kept});
      std::vector<int> degree(a.grain_count(), 0);
      for (const packing::Contact& c : a.contacts)
        ++degree[c.i], ++degree[c.j];
      rattlers +=
          static_cast<int>(mechanical_coordination(a, packing::ContactKind::frictional).rattler_count);
      two_contact_grains += static_cast<int>(std::count(degree.begin(), degree.end(), 2));
      const Matrix6 scale = twin::contact_sum(a);
      const Matrix6 difference = relaxed(a) - twin::response(a, false).relaxed;
      CHECK(difference.cwiseAbs().maxCoeff() < same * scale.cwiseAbs().maxCoeff());
    }
  }
  CHECK(rattlers > 5); // the cases meant to be met were met
  CHECK(two_contact_grains > 10);
}

TEST_CASE(
    "networks without tangential stiffness, with sliding contacts, with prestress: as their dense twins") {
  const packing::Assembly smooth =
      samples::random_network({.seed = 5, .repeats = 2, .kept = 0.7, .tangential_ratio = 0});
  CHECK(network::linear_response(smooth).report().unknowns_per_grain == 3);
  CHECK(twin::distance(relaxed(smooth), twin::response(smooth, false).relaxed) < same);

  // Forces that are not in equilibrium make floppy networks unstable, so prestress is tried on stiff ones.
  for (const double ratio : {0.0, 1.0}) {
    const packing::Assembly stiff =
        samples::random_network({.seed = 5, .repeats = 2, .tangential_ratio = ratio});
    const Matrix6 stressed = relaxed(stiff, {.prestress = true});
    CHECK(twin::distance(stressed, twin::response(stiff, true).relaxed) < same);
    CHECK(twin::distance(stressed, relaxed(stiff)) > 1e-5);
  }

  packing::Assembly a = samples::random_network({.seed = 6, .repeats = 2, .kept = 0.5});
  packing::Assembly released = a;
  for (std::size_t k = 0; k < a.contacts.size(); k += 3) {
    a.contacts[k].sliding = true;
    released.contacts[k].tangential_stiffness = 0;
  }
  const Matrix6 stick = relaxed(a);
  const Matrix6 slip = relaxed(a, {.sliding = network::SlidingContacts::release});
  CHECK(twin::distance(stick, twin::response(a, false).relaxed) < same);
  CHECK(twin::distance(slip, twin::response(released, false).relaxed) < same);
  CHECK(twin::smallest_eigenvalue(stick - slip) > 0); // slip softens every strain
}

TEST_CASE("unsupported clusters add nothing") {
  const packing::Assembly one = samples::random_network({.seed = 7, .repeats = 2, .kept = 0.6});
  packing::Assembly two = one;
  const auto first = static_cast<std::uint32_t>(two.grain_count());
  for (int k = 0; k < 4; ++k) { // a tetrahedron far from anything it touches
    two.position.push_back({0.1 * k, 0, 0});
    two.radius.push_back(0.5);
  }
  const Vec3 corner[4] = {{1, 1, 1}, {1, -1, -1}, {-1, 1, -1}, {-1, -1, 1}};
  for (std::uint32_t p = 0; p < 4; ++p)
    for (std::uint32_t q = p + 1; q < 4; ++q)
      two.contacts.push_back({.i = first + p,
                              .j = first + q,
                              .branch = 0.35 * (corner[q] - corner[p]),
                              .tangential_force = {},
                              .normal_stiffness = 1,
                              .tangential_stiffness = 0.8});
  CHECK(network::linear_response(two).report().grains == network::linear_response(one).report().grains + 4);
  CHECK(twin::distance(relaxed(two), relaxed(one)) < same);
}

TEST_CASE("symmetric, positive semidefinite, never above uniform strain") {
  for (const double kept : {1.0, 0.5, 0.35}) {
    const packing::Assembly a = samples::random_network({.seed = 11, .kept = kept});
    const auto response = network::linear_response(a);
    const Matrix6 &affine = response.affine().matrix, &soft = response.relaxed().matrix;
    const double size = affine.cwiseAbs().maxCoeff();
    CHECK(response.report().symmetry_residual < 1e-9);
    CHECK(soft == soft.transpose());
    CHECK(twin::smallest_eigenvalue(soft) > -1e-12 * size);
    CHECK(twin::smallest_eigenvalue(affine - soft) > 0);
    CHECK(response.report().residual <= 1e-10);
    CHECK(response.report().iterations > 0);
  }
}

TEST_CASE("uniform strain is the closed sum over contacts: all, or those that carry load") {
  const packing::Assembly full = samples::random_network({.seed = 12, .kept = 1}),
                          sparse = samples::random_network({.seed = 11, .kept = 0.35});
  REQUIRE(mechanical_coordination(full, packing::ContactKind::frictional).rattler_count == 0);
  REQUIRE(mechanical_coordination(sparse, packing::ContactKind::frictional).rattler_count > 0);
  CHECK(twin::distance(network::linear_response(full).affine().matrix, twin::contact_sum(full)) < 1e-13);
  const Matrix6 all = network::affine_all(sparse).matrix,
                bearing = network::linear_response(sparse).affine().matrix;
  CHECK(twin::distance(all, twin::contact_sum(sparse)) < 1e-13);
  CHECK(twin::smallest_eigenvalue(all - bearing) > -1e-13 * all.cwiseAbs().maxCoeff());
  CHECK(twin::distance(bearing, all) > 1e-3);
  CHECK(network::affine_all(samples::random_network({.seed = 11, .kept = 0})).matrix == Matrix6::Zero());
}

TEST_CASE("stiffness and length scale as dimensions demand, bit by bit") {
  const packing::Assembly a = samples::random_network({.seed = 15, .repeats = 2, .kept = 0.5});
  packing::Assembly stiff = a, large = a;
  large.cell = 2.0 * large.cell;
  for (std::size_t g = 0; g < a.grain_count(); ++g)
    large.position[g] *= 2, large.radius[g] *= 2;
  for (std::size_t k = 0; k < a.contacts.size(); ++k) {
    stiff.contacts[k].normal_stiffness *= 8, stiff.contacts[k].tangential_stiffness *= 8;
    large.contacts[k].branch *= 2, large.contacts[k].overlap *= 2;
  }
  const Matrix6 base = relaxed(a);
  CHECK(relaxed(stiff) == 8 * base);
  CHECK(relaxed(large) == base / 2);
  CHECK(relaxed(a) == base);
}

TEST_CASE("assemblies without a load-bearing network have zero stiffness") {
  packing::Assembly a;
  a.cell = Mat3::diagonal(4e-3, 4e-3, 4e-3);
  const auto check_zero = [&](std::size_t grains) {
    const auto response = network::linear_response(a);
    CHECK(response.converged());
    CHECK(response.report().grains == grains);
    CHECK(response.relaxed().matrix == Matrix6::Zero());
    CHECK(response.affine().matrix == Matrix6::Zero());
  };
  check_zero(0);
  // The chain of three spheres: both ends go, then the middle.
  a.position = {{1e-3, 2e-3, 2e-3}, {1.9999e-3, 2e-3, 2e-3}, {1.9999e-3, 2e-3, 2.9998e-3}};
  a.radius = {0.5e-3, 0.5e-3, 0.5e-3};
  check_zero(0);
  for (std::uint32_t i = 0; i < 2; ++i)
    a.contacts.push_back({.i = i,
                          .j = i + 1,
                          .branch = a.position[i + 1] - a.position[i],
                          .tangential_force = {},
                          .normal_stiffness = 3.5e5,
                          .tangential_stiffness = 3e5});
  check_zero(0);
  // Contacts that have lost all stiffness still count as contacts.
  a = samples::lattice(samples::simple_cubic, {.normal_stiffness = 0});
  check_zero(27);
}

TEST_CASE("a result that did not converge is not returned") {
  const packing::Assembly a = samples::random_network({.seed = 18, .kept = 0.5});
  const auto hasty = network::linear_response(a, {.iteration_limit = 2});
  CHECK_FALSE(hasty.converged());
  CHECK(hasty.report().status == network::Status::iteration_limit);
  CHECK_THROWS_AS(static_cast<void>(hasty.relaxed()), NotConverged);
  CHECK(hasty.last_iterate().matrix.allFinite());
  CHECK(hasty.affine().matrix.allFinite());

  packing::Assembly pushed = a; // far too much compression for its stiffness: it buckles
  for (packing::Contact& c : pushed.contacts) {
    c.tangential_stiffness = 0;
    c.normal_force = 3;
  }
  const auto buckled = network::linear_response(pushed, {.prestress = true});
  CHECK(buckled.report().status == network::Status::not_positive_definite);
  CHECK_THROWS_AS(static_cast<void>(buckled.relaxed()), NotConverged);
  CHECK(buckled.last_iterate().matrix.allFinite());
}

// No load is on modes without stiffness, but rounding is: it must not run away where the solver goes on.
// Springs of 1e-14 then hold the grains, which networks that hardly hold can tell: softest modes of 1e-6 k_n.
TEST_CASE("a tolerance at the edge of rounding is reached, among modes without stiffness as well") {
  for (const double kept : {0.3, 0.4, 0.5, 0.6})
    for (std::uint64_t seed = 1; seed <= 4; ++seed) {
      CAPTURE(kept);
      CAPTURE(seed);
      const packing::Assembly a = samples::random_network({.seed = seed, .repeats = 2, .kept = kept});
      const auto exact = network::linear_response(a, {.tolerance = 1e-12});
      REQUIRE(exact.converged());
      const auto pressed = network::linear_response(a, {.tolerance = 1e-15, .iteration_limit = 2000});
      CHECK(pressed.report().residual < 1e-11);
      const Matrix6 difference = pressed.last_iterate().matrix - exact.relaxed().matrix;
      CHECK(difference.cwiseAbs().maxCoeff() < 1e-8 * exact.affine().matrix.cwiseAbs().maxCoeff());
    }
}

TEST_CASE("bad options and bad assemblies are refused") {
  packing::Assembly a = samples::lattice(samples::simple_cubic, {});
  using network::ResponseOptions;
  for (const ResponseOptions& bad : {ResponseOptions{.tolerance = 0}, ResponseOptions{.tolerance = 1},
                                     ResponseOptions{.iteration_limit = 0}, ResponseOptions{.threads = 0}})
    CHECK_THROWS_AS(static_cast<void>(network::linear_response(a, bad)), InvalidArgument);
  a.contacts[0].normal_stiffness = -1;
  CHECK_THROWS_AS(static_cast<void>(network::linear_response(a)), InvalidArgument);
}

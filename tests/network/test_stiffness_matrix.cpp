// SPDX-License-Identifier: GPL-3.0-or-later
// H and the motions under unit strains beside the dense twin; 300 grains beside numpy are in
// python/tests/test_networks.py.
#include <granum/network/stiffness_matrix.hpp>

#include <granum/packing/coordination.hpp>

#include "dense_twin.hpp"
#include "packing/sample_packings.hpp"
#include "unit.hpp"

namespace {

using Dense = twin::Unknowns;

/// The twin's matrix for the unknowns u and R w.
Dense with_turns(Dense h, const packing::Assembly& a) {
  for (int row = 0; row < h.rows(); ++row)
    if (row % 6 >= 3) {
      const double radius = a.radius[static_cast<std::size_t>(row / 6)];
      h.row(row) /= radius;
      h.col(row) /= radius;
    }
  return h;
}

/// The rows of all grains, zero for those without load.
Dense of_all_grains(const network::StiffnessMatrix& h, std::size_t grains) {
  const int n = static_cast<int>(6 * grains), block = h.unknowns_per_grain;
  Dense out = Dense::Zero(n, n);
  const auto row_of = [&](Eigen::Index k) {
    return static_cast<int>(6 * h.grain[static_cast<std::size_t>(k / block)]) + static_cast<int>(k % block);
  };
  for (int c = 0; c < h.matrix.outerSize(); ++c)
    for (Eigen::SparseMatrix<double>::InnerIterator entry(h.matrix, c); entry; ++entry)
      out(row_of(entry.row()), row_of(entry.col())) = entry.value();
  return out;
}

double largest(const Dense& m) { return m.cwiseAbs().maxCoeff(); }

/// One case of motions as a column.
Dense column_of(const std::vector<network::GrainMotion>& motions) {
  Dense out(static_cast<int>(6 * motions.size()), 1);
  for (int row = 0; row < out.rows(); ++row) {
    const network::GrainMotion& motion = motions[static_cast<std::size_t>(row / 6)];
    out(row, 0) = row % 6 < 3 ? motion.displacement[row % 3] : motion.turn[row % 3];
  }
  return out;
}

packing::Assembly with_walls() {
  packing::Assembly a = samples::random_network({.seed = 3, .repeats = 2});
  for (std::uint32_t g = 0; g < 5; ++g)
    a.wall_contacts.push_back(
        {.i = g, .j = 0, .branch = {0, 0, -a.radius[g]}, .normal_stiffness = 1, .tangential_stiffness = 0.5});
  return a;
}

} // namespace

TEST_CASE("the stiffness matrix is that of the dense twin, symmetric to the bit") {
  packing::Assembly rolling = samples::random_network({.seed = 2, .repeats = 2});
  for (packing::Contact& c : rolling.contacts)
    c.rolling_stiffness = 0.02, c.twisting_stiffness = 0.01;
  for (const packing::Assembly& a :
       {samples::random_network({.seed = 1, .repeats = 2}), rolling, with_walls(),
        samples::random_network({.seed = 4, .repeats = 2, .tangential_ratio = 0})}) {
    const network::StiffnessMatrix h = network::stiffness_matrix(a);
    REQUIRE(h.grain.size() == a.grain_count()); // no rattlers, which the twin has
    CHECK(std::is_sorted(h.grain.begin(), h.grain.end()));
    const Dense own = of_all_grains(h, a.grain_count()),
                other = with_turns(twin::response(a, false).stiffness, a);
    CHECK(largest(own - other) < 1e-14 * largest(other));
    CHECK(own == own.transpose());
  }
  const packing::Assembly a = samples::random_network({.seed = 1, .repeats = 2});
  const Dense pressed = with_turns(twin::response(a, true).stiffness, a);
  CHECK(largest(of_all_grains(network::stiffness_matrix(a, {.prestress = true}), a.grain_count()) - pressed) <
        1e-14 * largest(pressed));
}

TEST_CASE("a network without walls and periodic images resists neither translation nor rotation") {
  packing::Assembly a = samples::random_network({.seed = 5, .repeats = 3, .kept = 0.6});
  std::erase_if(a.contacts, [&](const packing::Contact& c) {
    return norm(a.position[c.j] - a.position[c.i] - c.branch) > 1e-9;
  });
  const network::StiffnessMatrix h = network::stiffness_matrix(a);
  REQUIRE(h.grain.size() > 50);
  for (int axis = 0; axis < 3; ++axis) {
    Vec3 unit;
    unit[axis] = 1;
    Eigen::VectorXd moved(h.matrix.rows()), turned(h.matrix.rows());
    for (std::size_t k = 0; k < h.grain.size(); ++k) {
      const Vec3 along = cross(unit, a.position[h.grain[k]]), turn = a.radius[h.grain[k]] * unit;
      const auto first = static_cast<Eigen::Index>(6 * k);
      moved.segment<6>(first) << unit.x, unit.y, unit.z, 0, 0, 0;
      turned.segment<6>(first) << along.x, along.y, along.z, turn.x, turn.y, turn.z;
    }
    CHECK((h.matrix * moved).cwiseAbs().maxCoeff() < 1e-13);
    CHECK((h.matrix * turned).cwiseAbs().maxCoeff() < 1e-13);
  }
}

TEST_CASE("motions under unit strains are those of the dense twin, and rest where no load is") {
  for (const packing::Assembly& a : {samples::random_network({.seed = 1, .repeats = 2}), with_walls(),
                                     samples::random_network({.seed = 6, .repeats = 3, .kept = 0.5})}) {
    const network::StrainMotions motions =
        network::linear_response(a, {.motions = true, .tolerance = 1e-12}).motions();
    const twin::Response dense = twin::response(a, false);
    const Dense h = of_all_grains(network::stiffness_matrix(a), a.grain_count());
    for (std::size_t c = 0; c < motions.size(); ++c) {
      REQUIRE(motions[c].size() == a.grain_count());
      Dense difference = column_of(motions[c]), other = dense.motions.col(static_cast<int>(c));
      for (int row = 0; row < other.rows(); ++row)
        if (row % 6 >= 3)
          other(row, 0) *= a.radius[static_cast<std::size_t>(row / 6)];
      const double all = largest(other);
      CHECK(largest(difference) > 0.1 * all);
      // the difference is at most a motion without stiffness
      CHECK(largest(h * (difference - other)) < 1e-9 * largest(h) * all);
      Vec3 mean;
      for (const network::GrainMotion& motion : motions[c])
        mean += motion.displacement;
      if (a.wall_contacts.empty())
        CHECK(norm(mean) < 1e-11);
    }
    const auto rattler = mechanical_coordination(a, packing::ContactKind::frictional).rattler;
    for (std::size_t g = 0; g < a.grain_count(); ++g)
      if (rattler[g])
        CHECK(norm(motions[3][g].displacement) + norm(motions[3][g].turn) == 0);
  }
  CHECK(network::linear_response(with_walls()).motions()[0].empty());
}

TEST_CASE("motions scale with the length, and are the same bits on two threads") {
  const packing::Assembly a = samples::random_network({.seed = 7, .repeats = 5, .kept = 0.6});
  const auto one = network::linear_response(a, {.motions = true}),
             two = network::linear_response(a, {.motions = true, .threads = 2});
  packing::Assembly large = a;
  large.cell = 2.0 * a.cell;
  for (std::size_t g = 0; g < a.grain_count(); ++g)
    large.position[g] *= 2, large.radius[g] *= 2;
  for (packing::Contact& c : large.contacts)
    c.branch *= 2;
  const auto doubled = network::linear_response(large, {.motions = true});
  for (std::size_t c = 0; c < 6; ++c) {
    CHECK(column_of(one.motions()[c]) == column_of(two.motions()[c]));
    CHECK(column_of(doubled.motions()[c]) == 2 * column_of(one.motions()[c]));
  }
}

TEST_CASE("motions of contacts that count as rigid, of bodies, and none of a network that was not solved") {
  packing::Assembly a = samples::random_network({.seed = 8, .repeats = 2});
  a.contacts[0].normal_stiffness = 1e12;
  const network::StrainMotions motions = network::linear_response(a, {.motions = true}).motions();
  const packing::Contact& stiff = a.contacts[0];
  const Vec3 apart = motions[0][stiff.j].displacement - motions[0][stiff.i].displacement;
  CHECK(std::abs(dot(apart, normal(stiff)) + normal(stiff).x * stiff.branch.x) < 1e-5); // no change of length
  a.contacts[0].normal_stiffness = 1;
  a.body.resize(a.grain_count());
  for (std::uint32_t g = 0; g < a.grain_count(); ++g)
    a.body[g] = g == 0 ? 0 : g - 1;
  CHECK(network::linear_response(a, {.motions = true}).motions()[0].size() == a.grain_count() - 1);
  CHECK(network::stiffness_matrix(a).grain.size() == a.grain_count() - 1);
  CHECK_THROWS_AS(static_cast<void>(network::stiffness_matrix(a, {.prestress = true})), InvalidArgument);
  a.body.clear();
  auto hasty = network::linear_response(a, {.motions = true, .iteration_limit = 1});
  CHECK_THROWS_AS(static_cast<void>(hasty.motions()), NotConverged);
  CHECK(hasty.take_motions()[5].size() == a.grain_count());
  a.contacts.clear();
  CHECK(network::linear_response(a, {.motions = true}).motions()[5].size() == a.grain_count());
  CHECK(network::stiffness_matrix(a).matrix.rows() == 0);
}

// SPDX-License-Identifier: GPL-3.0-or-later
#include <Eigen/Dense>
#include <granum/network/linear_response.hpp>

#include "large_networks.hpp"
#include "network/coarse/correction.hpp"
#include "network/contact_operator.hpp"
#include "unit.hpp"

namespace {

template <int Dof>
network::Field<Dof> random_field(std::size_t grains, std::uint64_t seed) {
  samples::Uniform uniform(seed);
  network::Field<Dof> x(grains);
  for (auto& grain : x)
    for (auto& row : grain.row)
      for (int c = 0; c < network::load_cases; ++c)
        row[c] = uniform(-1, 1);
  return x;
}

/// Rows of all grains, and a column for each load case.
template <int Dof>
Eigen::MatrixXd dense_of(const network::Field<Dof>& x) {
  Eigen::MatrixXd out(Dof * static_cast<int>(x.size()), network::load_cases);
  for (int row = 0; row < out.rows(); ++row)
    for (int c = 0; c < network::load_cases; ++c)
      out(row, c) = x[static_cast<std::size_t>(row / Dof)].row[row % Dof][c];
  return out;
}

/// A projection along the motions of the nodes: what is left is orthogonal to each correction, and a second
/// one finds nothing. H comes from apply_stiffness, which knows of no nodes.
template <int Dof>
void check_correction(const packing::Assembly& a, const network::ResponseOptions& options,
                      double grains_a_node) {
  const network::Backbone backbone = network::load_bearing_network(a, options);
  REQUIRE(backbone.rotations == (Dof == 6));
  const network::Workers alone;
  const network::CoarseCorrection<Dof> coarse(backbone, alone, grains_a_node);
  const auto forces = [&](const network::Field<Dof>& motion) {
    network::Field<Dof> answer;
    network::apply_stiffness<Dof>(backbone, alone, 0, motion, answer);
    return answer;
  };
  // a load that the network can bear: of a displacement
  const auto load = forces(random_field<Dof>(backbone.grain_count, 1));
  const auto before = random_field<Dof>(backbone.grain_count, 2);
  const auto left = [&](const network::Field<Dof>& z) {
    return Eigen::MatrixXd(dense_of<Dof>(load) - dense_of<Dof>(forces(z)));
  };
  auto z = before;
  coarse.correct(load, z);
  const Eigen::MatrixXd step = dense_of<Dof>(z) - dense_of<Dof>(before);
  REQUIRE(step.norm() > 0);
  CHECK(std::abs(step.cwiseProduct(left(z)).sum()) < 1e-9 * step.norm() * dense_of<Dof>(load).norm());
  CHECK(step.cwiseProduct(left(before)).sum() > 0); // the step takes energy out of the error
  auto again = z;
  coarse.correct(load, again);
  CHECK((dense_of<Dof>(again) - dense_of<Dof>(z)).norm() < 1e-6 * step.norm());
  network::Field<Dof> lifted(z.size()), corrected(z.size());
  coarse.add_lifted(load, lifted);
  coarse.correct(load, corrected); // of z = 0
  CHECK(dense_of<Dof>(lifted).squaredNorm() ==
        doctest::Approx(dense_of<Dof>(corrected).squaredNorm()).epsilon(1e-12));
}

/// Some grains also touch a wall.
packing::Assembly with_walls(packing::Assembly a) {
  samples::Uniform uniform(5);
  for (std::uint32_t g = 0; g < a.grain_count(); g += 7)
    a.wall_contacts.push_back({.i = g,
                               .j = 0,
                               .branch = {-0.9 * a.radius[g], 0, 0},
                               .overlap = 0.1 * a.radius[g],
                               .normal_force = uniform(0, 1e-3),
                               .tangential_force = {},
                               .normal_stiffness = uniform(0.5, 2),
                               .tangential_stiffness = 0.5});
  return a;
}

/// Against the dense matrix, which has free directions.
Eigen::MatrixXd check_sparse_factor(std::uint32_t blocks, const network::Workers& workers) {
  const int size = 6 * static_cast<int>(blocks);
  // Springs between blocks at random, none on the last two: one has nothing, the others are held by one.
  samples::Uniform uniform(8);
  std::vector<network::CoarseFactor::Coupling> pairs;
  for (std::uint32_t i = 0; i + 2 < blocks; ++i)
    for (std::uint32_t j = 0; j < i; ++j)
      if (uniform(0, 1) < 0.5)
        pairs.emplace_back(j, i);
  network::CoarseFactor factor(blocks, pairs);
  Eigen::MatrixXd dense = Eigen::MatrixXd::Zero(size, size);
  const auto add = [&](std::uint32_t r, std::uint32_t c, const elastic::Matrix6& m) {
    factor.add(r, c, m);
    dense.block<6, 6>(6 * static_cast<int>(r), 6 * static_cast<int>(c)) += m;
    if (r != c)
      dense.block<6, 6>(6 * static_cast<int>(c), 6 * static_cast<int>(r)) += m.transpose();
  };
  const auto random_stiffness = [&] {
    elastic::Matrix6 m;
    for (double& value : m.reshaped())
      value = uniform(-1, 1);
    return elastic::Matrix6(m * m.transpose());
  };
  for (const auto& [i, j] : pairs) {
    const elastic::Matrix6 k = random_stiffness();
    add(i, i, k);
    add(j, j, k);
    add(j, i, -k);
  }
  add(blocks - 2, blocks - 2, elastic::Matrix6(Eigen::Matrix<double, 6, 1>{1, 2, 0, 4, 0, 6}.asDiagonal()));
  factor.factorise(workers);

  auto x = random_field<6>(blocks, 9);
  const Eigen::MatrixXd load = dense * dense_of<6>(x);
  for (int row = 0; row < size; ++row)
    for (int c = 0; c < 6; ++c)
      x[static_cast<std::size_t>(row / 6)].row[row % 6][c] = load(row, c);
  factor.solve(x);
  const Eigen::MatrixXd found = dense_of<6>(x);
  CHECK((dense * found - load).norm() < 1e-10 * load.norm());
  CHECK(found.bottomRows<6>().norm() == 0);
  CHECK(found.row(size - 10).norm() == 0); // of the block before, the third and the fifth
  CHECK(found.row(size - 8).norm() == 0);
  return found;
}

} // namespace

TEST_CASE("motions of the nodes leave a residual that does no work on any") {
  for (const double kept : {1.0, 0.5, 0.35}) { // the last has clusters that move freely
    CAPTURE(kept);
    const packing::Assembly rough = samples::random_network({.seed = 3, .repeats = 3, .kept = kept});
    for (const double grains_a_node : {1.0, 6.0, 30.0, 1000.0}) {
      CAPTURE(grains_a_node);
      if (kept < 0.4 &&
          grains_a_node == 1) // then P^T H P is H, with soft modes of the size that counts as free
        continue;
      if (grains_a_node < 1000) // a single node, whose shifts bear nothing
        check_correction<6>(rough, {}, grains_a_node);
      check_correction<6>(with_walls(rough), {}, grains_a_node);
      check_correction<6>(with_walls(rough), {.prestress = true}, grains_a_node);
    }
  }
  const packing::Assembly smooth =
      samples::random_network({.seed = 4, .repeats = 3, .kept = 0.7, .tangential_ratio = 0});
  for (const double grains_a_node : {1.0, 6.0, 30.0})
    check_correction<3>(smooth, {}, grains_a_node);
}

TEST_CASE("weights of the nodes in a grain are linear along the edges of its box, and periodic") {
  const packing::Assembly a = samples::random_network({.seed = 3, .repeats = 3});
  const network::Backbone backbone = network::load_bearing_network(a, {});
  for (const int along : {1, 2, 3}) { // boxes
    CAPTURE(along);
    const network::CoarseGrid grid(backbone, static_cast<double>(backbone.grain_count) / std::pow(along, 3));
    REQUIRE(grid.size() == static_cast<std::size_t>(along * along * along));
    std::size_t listed = 0;
    for (std::size_t box = 0; box < grid.size(); ++box) {
      const auto nodes = grid.nodes_of(box);
      for (unsigned c = 0; c < nodes.size(); ++c)
        CHECK(grid.boxes_around(nodes[c])[c] == box);
      for (const std::uint32_t g : grid.grains_of(box)) {
        ++listed;
        CHECK(grid.box_of(g) == box);
        const Vec3 place =
            along * (inverse_of(backbone.cell) * backbone.centre[g]); // over the edges of a box
        Vec3 found{};
        const auto share = grid.shares_of(g);
        for (unsigned c = 0; c < share.size(); ++c) {
          int node = 0;
          for (int k = 0; k < 3; ++k) {
            const int corner = static_cast<int>(std::floor(place[k])) + static_cast<int>(c >> k & 1U);
            found[k] += share[c] * corner;
            node = node * along + corner % along;
          }
          CHECK(nodes[c] == static_cast<std::uint32_t>(node));
        }
        for (int k = 0; k < 3; ++k)
          CHECK(found[k] == doctest::Approx(place[k]).epsilon(1e-12));
      }
    }
    CHECK(listed == backbone.grain_count);
  }
}

TEST_CASE("a sparse factor is that of the dense matrix, on any number of threads, and leaves free directions "
          "alone") {
  check_sparse_factor(9, network::Workers());
  const Eigen::MatrixXd alone = check_sparse_factor(90, network::Workers());
  for (const std::size_t members : {2U, 3U}) {
    Team team(members);
    CHECK(check_sparse_factor(90, network::Workers(&team)) == alone);
  }
}

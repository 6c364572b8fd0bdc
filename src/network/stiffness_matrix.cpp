// SPDX-License-Identifier: GPL-3.0-or-later
#include <granum/network/stiffness_matrix.hpp>

#include <algorithm>
#include <numeric>
#include <utility>

#include "backbone.hpp"
#include "contact_operator.hpp"

namespace granum::network {

namespace {

/// Places of the grains of a network if they are sorted by their numbers in the assembly.
std::vector<std::uint32_t> places(const Backbone& network) {
  std::vector<std::uint32_t> order(network.grain_count), place(network.grain_count);
  std::iota(order.begin(), order.end(), std::uint32_t{0});
  std::sort(order.begin(), order.end(),
            [&](std::uint32_t a, std::uint32_t b) { return network.grain[a] < network.grain[b]; });
  for (std::uint32_t k = 0; k < order.size(); ++k)
    place[order[k]] = k;
  return place;
}

template <int Dof>
Eigen::SparseMatrix<double> matrix_of(const Backbone& network) {
  const std::vector<std::uint32_t> place = places(network);
  std::vector<Eigen::Triplet<double>> entries;
  entries.reserve((network.grain_count + 2 * network.links.size()) * Dof * Dof);
  const double unit = network.stiffness_scale;
  const auto add = [&](std::uint32_t row, std::uint32_t column, int r, int c, double value) {
    entries.emplace_back(static_cast<int>(Dof * place[row]) + r, static_cast<int>(Dof * place[column]) + c,
                         unit * value);
  };
  const std::vector<Block<Dof>> diagonal = diagonal_blocks<Dof>(network);
  for (std::uint32_t g = 0; g < network.grain_count; ++g)
    for (int r = 0; r < Dof; ++r)
      for (int c = 0; c < Dof; ++c)
        add(g, g, r, c, (diagonal[g].at[r][c] + diagonal[g].at[c][r]) / 2);
  for (const Link& l : network.links) {
    const Block<Dof> coupling = link_blocks<Dof>(l, network.joint_of(l)).coupling_ba;
    for (int r = 0; r < Dof; ++r)
      for (int c = 0; c < Dof; ++c) {
        add(l.b, l.a, r, c, coupling.at[r][c]);
        add(l.a, l.b, c, r, coupling.at[r][c]);
      }
  }
  const auto rows = static_cast<int>(Dof * network.grain_count);
  Eigen::SparseMatrix<double> matrix(rows, rows);
  matrix.setFromTriplets(entries.begin(), entries.end());
  return matrix;
}

} // namespace

StiffnessMatrix stiffness_matrix(const packing::Assembly& assembly, const ResponseOptions& options) {
  require_valid(assembly);
  Backbone network = load_bearing_network(assembly, options);
  if (network.links.empty() && network.wall_links.empty())
    return {.matrix = {}, .grain = {}, .unknowns_per_grain = network.rotations ? 6 : 3};
  StiffnessMatrix out{.matrix = network.rotations ? matrix_of<6>(network) : matrix_of<3>(network),
                      .grain = std::move(network.grain),
                      .unknowns_per_grain = network.rotations ? 6 : 3};
  std::sort(out.grain.begin(), out.grain.end());
  return out;
}

} // namespace granum::network

// SPDX-License-Identifier: GPL-3.0-or-later
#include "stiffness.hpp"

#include <algorithm>
#include <compare>
#include <memory>
#include <vector>

#include "core/vector/level.hpp"
#include "network/contact_operator.hpp"

namespace granum::network {

namespace {

using Corners = CoarseGrid::Corners;
using Shares = CoarseGrid::Shares;
using NodeBlock = Block<6>;

/// The same in terms of u and w instead of u and R w.
template <int Dof>
NodeBlock turned(const Block<Dof>& b, double radius_of_row, double radius_of_column) {
  NodeBlock m;
  for (int r = 0; r < Dof; ++r)
    for (int c = 0; c < Dof; ++c)
      m.at[r][c] = b.at[r][c] * (r < 3 ? 1 : radius_of_row) * (c < 3 ? 1 : radius_of_column);
  return m;
}

/// Contribution to P^T H P of the links between grains of two boxes: blocks of corners of either box.
struct Couplings {
  NodeBlock at[8][8] = {};
};

GRANUM_INLINE void add_shared(const NodeBlock& b, const Shares& rows, const Shares& columns,
                              Couplings& target) {
  for (unsigned i = 0; i < rows.size(); ++i)
    for (unsigned j = 0; j < columns.size(); ++j) {
      const double share = rows[i] * columns[j];
      for (int r = 0; r < 6; ++r)
        for (int c = 0; c < 6; ++c)
          target.at[i][j].at[r][c] += share * b.at[r][c];
    }
}

/// target += P^T b P
/// \param    b   block of H for two grains, or one with itself
template <int Dof>
void add_coarse(const Backbone& backbone, const CoarseGrid& grid, const Block<Dof>& b, std::uint32_t row,
                std::uint32_t column, Couplings& target) {
  const NodeBlock block = turned(b, backbone.radius[row], backbone.radius[column]);
  const Shares rows = grid.shares_of(row), columns = grid.shares_of(column);
  at_vector_level([&](auto) __attribute__((always_inline)) { add_shared(block, rows, columns, target); });
}

/// Symmetric blocks among the corners of one box.
void add_box(const Couplings& sum, const Corners& nodes, CoarseFactor& factor) {
  for (unsigned i = 0; i < nodes.size(); ++i)
    for (unsigned j = 0; j < nodes.size(); ++j)
      if (nodes[i] >= nodes[j])
        factor.add(nodes[i], nodes[j], dense(sum.at[i][j]));
}

/// Blocks of the corners of one box (rows) and of another (columns), and their transposes.
void add_between(const Couplings& sum, const Corners& rows, const Corners& columns, CoarseFactor& factor) {
  for (unsigned i = 0; i < rows.size(); ++i)
    for (unsigned j = 0; j < columns.size(); ++j) {
      const elastic::Matrix6 block = dense(sum.at[i][j]);
      factor.add(rows[i], columns[j], rows[i] == columns[j] ? block + block.transpose() : block);
    }
}

/// A link of the box of its end b.
struct Placed {
  std::uint32_t box_b, box_a, link;
  auto operator<=>(const Placed&) const = default;
};

bool same_boxes(const Placed& l, const Placed& m) { return l.box_b == m.box_b && l.box_a == m.box_a; }

/// Sorted.
std::vector<Placed> by_boxes(const std::vector<Link>& links, const CoarseGrid& grid) {
  std::vector<Placed> placed;
  placed.reserve(links.size());
  for (std::uint32_t k = 0; k < links.size(); ++k)
    placed.push_back({grid.box_of(links[k].b), grid.box_of(links[k].a), k});
  std::sort(placed.begin(), placed.end());
  return placed;
}

/// Blocks of P^T H P, each once.
std::vector<CoarseFactor::Coupling> coupled_nodes(const std::vector<Placed>& links, const CoarseGrid& grid) {
  std::vector<CoarseFactor::Coupling> couplings;
  const auto couple = [&](std::uint32_t box, std::uint32_t other) {
    for (const std::uint32_t i : grid.nodes_of(box))
      for (const std::uint32_t j : grid.nodes_of(other))
        if (i != j)
          couplings.push_back(std::minmax(i, j));
  };
  for (std::uint32_t box = 0; box < grid.size(); ++box)
    couple(box, box);
  for (std::size_t k = 0; k < links.size(); ++k)
    if (k == 0 || !same_boxes(links[k - 1], links[k]))
      couple(links[k].box_b, links[k].box_a);
  std::sort(couplings.begin(), couplings.end());
  couplings.erase(std::unique(couplings.begin(), couplings.end()), couplings.end());
  return couplings;
}

} // namespace

template <int Dof>
CoarseFactor coarse_stiffness(const Backbone& backbone, const CoarseGrid& grid, const Workers& workers) {
  const std::vector<Placed> links = by_boxes(backbone.links, grid);
  CoarseFactor factor(grid.size(), coupled_nodes(links, grid));
  const auto sum = std::make_unique<Couplings>();
  const std::vector<Block<Dof>> diagonal = diagonal_blocks<Dof>(backbone);
  for (std::size_t box = 0; box < grid.size(); ++box) {
    *sum = {};
    for (const std::uint32_t g : grid.grains_of(box))
      add_coarse(backbone, grid, diagonal[g], g, g, *sum);
    add_box(*sum, grid.nodes_of(box), factor);
  }
  for (auto first = links.begin(), last = first; first != links.end(); first = last) {
    *sum = {};
    for (; last != links.end() && same_boxes(*first, *last); ++last) {
      const Link& l = backbone.links[last->link];
      add_coarse(backbone, grid, link_blocks<Dof>(l, backbone.joint_of(l)).coupling_ba, l.b, l.a, *sum);
    }
    add_between(*sum, grid.nodes_of(first->box_b), grid.nodes_of(first->box_a), factor);
  }
  factor.factorise(workers);
  return factor;
}

template CoarseFactor coarse_stiffness<3>(const Backbone&, const CoarseGrid&, const Workers&);
template CoarseFactor coarse_stiffness<6>(const Backbone&, const CoarseGrid&, const Workers&);

} // namespace granum::network

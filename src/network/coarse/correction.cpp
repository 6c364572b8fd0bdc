// SPDX-License-Identifier: GPL-3.0-or-later
// A grain g moves by u = sum over the nodes k of s_gk v_k and R w = sum of s_gk R w_k, with the shift v_k and
// the rotation w_k of node k, and shares s_gk that are linear in the position of the grain. A wave much
// longer than a box then has nearly its true energy. With rigid motions of aggregates all strain is
// concentrated between them, which takes some eight times the energy.
#include "correction.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <compare>
#include <memory>
#include <numeric>
#include <span>
#include <vector>

#include <granum/core/stop.hpp>

#include "core/vector/level.hpp"
#include "network/contact_operator.hpp"

namespace granum::network {

CoarseGrid::CoarseGrid(const Backbone& backbone, double grains_a_box)
    : part_(backbone.grain_count), box_(backbone.grain_count), grains_(backbone.grain_count) {
  const Vec3 width = packing::cell_widths(backbone.cell);
  const double edge =
      std::cbrt(determinant(backbone.cell) * grains_a_box / static_cast<double>(backbone.grain_count));
  for (unsigned k = 0; k < 3; ++k)
    along_[k] = static_cast<std::size_t>(std::max(1.0, std::round(width[static_cast<int>(k)] / edge)));
  grains_start_.assign(along_[0] * along_[1] * along_[2] + 1, 0);

  const Mat3 to_parts = inverse_of(backbone.cell);
  for (std::size_t g = 0; g < backbone.grain_count; ++g) {
    const Vec3 part = to_parts * backbone.centre[g];
    std::size_t box = 0;
    for (unsigned k = 0; k < 3; ++k) {
      const int axis = static_cast<int>(k);
      const double place = part[axis] * static_cast<double>(along_[k]);
      const double before = std::clamp(std::floor(place), 0.0, static_cast<double>(along_[k] - 1));
      part_[g][axis] = std::clamp(place - before, 0.0, 1.0);
      box = box * along_[k] + static_cast<std::size_t>(before);
    }
    box_[g] = static_cast<std::uint32_t>(box);
    ++grains_start_[box + 1];
  }
  std::partial_sum(grains_start_.begin(), grains_start_.end(), grains_start_.begin());
  std::vector<std::uint32_t> next(grains_start_.begin(), grains_start_.end() - 1);
  for (std::uint32_t g = 0; g < backbone.grain_count; ++g)
    grains_[next[box_[g]]++] = g;
}

/// The boxes or nodes one step further along each set of axes.
CoarseGrid::Corners CoarseGrid::neighbours(std::size_t number, int direction) const {
  const std::array<std::size_t, 3> here{number / along_[2] / along_[1], number / along_[2] % along_[1],
                                        number % along_[2]};
  Corners all{};
  for (unsigned c = 0; c < all.size(); ++c) {
    std::size_t there = 0;
    for (unsigned k = 0; k < 3; ++k) {
      const std::size_t step = (c >> k & 1U) == 0 ? 0 : direction > 0 ? 1 : along_[k] - 1;
      there = there * along_[k] + (here[k] + step) % along_[k];
    }
    all[c] = static_cast<std::uint32_t>(there);
  }
  return all;
}

namespace {

// Largest number of nodes: the factor of P^T H P grows as its power 4/3.
constexpr double most_nodes = 2048;
// Least number of grains: below, making the coarse space takes longer than it saves.
constexpr std::size_t fewest_grains = 20000;

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

/// Factor of P^T H P for the motions P of the nodes of a grid.
template <int Dof>
CoarseFactor coarse_stiffness(const Backbone& backbone, const CoarseGrid& grid, const Workers& workers) {
  const std::vector<Placed> links = by_boxes(backbone.links, grid);
  CoarseFactor factor(grid.size(), coupled_nodes(links, grid));
  const auto sum = std::make_unique<Couplings>();
  const std::vector<Block<Dof>> diagonal = diagonal_blocks<Dof>(backbone);
  for (std::size_t box = 0; box < grid.size(); ++box) {
    stop_point();
    *sum = {};
    for (const std::uint32_t g : grid.grains_of(box))
      add_coarse(backbone, grid, diagonal[g], g, g, *sum);
    add_box(*sum, grid.nodes_of(box), factor);
  }
  for (auto first = links.begin(), last = first; first != links.end(); first = last) {
    stop_point();
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

/// Prefetches the rows of later grains, because those of a box are scattered over memory.
template <int Dof>
GRANUM_INLINE void fetch(std::span<const std::uint32_t> grains, std::size_t k, const Field<Dof>& x) {
  constexpr std::size_t ahead = 4;
  if (k + ahead < grains.size())
    for (const Lanes& row : x[grains[k + ahead]].row)
      __builtin_prefetch(&row);
}

/// c += P^T f of one grain, at the corners of its box.
template <int Dof>
GRANUM_INLINE void add_restricted(const Shares& share, double radius, const Rows<Dof>& f, Rows<6>* c) {
  for (int r = 0; r < Dof; ++r) {
    const Lanes force = r < 3 ? f.row[r] : radius * f.row[r];
    for (unsigned k = 0; k < share.size(); ++k)
      c[k].row[r] += share[k] * force;
  }
}

/// u += P c of one grain.
template <int Dof>
GRANUM_INLINE void add_motion(const Shares& share, double radius, const Rows<6>* c, Rows<Dof>& u) {
  for (int r = 0; r < Dof; ++r) {
    Lanes sum = {};
    for (unsigned k = 0; k < share.size(); ++k)
      sum += share[k] * c[k].row[r];
    u.row[r] += r < 3 ? sum : radius * sum;
  }
}

/// The load r.
template <int Dof>
struct Whole {
  const Field<Dof>& r;
  GRANUM_INLINE const Rows<Dof>& on(std::uint32_t g) const { return r[g]; }
  GRANUM_INLINE void fetch(std::span<const std::uint32_t> grains, std::size_t k) const {
    network::fetch<Dof>(grains, k, r);
  }
};

/// The load less H z, the forces that are already in balance with it.
template <int Dof>
struct Rest {
  const Field<Dof>& r;
  const Field<Dof>& answered;
  GRANUM_INLINE Rows<Dof> on(std::uint32_t g) const {
    Rows<Dof> rest;
    for (int d = 0; d < Dof; ++d)
      rest.row[d] = r[g].row[d] - answered[g].row[d];
    return rest;
  }
  GRANUM_INLINE void fetch(std::span<const std::uint32_t> grains, std::size_t k) const {
    network::fetch<Dof>(grains, k, r);
    network::fetch<Dof>(grains, k, answered);
  }
};

} // namespace

template <int Dof>
CoarseCorrection<Dof>::CoarseCorrection(const Backbone& backbone, const Workers& workers,
                                        double grains_a_node)
    : backbone_(backbone), workers_(workers),
      grid_(backbone, std::max(grains_a_node, static_cast<double>(backbone.grain_count) / most_nodes)),
      factor_(coarse_stiffness<Dof>(backbone, grid_, workers)) {}

template <int Dof>
bool CoarseCorrection<Dof>::pays(const Backbone& backbone) {
  return backbone.grain_count >= fewest_grains;
}

/// u += P (P^T H P)^+ P^T f
template <int Dof>
template <class Force>
void CoarseCorrection<Dof>::add_coarse_motion(const Force& force, Field<Dof>& u) const {
  std::vector<std::array<Rows<6>, 8>> of_box(grid_.size());
  workers_.each(grid_.size(), [&](std::size_t box) {
    at_vector_level([&](auto) __attribute__((always_inline)) {
      const auto grains = grid_.grains_of(box);
      for (std::size_t k = 0; k < grains.size(); ++k) {
        const std::uint32_t g = grains[k];
        force.fetch(grains, k);
        add_restricted<Dof>(grid_.shares_of(g), backbone_.radius[g], force.on(g), of_box[box].data());
      }
    });
  });
  Field<6> motion(grid_.size());
  workers_.each(grid_.size(), [&](std::size_t node) {
    const Corners boxes = grid_.boxes_around(node);
    for (unsigned c = 0; c < boxes.size(); ++c)
      for (int r = 0; r < 6; ++r)
        motion[node].row[r] += of_box[boxes[c]][c].row[r];
  });
  factor_.solve(motion);
  workers_.each(grid_.size(), [&](std::size_t box) {
    std::array<Rows<6>, 8> corner;
    const Corners nodes = grid_.nodes_of(box);
    for (unsigned c = 0; c < nodes.size(); ++c)
      corner[c] = motion[nodes[c]];
    at_vector_level([&](auto) __attribute__((always_inline)) {
      const auto grains = grid_.grains_of(box);
      for (std::size_t k = 0; k < grains.size(); ++k) {
        const std::uint32_t g = grains[k];
        fetch(grains, k, u);
        add_motion<Dof>(grid_.shares_of(g), backbone_.radius[g], corner.data(), u[g]);
      }
    });
  });
}

template <int Dof>
void CoarseCorrection<Dof>::correct(const Field<Dof>& r, Field<Dof>& z) const {
  apply_stiffness<Dof>(backbone_, workers_, 0, z, force_);
  add_coarse_motion(Rest<Dof>{r, force_}, z);
}

template <int Dof>
void CoarseCorrection<Dof>::add_lifted(const Field<Dof>& r, Field<Dof>& q) const {
  add_coarse_motion(Whole<Dof>{r}, q);
}

template class CoarseCorrection<3>;
template class CoarseCorrection<6>;

} // namespace granum::network

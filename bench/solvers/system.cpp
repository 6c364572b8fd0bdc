// SPDX-License-Identifier: GPL-3.0-or-later
#include "system.hpp"

#include <cstdint>
#include <utility>

#include "network/contact_operator.hpp"

namespace granum::bench {

namespace {

using Block = network::Block<6>;

/// What a grain couples with: another, by a link; or itself.
struct Coupled {
  std::uint32_t grain;
  const network::Link* link; ///< null: the grain with itself
};

/// Of each grain, in rising order: links are sorted by (b, a).
std::vector<std::vector<Coupled>> couplings(const network::Backbone& backbone) {
  std::vector<std::vector<Coupled>> rows(backbone.grain_count);
  std::uint32_t done = 0;
  const auto diagonals_to = [&](std::uint32_t last) {
    for (; done < last; ++done)
      rows[done].push_back({done, nullptr});
  };
  for (const network::Link& l : backbone.links) {
    diagonals_to(l.b);
    rows[l.b].push_back({l.a, &l});
    rows[l.a].push_back({l.b, &l});
  }
  diagonals_to(static_cast<std::uint32_t>(backbone.grain_count));
  return rows;
}

/// Adds the block of a link in the row of grain g.
void add_link(const network::Backbone& backbone, const network::Link& l, std::uint32_t g, Block& sum) {
  const Block ba = network::link_blocks<6>(l, backbone.joint_of(l)).coupling_ba;
  for (int r = 0; r < 6; ++r)
    for (int c = 0; c < 6; ++c)
      sum.at[r][c] += g == l.b ? ba.at[r][c] : ba.at[c][r];
}

} // namespace

Matrix assembled(const network::Backbone& backbone, double shift) {
  const std::vector<Block> diagonal = network::diagonal_blocks<6>(backbone);
  double mean = 0;
  for (const Block& b : diagonal)
    for (int r = 0; r < 6; ++r)
      mean += b.at[r][r] / (6 * static_cast<double>(diagonal.size()));
  const std::vector<std::vector<Coupled>> rows = couplings(backbone);
  Matrix h;
  const std::size_t most = 36 * (backbone.grain_count + 2 * backbone.links.size());
  h.column.reserve(most);
  h.value.reserve(most);
  h.row_start.reserve(6 * backbone.grain_count + 1);
  h.row_start.push_back(0);
  std::vector<std::pair<std::uint32_t, Block>> blocks; // of one grain
  for (std::uint32_t g = 0; g < backbone.grain_count; ++g) {
    blocks.clear();
    for (const Coupled& with : rows[g]) {
      if (blocks.empty() || blocks.back().first != with.grain)
        blocks.emplace_back(with.grain, Block{});
      if (with.link == nullptr)
        network::add(diagonal[g], blocks.back().second);
      else
        add_link(backbone, *with.link, g, blocks.back().second);
    }
    for (int r = 0; r < 6; ++r) {
      for (const auto& [other, block] : blocks)
        for (int c = 0; c < 6; ++c) {
          h.column.push_back(static_cast<int>(6 * other) + c);
          h.value.push_back(block.at[r][c] + (other == g && r == c ? shift * mean : 0));
        }
      h.row_start.push_back(static_cast<int>(h.column.size()));
    }
  }
  return h;
}

std::vector<double> rigid_motions(const network::Backbone& backbone) {
  const std::size_t rows = 6 * backbone.grain_count;
  std::vector<double> motions(6 * rows);
  for (std::size_t g = 0; g < backbone.grain_count; ++g)
    for (int k = 0; k < 3; ++k) {
      const auto d = static_cast<std::size_t>(k);
      motions[d * rows + 6 * g + d] = 1;
      Vec3 axis;
      axis[k] = 1;
      const Vec3 u = cross(axis, backbone.centre[g]);
      for (int i = 0; i < 3; ++i)
        motions[(3 + d) * rows + 6 * g + static_cast<std::size_t>(i)] = u[i];
      motions[(3 + d) * rows + 6 * g + 3 + d] = backbone.radius[g];
    }
  return motions;
}

void take_case(const Motions& from, int load_case, double* to) {
  for (const auto& grain : from)
    for (const network::Lanes& row : grain.row)
      *to++ = row[load_case];
}

void put_case(const double* from, int load_case, Motions& to) {
  for (auto& grain : to)
    for (network::Lanes& row : grain.row)
      row[load_case] = *from++;
}

Preconditioner case_by_case(int rows,
                            std::function<void(const std::vector<double>& r, std::vector<double>& z)> solve) {
  const auto size = static_cast<std::size_t>(rows);
  return [solve = std::move(solve), in = std::vector<double>(size),
          out = std::vector<double>(size)](const Motions& r, Motions& z) mutable {
    for (int c = 0; c < network::load_cases; ++c) {
      take_case(r, c, in.data());
      solve(in, out);
      put_case(out.data(), c, z);
    }
  };
}

} // namespace granum::bench

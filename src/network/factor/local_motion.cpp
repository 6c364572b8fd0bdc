// SPDX-License-Identifier: GPL-3.0-or-later
#include "local_motion.hpp"

#include <algorithm>
#include <numeric>

#include "network/link_forces.hpp"

namespace granum::network {

namespace {

/// First link of each grain, for links sorted by `end`.
std::vector<std::uint32_t> starts(const Backbone& backbone, std::uint32_t Link::*end) {
  std::vector<std::uint32_t> start(backbone.grain_count + 1);
  for (const Link& l : backbone.links)
    ++start[l.*end + 1];
  std::partial_sum(start.begin(), start.end(), start.begin());
  return start;
}

template <int Dof>
void add_work(const Rows<Dof>& x, const Rows<Dof>& force, Lanes& sum) {
  for (int r = 0; r < Dof; ++r)
    sum += x.row[r] * force.row[r];
}

} // namespace

LinksOfGrains::LinksOfGrains(const Backbone& backbone)
    : backbone_(backbone), links_(backbone.links), later_start_(starts(backbone, &Link::b)),
      earlier_start_(starts(backbone, &Link::a)), earlier_(backbone.links.size()) {
  std::vector<std::uint32_t> next(earlier_start_.begin(), earlier_start_.end() - 1);
  for (std::uint32_t k = 0; k < backbone.links.size(); ++k)
    earlier_[next[backbone.links[k].a]++] = k;
}

template <int Dof>
Rows<Dof>& LocalMotion<Dof>::of(std::uint32_t grain) {
  if (!moves(grain)) {
    place_[grain] = static_cast<std::uint32_t>(rows_.size());
    grains_.push_back(grain);
    rows_.emplace_back();
    untaken_.push_back(grain);
    std::push_heap(untaken_.begin(), untaken_.end());
  }
  return rows_[place_[grain]];
}

template <int Dof>
bool LocalMotion<Dof>::take_latest(std::uint32_t& grain) {
  if (untaken_.empty())
    return false;
  std::pop_heap(untaken_.begin(), untaken_.end());
  grain = untaken_.back();
  untaken_.pop_back();
  return true;
}

template <int Dof>
PerCase LocalMotion<Dof>::squares() const {
  Lanes sum = {};
  for (const Rows<Dof>& x : rows_)
    add_work<Dof>(x, x, sum);
  PerCase squares;
  for (std::size_t c = 0; c < squares.size(); ++c)
    squares[c] = sum[static_cast<int>(c)];
  return squares;
}

template <int Dof>
void LocalMotion<Dof>::add_movers(int lane, double part, std::vector<std::uint32_t>& grains) const {
  std::vector<double> squares(rows_.size());
  double most = 0;
  for (std::size_t k = 0; k < rows_.size(); ++k) {
    for (const Lanes& row : rows_[k].row)
      squares[k] += row[lane] * row[lane];
    most = std::max(most, squares[k]);
  }
  const double least = part * part * most;
  for (std::size_t k = 0; k < squares.size(); ++k)
    if (squares[k] >= least)
      grains.push_back(grains_[k]);
}

template <int Dof>
PerCase LocalMotion<Dof>::energy(const Backbone& backbone, const LinksOfGrains& links) const {
  const Rows<Dof> still = {};
  Lanes sum = {};
  const auto add = [&](const Link& link, const Rows<Dof>& xa, const Rows<Dof>& xb) {
    Rows<Dof> ya = {}, yb = {};
    add_link_forces<Dof>(link, backbone.joint_of(link), xa, xb, ya, yb);
    add_work<Dof>(xa, ya, sum);
    add_work<Dof>(xb, yb, sum);
  };
  for (std::size_t k = 0; k < grains_.size(); ++k) {
    links.with_earlier(grains_[k],
                       [&](const Link& l) { add(l, moves(l.a) ? rows_[place_[l.a]] : still, rows_[k]); });
    links.with_later(grains_[k], [&](const Link& l) {
      if (!moves(l.b)) // otherwise it is added as an earlier link of l.b
        add(l, rows_[k], still);
    });
  }
  if (!backbone.wall_links.empty())
    for (std::size_t k = 0; k < grains_.size(); ++k) {
      auto l = std::lower_bound(backbone.wall_links.begin(), backbone.wall_links.end(), grains_[k],
                                [](const Link& link, std::uint32_t g) { return link.a < g; });
      for (; l != backbone.wall_links.end() && l->a == grains_[k]; ++l) {
        Rows<Dof> y = {};
        add_wall_forces<Dof>(*l, backbone.wall_joint_of(*l), rows_[k], y);
        add_work<Dof>(rows_[k], y, sum);
      }
    }
  PerCase energies;
  for (std::size_t c = 0; c < energies.size(); ++c)
    energies[c] = sum[static_cast<int>(c)];
  return energies;
}

template class LocalMotion<3>;
template class LocalMotion<6>;

} // namespace granum::network

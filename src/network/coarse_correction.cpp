// SPDX-License-Identifier: GPL-3.0-or-later
// A rigid motion of an aggregate is a shift v and a turn w: u = v + w x arm, and R w for the spin. It strains
// no link inside of the aggregate, unless that goes around the periodic cell, or prestress turns with it.
#include "coarse_correction.hpp"

#include <algorithm>
#include <numeric>
#include <span>

#include "contact_operator.hpp"
#include "halving.hpp"
#include "link_answer.hpp"

namespace granum::network {

namespace {

// The factor of P^T H P grows as the 4/3rd power of their number.
constexpr std::size_t most_aggregates = 4096;
// Smaller networks gain less by it than it takes: 35 iterations for 39 at 10,000 dense grains.
constexpr std::size_t fewest_grains = 20000;

using Matrix6 = Eigen::Matrix<double, 6, 6>;

/// Columns: what six rigid motions of an aggregate do to a grain.
template <int Dof>
Eigen::Matrix<double, Dof, 6> rigid_motion(const Vec3& arm, double radius) {
  Eigen::Matrix<double, Dof, 6> m = Eigen::Matrix<double, Dof, 6>::Zero();
  m.template topLeftCorner<3, 3>().setIdentity();
  m.template topRightCorner<3, 3>() << 0, arm.z, -arm.y, -arm.z, 0, arm.x, arm.y, -arm.x, 0;
  if constexpr (Dof == 6)
    m.template bottomRightCorner<3, 3>() = radius * Eigen::Matrix3d::Identity();
  return m;
}

template <int Dof>
Eigen::Matrix<double, Dof, Dof> matrix(const Block<Dof>& b) {
  Eigen::Matrix<double, Dof, Dof> m;
  for (int r = 0; r < Dof; ++r)
    for (int c = 0; c < Dof; ++c)
      m(r, c) = b.at[r][c];
  return m;
}

/// c += P^T f of one grain.
template <int Dof>
GRANUM_INLINE void add_restricted(const Vec3& x, double radius, const Rows<Dof>& f, Rows<6>& c) {
  for (int k = 0; k < 3; ++k)
    c.row[k] += f.row[k];
  c.row[3] += x.y * f.row[2] - x.z * f.row[1];
  c.row[4] += x.z * f.row[0] - x.x * f.row[2];
  c.row[5] += x.x * f.row[1] - x.y * f.row[0];
  if constexpr (Dof == 6)
    for (int k = 0; k < 3; ++k)
      c.row[3 + k] += radius * f.row[3 + k];
}

/// u += P c of one grain.
template <int Dof>
GRANUM_INLINE void add_motion(const Vec3& x, double radius, const Rows<6>& c, Rows<Dof>& u) {
  u.row[0] += c.row[0] + (c.row[4] * x.z - c.row[5] * x.y);
  u.row[1] += c.row[1] + (c.row[5] * x.x - c.row[3] * x.z);
  u.row[2] += c.row[2] + (c.row[3] * x.y - c.row[4] * x.x);
  if constexpr (Dof == 6)
    for (int k = 0; k < 3; ++k)
      u.row[3 + k] += radius * c.row[3 + k];
}

/// Sorted lists of one length each, one behind the other.
std::vector<std::uint32_t> starts(const std::vector<std::uint32_t>& lengths) {
  std::vector<std::uint32_t> start(lengths.size() + 1, 0);
  std::partial_sum(lengths.begin(), lengths.end(), start.begin() + 1);
  return start;
}

} // namespace

template <int Dof>
CoarseCorrection<Dof>::CoarseCorrection(const Backbone& backbone, const Workers& workers,
                                        std::size_t most_grains)
    : backbone_(backbone), workers_(workers) {
  gather(most_grains);
  list_ends();
  factorise();
}

template <int Dof>
bool CoarseCorrection<Dof>::pays(const Backbone& backbone) {
  return backbone.grain_count >= fewest_grains;
}

/// Aggregates: all grains, halved again and again.
template <int Dof>
void CoarseCorrection<Dof>::gather(std::size_t most_grains) {
  const std::size_t n = backbone_.grain_count;
  grains_.resize(n);
  std::iota(grains_.begin(), grains_.end(), 0U);
  grains_start_ = {0, static_cast<std::uint32_t>(n)};
  const auto part = [this](std::size_t k) {
    return std::span(grains_).subspan(grains_start_[k], grains_start_[k + 1] - grains_start_[k]);
  };
  while (n > most_grains * size() && size() < most_aggregates) {
    std::vector<std::uint32_t> finer(2 * size() + 1, static_cast<std::uint32_t>(n));
    workers_.each(size(), [&](std::size_t k) {
      finer[2 * k] = grains_start_[k];
      finer[2 * k + 1] = grains_start_[k] + static_cast<std::uint32_t>(halve(backbone_.centre, part(k)));
    });
    grains_start_ = std::move(finer);
  }
  aggregate_.resize(n);
  arm_.resize(n);
  workers_.each(size(), [&](std::size_t k) {
    Vec3 sum{};
    for (const std::uint32_t g : part(k))
      sum += backbone_.centre[g];
    for (const std::uint32_t g : part(k)) {
      aggregate_[g] = static_cast<std::uint32_t>(k);
      arm_[g] = backbone_.centre[g] - (1 / static_cast<double>(part(k).size())) * sum;
    }
  });
}

template <int Dof>
bool CoarseCorrection<Dof>::is_strained(const Link& link) const {
  constexpr double rounding = 1e-6;
  return aggregate_[link.a] != aggregate_[link.b] || link.prestress != 0 ||
         norm(arm_[link.b] - arm_[link.a] - link.length * link.normal) > rounding;
}

template <int Dof>
void CoarseCorrection<Dof>::list_ends() {
  const auto list = [this](const auto& for_each_end, std::vector<End>& ends,
                           std::vector<std::uint32_t>& ends_start) {
    std::vector<std::uint32_t> count(size(), 0);
    for_each_end([&](std::uint32_t grain, End) { ++count[aggregate_[grain]]; });
    ends_start = starts(count);
    ends.resize(ends_start.back());
    std::vector<std::uint32_t> next(ends_start.begin(), ends_start.end() - 1);
    for_each_end([&](std::uint32_t grain, End end) { ends[next[aggregate_[grain]]++] = end; });
  };
  list(
      [this](const auto& see) {
        for (std::uint32_t k = 0; k < backbone_.links.size(); ++k)
          if (const Link& l = backbone_.links[k]; is_strained(l)) {
            see(l.a, End{k, true});
            see(l.b, End{k, false});
          }
      },
      ends_, ends_start_);
  list(
      [this](const auto& see) {
        for (std::uint32_t k = 0; k < backbone_.wall_links.size(); ++k)
          see(backbone_.wall_links[k].a, End{k, true});
      },
      wall_ends_, wall_ends_start_);
}

template <int Dof>
void CoarseCorrection<Dof>::factorise() {
  std::vector<CoarseFactor::Coupling> couplings;
  for (const End& end : ends_)
    if (const Link& l = backbone_.links[end.link]; end.at_a && aggregate_[l.a] != aggregate_[l.b])
      couplings.push_back(std::minmax(aggregate_[l.a], aggregate_[l.b]));
  factor_.emplace(size(), couplings);
  const auto motion = [this](std::uint32_t g) { return rigid_motion<Dof>(arm_[g], backbone_.radius[g]); };
  for (const End& end : ends_) {
    if (!end.at_a)
      continue;
    const Link& l = backbone_.links[end.link];
    const std::uint32_t a = aggregate_[l.a], b = aggregate_[l.b];
    const auto blocks = link_blocks<Dof>(l);
    const auto at_a = motion(l.a), at_b = motion(l.b);
    factor_->add(a, a, at_a.transpose() * matrix<Dof>(blocks.diagonal_a) * at_a);
    factor_->add(b, b, at_b.transpose() * matrix<Dof>(blocks.diagonal_b) * at_b);
    const Matrix6 coupling = at_b.transpose() * matrix<Dof>(blocks.coupling_ba) * at_a;
    if (a == b)
      factor_->add(a, a, coupling + coupling.transpose());
    else
      factor_->add(b, a, coupling);
  }
  for (const End& end : wall_ends_) {
    const Link& l = backbone_.wall_links[end.link];
    const auto at_a = motion(l.a);
    factor_->add(aggregate_[l.a], aggregate_[l.a], at_a.transpose() * matrix<Dof>(wall_block<Dof>(l)) * at_a);
  }
  factor_->factorise();
}

/// P^T r of one aggregate.
template <int Dof>
Rows<6> CoarseCorrection<Dof>::restricted(std::size_t aggregate, const Field<Dof>& r) const {
  Rows<6> sum = {};
  at_vector_level([&](auto) __attribute__((always_inline)) {
    for (std::uint32_t k = grains_start_[aggregate]; k < grains_start_[aggregate + 1]; ++k)
      add_restricted<Dof>(arm_[grains_[k]], backbone_.radius[grains_[k]], r[grains_[k]], sum);
  });
  return sum;
}

/// P^T H z of one aggregate.
template <int Dof>
Rows<6> CoarseCorrection<Dof>::restricted_answer(std::size_t aggregate, const Field<Dof>& z) const {
  Rows<6> sum = {};
  at_vector_level([&](auto) __attribute__((always_inline)) {
    for (std::uint32_t k = ends_start_[aggregate]; k < ends_start_[aggregate + 1]; ++k) {
      const Link& link = backbone_.links[ends_[k].link];
      Rows<Dof> on_a = {}, on_b = {};
      answer<Dof>(link, z[link.a], z[link.b], on_a, on_b);
      const std::uint32_t g = ends_[k].at_a ? link.a : link.b;
      add_restricted<Dof>(arm_[g], backbone_.radius[g], ends_[k].at_a ? on_a : on_b, sum);
    }
    for (std::uint32_t k = wall_ends_start_[aggregate]; k < wall_ends_start_[aggregate + 1]; ++k) {
      const Link& link = backbone_.wall_links[wall_ends_[k].link];
      Rows<Dof> on_a = {};
      answer_to_wall<Dof>(link, z[link.a], on_a);
      add_restricted<Dof>(arm_[link.a], backbone_.radius[link.a], on_a, sum);
    }
  });
  return sum;
}

template <int Dof>
void CoarseCorrection<Dof>::add_motions(const Field<6>& motion, Field<Dof>& z) const {
  workers_.blocks(z.size(), [&](std::size_t, std::size_t first, std::size_t last) {
    at_vector_level([&](auto) __attribute__((always_inline)) {
      for (std::size_t g = first; g < last; ++g)
        add_motion<Dof>(arm_[g], backbone_.radius[g], motion[aggregate_[g]], z[g]);
    });
  });
}

template <int Dof>
void CoarseCorrection<Dof>::correct(const Field<Dof>& r, Field<Dof>& z) const {
  Field<6> c(size());
  workers_.each(size(), [&](std::size_t k) {
    const Rows<6> force = restricted(k, r), answered = restricted_answer(k, z);
    for (int row = 0; row < 6; ++row)
      c[k].row[row] = force.row[row] - answered.row[row];
  });
  factor_->solve(c);
  add_motions(c, z);
}

template <int Dof>
void CoarseCorrection<Dof>::add_lifted(const Field<Dof>& r, Field<Dof>& q) const {
  Field<6> c(size());
  workers_.each(size(), [&](std::size_t k) { c[k] = restricted(k, r); });
  factor_->solve(c);
  add_motions(c, q);
}

template class CoarseCorrection<3>;
template class CoarseCorrection<6>;

} // namespace granum::network

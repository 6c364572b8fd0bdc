// SPDX-License-Identifier: GPL-3.0-or-later
#include "incomplete_factor.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

#include <Eigen/Cholesky>
#include <Eigen/Eigenvalues>

#include "block_algebra.hpp"
#include "contact_operator.hpp"
#include "core/vector/level.hpp"

namespace granum::network {

namespace {

// Numbers that the factor may hold a grain, besides its pivots: 16 blocks with spins; loose packings have 11
constexpr int most_numbers = 16 * 36;

// Where lost pivots are held, one is when an eigenvalue may be below this part of the shift.
constexpr double safe_pivot = 0.1;
// Of a pivot that is held, directions are lost whose eigenvalue is below this part of the mean diagonal: what
// was dropped from the factor has made a stiff direction negative, and its stiffness is not known.
constexpr double lost_stiffness = 0.1;
// Least eigenvalue over that mean of a pivot that is stiffened: more stops some floppy networks from
// arriving.
constexpr double least_stiffened = 1e-4;
// Where pivots are judged: directions whose eigenvalue is below this part of that mean are.
constexpr double soft = 1e-2;
// Their motions leave out displacements whose energy would be below this part of the eigenvalue.
constexpr double negligible_energy = 1e-2;
// They are lost where the energy of the motion is more than so many times the eigenvalue.
constexpr double far_off = 10;

/// target -= left * right
template <int Dof>
GRANUM_INLINE void subtract_product(const Block<Dof>& left, const Block<Dof>& right, Block<Dof>& target) {
  for (int r = 0; r < Dof; ++r)
    for (int k = 0; k < Dof; ++k)
      for (int c = 0; c < Dof; ++c)
        target.at[r][c] -= left.at[r][k] * right.at[k][c];
}

/// target += left * right
template <int Dof>
GRANUM_INLINE void add_product(const Block<Dof>& left, const Block<Dof>& right, Block<Dof>& target) {
  for (int r = 0; r < Dof; ++r)
    for (int k = 0; k < Dof; ++k)
      for (int c = 0; c < Dof; ++c)
        target.at[r][c] += left.at[r][k] * right.at[k][c];
}

template <int Dof>
GRANUM_INLINE Block<Dof> transposed(const Block<Dof>& b) {
  Block<Dof> t;
  for (int r = 0; r < Dof; ++r)
    for (int c = 0; c < Dof; ++c)
      t.at[r][c] = b.at[c][r];
  return t;
}

/// The same numbers, rounded where `To` is shorter.
template <class To, int Dof, class From>
GRANUM_INLINE Block<Dof, To> as(const Block<Dof, From>& b) {
  Block<Dof, To> other;
  for (int r = 0; r < Dof; ++r)
    for (int c = 0; c < Dof; ++c)
      other.at[r][c] = static_cast<To>(b.at[r][c]);
  return other;
}

/// target -= M^T source, or M source, for the stored (transposed) block M = L^T.
template <int Dof>
GRANUM_INLINE void subtract_lower(const Block<Dof>& stored, const Rows<Dof>& source, Rows<Dof>& target) {
  for (int k = 0; k < Dof; ++k)
    for (int r = 0; r < Dof; ++r)
      target.row[r] -= stored.at[k][r] * source.row[k];
}
template <int Dof>
GRANUM_INLINE void subtract_upper(const Block<Dof>& stored, const Rows<Dof>& source, Rows<Dof>& target) {
  for (int r = 0; r < Dof; ++r)
    for (int k = 0; k < Dof; ++k)
      target.row[r] -= stored.at[r][k] * source.row[k];
}

template <int Dof, class Number>
GRANUM_INLINE void substitute_forward(Piece piece, const std::uint32_t* row_start,
                                      const std::uint32_t* column, const Block<Dof, Number>* lower,
                                      const Rows<Dof>* r, Rows<Dof>* z) {
  for (std::size_t i = piece.first; i < piece.last; ++i) {
    Rows<Dof> zi = r[i];
    for (std::uint32_t e = row_start[i]; e < row_start[i + 1]; ++e)
      subtract_lower(as<double>(lower[e]), z[column[e]], zi);
    z[i] = zi;
  }
}

template <int Dof>
GRANUM_INLINE void divide_by_pivots(std::size_t first, std::size_t last, const Block<Dof>* inverse_pivot,
                                    Rows<Dof>* z) {
  for (std::size_t i = first; i < last; ++i) {
    const Rows<Dof> forward = z[i];
    Rows<Dof> zi = {};
    for (int r = 0; r < Dof; ++r)
      for (int k = 0; k < Dof; ++k)
        zi.row[r] += inverse_pivot[i].at[r][k] * forward.row[k];
    z[i] = zi;
  }
}

template <int Dof, class Number>
GRANUM_INLINE void substitute_back(Piece piece, const std::uint32_t* row_start, const std::uint32_t* column,
                                   const Block<Dof, Number>* lower, Rows<Dof>* z) {
  std::uint32_t e = row_start[piece.last];
  for (std::size_t i = piece.last; i-- > piece.first;) {
    const Rows<Dof> zi = z[i];
    while (e > row_start[i]) { // backwards through memory all the way, as processors read ahead best
      --e;
      subtract_upper(as<double>(lower[e]), zi, z[column[e]]);
    }
  }
}

} // namespace

template <int Dof>
IncompleteFactor<Dof>::IncompleteFactor(const Backbone& backbone, const Workers& workers,
                                        const FactorRule& rule)
    : backbone_(backbone), workers_(workers), rule_(rule),
      pattern_(
          fill_pattern_within(backbone, rule.fill_level, static_cast<double>(most_numbers) / (Dof * Dof))),
      inverse_pivot_(diagonal_blocks<Dof>(backbone)) {
  if (rule.soft_pivots == SoftPivots::judged)
    links_.emplace(backbone);
  if (rule.soft_pivots == SoftPivots::stiffened)
    lower_ = std::vector<Block<Dof, double>>();
  std::visit([this](auto& lower) { this->factorise(lower); }, lower_);
}

/// What the factorisation of a row needs.
template <int Dof>
struct IncompleteFactor<Dof>::Work {
  struct Entry {
    std::uint32_t row, index;
  };
  std::vector<std::vector<Entry>>& below; ///< finished entries of each column
  std::vector<std::uint32_t> slot; ///< place in `row` of each column, or `absent`; all are, between two rows
  std::vector<Link>::const_iterator link; ///< first of the links that the next rows hold
  std::vector<Block<Dof>> row = {};       ///< of the present row, transposed; before its division by pivots
  Held held = {};
  std::size_t mended_pivots = 0;
};

template <int Dof>
template <class Number>
void IncompleteFactor<Dof>::factorise(Lower<Number>& lower) {
  lower.resize(pattern_.size());
  const std::size_t n = inverse_pivot_.size();
  double mean = 0;
  for (const auto& d : inverse_pivot_)
    for (int r = 0; r < Dof; ++r)
      mean += d.at[r][r] / static_cast<double>(n * Dof);
  if (!(mean > 0))
    mean = 1;
  std::vector<std::vector<typename Work::Entry>> below(n);
  Held held;
  for (const std::vector<Piece>& stage : backbone_.stages) {
    std::vector<std::size_t> pivots(stage.size());
    std::vector<Held> directions(stage.size());
    workers_.each(stage.size(), [&](std::size_t k) {
      const auto link = std::lower_bound(backbone_.links.begin(), backbone_.links.end(), stage[k].first,
                                         [](const Link& l, std::uint32_t g) { return l.b < g; });
      Work work{below, std::vector<std::uint32_t>(n, LocalMotion<Dof>::absent), link};
      factorise(stage[k], mean, work, lower);
      pivots[k] = work.mended_pivots;
      directions[k] = std::move(work.held);
    });
    mended_pivots_ = std::accumulate(pivots.begin(), pivots.end(), mended_pivots_);
    for (const Held& of_piece : directions)
      held.insert(held.end(), of_piece.begin(), of_piece.end());
  }
  below.clear();
  below.shrink_to_fit();
  release(held, mean, lower);
}

/// Row i of H, with places for its fill.
template <int Dof>
void IncompleteFactor<Dof>::begin_row(std::uint32_t i, Work& work) const {
  const std::uint32_t first = pattern_.row_start[i], last = pattern_.row_start[i + 1];
  work.row.assign(last - first, {});
  for (std::uint32_t e = first; e < last; ++e)
    work.slot[pattern_.column[e]] = e - first;
  for (; work.link != backbone_.links.end() && work.link->b == i; ++work.link)
    add(transposed(link_blocks<Dof>(*work.link).coupling_ba), work.row[work.slot[work.link->a]]);
}

template <int Dof>
template <class Number>
void IncompleteFactor<Dof>::factorise(Piece piece, double mean, Work& work, Lower<Number>& lower) {
  for (std::uint32_t i = piece.first; i < piece.last; ++i) {
    Block<Dof>& pivot = inverse_pivot_[i];
    for (int r = 0; r < Dof && rule_.soft_pivots != SoftPivots::judged; ++r)
      pivot.at[r][r] += rule_.shift * mean;
    begin_row(i, work);
    at_vector_level([&](auto) __attribute__((always_inline)) { eliminate(i, work, lower, pivot); });
    const std::uint32_t first = pattern_.row_start[i], last = pattern_.row_start[i + 1];
    for (std::uint32_t e = first; e < last; ++e) {
      work.below[pattern_.column[e]].push_back({i, e});
      work.slot[pattern_.column[e]] = LocalMotion<Dof>::absent;
    }
    if (invert_pivot(i, mean, work, lower))
      ++work.mended_pivots;
  }
}

/// Energies of the motions L^-T d that directions d of grain i stand for, one in each lane, without
/// displacements below `negligible`.
template <int Dof>
template <class Number>
PerCase IncompleteFactor<Dof>::motion_energy(std::uint32_t i, const Rows<Dof>& directions, double negligible,
                                             Work& work, const Lower<Number>& lower) const {
  const auto bears = [negligible](const Rows<Dof>& x) {
    for (const Lanes& row : x.row)
      for (int k = 0; k < Dof; ++k)
        if (std::abs(row[k]) >= negligible)
          return true;
    return false;
  };
  LocalMotion<Dof> motion(work.slot);
  motion.of(i) = directions;
  for (std::uint32_t g = i; motion.take_latest(g);)
    if (const Rows<Dof> here = motion.of(g); bears(here))
      for (std::uint32_t e = pattern_.row_start[g]; e < pattern_.row_start[g + 1]; ++e)
        subtract_upper(as<double>(lower[e]), here, motion.of(pattern_.column[e]));
  return motion.energy(backbone_, *links_);
}

/// Eigenvalues of a pivot, the soft ones after what their motions say.
template <int Dof>
template <class Number>
auto IncompleteFactor<Dof>::judged_values(std::uint32_t i, const PivotSystem& pivot, double mean, Work& work,
                                          const Lower<Number>& lower) const -> Vector {
  Vector values = pivot.eigenvalues();
  double softest = 1; // at most, over the mean diagonal
  Rows<Dof> directions = {};
  for (int k = 0; k < Dof && values[k] < soft * mean; ++k) {
    softest = std::min(softest, std::max(std::abs(values[k]) / mean, rule_.shift));
    for (int r = 0; r < Dof; ++r)
      directions.row[r][k] = pivot.eigenvectors()(r, k);
  }
  if (values[0] >= soft * mean)
    return values;
  const PerCase energy = motion_energy(i, directions, std::sqrt(negligible_energy * softest), work, lower);
  for (int k = 0; k < Dof && pivot.eigenvalues()[k] < soft * mean; ++k)
    values[k] = std::max(energy[static_cast<std::size_t>(k)], rule_.shift * mean);
  return values;
}

/// Replaces a symmetric pivot by its inverse; returns whether it had to be mended first.
/// \param    mean    of the diagonal of H
template <int Dof>
template <class Number>
bool IncompleteFactor<Dof>::invert_pivot(std::uint32_t i, double mean, Work& work,
                                         const Lower<Number>& lower) {
  using Square = Eigen::Matrix<double, Dof, Dof, Eigen::RowMajor>;
  Eigen::Map<Square> map(&inverse_pivot_[i].at[0][0]);
  const Square symmetric = (map + map.transpose()) / 2;
  const bool judges = rule_.soft_pivots == SoftPivots::judged;
  const double safe = judges ? 2 * soft : safe_pivot * rule_.shift;
  const Eigen::LLT<Eigen::Matrix<double, Dof, Dof>> cholesky(symmetric);
  if (cholesky.info() == Eigen::Success &&
      cholesky.matrixLLT().diagonal().cwiseAbs2().minCoeff() >= safe * mean) {
    map = cholesky.solve(Eigen::Matrix<double, Dof, Dof>::Identity());
    return false;
  }
  const PivotSystem pivot(symmetric);
  const Vector found = pivot.eigenvalues();
  Vector inverses;
  bool mended = true;
  if (rule_.soft_pivots == SoftPivots::stiffened)
    inverses = found.unaryExpr([&](double v) { return 1 / std::max(std::abs(v), least_stiffened * mean); });
  else {
    const Vector values = judges ? judged_values(i, pivot, mean, work, lower) : found;
    const double least = rule_.shift * mean;
    mended = !judges || (values.array() > far_off * found.array().max(least)).any();
    inverses = values.cwiseInverse();
    for (int k = 0; k < Dof && mended && found[k] < lost_stiffness * mean; ++k)
      if (!judges || values[k] > least) // else nothing resists it
        hold(i, pivot, k, work.held, inverses);
  }
  map = pivot.eigenvectors() * inverses.asDiagonal() * pivot.eigenvectors().transpose();
  return mended;
}

/// Takes eigenvector k of a pivot out of its inverse.
template <int Dof>
void IncompleteFactor<Dof>::hold(std::uint32_t i, const PivotSystem& pivot, int k, Held& held,
                                 Vector& inverses) {
  HeldDirection found{.row = i};
  for (int r = 0; r < Dof; ++r)
    found.direction[static_cast<std::size_t>(r)] = pivot.eigenvectors()(r, k);
  held.push_back(found);
  inverses[k] = 0;
}

/// Gives each direction d that was held the stiffness v^T H v of the motion v = L^-T d, or the shift of the
/// diagonal where that is more, as free ones get.
template <int Dof>
template <class Number>
void IncompleteFactor<Dof>::release(const Held& held, double mean, const Lower<Number>& lower) {
  Field<Dof> v, answer;
  for (std::size_t first = 0; first < held.size(); first += load_cases) {
    const std::size_t count = std::min<std::size_t>(load_cases, held.size() - first);
    v.assign(inverse_pivot_.size(), {});
    for (std::size_t k = 0; k < count; ++k)
      for (int r = 0; r < Dof; ++r)
        v[held[first + k].row].row[r][k] = held[first + k].direction[static_cast<std::size_t>(r)];
    solve_upper(lower, v);
    apply_stiffness<Dof>(backbone_, workers_, 0, v, answer);
    const elastic::Matrix6 energy = products<Dof>(workers_, v, answer);
    for (std::size_t k = 0; k < count; ++k) {
      const HeldDirection& d = held[first + k];
      const auto at = static_cast<Eigen::Index>(k);
      const double stiffness = std::max(energy(at, at), rule_.shift * mean);
      for (int r = 0; r < Dof; ++r)
        for (int c = 0; c < Dof; ++c)
          inverse_pivot_[d.row].at[r][c] +=
              d.direction[static_cast<std::size_t>(r)] * d.direction[static_cast<std::size_t>(c)] / stiffness;
    }
  }
}

/// Row i of L and pivot i, from the finished rows.
template <int Dof>
template <class Number>
GRANUM_INLINE void IncompleteFactor<Dof>::eliminate(std::uint32_t i, Work& work, Lower<Number>& lower,
                                                    Block<Dof>& pivot) {
  const std::uint32_t first = pattern_.row_start[i];
  for (std::uint32_t e = first; e < pattern_.row_start[i + 1]; ++e) {
    const std::uint32_t j = pattern_.column[e];
    const Block<Dof>& unscaled = work.row[e - first]; // (L_ij D_j)^T
    for (const auto [k, index] : work.below[j])
      if (const std::uint32_t slot = work.slot[k]; slot != LocalMotion<Dof>::absent)
        subtract_product(transposed(as<double>(lower[index])), unscaled, work.row[slot]);
    Block<Dof> scaled;
    add_product(inverse_pivot_[j], unscaled, scaled);
    subtract_product(transposed(scaled), unscaled, pivot);
    lower[e] = as<Number>(scaled);
  }
}

template <int Dof>
void IncompleteFactor<Dof>::solve(const Field<Dof>& r, Field<Dof>& z) const {
  std::visit([&](const auto& lower) { solve(lower, r, z); }, lower_);
}

template <int Dof>
template <class Number>
void IncompleteFactor<Dof>::solve(const Lower<Number>& lower, const Field<Dof>& r, Field<Dof>& z) const {
  z.resize(r.size());
  for (const std::vector<Piece>& stage : backbone_.stages)
    workers_.each(stage.size(), [&](std::size_t k) {
      at_vector_level([&](auto) __attribute__((always_inline)) {
        substitute_forward(stage[k], pattern_.row_start.data(), pattern_.column.data(), lower.data(),
                           r.data(), z.data());
      });
    });
  workers_.blocks(z.size(), [&](std::size_t, std::size_t first, std::size_t last) {
    at_vector_level([&](auto) __attribute__((always_inline)) {
      divide_by_pivots<Dof>(first, last, inverse_pivot_.data(), z.data());
    });
  });
  solve_upper(lower, z);
}

/// z = L^-T z
template <int Dof>
template <class Number>
void IncompleteFactor<Dof>::solve_upper(const Lower<Number>& lower, Field<Dof>& z) const {
  for (auto stage = backbone_.stages.rbegin(); stage != backbone_.stages.rend(); ++stage)
    workers_.each(stage->size(), [&](std::size_t k) {
      at_vector_level([&](auto) __attribute__((always_inline)) {
        substitute_back((*stage)[k], pattern_.row_start.data(), pattern_.column.data(), lower.data(),
                        z.data());
      });
    });
}

template class IncompleteFactor<3>;
template class IncompleteFactor<6>;

} // namespace granum::network

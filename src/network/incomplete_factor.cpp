// SPDX-License-Identifier: GPL-3.0-or-later
#include "incomplete_factor.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

#include <Eigen/Cholesky>
#include <Eigen/Eigenvalues>

#include "contact_operator.hpp"
#include "core/vector/level.hpp"

namespace granum::network {

namespace {

constexpr std::uint32_t absent = ~std::uint32_t{0};

// Added to the diagonal, over its mean, for spins that nothing resists: a grain with two contacts turns
// freely about them. A thousand times as much takes 114 iterations in place of 84 at 10,000 loose grains.
constexpr double shift_of_diagonal = 1e-6;
// A pivot is mended when an eigenvalue may be below this part of the shift.
constexpr double safe_pivot = 0.1;
// Least eigenvalue of a mended pivot, over the mean diagonal: what was dropped from the factor has made a
// stiff direction negative, and its stiffness is not known. Between 1e-5 and 1e-3 it makes no difference.
constexpr double mended_stiffness = 1e-4;

template <int Dof>
void add(const Block<Dof>& from, Block<Dof>& to) {
  for (int r = 0; r < Dof; ++r)
    for (int c = 0; c < Dof; ++c)
      to.at[r][c] += from.at[r][c];
}

/// target -= left * right
template <int Dof>
GRANUM_INLINE void subtract_product(const Block<Dof>& left, const Block<Dof>& right, Block<Dof>& target) {
  for (int r = 0; r < Dof; ++r)
    for (int k = 0; k < Dof; ++k)
      for (int c = 0; c < Dof; ++c)
        target.at[r][c] -= left.at[r][k] * right.at[k][c];
}

template <int Dof>
GRANUM_INLINE Block<Dof> transposed(const Block<Dof>& b) {
  Block<Dof> t;
  for (int r = 0; r < Dof; ++r)
    for (int c = 0; c < Dof; ++c)
      t.at[r][c] = b.at[c][r];
  return t;
}

/// Replaces a symmetric pivot by its inverse; returns whether it had to be mended first.
/// \param    mean   of the diagonal of H
template <int Dof>
bool invert_pivot(Block<Dof>& pivot, double mean) {
  using Square = Eigen::Matrix<double, Dof, Dof, Eigen::RowMajor>;
  Eigen::Map<Square> map(&pivot.at[0][0]);
  const Square symmetric = (map + map.transpose()) / 2;
  const Eigen::LLT<Eigen::Matrix<double, Dof, Dof>> cholesky(symmetric);
  if (cholesky.info() == Eigen::Success &&
      cholesky.matrixLLT().diagonal().cwiseAbs2().minCoeff() >= safe_pivot * shift_of_diagonal * mean) {
    map = cholesky.solve(Eigen::Matrix<double, Dof, Dof>::Identity());
    return false;
  }
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix<double, Dof, Dof>> eigen(symmetric);
  const Eigen::Matrix<double, Dof, 1> inverse = eigen.eigenvalues().unaryExpr(
      [&](double value) { return 1 / std::max(std::abs(value), mended_stiffness * mean); });
  map = eigen.eigenvectors() * inverse.asDiagonal() * eigen.eigenvectors().transpose();
  return true;
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

template <int Dof>
GRANUM_INLINE void substitute_forward(Piece piece, const std::uint32_t* row_start,
                                      const std::uint32_t* column, const Block<Dof>* lower,
                                      const Rows<Dof>* r, Rows<Dof>* z) {
  for (std::size_t i = piece.first; i < piece.last; ++i) {
    Rows<Dof> zi = r[i];
    for (std::uint32_t e = row_start[i]; e < row_start[i + 1]; ++e)
      subtract_lower(lower[e], z[column[e]], zi);
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

template <int Dof>
GRANUM_INLINE void substitute_back(Piece piece, const std::uint32_t* row_start, const std::uint32_t* column,
                                   const Block<Dof>* lower, Rows<Dof>* z) {
  for (std::size_t i = piece.last; i-- > piece.first;) {
    const Rows<Dof> zi = z[i];
    for (std::uint32_t e = row_start[i]; e < row_start[i + 1]; ++e)
      subtract_upper(lower[e], zi, z[column[e]]);
  }
}

} // namespace

template <int Dof>
IncompleteFactor<Dof>::IncompleteFactor(const Backbone& backbone, const Workers& workers)
    : stages_(backbone.stages), workers_(workers) {
  find_pattern(backbone);
  assemble(backbone);
  factorise();
}

template <int Dof>
void IncompleteFactor<Dof>::find_pattern(const Backbone& backbone) {
  std::vector<std::vector<std::uint32_t>> above(backbone.grain_count), rows(backbone.grain_count);
  for (const Link& l : backbone.links) {
    above[l.a].push_back(l.b);
    rows[l.b].push_back(l.a);
  }
  for (auto& later : above) // one level of fill: two grains coupled through an earlier common neighbour
    for (const std::uint32_t i : later)
      for (const std::uint32_t k : later)
        if (k < i)
          rows[i].push_back(k);
  row_start_.assign(1, 0);
  for (auto& row : rows) {
    std::sort(row.begin(), row.end());
    row.erase(std::unique(row.begin(), row.end()), row.end());
    column_.insert(column_.end(), row.begin(), row.end());
    row_start_.push_back(static_cast<std::uint32_t>(column_.size()));
  }
}

template <int Dof>
void IncompleteFactor<Dof>::assemble(const Backbone& backbone) {
  lower_.assign(column_.size(), {});
  inverse_pivot_.assign(backbone.grain_count, {});
  for (const Link& l : backbone.links) {
    const auto blocks = link_blocks<Dof>(l);
    add(blocks.diagonal_a, inverse_pivot_[l.a]);
    add(blocks.diagonal_b, inverse_pivot_[l.b]);
    const std::uint32_t* const entry =
        std::lower_bound(column_.data() + row_start_[l.b], column_.data() + row_start_[l.b + 1], l.a);
    add(transposed(blocks.coupling_ba), lower_[static_cast<std::size_t>(entry - column_.data())]);
  }
  for (const Link& l : backbone.wall_links)
    add(wall_block<Dof>(l), inverse_pivot_[l.a]);
}

/// What the factorisation of a row needs.
template <int Dof>
struct IncompleteFactor<Dof>::Work {
  struct Entry {
    std::uint32_t row, index;
  };
  std::vector<std::vector<Entry>>& below; ///< finished entries of each column
  std::vector<std::uint32_t> slot;        ///< entry of the present row in each column, or `absent`
};

template <int Dof>
void IncompleteFactor<Dof>::factorise() {
  const std::size_t n = inverse_pivot_.size();
  double mean = 0;
  for (const auto& d : inverse_pivot_)
    for (int r = 0; r < Dof; ++r)
      mean += d.at[r][r] / static_cast<double>(n * Dof);
  if (!(mean > 0))
    mean = 1;
  std::vector<std::vector<typename Work::Entry>> below(n);
  for (const std::vector<Piece>& stage : stages_) {
    std::vector<std::size_t> mended(stage.size());
    workers_.each(stage.size(), [&](std::size_t k) {
      Work work{below, std::vector<std::uint32_t>(n, absent)};
      mended[k] = factorise(stage[k], mean, work);
    });
    mended_pivots_ = std::accumulate(mended.begin(), mended.end(), mended_pivots_);
  }
}

/// Returns how many pivots were mended.
template <int Dof>
std::size_t IncompleteFactor<Dof>::factorise(Piece piece, double mean, Work& work) {
  std::size_t mended = 0;
  for (std::uint32_t i = piece.first; i < piece.last; ++i) {
    Block<Dof>& pivot = inverse_pivot_[i];
    for (int r = 0; r < Dof; ++r)
      pivot.at[r][r] += shift_of_diagonal * mean;
    for (std::uint32_t e = row_start_[i]; e < row_start_[i + 1]; ++e)
      work.slot[column_[e]] = e;
    for (std::uint32_t e = row_start_[i]; e < row_start_[i + 1]; ++e) {
      const std::uint32_t j = column_[e];
      const Block<Dof> unscaled = lower_[e]; // (L_ij D_j)^T
      for (const auto [k, index] : work.below[j])
        if (work.slot[k] != absent)
          subtract_product(transposed(lower_[index]), unscaled, lower_[work.slot[k]]);
      Block<Dof> scaled;
      subtract_product(inverse_pivot_[j], unscaled, scaled);
      for (auto& row : scaled.at)
        for (double& value : row)
          value = -value;
      subtract_product(transposed(scaled), unscaled, pivot);
      lower_[e] = scaled;
      work.below[j].push_back({i, e});
    }
    for (std::uint32_t e = row_start_[i]; e < row_start_[i + 1]; ++e)
      work.slot[column_[e]] = absent;
    if (invert_pivot(pivot, mean))
      ++mended;
  }
  return mended;
}

template <int Dof>
void IncompleteFactor<Dof>::solve(const Field<Dof>& r, Field<Dof>& z) const {
  z.resize(r.size());
  for (const std::vector<Piece>& stage : stages_)
    workers_.each(stage.size(), [&](std::size_t k) {
      at_vector_level([&](auto) __attribute__((always_inline)) {
        substitute_forward<Dof>(stage[k], row_start_.data(), column_.data(), lower_.data(), r.data(),
                                z.data());
      });
    });
  workers_.blocks(z.size(), [&](std::size_t, std::size_t first, std::size_t last) {
    at_vector_level([&](auto) __attribute__((always_inline)) {
      divide_by_pivots<Dof>(first, last, inverse_pivot_.data(), z.data());
    });
  });
  for (auto stage = stages_.rbegin(); stage != stages_.rend(); ++stage)
    workers_.each(stage->size(), [&](std::size_t k) {
      at_vector_level([&](auto) __attribute__((always_inline)) {
        substitute_back<Dof>((*stage)[k], row_start_.data(), column_.data(), lower_.data(), z.data());
      });
    });
}

template class IncompleteFactor<3>;
template class IncompleteFactor<6>;

} // namespace granum::network

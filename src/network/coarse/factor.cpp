// SPDX-License-Identifier: GPL-3.0-or-later
#include "factor.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include <Eigen/Core>
#include <Eigen/OrderingMethods>
#include <Eigen/SparseCore>

#include <granum/elastic/eigen_system.hpp>

#include "core/vector/level.hpp"

namespace granum::network {

namespace {

constexpr std::uint32_t none = ~std::uint32_t{0};
// Directions of a pivot below this part of what its diagonal was before the elimination count as free: where
// soft clusters hang together rounding reaches 1e-7.
constexpr double free_direction = 1e-6;

using elastic::Matrix6;

Block<6> stored(const Matrix6& m) {
  Block<6> b;
  for (int r = 0; r < 6; ++r)
    for (int c = 0; c < 6; ++c)
      b.at[r][c] = m(r, c);
  return b;
}

/// Generalised inverse of a pivot; `size` is the diagonal that it had before the elimination.
Block<6> pivot_inverse(const Block<6>& pivot, const std::array<double, 6>& size) {
  using Vector6 = Eigen::Matrix<double, 6, 1>;
  Vector6 scale;
  for (int r = 0; r < 6; ++r)
    scale[r] = size[static_cast<std::size_t>(r)] > 0 ? 1 / std::sqrt(size[static_cast<std::size_t>(r)]) : 0;
  const Matrix6 m = dense(pivot);
  const Matrix6 scaled = scale.asDiagonal() * ((m + m.transpose()) / 2) * scale.asDiagonal();
  const elastic::EigenSystem eigen = elastic::eigen_system(scaled);
  const Vector6 inverse = eigen.values.unaryExpr([](double v) { return v > free_direction ? 1 / v : 0.0; });
  const Matrix6 turned = scale.asDiagonal() * eigen.vectors;
  return stored(turned * inverse.asDiagonal() * turned.transpose());
}

/// The finished part of column k from entry e on, taken off the column that row_[e] names:
/// target -= U D^+ U_e^T for the blocks U = L D of column k.
GRANUM_INLINE void subtract_column(std::uint32_t e, std::uint32_t end, const std::uint32_t* row,
                                   const Block<6>* upper, const Block<6>& inverse_pivot, Block<6>* target) {
  Block<6> factor = {};
  for (int r = 0; r < 6; ++r)
    for (int k = 0; k < 6; ++k)
      for (int c = 0; c < 6; ++c)
        factor.at[r][c] += inverse_pivot.at[r][k] * upper[e].at[c][k];
  for (std::uint32_t f = e; f < end; ++f)
    for (int r = 0; r < 6; ++r)
      for (int k = 0; k < 6; ++k)
        for (int c = 0; c < 6; ++c)
          target[row[f]].at[r][c] -= upper[f].at[r][k] * factor.at[k][c];
}

GRANUM_INLINE void substitute_coarse(std::size_t n, const std::uint32_t* column_start,
                                     const std::uint32_t* row, const Block<6>* lower,
                                     const Block<6>* inverse_pivot, Rows<6>* x) {
  for (std::size_t k = 0; k < n; ++k) {
    const Rows<6> xk = x[k];
    for (std::uint32_t e = column_start[k]; e < column_start[k + 1]; ++e) {
      Rows<6>& target = x[row[e]];
      for (int r = 0; r < 6; ++r)
        for (int c = 0; c < 6; ++c)
          target.row[r] -= lower[e].at[r][c] * xk.row[c];
    }
  }
  for (std::size_t k = n; k-- > 0;) {
    Rows<6> xk = {};
    for (int r = 0; r < 6; ++r)
      for (int c = 0; c < 6; ++c)
        xk.row[r] += inverse_pivot[k].at[r][c] * x[k].row[c];
    for (std::uint32_t e = column_start[k]; e < column_start[k + 1]; ++e) {
      const Rows<6>& source = x[row[e]];
      for (int r = 0; r < 6; ++r)
        for (int c = 0; c < 6; ++c)
          xk.row[c] -= lower[e].at[r][c] * source.row[r];
    }
    x[k] = xk;
  }
}

} // namespace

elastic::Matrix6 dense(const Block<6>& b) {
  Matrix6 m;
  for (int r = 0; r < 6; ++r)
    for (int c = 0; c < 6; ++c)
      m(r, c) = b.at[r][c];
  return m;
}

CoarseFactor::CoarseFactor(std::size_t size, const std::vector<Coupling>& couplings) {
  find_order(size, couplings);
  find_pattern(size, couplings);
}

/// By minimum degree, which keeps L sparse.
void CoarseFactor::find_order(std::size_t size, const std::vector<Coupling>& couplings) {
  std::vector<Eigen::Triplet<double>> ones;
  ones.reserve(2 * couplings.size());
  for (const auto& [row, column] : couplings) {
    ones.emplace_back(static_cast<int>(row), static_cast<int>(column), 1);
    ones.emplace_back(static_cast<int>(column), static_cast<int>(row), 1);
  }
  Eigen::SparseMatrix<double> pattern(static_cast<int>(size), static_cast<int>(size));
  pattern.setFromTriplets(ones.begin(), ones.end());
  Eigen::PermutationMatrix<Eigen::Dynamic, Eigen::Dynamic, int> order;
  Eigen::AMDOrdering<int>()(pattern, order);
  place_.resize(size);
  for (std::size_t k = 0; k < size; ++k)
    place_[static_cast<std::size_t>(order.indices()[static_cast<int>(k)])] = static_cast<std::uint32_t>(k);
}

void CoarseFactor::find_pattern(std::size_t size, const std::vector<Coupling>& couplings) {
  std::vector<std::vector<std::uint32_t>> columns(size);
  for (const auto& [row, column] : couplings) {
    const auto [first, last] = std::minmax(place_[row], place_[column]);
    columns[first].push_back(last);
  }
  column_start_.assign(1, 0);
  for (auto& rows : columns) {
    std::sort(rows.begin(), rows.end());
    rows.erase(std::unique(rows.begin(), rows.end()), rows.end());
    row_.insert(row_.end(), rows.begin(), rows.end());
    column_start_.push_back(static_cast<std::uint32_t>(row_.size()));
    if (rows.size() > 1) { // fill: the first of them inherits the others
      auto& heir = columns[rows.front()];
      heir.insert(heir.end(), rows.begin() + 1, rows.end());
    }
  }
  lower_.assign(row_.size(), {});
  inverse_pivot_.assign(size, {});
}

void CoarseFactor::add(std::uint32_t row, std::uint32_t column, const Matrix6& block) {
  const auto add_to = [](Block<6>& target, const Matrix6& m) {
    for (int r = 0; r < 6; ++r)
      for (int c = 0; c < 6; ++c)
        target.at[r][c] += m(r, c);
  };
  const auto [first, last] = std::minmax(place_[row], place_[column]);
  if (first == last)
    return add_to(inverse_pivot_[first], block);
  const std::uint32_t* const found =
      std::lower_bound(row_.data() + column_start_[first], row_.data() + column_start_[first + 1], last);
  const bool below = place_[row] == last;
  add_to(lower_[static_cast<std::size_t>(found - row_.data())], below ? block : Matrix6(block.transpose()));
}

/// Column after column; a finished column waits in the list of the row that it reaches next.
void CoarseFactor::factorise() {
  const auto n = static_cast<std::uint32_t>(place_.size());
  std::vector<Block<6>> work(n);
  std::vector<std::uint32_t> waiting(n, none), behind(n, none), reached(n);
  const auto wait = [&](std::uint32_t column, std::uint32_t entry) {
    if (entry == column_start_[column + 1])
      return;
    reached[column] = entry;
    behind[column] = waiting[row_[entry]];
    waiting[row_[entry]] = column;
  };
  for (std::uint32_t j = 0; j < n; ++j) {
    std::array<double, 6> size{};
    for (std::size_t r = 0; r < size.size(); ++r)
      size[r] = inverse_pivot_[j].at[r][r];
    work[j] = inverse_pivot_[j];
    for (std::uint32_t e = column_start_[j]; e < column_start_[j + 1]; ++e)
      work[row_[e]] = lower_[e];
    for (std::uint32_t k = waiting[j]; k != none;) {
      const std::uint32_t next = behind[k], entry = reached[k];
      at_vector_level([&](auto) __attribute__((always_inline)) {
        subtract_column(entry, column_start_[k + 1], row_.data(), lower_.data(), inverse_pivot_[k],
                        work.data());
      });
      wait(k, entry + 1);
      k = next;
    }
    inverse_pivot_[j] = pivot_inverse(work[j], size);
    for (std::uint32_t e = column_start_[j]; e < column_start_[j + 1]; ++e)
      lower_[e] = work[row_[e]];
    wait(j, column_start_[j]);
  }
  for (std::uint32_t k = 0; k < n; ++k)
    for (std::uint32_t e = column_start_[k]; e < column_start_[k + 1]; ++e)
      lower_[e] = stored(dense(lower_[e]) * dense(inverse_pivot_[k]));
}

void CoarseFactor::solve(Field<6>& x) const {
  Field<6> ordered(x.size());
  for (std::size_t k = 0; k < x.size(); ++k)
    ordered[place_[k]] = x[k];
  at_vector_level([&](auto) __attribute__((always_inline)) {
    substitute_coarse(ordered.size(), column_start_.data(), row_.data(), lower_.data(), inverse_pivot_.data(),
                      ordered.data());
  });
  for (std::size_t k = 0; k < x.size(); ++k)
    x[k] = ordered[place_[k]];
}

} // namespace granum::network

// SPDX-License-Identifier: GPL-3.0-or-later
#include "correction.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include <Eigen/Core>
#include <Eigen/OrderingMethods>
#include <Eigen/SparseCore>

#include <granum/core/stop.hpp>
#include <granum/elastic/stiffness.hpp>

#include "core/vector/level.hpp"

namespace granum::network {

namespace {

constexpr std::uint32_t none = ~std::uint32_t{0};
// Directions of a pivot below this fraction of its diagonal before the elimination are free: in soft clusters
// rounding reaches 1e-7.
constexpr double free_direction = 1e-6;

// Blocks subtracted from a column from which on threads share the work, and the number of parts.
constexpr std::size_t worth_sharing = 2000;
constexpr std::size_t parts_shared = 8;

using elastic::Matrix6;

Block<6> stored(const Matrix6& m) {
  Block<6> b;
  for (int r = 0; r < 6; ++r)
    for (int c = 0; c < 6; ++c)
      b.at[r][c] = m(r, c);
  return b;
}

/// Generalised inverse of a pivot; `size` is its diagonal before the elimination.
Block<6> pivot_inverse(const Block<6>& pivot, const std::array<double, 6>& size) {
  using SixNumbers = Eigen::Matrix<double, 6, 1>;
  SixNumbers scale;
  for (int r = 0; r < 6; ++r)
    scale[r] = size[static_cast<std::size_t>(r)] > 0 ? 1 / std::sqrt(size[static_cast<std::size_t>(r)]) : 0;
  const Matrix6 m = dense(pivot);
  const Matrix6 scaled = scale.asDiagonal() * ((m + m.transpose()) / 2) * scale.asDiagonal();
  const elastic::EigenSystem eigen = elastic::eigen_system(scaled);
  const SixNumbers inverse =
      eigen.values.unaryExpr([](double v) { return v > free_direction ? 1 / v : 0.0; });
  const Matrix6 turned = scale.asDiagonal() * eigen.vectors;
  return stored(turned * inverse.asDiagonal() * turned.transpose());
}

/// Subtracts the part of a finished column k from column row[e]: target -= U D^+ U_e^T for the blocks
/// U = L D of column k from `first` to `last`. Rows of the target are vectors of six numbers.
GRANUM_INLINE void subtract_column(std::uint32_t e, std::uint32_t first, std::uint32_t last,
                                   const std::uint32_t* row, const Block<6>* upper,
                                   const Block<6>& inverse_pivot, Rows<6>* target) {
  Rows<6> factor = {};
  for (int r = 0; r < 6; ++r)
    for (int k = 0; k < 6; ++k)
      for (int c = 0; c < 6; ++c)
        factor.row[r][c] += inverse_pivot.at[r][k] * upper[e].at[c][k];
  for (std::uint32_t f = first; f < last; ++f)
    for (int r = 0; r < 6; ++r)
      for (int k = 0; k < 6; ++k)
        target[row[f]].row[r] -= upper[f].at[r][k] * factor.row[k];
}

Rows<6> rows_of(const Block<6>& b) {
  Rows<6> rows;
  for (int r = 0; r < 6; ++r)
    for (int c = 0; c < 6; ++c)
      rows.row[r][c] = b.at[r][c];
  return rows;
}
Block<6> block_of(const Rows<6>& rows) {
  Block<6> b;
  for (int r = 0; r < 6; ++r)
    for (int c = 0; c < 6; ++c)
      b.at[r][c] = rows.row[r][c];
  return b;
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

/// Minimum degree, which keeps L sparse.
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

/// Subtracts finished columns, each from its entry in row j on, from the column j in `work`. Threads share
/// the rows.
void CoarseFactor::subtract_columns(std::uint32_t j, const std::vector<Reaching>& columns,
                                    const Workers& workers, std::vector<Rows<6>>& work) const {
  std::size_t blocks = 0;
  for (const auto& [k, entry] : columns)
    blocks += column_start_[k + 1] - entry;
  const std::uint32_t rows = column_start_[j + 1] - column_start_[j];
  const std::size_t parts = blocks < worth_sharing || rows < parts_shared ? 1 : parts_shared;
  const auto first_row = [&](std::size_t part) {
    if (part == 0)
      return j;
    return part == parts ? none : row_[column_start_[j] + static_cast<std::uint32_t>(rows * part / parts)];
  };
  workers.each(parts, [&](std::size_t part) {
    const auto entry_of = [&](std::uint32_t k, std::uint32_t entry, std::uint32_t row) {
      return static_cast<std::uint32_t>(
          std::lower_bound(row_.data() + entry, row_.data() + column_start_[k + 1], row) - row_.data());
    };
    const std::uint32_t from = first_row(part), to = first_row(part + 1);
    for (const Reaching& of : columns) {
      const std::uint32_t first = entry_of(of.column, of.entry, from), last = entry_of(of.column, first, to);
      at_vector_level([&](auto) __attribute__((always_inline)) {
        subtract_column(of.entry, first, last, row_.data(), lower_.data(), inverse_pivot_[of.column],
                        work.data());
      });
    }
  });
}

/// Column by column; a finished column is in the list of the row that it affects next.
void CoarseFactor::factorise(const Workers& workers) {
  const auto n = static_cast<std::uint32_t>(place_.size());
  std::vector<Rows<6>> work(n); // of one column
  std::vector<std::vector<Reaching>> waiting(n);
  const auto wait = [&](std::uint32_t column, std::uint32_t entry) {
    if (entry < column_start_[column + 1])
      waiting[row_[entry]].push_back({column, entry});
  };
  for (std::uint32_t j = 0; j < n; ++j) {
    stop_point();
    std::array<double, 6> size{};
    for (std::size_t r = 0; r < size.size(); ++r)
      size[r] = inverse_pivot_[j].at[r][r];
    work[j] = rows_of(inverse_pivot_[j]);
    for (std::uint32_t e = column_start_[j]; e < column_start_[j + 1]; ++e)
      work[row_[e]] = rows_of(lower_[e]);
    const std::vector<Reaching> columns = std::exchange(waiting[j], {});
    subtract_columns(j, columns, workers, work);
    for (const auto& [k, entry] : columns)
      wait(k, entry + 1);
    inverse_pivot_[j] = pivot_inverse(block_of(work[j]), size);
    for (std::uint32_t e = column_start_[j]; e < column_start_[j + 1]; ++e)
      lower_[e] = block_of(work[row_[e]]);
    wait(j, column_start_[j]);
  }
  workers.each(n, [&](std::size_t k) {
    stop_point(k);
    for (std::uint32_t e = column_start_[k]; e < column_start_[k + 1]; ++e)
      lower_[e] = stored(dense(lower_[e]) * dense(inverse_pivot_[k]));
  });
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

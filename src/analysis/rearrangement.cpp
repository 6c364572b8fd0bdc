// SPDX-License-Identifier: GPL-3.0-or-later
#include <granum/analysis/rearrangement.hpp>

#include <algorithm>
#include <cmath>
#include <string>

#include <Eigen/Core>
#include <granum/core/error.hpp>

#include "core/compiled_once.hpp"

namespace granum::analysis {

namespace {

using Eigen::Matrix3d;
using Eigen::Vector3d;

Vector3d column_of(const Vec3& v) { return {v.x, v.y, v.z}; }

/// Branches of a pair in two states.
struct Pair {
  std::size_t i, j;
  Vector3d before, after;
};

/// The branch after, through the same faces as before, but for those that a grain has crossed since.
std::vector<Pair> pairs_of(const packing::Assembly& before, const packing::Assembly& after,
                           std::span<const packing::Contact> neighbours,
                           const std::array<bool, 3>& periodic) {
  const Mat3 parts_before = inverse_of(before.cell), parts_after = inverse_of(after.cell);
  std::vector<Pair> out;
  out.reserve(neighbours.size());
  for (const packing::Contact& c : neighbours) {
    if (std::max(c.i, c.j) >= before.grain_count())
      throw InvalidArgument("neighbours " + std::to_string(c.i) + " and " + std::to_string(c.j) +
                            " are not both among the " + std::to_string(before.grain_count()) + " grains");
    Vec3 branch = after.position[c.j] - after.position[c.i];
    const Vec3 was = parts_before * c.branch, is = parts_after * branch;
    for (int k = 0; k < 3; ++k)
      if (periodic[static_cast<std::size_t>(k)])
        branch += std::round(was[k] - is[k]) * column(after.cell, k);
    out.push_back({c.i, c.j, column_of(c.branch), column_of(branch)});
  }
  return out;
}

/// X A^+ of a symmetric A >= 0, whose null directions, such as those across neighbours in a plane, count as
/// undeformed.
Matrix3d over(const Matrix3d& x, const Matrix3d& a) {
  constexpr double nothing = 1e-12;
  const SymmetricEigen<3> parts = symmetric_eigen<3>(a);
  Matrix3d inverse = Matrix3d::Zero();
  for (int k = 0; k < 3; ++k)
    if (parts.values[k] > nothing * parts.values[2])
      inverse += parts.vectors.col(k) * parts.vectors.col(k).transpose() / parts.values[k];
  return x * inverse;
}

} // namespace

std::vector<double> d2min(const packing::Assembly& before, const packing::Assembly& after,
                          std::span<const packing::Contact> neighbours, const std::array<bool, 3>& periodic) {
  require_valid(before);
  require_valid(after);
  const std::size_t grains = before.grain_count();
  if (after.grain_count() != grains)
    throw InvalidArgument("the states have " + std::to_string(grains) + " and " +
                          std::to_string(after.grain_count()) + " grains");
  const std::vector<Pair> pairs = pairs_of(before, after, neighbours, periodic);
  // A pair counts for both of its grains alike: b b^T and |b' - J b|^2 are even in b. The change b' - b is
  // fitted, not b', which rounding would make inaccurate where little moves.
  std::vector<Matrix3d> fit(grains, Matrix3d::Zero()), squares = fit;
  for (const Pair& p : pairs)
    for (const std::size_t g : {p.i, p.j}) {
      fit[g] += (p.after - p.before) * p.before.transpose();
      squares[g] += p.before * p.before.transpose();
    }
  for (std::size_t g = 0; g < grains; ++g)
    fit[g] = over(fit[g], squares[g]);
  std::vector<double> out(grains, 0.0);
  for (const Pair& p : pairs)
    for (const std::size_t g : {p.i, p.j})
      out[g] += (p.after - p.before - fit[g] * p.before).squaredNorm();
  return out;
}

} // namespace granum::analysis

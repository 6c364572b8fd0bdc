// SPDX-License-Identifier: GPL-3.0-or-later
// Private to src/dem. Notation: b branch from a grain over the radii that it spans, n its direction; k
// stiffness of a contact, r = k_t/k_n.
#pragma once

#include <cmath>

#include <granum/core/vec3.hpp>

namespace granum::dem {

/// Sum of k nn.
struct NormalSum {
  double xx = 0, yy = 0, zz = 0, xy = 0, xz = 0, yz = 0;

  /// \param    weight   k/|along|^2
  void add(double weight, const Vec3& along) {
    const double x = weight * along.x, y = weight * along.y, z = weight * along.z;
    xx += x * along.x;
    yy += y * along.y;
    zz += z * along.z;
    xy += x * along.y;
    xz += x * along.z;
    yz += y * along.z;
  }
  /// Adds a multiple of another sum.
  void add(double factor, const NormalSum& other) {
    xx += factor * other.xx, yy += factor * other.yy, zz += factor * other.zz;
    xy += factor * other.xy, xz += factor * other.xz, yz += factor * other.yz;
  }
  [[nodiscard]] double trace() const { return xx + yy + zz; }
  /// Largest possible distance of an eigenvalue from a third of the trace.
  [[nodiscard]] double spread() const {
    const double mean = trace() / 3, x = xx - mean, y = yy - mean, z = zz - mean;
    return std::sqrt(2.0 / 3 * (x * x + y * y + z * z + 2 * (xy * xy + xz * xz + yz * yz)));
  }
};

/// Sums over the contacts of a grain that have tangential stiffness.
struct StiffnessBlock {
  NormalSum sticking;
  Vec3 couple; ///< sum of k b, which couples rotation to translation

  void add(double stiffness, double per_squared, const Vec3& b) {
    sticking.add(stiffness * per_squared, b);
    couple += stiffness * b;
  }

  /// Upper bound of the largest eigenvalue: the sum of k_n nn + k_t (1 - nn) for translation, at most of k_t
  /// (1 - nn) for rotation (lengths in radii), and of k_t b x for their coupling [N/m]. If it cannot exceed
  /// `floor`, any number up to `floor`.
  /// \param    smooth   contacts without tangential stiffness
  [[nodiscard]] double largest(double r, const NormalSum& smooth, double floor) const {
    const double trace = sticking.trace(), spread = sticking.spread();
    NormalSum beyond = smooth;
    beyond.add(1 - r, sticking);
    const double moving = r * trace + beyond.trace() / 3 + beyond.spread();
    const double turning = r * (2.0 / 3 * trace + spread);
    const double mean = (moving + turning) / 2, half = (moving - turning) / 2, tie = r * norm(couple);
    constexpr double rounding = 1 - 1e-12;
    if (mean + std::abs(half) + tie < rounding * floor) // std::hypot takes as long as all the rest
      return 0;
    return mean + std::hypot(half, tie);
  }
};

} // namespace granum::dem

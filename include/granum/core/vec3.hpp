// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cmath>

/// Plain vectors and 3 x 3 matrices of the floors that stay free of Eigen. Aggregates of doubles, no units of
/// their own, no checks.
/// Checked by tests/core/test_vec3.cpp
namespace granum {

struct Vec3 {
  double x = 0, y = 0, z = 0;

  constexpr double operator[](int axis) const { return axis == 0 ? x : axis == 1 ? y : z; }
  constexpr double& operator[](int axis) { return axis == 0 ? x : axis == 1 ? y : z; }
  constexpr bool operator==(const Vec3&) const = default;

  constexpr Vec3& operator+=(const Vec3& b) {
    x += b.x, y += b.y, z += b.z;
    return *this;
  }
  constexpr Vec3& operator-=(const Vec3& b) {
    x -= b.x, y -= b.y, z -= b.z;
    return *this;
  }
  constexpr Vec3& operator*=(double s) {
    x *= s, y *= s, z *= s;
    return *this;
  }
};

constexpr Vec3 operator+(Vec3 a, const Vec3& b) { return a += b; }
constexpr Vec3 operator-(Vec3 a, const Vec3& b) { return a -= b; }
constexpr Vec3 operator-(const Vec3& a) { return {-a.x, -a.y, -a.z}; }
constexpr Vec3 operator*(double s, Vec3 a) { return a *= s; }
constexpr Vec3 operator*(Vec3 a, double s) { return a *= s; }

constexpr double dot(const Vec3& a, const Vec3& b) { return a.x * b.x + a.y * b.y + a.z * b.z; }
constexpr Vec3 cross(const Vec3& a, const Vec3& b) {
  return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}
inline double norm(const Vec3& a) { return std::sqrt(dot(a, a)); }

/// 3 x 3 matrix by rows: m(i, j) is row i, column j.
struct Mat3 {
  double m[3][3] = {{0, 0, 0}, {0, 0, 0}, {0, 0, 0}};

  constexpr double operator()(int i, int j) const { return m[i][j]; }
  constexpr double& operator()(int i, int j) { return m[i][j]; }
  constexpr bool operator==(const Mat3&) const = default;

  static constexpr Mat3 diagonal(double x, double y, double z) { return {{{x, 0, 0}, {0, y, 0}, {0, 0, z}}}; }
  static constexpr Mat3 identity() { return diagonal(1, 1, 1); }

  constexpr Mat3& operator+=(const Mat3& b) {
    for (int i = 0; i < 3; ++i)
      for (int j = 0; j < 3; ++j)
        m[i][j] += b.m[i][j];
    return *this;
  }
};

constexpr Mat3 operator+(Mat3 a, const Mat3& b) { return a += b; }

constexpr Mat3 operator*(double s, Mat3 a) {
  for (auto& row : a.m)
    for (double& value : row)
      value *= s;
  return a;
}

constexpr Vec3 operator*(const Mat3& a, const Vec3& v) {
  return {a(0, 0) * v.x + a(0, 1) * v.y + a(0, 2) * v.z, a(1, 0) * v.x + a(1, 1) * v.y + a(1, 2) * v.z,
          a(2, 0) * v.x + a(2, 1) * v.y + a(2, 2) * v.z};
}

constexpr Mat3 operator*(const Mat3& a, const Mat3& b) {
  Mat3 c;
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j < 3; ++j)
      c(i, j) = a(i, 0) * b(0, j) + a(i, 1) * b(1, j) + a(i, 2) * b(2, j);
  return c;
}

/// a b^T
constexpr Mat3 outer(const Vec3& a, const Vec3& b) {
  Mat3 c;
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j < 3; ++j)
      c(i, j) = a[i] * b[j];
  return c;
}

constexpr Mat3 transpose(const Mat3& a) {
  Mat3 t;
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j < 3; ++j)
      t(i, j) = a(j, i);
  return t;
}

constexpr double trace(const Mat3& a) { return a(0, 0) + a(1, 1) + a(2, 2); }

constexpr Vec3 column(const Mat3& a, int j) { return {a(0, j), a(1, j), a(2, j)}; }

constexpr double determinant(const Mat3& a) { return dot(column(a, 0), cross(column(a, 1), column(a, 2))); }

/// Inverse by cofactors; the caller guarantees a determinant other than zero.
constexpr Mat3 inverse_of(const Mat3& a) {
  const Vec3 u = column(a, 0), v = column(a, 1), w = column(a, 2);
  const Vec3 rows[3] = {cross(v, w), cross(w, u), cross(u, v)};
  const double d = dot(u, rows[0]);
  Mat3 inv;
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j < 3; ++j)
      inv(i, j) = rows[i][j] / d;
  return inv;
}

} // namespace granum

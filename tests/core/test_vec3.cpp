// SPDX-License-Identifier: GPL-3.0-or-later
#include <granum/core/vec3.hpp>

#include "unit.hpp"

TEST_CASE("vector and matrix identities") {
  const Vec3 a{1, -2, 3}, b{0.5, 4, -1};
  CHECK(dot(cross(a, b), a) == 0);
  CHECK(trace(outer(a, b)) == dot(a, b));
  CHECK(outer(a, b) * b == dot(b, b) * a);
  const Mat3 m{{{2, 1, 0}, {0.5, 3, 1}, {1, 0, 4}}};
  const Mat3 one = m * inverse_of(m);
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j < 3; ++j)
      CHECK(one(i, j) == doctest::Approx(i == j ? 1.0 : 0.0).epsilon(1e-15));
  CHECK(determinant(m) == doctest::Approx(2 * (12 - 0) - 1 * (2 - 1)).epsilon(1e-15));
  CHECK(transpose(transpose(m)) == m);
  CHECK(dot(a, m * b) == doctest::Approx(dot(transpose(m) * a, b)).epsilon(1e-15));
}

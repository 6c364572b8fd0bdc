// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/root.hpp"

#include "unit.hpp"

TEST_CASE("root: intervals contain the root and are as narrow as asked, within the calls allowed") {
  std::size_t calls = 0;
  const auto cosine = [&](double x) {
    ++calls;
    return std::cos(x);
  };
  const double root = std::acos(0.0);
  const auto [low, high] = root_between(cosine, 0, 3, within_bits(40));
  CHECK(low <= root);
  CHECK(high >= root);
  CHECK(high - low <= std::ldexp(root, -38));
  CHECK(middle({low, high}) == doctest::Approx(root).epsilon(1e-12));
  calls = 0;
  const RootInterval wide = root_between(cosine, 0, 3, within_bits(50), 3);
  CHECK(calls <= 5); // both ends, and three within
  CHECK(wide.second - wide.first > 1e-6);
  for (const double x : {1e-6, 1.0, 1e6}) // the share is of the upper end
    CHECK((within_share(0.1)(0.901 * x, x) && !within_share(0.1)(0.899 * x, x)));
}

TEST_CASE("root: an exact root is both ends") {
  const RootInterval at = root_between([](double x) { return x - 2; }, 0, 4, within_bits(52));
  CHECK(at.first == 2);
  CHECK(at.second == 2);
}

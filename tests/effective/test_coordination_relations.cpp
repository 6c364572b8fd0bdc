// SPDX-License-Identifier: GPL-3.0-or-later
#include <granum/effective/coordination_relations.hpp>

#include <doctest/doctest.h>

#include <cmath>

#include <granum/core/error.hpp>

#include "relative.hpp"

using namespace granum;
using namespace granum::effective;
using enum CoordinationRelation;

TEST_CASE("coordination relations: rows of the table, and between them") {
  CHECK(coordination_number(murphy_table, 0.2) == relative(14.007, 1e-15));
  CHECK(coordination_number(murphy_table, 0.4) == relative(8.3147, 1e-14));
  CHECK(coordination_number(murphy_table, 0.7) == relative(3.7440, 1e-14));
  CHECK(coordination_number(murphy_table, 0.425) == relative((8.3147 + 7.2517) / 2, 1e-14));
}

TEST_CASE("coordination relations: formulas at printed points, and near the table") {
  CHECK(coordination_number(murphy_quadratic, 0.36) == relative(20 - 34 * 0.36 + 14 * 0.36 * 0.36, 1e-15));
  CHECK(coordination_number(garcia_medina, 0.384) == 4.46);
  CHECK(coordination_number(garcia_medina, 0.36) ==
        relative(4.46 + 9.7 * std::exp(0.48 * std::log(0.024)), 1e-14));
  for (double n = 0.2; n < 0.6; n += 0.01) // the quadratic follows the table within 0.6
    CHECK(std::abs(coordination_number(murphy_quadratic, n) - coordination_number(murphy_table, n)) < 0.6);
  CHECK(coordination_number_at_pressure(0) == 6);
  CHECK(coordination_number_at_pressure(0.06e6 * 8) == relative(8, 1e-15));
}

TEST_CASE("coordination relations: fall with porosity over their whole range, and are refused beyond it") {
  for (const CoordinationRelation relation : {murphy_table, murphy_quadratic, garcia_medina}) {
    const auto [low, high] = range(relation);
    double last = 1e9;
    for (int k = 0; k <= 1000; ++k) {
      const double C = coordination_number(relation, std::min(high, low + (high - low) * k / 1000));
      CHECK(C < last);
      last = C;
    }
    CHECK_THROWS_AS((void)coordination_number(relation, low - 1e-6), InvalidArgument);
    CHECK_THROWS_AS((void)coordination_number(relation, high + 1e-6), InvalidArgument);
    CHECK_THROWS_AS((void)coordination_number(relation, std::nan("")), InvalidArgument);
  }
  CHECK_THROWS_WITH_AS((void)coordination_number(murphy_table, 0.1),
                       "porosity = 0.1 is outside [0.2, 0.7], the range of the relation murphy-table",
                       InvalidArgument);
  CHECK_THROWS_AS((void)coordination_number_at_pressure(-1), InvalidArgument);
}

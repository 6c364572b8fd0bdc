// SPDX-License-Identifier: GPL-3.0-or-later
#include <granum/core/check.hpp>

#include <limits>
#include <string>

#include <doctest/doctest.h>
#include <granum/core/error.hpp>

using namespace granum;

TEST_CASE("a rejected value is named with its unit and range") {
  try {
    require_positive("radius", -0.5, "m");
    FAIL("no exception");
  } catch (const InvalidArgument& error) {
    CHECK(std::string(error.what()) == "radius = -0.5 m is outside (0, inf)");
  }
  try {
    require_open("porosity", 38, 0, 1);
    FAIL("no exception");
  } catch (const InvalidArgument& error) {
    CHECK(std::string(error.what()) == "porosity = 38 is outside (0, 1)");
  }
}

TEST_CASE("a refused number can be read off its exception, and a text that is none has none") {
  try {
    require_closed("stress_v", 2e300, 0, 1e200, "Pa");
    FAIL("no exception");
  } catch (const InvalidArgument& error) {
    REQUIRE(error.refused());
    CHECK(error.refused()->name == "stress_v");
    CHECK(error.refused()->value == 2e300);
    CHECK(error.refused()->unit == "Pa");
    CHECK(error.refused()->range == "[0, 1e+200]");
  }
  CHECK_FALSE(InvalidArgument("two masses").refused());
}

TEST_CASE("a file error contains its path and its line") {
  const FileError error("a.csv", 3, "expected a number");
  CHECK(error.path() == "a.csv");
  CHECK(error.line() == 3);
  CHECK(FileError("a.csv", 0, "no such file").line() == 0);
}

TEST_CASE("checks pass their value on and stop NaN and infinity") {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const double inf = std::numeric_limits<double>::infinity();
  CHECK(require_positive("x", 2.5) == 2.5);
  CHECK(require_non_negative("x", 0) == 0);
  CHECK(require_closed("x", 1, 0, 1) == 1);
  CHECK(require_poisson_ratio("nu", 0.5) == 0.5);
  CHECK_THROWS_AS(require_positive("x", 0), InvalidArgument);
  CHECK_THROWS_AS(require_positive("x", inf), InvalidArgument);
  CHECK_THROWS_AS(require_non_negative("x", nan), InvalidArgument);
  CHECK_THROWS_AS(require_finite("x", nan), InvalidArgument);
  CHECK_THROWS_AS(require_closed("x", nan, 0, 1), InvalidArgument);
  CHECK_THROWS_AS(require_open("x", 1, 0, 1), InvalidArgument);
  CHECK_THROWS_AS(require_poisson_ratio("nu", -1), InvalidArgument);
  CHECK_THROWS_AS(require_poisson_ratio("nu", 0.6), InvalidArgument);
}

TEST_CASE("a file error begins with path and line") {
  CHECK(std::string(FileError("a.csv", 3, "expected a number").what()) == "a.csv:3: expected a number");
  CHECK(std::string(FileError("a.csv", 0, "no such file").what()) == "a.csv: no such file");
}

// SPDX-License-Identifier: GPL-3.0-or-later
#include <granum/core/error.hpp>

#include <Eigen/Core>

#include "refusal_text.hpp"
#include "unit.hpp"

TEST_CASE("a rejected value is named with its unit and range, also as data") {
  try {
    require_closed("stress_v", 2e300, 0, 1e200, "Pa");
    FAIL("no exception");
  } catch (const InvalidArgument& error) {
    const std::string text = error.what();
    CHECK(text.find("stress_v = 2e+300 Pa") != std::string::npos);
    REQUIRE(error.refused());
    CHECK(error.refused()->name == "stress_v");
    CHECK(error.refused()->value == 2e300);
    CHECK(error.refused()->unit == "Pa");
    CHECK(error.refused()->range == "[0, 1e+200]");
    CHECK(text.find(error.refused()->range) != std::string::npos);
  }
  CHECK_FALSE(InvalidArgument("two masses").refused());
}

TEST_CASE("a range contains what lies between its ends, closed or open, with a unit or a reason behind it") {
  using detail::contains;
  constexpr double inf = std::numeric_limits<double>::infinity();
  CHECK((contains("[0, 1]", 0) && contains("[0, 1]", 1) && contains("(0, 1)", 0.5)));
  CHECK_FALSE(
      (contains("(0, 1)", 0) || contains("(0, 1)", 1) || contains("[0, 1)", 1) || contains("[0, 1]", 2)));
  CHECK((contains("(-inf, inf)", -1e300) && contains("[0, inf): compression is positive", 5)));
  CHECK_FALSE(contains("[0, inf)", inf));
  CHECK((contains("(0, 0.5 m], the width", 0.5) && contains("[-7.5, 1e+06)", -7.5)));
  CHECK_FALSE(contains("[0, 1]", std::numeric_limits<double>::quiet_NaN()));
  for (const char* words : {"", "[", "[0", "[0, half of the box)", "above 1", "{0}", "[0, 1"})
    CHECK_FALSE(contains(words, 0.5));
}

TEST_CASE("no refusal prints a value that is within the range it prints") {
  int refused = 0;
  for (const double low : {-5.0, 0.0, 1e-6, 1 + 1e-6, 2.0 / 3, 1e5 + 1.0 / 3})
    for (const double high : {low + 1e-9, low + 5.0 / 3, 1e6, 1e14 + 0.5})
      for (const double end : {low, high})
        for (const double value : around(end))
          for (const auto check : {require_closed, require_open})
            try {
              CHECK(check("x", value, low, high, "m") == value);
            } catch (const InvalidArgument& error) {
              CAPTURE(error.what());
              const std::string_view text = error.what();
              const auto printed = leading_number(text.substr(text.find("x = ") + 4));
              CHECK_FALSE(detail::contains(error.refused().value().range, printed.value().value));
              ++refused;
            }
  CHECK(refused > 500);
}

TEST_CASE("a NUL in a text does not end the message, and a file error has its path and line") {
  const std::string name("two\0words\0", 10);
  CHECK(std::string(InvalidArgument("'" + name + "'").what()) == "'two\\x00words\\x00'");
  CHECK(std::string(FileError(name, 2, "no").what()) == "two\\x00words\\x00:2: no");
  CHECK(std::string(InvalidArgument(name, 1, "", "[2, 3]").what()).ends_with("[2, 3]"));
  const FileError error("a.csv", 3, "expected a number");
  CHECK(error.path() == "a.csv");
  CHECK(error.line() == 3);
}

TEST_CASE("a symmetric matrix may be off by a thousandth of its largest entry, and the pair that is worst is "
          "named") {
  const auto named = [](double off, int row, int column, double scale = 1) {
    Eigen::Matrix3d matrix = Eigen::Matrix3d::Constant(-2 * scale);
    matrix(row, column) += off * 2 * scale;
    matrix(2, 0) += 1e-5 * scale;
    try {
      require_symmetric<3>("D", matrix);
    } catch (const InvalidArgument& error) {
      return std::string(error.what());
    }
    return std::string();
  };
  for (const double scale : {1e-9, 1.0, 1e9})
    for (const auto& [row, column] : {std::pair(1, 0), {0, 1}, {2, 1}}) {
      CHECK(named(0.000999, row, column, scale).empty());
      const std::string pair =
          std::to_string(std::max(row, column) + 1) + std::to_string(std::min(row, column) + 1);
      CHECK(named(0.001001, row, column, scale).find("entries " + pair) != std::string::npos);
    }
}

TEST_CASE("checks pass their value on and stop NaN and infinity") {
  constexpr double nan = std::numeric_limits<double>::quiet_NaN(),
                   inf = std::numeric_limits<double>::infinity();
  CHECK(require_positive("x", 2.5) == 2.5);
  CHECK(require_non_negative("x", 0) == 0);
  CHECK(require_poisson_ratio("nu", 0.5) == 0.5);
  CHECK_THROWS_AS(require_positive("x", 0), InvalidArgument);
  CHECK_THROWS_AS(require_open("x", 1, 0, 1), InvalidArgument);
  for (const double bad : {nan, inf, -inf}) {
    CHECK_THROWS_AS(require_positive("x", bad), InvalidArgument);
    CHECK_THROWS_AS(require_non_negative("x", bad), InvalidArgument);
    CHECK_THROWS_AS(require_finite("x", bad), InvalidArgument);
    CHECK_THROWS_AS(require_closed("x", bad, 0, 1), InvalidArgument);
  }
  for (const double bad : {-1.0, 0.6, nan})
    CHECK_THROWS_AS(require_poisson_ratio("nu", bad), InvalidArgument);
}

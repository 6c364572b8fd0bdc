// SPDX-License-Identifier: GPL-3.0-or-later
#include <granum/core/text.hpp>

#include <bit>
#include <random>

#include "unit.hpp"

TEST_CASE("a number is all of the text or nothing") {
  CHECK(parse_number("-1.5e3") == -1500);
  CHECK(parse_number(" \t+2\r") == 2);
  CHECK(parse_number(".5") == 0.5);
  for (const char* text :
       {"", " ", "+", "+-2", "--2", "1,5", "1.5x", "1 2", "0x10", "nan", "inf", "-inf", "1e999", "e5"}) {
    CAPTURE(text);
    CHECK_FALSE(parse_number(text).has_value());
  }
}

TEST_CASE("the rest of a leading number begins where the number ends") {
  CHECK(leading_number("100kPa")->rest == "kPa");
  CHECK(leading_number("1e5Pa")->value == 1e5);
  CHECK(leading_number("5e")->rest == "e");
  CHECK_FALSE(leading_number("kPa").has_value());
}

TEST_CASE("17 digits give the same bits back") {
  std::mt19937_64 bits(7);
  for (int k = 0; k < 10000; ++k) {
    const double value = std::bit_cast<double>(bits());
    if (value - value == 0)
      REQUIRE(std::bit_cast<std::uint64_t>(*parse_number(exact_text(value))) ==
              std::bit_cast<std::uint64_t>(value));
  }
  for (const double value :
       {0.0, -0.0, 0.1, std::numeric_limits<double>::denorm_min(), std::numeric_limits<double>::max()})
    CHECK(parse_number(exact_text(value)) == value);
  // Digits alone from 0.0001 to 10^16, powers of ten outside of it.
  CHECK((exact_text(0.0) == "0" && exact_text(-1e-4) == "-0.0001"));
  CHECK(exact_text(9e15) == "9000000000000000");
  for (const double value : {9e-5, 1e16})
    CHECK(exact_text(value).find('e') != std::string::npos);
}

TEST_CASE("short text keeps four digits, and shares are per cent") {
  CHECK(short_text(1234.56) == "1235");
  CHECK(short_text(0.000123456) == "0.0001235");
  CHECK(short_text(0) == "0");
  CHECK(percent_text(0.02666) == "2.7 %");
  CHECK(percent_text(1.141) == "114 %");
  CHECK(percent_text(-0.05) == "-5 %");
}

// SPDX-License-Identifier: GPL-3.0-or-later
#include <granum/core/units.hpp>

#include <numbers>
#include <string>

#include <doctest/doctest.h>
#include <granum/core/error.hpp>
#include <relative.hpp>

using namespace granum;

namespace {

/// The message with which the text is refused; empty if it is taken.
std::string refusal(std::string_view text, Dimension dimension) {
  try {
    (void)parse_quantity("--x", text, dimension);
  } catch (const InvalidArgument& error) {
    return error.what();
  }
  return "";
}

} // namespace

TEST_CASE("quantities come in as SI") {
  const double ulp = 3e-16; // one product
  CHECK(parse_quantity("p", "100kPa", Dimension::pressure) == 1e5);
  CHECK(parse_quantity("G", "30GPa", Dimension::pressure) == 30e9);
  CHECK(parse_quantity("G", "1e5Pa", Dimension::pressure) == 1e5);
  CHECK(parse_quantity("p", "-5 MPa", Dimension::pressure) == -5e6);
  CHECK(parse_quantity("R", " 0.5mm ", Dimension::length) == relative(0.5e-3, ulp));
  CHECK(parse_quantity("a", "5.7um", Dimension::length) == relative(5.7e-6, ulp));
  CHECK(parse_quantity("phi", "26.5deg", Dimension::angle) == relative(26.5 * std::numbers::pi / 180, ulp));
  CHECK(parse_quantity("rho", "2650kg/m3", Dimension::density) == 2650);
  CHECK(parse_quantity("rho", "2.65g/cm3", Dimension::density) == 2650);
  CHECK(parse_quantity("t", "20us", Dimension::time) == relative(20e-6, ulp));
  CHECK(parse_quantity("f", "3mN", Dimension::force) == relative(3e-3, ulp));
  CHECK(parse_quantity("v", "0.25km/s", Dimension::speed) == 250);
  CHECK(parse_quantity("e", "0.6", Dimension::dimensionless) == 0.6);
  CHECK(parse_quantity("n", "38%", Dimension::dimensionless) == relative(0.38, ulp));
}

TEST_CASE("a bare number for a dimensional input is refused with a hint") {
  CHECK(refusal("100", Dimension::pressure) == "--x = 100 has no unit; write 100Pa, 100kPa, 100MPa, 100GPa");
  CHECK(refusal("26.5", Dimension::angle) == "--x = 26.5 has no unit; write 26.5rad, 26.5deg");
  CHECK(refusal("0", Dimension::length) != "");
}

TEST_CASE("each wrong text has its own message, and every one names the argument") {
  CHECK(refusal("100kpa", Dimension::pressure) ==
        "--x = '100kpa' has the unknown unit 'kpa'; did you mean kPa?");
  CHECK(refusal("3psi", Dimension::pressure) ==
        "--x = '3psi' has the unknown unit 'psi'; known for a pressure: Pa, kPa, MPa, GPa");
  CHECK(refusal("5mm", Dimension::pressure) == "--x = '5mm' must be a pressure, not a length");
  CHECK(refusal("0.6kPa", Dimension::dimensionless) ==
        "--x = '0.6kPa' must be a pure number, not a pressure");
  CHECK(refusal("5%", Dimension::length) == "--x = '5%' must be a length, not a pure number");
  CHECK(refusal("1e308GPa", Dimension::pressure) == "--x = '1e308GPa' is too large");
  for (const char* text : {"", "kPa", "nan", "inf", "infkPa", "nanPa", "1e999Pa", "ten kPa"}) {
    CAPTURE(text);
    CHECK(refusal(text, Dimension::pressure).find("must begin with a finite number") != std::string::npos);
  }
  for (const char* text : {"100kPa x", "1,5kPa", "100 k Pa", "100kPa2", "1 2Pa"}) {
    CAPTURE(text);
    CHECK(refusal(text, Dimension::pressure).find("unknown unit") != std::string::npos);
  }
}

TEST_CASE("column headings carry their unit") {
  CHECK(is_column_of("sigma_v_kPa", "sigma_v"));
  CHECK(is_column_of("e", "e"));
  CHECK(is_column_of("G_mm", "G"));
  CHECK(is_column_of("V_s_m/s", "V_s"));
  CHECK_FALSE(is_column_of("V_s_hh_m/s", "V_s"));
  CHECK_FALSE(is_column_of("sigma_v_kPa", "sigma"));
  CHECK_FALSE(is_column_of("sigma_", "sigma"));
  CHECK_FALSE(is_column_of("Ge_kPa", "G"));
  CHECK(column_factor("sigma_v_kPa", "sigma_v", Dimension::pressure) == 1e3);
  CHECK(column_factor("G_MPa", "G", Dimension::pressure) == 1e6);
  CHECK(column_factor("e", "e", Dimension::dimensionless) == 1);
  CHECK_THROWS_WITH_AS((void)column_factor("G", "G", Dimension::pressure),
                       "column 'G' has no unit; name it G_Pa, G_kPa, G_MPa, G_GPa", InvalidArgument);
  CHECK_THROWS_AS((void)column_factor("G_mm", "G", Dimension::pressure), InvalidArgument);
  CHECK_THROWS_AS((void)column_factor("e_mm", "e", Dimension::dimensionless), InvalidArgument);
}

TEST_CASE("tables show the fitting prefix") {
  CHECK(pretty(3.66e7, Dimension::pressure) == "36.6 MPa");
  CHECK(pretty(1e5, Dimension::pressure) == "100 kPa");
  CHECK(pretty(999.96e3, Dimension::pressure) == "1 MPa");
  CHECK(pretty(-2.5e3, Dimension::pressure) == "-2.5 kPa");
  CHECK(pretty(0, Dimension::pressure) == "0 Pa");
  CHECK(pretty(0.25, Dimension::pressure) == "0.25 Pa");
  CHECK(pretty(5e-4, Dimension::length) == "500 um");
  CHECK(pretty(0.02, Dimension::length) == "20 mm");
  CHECK(pretty(26.5 * std::numbers::pi / 180, Dimension::angle) == "26.5 deg");
  CHECK(pretty(2650, Dimension::density) == "2650 kg/m3");
  CHECK(pretty(1587.25, Dimension::speed) == "1587 m/s");
  CHECK(pretty(0.123456, Dimension::dimensionless) == "0.1235");
}

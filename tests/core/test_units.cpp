// SPDX-License-Identifier: GPL-3.0-or-later
#include <granum/core/units.hpp>

#include "unit.hpp"

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

TEST_CASE("quantities come in as SI, in units that engineers write by their definitions") {
  const struct {
    const char* text;
    Dimension dimension;
    double value; ///< SI
  } all[] = {
      {"1e5Pa", Dimension::pressure, 1e5},
      {"30GPa", Dimension::pressure, 30e9},
      {"-5 MPa", Dimension::pressure, -5e6},
      {" 0.5mm ", Dimension::length, 0.5e-3},
      {"5.7um", Dimension::length, 5.7e-6},
      {"26.5deg", Dimension::angle, 26.5 * std::numbers::pi / 180},
      {"2650kg/m3", Dimension::density, 2650},
      {"20us", Dimension::time, 20e-6},
      {"3ms", Dimension::time, 3e-3},
      {"7ns", Dimension::time, 7e-9},
      {"3mN", Dimension::force, 3e-3},
      {"0.25km/s", Dimension::speed, 250},
      {"0.6", Dimension::dimensionless, 0.6},
      {"38%", Dimension::dimensionless, 0.38},
      {"1kN/m2", Dimension::pressure, 1e3},
      {"1kN/m\u00b2", Dimension::pressure, 1e3},
      {"1bar", Dimension::pressure, 1e5},
      // 0.45359237 kg times 9.80665 m/s2 over 0.0254 m squared, and 144 square inches in a square foot
      {"1psi", Dimension::pressure, 6894.757293168362},
      {"1ksi", Dimension::pressure, 6894757.293168362},
      {"144 psf", Dimension::pressure, 6894.757293168362},
      {"144ksf", Dimension::pressure, 6894757.293168362},
      {"72tsf", Dimension::pressure, 6894757.293168362},
      {"1kgf/cm2", Dimension::pressure, 98066.5},
      {"1t/m2", Dimension::pressure, 9806.65},
      {"2.65t/m3", Dimension::density, 2650},
      {"2.65 g/cm\u00b3", Dimension::density, 2650},
      {"100lb/ft3", Dimension::density, 1601.846337396014},
      {"18kN/m^3", Dimension::unit_weight, 18e3},
      {"100lbf/ft3", Dimension::unit_weight, 15708.746384624621},
      {"5\u00b5m", Dimension::length, 5e-6},
      {"10ft", Dimension::length, 3.048},
      {"1in", Dimension::length, 0.0254},
      {"30\u00b0", Dimension::angle, std::numbers::pi / 6},
      {"1000ft/s", Dimension::speed, 304.8},
  };
  for (const auto& row : all) {
    CAPTURE(row.text);
    CHECK(parse_quantity("x", row.text, row.dimension) == relative(row.value, 2e-15));
  }
  // a density and a unit weight stand for each other
  CHECK(parse_quantity("x", "2t/m3", Dimension::unit_weight) == relative(2000 * 9.80665, 1e-15));
  CHECK(parse_quantity("x", "120pcf", Dimension::unit_weight) == relative(1.2 * 15708.746384624621, 2e-15));
  CHECK(parse_quantity("x", "26kN/m3", Dimension::density) == relative(26e3 / 9.80665, 1e-15));
  CHECK(refusal("18kPa", Dimension::unit_weight) != "");
}

TEST_CASE("a prefix of the SI in front of a unit is its power of ten") {
  const std::pair<const char*, double> prefixes[] = {
      {"n", 1e-9}, {"u", 1e-6}, {"\u00b5", 1e-6}, {"\u03bc", 1e-6}, {"m", 1e-3},
      {"c", 1e-2}, {"h", 1e2},  {"k", 1e3},       {"M", 1e6},       {"G", 1e9}};
  const std::pair<const char*, double> units[] = {{"Pa", 1},      {"bar", 1e5},  {"N", 1}, {"N/m2", 1},
                                                  {"N/mm2", 1e6}, {"m", 1},      {"s", 1}, {"m/s", 1},
                                                  {"N/m3", 1},    {"g/m3", 1e-3}};
  int found = 0;
  for (const auto& [prefix, power] : prefixes)
    for (const auto& [symbol, factor] : units)
      if (const std::optional<Unit> unit = find_unit(std::string(prefix) + symbol)) {
        CAPTURE(unit->symbol);
        CHECK(unit->factor == doctest::Approx(power * factor).epsilon(1e-14).scale(0));
        ++found;
      }
  CHECK(found > 30);
}

TEST_CASE("large and small letters do not matter where they cannot mislead") {
  for (const char* text : {"100kpa", "100KPA", "100 KPa", "0.1mpa"})
    CHECK(parse_quantity("p", text, Dimension::pressure) == 1e5);
  CHECK(parse_quantity("p", "14.5 PSI", Dimension::pressure) == relative(14.5 * 6894.757293168362, 2e-15));
  CHECK(refusal("1mPa", Dimension::pressure).find("MPa") != std::string::npos); // which was meant
  CHECK(refusal("1mn", Dimension::force) != "");                                // mN or MN?
  CHECK_FALSE(find_unit("Mm"));
}

TEST_CASE("each text that is no quantity is refused by the name of the argument, with what would be one") {
  const struct {
    const char* text;
    Dimension dimension;
    std::vector<const char*> hints;
  } all[] = {{"0,6", Dimension::dimensionless, {"0.6"}}, // a decimal comma
             {"1,5kPa", Dimension::pressure, {" 1.5kPa"}},
             {"1,500 kPa", Dimension::pressure, {"1.500 kPa", "1500 kPa"}},
             {"1,000,000Pa", Dimension::pressure, {" 1000000Pa"}}, // one meaning
             {"0.6,0.7", Dimension::pressure, {}},                 // several
             {"50kPa,100kPa", Dimension::pressure, {}},
             {"50, 100", Dimension::pressure, {"several"}},
             {"10kPa..1MPa", Dimension::pressure, {}},
             {"1;2", Dimension::pressure, {}},
             {"100", Dimension::pressure, {"100Pa", "100kPa", "100MPa", "100GPa"}}, // no unit
             {"26.5", Dimension::angle, {"26.5rad", "26.5deg"}},
             {"0", Dimension::length, {}},
             {"3torr", Dimension::pressure, {"torr", "kPa", "kN/m2", "psi", "ksf"}}, // units that are read
             {"3km", Dimension::length, {"km", "mm", "in,", "ft"}},
             {"5mm", Dimension::pressure, {}}, // of something else
             {"0.6kPa", Dimension::dimensionless, {}},
             {"5%", Dimension::length, {}},
             {"1e308GPa", Dimension::pressure, {}}};
  for (const auto& row : all) {
    CAPTURE(row.text);
    const std::string said = refusal(row.text, row.dimension);
    CHECK(said.find("--x") != std::string::npos);
    CHECK(said.find(row.text) != std::string::npos);
    for (const char* hint : row.hints)
      CHECK_MESSAGE(said.find(hint) != std::string::npos, hint);
  }
  for (const char* text : {"", "kPa", "nan", "inf", "infkPa", "nanPa", "1e999Pa", "ten kPa", "100kPa x",
                           "1,kPa", "100 k Pa", "100kPa2", "1 2Pa"})
    CHECK_MESSAGE(refusal(text, Dimension::pressure).find("--x") != std::string::npos, text);
}

TEST_CASE("column headings carry their unit") {
  const struct {
    const char *heading, *name;
    Dimension dimension;
    double factor;
  } columns[] = {{"sigma_v_kPa", "sigma_v", Dimension::pressure, 1e3},
                 {"G_MPa", "G", Dimension::pressure, 1e6},
                 {"V_s_m/s", "V_s", Dimension::speed, 1},
                 {"e", "e", Dimension::dimensionless, 1},
                 {"e (-)", "e", Dimension::dimensionless, 1},
                 {"e [-]", "e", Dimension::dimensionless, 1},
                 {"n (%)", "n", Dimension::dimensionless, 0.01},
                 {"p (kPa)", "p", Dimension::pressure, 1e3},
                 {"p_(kPa)", "p", Dimension::pressure, 1e3},
                 {"p kPa", "p", Dimension::pressure, 1e3},
                 {"p_kpa", "p", Dimension::pressure, 1e3},
                 {"p [kN/m\u00b2]", "p", Dimension::pressure, 1e3}};
  for (const auto& column : columns) {
    CAPTURE(column.heading);
    CHECK(is_column_of(column.heading, column.name));
    CHECK(column_factor(column.heading, column.name, column.dimension) == column.factor);
  }
  CHECK(is_column_of("G_mm", "G"));
  for (const auto& [heading, name] : {std::pair("p (test 3)", "p"),
                                      {"p kPa kPa", "p"},
                                      {"pkPa", "p"},
                                      {"p (kPa]", "p"},
                                      {"V_s_hh_m/s", "V_s"},
                                      {"sigma_v_kPa", "sigma"},
                                      {"sigma_", "sigma"},
                                      {"Ge_kPa", "G"}})
    CHECK_FALSE(is_column_of(heading, name));
  for (const auto& [heading, dimension] : {std::pair("G", Dimension::pressure),
                                           {"G_mm", Dimension::pressure},
                                           {"G_mm", Dimension::dimensionless}})
    CHECK_THROWS_AS((void)column_factor(heading, "G", dimension), InvalidArgument);
}

TEST_CASE("tables show the fitting prefix") {
  const struct {
    double value;
    Dimension dimension;
    const char* text;
  } all[] = {{3.66e7, Dimension::pressure, "36.6 MPa"},
             {999.96e3, Dimension::pressure, "1 MPa"},
             {-2.5e3, Dimension::pressure, "-2.5 kPa"},
             {0, Dimension::pressure, "0 Pa"},
             {0.25, Dimension::pressure, "0.25 Pa"},
             {5e-4, Dimension::length, "500 um"},
             {26.5 * std::numbers::pi / 180, Dimension::angle, "26.5 deg"},
             {1587.25, Dimension::speed, "1587 m/s"},
             {0.123456, Dimension::dimensionless, "0.1235"}};
  for (const auto& row : all)
    CHECK(pretty(row.value, row.dimension) == row.text);
}

TEST_CASE("primes and the Greek letter in headings are those of the quantity") {
  for (const char* heading : {"sigma'v (kPa)", "\u03c3\u2032v [kPa]", "\u03c3\u2019v_kPa", "\u03c3'v kPa"}) {
    CAPTURE(heading);
    CHECK(is_column_of(heading, "sigma'v"));
    CHECK_FALSE(is_column_of(heading, "sigma'h"));
    CHECK(column_factor(heading, "sigma'v", Dimension::pressure) == 1e3);
  }
  CHECK(is_column_of("p\u2032_kPa", "p'"));
  CHECK_FALSE(is_column_of("p\u2032_kPa", "p"));
  CHECK_FALSE(is_column_of("\u03c3", "sigma_v"));
}

TEST_CASE("headings: words are read however they are spelt, symbols are not") {
  for (const char* heading : {"mean_effective_stress_kPa", "Mean Effective Stress (kPa)",
                              "MEAN EFFECTIVE STRESS [kPa]", "mean-effective-stress kPa"}) {
    CHECK(is_column_of(heading, "mean_effective_stress"));
    CHECK(column_factor(heading, "mean_effective_stress", Dimension::pressure) == 1e3);
  }
  CHECK_FALSE(is_column_of("Mean Effective Stress Ratio", "mean_effective_stress"));
  CHECK(is_column_of("Depth (m)", "depth")); // a word has five letters
  CHECK_FALSE(is_column_of("Area", "area"));
  CHECK_FALSE(is_column_of("g_MPa", "G"));
  CHECK_FALSE(is_column_of("s_r", "S_r"));
  CHECK(column_factor("strain_percent", "strain", Dimension::dimensionless) == 0.01);
}

// SPDX-License-Identifier: GPL-3.0-or-later
#include "studies/trade/trade_findings.hpp"

#include <granum/core/text.hpp>
#include <granum/io/csv/table.hpp>

#include "unit.hpp"

using namespace granum::studies;
using triaxial::Density;

namespace {

TradeRow row(Varied varied, double value, std::size_t specimens, const Deviation& deviation) {
  TradeRow out;
  out.varied = varied;
  out.value = value;
  out.specimens = specimens;
  out.shear_modulus = deviation;
  return out;
}

/// Rows that obey c = 0.4, b = -3 and k = 20 exactly.
std::vector<TradeRow> lawful() {
  std::vector<TradeRow> rows;
  for (const double grains : {250.0, 500.0, 2000.0})
    rows.push_back(row(Varied::grains, grains, static_cast<std::size_t>(4000 / grains),
                       {-3 / grains + 3 / 2000.0, 0.4 / std::sqrt(4000), 0.4 / std::sqrt(grains)}));
  rows.back().reference = true;
  for (const double rate : {4e-3, 1e-3, 2.5e-4})
    rows.push_back(row(Varied::compression, rate, 4, {20 * (rate - 2.5e-4), 1e-4 + rate, 0.01}));
  rows.back().reference = true;
  return rows;
}

} // namespace

TEST_CASE("laws give back the scatter, the bias by size and the bias by rate that rows were made with") {
  const TradeLaws laws = laws_of(lawful());
  CHECK(laws.dense_modulus.size.scatter == relative(0.4, 1e-12));
  CHECK(laws.dense_modulus.size.bias == relative(-3.0, 1e-12));
  CHECK(laws.dense_modulus.rate.bias == relative(20.0, 1e-12));
  // 1/sqrt(sum of (x/SE)^2), x = 1/N - 1/2000
  const double x1 = 1 / 250.0 - 1 / 2000.0, x2 = 1 / 500.0 - 1 / 2000.0, error = 0.4 / std::sqrt(4000);
  CHECK(laws.dense_modulus.size.bias_error == relative(error / std::hypot(x1, x2), 1e-12));
  CHECK(laws.dense_modulus.size.smallest == 250);
  CHECK(laws.dense_modulus.size.largest == 2000);
  CHECK(laws.loose_modulus.size.scatter == 0);
  CHECK(laws.loose_modulus.size.largest == 0);
  CHECK(laws.dense_peak.rate.bias == 0);
  // Rows of walls and of the other density do not enter a law.
  std::vector<TradeRow> more = lawful();
  more.insert(more.end(), 2, row(Varied::grains, 100, 9, {0.5, 0.01, 0.3}));
  more[more.size() - 2].density = Density::loose;
  more.back().boundary = Boundary::rough_walls;
  CHECK(laws_of(more).dense_modulus.size.scatter == laws.dense_modulus.size.scatter);
  CHECK(laws_of(more).dense_modulus.size.bias == laws.dense_modulus.size.bias);
}

TEST_CASE("the recorded laws are those of validation/trade") {
  const io::CsvTable table = io::read_csv(GRANUM_VALIDATION "/trade/trade.csv");
  std::vector<TradeRow> rows;
  for (std::size_t k = 0; k < table.row_count(); ++k) {
    const auto field = [&](const std::string& heading) {
      const auto place = std::ranges::find(table.headings(), heading) - table.headings().begin();
      return table.fields(k).at(static_cast<std::size_t>(place));
    };
    const auto number = [&](const std::string& heading) { return parse_number(field(heading)); };
    const auto deviation = [&](const std::string& of) {
      const auto bias = number(of + "_bias");
      return bias ? std::optional(Deviation{*bias, *number(of + "_error"), *number(of + "_scatter")})
                  : std::nullopt;
    };
    TradeRow read;
    for (const Varied each : all_varied)
      if (name(each) == field("varied"))
        read.varied = each;
    read.boundary =
        field("boundary") == name(Boundary::periodic) ? Boundary::periodic : Boundary::smooth_walls;
    read.density = field("density") == name(Density::dense) ? Density::dense : Density::loose;
    read.value = *number("value");
    read.specimens = static_cast<std::size_t>(*number("specimens"));
    read.reference = *number("reference") == 1;
    read.shear_modulus = deviation("G");
    read.exponent = deviation("s");
    read.peak_ratio = deviation("peak");
    rows.push_back(read);
  }
  const TradeLaws now = laws_of(rows), recorded = recorded_laws();
  for (const auto law : {&TradeLaws::dense_modulus, &TradeLaws::dense_exponent, &TradeLaws::loose_modulus,
                         &TradeLaws::loose_exponent, &TradeLaws::dense_peak}) {
    const ErrorLaw &a = recorded.*law, &b = now.*law;
    // The constants have three digits; a bias that is far below its own error has fewer.
    CHECK(a.size.scatter == relative(b.size.scatter, 5e-3));
    CHECK(std::abs(a.size.bias - b.size.bias) <= 5e-3 * std::abs(b.size.bias) + 1e-3 * b.size.bias_error);
    CHECK(a.size.bias_error == relative(b.size.bias_error, 5e-3));
    CHECK((a.size.smallest == b.size.smallest && a.size.largest == b.size.largest));
    CHECK(std::abs(a.rate.bias - b.rate.bias) <= 5e-3 * std::abs(b.rate.bias) + 1e-3 * b.rate.bias_error);
    CHECK(a.rate.bias_error == relative(b.rate.bias_error, 5e-3));
  }
}

TEST_CASE("errors add in squares, biases with their signs") {
  const ErrorLaw law{.size = {0.4, -3, 0.5}, .rate = {20, 1}};
  CHECK(expected_error(law, 400, 1, 0) == relative(std::hypot(0.02, 0.0075), 1e-14));
  CHECK(expected_error(law, 400, 4, 0) == relative(std::hypot(0.01, 0.0075), 1e-14));
  CHECK(expected_error(law, 400, 4, 3e-4) == relative(std::hypot(0.01, 0.0015), 1e-12));
  CHECK(
      (scatter_of(law, 400) == relative(0.02, 1e-14) && size_bias_of(law, 400) == relative(-0.0075, 1e-14)));
  CHECK(rate_bias_of(law, 3e-4) == relative(0.006, 1e-14));
  CHECK_THROWS_AS((void)expected_error(law, 0, 1, 0), InvalidArgument);
  CHECK_THROWS_AS((void)expected_error(law, 100, 0, 0), InvalidArgument);
  CHECK_THROWS_AS((void)expected_error(law, 100, 1, -1e-3), InvalidArgument);
}

TEST_CASE("a recipe meets the required error without waste") {
  for (const ErrorLaw& law :
       {ErrorLaw{.size = {0.4, -3, 0.5}, .rate = {20, 1}}, ErrorLaw{.size = {1.5, 20, 2}, .rate = {-60, 9}}})
    for (const double error : {0.003, 0.01, 0.05})
      for (const std::size_t specimens : {1U, 4U}) {
        CAPTURE(error);
        CAPTURE(specimens);
        const Recipe recipe = recipe_for(law, error, specimens);
        CHECK(expected_error(law, recipe.grains, specimens, 0) <= error);
        // Two digits, upwards: a tenth more grains than needed at most.
        CHECK(expected_error(law, recipe.grains * 9 / 10, specimens, 0) > 0.999 * error);
        CHECK(std::abs(law.rate.bias) * recipe.inertial_number == relative(error / 3, 1e-12));
      }
  // Rates that do not matter are not made larger than what was measured.
  CHECK(recipe_for(ErrorLaw{.size = {0.4, 0, 0}, .rate = {1e-3, 0}}, 0.05, 1).inertial_number == 1e-2);
  CHECK(recipe_for(ErrorLaw{.size = {1e-3, 0, 0}, .rate = {}}, 0.05, 1).grains == 40);
  const std::pair<double, std::size_t> rounded[] = {
      {39, 40}, {41.2, 42}, {87.5, 88}, {1234, 1300}, {35000, 35000}};
  for (const auto& [needed, grains] : rounded) // c^2/e^2
    CHECK(recipe_for(ErrorLaw{.size = {0.01 * std::sqrt(needed * (1 - 1e-12)), 0, 0}, .rate = {}}, 0.01, 1)
              .grains == grains);
  CHECK_THROWS_AS((void)recipe_for(ErrorLaw{}, 0, 1), InvalidArgument);
  CHECK_THROWS_AS((void)recipe_for(ErrorLaw{}, 0.01, 0), InvalidArgument);
}

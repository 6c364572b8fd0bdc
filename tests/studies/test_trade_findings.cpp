// SPDX-License-Identifier: GPL-3.0-or-later
#include "studies/trade/trade_findings.hpp"

#include "unit.hpp"

using namespace granum::studies;
using triaxial::Density;

namespace {

TradeSample sample(Varied varied, double value, std::uint64_t seed, double log_modulus,
                   double exponent = 0.4) {
  TradeSample out;
  out.varied = varied;
  out.value = value;
  out.seed = seed;
  // Two pressures, of which the geometric mean is exp(log_modulus).
  out.shear_modulus = {std::exp(log_modulus - 0.3), std::exp(log_modulus + 0.3)};
  out.exponent = exponent;
  out.cpu_seconds = 2 * value;
  out.steps = 10 * seed;
  return out;
}

const TradeRow& row(const std::vector<TradeRow>& rows, double value, Boundary boundary = Boundary::periodic) {
  const auto found = std::find_if(rows.begin(), rows.end(), [&](const TradeRow& r) {
    return r.value == value && r.boundary == boundary;
  });
  REQUIRE(found != rows.end());
  return *found;
}

} // namespace

TEST_CASE("sizes are compared by their means, with a scatter that follows c N^(-1/2)") {
  // Deviations of +-d from means 17 and 17.02: standard deviation d sqrt 2 of two, d sqrt(4/3) of four.
  const double d = 0.03, e = 0.01;
  const std::vector<TradeSample> samples{
      sample(Varied::grains, 100, 1, 17 + d, 0.5), sample(Varied::grains, 100, 2, 17 - d, 0.5),
      sample(Varied::grains, 100, 3, 17 + d, 0.4), sample(Varied::grains, 100, 4, 17 - d, 0.4),
      sample(Varied::grains, 400, 1, 17.02 + e),   sample(Varied::grains, 400, 2, 17.02 - e)};
  const std::vector<TradeRow> rows = trade_rows(samples);
  REQUIRE(rows.size() == 2);
  const TradeRow& small = row(rows, 100);
  CHECK_FALSE(small.reference);
  CHECK(row(rows, 400).reference);
  CHECK(small.specimens == 4);
  CHECK(small.cpu_seconds == relative(200, 1e-15));
  CHECK(small.steps == relative(25, 1e-15));
  REQUIRE(small.shear_modulus);
  CHECK(small.shear_modulus->bias == relative(std::expm1(-0.02), 1e-10)); // digits of 17.02 - 17
  CHECK(small.shear_modulus->scatter == relative(d * std::sqrt(4.0 / 3), 1e-10));
  // c^2 = (3 (4/3) d^2 100 + 1 (2) e^2 400)/(3 + 1)
  const double c_squared = (4 * d * d * 100 + 2 * e * e * 400) / 4;
  CHECK(small.shear_modulus->standard_error ==
        relative(std::sqrt(c_squared / 100 / 4 + c_squared / 400 / 2), 1e-10));
  CHECK(small.exponent->bias == relative(0.05, 1e-12));
  CHECK_FALSE(small.peak_ratio);
  CHECK(row(rows, 400).shear_modulus->bias == 0);
  CHECK(row(rows, 400).shear_modulus->standard_error == relative(std::sqrt(c_squared / 400 / 2), 1e-10));
  // Two specimens of one size: e sqrt 2 over sqrt 2.
  const std::vector<TradeRow> pair = trade_rows({samples[4], samples[5]});
  CHECK(pair[0].shear_modulus->standard_error == relative(e, 1e-10));
}

TEST_CASE("settings are compared on the same packings, whose own scatter drops out") {
  // Packings that differ by 30 %; the coarse rate takes 1 and 3 % off them.
  std::vector<TradeSample> samples{sample(Varied::shear, 2e-3, 1, 17 - 0.01),
                                   sample(Varied::shear, 2e-3, 2, 17.3 - 0.03),
                                   sample(Varied::shear, 1e-4, 2, 17.3), sample(Varied::shear, 1e-4, 1, 17)};
  samples[0].peak_ratio = 1.1;
  samples[1].peak_ratio = 1.21;
  samples[3].peak_ratio = 1.0;
  samples[2].peak_ratio = 1.1;
  const std::vector<TradeRow> rows = trade_rows(samples);
  const TradeRow& coarse = row(rows, 2e-3);
  CHECK(row(rows, 1e-4).reference);
  CHECK(coarse.shear_modulus->bias == relative(std::expm1(-0.02), 1e-10));
  CHECK(coarse.shear_modulus->scatter == relative(0.01 * std::sqrt(2.0), 1e-10));
  CHECK(coarse.shear_modulus->standard_error == relative(0.01, 1e-10));
  CHECK(coarse.peak_ratio->bias == relative(0.1, 1e-12));
  CHECK(coarse.peak_ratio->standard_error < 1e-15);
}

TEST_CASE("a specimen without its partner, and one that failed, do not count") {
  std::vector<TradeSample> samples{
      sample(Varied::time_step, 0.8, 1, 17.1), sample(Varied::time_step, 0.8, 2, 17.1),
      sample(Varied::time_step, 0.8, 3, 19),   sample(Varied::time_step, 0.4, 1, 17),
      sample(Varied::time_step, 0.4, 2, 17),   sample(Varied::time_step, 0.4, 3, 17)};
  samples[5].shear_modulus.clear();
  samples[5].failure = "did not come to rest";
  std::vector<TradeRow> rows = trade_rows(samples);
  CHECK(row(rows, 0.8).specimens == 3);
  CHECK(row(rows, 0.4).specimens == 2);
  CHECK(row(rows, 0.8).shear_modulus->bias == relative(std::expm1(0.1), 1e-10));
  samples[4] = samples[5];
  rows = trade_rows(samples);
  CHECK_FALSE(row(rows, 0.8).shear_modulus);
  samples[3] = samples[5];
  CHECK(row(trade_rows(samples), 0.4).cpu_seconds == 0); // none is left
}

TEST_CASE("probes are compared with the network, walls with the largest periodic cell") {
  std::vector<TradeSample> samples;
  for (const std::uint64_t seed : {1U, 2U}) {
    samples.push_back(sample(Varied::probe, 1e-4, seed, 17.001));
    samples.push_back(sample(Varied::probe, 0, seed, 17));
    for (const double grains : {100.0, 200.0}) {
      samples.push_back(sample(Varied::boundary, grains, seed, 17));
      samples.push_back(sample(Varied::boundary, 2 * grains, seed, 16.5));
      samples.back().boundary = Boundary::rough_walls;
    }
    samples.push_back(sample(Varied::boundary, 100, seed, 16));
    samples.back().density = Density::loose;
  }
  const std::vector<TradeRow> rows = trade_rows(samples);
  CHECK(row(rows, 0).reference);
  CHECK(row(rows, 1e-4).shear_modulus->bias == relative(std::expm1(0.001), 1e-9));
  CHECK(row(rows, 200).reference);
  CHECK_FALSE(row(rows, 400, Boundary::rough_walls).reference);
  CHECK(row(rows, 400, Boundary::rough_walls).shear_modulus->bias == relative(std::expm1(-0.5), 1e-10));
  CHECK(rows.back().density == Density::loose);
  CHECK(rows.back().reference);
}

TEST_CASE("failed samples are counted, and the first is named with its reason") {
  std::vector<TradeSample> samples{sample(Varied::grains, 250, 1, 17), sample(Varied::grains, 250, 2, 17),
                                   sample(Varied::boundary, 1000, 7, 17),
                                   sample(Varied::boundary, 1000, 8, 17)};
  CHECK(failures_text(samples).empty());
  samples[2].boundary = Boundary::smooth_walls;
  samples[2].density = Density::loose;
  samples[2].failure = "why";
  samples[3].failure = "another";
  for (const char* part : {"2", "4", "boundary", "1000", "smooth-walls", "loose", "7", "why"})
    CHECK(failures_text(samples).find(part) != std::string::npos);
  samples[1].failure = "a third";
  CHECK(failures_text(samples).ends_with("a third")); // of a smaller number
}

TEST_CASE("error of a specimen: bias and scatter if the packing changes, else the bias") {
  TradeRow row;
  row.shear_modulus = Deviation{.bias = -0.03, .scatter = 0.04};
  for (const auto& [varied, error] :
       {std::pair{Varied::grains, 0.05}, {Varied::boundary, 0.05}, {Varied::compression, 0.03}}) {
    row.varied = varied;
    CHECK(error_of(row) == relative(error, 1e-15));
  }
}

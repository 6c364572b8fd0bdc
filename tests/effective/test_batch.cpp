// SPDX-License-Identifier: GPL-3.0-or-later
#include <granum/effective/batch.hpp>

#include <granum/effective/uniform_field.hpp>

#include "core/vector/power.hpp"
#include "support.hpp"
#include "thresholds.hpp"
#include "unit.hpp"
#include "vector_levels.hpp"

namespace {

using namespace granum::effective;

/// Rows that differ in everything; the lengths of vectors and of the inner blocks do not divide `count`.
struct Inputs {
  std::vector<double> pressure, coordination_number, porosity;

  explicit Inputs(std::size_t count) {
    for (std::size_t k = 0; k < count; ++k) {
      const double x = static_cast<double>(k);
      pressure.push_back(std::pow(10, -3 + std::fmod(0.37 * x, 12)));
      coordination_number.push_back(3 + std::fmod(0.61 * x, 9));
      porosity.push_back(0.2 + std::fmod(0.17 * x, 0.5));
    }
  }
};

struct Outputs {
  std::vector<double> bulk, shear;
  explicit Outputs(std::size_t count) : bulk(count, -1), shear(count, -1) {}
  [[nodiscard]] ModuliColumns columns() { return {bulk, shear}; }
};

/// Of unequal grains. Equal ones are those of which 50 digits are known below.
constexpr sizes::ContactMeans means{
    .branch = 1.02, .branch_square = 1.08, .pair_radius = 0.98, .grain_volume = 1.1};

PackingBatch batch_of(const contact::PowerLaw& law, const Inputs& in) {
  return {.law = law,
          .tangential_ratio = 0.8,
          .radius = 5e-4,
          .pressure = in.pressure,
          .coordination_number = in.coordination_number,
          .porosity = in.porosity,
          .contacts = means};
}

/// K and G of one row by the function for one state.
elastic::TransverselyIsotropic one_by_one(const contact::PowerLaw& law, double p, double C, double n) {
  return uniform_strain({.law = law,
                         .tangential_ratio = 0.8,
                         .radius = 5e-4,
                         .void_ratio = n / (1 - n),
                         .coordination_number = C,
                         .stress_v = p,
                         .stress_h = p,
                         .contacts = means})
      .stiffness;
}

} // namespace

TEST_CASE("batch: every row equals the function for one state, for any number of rows") {
  for (const double alpha : {1.0, 1.5, 2.0, 8.0, 300.0, test::infinity}) {
    const contact::PowerLaw law = test::law_of(alpha, 0.15);
    std::vector<std::size_t> counts{255, 256, 257, 280, 700};
    for (std::size_t count = 0; count <= 40; ++count)
      counts.push_back(count);
    for (const std::size_t count : counts) {
      const Inputs in(count);
      Outputs out(count);
      REQUIRE(uniform_strain(batch_of(law, in), out.columns()).ok());
      for (std::size_t k = 0; k < count; ++k) {
        const auto c = one_by_one(law, in.pressure[k], in.coordination_number[k], in.porosity[k]);
        CHECK(out.bulk[k] == relative(c.bulk_modulus(), 1e-14));
        CHECK(out.shear[k] == relative(c.G_vh(), 1e-14));
      }
    }
  }
}

TEST_CASE("batch: large batches, which bypass the caches, give the same bits as small ones") {
  const contact::PowerLaw law = test::law_of(2, 0.15);
  const std::size_t count = (std::size_t{1} << 17) + 3;
  const Inputs in(count);
  Outputs out(count), shifted(count + 1);
  REQUIRE(uniform_strain(batch_of(law, in), out.columns()).ok());
  // An odd start is not aligned to 16 bytes.
  const ModuliColumns odd{std::span(shifted.bulk).subspan(1), std::span(shifted.shear).subspan(1)};
  REQUIRE(uniform_strain(batch_of(law, in), odd).ok());
  for (std::size_t k = 0; k < count; k += 997) {
    const auto c = one_by_one(law, in.pressure[k], in.coordination_number[k], in.porosity[k]);
    CHECK(out.bulk[k] == relative(c.bulk_modulus(), 1e-14));
    CHECK(out.shear[k] == relative(c.G_vh(), 1e-14));
  }
  CHECK(std::ranges::equal(out.bulk, odd.bulk_modulus));
  CHECK(std::ranges::equal(out.shear, odd.shear_modulus));
}

TEST_CASE("batch: every shape has the same bits at every vector level") {
  if (test::levels_beyond_baseline().empty())
    MESSAGE("NOT COMPARED: this machine or build has the plain level only");
  for (const double alpha : {1.0, 1.5, 2.0, 8.0, test::infinity}) {
    CAPTURE(alpha);
    const contact::PowerLaw law = test::law_of(alpha, 0.15);
    const Inputs in(700);
    const auto moduli = [&](VectorLevel level) {
      const test::LevelSet at(level);
      Outputs out(700);
      REQUIRE(uniform_strain(batch_of(law, in), out.columns()).ok());
      return std::pair{out.bulk, out.shear};
    };
    for (const VectorLevel level : test::levels_beyond_baseline())
      CHECK(moduli(level) == moduli(VectorLevel::baseline));
  }
}

TEST_CASE("batch: a column may be one number, and results may take the place of the inputs, to the bit") {
  const contact::PowerLaw law = test::law_of(2, 0.15);
  Inputs in(300);
  in.coordination_number.assign(300, 6.2);
  Outputs out(300), constant(300);
  PackingBatch batch = batch_of(law, in);
  batch.coordination_number = 6.2;
  REQUIRE(uniform_strain(batch, constant.columns()).ok());
  REQUIRE(uniform_strain(batch_of(law, in), out.columns()).ok());
  REQUIRE(uniform_strain(batch_of(law, in), {in.pressure, in.porosity}).ok());
  CHECK((constant.bulk == out.bulk && constant.shear == out.shear));
  CHECK((in.pressure == out.bulk && in.porosity == out.shear));
}

TEST_CASE("batch: bad rows are named and zero, the others are computed") {
  const contact::PowerLaw law = test::law_of(2, 0.15);
  constexpr double nan = std::numeric_limits<double>::quiet_NaN();
  Inputs in(600);
  in.pressure[3] = -1;
  in.pressure[257] = nan;
  in.coordination_number[258] = -6;
  in.porosity[599] = 38;
  in.pressure[599] = in.coordination_number[599] = 0.5; // which are possible
  Outputs out(600), good(600);
  const BatchReport report = uniform_strain(batch_of(law, in), out.columns());
  REQUIRE(uniform_strain(batch_of(law, Inputs(600)), good.columns()).ok());
  CHECK(report.failed == 4);
  REQUIRE(report.errors.size() == 4);
  CHECK(report.errors[0].row == 3);
  CHECK(report.errors[0].message.starts_with("pressure = -1 Pa"));
  CHECK(report.errors[1].row == 257);
  CHECK(report.errors[2].message.starts_with("coordination_number = -6"));
  CHECK(report.errors[3].message.starts_with("porosity = 38"));
  for (std::size_t k = 0; k < 600; ++k) {
    const bool bad = k == 3 || k == 257 || k == 258 || k == 599;
    CHECK(out.bulk[k] == (bad ? 0 : good.bulk[k]));
    CHECK(out.shear[k] == (bad ? 0 : good.shear[k]));
  }
}

TEST_CASE("batch: rows are good up to the limits of pressures, contacts and porosities") {
  const auto limit = [](double at, std::vector<double> Inputs::*column) {
    check_threshold(at, [&](double value) {
      Inputs in(3);
      (in.*column)[1] = value;
      Outputs out(3);
      return uniform_strain(batch_of(test::law_of(2, 0.15), in), out.columns()).failed;
    });
  };
  limit(1e200, &Inputs::pressure);
  limit(1e6, &Inputs::coordination_number);
  limit(1, &Inputs::porosity);
}

TEST_CASE("batch: of many bad rows the first thousand are named, all are counted") {
  for (const std::size_t bad : {0U, 1U, 3000U}) {
    Inputs in(3000);
    std::fill_n(in.porosity.begin(), bad, 1);
    Outputs out(3000);
    const BatchReport report = uniform_strain(batch_of(test::law_of(1, 0.15), in), out.columns());
    CHECK(report.ok() == (bad == 0));
    CHECK(report.failed == bad);
    CHECK(report.errors.size() == std::min<std::size_t>(bad, 1000));
  }
}

TEST_CASE("batch: columns of another length are refused by name") {
  const Inputs in(5);
  Outputs out(4);
  CHECK_THROWS_WITH_AS((void)uniform_strain(batch_of(test::law_of(2, 0.15), in), out.columns()),
                       doctest::Contains("pressure"), InvalidArgument);
  Outputs other(5);
  CHECK_THROWS_WITH_AS((void)uniform_strain(batch_of(test::law_of(2, 0.15), in), {other.bulk, out.shear}),
                       doctest::Contains("shear_modulus"), InvalidArgument);
  PackingBatch batch = batch_of(test::law_of(2, 0.15), in);
  batch.radius = 0;
  CHECK_THROWS_AS((void)uniform_strain(batch, other.columns()), InvalidArgument);
}

TEST_CASE("batch: the smallest and largest pressures, and the limits at zero") {
  for (const double alpha : {1.0, 1.5, 2.0, 300.0, test::infinity}) {
    const contact::PowerLaw law = test::law_of(alpha, 0.15);
    const std::vector<double> pressure{0, 1e-300, 1e-308, 1e-3, 1e12, 1e200};
    for (const double C : {1e-14, 4.0, 14.0, 1e6}) {
      Outputs out(pressure.size());
      REQUIRE(uniform_strain({law, 0.8, 5e-4, pressure, C, 0.4}, out.columns()).ok());
      const double b = law.stiffness_exponent();
      for (std::size_t k = 1; k < pressure.size(); ++k) // K ~ p^b
        CHECK(std::log(out.bulk[k] / out.bulk[3]) ==
              doctest::Approx(b * std::log(pressure[k] / 1e-3)).epsilon(1e-12));
      CHECK(out.bulk[0] == (b == 0 ? out.bulk[3] : 0));
    }
    Outputs none(pressure.size());
    REQUIRE(uniform_strain({law, 0.8, 5e-4, pressure, 0.0, 0.4}, none.columns()).ok());
    CHECK(none.bulk == std::vector<double>(pressure.size(), 0.0));
    CHECK(none.shear == std::vector<double>(pressure.size(), 0.0));
  }
}

// Spheres against 50-digit arithmetic: validation/accuracy.
TEST_CASE("batch: no good row is infinite or NaN, no refused row anything but plain 0") {
  constexpr double nan = std::numeric_limits<double>::quiet_NaN();
  std::vector<double> values{0, -0.0, nan};
  for (const double size :
       {5e-324, 1e-300, 1e-9, 0.5, 1.0, 14.0, 1e6, 1.01e6, 1e200, 1.01e200, test::infinity})
    values.insert(values.end(), {size, -size});
  for (const double alpha : {1.0, 1.5, 2.0, 300.0, test::infinity}) {
    const contact::PowerLaw law = test::law_of(alpha, 0.15);
    for (const double C : values)
      for (const double n : values) {
        Outputs out(values.size());
        const BatchReport report = uniform_strain({law, 0.8, 5e-4, values, C, n}, out.columns());
        std::size_t impossible = 0;
        for (const double p : values)
          if (!(p >= 0 && p <= 1e200 && C >= 0 && C <= 1e6 && n > 0 && n < 1))
            ++impossible;
        CHECK(report.failed == impossible);
        CHECK(report.errors.size() == impossible);
        for (std::size_t k = 0; k < values.size(); ++k) {
          CHECK(std::isfinite(out.bulk[k]));
          CHECK(out.bulk[k] >= 0);
          CHECK(out.shear[k] >= 0);
        }
        for (const RowError& error : report.errors) {
          CHECK(!error.message.empty());
          CHECK(out.bulk[error.row] == 0);
          CHECK(!std::signbit(out.bulk[error.row]));
          CHECK(out.shear[error.row] == 0);
        }
      }
  }
}

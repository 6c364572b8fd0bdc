// SPDX-License-Identifier: GPL-3.0-or-later
#include "studies/verify/seed_mean.hpp"

#include <functional>

#include "studies/scene/scene.hpp"
#include <granum/core/text.hpp>
#include <granum/io/csv/table.hpp>

#include "sample_statistics.hpp"
#include "unit.hpp"

using namespace granum::studies;
using contact::Shape;
using triaxial::Density;

namespace {

constexpr std::size_t grains = 1000;

/// Calls a check with every contact, density and route of the recorded specimens.
void for_each_kind(const std::function<void(Shape, Density, const char*, ExponentRoute)>& check) {
  for (const Shape contact : {Shape::cone, Shape::sphere, Shape::flat})
    for (const Density density : {Density::dense, Density::loose})
      for (const auto& [column, route] : {std::pair{"closed_form", ExponentRoute::closed_form},
                                          {"network", ExponentRoute::network},
                                          {"probe", ExponentRoute::probe}}) {
        CAPTURE(name(contact));
        check(contact, density, column, route);
      }
}

/// s of the recorded specimens of a kind whose seeds are below 100, or the others.
std::vector<double> recorded(Shape contact, Density density, const std::string& column, bool below_100) {
  static const io::CsvTable table = io::read_csv(GRANUM_VALIDATION "/verify_default/scatter.csv");
  const auto field = [&](std::size_t row, std::string_view heading) {
    const auto found = std::find(table.headings().begin(), table.headings().end(), heading);
    REQUIRE(found != table.headings().end());
    return table.fields(row)[static_cast<std::size_t>(found - table.headings().begin())];
  };
  std::vector<double> values;
  for (std::size_t row = 0; row < table.row_count(); ++row)
    if (field(row, "contact") == name(contact) && field(row, "density") == name(density) &&
        (parse_number(field(row, "seed")).value() < 100) == below_100)
      values.push_back(parse_number(field(row, column)).value());
  return values;
}

} // namespace

TEST_CASE("the scatter of s is that of the recorded seeds") {
  for_each_kind([](Shape contact, Density density, const char* column, ExponentRoute route) {
    CAPTURE(column);
    const std::vector<double> seeds = recorded(contact, density, column, true);
    REQUIRE(seeds.size() >= 14);
    const KnownScatter known = exponent_scatter(contact, density, route, grains);
    CHECK(std::abs(known.deviation - deviation(seeds)) < 1e-4); // the digits that the table has
    REQUIRE(known.mean);
    CHECK(std::abs(*known.mean - mean(seeds)) < 1e-4);
  });
}

TEST_CASE("two stated errors of s cover 19 of 20 specimens not used for the scatter") {
  int within_one = 0, within_two = 0, all = 0;
  for_each_kind([&](Shape contact, Density density, const char* column, ExponentRoute route) {
    const KnownScatter known = exponent_scatter(contact, density, route, grains);
    for (const double s : recorded(contact, density, column, false)) {
      const double errors = std::abs(s - known.mean.value()) / known.deviation;
      within_one += errors <= 1;
      within_two += errors <= 2;
      ++all;
    }
  });
  REQUIRE(all >= 260);
  CHECK(within_one >= 0.55 * all);
  CHECK(within_one <= 0.8 * all);
  CHECK(within_two >= 0.92 * all);
}

TEST_CASE("the scatter of s falls with the root of the grains, a power-law contact has that of a flat one") {
  const auto at = [](Shape contact, std::size_t count) {
    return exponent_scatter(contact, Density::loose, ExponentRoute::network, count).deviation;
  };
  CHECK(at(Shape::sphere, 4000) == relative(at(Shape::sphere, 1000) / 2, 1e-12));
  CHECK(at(Shape::power_law, 1000) == at(Shape::flat, 1000));
  CHECK(!exponent_scatter(Shape::power_law, Density::loose, ExponentRoute::network, 1000).mean);
}

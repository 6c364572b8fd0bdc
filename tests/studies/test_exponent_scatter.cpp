// SPDX-License-Identifier: GPL-3.0-or-later
#include "studies/verify/seed_mean.hpp"

#include "studies/scene/scene.hpp"
#include <granum/core/text.hpp>
#include <granum/io/csv/table.hpp>

#include "sample_statistics.hpp"
#include "unit.hpp"

using namespace granum::studies;
using contact::Shape;
using triaxial::Density;

namespace {

/// s of the recorded specimens of a kind whose seeds are below 100.
std::vector<double> recorded(Shape contact, Density density, const char* column) {
  static const io::CsvTable table = io::read_csv(GRANUM_VALIDATION "/verify_default/scatter.csv");
  const auto field = [&](std::size_t row, std::string_view heading) {
    const auto place = std::ranges::find(table.headings(), heading) - table.headings().begin();
    return table.fields(row).at(static_cast<std::size_t>(place));
  };
  std::vector<double> values;
  for (std::size_t row = 0; row < table.row_count(); ++row)
    if (field(row, "contact") == name(contact) && field(row, "density") == name(density) &&
        parse_number(field(row, "seed")).value() < 100)
      values.push_back(parse_number(field(row, column)).value());
  return values;
}

} // namespace

TEST_CASE("the scatter of s is that of the recorded seeds, falls with the root of the grains, and of power "
          "laws is that of flat") {
  for (const Shape contact : {Shape::cone, Shape::sphere, Shape::flat})
    for (const Density density : {Density::dense, Density::loose})
      for (const auto& [column, route] : {std::pair{"closed_form", ExponentRoute::closed_form},
                                          {"network", ExponentRoute::network},
                                          {"probe", ExponentRoute::probe}}) {
        CAPTURE(name(contact));
        const std::vector<double> seeds = recorded(contact, density, column);
        REQUIRE(seeds.size() >= 14);
        const KnownScatter known = exponent_scatter(contact, density, route, 1000);
        CHECK(std::abs(known.deviation - deviation(seeds)) < 1e-4); // the digits that the table has
        CHECK(std::abs(known.mean.value() - mean(seeds)) < 1e-4);
      }
  const auto at = [](Shape contact, std::size_t count) {
    return exponent_scatter(contact, Density::loose, ExponentRoute::network, count).deviation;
  };
  CHECK(mean_over_seeds({{3, {}}}, {.deviation = 0.2, .degrees = 1})->standard_error == 0.2); // one seed
  CHECK(at(Shape::sphere, 4000) == relative(at(Shape::sphere, 1000) / 2, 1e-12));
  CHECK(at(Shape::power_law, 1000) == at(Shape::flat, 1000));
  CHECK(!exponent_scatter(Shape::power_law, Density::loose, ExponentRoute::network, 1000).mean);
}

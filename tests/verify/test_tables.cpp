// SPDX-License-Identifier: GPL-3.0-or-later
#include <granum/verify/tables.hpp>

#include <doctest/doctest.h>
#include <granum/core/error.hpp>
#include <granum/io/csv.hpp>

#include "verify/synthetic_study.hpp"

using namespace granum;
using namespace granum::verify;
using contact::Shape;
using triaxial::Density;

namespace {

const std::vector<double> pressures{10e3, 100e3 / 3, 100e3};

std::vector<SpecimenResult> study() {
  return {test::power_law_specimen(Shape::sphere, Density::dense, 7, 0.34, pressures),
          test::power_law_specimen(Shape::flat, Density::loose, 8, 0.21, pressures)};
}

Scene scene_of_study() {
  Scene scene;
  scene.study.contacts = {Shape::sphere, Shape::flat};
  return scene;
}

bool contains(const std::string& text, const std::string& part) {
  return text.find(part) != std::string::npos;
}

} // namespace

TEST_CASE("states_csv reads back to the same bits") {
  const io::CsvTable table("states.csv", states_csv(scene_of_study(), study()));
  REQUIRE(table.row_count() == 6);
  CHECK(table.headings().size() == 32);
  const auto column = [&](const char* name) { return table.numbers(name, Dimension::pressure); };
  std::size_t row = 0;
  for (const SpecimenResult& specimen : study())
    for (const StateResult& s : specimen.states) {
      CHECK(column("p")[row] == s.pressure);
      CHECK(column("p_contacts")[row] == s.pressure_by_contacts);
      CHECK(column("p_work")[row] == s.pressure_by_work);
      CHECK(column("G_closed")[row] == s.G_closed);
      CHECK(column("K_closed")[row] == s.K_closed);
      CHECK(column("G_uniform_strain")[row] == s.G_uniform_strain);
      CHECK(column("K_uniform_strain")[row] == s.K_uniform_strain);
      CHECK(column("G_network")[row] == s.G_network);
      CHECK(column("K_network")[row] == s.K_network);
      CHECK(column("K_lower")[row] == s.K_lower);
      CHECK(column("K_upper")[row] == s.K_upper);
      CHECK(column("G_hv_probe")[row] == s.probes->G_hv);
      CHECK(table.numbers("seed", Dimension::dimensionless)[row] == static_cast<double>(specimen.seed));
      CHECK(table.numbers("C_n", Dimension::dimensionless)[row] == s.coordination_number);
      CHECK(table.numbers("e", Dimension::dimensionless)[row] == s.void_ratio);
      ++row;
    }
}

TEST_CASE("each figure stands in its own column") {
  SpecimenResult specimen{Shape::cone, Density::dense, 1, {StateResult{}}, {}};
  StateResult& s = specimen.states[0];
  double next = 1;
  // In the order of the headings after contact, density and seed.
  for (double* figure : {&s.pressure,
                         &s.pressure_by_contacts,
                         &s.pressure_by_work,
                         &s.void_ratio,
                         &s.coordination_number,
                         &s.mechanical_coordination_number,
                         &s.rattler_fraction,
                         &s.fabric_anisotropy,
                         &s.fabric_anisotropy_error,
                         &s.sliding_fraction,
                         &s.G_closed,
                         &s.K_closed,
                         &s.G_uniform_strain,
                         &s.K_uniform_strain,
                         &s.G_network,
                         &s.K_network,
                         &s.G_hh_network,
                         &s.G_vh_network,
                         &s.K_lower,
                         &s.K_upper})
    *figure = next++;
  s.probes = Probes{21, 22, 23, 24};
  s.steps = 25;
  s.unbalanced_force_ratio = 26;
  s.largest_inertial_number = 27;
  s.network_iterations = 28;
  s.network_residual = 29;
  std::string numbers;
  for (int k = 1; k <= 29; ++k)
    numbers += "," + std::to_string(k);
  CHECK(contains(states_csv(scene_of_study(), {specimen}), "\ncone,dense,1" + numbers + "\n"));
  s.probes.reset();
  CHECK(contains(states_csv(scene_of_study(), {specimen}), ",20,,,,,25,"));
}

TEST_CASE("exponents_csv reads back, and what is missing is empty") {
  const std::vector<ExponentRow> rows = exponents(scene_of_study(), study());
  const std::string csv = exponents_csv(rows);
  const io::CsvTable table("exponents.csv", csv);
  REQUIRE(table.row_count() == 4); // two contacts, two densities, with specimens or without
  CHECK(table.numbers("contact_law", Dimension::dimensionless)[0] == rows[0].contact_law);
  CHECK(table.numbers("paper", Dimension::dimensionless)[3] == 0.245);
  CHECK_THROWS_AS((void)table.numbers("network", Dimension::dimensionless), FileError);
  CHECK(contains(csv, "\nsphere,loose,"));
  CHECK(contains(csv, ",,,,,,,,0.533"));
  const io::CsvTable full("exponents.csv", exponents_csv({rows[0], rows[3]}));
  CHECK(full.numbers("network", Dimension::dimensionless)[0] == rows[0].network->value);
  CHECK(full.numbers("network_error", Dimension::dimensionless)[1] == rows[3].network->standard_error);
  CHECK(full.numbers("closed_form", Dimension::dimensionless)[1] == rows[3].closed_form->value);
  CHECK(full.numbers("probe", Dimension::dimensionless)[1] == rows[3].probe->value);
}

TEST_CASE("tables for people name each specimen, its end and the verdicts") {
  std::vector<SpecimenResult> specimens = study();
  specimens[1].failure = "stopped on request";
  const std::string states = states_table(specimens);
  CHECK(contains(states, "sphere, dense, seed 7\n"));
  CHECK(contains(states, "flat, loose, seed 8\n"));
  CHECK(contains(states, "ended early: stopped on request"));
  CHECK(contains(states, "0.800")); // G network over uniform strain
  const std::string table = exponents_table(exponents(scene_of_study(), study()));
  CHECK(contains(table, "  sphere     dense        0.333    0.340 +- 0.000"));
  CHECK(contains(table, "0.349"));
  const std::string judged = verdicts_table({{"this", true, "1"}, {"that", false, "2"}});
  CHECK(judged == "  holds  this: 1\n  FAILS  that: 2\n");
}

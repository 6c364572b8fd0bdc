// SPDX-License-Identifier: GPL-3.0-or-later
#include "studies/verify/tables.hpp"

#include <granum/core/units.hpp>
#include <granum/io/csv/table.hpp>

#include "studies/verify/local_exponents.hpp"
#include "synthetic_study.hpp"
#include "unit.hpp"

using namespace granum::studies;
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

std::string states_csv(const std::vector<SpecimenResult>& specimens) {
  std::vector<CompressedState> states;
  for (const SpecimenResult& specimen : specimens)
    states.insert(states.end(), specimen.states.begin(), specimen.states.end());
  return io::csv_text(state_columns(), states);
}

std::string exponents_csv(const std::vector<ExponentRow>& rows) {
  return io::csv_text(exponent_columns(), rows);
}

bool contains(const std::string& text, const std::string& part) {
  return text.find(part) != std::string::npos;
}

} // namespace

TEST_CASE("each number is in its own column") {
  SpecimenResult specimen = test::power_law_specimen(Shape::cone, Density::dense, 1, 0.3, {100e3});
  CompressedState& s = specimen.states[0];
  // In the order of the headings.
  s.pressure = 1;
  s.packing.stress->symmetric = Mat3::diagonal(2, 2, 2);
  s.packing.pressure_by_work = 3;
  s.packing.void_ratio = 4;
  s.packing.counts.coordination_number = 5;
  s.packing.counts.mechanical.coordination_number = 6;
  s.packing.counts.mechanical.rattler_fraction = 7;
  s.packing.fabric = analysis::Fabric{};
  s.packing.fabric->by_moment.anisotropy = 8;
  s.packing.fabric->by_moment.standard_error = 9;
  s.sliding_fraction = 10;
  s.G_closed = 11;
  s.K_closed = 12;
  elastic::VoigtStiffness relaxed = test::solid(16, 15);
  relaxed.matrix(5, 5) += 1; // the planes differ, the isotropic part is the same
  relaxed.matrix(4, 4) += 2;
  relaxed.matrix(3, 3) -= 3;
  s.packing.network->response = {test::solid(14, 13), relaxed, {.iterations = 28, .residual = 29}};
  s.packing.network->bulk_bounds = {.lower = 19, .upper = 20};
  s.probes = Probes{21, 22, 23, 24};
  s.steps = 25;
  s.unbalanced_force_ratio = 26;
  s.largest_inertial_number = 27;
  const contact::GrainMaterial quartz{.shear_modulus = 30e9, .poisson_ratio = 0.15};
  s.packing.state = effective::State{.law = contact::PowerLaw::sphere(quartz, 0.5e-3),
                                     .tangential_ratio = 0.9,
                                     .radius = 0.5e-3,
                                     .void_ratio = 0.6,
                                     .coordination_number = 5.5,
                                     .mechanical_coordination_number = 5.7,
                                     .stress_v = 1e5,
                                     .stress_h = 1e5};
  const double rung3 = relaxed_modulus(s).value();
  const io::CsvTable table("states.csv", states_csv({specimen}));
  const std::vector<double> expected{1,  2,  3,  4,  5,  6,  7,  8,  9,  10, 11, 12, rung3, 13, 14,
                                     15, 16, 16, 17, 19, 20, 21, 22, 23, 24, 25, 26, 27,    28, 29};
  REQUIRE(table.fields(0).size() == expected.size());
  for (std::size_t k = 0; k < expected.size(); ++k) {
    CAPTURE(table.headings()[k]);
    CHECK(std::stod(table.fields(0)[k]) == relative(expected[k], 1e-14));
  }
  s.probes.reset();
  CHECK(contains(states_csv({specimen}), ",20,,,,,25,"));
}

TEST_CASE("exponents in CSV are read back, with empty cells for missing values") {
  const std::vector<ExponentRow> rows = exponents(scene_of_study(), study());
  const std::string csv = exponents_csv(rows);
  const io::CsvTable table("exponents.csv", csv), full("exponents.csv", exponents_csv({rows[0], rows[3]}));
  REQUIRE(table.row_count() == 4); // two contacts, two densities, with specimens or without
  const auto numbers = [](const io::CsvTable& of, const char* column) {
    return of.numbers(column, Dimension::dimensionless);
  };
  CHECK(numbers(table, "contact_law")[0] == rows[0].contact_law);
  CHECK(numbers(table, "paper")[3] == 0.245);
  CHECK_THROWS_AS((void)numbers(table, "network"), FileError);
  CHECK(contains(csv, "\nsphere,loose,"));
  CHECK(contains(csv, ",,,,,,,,0.533"));
  CHECK(numbers(full, "network")[0] == rows[0].network->value);
  CHECK(numbers(full, "network_error")[1] == rows[3].network->standard_error);
  CHECK(numbers(full, "closed_form")[1] == rows[3].closed_form->value);
  CHECK(numbers(full, "probe")[1] == rows[3].probe->value);
}

TEST_CASE("tables: numbers are shown in the unit of their heading") {
  std::size_t with_units = 0;
  const auto check = [&](const auto& columns) {
    for (const auto& column : columns)
      if (const std::size_t open = column.shown ? column.shown->heading.find('[') : std::string::npos;
          open != std::string::npos) {
        const std::string& heading = column.shown->heading;
        CAPTURE(heading);
        const std::optional<Unit> unit = find_unit(heading.substr(open + 1, heading.find(']') - open - 1));
        REQUIRE(unit);
        CHECK(column.shown->unit == unit->factor);
        ++with_units;
      }
  };
  check(state_columns());
  check(exponent_columns());
  check(verdict_columns());
  check(local_exponent_columns());
  CHECK(with_units > 2);
}

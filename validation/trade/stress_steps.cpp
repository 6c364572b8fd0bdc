// SPDX-License-Identifier: GPL-3.0-or-later
// Friction angles by steps of stress, each followed by rest, beside the peaks of shear at a given rate: dense
// spheres between walls.
//
//     trade_stress_steps [table.csv [specimens [grains [step of q/p']]]]
//
// By default 3 specimens of 1000 grains in steps of 0.025, and no table. A path ends at the last stress that
// the specimen holds: at the next one it does not come to rest. Exit code: 0, 1 an error, 2 usage.
#include <granum/dem/quasistatic.hpp>
#include <granum/triaxial/shear_test.hpp>

#include "../common.hpp"
#include "dense_spheres.hpp"

namespace {

using namespace trade;

struct Row {
  std::uint64_t seed = 0;
  stress::ShearPath path = stress::ShearPath::txc;
  double held_angle = 0, held_strain = 0; ///< of the last step that came to rest [deg, 1]
  double left_strain = 0;                 ///< where the next one was given up [1]
  double driven_angle = 0;                ///< peak at the default rate [deg]
};

/// Of the axis, from that length on.
double axial_strain(const dem::Engine& engine, double length) {
  return -std::log(engine.cell()(2, 2) / length);
}

Row stepped(const dem::Specimen& start, const dem::Material& material, stress::ShearPath path, double step) {
  constexpr double largest_strain = 0.1;
  const dem::QuasistaticOptions rest{.force_tolerance = 1e-4, .stress_tolerance = 1e-4};
  dem::Engine engine(start, material);
  const double length = engine.cell()(2, 2);
  Row row{.path = path};
  for (int k = 1;; ++k) {
    const double eta = (stress::is_compression(path) ? 1 : -1) * k * step;
    const stress::AxialStress target = stress::stress_on_path(path, pressure, eta);
    const bool holds = dem::equilibrate(engine, {target.h, target.h, target.v}, rest).converged();
    row.left_strain = axial_strain(engine, length);
    if (!holds || std::abs(row.left_strain) > largest_strain)
      return row;
    row.held_angle = angle_at(path, eta);
    row.held_strain = row.left_strain;
  }
}

double driven(const dem::Specimen& start, const dem::Material& material, stress::ShearPath path) {
  triaxial::ShearTest test(start, material,
                           {.path = path, .mean_stress = pressure, .eta_step = 10, .strain_step = 1e-3});
  while (test.advance() == triaxial::ShearEvent::snapshot) {
  }
  return stress::mobilised_friction_angle(test.peak().stress) / degree;
}

std::vector<Row> study(std::uint64_t specimens, std::size_t grains, double step) {
  std::vector<Row> rows;
  for (std::uint64_t seed = 1; seed <= specimens; ++seed) {
    const triaxial::SpecimenRecipe recipe = recipe_of(true, seed, grains);
    const dem::Specimen start = compressed(recipe);
    for (const stress::ShearPath path : stress::all_shear_paths) {
      Row row = stepped(start, recipe.material, path, step);
      row.seed = seed;
      row.driven_angle = driven(start, recipe.material, path);
      std::fprintf(stderr,
                   "specimen %llu, %s: held %.2f degrees at a strain of %.4f, left at %.4f; driven %.2f\n",
                   static_cast<unsigned long long>(seed), std::string(stress::name(path)).c_str(),
                   row.held_angle, row.held_strain, row.left_strain, row.driven_angle);
      rows.push_back(row);
    }
  }
  return rows;
}

io::CsvContent table_of(const std::vector<Row>& rows, std::size_t grains, double step) {
  io::CsvContent table;
  table.headings = {
      "grains",         "eta_step", "seed", "path", "held_deg", "held_axial_strain", "left_axial_strain",
      "driven_peak_deg"};
  for (const Row& r : rows) {
    auto& cells = table.rows.emplace_back(std::vector<io::CsvCell>{
        static_cast<double>(grains), step, static_cast<double>(r.seed), std::string(stress::name(r.path))});
    for (const double number : {r.held_angle, r.held_strain, r.left_strain, r.driven_angle})
      cells.emplace_back(short_text(number, 6));
  }
  return table;
}

/// Printed by the paper for dense spheres [deg].                                      [Chung2014, Table 4]
double printed(stress::ShearPath path) {
  using enum stress::ShearPath;
  return path == txc ? 26 : path == rtxc ? 25.7 : path == rtxe ? 28 : 28.5;
}

void report(const std::vector<Row>& rows) {
  for (const stress::ShearPath path : stress::all_shear_paths) {
    std::vector<double> held, peaks;
    for (const Row& row : rows)
      if (row.path == path) {
        held.push_back(row.held_angle);
        peaks.push_back(row.driven_angle);
      }
    const Mean steps = mean_of(held), rate = mean_of(peaks);
    std::printf("%-4s held in steps %.2f +- %.2f, peak of driven shear %.2f +- %.2f, paper %.1f degrees\n",
                std::string(stress::name(path)).c_str(), steps.value, steps.error, rate.value, rate.error,
                printed(path));
  }
}

} // namespace

int main(int argc, char** argv) {
  return program(argc, argv, {{"", "[table.csv] [specimens] [grains] [step]", [](const Arguments& arguments) {
                                 const Asked found = asked(arguments, 0.025);
                                 if (!(found.last > 0 && found.last < 1))
                                   throw InvalidArgument("the step of q/p' is not between 0 and 1");
                                 const std::vector<Row> rows =
                                     study(found.specimens, found.grains, found.last);
                                 write(found, table_of(rows, found.grains, found.last));
                                 report(rows);
                               }}});
}

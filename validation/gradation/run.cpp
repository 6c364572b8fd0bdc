// SPDX-License-Identifier: GPL-3.0-or-later
// Makes packings of spheres with uniformity coefficients from 1 to 4, and asks each for G in three ways:
// closed form, contact network, DEM probe.
//
//     gradation_run states.csv [threads [first letters of the preparations]]
//
// One row a state is appended as soon as the state is finished. A run that is started again skips the states
// that the file holds already: it may be stopped at any time, and a state whose row was deleted is made
// again. States that do not come to rest, or are looser than rung 3 has a stiffness for, are named on the
// error stream and left out.
#include <cstdio>
#include <cstdlib>
#include <exception>
#include <numbers>
#include <string>
#include <vector>

#include "studies/running/probes.hpp"
#include "studies/running/work_sharing.hpp"
#include <granum/contact/grains.hpp>
#include <granum/triaxial/probe.hpp>

#include "../relaxation/recording.hpp"
#include "../relaxation/specimens.hpp"
#include "closed_forms.hpp"

namespace {

using namespace granum;
using relaxation::Preparation;
using relaxation::Row;

constexpr double usual_radius = 0.5e-3; // mean by number [m]
constexpr double pressure = 100e3;      // [Pa]
constexpr int key_columns = 5;

/// A specimen to be made.
struct Task {
  Preparation preparation;
  double radius; // mean by number [m]
  std::uint64_t seed;
};

/// Dense, and compressed with more and more friction from a gas: from the densest to the loosest.
std::vector<Preparation> preparations() {
  const double mu = contact::Friction::from_angle(26.5 * std::numbers::pi / 180).coefficient();
  const std::vector<relaxation::Stage> path{{pressure}};
  std::vector<Preparation> all{
      {.name = "dense", .density = triaxial::Density::dense, .friction_coefficient = mu, .path = path},
      relaxation::gas("gas mu0.03", 0.03, path),
      relaxation::gas("gas mu0.1", 0.1, path),
      relaxation::gas("gas mu0.2", 0.2, path),
      relaxation::gas("gas mu0.3", 0.3, path),
      relaxation::gas("gas mu0.5", 0.5, path),
  };
  for (Preparation& preparation : all)
    preparation.max_steps = 400000;
  return all;
}

struct Gradation {
  const char* sizes;
  std::size_t grains;
};

/// One family: the same mass of grains for every step of diameter, C_u = 1, 1.5, 2, 2.5, 3 and 4. More
/// grains the wider it is: the largest must have room beside each other.
constexpr Gradation gradations[] = {{"", 1000},
                                    {"power-law:3:2.11", 1000},
                                    {"power-law:3:3.5", 1000},
                                    {"power-law:3:5.29", 1200},
                                    {"power-law:3:7.67", 1500},
                                    {"power-law:3:16", 3000}};

/// Every gradation and preparation once before any of them with a second seed; C_u = 2 again with grains
/// ten times as large, and sixteen times, a power of 4, which rounds as the usual size does.
std::vector<Task> tasks(const std::string& first_letters) {
  std::vector<Task> all;
  const auto add = [&](const Gradation& gradation, Preparation preparation, double radius,
                       std::uint64_t seed) {
    if (!std::string(preparation.name).starts_with(first_letters))
      return;
    preparation.sizes = gradation.sizes;
    preparation.grains = gradation.grains;
    all.push_back({preparation, radius, seed});
  };
  const std::vector<Preparation> ways = preparations();
  for (const std::uint64_t seed : {7000U, 7001U, 7002U, 7003U}) {
    for (const Preparation& way : ways)
      for (const Gradation& gradation : gradations)
        add(gradation, way, usual_radius, seed);
    if (seed == 7000)
      for (const double times : {10, 16})
        for (const std::size_t way : {0U, 4U}) // dense, and with a friction of 0.3
          add(gradations[2], ways[way], times * usual_radius, seed);
  }
  return all;
}

/// The columns that name a state.
Row key(const Task& task) {
  Row row;
  row.add("sizes", relaxation::sizes_of(task.preparation).text());
  row.add("preparation", std::string(task.preparation.name));
  row.add("seed", static_cast<double>(task.seed));
  row.add("grains", static_cast<double>(task.preparation.grains));
  row.add("mean_radius_m", task.radius);
  return row;
}

void add_closed_forms(Row& row, const analysis::Measurement& measured, const Task& task) {
  const packing::MechanicalCoordination& counted = measured.counts.mechanical;
  const gradation::ClosedForms closed =
      gradation::closed_forms(measured.state.value(), counted.coordination_number, counted.rattler_fraction,
                              relaxation::sizes_of(task.preparation), task.radius);
  row.add("G_closed_Pa", closed.relaxed);
  row.add("G_closed_stated", closed.stated_error);
  row.add("G_closed_sizes_Pa", closed.relaxed_from_sizes);
  row.add("G_uniform_strain_Pa", closed.uniform_strain);
}

void add_network(Row& row, const network::Response& response) {
  const elastic::VoigtStiffness& relaxed = response.relaxed();
  row.add("G_affine_Pa", elastic::isotropic_projection(response.affine()).shear_modulus());
  row.add("K_network_Pa", elastic::isotropic_projection(relaxed).bulk_modulus());
  row.add("G_network_Pa", elastic::isotropic_projection(relaxed).shear_modulus());
  row.add("C44_network_Pa", relaxed.matrix(3, 3));
  row.add("C55_network_Pa", relaxed.matrix(4, 4));
  row.add("C66_network_Pa", relaxed.matrix(5, 5));
}

void add_probes(Row& row, const dem::Specimen& frozen, const dem::Material& material) {
  const auto probes = triaxial::probe_all(frozen, material);
  const char* const modes[] = {"hh", "hv", "vh"};
  for (std::size_t k = 0; k < probes.size(); ++k) {
    const std::string mode = modes[k];
    row.add("G_" + mode + "_probe_Pa", probes[k].last_shear_modulus);
    row.add("converged_" + mode, probes[k].converged);
    row.add("steps_" + mode, static_cast<double>(probes[k].steps));
    row.add("unbalance_" + mode, probes[k].unbalanced_force_ratio);
  }
}

/// What one row says of a frozen state.
void describe(Row& row, const dem::Specimen& frozen, const dem::Material& material, const Task& task) {
  const packing::Assembly assembly = dem::contact_network(frozen, material);
  const analysis::Measurement measured = analysis::measure(assembly, studies::known_of(frozen, material),
                                                           {.network = network::ResponseOptions{}});
  row.add("friction_coefficient", task.preparation.friction_coefficient);
  relaxation::add_sizes(row, assembly, measured);
  row.add("d50_m", measured.sizes.gradation.d50);
  row.add("e", measured.void_ratio);
  row.add("C_n", measured.counts.coordination_number);
  row.add("a", measured.state.value().fabric_anisotropy);
  row.add("stress_v_Pa", measured.state->stress_v);
  row.add("stress_h_Pa", measured.state->stress_h);
  row.add("z_star", measured.counts.mechanical.coordination_number);
  row.add("rattler_fraction", measured.counts.mechanical.rattler_fraction);
  add_closed_forms(row, measured, task);
  add_network(row, measured.solved_network().response);
  add_probes(row, frozen, material);
}

void run(const Task& task, relaxation::Packings& packings, relaxation::Record& record) {
  Row row = key(task);
  if (record.has(row))
    return;
  const triaxial::SpecimenRecipe recipe = relaxation::recipe(
      contact::PowerLaw::sphere(relaxation::grain, task.radius), task.radius, task.preparation, task.seed);
  const dem::Specimen compressed = relaxation::at_stage(
      relaxation::start_of_path(packings.get("sphere", recipe), task.preparation, recipe), task.preparation,
      0, recipe.material);
  const triaxial::FrozenState frozen = triaxial::freeze_in_place(compressed, recipe.material);
  if (const std::string why = relaxation::why_left_out(frozen, recipe.material); !why.empty()) {
    std::fprintf(stderr, "%s: %s\n", row.cells.c_str(), why.c_str());
    return;
  }
  describe(row, frozen.state(), recipe.material, task);
  record.append(row);
  std::fprintf(stderr, "%s\n", record.key_of(row.cells).c_str());
}

} // namespace

int main(int argc, char** argv) {
  if (argc < 2 || argc > 4) {
    std::fprintf(stderr, "usage: %s states.csv [threads [first letters of the preparations]]\n", argv[0]);
    return 2;
  }
  const std::size_t threads = argc > 2 ? std::strtoul(argv[2], nullptr, 10) : 1;
  const std::vector<Task> all = tasks(argc > 3 ? argv[3] : "");
  relaxation::Record record(argv[1], key_columns);
  relaxation::Packings packings;
  studies::side_by_side(all.size(), threads, [&](std::size_t k) {
    try {
      run(all[k], packings, record);
    } catch (const std::exception& error) {
      std::fprintf(stderr, "%s: %s\n", key(all[k]).cells.c_str(), error.what());
    }
  });
}

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

#include "../common.hpp"
#include "../relaxation/making.hpp"
#include "closed_forms.hpp"
#include "studies/running/probes.hpp"

namespace {

using namespace granum;
using relaxation::gas;
using relaxation::Preparation;
using relaxation::Row;
using relaxation::Task;

constexpr double usual_radius = 0.5e-3; // mean by number [m]
constexpr double pressure = 100e3;      // [Pa]

/// Dense, and compressed with more and more friction from a gas: from the densest to the loosest.
std::vector<Preparation> preparations() {
  const double mu = relaxation::usual_friction();
  const std::vector<relaxation::Stage> path{{pressure}};
  std::vector<Preparation> all{
      {.name = "dense", .density = triaxial::Density::dense, .friction_coefficient = mu, .path = path},
      gas("gas mu0.03", 0.03, path),
      gas("gas mu0.1", 0.1, path),
      gas("gas mu0.2", 0.2, path),
      gas("gas mu0.3", 0.3, path),
      gas("gas mu0.5", 0.5, path),
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
    Row key; // the columns that name a state
    key.add("sizes", relaxation::sizes_of(preparation).text());
    key.add("preparation", preparation.name);
    key.add({{"seed", static_cast<double>(seed)},
             {"grains", static_cast<double>(preparation.grains)},
             {"mean_radius_m", radius}});
    all.push_back({.shape = "sphere",
                   .preparation = preparation,
                   .recipe = relaxation::recipe(contact::PowerLaw::sphere(relaxation::grain, radius), radius,
                                                preparation, seed),
                   .keys = {key}});
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

/// What one row says of a frozen state.
void describe(Row& row, const dem::Specimen& frozen, const Task& task) {
  const packing::Assembly assembly = dem::contact_network(frozen, task.recipe.material);
  const analysis::Measurement measured = analysis::measure(
      assembly, studies::known_of(frozen, task.recipe.material), {.network = network::ResponseOptions{}});
  const packing::MechanicalCoordination& counted = measured.counts.mechanical;
  row.add("friction_coefficient", task.preparation.friction_coefficient);
  relaxation::add_sizes(row, assembly, measured);
  row.add({{"d50_m", measured.sizes.gradation.d50},
           {"e", measured.void_ratio},
           {"C_n", measured.counts.coordination_number},
           {"a", measured.state.value().fabric_anisotropy},
           {"stress_v_Pa", measured.state->stress_v},
           {"stress_h_Pa", measured.state->stress_h},
           {"z_star", counted.coordination_number},
           {"rattler_fraction", counted.rattler_fraction}});
  const gradation::ClosedForms closed =
      gradation::closed_forms(measured.state.value(), counted.coordination_number, counted.rattler_fraction,
                              relaxation::sizes_of(task.preparation), task.recipe.radius);
  row.add({{"G_closed_Pa", closed.relaxed},
           {"G_closed_stated", closed.stated_error},
           {"G_closed_sizes_Pa", closed.relaxed_from_sizes},
           {"G_uniform_strain_Pa", closed.uniform_strain}});
  const network::Response& response = measured.solved_network().response;
  const elastic::VoigtStiffness& relaxed = response.relaxed();
  row.add({{"G_affine_Pa", elastic::isotropic_projection(response.affine()).shear_modulus()},
           {"K_network_Pa", elastic::isotropic_projection(relaxed).bulk_modulus()},
           {"G_network_Pa", elastic::isotropic_projection(relaxed).shear_modulus()},
           {"C44_network_Pa", relaxed.matrix(3, 3)},
           {"C55_network_Pa", relaxed.matrix(4, 4)},
           {"C66_network_Pa", relaxed.matrix(5, 5)}});
  const auto probes = triaxial::probe_all(frozen, task.recipe.material);
  const char* const modes[] = {"hh", "hv", "vh"};
  for (std::size_t k = 0; k < probes.size(); ++k) {
    const std::string mode = modes[k];
    row.add({{"G_" + mode + "_probe_Pa", probes[k].last_shear_modulus},
             {"converged_" + mode, probes[k].converged},
             {"steps_" + mode, static_cast<double>(probes[k].steps)},
             {"unbalance_" + mode, probes[k].unbalanced_force_ratio}});
  }
}

} // namespace

int main(int argc, char** argv) {
  return program(
      argc, argv,
      {{"", "states.csv [threads] [first-letters-of-the-preparations]", [](const Arguments& arguments) {
          relaxation::Record record(arguments[0], 5);
          relaxation::record_all(tasks(arguments.size() > 2 ? arguments[2] : ""),
                                 arguments.size() > 1 ? std::stoul(arguments[1]) : 1, record, describe);
        }}});
}

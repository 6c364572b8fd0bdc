// SPDX-License-Identifier: GPL-3.0-or-later
//
// Example 13: a packing is exported to LAMMPS, and the result of LAMMPS is read.
//
// granum makes a small dense specimen and writes a deck (input files) for LAMMPS. LAMMPS compresses the
// specimen and probes it by small strains, on one core here, on any number of cores elsewhere. granum reads
// the dumps of LAMMPS (its files of grains and contacts) and solves the contact network of the probed state.
// Network and LAMMPS must give the same moduli: K, the bulk modulus, and G_vh and G_hh, the shear moduli of a
// vertical and of the horizontal plane. Without LAMMPS the example ends after the deck.
//   13_from_scene_to_lammps_and_back [FOLDER]
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <string>
#include <vector>

#include <granum/analysis/measure.hpp>
#include <granum/io/csv/table.hpp>
#include <granum/io/lammps/deck.hpp>
#include <granum/io/lammps/files.hpp>
#include <granum/io/output_file.hpp>
#include <granum/triaxial/specimen.hpp>

using namespace granum;
namespace fs = std::filesystem;

namespace {

constexpr contact::GrainMaterial quartz{.shear_modulus = 30e9, .poisson_ratio = 0.15};
constexpr double radius = 0.5e-3; // [m]
constexpr double friction = 0.5;  // coefficient [1]

/// The deck of 300 spheres, packed without friction at 50 kPa. LAMMPS compresses them with friction to 50 and
/// 100 kPa, and probes them at 100 kPa.
std::vector<io::DeckFile> deck() {
  const auto law = contact::PowerLaw::sphere(quartz, radius);
  const double ratio = contact::mindlin_stiffness_ratio(quartz.poisson_ratio);
  const dem::Material material{.law = law, .tangential_ratio = ratio, .friction_coefficient = friction};
  triaxial::SpecimenRecipe recipe{.material = material, .radius = radius};
  recipe.grains = 300;
  recipe.first_pressure = 50e3;
  const packing::Assembly start =
      dem::contact_network(triaxial::frictionless_specimen(recipe).state, material);
  return io::lammps_deck(start, {.law = law,
                                 .radius = radius,
                                 .tangential_ratio = ratio,
                                 .friction_coefficient = friction,
                                 .pressures = {50e3, 100e3},
                                 .probe_pressures = {100e3}});
}

bool shell(const std::string& command) { return std::system(command.c_str()) == 0; }

} // namespace

int main(int argc, char** argv) {
  const fs::path folder = argc > 1 ? argv[1] : "lammps_deck";

  // 1. The deck: plain text. Every number is in scene.lmp, with a comment.
  fs::create_directories(folder);
  for (const io::DeckFile& file : deck())
    io::write_file(folder / file.name, file.text, io::Existing::replace);
  std::printf("deck written to %s\n", folder.c_str());

  // 2. LAMMPS, if it is installed; on a cluster: mpirun -np 64 lmp -in in.all
  if (!shell("command -v lmp > /dev/null 2>&1")) {
    std::printf("no program lmp is found; with LAMMPS, run in that folder:  lmp -in in.all\n");
    return 0;
  }
  if (!shell("cd '" + folder.string() + "' && lmp -in in.all > lammps.out 2>&1")) {
    std::printf("LAMMPS failed; its messages are in lammps.out\n");
    return 1;
  }

  // 3. Grains and contacts of the probed state. Dumps do not contain the material, so it is given here.
  io::LammpsDump dump(io::TextSource(folder / "atoms.100kPa.frozen.dump"),
                      io::TextSource(folder / "contacts.100kPa.frozen.dump"));
  const io::ImportedPacking packing = dump.next().value();
  const analysis::Measurement measured = analysis::measure(
      packing.assembly,
      {.grain_shear_modulus = quartz.shear_modulus, .grain_poisson_ratio = quartz.poisson_ratio},
      {.network = network::ResponseOptions{}});
  std::printf("%zu grains, C_n %.3f, p = %.3f kPa\n", measured.counts.grains,
              measured.counts.coordination_number, measured.stress.value().mean() / 1e3);

  // 4. Check: moduli that LAMMPS measured by straining the box, and moduli of the contact network.
  const auto& stiffness = measured.solved_network().response.relaxed().matrix;
  const double network[] = {stiffness(4, 4), stiffness(5, 5), stiffness.topLeftCorner<3, 3>().sum() / 9};
  const std::vector<double> probed =
      io::read_csv(folder / "moduli.csv").numbers("value", Dimension::pressure);
  const char* const names[] = {"G_vh", "G_hh", "K"}; // as in moduli.csv
  double worst = 0;
  for (std::size_t k = 0; k < 3; ++k) {
    std::printf("%-5s LAMMPS %7.2f MPa   network %7.2f MPa\n", names[k], probed.at(k) / 1e6,
                network[k] / 1e6);
    worst = std::max(worst, std::abs(probed[k] / network[k] - 1));
  }
  return worst < 0.02 ? 0 : 1;
}

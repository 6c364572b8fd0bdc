// SPDX-License-Identifier: GPL-3.0-or-later
//
// Example 11: what is in a packing made by another code, and do the closed forms agree with it?
//
// LAMMPS made 10,000 spheres at 50 kPa, loosely prepared. It wrote the grains by `dump custom` and the
// contacts by `dump local`. Such files contain neither the contact law nor the material; both follow from
// forces and overlaps. Other dumps are given on the command line:
//   11_analyse_a_lammps_dump grains.dump contacts.dump
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <string>
#include <vector>

#include "studies/analyse/measured_frame.hpp"
#include <granum/effective/relaxation.hpp>
#include <granum/effective/uniform_field.hpp>
#include <granum/elastic/projection.hpp>
#include <granum/io/lammps/dump.hpp>

using namespace granum;

namespace {

/// One line of the ladder: a shear modulus, and how much of it the network has.
void print(const char* rung, double G, double measured) {
  std::printf("  %-34s %7.1f MPa   network/this %.3f\n", rung, G / 1e6, measured / G);
}

double shear_modulus(const elastic::TransverselyIsotropic& stiffness) {
  return elastic::isotropic_projection(elastic::voigt(stiffness)).shear_modulus();
}

/// Largest difference of a stress from the six pressures that a code printed, over the mean stress. LAMMPS
/// prints sum d_a f_b, of which f_i l_j of the analysis is the transpose.
double difference(const packing::ContactStress& stress, const double (&code)[6]) {
  const Mat3& s = stress.tensor;
  const double own[6] = {s(0, 0), s(1, 1), s(2, 2), s(1, 0), s(2, 0), s(2, 1)};
  double largest = 0;
  for (int k = 0; k < 6; ++k)
    largest = std::max(largest, std::abs(own[k] - code[k]));
  return largest / stress.mean();
}

} // namespace

int main(int argc, char** argv) {
  const bool shipped = argc < 3;
  const std::string folder = GRANUM_EXAMPLE_DATA;

  // 1. Read one frame of both files, gzip or plain. What they could not tell comes along as notes.
  io::LammpsDump dump(io::TextSource(shipped ? folder + "/lammps_loose_p50.atoms.gz" : argv[1]),
                      io::TextSource(shipped ? folder + "/lammps_loose_p50.contacts.gz" : argv[2]));
  const io::ImportedPacking packing = dump.next().value();
  for (const io::ImportNote& note : packing.notes)
    std::printf("- %s\n", note.text.c_str());

  // 2. All that it says. Nothing is given, so the material comes out of the forces.
  const studies::MeasuredFrame frame = studies::measure_frame(packing);
  const analysis::Measurement& a = frame.packing;
  for (const std::string& warning : frame.warnings)
    std::printf("warning: %s\n", warning.c_str());
  if (!a.state || !a.network || !a.law_check->alpha) {
    std::printf("the files do not hold enough for stiffnesses\n");
    return 1;
  }
  std::printf("\nC_n %.4f over all grains, z* %.4f without %zu rattlers, %zu grains without contact\n",
              a.counts.coordination_number, a.counts.mechanical.coordination_number,
              a.counts.mechanical.rattler_count, a.counts.without_contact);
  std::printf("a = %.4f +- %.4f; different from 0 with p = %.2f; E(gamma; a) fits with p = %.2f\n",
              a.fabric->by_moment.anisotropy, a.fabric->by_moment.standard_error, a.fabric->isotropy->p_value,
              a.fabric->density->chi_square.p_value);
  std::printf("p = %.3f kPa; %.2f %% of the contacts slide\n", a.stress->mean() / 1e3,
              100 * a.forces->sliding_fraction.value_or(0));
  std::printf("alpha = %.6f +- %.0e (spheres: 2), grains of G_g = %.4f GPa if nu_g = 0.15\n",
              a.law_check->alpha->value, a.law_check->alpha->standard_error, a.grain->shear_modulus / 1e9);

  // 3. The ladder, for this very packing.
  const double measured = a.network->isotropic_relaxed().shear_modulus();
  const double affine = a.network->isotropic_affine().shear_modulus();
  const double uniform = shear_modulus(effective::uniform_strain(*a.state).stiffness);
  const double relaxed =
      shear_modulus(effective::relaxed(*a.state, a.counts.mechanical.coordination_number).stiffness);
  std::printf("\nshear modulus\n");
  print("rung 2, uniform strain", uniform, measured);
  print("rung 3, relaxed", relaxed, measured);
  print("uniform strain of this network", affine, measured);
  print("rung 4, this network", measured, measured);

  // 4. Check: the stress that the contacts carry is the one that LAMMPS printed, all six components.
  if (!shipped)
    return 0;
  const double code[6] = {49035.556553992,  50081.009425463, 50855.791347786,
                          -348.72040677456, 361.55169364362, -259.00766205737};
  const double apart = difference(*a.stress, code);
  std::printf("\nstress by contacts against LAMMPS' own: %.1e of the mean stress\n", apart);
  return apart < 1e-10 ? 0 : 1;
}

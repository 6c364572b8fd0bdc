// SPDX-License-Identifier: GPL-3.0-or-later
//
// Example 11: what is in a packing made by another code, and do the closed forms agree with it?
//
// LAMMPS made a loose packing of 10,000 spheres at 50 kPa. It wrote the grains by `dump custom` and the
// contacts by `dump local`. Such files contain neither the contact law nor the material; granum infers both
// from forces and overlaps. Other dumps can be given on the command line:
//   11_analyse_a_lammps_dump grains.dump contacts.dump
//
// C_n is the number of contacts per grain, z* the same without rattlers (grains that carry no load). a is the
// anisotropy of the contact directions, and E(gamma; a) their assumed density at the angle gamma from the
// vertical. p is the mean stress, or in "with p = ..." the p-value of a test. alpha is the exponent of the
// profile of a grain near a contact. G_g and nu_g are shear modulus and Poisson's ratio of the grains.
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <string>
#include <vector>

#include "studies/analyse/measured_frame.hpp"
#include <granum/effective/relaxation.hpp>
#include <granum/effective/uniform_field.hpp>
#include <granum/elastic/isotropic.hpp>
#include <granum/io/lammps/files.hpp>

using namespace granum;

namespace {

/// One line of the table: a shear modulus G, and G of the network (measured) over it.
void print(const char* rung, double G, double measured) {
  std::printf("  %-34s %7.1f MPa   network/this %.3f\n", rung, G / 1e6, measured / G);
}

double shear_modulus(const elastic::TransverselyIsotropic& stiffness) {
  return elastic::isotropic_projection(elastic::voigt(stiffness)).shear_modulus();
}

/// Largest difference between a stress and the six components (xx, yy, zz, xy, xz, yz) that a code printed,
/// over the mean stress. LAMMPS sums d_a f_b over the contacts, granum f_a d_b (d: vector between the
/// centres, f: contact force). One is the transpose of the other.
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

  // 1. Read one frame of both files, compressed by gzip or not. Notes list what the files do not contain.
  io::LammpsDump dump(io::TextSource(shipped ? folder + "/lammps_loose_p50.atoms.gz" : argv[1]),
                      io::TextSource(shipped ? folder + "/lammps_loose_p50.contacts.gz" : argv[2]));
  const io::ImportedPacking packing = dump.next().value();
  for (const io::ImportNote& note : packing.notes)
    std::printf("- %s\n", note.text.c_str());

  // 2. All measurements of the frame. No material is given, so it is inferred from forces and overlaps.
  const studies::MeasuredFrame frame = studies::measure_frame(packing);
  const analysis::Measurement& a = frame.packing;
  for (const std::string& warning : frame.warnings)
    std::printf("warning: %s\n", warning.c_str());
  if (!a.state || !a.network || !a.law_check->alpha) {
    std::printf("the files do not contain enough for stiffnesses\n");
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

  // 3. Estimates of the shear modulus of this packing, from formulas to the network. Rung 2 and rung 3 are
  //    closed forms (formulas): grains move with the mean strain (rung 2), or relax until their forces
  //    balance (rung 3). "Uniform strain of this network" is a sum over the actual contacts. Rung 4 solves
  //    the equilibrium of all grains.
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

  // 4. Check: the stress from the contact forces equals the one that LAMMPS printed [Pa], in all six
  //    components.
  if (!shipped)
    return 0;
  const double code[6] = {49035.556553992,  50081.009425463, 50855.791347786,
                          -348.72040677456, 361.55169364362, -259.00766205737};
  const double apart = difference(*a.stress, code);
  std::printf("\nstress by contacts against LAMMPS' own: %.1e of the mean stress\n", apart);
  return apart < 1e-10 ? 0 : 1;
}

// SPDX-License-Identifier: GPL-3.0-or-later
//
// Example 12: how does granum read a packing of YADE, and how stiff is the packing?
//
// YADE's own text exports have six digits, too few to compute overlaps. The script
// share/yade/granum_export.py, run inside YADE, writes all digits:
//   import sys; sys.path.append("<granum>/share/yade"); import granum_export
//   granum_export.write("packing", O)
// <granum> is the folder of granum's sources. The script also writes the contact stiffnesses of YADE, so the
// material need not be known. Other packings can be given on the command line:
//   12_analyse_yade_output packing.grains packing.contacts
//
// C_n is the number of contacts per grain, z* the same without rattlers (grains that carry no load). p is the
// mean stress. alpha is the exponent of the profile of a grain near a contact. G_g and nu_g are shear modulus
// and Poisson's ratio of the grains.
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <string>

#include "studies/analyse/measured_frame.hpp"
#include <granum/contact/power_law.hpp>
#include <granum/io/yade/files.hpp>
#include <granum/packing/stiffness.hpp>

using namespace granum;

namespace {

/// Largest difference between a stress and the six components (xx, yy, zz, xy, xz, yz) that getStress() of
/// YADE gives, over the mean stress.
double difference(const packing::ContactStress& stress, const double (&code)[6]) {
  const Mat3& s = stress.tensor;
  const double own[6] = {s(0, 0), s(1, 1), s(2, 2), s(1, 0), s(2, 0), s(2, 1)};
  double largest = 0;
  for (int k = 0; k < 6; ++k)
    largest = std::max(largest, std::abs(own[k] - code[k]));
  return largest / stress.mean();
}

/// Largest relative difference between the normal and tangential stiffnesses k_n and k_t of a packing and
/// those by Hertz and Mindlin at the same overlaps.
double difference(const packing::Assembly& packing, const contact::GrainMaterial& grain) {
  packing::Assembly expected = packing;
  assign_hertz_stiffness(expected, grain, contact::mindlin_stiffness_ratio(grain.poisson_ratio));
  double largest = 0;
  for (std::size_t c = 0; c < packing.contacts.size(); ++c) {
    const packing::Contact& is = packing.contacts[c];
    const packing::Contact& should = expected.contacts[c];
    largest = std::max({largest, std::abs(is.normal_stiffness / should.normal_stiffness - 1),
                        std::abs(is.tangential_stiffness / should.tangential_stiffness - 1)});
  }
  return largest;
}

} // namespace

int main(int argc, char** argv) {
  const bool shipped = argc < 3;
  const std::string folder = GRANUM_EXAMPLE_DATA;

  // 1. Read both files, compressed by gzip or not. Notes list what the files do not contain.
  const io::ImportedPacking packing =
      io::read_yade(io::TextSource(shipped ? folder + "/yade_packing.grains.gz" : argv[1]),
                    io::TextSource(shipped ? folder + "/yade_packing.contacts.gz" : argv[2]));
  for (const io::ImportNote& note : packing.notes)
    std::printf("- %s\n", note.text.c_str());

  // 2. All measurements of the packing.
  const studies::MeasuredFrame frame = studies::measure_frame(packing);
  const analysis::Measurement& a = frame.packing;
  for (const std::string& warning : frame.warnings)
    std::printf("warning: %s\n", warning.c_str());
  if (!a.stress || !a.network || !a.law_check->alpha || !a.grain) {
    std::printf("the files do not contain enough for stiffnesses\n");
    return 1;
  }
  std::printf("\nC_n %.4f over all grains, z* %.4f without %zu rattlers, p = %.3f kPa\n",
              a.counts.coordination_number, a.counts.mechanical.coordination_number,
              a.counts.mechanical.rattler_count, a.stress->mean() / 1e3);
  std::printf("alpha = %.6f (spheres: 2), grains of G_g = %.4f GPa if nu_g = 0.15\n",
              a.law_check->alpha->value, a.grain->shear_modulus / 1e9);

  // 3. Shear modulus G of the contact network with the stiffnesses of the files, and its ratio to G under
  //    uniform strain, in which all grains move with the mean strain.
  const double measured = a.network->isotropic_relaxed().shear_modulus();
  const double affine = a.network->isotropic_affine().shear_modulus();
  std::printf("G = %.1f MPa, %.3f of what uniform strain makes of the same contacts\n", measured / 1e6,
              measured / affine);

  // 4. Check: stress [Pa] and C_n are those that YADE printed for this state. The stiffnesses of YADE are
  //    those of Hertz and Mindlin for its grains: E = 69 GPa and nu = 0.15, so G = 30 GPa.
  if (!shipped)
    return 0;
  const double code[6] = {982321.63895271579, 983329.91514042427, 980526.88611746742,
                          -44299.73270919206, 69225.982755868346, -46511.588876321803};
  const double stress_apart = difference(*a.stress, code);
  const double stiffness_apart = difference(packing.assembly, {.shear_modulus = 30e9, .poisson_ratio = 0.15});
  std::printf("\nstress by contacts against YADE's own: %.1e of the mean stress\n", stress_apart);
  std::printf("stiffnesses of YADE against Hertz and Mindlin at its overlaps: %.1e\n", stiffness_apart);
  return stress_apart < 1e-10 && stiffness_apart < 1e-10 && a.counts.coordination_number == 5 ? 0 : 1;
}

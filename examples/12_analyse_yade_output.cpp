// SPDX-License-Identifier: GPL-3.0-or-later
//
// Example 12: how does granum read a packing of YADE, and how stiff is the packing?
//
// YADE's own text exports have six digits, too few for overlaps. share/yade/granum_export.py, run inside
// YADE, writes all digits:
//   import sys; sys.path.append("<granum>/share/yade"); import granum_export
//   granum_export.write("packing", O)
// It also writes the contact stiffnesses of YADE, so the material need not be known. <granum> is the folder
// of granum's sources. Other packings are given on the command line:
//   12_analyse_yade_output packing.grains packing.contacts
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <string>

#include "studies/analyse/measured_frame.hpp"
#include <granum/contact/power_law.hpp>
#include <granum/io/yade/text.hpp>
#include <granum/packing/stiffness.hpp>

using namespace granum;

namespace {

/// Largest difference of a stress from the six that YADE's getStress() gives, over the mean stress.
double difference(const packing::ContactStress& stress, const double (&code)[6]) {
  const Mat3& s = stress.tensor;
  const double own[6] = {s(0, 0), s(1, 1), s(2, 2), s(1, 0), s(2, 0), s(2, 1)};
  double largest = 0;
  for (int k = 0; k < 6; ++k)
    largest = std::max(largest, std::abs(own[k] - code[k]));
  return largest / stress.mean();
}

/// Largest relative difference of k_n and k_t in a packing from Hertz and Mindlin at the overlaps.
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

  // 1. Read both files, gzip or plain. What they could not tell comes along as notes.
  const io::ImportedPacking packing =
      io::read_yade(io::TextSource(shipped ? folder + "/yade_packing.grains.gz" : argv[1]),
                    io::TextSource(shipped ? folder + "/yade_packing.contacts.gz" : argv[2]));
  for (const io::ImportNote& note : packing.notes)
    std::printf("- %s\n", note.text.c_str());

  // 2. All that it says.
  const studies::MeasuredFrame frame = studies::measure_frame(packing);
  const analysis::Measurement& a = frame.packing;
  for (const std::string& warning : frame.warnings)
    std::printf("warning: %s\n", warning.c_str());
  if (!a.stress || !a.network || !a.law_check->alpha || !a.grain) {
    std::printf("the files do not hold enough for stiffnesses\n");
    return 1;
  }
  std::printf("\nC_n %.4f over all grains, z* %.4f without %zu rattlers, p = %.3f kPa\n",
              a.counts.coordination_number, a.counts.mechanical.coordination_number,
              a.counts.mechanical.rattler_count, a.stress->mean() / 1e3);
  std::printf("alpha = %.6f (spheres: 2), grains of G_g = %.4f GPa if nu_g = 0.15\n",
              a.law_check->alpha->value, a.grain->shear_modulus / 1e9);

  // 3. Its network, with the stiffnesses of the files, beside uniform strain.
  const double measured = a.network->isotropic_relaxed().shear_modulus();
  const double affine = a.network->isotropic_affine().shear_modulus();
  std::printf("G = %.1f MPa, %.3f of what uniform strain makes of the same contacts\n", measured / 1e6,
              measured / affine);

  // 4. Check: stress and C_n are those that YADE printed for this state, and its stiffnesses are those of
  //    Hertz and Mindlin for the grains that it was told, E = 69 GPa and nu = 0.15.
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

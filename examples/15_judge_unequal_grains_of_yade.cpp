// SPDX-License-Identifier: GPL-3.0-or-later
//
// Example 15: how accurate is the closed form for unequal grains packed by another code?
//
// YADE packed 600 spheres of unequal radii, lognormal by number, and compressed them to 100 kPa: once without
// friction (dense), and once with friction, from a gas of grains that do not touch (loose). The files contain
// sizes, contacts and stiffnesses. Rung 3, the relaxed closed form (formula), uses means over the contacts of
// unequal grains. It gives the bulk modulus K and the shear modulus G, each with a stated error (standard
// error). The program prints the difference between rung 3 and the contact network of the same packing, in
// per cent and in stated errors. Other packings, written by share/yade/granum_export.py, can be given on the
// command line:
//   15_judge_unequal_grains_of_yade packing.grains packing.contacts
#include <cmath>
#include <cstdio>
#include <string>

#include <granum/analysis/measure.hpp>
#include <granum/core/error.hpp>
#include <granum/elastic/isotropic.hpp>
#include <granum/io/yade/files.hpp>

using namespace granum;

namespace {

constexpr double MPa = 1e6, kPa = 1e3;

/// Prints a modulus by rung 3 and by the network, both given in Pa. Returns true if they differ by at most
/// two stated errors.
bool judge(const char* name, double rung, double relative_error, double network) {
  const double off = rung / network - 1, deviations = std::abs(rung - network) / (relative_error * rung);
  std::printf(
      "%s  network %6.1f MPa   rung 3 %6.1f MPa +- %.1f %%   off by %+.1f %%, %.1f stated errors: %s\n", name,
      network / MPa, rung / MPa, 100 * relative_error, 100 * off, deviations,
      deviations <= 2 ? "within two" : "beyond two");
  return deviations <= 2;
}

/// Prints sizes, stress and contacts of the packing: e is the void ratio, p the mean stress, and z* the
/// number of contacts per grain without rattlers (grains that carry no load). The last line has the means
/// that the closed forms use, each over its value for equal grains of the radius R: l is the distance of the
/// centres of two grains in contact, R* the effective radius of a pair, and V the volume of a grain.
void describe(const analysis::Measurement& a) {
  const sizes::ContactMeans& means = a.sizes.contacts;
  std::printf("%zu grains of %.3f to %.3f mm, C_u = d60/d10 = %.2f; e = %.3f at p = %.1f kPa\n",
              a.counts.grains, 2e3 * a.sizes.smallest, 2e3 * a.sizes.largest, a.sizes.gradation.uniformity(),
              a.void_ratio, a.stress->mean() / kPa);
  std::printf("z* = %.3f without rattlers, %.1f %% of the grains\n", a.counts.mechanical.coordination_number,
              100 * a.counts.mechanical.rattler_fraction);
  std::printf("over equal grains of R = <R^3>/<R^2> = %.4f mm: <l> %.3f, <l^2> %.3f, R* %.3f, <V> %.3f\n\n",
              1e3 * a.sizes.equivalent, means.branch, means.branch_square, means.pair_radius,
              means.grain_volume);
}

/// True where rung 3 and the network agree within two stated errors.
struct Judgement {
  bool bulk;
  bool shear;
};

Judgement judge(const std::string& grains, const std::string& contacts) {
  const io::ImportedPacking packing = io::read_yade(io::TextSource(grains), io::TextSource(contacts));
  const analysis::Measurement a =
      analysis::measure(packing.assembly, {}, {.closed_forms = true, .network = network::ResponseOptions{}});
  describe(a);

  // One K and one G for each: the stiffnesses are nearly isotropic, and their isotropic part is compared.
  const elastic::Isotropic network = a.solved_network().isotropic_relaxed();
  const effective::RungAnswer answer = a.closed_form(effective::RungName::relaxed).value();
  const elastic::Isotropic rung = elastic::isotropic_projection(elastic::voigt(answer.stiffness));
  const effective::ModulusErrors& error = answer.relative_error.value();
  const Judgement judgement{.bulk =
                                judge("K", rung.bulk_modulus(), error.bulk_modulus, network.bulk_modulus()),
                            .shear = judge("G", rung.shear_modulus(), error.G_vh, network.shear_modulus())};
  for (const std::string& note : answer.validity.notes)
    std::printf("note: %s\n", note.c_str());
  return judgement;
}

Judgement judge_shipped(const std::string& density) {
  const std::string name = GRANUM_EXAMPLE_DATA "/yade_lognormal_" + density;
  std::printf("%s\n", density.c_str());
  const Judgement judgement = judge(name + ".grains.gz", name + ".contacts.gz");
  std::printf("\n");
  return judgement;
}

} // namespace

int main(int argc, char** argv) {
  try {
    if (argc == 3) {
      (void)judge(argv[1], argv[2]);
      return 0;
    }
    const Judgement dense = judge_shipped("dense"), loose = judge_shipped("loose");

    // Check: all errors of rung 3 are within two stated errors. K of the loose packing is 8 % too small, as
    // in other packings that a code compressed with friction from a gas. The stated error allows for this.
    return dense.bulk && dense.shear && loose.bulk && loose.shear ? 0 : 1;
  } catch (const Error& error) {
    std::fprintf(stderr, "%s\n", error.what());
    return 2;
  }
}

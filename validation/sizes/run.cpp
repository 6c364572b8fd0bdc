// SPDX-License-Identifier: GPL-3.0-or-later
// How well do means over contacts, counted or expected from the sizes, make the closed forms those of unequal
// grains? Packings of LAMMPS, and the sum over their contacts as the truth.
//   sizes <folder of the packings>
// Exit code 0 only if every number is within what README.md says.
#include <granum/analysis/measure.hpp>
#include <granum/contact/grains.hpp>
#include <granum/effective/uniform_field.hpp>
#include <granum/elastic/isotropic.hpp>
#include <granum/io/lammps/files.hpp>
#include <granum/sizes/contact_means.hpp>
#include <granum/sizes/distribution.hpp>

#include "../common.hpp"

using namespace granum;

namespace {

constexpr contact::GrainMaterial quartz{.shear_modulus = 30e9, .poisson_ratio = 0.15};

struct Packing {
  const char* name;
  const char* sizes; ///< that its grains were drawn from
};

/// G of uniform strain, of contacts that all bear the mean force.
double shear_modulus(effective::State state, const sizes::ContactMeans& means, double radius) {
  state.radius = radius;
  state.contacts = means;
  state.law = contact::PowerLaw::sphere(quartz, radius * means.pair_radius);
  return elastic::isotropic_projection(
             elastic::voigt(effective::uniform_strain_stiffness(effective::uniform_contacts(state))))
      .shear_modulus();
}

/// Whether it is within the limit; the text says by how much it is off [%].
bool judge(const char* what, double ratio, double limit) {
  const double off = 100 * (ratio - 1);
  std::printf("  %-58s %+6.1f %%%s\n", what, off, std::abs(off) <= limit ? "" : "   BEYOND ITS LIMIT");
  return std::abs(off) <= limit;
}

/// What stands between the closed form and the sum over contacts: their product is 1 over its error.
struct Causes {
  double mean_force = 0;  ///< k_n of <f> over that of 3 p V/(N_c <l>): long branches bear more
  double scatter = 0;     ///< <f^(1/3)> over <f>^(1/3), as k_n ~ f^(1/3) R*^(1/3); equal grains have it too
  double correlation = 0; ///< <f^(1/3) R*^(1/3) l^2> over <f^(1/3)> <R*^(1/3) l^2>: forces grow with sizes
};

Causes causes_of(const packing::Assembly& assembly, const effective::State& state) {
  double roots = 0, of_size = 0, both = 0, f = 0;
  for (const packing::Contact& c : assembly.contacts) {
    const double ri = assembly.radius[c.i], rj = assembly.radius[c.j];
    const double root = std::cbrt(c.normal_force);
    const double size = std::cbrt(contact::pair_radius(ri, rj)) * (ri + rj) * (ri + rj);
    roots += root, of_size += size, both += root * size, f += c.normal_force;
  }
  const double count = static_cast<double>(assembly.contacts.size());
  const double of_mean = state.law.stiffness_at_force(f / count);
  return {.mean_force = of_mean / state.law.stiffness_at_force(effective::mean_contact_force(state)),
          .scatter = roots / count / std::cbrt(f / count),
          .correlation = both * count / (roots * of_size)};
}

bool check(const Packing& which, const std::string& folder) {
  const std::string path = folder + "/" + which.name;
  io::LammpsDump dump(io::TextSource(path + ".atoms.gz"), io::TextSource(path + ".contacts.gz"));
  const packing::Assembly assembly = dump.next().value().assembly;
  const analysis::Measurement a = analysis::measure(
      assembly,
      {.grain_shear_modulus = quartz.shear_modulus, .stiffness_from = packing::StiffnessFrom::force},
      {.closed_forms = true, .network = network::ResponseOptions{}});
  const double affine = a.network->isotropic_affine().shear_modulus();
  const double x0 = a.counts.mechanical.rattler_fraction, mean = mean_of(assembly.radius).value;
  const sizes::ContactMeans counted = sizes::with_reference(a.sizes.contacts, mean / a.sizes.equivalent);
  const auto drawn = sizes::parse_distribution(which.sizes);
  const sizes::ContactMeans expected = sizes::expected_contact_means(drawn, x0);
  const sizes::ContactMeans without = sizes::expected_contact_means(drawn);
  std::printf("%s: %s, C_u %.2f, C_n %.3f, z* %.3f, x_0 %.3f\n", which.name, which.sizes,
              a.sizes.gradation.uniformity(), a.counts.coordination_number,
              a.counts.mechanical.coordination_number, x0);
  std::printf(" means over contacts, from sizes and rattlers, over counted ones\n");
  bool good = judge("<l>", expected.branch / counted.branch, 2);
  good &= judge("<l^2>", expected.branch_square / counted.branch_square, 3);
  good &= judge("R* of the mean pair", expected.pair_radius / counted.pair_radius, 2);
  judge("<l^2>, rattlers not told", without.branch_square / counted.branch_square, 100);
  std::printf(" G of uniform strain over the sum over contacts\n");
  const auto [mean_force, scatter, correlation] = causes_of(assembly, *a.state);
  const double by_count = shear_modulus(*a.state, counted, mean) / affine;
  const double by_sizes = shear_modulus(*a.state, expected, mean) / affine;
  judge("means counted", by_count, 100);
  judge("means from sizes and rattlers", by_sizes, 100);
  good &= judge("means counted, times <f^b>/<f>^b", by_count * scatter, 5);
  good &= judge("means from sizes and rattlers, times <f^b>/<f>^b", by_sizes * scatter, 5);
  judge("means from sizes, rattlers not told", shear_modulus(*a.state, without, mean) / affine, 100);
  judge("equal grains of <R^3>/<R^2>", shear_modulus(*a.state, {}, a.sizes.equivalent) / affine, 100);
  std::printf(" what stands between means counted and the sum\n");
  judge("long branches bear more: the mean force is smaller", mean_force, 100);
  judge("forces scatter about their mean", scatter, 100);
  judge("forces grow with the sizes of the pair", correlation, 100);
  good &= judge("all three, after which nothing is left", by_count * mean_force * scatter * correlation, 0.1);
  std::printf(" rung 3 over network\n");
  const auto relaxed = a.closed_form(effective::RungName::relaxed);
  const elastic::Isotropic network = a.network->isotropic_relaxed();
  const elastic::Isotropic rung = elastic::isotropic_projection(elastic::voigt(relaxed->stiffness));
  judge("K", rung.bulk_modulus() / network.bulk_modulus(), 100);
  judge("G", rung.shear_modulus() / network.shear_modulus(), 100);
  return good;
}

} // namespace

int main(int argc, char** argv) {
  return program(argc, argv, {{"", "FOLDER", [](const Arguments& arguments) {
                                 bool good = true;
                                 for (const Packing& packing : {Packing{"lognormal_dense", "lognormal:0.35"},
                                                                Packing{"uniform_dense", "uniform:1:3"},
                                                                Packing{"lognormal_loose", "lognormal:0.35"},
                                                                Packing{"uniform_loose", "uniform:1:3"}})
                                   good = check(packing, arguments[0]) && good;
                                 return good;
                               }}});
}

// SPDX-License-Identifier: GPL-3.0-or-later
//
// Example 03: why does a loose packing stiffen faster with stress than a dense one?
//
// Two specimens of spheres are made from one frictionless packing. The dense one keeps its contacts. The
// loose one is expanded a little before friction is switched on, so that it has fewer contacts at nearly the
// same void ratio. G is the shear modulus and p the mean stress. With a constant number of contacts both
// specimens would have s = 1/3 in G ~ p^s.
//
// The first table gives the void ratio e, the contacts per grain C_n, the contacts per load-carrying grain z*
// and G of the contact network, all at three pressures. Uniform strain means that all grains move with the
// mean strain.
#include <cmath>
#include <cstdio>
#include <vector>

#include <granum/analysis/measure.hpp>
#include <granum/core/error.hpp>
#include <granum/triaxial/probe.hpp>
#include <granum/triaxial/specimen.hpp>

using namespace granum;

namespace {

/// The measurements of a specimen at one pressure.
struct Compressed {
  double pressure = 0;
  double void_ratio = 0;
  double coordination_number = 0;            // C_n, all grains
  double mechanical_coordination_number = 0; // z*, without rattlers (grains that carry no load)
  double shear_modulus = 0;                  // of the network, every grain in equilibrium [Pa]
  double uniform_strain = 0;                 // shear modulus of the same network under uniform strain [Pa]
};

Compressed measure(const triaxial::Snapshot& snapshot, const dem::Material& material) {
  const triaxial::FrozenState frozen = triaxial::freeze_in_place(snapshot.state, material);
  if (!snapshot.report.converged() || !frozen.report.converged())
    throw NotConverged("a specimen did not come to rest");
  const analysis::Measurement packing =
      analysis::measure(dem::contact_network(frozen.state(), material),
                        {.law = material.law, .tangential_ratio = material.tangential_ratio},
                        {.network = network::ResponseOptions{}});
  const analysis::Network& network = packing.solved_network();
  return {
      .pressure = snapshot.pressure,
      .void_ratio = packing.void_ratio,
      .coordination_number = packing.counts.coordination_number,
      .mechanical_coordination_number = packing.counts.mechanical.coordination_number,
      .shear_modulus = network.isotropic_relaxed().shear_modulus(),
      .uniform_strain = network.isotropic_affine().shear_modulus(),
  };
}

std::vector<Compressed> compress(const dem::Specimen& packing, triaxial::Density density,
                                 const triaxial::SpecimenRecipe& recipe) {
  std::vector<Compressed> path;
  triaxial::isotropic_path(triaxial::start_of_compression(packing, density, recipe), recipe.material,
                           {10e3, 30e3, 100e3}, triaxial::compression_options(),
                           [&](const triaxial::Snapshot& snapshot) {
                             path.push_back(measure(snapshot, recipe.material));
                             return true;
                           });
  return path;
}

void print(const char* name, const std::vector<Compressed>& path) {
  for (const Compressed& at : path)
    std::printf("%-6s %5.0f kPa   %.3f   %5.2f   %5.2f   %6.1f MPa   %.3f\n", name, at.pressure / 1e3,
                at.void_ratio, at.coordination_number, at.mechanical_coordination_number,
                at.shear_modulus / 1e6, at.shear_modulus / at.uniform_strain);
}

/// Exponent of a quantity ~ p^exponent between the first and the last pressure.
double exponent(const std::vector<Compressed>& path, double Compressed::*quantity) {
  const Compressed& low = path.front();
  const Compressed& high = path.back();
  return std::log(high.*quantity / low.*quantity) / std::log(high.pressure / low.pressure);
}

/// 0 if the void ratios differ by at most 0.02, no network is stiffer than under uniform strain, and s of the
/// loose specimen is larger than s of the dense one by more than 0.1.
int check(const std::vector<Compressed>& dense, const std::vector<Compressed>& loose) {
  if (dense.size() != 3 || loose.size() != 3)
    return 1;
  for (std::size_t k = 0; k < 3; ++k) {
    if (std::abs(loose[k].void_ratio - dense[k].void_ratio) > 0.02)
      return 1;
    if (dense[k].shear_modulus > dense[k].uniform_strain || loose[k].shear_modulus > loose[k].uniform_strain)
      return 1;
  }
  const double gain =
      exponent(loose, &Compressed::shear_modulus) - exponent(dense, &Compressed::shear_modulus);
  return gain > 0.1 ? 0 : 1;
}

} // namespace

int main() {
  // 1. The grains: 300 spheres of 1 mm, quartz-like, with a friction angle of 26.5 degrees between them.
  const contact::GrainMaterial grain{.shear_modulus = 30e9, .poisson_ratio = 0.15};
  triaxial::SpecimenRecipe recipe{
      .material = {.law = contact::PowerLaw::sphere(grain, 0.5e-3),
                   .tangential_ratio = contact::mindlin_stiffness_ratio(grain.poisson_ratio),
                   .friction_coefficient = 0.4986},
      .radius = 0.5e-3,
      .grains = 300};

  // 2. One packing without friction, at 10 kPa. Both specimens start from it.
  const dem::Specimen packing = triaxial::frictionless_specimen(recipe).state;

  // 3. Compress both with friction. At three pressures freeze them (no contact slides), and solve the
  //    equilibrium of the contact network.
  const auto dense = compress(packing, triaxial::Density::dense, recipe);
  const auto loose = compress(packing, triaxial::Density::loose, recipe);
  std::printf("           p         e     C_n      z*            G   G/G(uniform strain)\n");
  print("dense", dense);
  print("loose", loose);

  // 4. The reason: s is the sum of two exponents. The first is that of G under uniform strain: 1/3 for
  //    contacts of spheres, and a little more if contacts are added and share the load more evenly. The
  //    second is that of the ratio G/G(uniform strain). A grain with few contacts deviates from the mean
  //    strain, and this lowers the ratio; with more contacts it deviates less. In the loose specimen z* grows
  //    with the pressure, and the ratio grows steeply with z*. In the dense one both are nearly constant.
  std::printf("\nfrom 10 to 100 kPa          s of G   of G(uniform strain)   of their ratio   of z*\n");
  for (const auto* path : {&dense, &loose}) {
    const double s = exponent(*path, &Compressed::shear_modulus);
    const double affine = exponent(*path, &Compressed::uniform_strain);
    std::printf("%-24s %9.3f   %20.3f   %14.3f   %5.3f\n", path == &dense ? "dense" : "loose", s, affine,
                s - affine, exponent(*path, &Compressed::mechanical_coordination_number));
  }

  // 5. Check: nearly the same void ratio, different exponents, and no network stiffer than uniform strain.
  return check(dense, loose);
}

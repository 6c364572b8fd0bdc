// SPDX-License-Identifier: GPL-3.0-or-later
//
// Example 09: does a simulated cyclic shear test give the modulus of the contact network?
//
// A specimen under 50 kPa is frozen (brought to rest, with no contact sliding) and sheared by a strain below
// 1e-8 in three ways. G_hh is the shear modulus of the horizontal plane. G_hv and G_vh are those of a
// vertical plane, sheared by moving one or the other pair of faces; they must be equal. The linear response
// of the contact network gives the same moduli without time steps. The program also prints the upper bound:
// uniform strain, in which all grains move with the mean strain. Takes seconds.
#include <cmath>
#include <cstdio>
#include <numbers>

#include <granum/analysis/measure.hpp>
#include <granum/contact/grains.hpp>
#include <granum/triaxial/probe.hpp>
#include <granum/triaxial/specimen.hpp>

using namespace granum;

int main() {
  // 1. 300 spheres, prepared without friction, then compressed with friction to 50 kPa.
  const contact::GrainMaterial grain{.shear_modulus = 30e9, .poisson_ratio = 0.15};
  const double radius = 0.5e-3;
  const dem::Material material{
      .law = contact::PowerLaw::sphere(grain, radius),
      .tangential_ratio = contact::mindlin_stiffness_ratio(grain.poisson_ratio),
      .friction_coefficient = contact::Friction::from_angle(26.5 * std::numbers::pi / 180).coefficient()};
  const triaxial::SpecimenRecipe recipe{.material = material, .radius = radius, .grains = 300};
  dem::Specimen state = triaxial::start_of_compression(triaxial::frictionless_specimen(recipe).state,
                                                       triaxial::Density::dense, recipe);
  if (!triaxial::isotropic_path(state, material, {50e3}, triaxial::compression_options(),
                                [&](const triaxial::Snapshot& snapshot) {
                                  state = snapshot.state;
                                  return snapshot.report.converged();
                                }))
    return 1;

  // 2. Freeze: the grains come to rest in a fixed cell, and no contact slides. Network and probe then start
  //    from the same state.
  const triaxial::FrozenState frozen = triaxial::freeze_in_place(state, material);
  std::printf("frozen after %zu steps, unbalanced force ratio %.1e\n", frozen.report.steps,
              frozen.report.unbalanced_force_ratio);

  // 3. The network: two stiffness matrices by linear algebra, relaxed (every grain in equilibrium) and affine
  //    (uniform strain).
  const analysis::Measurement measured =
      analysis::measure(dem::contact_network(frozen.state(), material),
                        {.law = material.law, .tangential_ratio = material.tangential_ratio},
                        {.network = network::ResponseOptions{}});
  const network::Response& response = measured.solved_network().response;

  // 4. The probe: a simulation by discrete elements, in three shear modes.
  struct Mode {
    const char* name;
    triaxial::ShearMode mode;
    int index; // row of the Voigt matrix: 3, 4, 5 are the shear components 23, 13, 12
  };
  double worst = 0;
  std::printf("         probe   network   uniform strain [MPa]\n");
  for (const Mode& m : {Mode{"G_hh", triaxial::ShearMode::hh, 5}, Mode{"G_hv", triaxial::ShearMode::hv, 4},
                        Mode{"G_vh", triaxial::ShearMode::vh, 4}}) {
    const triaxial::ProbeResult probe = triaxial::probe(frozen.state(), material, m.mode);
    const double network = response.relaxed().matrix(m.index, m.index);
    std::printf("%s   %7.2f   %7.2f   %7.2f     shear strain %.1e, %zu steps\n", m.name,
                probe.shear_modulus() / 1e6, network / 1e6, response.affine().matrix(m.index, m.index) / 1e6,
                probe.amplitude, probe.steps);
    worst = std::max(worst, std::abs(probe.shear_modulus() / network - 1));
  }

  // 5. Check: probe and network agree within 1 %.
  std::printf("largest difference of probe and network: %.2f %%\n", 100 * worst);
  return worst < 0.01 ? 0 : 1;
}

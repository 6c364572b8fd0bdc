// SPDX-License-Identifier: GPL-3.0-or-later
//
// Example 08: what happens to a dense specimen on the way to failure?
//
// Triaxial compression (TXC) of 400 spheres from 100 kPa to beyond the peak, by the discrete element method:
// the vertical stress grows, the horizontal stress is constant. At many states the specimen is frozen (no
// contact slides) and its contact network solved. Up to about two thirds of the stress ratio at failure the
// specimen keeps its contacts. The modulus then depends on the stress alone, as in the closed form (formula)
// of uniform strain, in which all grains move with the mean strain. After that contacts are lost, the others
// turn towards the larger stress, and G falls although the stress still grows. Takes seconds.
//
// eta = q/p' is the stress ratio, with q the vertical minus the horizontal stress and p' the mean stress. C_n
// is the number of contacts per grain, a the anisotropy of their directions (positive: more vertical ones).
// G_vh is the shear modulus of a vertical plane; ratio is G_vh of the network over that of the closed form.
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <numbers>

#include <granum/analysis/measure.hpp>
#include <granum/contact/grains.hpp>
#include <granum/effective/uniform_field.hpp>
#include <granum/triaxial/probe.hpp>
#include <granum/triaxial/shear_test.hpp>
#include <granum/triaxial/specimen.hpp>

using namespace granum;

int main() {
  // 1. The grains of Chung et al. (2014), in a periodic cell.
  const contact::GrainMaterial grain{.shear_modulus = 30e9, .poisson_ratio = 0.15};
  const double radius = 0.5e-3, degree = std::numbers::pi / 180;
  const dem::Material material{.law = contact::PowerLaw::sphere(grain, radius),
                               .tangential_ratio = contact::mindlin_stiffness_ratio(grain.poisson_ratio),
                               .friction_coefficient =
                                   contact::Friction::from_angle(26.5 * degree).coefficient()};
  const triaxial::SpecimenRecipe recipe{.material = material, .radius = radius, .grains = 400};

  // 2. Dense: no friction until the first pressure is reached, then compression with friction to 100 kPa.
  dem::Specimen state = triaxial::start_of_compression(triaxial::frictionless_specimen(recipe).state,
                                                       triaxial::Density::dense, recipe);
  const bool compressed =
      triaxial::isotropic_path(state, material, {30e3, 100e3}, triaxial::compression_options(),
                               [&](const triaxial::Snapshot& snapshot) {
                                 state = snapshot.state;
                                 return snapshot.report.converged();
                               });
  if (!compressed)
    return 1;

  // 3. Shear at constant inertial number (the strain rate in units of grain size, density and pressure), to
  //    an axial strain of 1 %. A snapshot at each multiple of 0.1 of eta, and of 0.5 % of the axial strain.
  triaxial::ShearTest test(state, material,
                           {.path = stress::ShearPath::txc,
                            .mean_stress = 100e3,
                            .eta_step = 0.1,
                            .strain_step = 0.005,
                            .largest_strain = 0.01});
  std::printf("  eta   strain    C_n      a     G_vh network   uniform strain [MPa]   ratio\n");
  double first_ratio = 0, smallest_early = 1e9, largest_early = 0, last_G = 0, largest_G = 0;
  while (test.advance() == triaxial::ShearEvent::snapshot) {
    // 4. A frozen copy gives the network and the stress. The closed form uses this stress, and the void
    //    ratio, contacts and fabric of the specimen itself.
    const dem::Specimen now = test.engine().state();
    const triaxial::FrozenState frozen = triaxial::freeze_in_place(now, material);
    const analysis::Given given{.law = material.law, .tangential_ratio = material.tangential_ratio};
    const double G_vh = analysis::measure(dem::contact_network(frozen.state(), material), given,
                                          {.network = network::ResponseOptions{}})
                            .solved_network()
                            .G_vh();
    const analysis::Microstructure micro =
        analysis::measure(dem::contact_network(now, material), given).microstructure();
    const double closed =
        effective::uniform_strain({.law = material.law,
                                   .tangential_ratio = material.tangential_ratio,
                                   .radius = radius,
                                   .void_ratio = dem::void_ratio(now),
                                   .coordination_number = micro.coordination_number,
                                   .fabric_anisotropy = micro.fabric_anisotropy,
                                   .stress_v = frozen.stress()(2, 2),
                                   .stress_h = (frozen.stress()(0, 0) + frozen.stress()(1, 1)) / 2})
            .stiffness.G_vh();
    const double ratio = G_vh / closed, eta = test.now().stress.ratio();
    std::printf("%5.2f  %.5f  %5.2f  %6.3f     %8.1f        %8.1f            %.3f\n", eta,
                test.now().axial_strain, micro.coordination_number, micro.fabric_anisotropy, G_vh / 1e6,
                closed / 1e6, ratio);
    if (first_ratio == 0)
      first_ratio = ratio;
    if (std::abs(test.now().axial_strain) < 0.002 && eta < 0.65) {
      smallest_early = std::min(smallest_early, ratio);
      largest_early = std::max(largest_early, ratio);
    }
    largest_G = std::max(largest_G, G_vh);
    last_G = G_vh;
  }
  const double angle = stress::mobilised_friction_angle(test.peak().stress) / degree;
  std::printf("peak: eta = %.3f, friction angle %.1f degrees (26.0 in the paper)\n",
              test.peak().stress.ratio(), angle);

  // 5. Check: up to eta = 0.65 and 0.2 % of axial strain the ratio of network and closed form changes by less
  //    than 5 %; at the end G has fallen by more than 20 % from its maximum; the friction angle is that of a
  //    dense packing.
  const bool same_share = largest_early / smallest_early < 1.05;
  const bool falls = last_G < 0.8 * largest_G;
  return same_share && falls && angle > 22 && angle < 32 ? 0 : 1;
}

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <cstdint>
#include <numbers>
#include <string>
#include <string_view>
#include <vector>

#include <granum/contact/power_law.hpp>
#include <granum/stress/shear_path.hpp>
#include <granum/triaxial/specimen.hpp>

namespace granum::verify {

/// Contact shapes that a study can take up.
enum class Shape { cone, sphere, flat, power_law };

[[nodiscard]] std::string_view name(Shape shape);
[[nodiscard]] std::string_view name(triaxial::Density density);

/// What `granum verify` and `granum reproduce` run. The defaults are the paper's grains (Table 1) with the
/// two lengths that the paper does not print: the cone's slope and the punch radius that agree with its
/// Table 5.                                                                                    [Chung2014]
struct Scene {
  double radius = 0.5e-3;                                  ///< R [m]
  double grain_shear_modulus = 30e9;                       ///< G_g [Pa]
  double grain_poisson_ratio = 0.15;                       ///< nu_g [1]
  double friction_angle = 26.5 * std::numbers::pi / 180.0; ///< between grains [rad]
  double density = 2650;                                   ///< of the grains [kg/m^3]
  double tangential_ratio = -1;                            ///< k_t/k_n [1]; negative: 2(1-nu)/(2-nu)

  std::vector<Shape> contacts{Shape::cone, Shape::sphere, Shape::flat};
  double cone_slope = 0.4;         ///< A_1 [1]
  double punch_radius = 5.7e-6;    ///< a of the flat contact [m]
  double alpha = 1.5;              ///< of the power-law contact [1]
  double profile_constant = 180.0; ///< A_alpha of the power-law contact [m^(1-alpha)]

  std::vector<triaxial::Density> densities{triaxial::Density::dense, triaxial::Density::loose};
  std::size_t grains = 1000;
  std::size_t seeds = 1;        ///< specimens of each kind
  std::uint64_t first_seed = 1; ///< they take first_seed, first_seed + 1, ...
  double expansion_void_ratio = 0.56;
  double unjamming_strain = 0.003;
  double agitation = 0.03;

  std::vector<double> pressures{10e3, 20e3, 30e3, 40e3, 50e3, 60e3, 70e3, 80e3, 90e3, 100e3}; ///< rising [Pa]
  std::vector<double> probe_pressures{10e3, 30e3, 100e3}; ///< some of the pressures [Pa]

  // What the paper's experiment adds; the isotropic study leaves it out.
  bool walls = false;       ///< six rigid walls in place of the periodic cell
  double wall_friction = 0; ///< mu >= 0 between grains and walls [1]
  std::vector<stress::ShearPath> paths{stress::all_shear_paths.begin(), stress::all_shear_paths.end()};
  double inertial_number = 2e-4; ///< of shearing [1]
  double eta_step = 0.05;        ///< the specimen is frozen at multiples of this eta ...
  double strain_step = 0.0025;   ///< ... and of this axial strain
  double largest_strain = 0.03;  ///< axial, where a path ends [1]
  double probe_eta_step = 0.25;  ///< cyclic shear by DEM at multiples of this eta; 0: nowhere
  double loop_strain = 1e-5;     ///< of the cycles of shear with friction; 0: none

  /// Specimens that run side by side; 0: as many as the machine has cores. The results do not depend on it.
  std::size_t threads = 0;
};

/// \throws InvalidArgument naming the value that no study can have.
void require_valid(const Scene& scene);

/// scene.threads, or the number of cores where that is 0.
[[nodiscard]] std::size_t thread_count(const Scene& scene);

[[nodiscard]] contact::PowerLaw law(const Scene& scene, Shape shape);
[[nodiscard]] triaxial::SpecimenRecipe recipe(const Scene& scene, Shape shape, std::uint64_t seed);

} // namespace granum::verify

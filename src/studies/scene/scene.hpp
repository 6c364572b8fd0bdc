// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <cstdint>
#include <numbers>
#include <optional>
#include <string_view>
#include <vector>

#include <granum/contact/laws.hpp>
#include <granum/sizes/distribution.hpp>
#include <granum/stress/stress.hpp>
#include <granum/triaxial/specimen.hpp>

/// Input of `granum verify`, `reproduce`, `trade`, `plan` and `export`. The defaults are the paper's grains
/// (Table 1) with the two lengths that the paper does not print: the cone's slope and the punch radius that
/// agree with its Table 5 (contact/laws.hpp). The meaning of each value, its range and the commands that use
/// it: scene_keys.hpp. [Chung2014]
namespace granum::studies {

[[nodiscard]] std::string_view name(triaxial::Density density);

/// Spheres of one material.
struct GrainSection {
  double radius = 0.5e-3;                                   ///< R, of all or their mean by number [m]
  sizes::Distribution sizes = sizes::Distribution::equal(); ///< of the radii over R
  double shear_modulus = 30e9;                              ///< G_g [Pa]
  double poisson_ratio = 0.15;                              ///< nu_g [1]
  double friction_angle = 26.5 * std::numbers::pi / 180.0;  ///< between grains [rad]
  double density = 2650;                                    ///< of the grains [kg/m^3]
};

/// Contacts between grains.
struct ContactSection {
  std::optional<double> tangential_ratio = {}; ///< k_t/k_n [1]; not given: Mindlin's 2(1-nu)/(2-nu)
  contact::LawNumbers numbers = {};            ///< of contact laws, by their keys
};

/// Which specimens there are, and at which pressures they are measured.
struct StudySection {
  std::vector<contact::Shape> contacts{contact::Shape::cone, contact::Shape::sphere, contact::Shape::flat};
  std::vector<triaxial::Density> densities{triaxial::Density::dense, triaxial::Density::loose};
  std::size_t grains = 1000;
  std::size_t seeds = 1;        ///< specimens of each kind
  std::uint64_t first_seed = 1; ///< seeds are first_seed, first_seed + 1, ...
  /// Specimens that run side by side; 0: as many as the machine has cores. The results do not depend on it.
  std::size_t threads = 0;
  std::vector<double> pressures{10e3, 20e3, 30e3, 40e3, 50e3, 60e3, 70e3, 80e3, 90e3, 100e3}; ///< rising [Pa]
  std::vector<double> probe_pressures{10e3, 30e3, 100e3}; ///< some of the pressures [Pa]
};

/// Boundaries and preparation of a specimen.
struct SpecimenSection {
  bool walls = false;       ///< six rigid walls in place of the periodic cell
  double wall_friction = 0; ///< mu >= 0 between grains and walls [1]
  double expansion_void_ratio = 0.56;
  double unjamming_strain = 0.003;
  double agitation = 0.03;
};

/// Shear along paths, for the paper's experiment.
struct ShearSection {
  std::vector<stress::ShearPath> paths{stress::all_shear_paths.begin(), stress::all_shear_paths.end()};
  double inertial_number = 2e-4; ///< of shearing [1]
  double eta_step = 0.05;        ///< the specimen is frozen at multiples of this eta ...
  double strain_step = 0.0025;   ///< ... and of this axial strain
  double largest_strain = 0.03;  ///< axial, where a path ends [1]
  double probe_eta_step = 0.25;  ///< cyclic shear by DEM at multiples of this eta; 0: nowhere
  double loop_strain = 1e-5;     ///< of the cycles of shear with friction; 0: none
};

struct Scene {
  GrainSection grain;
  ContactSection contact;
  StudySection study;
  SpecimenSection specimen;
  ShearSection shear;
};

/// Every key within its range (scene_keys.hpp), the lists in order, and contacts that neither vanish in the
/// rounding of positions nor close the voids: predicted_overlap at every pressure of the scene lies between
/// least_predicted_overlap and largest_predicted_overlap.
/// \throws   InvalidArgument naming the key that no study can have, its value, unit and range
/// Checked by tests/studies/test_scene.cpp
void require_valid(const Scene& scene);

/// \throws   InvalidArgument naming specimen.boundary, if the scene has walls: for studies that measure in
///           the periodic cell alone
void require_periodic_cell(const Scene& scene);

/// A specimen of a scene, and the packing that it starts from: one for each contact and seed.
struct SpecimenName {
  contact::Shape contact;
  triaxial::Density density;
  std::uint64_t seed;
  std::size_t packing; ///< its number, from 0
};
/// In the order contact, density, seed.
[[nodiscard]] std::vector<SpecimenName> specimens_of(const Scene& scene);

/// Number of threads: as given, or one per core if 0.
[[nodiscard]] std::size_t thread_count(std::size_t asked);
/// The same of scene.study.threads.
[[nodiscard]] std::size_t thread_count(const Scene& scene);

/// k_t/k_n of the scene, or Mindlin's value for its grains [1]; 0 where no contact has friction.
[[nodiscard]] double tangential_ratio(const Scene& scene);
[[nodiscard]] contact::NormalLaw law(const Scene& scene, contact::Shape shape);
[[nodiscard]] triaxial::SpecimenRecipe recipe(const Scene& scene, contact::Shape shape, std::uint64_t seed);

/// Overlap of two grains over their diameter, under the mean force f = 4 pi R^2 (1+e) p/C_n of a dense
/// packing of the paper's spheres (e = 0.558, C_n = 5.73) at a pressure p [Pa].
/// Accuracy  a factor of two: for judging whether a scene can be run, before it is.
[[nodiscard]] double predicted_overlap(const Scene& scene, contact::Shape shape, double pressure);

/// b = d ln k_n/d ln f of a shape's contacts: if b changes with the force, at the mean force of
/// such a packing half-way between the lowest and the highest pressure of the scene, on a logarithmic scale.
[[nodiscard]] double contact_exponent(const Scene& scene, contact::Shape shape);

/// Between these a packing can be compressed. Below, rounding of positions is felt in the forces: dense
/// spheres at 1.1e-9 do not come to rest. Above, the voids close: at 0.095 dense specimens have e = 0.16 to
/// 0.26.
inline constexpr double least_predicted_overlap = 1e-9;
inline constexpr double largest_predicted_overlap = 0.1;

} // namespace granum::studies

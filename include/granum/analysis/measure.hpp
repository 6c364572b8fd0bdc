// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <vector>

#include <granum/analysis/measurement.hpp>
#include <granum/packing/assembly.hpp>
#include <granum/packing/stiffness.hpp>
#include <granum/stress/stress.hpp>

/// The one way from a packing to its numbers.
/// Checked by tests/analysis/test_measure.cpp, tests/studies/test_measured_frame.cpp
namespace granum::analysis {

/// Known properties of a packing that are not in the assembly.
struct Given {
  /// Of all contacts, as one knows it of own specimens of equal grains: no material is looked for then.
  std::optional<contact::NormalLaw> law = {};
  LawFamily law_family =
      contact::PowerLaw::sphere;                  ///< else: the law of two grains of a material and a radius
  std::optional<double> grain_shear_modulus = {}; ///< G_g [Pa]; without it, from forces against overlaps
  std::optional<double> grain_density = {};       ///< rho_s [kg/m3], > 0; without it no wave speeds
  double grain_poisson_ratio = 0.15;              ///< nu_g [1]
  bool law_assumed = false; ///< law_family is a default: linear springs are used if the forces show them
  std::vector<contact::GrainMaterial> materials = {}; ///< of each grain, where there are several; spheres
  /// k_t/k_n [1], of contacts with adhesion over 2 E* a; without it that of the stiffnesses in the assembly,
  /// or contact::mindlin_stiffness_ratio
  std::optional<double> tangential_ratio = {};
  /// Of spheres: k_n and k_t of the network are those of JKR or DMT contacts, the closed forms are of Hertz'.
  /// It needs grain_shear_modulus or materials.
  std::optional<contact::Adhesion> adhesion = {};
  std::optional<packing::TurningSpring> rolling = {};  ///< of all contacts; without it as they have it
  std::optional<packing::TurningSpring> twisting = {}; ///< likewise
  std::optional<double> friction_coefficient = {};     ///< [1]; without it estimate_friction
  std::optional<packing::StiffnessFrom> stiffness_from =
      {};                                ///< without it overlaps, or forces if those have few digits
  bool contact_moments = false;          ///< contacts carry moments of unknown stiffness
  bool normal_forces = true;             ///< the contacts hold them
  bool tangential_forces = true;         ///< the contacts hold them
  double force_rounding = 0;             ///< unbalanced force due to few digits, over the mean force [1]
  double overlap_rounding = 0;           ///< by so much overlaps may be off, by the digits of the files [m]
  std::vector<long> type = {};           ///< of each grain, where materials may differ by type; else empty
  std::optional<double> void_ratio = {}; ///< where it is known better than by a sum over the grains
  std::optional<stress::AxialStress> stress =
      {}; ///< of the closed forms' state; without it that of the contacts
};

/// An upright box, in the axes of the packing.
struct Window {
  Vec3 low;  ///< [m]
  Vec3 high; ///< [m]
};

/// Parts to measure. Volume, sizes, counts, stress, fabric tensor and a always are; they take a thousandth of
/// the time of the network.
struct Wanted {
  bool fabric_tests = false;                  ///< most likely a and the tests of the fabric
  std::optional<std::size_t> rose_bins = {};  ///< rose of contact normals, so many bins of [0, 90 degrees]
  std::optional<std::size_t> force_bins = {}; ///< distribution and moments of the forces, friction, unbalance
  bool law_check = false;                     ///< forces against overlaps
  bool work = false;                          ///< the pressure by the work of the cell
  bool closed_forms = false;                  ///< rungs 0 to 3 and uniform stress
  std::optional<double> interior_layer = {};  ///< left out at each wall [m]
  std::optional<Window> window = {};          ///< else: a part of the packing to look at
  std::optional<network::ResponseOptions> network = {}; ///< rung 4, which takes most of the time
};

/// All parts but those that need walls or a known law.
[[nodiscard]] Wanted everything();

/// Measures a packing.
/// Assumes   axis 3 is vertical, the axis of symmetry of the closed forms; contacts transmit friction.
/// \return   the network has the stiffnesses of the contacts if any contact has one (and given.stiffness_from
///           does not say otherwise), else those of the law
/// \throws   InvalidArgument for an assembly that is not valid, has no grains or lies in one plane (a packing
///           in two dimensions), or for values given or wanted that are out of their ranges
/// Accuracy  as the functions for each part.
[[nodiscard]] Measurement measure(const packing::Assembly& assembly, const Given& given = {},
                                  const Wanted& wanted = {});

/// The assembly whose contact network measure() solves, for network::stiffness_matrix and lowest_modes.
/// \return   with k_n and k_t of its contacts as the files have them, else those of the law or of the forces
/// \throws   InvalidArgument as measure, and if the stiffnesses follow from nothing given
/// Checked by tests/analysis/test_measure.cpp
[[nodiscard]] packing::Assembly stiffened(const packing::Assembly& assembly, const Given& given = {});

/// Directions of contact normals alone, where that is all there is.
/// \param    normals   at least 2 unit vectors
/// \throws   InvalidArgument as fabric::rose and fabric::estimate_anisotropy
[[nodiscard]] Fabric measure_fabric(std::span<const Vec3> normals, const Wanted& wanted);

/// Forces of an assembly's contacts; moments, friction and sliding are of those that press.
/// \throws   InvalidArgument for an assembly that require_valid rejects, or for a friction coefficient or
///           bins out of range
[[nodiscard]] Forces measure_forces(const packing::Assembly& assembly, const Given& given, std::size_t bins);

} // namespace granum::analysis

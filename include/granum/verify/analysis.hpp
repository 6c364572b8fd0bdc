// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include <granum/assembly/coordination.hpp>
#include <granum/assembly/force_distribution.hpp>
#include <granum/assembly/force_moments.hpp>
#include <granum/assembly/sliding.hpp>
#include <granum/assembly/stress.hpp>
#include <granum/effective/state.hpp>
#include <granum/elastic/isotropic.hpp>
#include <granum/elastic/symmetry.hpp>
#include <granum/elastic/transverse_isotropic.hpp>
#include <granum/fabric/anisotropy_estimate.hpp>
#include <granum/fabric/goodness_of_fit.hpp>
#include <granum/fabric/likelihood_estimate.hpp>
#include <granum/fabric/rose.hpp>
#include <granum/io/imported_packing.hpp>
#include <granum/io/packing_csv.hpp>
#include <granum/io/stiffness.hpp>
#include <granum/network/linear_response.hpp>
#include <granum/verify/law_check.hpp>

/// All that one state of a packing tells, whatever code wrote it: what `granum analyse` prints.
/// Checked by tests/verify/test_analysis.cpp
namespace granum::verify {

/// What files do not hold and a user may know.
struct AnalysisOptions {
  LawFamily law = contact::PowerLaw::sphere;
  std::optional<double> grain_shear_modulus = {}; ///< G_g [Pa]; without it, from forces against overlaps
  double grain_poisson_ratio = 0.15;              ///< nu_g [1]
  std::optional<double> tangential_ratio = {}; ///< k_t/k_n [1]; without it contact::mindlin_stiffness_ratio
  std::optional<double> friction_coefficient = {}; ///< [1]; without it estimate_friction
  std::optional<io::StiffnessFrom> stiffness_from =
      {}; ///< without it overlaps, or forces if those have few digits
  network::Options network = {};
  bool solve_network = true; ///< rung 4, the part that takes time
  std::size_t rose_bins = 18;
  std::size_t force_bins = 32;
};

/// Grains and contacts, counted.
struct CountAnalysis {
  std::size_t grains = 0;
  std::size_t contacts = 0;
  std::size_t wall_contacts = 0;
  std::size_t without_contact = 0;           ///< grains that touch no other
  double coordination_number = 0;            ///< C_n = 2 N_c/N, all grains
  double touching_coordination_number = 0;   ///< the same over the grains with a contact
  double coordination_number_with_walls = 0; ///< (2 N_c + N_w)/N
  MechanicalCoordination mechanical = {};    ///< z* and rattlers
};

/// Directions of the contacts.
struct FabricAnalysis {
  std::size_t contacts = 0;
  Mat3 tensor = {}; ///< F_ij
  fabric::AnisotropyEstimate by_moment = {};
  fabric::LikelihoodEstimate by_likelihood = {};
  fabric::IsotropyTest isotropy = {};              ///< is a different from 0?
  std::optional<fabric::DensityTest> density = {}; ///< does E(gamma; a) describe it? From 20 contacts on
  std::optional<fabric::AxisymmetryTest> axisymmetry = {}; ///< is axis 3 one of symmetry? From 20 contacts on
  std::vector<fabric::RoseBin> rose = {};                  ///< beside E(gamma; a) of the most likely a
};

/// Directions of contact normals alone, where that is all there is.
/// \param    normals   at least 2 unit vectors
/// \throws   InvalidArgument as fabric::rose and fabric::estimate_anisotropy
[[nodiscard]] FabricAnalysis analyse_fabric(std::span<const Vec3> normals, std::size_t rose_bins = 18);

/// Forces of the contacts.
struct ForceAnalysis {
  ForceDistribution distribution = {};
  double Z_2 = 0;   ///< <f_n^2>/<f_n>^2 of the pressing contacts
  double Z_5_3 = 0; ///< <f_n^(5/3)>/<f_n>^(5/3), elastic energy of Hertz contacts
  std::optional<double> mean_tangential_over_normal = {}; ///< mean f_t over mean f_n, pressing contacts
  std::optional<FrictionEstimate> friction = {};
  std::optional<double> sliding_fraction = {}; ///< at the coefficient given, or else estimated
  Unbalance unbalance = {};
};

/// Frozen contact network, rung 4.
struct NetworkAnalysis {
  network::Response::Report report = {};
  elastic::VoigtStiffness relaxed = {};     ///< every grain in equilibrium [Pa]
  elastic::VoigtStiffness affine = {};      ///< uniform strain of this very network [Pa]
  elastic::SymmetryDistances symmetry = {}; ///< of relaxed
  BulkModulusBounds bulk_bounds = {};
};

/// What one state tells. Parts that need what the files do not hold are empty, and `missing` says why.
struct Analysis {
  long step = 0;
  std::optional<double> time = {}; ///< [s]
  double volume = 0;               ///< [m^3]
  double void_ratio = 0;
  double smallest_radius = 0;   ///< [m]
  double largest_radius = 0;    ///< [m]
  double equivalent_radius = 0; ///< <R^3>/<R^2>: of equal spheres with the same prefactor P [m]
  CountAnalysis counts = {};
  std::optional<FabricAnalysis> fabric = {};
  std::optional<ForceAnalysis> forces = {};
  std::optional<ContactStress> stress = {};
  std::optional<LawCheck> law_check = {};
  std::optional<contact::GrainMaterial> grain = {}; ///< given, or with G_g as the forces show it
  /// What the closed forms are asked: measured C_n, e, a and stress, and the contact law.
  std::optional<effective::State> state = {};
  std::optional<NetworkAnalysis> network = {};
  std::vector<std::string> notes = {};    ///< what was assumed or not there, a sentence each
  std::vector<std::string> warnings = {}; ///< what ruins comparisons, a sentence each
};

/// Works out all that a packing tells.
/// Assumes   axis 3 is vertical, the axis of symmetry of the closed forms.
/// \throws   InvalidArgument for options out of their ranges
[[nodiscard]] Analysis analyse(const io::ImportedPacking& packing, const AnalysisOptions& options = {});

/// The same for a table of contacts without grains: directions, and forces where the table has them.
/// \throws   InvalidArgument for options out of their ranges
[[nodiscard]] Analysis analyse_contacts(const io::ContactTable& table, const AnalysisOptions& options = {});

} // namespace granum::verify

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include <granum/analysis/law_check.hpp>
#include <granum/analysis/parts.hpp>
#include <granum/effective/rungs.hpp>
#include <granum/effective/state.hpp>
#include <granum/elastic/isotropic.hpp>
#include <granum/elastic/stiffness.hpp>
#include <granum/elastic/waves.hpp>
#include <granum/fabric/estimates.hpp>
#include <granum/network/linear_response.hpp>
#include <granum/packing/assembly.hpp>
#include <granum/packing/coordination.hpp>
#include <granum/packing/forces.hpp>
#include <granum/sizes/contact_means.hpp>
#include <granum/sizes/distribution.hpp>

/// Measurements of one packing, for granum's own specimens and imported ones alike.
namespace granum::analysis {

/// Sizes of the grains.
struct Sizes {
  double smallest = 0;   ///< radius [m]
  double largest = 0;    ///< radius [m]
  double equivalent = 0; ///< <R^3>/<R^2> [m]: the radius that the contact means refer to
  sizes::Gradation gradation = {};
  /// Of the contacts between grains as they were counted, with l = R_i + R_j; those of equal grains where
  /// there is no contact.
  sizes::ContactMeans contacts = {};
};

/// Grains and contacts, counted.
struct Counts {
  std::size_t grains = 0;
  std::size_t bodies = 0; ///< rigid bodies; grains if each is its own. The numbers below count them
  std::size_t contacts = 0;
  std::size_t wall_contacts = 0;
  std::size_t without_contact = 0;           ///< grains that touch no other
  double coordination_number = 0;            ///< C_n = 2 N_c/N, all grains
  double coordination_error = 0;             ///< its standard error, by the scatter of the grains' numbers
  double touching_coordination_number = 0;   ///< C_n over the grains with a contact
  double coordination_number_with_walls = 0; ///< (2 N_c + N_w)/N
  double sliding_fraction = 0;               ///< of the contacts (Contact::sliding); 0 without contacts
  packing::MechanicalCoordination mechanical = {}; ///< z* and rattlers
};

/// Directions of the contacts. The tests are there where they were wanted.
struct Fabric {
  std::size_t contacts = 0;
  Mat3 tensor = {}; ///< F_ij
  fabric::AnisotropyEstimate by_moment = {};
  std::optional<fabric::LikelihoodEstimate> by_likelihood = {};
  std::optional<fabric::IsotropyTest> isotropy = {}; ///< is a different from 0?
  std::optional<fabric::DensityTest> density = {};   ///< does E(gamma; a) describe it? From 20 contacts on
  std::optional<fabric::AxisymmetryTest> axisymmetry = {}; ///< is axis 3 one of symmetry? From 20 contacts on
  std::vector<fabric::RoseBin> rose = {}; ///< beside E(gamma; a) of the most likely a, of a = 0 without it
};

/// Forces of the contacts.
struct Forces {
  packing::ForceDistribution distribution = {};
  double Z_2 = 0;   ///< <f_n^2>/<f_n>^2 of the pressing contacts
  double Z_5_3 = 0; ///< <f_n^(5/3)>/<f_n>^(5/3), elastic energy of Hertz contacts
  /// Q, effective::Unevenness, which rung 3 takes into account; where the contact law is known.
  std::optional<double> unevenness = {};
  std::optional<double> mean_tangential_over_normal = {}; ///< mean f_t over mean f_n, pressing contacts
  /// a of the pressing contacts whose normal force is above the mean, and of the others; from 2 contacts on.
  /// Strong ones carry the deviator of a sheared packing, weak ones may lean the other way.    [Radjai1998]
  std::optional<fabric::AnisotropyEstimate> strong = {}, weak = {};
  std::optional<packing::FrictionEstimate> friction = {};
  std::optional<double> sliding_fraction = {};      ///< at the coefficient given, or else estimated
  std::optional<packing::Unbalance> unbalance = {}; ///< where the tangential forces are known
  std::optional<packing::Weight> weight = {};       ///< if it explains the unbalanced forces
};

/// A stiffness of the network as the axes of the packing show it; no symmetry is assumed.
struct NetworkMatrix {
  elastic::VoigtStiffness stiffness;
  elastic::SymmetryDistances symmetry = {}; ///< zeros if it is zero
  elastic::EngineeringModuli moduli = {};
  /// Along axes 1, 2 and 3; empty unless the density is known and the matrix is positive semidefinite.
  std::optional<std::array<elastic::PlaneWaves, 3>> waves = {};
};

/// Quantities derived from a stiffness.
/// \param    bulk_density   of the packing [kg/m3], > 0, where it is known
/// \throws   InvalidArgument if an entry is not finite, or for another density
/// Checked by tests/analysis/test_measure.cpp
[[nodiscard]] NetworkMatrix network_matrix(const elastic::VoigtStiffness& stiffness,
                                           const std::optional<double>& bulk_density = {});

/// The contact network, rung 4.
struct Network {
  network::Response response; ///< affine and relaxed stiffness, and the status of the solution
  NetworkMatrix affine = {};
  NetworkMatrix affine_all = {}; ///< those of rattlers too
  NetworkMatrix relaxed = {};    ///< of the last iterate, where the network was not solved
  packing::BulkModulusBounds bulk_bounds = {};

  /// The nearest isotropic solids.
  /// \throws   NotConverged (relaxed) unless the network is solved
  [[nodiscard]] elastic::Isotropic isotropic_relaxed() const;
  [[nodiscard]] elastic::Isotropic isotropic_affine() const;
  /// Shear moduli of the relaxed network in the horizontal plane, and the mean of both vertical ones [Pa].
  /// \throws   NotConverged unless the network is solved
  [[nodiscard]] double G_hh() const;
  [[nodiscard]] double G_vh() const;
};

/// Result of a closed-form rung for the state of a packing, or the reason why there is none.
struct ClosedForm {
  const effective::Rung* rung = nullptr; ///< its row of the table
  std::optional<effective::RungAnswer> answer = {};
  std::string refusal = {}; ///< empty if there is an answer
};

/// Results of all closed forms of the table of rungs for a state, in its order.
[[nodiscard]] std::vector<ClosedForm> closed_forms(const effective::State& packing);

/// Measurements of one packing. Parts that were not requested, or lack input, are empty; `notes` list what
/// was missing.
struct Measurement {
  double volume = 0;     ///< of the cell [m^3]
  double void_ratio = 0; ///< of the whole cell
  Sizes sizes = {};
  Counts counts = {};
  std::optional<Fabric> fabric = {};                 ///< from 2 contacts on
  std::optional<InteriorMeasures> interior = {};     ///< between walls
  std::optional<packing::ContactStress> stress = {}; ///< by the contact forces
  std::optional<double> bulk_density = {};           ///< dry, if that of the grains is given [kg/m3]
  std::optional<double> pressure_by_work = {};       ///< by the work of the cell [Pa]
  std::optional<Forces> forces = {};
  /// Why closed forms for spheres do not apply: contacts that carry moments, or rigid bodies of several
  /// grains. Empty if they do.
  std::string moments = {};
  std::optional<LawCheck> law_check = {};
  std::optional<contact::GrainMaterial> grain = {}; ///< given, or with G_g as the forces show it
  std::optional<contact::NormalLaw> law = {};       ///< of contacts of grains of the equivalent radius
  /// Input of the closed forms: C_n, e and a, of the interior between walls, stress and contact law.
  std::optional<effective::State> state = {};
  /// As effective::closed_forms(); empty without a state. K of rung 3 is within the bounds of the network. Of
  /// an interior of few grains, the errors of rung 3 are those of the whole packing's moduli, and larger.
  std::vector<ClosedForm> closed_forms = {};
  std::optional<Network> network = {}; ///< empty if no grain carries load
  std::vector<std::string> notes = {}; ///< assumptions and missing data, a sentence each

  /// C_n, z*, rattlers, a and sliding: of the interior where it was measured, else of all grains.
  /// \throws   InvalidArgument for fewer than 2 contacts, which have no fabric
  [[nodiscard]] Microstructure microstructure() const;
  /// Its void ratio.
  [[nodiscard]] double interior_void_ratio() const { return interior ? interior->void_ratio : void_ratio; }
  /// Result of a closed form; empty if it was not requested or has none.
  [[nodiscard]] std::optional<effective::RungAnswer> closed_form(effective::RungName name) const;
  /// The requested network.
  /// \throws   NotConverged if no grain carries load, so that there is no network
  [[nodiscard]] const Network& solved_network() const;
};

/// Moves K of rung 3, an estimate, into the bounds of the network, with a note; its shear moduli stay. Rungs
/// below are formulas of one motion and are compared with the network as they are. Nothing without a network,
/// or where an interior was measured.
/// Checked by tests/analysis/test_measure.cpp
void keep_within_bounds(Measurement& measurement);

} // namespace granum::analysis

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <utility>
#include <vector>

#include <granum/core/stop.hpp>
#include <granum/elastic/stiffness.hpp>
#include <granum/packing/assembly.hpp>

/// Rung 4: the elastic response of a given contact network, by linear algebra instead of time stepping.
namespace granum::network {

/// Behaviour of a contact at the Coulomb limit in a small probe.
enum class SlidingContacts {
  stick,  ///< keeps its k_t: the probe unloads it
  release ///< k_t = 0: it continues to slip
};

struct ResponseOptions {
  SlidingContacts sliding = SlidingContacts::stick;
  /// Adds the stiffness -(f_n/l)(1 - n n) for the relative displacement of two centres, and the rotation of
  /// wall forces. For networks without tangential stiffness only: the rotation of lever arms is missing, so
  /// grains with two frictional contacts come out unstable. force_terms includes it.
  bool prestress = false;
  bool force_terms = false;        ///< compute Response::force_terms; not for assemblies between walls
  bool motions = false;            ///< keep Response::motions
  double tolerance = 1e-10;        ///< in (0, 1): Report::residual at most
  int iteration_limit = 20000;     ///< >= 1
  std::size_t threads = 1;         ///< >= 1, including the calling one; same bits for any number
  StopRequest stop_requested = {}; ///< checked before every iteration
};

enum class Status {
  converged,
  iteration_limit,       ///< tolerance not reached: too few iterations, or rounding does not allow it
  not_positive_definite, ///< the network is unstable: the prestress term outweighs the contact stiffness
  stopped                ///< by options.stop_requested
};

/// Contribution of the contact forces to the stiffness, to first order in f/(k_n l), for the motions of
/// Response::relaxed [Pa]. A test that measures Cauchy stress, such as triaxial::probe, finds the sum of
/// relaxed() and both parts. For contacts between grains of any size, and forces in equilibrium.
struct ForceTerms {
  /// Rotation of the forces with their contacts, change of lever arms and of the cell. If it is not small
  /// beside relaxed(), some motion is so soft that forces matter as much as stiffness, and the sum is not
  /// valid.
  elastic::VoigtStiffness geometric;
  /// A contact that unloads loses tangential force as its k_t falls, and does not regain it on loading: the
  /// mean of both. For k_n as a power of the overlap and a constant k_t/k_n, as in dem::Engine.
  elastic::VoigtStiffness shedding;
};

/// Motion of one grain: the unknowns of a network, both of the dimension of a length.
struct GrainMotion {
  Vec3 displacement; ///< u, of the centre [m]
  Vec3 turn;         ///< R w, radius times rotation; of a body the radius of packing::bodies [m]
};
/// Motions under the six unit strains, in the order 11 22 33 23 13 12 with engineering shear strains; in each
/// one element a grain, or a body if grains form bodies.
using StrainMotions = std::array<std::vector<GrainMotion>, 6>;

/// Affine and relaxed stiffness of a contact network, with a report of the solution. Compression positive.
class [[nodiscard]] Response {
 public:
  struct Report {
    Status status = Status::converged;
    std::size_t grains = 0;   ///< grains that carry load (without rattlers)
    std::size_t contacts = 0; ///< between them
    std::size_t wall_contacts = 0;
    int unknowns_per_grain =
        0;              ///< 6; 3 if no contact has tangential stiffness, because spins do not matter then
    int iterations = 0; ///< sum over all factors tried
    /// Residual force over affine force in the worst load case, recomputed at the end. If the affine forces
    /// cancel on every grain, as in a lattice: over 1e-3 of the contact forces. With contacts that count as
    /// rigid and are not: the change of C if they become ten times softer.
    double residual = 0;
    double symmetry_residual = 0;    ///< largest |C_ab - C_ba| over largest |C_ab|, before C was symmetrised
    std::size_t factor_nonzeros = 0; ///< numbers stored by the preconditioner
    std::size_t mended_pivots =
        0; ///< pivots that were not safely positive and were modified; costs iterations, not accuracy
  };

  Response(const elastic::VoigtStiffness& affine, const elastic::VoigtStiffness& relaxed,
           const Report& report, const std::optional<ForceTerms>& force_terms = {},
           StrainMotions motions = {})
      : affine_(affine), relaxed_(relaxed), force_terms_(force_terms), motions_(std::move(motions)),
        report_(report) {}

  [[nodiscard]] const Report& report() const { return report_; }
  [[nodiscard]] bool converged() const { return report_.status == Status::converged; }

  /// Uniform strain without spin: the sum over the contacts of the load-bearing network [Pa].
  [[nodiscard]] const elastic::VoigtStiffness& affine() const { return affine_; }
  /// Every grain in equilibrium [Pa].
  /// \throws   Stopped if the solution was stopped; NotConverged unless converged().
  [[nodiscard]] const elastic::VoigtStiffness& relaxed() const;
  /// For the last iterate. Empty unless options.force_terms, and for a packing without network.
  /// Accuracy  of the sum beside DEM probes, 1,000 grains: dense 0.01 % rms, 0.16 % at worst; loose 0.2 %
  ///           rms, 0.8 % at worst.
  /// Checked by tests/network/test_force_terms.cpp, tests/studies/test_study.cpp
  [[nodiscard]] const std::optional<ForceTerms>& force_terms() const { return force_terms_; }
  /// What the grains of relaxed() do beside the uniform strain, for a unit of each strain [m]: q = -H^+ W,
  /// but for motions without stiffness, which are added in any amount. Their mean displacement is zero
  /// unless walls hold the network; zero for grains that carry no load. Empty unless options.motions.
  /// \throws   as relaxed()
  /// Checked by tests/network/test_stiffness_matrix.cpp
  [[nodiscard]] const StrainMotions& motions() const;
  /// The same of the last iterate, converged or not, moved out: motions() is empty afterwards.
  [[nodiscard]] StrainMotions take_motions() { return std::exchange(motions_, {}); }
  /// The last iterate of relaxed(), converged or not [Pa].
  [[nodiscard]] const elastic::VoigtStiffness& last_iterate() const { return relaxed_; }

 private:
  elastic::VoigtStiffness affine_;
  elastic::VoigtStiffness relaxed_;
  std::optional<ForceTerms> force_terms_;
  StrainMotions motions_;
  Report report_;
};

/// Stiffness of the frozen contact network: C = (A - W^T H^+ W)/V, with H the stiffness matrix of the grains'
/// displacements and spins, W the unbalanced forces under uniform strain, A the affine energy, V the volume.
/// [AgnolinRoux2007c] Contact kinematics: delta = u_j - u_i - (a_i w_i + a_j w_j) x n, f = k_n (n.delta) n +
/// k_t (1-nn) delta. The contact point divides the branch as the radii do, a_i = |branch| R_i/(R_i + R_j), so
/// that a rigid rotation of the grains costs nothing and the moments balance with the branch vectors of the
/// stress. Walls move with the uniform strain; a contact with one has delta = -u_i - |branch| w_i x n in
/// addition. This is exact for smooth rigid walls, planes that rotate with the faces of the cell: the
/// distance of a grain from such a plane changes as the length of a branch does. Rough walls are assumed to
/// stretch and shear along themselves with the strain; along rigid plates grains would slip, the more the
/// farther from the middle.
/// Assumes   contacts neither open nor form; k_n, k_t of the present state; rattlers (fewer than 2 contacts;
///           fewer than 4 if no contact has tangential stiffness) removed iteratively, also from A. Grains or
///           clusters that can still move freely have no effect.
/// \param    assembly  any number of grains; without load-bearing contacts both stiffnesses are zero
/// \throws   InvalidArgument for an assembly that require_valid rejects, or an option outside its range
/// Accuracy  the error of C is of second order in options.tolerance. If rounding drives modes without
///           stiffness, a spring of 1e-14 of the mean k_n is added to every grain. It increases C by 1e-14
///           times the contribution of a mode, over the mode's stiffness in units of k_n: by 1e-9 at most
///           even for networks that are hardly rigid, but by 1e-4 if a mode of 1e-13 k_n carries load.
///           Contacts more than 1e7 times as stiff as the median count as rigid; C_ab is then wrong by 1e-5
///           of sqrt(C_aa C_bb) at most. If they carry a strain alone, or if stiffnesses differ by more than
///           1e7 and relaxation leaves less than 1e-7 of an affine energy, the response did not converge.
///           Same input, same bits, for any number of threads.
/// Checked by tests/network/test_linear_response.cpp, tests/network/test_lattices.cpp,
///           tests/network/test_threads.cpp, tests/network/test_rigid_contacts.cpp
Response linear_response(const packing::Assembly& assembly, const ResponseOptions& options = {});

/// Uniform strain without spin, as Response::affine(), but of all contacts: those of rattlers too, as codes
/// sum that do not look for rattlers [Pa]. Zero without contacts.
/// \param    options   sliding and prestress count
/// \throws   InvalidArgument for an assembly that require_valid rejects
/// Checked by tests/network/test_linear_response.cpp
[[nodiscard]] elastic::VoigtStiffness affine_all(const packing::Assembly& assembly,
                                                 const ResponseOptions& options = {});

} // namespace granum::network

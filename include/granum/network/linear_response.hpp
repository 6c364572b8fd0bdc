// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <optional>

#include <granum/core/stop_request.hpp>
#include <granum/elastic/stiffness.hpp>
#include <granum/packing/assembly.hpp>

/// Rung 4: the elastic response of a given contact network, by linear algebra instead of time stepping.
namespace granum::network {

/// What a contact at the Coulomb limit does in a small probe.
enum class SlidingContacts {
  stick,  ///< keeps its k_t: the probe unloads it
  release ///< k_t = 0: it goes on slipping
};

struct ResponseOptions {
  SlidingContacts sliding = SlidingContacts::stick;
  /// Adds -(f_n/l)(1 - n n) on the relative displacement of two centres, and the turning forces of walls. For
  /// networks without tangential stiffness: the arms of forces do not turn, and grains that two frictional
  /// contacts hold come out unstable. force_terms has both.
  bool prestress = false;
  bool force_terms = false;        ///< Response::force_terms is worked out; not for assemblies between walls
  double tolerance = 1e-10;        ///< in (0, 1): Report::residual at most
  int iteration_limit = 20000;     ///< >= 1
  std::size_t threads = 1;         ///< >= 1, that of the caller among them; same bits for any number
  StopRequest stop_requested = {}; ///< asked before every iteration
};

enum class Status {
  converged,
  iteration_limit,       ///< the tolerance was not reached: too few iterations, or below what rounding allows
  not_positive_definite, ///< the network is unstable: the prestress term outweighs the contact stiffness
  stopped                ///< options.stop_requested said so
};

/// What the forces that contacts carry add to Response::relaxed, to first order in their share f/(k_n l), by
/// the motions that it found [Pa]. A test that measures Cauchy stress, as triaxial::probe does, finds the sum
/// of relaxed() and both parts. Contacts between grains of any size; forces in balance.
struct ForceTerms {
  /// Forces turn with their contacts, their arms and the cell change. Where this is not small beside
  /// relaxed(), some motion is so soft that forces matter as much as stiffness, and neither is the answer.
  elastic::VoigtStiffness geometric;
  /// A contact that unloads sheds tangential force as its k_t falls, and gets none back: the mean of both.
  /// For k_n as a power of the overlap and k_t in its ratio, which is what dem::Engine does.
  elastic::VoigtStiffness shedding;
};

/// The two stiffnesses of a contact network, and how the second was found. Compression positive.
class [[nodiscard]] Response {
 public:
  struct Report {
    Status status = Status::converged;
    std::size_t grains = 0;   ///< that carry load (rattlers left out)
    std::size_t contacts = 0; ///< between them
    std::size_t wall_contacts = 0;
    int unknowns_per_grain = 0; ///< 6, or 3 where no contact has tangential stiffness and spins do not matter
    int iterations = 0;         ///< of all factors that were tried
    /// Residual force over affine force, worst load case, recomputed at the end. Where affine forces cancel
    /// on every grain, as in a lattice, over 1e-3 of the contact forces that cancel.
    double residual = 0;
    double symmetry_residual = 0;    ///< largest |C_ab - C_ba| over largest |C_ab|, before C was symmetrised
    std::size_t factor_nonzeros = 0; ///< numbers held by the preconditioner
    std::size_t mended_pivots =
        0; ///< of it, that were not safely positive; some cost iterations, no accuracy
  };

  Response(const elastic::VoigtStiffness& affine, const elastic::VoigtStiffness& relaxed,
           const Report& report, const std::optional<ForceTerms>& force_terms = {})
      : affine_(affine), relaxed_(relaxed), force_terms_(force_terms), report_(report) {}

  [[nodiscard]] const Report& report() const { return report_; }
  [[nodiscard]] bool converged() const { return report_.status == Status::converged; }

  /// Uniform strain, no spin: the sum over contacts of the load-bearing network [Pa].
  [[nodiscard]] const elastic::VoigtStiffness& affine() const { return affine_; }
  /// Every grain in equilibrium [Pa].
  /// \throws   Stopped if it was; NotConverged unless converged().
  [[nodiscard]] const elastic::VoigtStiffness& relaxed() const;
  /// Nothing unless options asked for them, and there is a network. Of the last iterate.
  /// Accuracy  of the sum beside DEM probes, 1,000 grains: dense 0.01 % rms, 0.16 % at worst; loose 0.2 %
  ///           rms, 0.8 % at worst.
  /// Checked by tests/network/test_force_terms.cpp, tests/studies/test_study.cpp
  [[nodiscard]] const std::optional<ForceTerms>& force_terms() const { return force_terms_; }
  /// The last iterate of relaxed(), converged or not [Pa].
  [[nodiscard]] const elastic::VoigtStiffness& last_iterate() const { return relaxed_; }

 private:
  elastic::VoigtStiffness affine_;
  elastic::VoigtStiffness relaxed_;
  std::optional<ForceTerms> force_terms_;
  Report report_;
};

/// Stiffness of the frozen contact network: C = (A - W^T H^+ W)/V with H the stiffness matrix of the grains'
/// displacements and spins, W the forces that a uniform strain leaves unbalanced, A the affine energy.
///                                                                                        [AgnolinRoux2007c]
/// Contact kinematics: delta = u_j - u_i - (a_i w_i + a_j w_j) x n, f = k_n (n.delta) n + k_t (1-nn) delta.
/// The contact point divides the branch as the radii do, a_i = |branch| R_i/(R_i + R_j), so that a rigid
/// rotation of the grains costs nothing and the moments balance with the branch vectors of the stress.
/// Walls move with the uniform strain: at a contact with one delta = -u_i - |branch| w_i x n beyond it. Exact
/// for smooth rigid walls, planes that turn with their faces: the distance of a grain from such a plane
/// changes as the length of a branch does. Rough walls are taken to stretch and shear along themselves with
/// the strain; against stiff plates grains would slip the more the farther they are from the middle.
/// Assumes   contacts neither open nor form; k_n, k_t those of the present state; rattlers (fewer than 2
///           contacts, fewer than 4 where no contact has tangential stiffness) left out one after the other,
///           from A as well. Grains or clusters that still move freely do so at no cost and take no part.
/// \param    assembly  any number of grains; without load-bearing contacts both stiffnesses are zero
/// \throws   InvalidArgument for an assembly that require_valid rejects, or an option outside its range
/// Accuracy  the error of C is of second order in options.tolerance. Where rounding drives modes that have no
///           stiffness, springs of 1e-14 of the mean k_n hold every grain; they make C stiffer by 1e-14 times
///           what a mode softens it by, over the mode's stiffness as a part of k_n: by 1e-9 at most down to
///           networks that hardly hold, but by 1e-4 where a mode of 1e-13 k_n bears load. Same input, same
///           bits, for any number of threads.
/// Checked by tests/network/test_linear_response.cpp, tests/network/test_lattices.cpp,
///           tests/network/test_threads.cpp
Response linear_response(const packing::Assembly& assembly, const ResponseOptions& options = {});

} // namespace granum::network

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <memory>

#include <granum/core/bytes.hpp>
#include <granum/core/vec3.hpp>
#include <granum/dem/specimen.hpp>

namespace granum::dem {

/// Quantities of the last step, for control and end of runs.
struct StepFigures {
  Mat3 stress;          ///< (1/V) sum of force (x) branch over contacts, compression positive [Pa]
  Vec3 boundary_stress; ///< normal stresses controlled by servos: reaction of the walls over their area, or
                        ///< the diagonal of the contact stress of a periodic cell [Pa]
  double mean_normal_force = 0; ///< over contacts that touch [N]
  double p_wave_modulus =
      0; ///< mean uniform-strain modulus of the network, (1/V) sum k_n l^2 (1/5 + 2r/15) [Pa]
  std::size_t contacts = 0;      ///< between grains
  std::size_t sliding = 0;       ///< number of these at the Coulomb limit in this step
  std::size_t wall_contacts = 0; ///< between grains and walls
};

/// Default time step over its stability limit. Smaller ones cost more steps and do not change quasi-static
/// states. Measured in validation/trade/
inline constexpr double default_time_step_fraction = 0.8;

/// Masses of unequal grains are proportional to this power of their radii, as are the stiffnesses of their
/// contacts at equal stress. With true masses, small grains would require a much smaller time step.
inline constexpr double mass_exponent = 1;

/// Explicit dynamics of spheres of equal or unequal size in a cell that deforms with a given velocity
/// gradient. The cell is periodic, or a box with rigid walls if the state has walls (specimen.hpp). Wall
/// contacts enter the contact stress with the branch from the centre to the wall; at rest between smooth
/// walls, the contact stress then equals the wall stress.
///
/// Contacts: the material's normal law; tangential increments k_t du with k_t = r k_n(d), the force carried
/// so far scaled down when k_t falls (so that no energy is gained), and Coulomb's limit. Lever arm of a
/// contact of equal grains: half of the branch. Grains move affinely with the cell plus their own velocity,
/// and only the latter is damped, by a mass-proportional drag of twice the lowest frequency of the present
/// motion (adaptive dynamic relaxation). The translational mass is density times volume, the rotational
/// inertia m R^2 in place of 0.4 m R^2, which lengthens the stable time step without changing quasi-static
/// states. For unequal grains the total mass is density times volume, divided according to mass_exponent, for
/// the same reason; the contact point divides the branch in the ratio of the radii. The time step follows
/// from the contact stiffnesses: a fraction of the stability limit 2/omega, with a strict upper bound on
/// omega. Without friction, rotations and contact histories are left out.
/// Assumes   quasi-static motion: the time step follows from existing contacts, so a fast grain that overlaps
///           deeply at its first contact gains energy.
/// Same state, same calls: same bits.       [CundallStrack1979], checked by tests/dem/test_engine.cpp,
/// tests/dem/test_unequal_grains.cpp
class Engine {
 public:
  /// \throws InvalidArgument for an empty state, an impossible material, radius or size, or a cell that is
  ///         too small
  Engine(Specimen state, const Material& material);
  ~Engine();
  Engine(Engine&&) noexcept;
  Engine& operator=(Engine&&) noexcept;

  /// Velocity gradient of the cell from the next step on [1/s]. Compression is negative here: it is a rate of
  /// length.
  void set_velocity_gradient(const Mat3& gradient);
  /// Sets a constant drag coefficient [1/s] in place of the adaptive one; 0 switches damping off.
  void set_damping(double coefficient);
  /// Minimisation by FIRE until a drag is set, with a fifth of the adaptive drag: velocities are turned
  /// towards the forces; all grains stop when the forces do no work, and grains without contact stop too.
  /// Near rest and without sliding this takes half of the steps of the adaptive drag, with which weakly
  /// supported grains creep. Far from rest the adaptive drag takes fewer.
  /// Assumes   a cell at rest.
  /// [Bitzek2006], checked by tests/dem/test_descent.cpp
  void descend();
  /// Sets the time step over the stability limit; default_time_step_fraction before the first call.
  /// \throws InvalidArgument unless 0 < fraction <= 1
  void set_time_step_fraction(double fraction);

  /// Number of threads for each step, including the calling one; 1 before the first call. Results have the
  /// same bits with any number. Small specimens use fewer: at least 1,024 grains a thread. Useful on idle
  /// processors; several engines are better run at the same time with one thread each.
  /// \throws   InvalidArgument for 0
  /// Checked by tests/dem/test_threads.cpp
  void set_threads(std::size_t count);
  /// Number of threads in use.
  [[nodiscard]] std::size_t threads() const;

  /// One step: move, contact forces, velocities.
  void step();

  [[nodiscard]] const StepFigures& figures() const;
  /// Forces of the walls in the last step; zeros in a periodic cell.
  [[nodiscard]] WallForces wall_forces() const;
  /// Mean of sqrt(force^2 + (torque/R)^2) over the grains with contacts, R the radius of the grain, over the
  /// mean contact force [1]; 0 without contacts.
  [[nodiscard]] double unbalanced_force_ratio() const;
  /// Duration of the next step [s]; may change every 100 steps with the stiffness of the contacts.
  [[nodiscard]] double time_step() const;
  /// Radius of a grain of size 1 [m].
  [[nodiscard]] double diameter() const;
  [[nodiscard]] const Mat3& cell() const;
  /// Kinetic energy of the motion beyond the affine one [J].
  [[nodiscard]] double kinetic_energy() const;
  [[nodiscard]] bool finite() const;
  [[nodiscard]] std::size_t steps() const;
  /// Sets the velocities of the grains, relative to the cell, to zero.
  void rest();
  /// The state after the last step.
  [[nodiscard]] Specimen state() const;
  [[nodiscard]] const Material& material() const;

  /// Writes everything that the next steps depend on, to the bit; an engine uses no random numbers.
  void save(ByteWriter& to) const;
  /// Loads a saved engine; it continues with the same bits as the original.
  /// \throws   FileError if the bytes end too early or were written for another material
  /// Checked by tests/dem/test_engine_bytes.cpp
  [[nodiscard]] static Engine load(ByteReader& from, const Material& material);

 private:
  struct Data;
  explicit Engine(std::unique_ptr<Data> data);

  std::unique_ptr<Data> data_;
};

} // namespace granum::dem

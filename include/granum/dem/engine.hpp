// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <memory>

#include <granum/core/bytes.hpp>
#include <granum/core/vec3.hpp>
#include <granum/dem/specimen.hpp>
#include <granum/dem/walls.hpp>

namespace granum::dem {

/// Figures of the last step, from which runs steer and stop.
struct StepFigures {
  Mat3 stress;          ///< (1/V) sum of force (x) branch over contacts, compression positive [Pa]
  Vec3 boundary_stress; ///< normal stresses that servos hold: reaction of the walls over their area, or
                        ///< the diagonal of the contact stress of a periodic cell [Pa]
  double mean_normal_force = 0; ///< over contacts that touch [N]
  double p_wave_modulus =
      0; ///< mean uniform-strain modulus of the network, (1/V) sum k_n l^2 (1/5 + 2r/15) [Pa]
  std::size_t contacts = 0;      ///< between grains
  std::size_t sliding = 0;       ///< of them, at the Coulomb limit in this step
  std::size_t wall_contacts = 0; ///< between grains and walls
  std::size_t wall_sliding = 0;
};

/// What the time step is of the stability limit, unless another fraction is asked for. Smaller ones cost more
/// steps and leave quasi-static states as they are.         Measured in validation/trade/
inline constexpr double default_time_step_fraction = 0.8;

/// The masses of different grains go as this power of their radii, as the stiffnesses of their contacts
/// do at one stress: small grains of their true masses would set a time step that the others do not need.
inline constexpr double mass_exponent = 1;

/// Explicit dynamics of spheres, equal or not, in a cell that deforms with a given velocity gradient:
/// periodic, or, where the state has walls, a box whose faces are rigid walls (walls.hpp). Wall contacts
/// count in the contact stress with the branch from the centre to the wall, so that at rest it is that of
/// smooth walls.
///
/// Contacts: the material's normal law; tangential increments k_t du with k_t = r k_n(d), the force carried
/// so far scaled down when k_t falls (so that no energy is gained), and Coulomb's limit. Lever arm of a
/// contact of equal grains: half of the branch. Grains move affinely with the cell plus their own velocity,
/// which alone is damped: a mass-proportional drag of twice the lowest frequency that the motion shows
/// (adaptive dynamic relaxation). The translational mass is density times volume, the rotational inertia m
/// R^2 in place of 0.4 m R^2, which lengthens the stable time step and leaves quasi-static states as they
/// are. Where grains differ, the masses together are density times volume, and each has a share as
/// mass_exponent says, for the same reason; the contact point divides the branch as the radii do. The time
/// step follows from the contact stiffnesses: a fraction of the stability limit 2/omega, with a strict
/// upper bound on omega. Without friction no rotations and no histories are modelled.
/// Assumes   quasi-static motion: the time step follows the contacts that exist, so a grain that flies
///           into its first contact, deep within one step, gains energy.
/// Same state, same calls: same bits.       [CundallStrack1979], checked by tests/dem/test_engine.cpp,
/// tests/dem/test_unequal_grains.cpp
class Engine {
 public:
  /// \throws InvalidArgument for an empty state, a material, a radius or sizes that are impossible, or a cell
  ///         that is too small
  Engine(Specimen state, const Material& material);
  ~Engine();
  Engine(Engine&&) noexcept;
  Engine& operator=(Engine&&) noexcept;

  /// Velocity gradient of the cell from the next step on [1/s]; compression is negative here, as rates of
  /// length are.
  void set_velocity_gradient(const Mat3& gradient);
  /// Drag coefficient [1/s] from now on in place of the adaptive one; 0 switches damping off.
  void set_damping(double coefficient);
  /// From now on, until a drag is set, grains go downhill by FIRE, with a fifth of the adaptive drag:
  /// velocities are turned towards the forces, and all stop where these do no work; a grain that touches
  /// nothing stops too. Grains that hardly anything holds, which drag lets creep, swing to their places:
  /// from near rest to rest in half of the steps, where nothing slides. Far from rest the adaptive drag takes
  /// fewer.
  /// Assumes   a cell that stands still.
  /// [Bitzek2006], checked by tests/dem/test_descent.cpp
  void descend();
  /// Time step over the stability limit from now on; default_time_step_fraction before the first call.
  /// \throws InvalidArgument unless 0 < fraction <= 1
  void set_time_step_fraction(double fraction);

  /// How many threads share each step from now on, that of the caller among them; 1 before the first call.
  /// The bits are the same with any number. Small specimens take fewer: a thread has 1,024 grains or more.
  /// For processors that are idle; many engines are better run side by side, with one thread each.
  /// \throws   InvalidArgument for 0
  /// Checked by tests/dem/test_threads.cpp
  void set_threads(std::size_t count);
  /// The threads that share a step.
  [[nodiscard]] std::size_t threads() const;

  /// One step: move, contact forces, velocities.
  void step();

  [[nodiscard]] const StepFigures& figures() const;
  /// Forces of the walls in the last step; zeros in a periodic cell.
  [[nodiscard]] WallForces wall_forces() const;
  /// Mean of sqrt(force^2 + (torque/R)^2), R the grain's own, over the grains that touch others / mean
  /// contact force [1]; 0 without contacts.
  [[nodiscard]] double unbalanced_force_ratio() const;
  /// Time that the next step takes [s]; may change every 100 steps, as the contacts stiffen or soften.
  [[nodiscard]] double time_step() const;
  /// Of a grain of size 1 [m].
  [[nodiscard]] double diameter() const;
  [[nodiscard]] const Mat3& cell() const;
  /// Kinetic energy of the motion beyond the affine one [J].
  [[nodiscard]] double kinetic_energy() const;
  [[nodiscard]] bool finite() const;
  [[nodiscard]] std::size_t steps() const;
  /// Stops all own motion of the grains.
  void rest();
  /// The state as it stands after the last step.
  [[nodiscard]] Specimen state() const;
  [[nodiscard]] const Material& material() const;

  /// All that the next steps depend on, to the bit; no random numbers are drawn while an engine runs.
  void save(ByteWriter& to) const;
  /// The engine that was saved: it goes on with the same bits as the one that wrote it.
  /// \throws   FileError if the bytes end too early or were written for another material
  /// Checked by tests/dem/test_engine_bytes.cpp
  [[nodiscard]] static Engine load(ByteReader& from, const Material& material);

 private:
  struct Data;
  explicit Engine(std::unique_ptr<Data> data);

  std::unique_ptr<Data> data_;
};

} // namespace granum::dem

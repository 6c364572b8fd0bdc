// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

#include <granum/dem/engine.hpp>

#include "contact_sweep.hpp"
#include "grain_motion.hpp"
#include "grain_order.hpp"
#include "verlet_list.hpp"
#include "wall_contacts.hpp"

namespace granum::dem {

/// What an engine holds from step to step. Engine::save writes all of it that does not follow from the
/// material.
struct Engine::Data {
  /// \param order  place in the engine of each grain of the state; by default neighbours come near each other
  Data(State initial, const Material& m, std::vector<std::uint32_t> order = {});

  void rebuild();
  void sweep(double dt);
  void choose_time_step();
  void add_wall_stiffness(std::vector<Mat3>& translation, std::vector<Mat3>& rotation) const;
  [[nodiscard]] bool time_step_is_due() const;
  void integrate();
  void move();
  void take_figures(const SweepSums& sums);
  [[nodiscard]] std::vector<ContactHistory> history() const;

  Material material;
  contact::NormalKernel law;
  bool tangential;
  double friction;                  ///< finite stand-in for an infinite coefficient
  std::vector<std::uint32_t> order; ///< place of each grain of the outer state
  /// In the engine's order; cell and radius are current, the rest only between steps of rebuild.
  State cold;
  double mass = 0;
  double inertia = 0;
  VerletList list;
  std::optional<WallContacts> walls;
  std::vector<Pair> pairs; ///< those of the list, padded
  Grains grains;
  ContactMemory memory;
  std::vector<LoadRow> load;
  Mat3 gradient;
  double dt = 0;
  double time_step_fraction = default_time_step_fraction;
  double fixed_damping = -1; ///< negative: adaptive
  double damping = 0;
  double travelled = 0;       ///< upper bound of own displacement since the list was checked [m]
  double strained = 0;        ///< upper bound of the cell's strain since then [1]
  MotionSums motion;          ///< over the velocities of this moment and the last forces
  double stiffest = 0;        ///< k_n in the last sweep [N/m]
  double stiffest_chosen = 0; ///< the same when the time step was chosen
  std::size_t contacts_chosen = 0;
  StepFigures figures;
  std::size_t steps = 0;
};

} // namespace granum::dem

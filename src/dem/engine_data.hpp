// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <vector>

#include <granum/dem/engine.hpp>

#include "core/team.hpp"
#include "dem/sweep/contact_sweep.hpp"
#include "dem/sweep/frequency_bound.hpp"
#include "dem/sweep/grain_motion.hpp"
#include "dem/sweep/grain_rows.hpp"
#include "dem/sweep/partition.hpp"
#include "dem/sweep/verlet_list.hpp"
#include "dem/sweep/wall_contacts.hpp"

namespace granum::dem {

/// Contribution of one chunk to the sums of a step; in separate cache lines, because threads write at the
/// same time.
struct alignas(64) ChunkSums {
  SweepSums contacts;
  WallForces walls;
  double power = 0;
  double pull = 0;
  MotionSums motion;
};

/// State of an engine. Engine::save writes everything that does not follow from the material.
struct Engine::Data {
  /// \param order  place in the engine of each grain of the state; by default neighbours come near each other
  Data(Specimen initial, const Material& m, std::vector<std::uint32_t> order = {});

  void rebuild();
  void lay_out();
  void set_threads(std::size_t count);
  /// Calls job(number of the chunk) for each of them, spread over the threads.
  template <class Job>
  void each_chunk(const Job& job);
  void sweep(double dt);
  void choose_time_step();
  [[nodiscard]] bool time_step_is_due() const;
  void integrate();
  void choose_damping();
  /// Velocities become keep v + push f/m.
  struct Drive {
    double keep = 0, push = 0;
  };
  [[nodiscard]] Drive turned_downhill(Drive drive);
  void kick(const Kick& of_step);
  void move();
  void take_figures(const SweepSums& total);
  [[nodiscard]] std::vector<ContactHistory> history() const;

  Material material;
  contact::NormalKernel law;
  bool tangential;
  double friction;                  ///< finite, also for an infinite coefficient
  std::vector<std::uint32_t> order; ///< place of each grain of the outer state
  /// In the engine's order; cell and radius are current, the rest only between steps of rebuild.
  Specimen cold;
  double mass = 0;    ///< of each grain, where all are equal [kg]
  double inertia = 0; ///< likewise [kg m^2]
  double largest_size = 1;
  double lightest = 0; ///< mass [kg]
  VerletList list;
  std::optional<WallContacts> walls;
  Partition parts; ///< of the grains and the list
  std::vector<ChunkSums> sums;
  std::unique_ptr<Team> team;     ///< null: one thread
  std::vector<std::size_t> share; ///< first chunk of each thread, and their number
  Grains grains;
  std::vector<MemoryBlock> memory; ///< of the blocks of pairs; none without friction
  std::vector<LoadRow> load;       ///< of the grains, then the spare rows
  Mat3 gradient;
  double dt = 0;
  double time_step_fraction = default_time_step_fraction;
  double fixed_damping = -1; ///< negative: adaptive
  double damping = 0;
  bool descends = false;
  FireMixing mixing;          ///< used in a descent
  double travelled = 0;       ///< upper bound of own displacement since the list was checked [m]
  double strained = 0;        ///< upper bound of the cell's strain since then [1]
  MotionSums motion;          ///< over the present velocities and the last forces
  double power = 0;           ///< of the last forces over the velocities before their kick [W]
  double stiffest = 0;        ///< k_n in the last sweep [N/m]
  double stiffest_chosen = 0; ///< the same when the time step was chosen
  std::size_t contacts_chosen = 0;
  FrequencyBound frequency_bound;
  StepFigures figures;
  std::size_t steps = 0;
};

template <class Job>
void Engine::Data::each_chunk(const Job& job) {
  if (team) {
    team->run([&](std::size_t member) {
      for (std::size_t c = share[member]; c < share[member + 1]; ++c)
        job(c);
    });
  } else {
    for (std::size_t c = 0; c < parts.chunks.size(); ++c)
      job(c);
  }
}

} // namespace granum::dem

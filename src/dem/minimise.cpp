// SPDX-License-Identifier: GPL-3.0-or-later
// FIRE on the generalised coordinates (x_1 .. x_N, q): x positions with unit mass, q = sqrt(W) ln(size),
// where W sets how fast the cell answers beside the grains. Time is measured in sqrt(mass/stiffness).
#include <granum/dem/minimise.hpp>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>
#include <variant>

#include <granum/core/check.hpp>
#include <granum/core/error.hpp>

#include "verlet_list.hpp"
#include "wall_contacts.hpp"

namespace granum::dem {

namespace {

struct Sweep {
  double virial = 0;    ///< sum over contacts of f |branch| [J]
  double force_sum = 0; ///< sum over contacts of f [N]
  double stiffest = 0;  ///< largest k_n [N/m]
  double largest_overlap = 0;
  std::size_t contacts = 0;
};

template <class Law>
Sweep frictionless_sweep(const Law& law, const State& state, const std::vector<Pair>& pairs,
                         std::vector<Vec3>& force) {
  const std::array<Vec3, 27> shifts = shift_vectors(state.cell);
  const double diameter = 2 * state.radius;
  std::fill(force.begin(), force.end(), Vec3{});
  Sweep sweep;
  for (const Pair& pair : pairs) {
    const Vec3 branch = state.position[pair.j] + shifts[pair.image] - state.position[pair.i];
    const double distance_squared = dot(branch, branch);
    if (distance_squared >= diameter * diameter)
      continue;
    const double distance = std::sqrt(distance_squared);
    const contact::NormalResponse response = law(diameter - distance);
    const Vec3 on_j = (response.force / distance) * branch;
    force[pair.j] += on_j;
    force[pair.i] -= on_j;
    sweep.virial += response.force * distance;
    sweep.force_sum += response.force;
    sweep.stiffest = std::max(sweep.stiffest, response.stiffness);
    sweep.largest_overlap = std::max(sweep.largest_overlap, diameter - distance);
    ++sweep.contacts;
  }
  return sweep;
}

/// Adds what smooth walls do to the grains; the branch of a wall contact ends at the wall.
template <class Law>
void add_walls(const Law& law, const State& state, std::vector<Vec3>& force, Sweep& sweep) {
  for (const WallPlane& plane : wall_planes(state.cell))
    for (std::size_t g = 0; g < force.size(); ++g) {
      const double distance = wall_distance(plane, state.position[g]);
      const double overlap = state.radius - distance;
      if (!(overlap > 0))
        continue;
      const contact::NormalResponse response = wall_response(law, overlap);
      force[g] += response.force * plane.normal;
      sweep.virial += response.force * distance;
      sweep.force_sum += response.force;
      sweep.stiffest = std::max(sweep.stiffest, response.stiffness);
      sweep.largest_overlap = std::max(sweep.largest_overlap, overlap);
      ++sweep.contacts;
    }
}

/// FIRE's rule for time step and mixing, as published, with the dimensionless time step bounded by stability.
struct FireRule {
  double step = 0.1;
  double mixing = 0.1;
  int uphill_free = 0;

  static constexpr double largest_step = 0.6;

  void downhill() {
    if (++uphill_free > 5) {
      step = std::min(step * 1.1, largest_step);
      mixing *= 0.99;
    }
  }
  void uphill() {
    step *= 0.5;
    mixing = 0.1;
    uphill_free = 0;
  }
};

class Minimiser {
 public:
  Minimiser(State& state, const contact::PowerLaw& law, std::optional<double> pressure,
            const MinimiseOptions& options)
      : state_(state), law_(law.kernel()), pressure_(pressure), options_(options),
        list_(2 * state.radius, 0.1 * state.radius, images(state)), force_(state.grain_count()),
        velocity_(state.grain_count()),
        cell_inertia_(cell_inertia_per_grain(state.grain_count()) * static_cast<double>(state.grain_count()) *
                      state.radius * state.radius) {
    list_.build(state_.cell, state_.position);
  }

  RelaxReport run() {
    RelaxReport report;
    for (; report.steps < options_.max_steps; ++report.steps) {
      if (!list_.valid(state_.cell, state_.position))
        list_.build(state_.cell, state_.position);
      const Sweep sweep = std::visit([&](const auto& law) { return forces(law); }, law_);
      report.pressure = sweep.virial / (3 * determinant(state_.cell));
      report.unbalanced_force_ratio = unbalanced(sweep);
      if (arrived(sweep, report)) {
        report.converged = true;
        return report;
      }
      advance(sweep);
    }
    return report;
  }

 private:
  /// W/(m N R^2): the cell's period is then that of the specimen's slow sound waves, which cross it in a time
  /// that grows as N^(1/3).
  static double cell_inertia_per_grain(std::size_t grains) {
    return 500 * std::pow(std::max(1.0, static_cast<double>(grains) / 1000), 2.0 / 3);
  }
  /// The cell may change by this strain in a step at most, so that grains cannot pass through each other.
  static constexpr double largest_cell_step = 1e-3;

  template <class Law>
  Sweep forces(const Law& law) {
    Sweep sweep = frictionless_sweep(law, state_, list_.pairs(), force_);
    if (state_.walls)
      add_walls(law, state_, force_, sweep);
    return sweep;
  }

  [[nodiscard]] double unbalanced(const Sweep& sweep) const {
    if (sweep.contacts == 0)
      return 0;
    double residual = 0;
    for (const Vec3& f : force_)
      residual += norm(f);
    return residual / static_cast<double>(force_.size()) * static_cast<double>(sweep.contacts) /
           sweep.force_sum;
  }

  [[nodiscard]] bool arrived(const Sweep& sweep, const RelaxReport& report) const {
    const bool balanced = sweep.contacts > 0 && report.unbalanced_force_ratio < options_.force_tolerance;
    if (pressure_)
      return balanced && std::abs(report.pressure / *pressure_ - 1) < options_.pressure_tolerance;
    return balanced || sweep.largest_overlap < options_.overlap_tolerance * state_.radius;
  }

  /// One FIRE step: semi-implicit Euler, velocities turned towards the force while the power is positive.
  void advance(const Sweep& sweep) {
    const double volume = determinant(state_.cell);
    const double cell_force =
        pressure_ ? (sweep.virial - 3 * *pressure_ * volume) / std::sqrt(cell_inertia_) : 0;
    // Unit mass: the time step is the rule's number times sqrt(1/k) of the stiffest contact seen lately.
    stiffness_scale_ = std::max(sweep.stiffest, 0.98 * stiffness_scale_);
    if (!(stiffness_scale_ > 0))
      stiffness_scale_ = pressure_ ? *pressure_ * state_.radius : 1.0;
    double power = cell_velocity_ * cell_force;
    for (std::size_t g = 0; g < force_.size(); ++g)
      power += dot(velocity_[g], force_[g]);
    if (power > 0) {
      rule_.downhill();
    } else {
      rule_.uphill();
      std::fill(velocity_.begin(), velocity_.end(), Vec3{});
      cell_velocity_ = 0;
    }
    const double dt = rule_.step / std::sqrt(stiffness_scale_);
    double speed = 0, pull = 0;
    cell_velocity_ += dt * cell_force;
    speed += cell_velocity_ * cell_velocity_;
    pull += cell_force * cell_force;
    for (std::size_t g = 0; g < force_.size(); ++g) {
      velocity_[g] += dt * force_[g];
      speed += dot(velocity_[g], velocity_[g]);
      pull += dot(force_[g], force_[g]);
    }
    const double turn = pull > 0 ? rule_.mixing * std::sqrt(speed / pull) : 0;
    move(dt, turn, cell_force);
  }

  void move(double dt, double turn, double cell_force) {
    const double keep = 1 - rule_.mixing;
    // No grain moves farther than a tenth of the skin's order in one step, whatever the forces.
    const double largest_move = 0.02 * state_.radius;
    cell_velocity_ = keep * cell_velocity_ + turn * cell_force;
    double cell_step = dt * cell_velocity_ / std::sqrt(cell_inertia_);
    cell_step = std::clamp(cell_step, -largest_cell_step, largest_cell_step);
    cell_velocity_ = cell_step * std::sqrt(cell_inertia_) / dt;
    const double growth = 1 + cell_step;
    for (std::size_t g = 0; g < force_.size(); ++g) {
      velocity_[g] = keep * velocity_[g] + turn * force_[g];
      Vec3 displacement = dt * velocity_[g];
      const double length = norm(displacement);
      if (length > largest_move) {
        displacement *= largest_move / length;
        velocity_[g] *= largest_move / length;
      }
      state_.position[g] = growth * (state_.position[g] + displacement);
    }
    state_.cell = growth * state_.cell;
  }

  State& state_;
  contact::NormalKernel law_;
  std::optional<double> pressure_;
  MinimiseOptions options_;
  VerletList list_;
  std::vector<Vec3> force_;
  std::vector<Vec3> velocity_;
  double cell_velocity_ = 0;
  double cell_inertia_;
  double stiffness_scale_ = 0;
  FireRule rule_;
};

void clear_tangential(State& state) {
  state.velocity.assign(state.grain_count(), Vec3{});
  state.angular_velocity.assign(state.grain_count(), Vec3{});
  state.history.clear();
  if (state.walls)
    state.walls->history.clear();
}

RelaxReport minimise(State& state, const contact::PowerLaw& law, std::optional<double> pressure,
                     const MinimiseOptions& options) {
  if (state.grain_count() == 0)
    throw InvalidArgument("minimise: the state has no grains");
  require_positive("radius", state.radius, "m");
  clear_tangential(state);
  return Minimiser(state, law, pressure, options).run();
}

} // namespace

RelaxReport minimise_energy(State& state, const contact::PowerLaw& law, const MinimiseOptions& options) {
  return minimise(state, law, std::nullopt, options);
}

RelaxReport minimise_enthalpy(State& state, const contact::PowerLaw& law, double pressure,
                              const MinimiseOptions& options) {
  require_positive("pressure", pressure, "Pa");
  return minimise(state, law, pressure, options);
}

} // namespace granum::dem

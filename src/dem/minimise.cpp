// SPDX-License-Identifier: GPL-3.0-or-later
// FIRE on the generalised coordinates (x_1 .. x_N, q): positions x, with unit mass for equal grains and the
// masses of sizes_for_descent otherwise; q = sqrt(W) ln(size), where W is the inertia of the cell. The unit
// of time is sqrt(mass/stiffness). Forces are from the engine's sweep, without friction.
#include <granum/dem/quasistatic.hpp>

#include <algorithm>
#include <cmath>
#include <optional>
#include <string>

#include <granum/core/error.hpp>
#include <granum/core/text.hpp>

#include "dem/sweep/contact_sweep.hpp"
#include "dem/sweep/grain_motion.hpp"
#include "dem/sweep/grain_rows.hpp"
#include "dem/sweep/verlet_list.hpp"
#include "dem/sweep/wall_contacts.hpp"

namespace granum::dem {

namespace {

/// Sums over one sweep.
struct Balance {
  DescentSums contacts; ///< those at walls among them
  std::size_t all = 0;  ///< contacts, those at walls among them
  PushSums grains;
};

/// FIRE's rule for time step and mixing, as published, with the dimensionless time step bounded by stability.
struct FireRule {
  double step = 0.1;
  FireMixing mixing;

  static constexpr double largest_step = 0.6;

  void downhill() {
    if (mixing.downhill())
      step = std::min(step * 1.1, largest_step);
  }
  void uphill() {
    step *= 0.5;
    mixing.uphill();
  }
};

/// Grains, ordered such that neighbours are near in memory, with the list of their pairs.
class Minimiser {
 public:
  Minimiser(const Specimen& state, const contact::NormalLaw& law, std::optional<double> pressure,
            const MinimiseOptions& options)
      : order_(near_order(state)), state_(reordered(state, order_)), law_(law.kernel()), pressure_(pressure),
        options_(options), list_(state, pressure ? first_pressed_skin : growing_skin,
                                 pressure ? pressed_wide_skin : growing_wide_skin),
        cell_inertia_(cell_inertia_per_grain(state.grain_count()) * static_cast<double>(state.grain_count()) *
                      state.radius * state.radius) {
    grains_.resize(state_.grain_count());
    grains_.set_sizes(sizes_for_descent(state_));
    if (state_.walls)
      walls_.emplace(0.0);
    list_pairs();
  }

  RelaxReport run() {
    RelaxReport report;
    Balance balance;
    for (;; ++report.steps, ++list_age_) {
      if (list_.may_be_invalid(travelled_, strained_))
        check_list();
      balance = forces();
      report.last_pressure = balance.contacts.virial / (3 * determinant(state_.cell));
      report.stopped = is_stopped(options_.stop_requested);
      report.converged = !report.stopped && arrived(balance, report.last_pressure);
      if (report.stopped || report.converged || report.steps >= options_.max_steps)
        break;
      advance(balance); // with the forces: the report belongs to a sweep after which no grain moved
    }
    report.unbalanced_force_ratio = unbalanced(balance, lengths());
    fetch_centres();
    return report;
  }

  /// Present cell and centres.
  void put_into(Specimen& state) const {
    state.cell = state_.cell;
    for (std::size_t g = 0; g < order_.size(); ++g)
      state.position[g] = state_.position[order_[g]];
  }

 private:
  /// W/(m N R^2). The period of the cell then equals that of slow sound waves across the specimen, which
  /// grows as N^(1/3).
  static double cell_inertia_per_grain(std::size_t grains) {
    return 500 * std::pow(std::max(1.0, static_cast<double>(grains) / 1000), 2.0 / 3);
  }
  /// Skin of the list/R. In a fixed cell grains move farther than under a pressure; there the skin follows
  /// their speed from the second list on.
  static constexpr double first_pressed_skin = 0.03, growing_skin = 0.3;
  static constexpr double least_pressed_skin = 0.005, largest_pressed_skin = 0.1;
  /// Skins of the wider list from which it is made: from 0.4 to 0.8, and from 0.7 to 1, the time is the same.
  static constexpr double pressed_wide_skin = 0.6, growing_wide_skin = 1;
  /// Largest strain of the cell in a step, so that grains cannot pass through each other.
  static constexpr double largest_cell_step = 1e-3;

  void fetch_centres() {
    for (std::size_t g = 0; g < grains_.size(); ++g)
      state_.position[g] = grains_.centre(g);
  }

  /// Oscillating grains end near their start: the bounds are reset to the true displacements.
  void check_list() {
    const Drift drift = list_.drift(state_.cell, [this](std::size_t g) { return grains_.centre(g); });
    if (list_.valid(drift)) {
      travelled_ = drift.farthest;
      strained_ = drift.strain;
    } else {
      if (pressure_)
        list_.set_skin(skin_for(list_.nearing(drift) / static_cast<double>(list_age_)));
      fetch_centres();
      list_pairs();
    }
  }

  /// Skin [m] for grains that approach each other at a pace [m] per step. A list lasts skin/pace steps and
  /// costs about three; listed pairs without contact lengthen a step by some 1.7 skin/R. The sum is least if
  /// both costs are equal.
  [[nodiscard]] double skin_for(double pace) const {
    constexpr double list_steps = 3, longer_by = 1.7;
    const double skin = std::sqrt(list_steps / longer_by * pace / state_.radius);
    return std::clamp(skin, least_pressed_skin, largest_pressed_skin) * state_.radius;
  }

  void list_pairs() {
    list_.build(state_);
    parts_ = partition(list_.pairs(), grains_.size());
    load_.assign(parts_.rows, PushRow{});
    for (std::size_t g = 0; g < grains_.size(); ++g)
      grains_.set_centre(g, state_.position[g]);
    if (walls_)
      walls_->list(state_.cell, grains_, state_.radius, list_.skin(), {});
    travelled_ = strained_ = 0;
    list_age_ = 0;
  }

  Balance forces() {
    const DescentInput input{.pairs = parts_.pairs,
                             .grains = grains_,
                             .cell = state_.cell,
                             .diameter = 2 * state_.radius * largest_size_,
                             .unit_radius = state_.radius};
    Balance balance;
    for (const Chunk& chunk : parts_.chunks) {
      DescentSums sums = descent_sweep(law_, input, chunk, load_);
      if (walls_)
        balance.all += walls_->descent_sweep(law_, input, chunk.grains, load_, sums).contacts;
      // Spare rows come from earlier chunks only, because j > i.
      balance.grains += settle_pushes(grains_, chunk, parts_.additions, load_);
      balance.contacts += sums;
    }
    balance.all += balance.contacts.contacts;
    return balance;
  }

  /// Sum of |f| over all grains, in their order: with a few contacts in a growing specimen, the ratio may
  /// equal its tolerance to the last digit, and the rounding of the sum would decide.
  [[nodiscard]] double lengths() const {
    double sum = 0;
    for (const Chunk& chunk : parts_.chunks)
      sum += lengths_of_forces(chunk, load_);
    return sum;
  }

  /// \param    lengths   sum of the forces on all grains, without direction
  [[nodiscard]] double unbalanced(const Balance& balance, double lengths) const {
    if (balance.all == 0)
      return 0;
    return lengths / static_cast<double>(grains_.size()) * static_cast<double>(balance.all) /
           balance.contacts.normal_force;
  }

  [[nodiscard]] bool balanced(const Balance& balance) const {
    // Lengths are at least 1/sqrt(3) of the sums of components, which take no roots.
    constexpr double least = 0.577;
    return balance.all > 0 &&
           unbalanced(balance, least * balance.grains.components) < options_.force_tolerance &&
           unbalanced(balance, lengths()) < options_.force_tolerance;
  }

  [[nodiscard]] bool arrived(const Balance& balance, double pressure) const {
    if (pressure_)
      return std::abs(pressure / *pressure_ - 1) < options_.pressure_tolerance && balanced(balance);
    return balanced(balance) || parted(balance);
  }

  /// Whether no overlap beyond its tolerance is left.
  [[nodiscard]] bool parted(const Balance& balance) const {
    const double tolerance = options_.overlap_tolerance * state_.radius;
    // Every law has f <= k_n d: some contact has at least the overlap mean force over largest stiffness.
    if (balance.contacts.normal_force >
        tolerance * static_cast<double>(balance.all) * balance.contacts.stiffest)
      return false;
    const std::array<Vec3, image_count> shifts = shift_vectors(state_.cell);
    for (const Pair& pair : list_.pairs()) {
      const double near = state_.radius_of(pair.i) + state_.radius_of(pair.j) - tolerance;
      if (norm(grains_.centre(pair.j) + shifts[pair.image] - grains_.centre(pair.i)) <= near)
        return false;
    }
    const std::array<WallPlane, wall_count> planes = wall_planes(state_.cell);
    if (walls_)
      for (const WallHistory& candidate : walls_->candidates())
        if (wall_distance(planes[candidate.wall], grains_.centre(candidate.grain)) <=
            state_.radius_of(candidate.grain) - tolerance)
          return false;
    return true;
  }

  /// One FIRE step: semi-implicit Euler, velocities turned towards the force while the power is positive.
  void advance(const Balance& balance) {
    const double volume = determinant(state_.cell);
    const double cell_force =
        pressure_ ? (balance.contacts.virial - 3 * *pressure_ * volume) / std::sqrt(cell_inertia_) : 0;
    // No mass is below 1: the time step is the dimensionless one times sqrt(1/k) of the stiffest recent
    // contact.
    stiffness_scale_ = std::max(balance.contacts.stiffest, 0.98 * stiffness_scale_);
    if (!(stiffness_scale_ > 0))
      stiffness_scale_ = pressure_ ? *pressure_ * state_.radius : 1.0;
    double power = balance.grains.power + cell_velocity_ * cell_force;
    double speed = speed_ + cell_velocity_ * cell_velocity_;
    double keep = 1;
    if (power > 0) {
      rule_.downhill();
    } else {
      rule_.uphill();
      keep = power = speed = 0;
    }
    const double dt = rule_.step / std::sqrt(stiffness_scale_);
    const double pull = balance.grains.squares + cell_force * cell_force;
    speed += dt * (2 * power + dt * pull); // after the forces have acted
    const double turn = pull > 0 ? rule_.mixing.share * std::sqrt(std::max(0.0, speed) / pull) : 0;
    keep *= 1 - rule_.mixing.share;
    move(dt, keep, (1 - rule_.mixing.share) * dt + turn, cell_force);
  }

  /// Sets the velocities to keep v + push f and moves all grains with them for dt.
  void move(double dt, double keep, double push, double cell_force) {
    // Largest displacement in one step, for any forces.
    const double largest_move = 0.02 * state_.radius;
    const double cell_rate = (keep * cell_velocity_ + push * cell_force) / std::sqrt(cell_inertia_);
    const double cell_step = std::clamp(dt * cell_rate, -largest_cell_step, largest_cell_step);
    cell_velocity_ = cell_step * std::sqrt(cell_inertia_) / dt;
    const double growth = 1 + cell_step;
    const GlideSums sums =
        glide_grains(grains_, load_,
                     {.keep = keep, .push = push, .dt = dt, .growth = growth, .largest = largest_move / dt});
    speed_ = sums.squares;
    state_.cell = growth * state_.cell;
    travelled_ += std::min(dt * sums.fastest, largest_move);
    strained_ += 3 * std::abs(cell_step);
  }

  std::vector<std::uint32_t> order_; ///< place of each grain of the outer state
  Specimen state_;                   ///< its cell is current, its centres after fetch_centres()
  contact::NormalKernel law_;
  std::optional<double> pressure_;
  MinimiseOptions options_;
  VerletList list_;
  Partition parts_;
  double largest_size_ = largest_size(state_);
  TranslatingGrains grains_;
  std::optional<WallContacts> walls_;
  std::vector<PushRow> load_;
  std::size_t list_age_ = 0; ///< steps since the list was built
  double travelled_ = 0;     ///< upper bound of own displacement since the list was built [m]
  double strained_ = 0;      ///< upper bound of the cell's strain since then [1]
  double speed_ = 0;         ///< sum of m v^2
  double cell_velocity_ = 0;
  double cell_inertia_;
  double stiffness_scale_ = 0;
  FireRule rule_;
};

void clear_tangential(Specimen& state) {
  state.velocity.assign(state.grain_count(), Vec3{});
  state.angular_velocity.assign(state.grain_count(), Vec3{});
  state.history.clear();
  if (state.walls)
    state.walls->history.clear();
}

RelaxReport minimise(Specimen& state, const contact::NormalLaw& law, std::optional<double> pressure,
                     const MinimiseOptions& options) {
  if (state.grain_count() == 0)
    throw InvalidArgument("minimise: the state has no grains");
  require_positive("radius", state.radius, "m");
  require_valid_sizes(state);
  require_simulable(law);
  clear_tangential(state);
  Minimiser minimiser(state, law, pressure, options);
  const RelaxReport report = minimiser.run();
  minimiser.put_into(state);
  return report;
}

} // namespace

double RelaxReport::pressure() const {
  if (!converged)
    throw NotConverged("minimiser: unbalanced force ratio " + short_text(unbalanced_force_ratio) + " after " +
                       std::to_string(steps) + " steps");
  return last_pressure;
}

RelaxReport minimise_energy(Specimen& state, const contact::NormalLaw& law, const MinimiseOptions& options) {
  return minimise(state, law, std::nullopt, options);
}

RelaxReport minimise_enthalpy(Specimen& state, const contact::NormalLaw& law, double pressure,
                              const MinimiseOptions& options) {
  require_positive("pressure", pressure, "Pa");
  return minimise(state, law, pressure, options);
}

} // namespace granum::dem

// SPDX-License-Identifier: GPL-3.0-or-later
// Notation: b branch from i to j, l = |b|, n = b/l, d overlap; v own velocity of a grain beyond the affine
// motion of the cell, w angular velocity; L velocity gradient of the cell; f and t force and torque on a
// grain; r = k_t/k_n.
#include <granum/dem/engine.hpp>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <tuple>
#include <variant>

#include <granum/core/error.hpp>

#include "engine_data.hpp"

namespace granum::dem {

namespace {

/// Steps between two choices of the time step; stiffnesses change slowly in quasi-static runs.
constexpr std::size_t time_step_interval = 100;
/// Skins over R, of the list and of the wider list from which it is made.
constexpr double list_skin = 0.02, list_wide_skin = 0.2;
/// Fraction of the adaptive drag in a descent. Without any, vibrations grow; from 0.1 to 0.3 the number of
/// steps varies by a tenth.
constexpr double descent_drag = 0.2;

void add(WallForces& forces, const WallForces& other) {
  for (std::size_t w = 0; w < wall_count; ++w)
    forces.force[w] += other.force[w];
  forces.contacts += other.contacts;
  forces.sliding += other.sliding;
}

} // namespace

Engine::Data::Data(Specimen initial, const Material& m, std::vector<std::uint32_t> given_order)
    : material(m), law(m.law.kernel()), tangential(m.tangential()),
      friction(std::min(m.friction_coefficient, 1e100)), order(std::move(given_order)),
      cold(std::move(initial)), list(cold, list_skin, list_wide_skin) {
  require_valid(m);
  require_positive("radius", cold.radius, "m");
  require_valid_sizes(cold);
  const std::size_t count = cold.grain_count();
  if (count == 0)
    throw InvalidArgument("engine: the state has no grains");
  if (cold.walls) {
    require_valid(*cold.walls);
    walls.emplace(std::min(cold.walls->friction_coefficient, 1e100));
  }
  mass = m.density * 4.0 / 3.0 * std::numbers::pi * std::pow(cold.radius, 3);
  inertia = mass * cold.radius * cold.radius;
  largest_size = dem::largest_size(cold);
  cold.velocity.resize(count);
  cold.angular_velocity.resize(count);
  for (const ContactHistory& contact : cold.history)
    if (contact.i >= count || contact.j >= count)
      throw InvalidArgument("engine: the state remembers a contact of a grain that it does not have");
  for (std::size_t k = 0; cold.walls && k < cold.walls->history.size(); ++k)
    if (cold.walls->history[k].grain >= count)
      throw InvalidArgument("engine: the state remembers a wall contact of a grain that it does not have");
  if (order.empty())
    order = near_order(cold);
  cold = reordered(cold, order);
  grains.resize(count);
  grains.set_sizes(own_sizes(cold, m.density));
  lightest = mass;
  for (const OwnSize& own : grains.own)
    lightest = std::min(lightest, own.mass);
  for (std::size_t g = 0; g < count; ++g) {
    grains.set_velocity(g, cold.velocity[g]);
    if (tangential)
      grains.set_spin(g, cold.angular_velocity[g]);
  }
  rebuild();
  sweep(0);
  // A kick without effect, for the sums over the present velocities.
  kick({.keep = 1, .push = 0, .turn = 0});
  choose_time_step();
}

std::vector<ContactHistory> Engine::Data::history() const {
  std::vector<ContactHistory> out;
  for (std::size_t b = 0; b < memory.size(); ++b)
    for (std::size_t k = 0; k < block_size; ++k) {
      const MemoryBlock& of = memory[b];
      const ListedPair& pair = parts.pairs[b * block_size + k];
      if (of.stiffness[k] > 0)
        out.push_back({pair.i().number(), pair.j().number(), {of.x[k], of.y[k], of.z[k]}, of.stiffness[k]});
    }
  return out;
}

/// Divides the list into chunks, and the chunks among the threads by numbers of pairs.
void Engine::Data::lay_out() {
  parts = partition(list.pairs(), grains.size());
  load.resize(parts.rows);
  sums.resize(parts.chunks.size());
  const std::size_t threads = team ? team->size() : 1;
  share.assign(threads + 1, parts.chunks.size());
  share[0] = 0;
  std::size_t member = 1;
  for (std::size_t c = 0; c < parts.chunks.size(); ++c) {
    const std::size_t twice_middle = parts.chunks[c].pairs.begin + parts.chunks[c].pairs.end;
    while (member < threads && threads * twice_middle > 2 * member * parts.pairs.size())
      share[member++] = c;
  }
}

/// At most one thread per chunk.
void Engine::Data::set_threads(std::size_t count) {
  const std::size_t used = std::min(count, parts.chunks.size());
  if (used == (team ? team->size() : 1))
    return;
  team.reset();
  if (used > 1)
    team = std::make_unique<Team>(used);
  lay_out();
}

/// Renews the list of pairs and moves the contact memories to their new positions. Both lists are sorted by
/// (i, j).
void Engine::Data::rebuild() {
  const bool running = steps > 0;
  if (running) {
    cold.history = history();
    if (walls)
      cold.walls->history = walls->history();
  }
  for (std::size_t g = 0; running && g < grains.size(); ++g)
    cold.position[g] = grains.centre(g);
  list.build(cold);
  lay_out();
  for (std::size_t g = 0; g < grains.size(); ++g)
    grains.set_centre(g, cold.position[g]);
  if (tangential) {
    memory.assign(parts.pairs.size() / block_size, MemoryBlock{});
    auto past = cold.history.begin();
    for (std::size_t k = 0; k < parts.pairs.size(); ++k) {
      const ListedPair& pair = parts.pairs[k];
      if (pair.image() == far_image)
        continue;
      const std::uint32_t i = pair.i().number(), j = pair.j().number();
      while (past != cold.history.end() && std::tie(past->i, past->j) < std::tie(i, j))
        ++past;
      if (past != cold.history.end() && past->i == i && past->j == j) {
        MemoryBlock& block = memory[k / block_size];
        block.x[k % block_size] = past->tangential_force.x;
        block.y[k % block_size] = past->tangential_force.y;
        block.z[k % block_size] = past->tangential_force.z;
        block.stiffness[k % block_size] = past->tangential_stiffness;
      }
    }
  }
  if (walls)
    walls->list(cold.cell, grains, cold.radius, list.skin(), cold.walls->history);
  travelled = 0;
  strained = 0;
}

void Engine::Data::sweep(double elapsed) {
  const SweepInput input{.pairs = parts.pairs,
                         .grains = grains,
                         .cell = cold.cell,
                         .gradient = gradient,
                         .diameter = 2 * cold.radius * largest_size,
                         .unit_radius = cold.radius,
                         .elapsed = elapsed,
                         .tangential_ratio = material.tangential_ratio,
                         .friction = friction};
  const auto contacts_of = [&](std::size_t c) {
    const Chunk& chunk = parts.chunks[c];
    sums[c].contacts = contact_sweep(law, input, chunk, tangential ? memory.data() : nullptr, load);
    if (walls)
      sums[c].walls = walls->sweep(law, input, chunk.grains, tangential, load, sums[c].contacts);
  };
  const auto settle = [&](std::size_t c) {
    sums[c].power = settle_loads(grains, parts.chunks[c], parts.additions, load);
  };
  if (team) {
    each_chunk(contacts_of);
    each_chunk(settle);
  } else {
    // j > i: only earlier chunks fill spare rows for a chunk, and those rows are still in the cache.
    each_chunk([&](std::size_t c) {
      contacts_of(c);
      settle(c);
    });
  }
  SweepSums total;
  WallForces on_walls;
  power = 0;
  for (const ChunkSums& chunk : sums) {
    total += chunk.contacts;
    power += chunk.power;
    add(on_walls, chunk.walls);
  }
  if (walls)
    walls->set_forces(on_walls);
  take_figures(total);
}

void Engine::Data::take_figures(const SweepSums& total) {
  const double volume = determinant(cold.cell);
  stiffest = total.stiffest;
  figures.stress = (1 / volume) * total.stress;
  figures.contacts = total.contacts;
  figures.sliding = total.sliding;
  figures.boundary_stress = {figures.stress(0, 0), figures.stress(1, 1), figures.stress(2, 2)};
  if (walls) {
    figures.boundary_stress = wall_stress(walls->forces(), wall_planes(cold.cell));
    figures.wall_contacts = walls->forces().contacts;
  }
  const std::size_t all = figures.contacts + figures.wall_contacts;
  figures.mean_normal_force = all > 0 ? total.normal_force / static_cast<double>(all) : 0;
  // <n1^4> = 1/5, <n1^2 (1 - n1^2)> = 2/15 for isotropic normals.
  const double ratio = tangential ? material.tangential_ratio : 0;
  figures.p_wave_modulus = total.stiffness * (1.0 / 5 + 2.0 / 15 * ratio) / volume;
}

/// True every time_step_interval steps, and at once when the largest stiffness or the number of contacts has
/// grown by a tenth.
bool Engine::Data::time_step_is_due() const {
  return steps % time_step_interval == 0 || stiffest > 1.1 * stiffest_chosen ||
         10 * (figures.contacts + figures.wall_contacts) > 11 * contacts_chosen;
}

void Engine::Data::choose_time_step() {
  stiffest_chosen = stiffest;
  contacts_chosen = figures.contacts + figures.wall_contacts;
  const FrequencyInput input{.parts = parts,
                             .grains = grains,
                             .cell = cold.cell,
                             .radius = cold.radius,
                             .tangential_ratio = tangential ? material.tangential_ratio : 0,
                             .mass = mass};
  const double omega_squared = frequency_bound.highest_squared(
      law, input, walls ? &*walls : nullptr,
      [this](const std::function<void(std::size_t)>& job) { each_chunk(job); });
  // Rough spheres at first contact are much softer than under load: one of their time steps would pass
  // through the whole roughness.
  const double least = 20 * material.law.first_stiffness() / lightest;
  if (omega_squared > 0) {
    dt = time_step_fraction * 2 / std::sqrt(std::max(omega_squared, least));
  } else if (dt == 0) {
    // No contact yet: the stiffness at an overlap of 1e-4 R.
    const double k_n = material.law.stiffness_at_overlap(1e-4 * cold.radius);
    dt = time_step_fraction * 2 / std::sqrt(std::max(20 * k_n / lightest, least));
  }
}

/// Moves cell and grains, and renews the pair list before an unlisted pair could touch.
void Engine::Data::move() {
  const Mat3 stretch = Mat3::identity() + dt * gradient;
  each_chunk([&](std::size_t c) { move_grains(grains, parts.chunks[c].grains, stretch, dt); });
  cold.cell = stretch * cold.cell;
  double rate = 0;
  for (const auto& row : gradient.m)
    for (const double value : row)
      rate += std::abs(value);
  travelled += dt * std::sqrt(motion.speed_squared);
  strained += dt * rate;
  if (list.may_be_outdated(travelled, strained))
    rebuild();
}

/// The drag follows the lowest frequency in the motion of the last step, omega^2 = -(change of force .
/// velocity)/(dt sum m v^2).
void Engine::Data::choose_damping() {
  if (fixed_damping >= 0) {
    damping = fixed_damping;
  } else if (motion.kinetic > 0) {
    const double work = motion.power - power;
    damping = std::clamp(2 * std::sqrt(std::max(0.0, work / (dt * motion.kinetic))), 0.0002 / dt, 0.5 / dt);
  }
}

/// FIRE: a fraction of the velocities keep v + push f/m is turned towards f/m; all grains stop when forces do
/// negative work. A grain without contacts stops at once, so that rattlers stay near their neighbours and C_n
/// hardly changes.
Engine::Data::Drive Engine::Data::turned_downhill(Drive drive) {
  each_chunk([&](std::size_t c) {
    hold_free_grains(grains, parts.chunks[c].grains, load);
    sums[c].pull = pull_of(grains, parts.chunks[c].grains, load, mass, inertia);
  });
  double pull = 0;
  for (const ChunkSums& chunk : sums)
    pull += chunk.pull;
  const auto [keep, push] = drive;
  if (!(keep * power + push * pull > 0)) {
    mixing.uphill();
    return {};
  }
  mixing.downhill();
  const double squares = keep * keep * motion.kinetic + 2 * keep * push * power + push * push * pull;
  const double towards = mixing.share * std::sqrt(std::max(0.0, squares) / pull);
  return {.keep = (1 - mixing.share) * keep, .push = (1 - mixing.share) * push + towards};
}

/// Velocities from forces with drag.
void Engine::Data::integrate() {
  choose_damping();
  const double drag = 0.5 * (descends ? descent_drag * damping : damping) * dt;
  Drive drive{.keep = (1 - drag) / (1 + drag), .push = dt / (1 + drag)};
  if (descends)
    drive = turned_downhill(drive);
  if (grains.own.empty())
    kick({.keep = drive.keep, .push = drive.push / mass, .turn = drive.push / inertia});
  else
    kick({.keep = drive.keep, .push = drive.push, .turn = drive.push});
}

void Engine::Data::kick(const Kick& of_step) {
  each_chunk([&](std::size_t c) {
    sums[c].motion = kick_grains(grains, parts.chunks[c].grains, load, of_step, mass, inertia);
  });
  motion = {};
  for (const ChunkSums& chunk : sums)
    motion += chunk.motion;
}

Engine::Engine(Specimen state, const Material& material)
    : data_(std::make_unique<Data>(std::move(state), material)) {}
Engine::Engine(std::unique_ptr<Data> data) : data_(std::move(data)) {}
Engine::~Engine() = default;
Engine::Engine(Engine&&) noexcept = default;
Engine& Engine::operator=(Engine&&) noexcept = default;

void Engine::set_velocity_gradient(const Mat3& gradient) { data_->gradient = gradient; }
void Engine::set_damping(double coefficient) {
  data_->fixed_damping = require_non_negative("damping", coefficient, "1/s");
  data_->descends = false;
}

void Engine::descend() {
  data_->fixed_damping = -1;
  data_->descends = true;
  data_->mixing = {};
}

void Engine::set_time_step_fraction(double fraction) {
  Data& d = *data_;
  if (!(fraction > 0 && fraction <= 1))
    throw InvalidArgument("time_step_fraction", fraction, "", "(0, 1]");
  if (fraction == d.time_step_fraction)
    return;
  d.dt *= fraction / d.time_step_fraction;
  d.time_step_fraction = fraction;
}

void Engine::set_threads(std::size_t count) {
  if (count < 1)
    throw InvalidArgument("threads", 0.0, "", "1 or more");
  data_->set_threads(count);
}

std::size_t Engine::threads() const { return data_->team ? data_->team->size() : 1; }

void Engine::step() {
  Data& d = *data_;
  ++d.steps;
  d.move();
  d.sweep(d.dt);
  d.integrate();
  if (d.time_step_is_due())
    d.choose_time_step();
}

const StepFigures& Engine::figures() const { return data_->figures; }
WallForces Engine::wall_forces() const { return data_->walls ? data_->walls->forces() : WallForces{}; }
double Engine::unbalanced_force_ratio() const {
  const bool equal = data_->grains.own.empty(); // otherwise the rows contain t/R
  const double per_radius_squared = equal ? 1 / (data_->cold.radius * data_->cold.radius) : 1;
  double sum = 0;
  std::size_t touching = 0;
  for (std::size_t g = 0; g < data_->grains.size(); ++g) {
    const LoadRow& on = data_->load[g];
    const Vec3 f = force(on), t = torque(on);
    const double squared = dot(f, f) + per_radius_squared * dot(t, t);
    if (squared > 0) {
      sum += std::sqrt(squared);
      ++touching;
    }
  }
  return touching > 0 ? sum / static_cast<double>(touching) / data_->figures.mean_normal_force : 0;
}

double Engine::time_step() const { return data_->dt; }
double Engine::diameter() const { return 2 * data_->cold.radius; }
const Mat3& Engine::cell() const { return data_->cold.cell; }
std::size_t Engine::steps() const { return data_->steps; }
const Material& Engine::material() const { return data_->material; }

double Engine::kinetic_energy() const { return data_->motion.kinetic / 2; }

bool Engine::finite() const {
  return std::isfinite(data_->motion.speed_squared) && std::isfinite(trace(data_->figures.stress));
}

void Engine::rest() {
  for (std::size_t g = 0; g < data_->grains.size(); ++g) {
    data_->grains.set_velocity(g, {});
    data_->grains.set_spin(g, {});
  }
  data_->motion = {};
}

Specimen Engine::state() const {
  Specimen out = data_->cold;
  for (std::size_t g = 0; g < data_->grains.size(); ++g) {
    out.position[g] = data_->grains.centre(g);
    out.velocity[g] = data_->grains.velocity(g);
    out.angular_velocity[g] = data_->grains.spin(g);
  }
  out.history = data_->history();
  if (data_->walls)
    out.walls->history = data_->walls->history();
  return reordered(out, inverse_order(data_->order));
}

} // namespace granum::dem

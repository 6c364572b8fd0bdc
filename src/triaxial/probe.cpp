// SPDX-License-Identifier: GPL-3.0-or-later
#include <granum/triaxial/probe.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <limits>
#include <numbers>
#include <random>
#include <string>
#include <utility>

#include <boost/random/uniform_real_distribution.hpp>

#include <granum/core/bytes.hpp>
#include <granum/core/error.hpp>
#include <granum/core/text.hpp>

namespace granum::triaxial {

namespace {

struct Plane {
  int stacked;
  int moving;
};

Plane plane(ShearMode mode) {
  switch (mode) {
  case ShearMode::hh:
    return {0, 1};
  case ShearMode::hv:
    return {0, 2};
  case ShearMode::vh:
    break;
  }
  return {2, 0};
}

dem::Material sticking(dem::Material material) {
  if (material.tangential())
    material.friction_coefficient = std::numeric_limits<double>::infinity();
  return material;
}

dem::Specimen sticking(dem::Specimen state) {
  if (state.walls && state.walls->friction_coefficient > 0)
    state.walls->friction_coefficient = std::numeric_limits<double>::infinity();
  return state;
}

double edge(const dem::Engine& engine) { return std::cbrt(determinant(engine.cell())); }

/// Drag that damps the slowest shear wave [1/s], as long as the cell or, between walls, twice as long: that
/// is all that moves after a leg.
double drag(const dem::Engine& engine, const dem::Specimen& state) {
  // Relaxed shear modulus over the p-wave modulus without relaxation: 0.2 in dense specimens, 0.02 near z* 4.
  constexpr double relaxed_share = 0.05;
  const double density = engine.material().density / (1 + dem::void_ratio(state));
  const double speed = std::sqrt(relaxed_share * engine.figures().p_wave_modulus / density);
  return 4 * std::numbers::pi * speed / ((state.walls ? 2 : 1) * edge(engine));
}

/// Steps in which the slowest shear wave crosses the cell several times, so that softer modes that still move
/// are seen.
std::size_t spell(const dem::Engine& engine) {
  return static_cast<std::size_t>(20 * std::ceil(edge(engine) / engine.diameter()));
}

double chosen_amplitude(const dem::Engine& engine) {
  const double overlap = engine.material().law.overlap(engine.figures().mean_normal_force);
  return 3e-5 * overlap / engine.diameter();
}

/// A specimen at rest at zero strain, about to be sheared.
struct Probed {
  dem::Engine engine;
  dem::QuasistaticOptions relax;
  dem::QuasistaticReport start;
  double amplitude;
};

/// Brings the specimen to rest in three stages: adaptive drag, descent, the drag of the waves. Grains with
/// two or three contacts come to rest last: their support is 1e-5 times as stiff as a contact. With the drag
/// of the waves they creep for tens of thousands of steps, under the adaptive drag for thousands; in a
/// descent they swing to their places. But while a rattler is being squeezed out, no grain comes to rest
/// either way. Then the last stage runs, which also ends when the stress settles.
dem::QuasistaticReport come_to_rest(dem::Engine& engine, double wave_drag,
                                    const dem::QuasistaticOptions& relax) {
  // Of either of the first two stages: a state that has not come to rest by then seldom does.
  constexpr std::size_t most_free_steps = 10000;
  constexpr double descent_from = 1e-5; // unbalanced force ratio; farther from rest, adaptive drag is faster
  dem::QuasistaticOptions forces_alone = relax;
  forces_alone.settled_stress = 0;
  forces_alone.max_steps = std::min(relax.max_steps, most_free_steps);
  forces_alone.force_tolerance = std::max(relax.force_tolerance, descent_from);
  dem::QuasistaticReport report = dem::deform(engine, Mat3{}, 0, forces_alone);
  const auto go_on = [&](const dem::QuasistaticOptions& options) {
    const std::size_t steps = report.steps;
    report = dem::deform(engine, Mat3{}, 0, options);
    report.steps += steps;
  };
  if (report.converged() && relax.force_tolerance < descent_from) {
    engine.descend();
    forces_alone.force_tolerance = relax.force_tolerance;
    go_on(forces_alone);
  }
  engine.set_damping(wave_drag);
  if (!report.converged())
    go_on(relax);
  return report;
}

Probed at_rest(const dem::Specimen& state, const dem::Material& material, const ProbeOptions& options) {
  require_non_negative("amplitude", options.amplitude);
  dem::Engine engine =
      options.sliding ? dem::Engine(state, material) : dem::Engine(sticking(state), sticking(material));
  require_non_negative("settled_share", options.settled_share);
  dem::QuasistaticOptions relax;
  relax.force_tolerance = options.force_tolerance;
  relax.stress_tolerance = options.force_tolerance;
  relax.max_steps = options.max_steps;
  relax.stop_requested = options.stop_requested;
  const double amplitude = options.amplitude > 0 ? options.amplitude : chosen_amplitude(engine);
  relax.settled_stress = options.settled_share * amplitude * engine.figures().p_wave_modulus;
  relax.settle_steps = spell(engine);
  dem::QuasistaticReport start = options.sliding ? dem::deform(engine, Mat3{}, 0, relax)
                                                 : come_to_rest(engine, drag(engine, state), relax);
  return {std::move(engine), std::move(relax), start, amplitude};
}

/// The cycle of one mode.
ProbeResult sheared(Probed specimen, ShearMode mode, const ProbeOptions& options) {
  dem::Engine& engine = specimen.engine;
  const dem::QuasistaticOptions& relax = specimen.relax;
  ProbeResult result;
  result.amplitude = specimen.amplitude;
  result.converged = true;
  const Plane sides = plane(mode);
  const int stacked = sides.stacked, moving = sides.moving;
  const auto shear_stress = [&](const dem::QuasistaticReport& report) {
    if (report.outcome == dem::Outcome::stopped)
      throw Stopped();
    result.converged = result.converged && (report.converged() || report.outcome == dem::Outcome::settled);
    result.steps += report.steps;
    result.unbalanced_force_ratio = std::max(result.unbalanced_force_ratio, report.unbalanced_force_ratio);
    return -(report.last_stress(moving, stacked) + report.last_stress(stacked, moving)) / 2;
  };
  const double start = shear_stress(specimen.start);
  const Vec3 held = engine.figures().boundary_stress;
  // A specimen that does not rest here drifts by more stress than the shear causes, and no leg would end.
  const auto hopeless = [&] { return !options.sliding && !result.converged; };
  if (hopeless())
    return result;
  const bool keep = options.loop_points > 0;
  if (keep)
    result.last_loop.push_back({0, 0});
  /// To a strain given in quarters of the cycle; returns the stress there.
  const auto leg = [&](int from, int to) {
    const std::size_t pieces = keep ? options.loop_points * static_cast<std::size_t>(std::abs(to - from)) : 1;
    const double piece = (to - from) * result.amplitude / static_cast<double>(pieces);
    Mat3 gradient;
    gradient(moving, stacked) = piece;
    double stress = 0;
    for (std::size_t k = 1; k <= pieces; ++k) {
      stress = shear_stress(options.hold_normal_stress
                                ? dem::shear_at_stress(engine, gradient, options.ramp_steps, held, relax)
                                : dem::deform(engine, gradient, options.ramp_steps, relax));
      if (keep)
        result.last_loop.push_back(
            {from * result.amplitude + static_cast<double>(k) * piece, stress - start});
    }
    return stress;
  };
  const std::size_t at_start = result.steps;
  const double up = leg(0, 1);
  if (hopeless())
    return result;
  const std::size_t at_first_end = result.steps;
  const double down = leg(1, -1);
  const std::size_t at_second_end = result.steps;
  const double end = leg(-1, 0);
  // Without sliding the cycle closes except for the creep of rattlers, which is steady at the end of a leg.
  const double creep = options.sliding ? 0 : (end - start) / static_cast<double>(result.steps - at_start);
  if (keep)
    leg(0, 1);
  const double swing = up - down + creep * static_cast<double>(at_second_end - at_first_end);
  result.last_shear_modulus = swing / (2 * result.amplitude);
  result.last_opening = std::abs(end - start) / std::abs(up - down);
  return result;
}

FrozenState frozen_once(const dem::Specimen& state, const dem::Material& material, double force_tolerance,
                        const StopRequest& stop_requested) {
  dem::Engine engine(sticking(state), sticking(material));
  FrozenState frozen{.last_state = {}, .report = {}, .force_tolerance = force_tolerance};
  frozen.report = come_to_rest(
      engine, drag(engine, state),
      {.force_tolerance = force_tolerance, .max_steps = 20000, .stop_requested = stop_requested});
  if (frozen.report.outcome == dem::Outcome::stopped)
    throw Stopped();
  engine.rest();
  frozen.last_state = engine.state();
  if (state.walls)
    frozen.last_state.walls->friction_coefficient = state.walls->friction_coefficient;
  return frozen;
}

void require_rest(bool at_rest, double unbalanced_force_ratio, const char* what) {
  if (!at_rest)
    throw NotConverged(std::string(what) + " did not come to rest: unbalanced force ratio " +
                       short_text(unbalanced_force_ratio));
}

} // namespace

double ProbeResult::shear_modulus() const {
  require_rest(converged, unbalanced_force_ratio, "a probe");
  return last_shear_modulus;
}

double ProbeResult::opening() const {
  require_rest(converged, unbalanced_force_ratio, "a probe");
  return last_opening;
}

const std::vector<LoopPoint>& ProbeResult::loop() const {
  require_rest(converged, unbalanced_force_ratio, "a probe");
  return last_loop;
}

const dem::Specimen& FrozenState::state() const {
  require_rest(at_rest(), report.unbalanced_force_ratio, "a frozen state");
  return last_state;
}

const Mat3& FrozenState::stress() const {
  require_rest(at_rest(), report.unbalanced_force_ratio, "a frozen state");
  return report.last_stress;
}

FrozenState freeze_in_place(const dem::Specimen& state, const dem::Material& material, double force_tolerance,
                            const StopRequest& stop_requested) {
  // Two of 32 loose flat specimens have a state that needs four or five.
  constexpr int tries = 6;
  FrozenState frozen = frozen_once(state, material, force_tolerance, stop_requested);
  for (int k = 1; k < tries && !frozen.at_rest(); ++k) {
    FrozenState next = frozen_once(frozen.last_state, material, force_tolerance, stop_requested);
    next.report.steps += frozen.report.steps;
    frozen = std::move(next);
  }
  return frozen;
}

ProbeResult probe(const dem::Specimen& state, const dem::Material& material, ShearMode mode,
                  const ProbeOptions& options) {
  return sheared(at_rest(state, material, options), mode, options);
}

std::array<ProbeResult, 3> probe_all(const dem::Specimen& state, const dem::Material& material,
                                     const ProbeOptions& options) {
  const Probed specimen = at_rest(state, material, options);
  ByteWriter bytes;
  specimen.engine.save(bytes);
  const auto one = [&](ShearMode mode) {
    ByteReader from(bytes.bytes(), "a specimen at rest");
    return sheared({dem::Engine::load(from, specimen.engine.material()), specimen.relax, specimen.start,
                    specimen.amplitude},
                   mode, options);
  };
  return {one(ShearMode::hh), one(ShearMode::hv), one(ShearMode::vh)};
}

namespace {

/// A cube of periodic faces in boxes, each wide enough that grains touch those of the next boxes only, and so
/// narrow that few grains fit in.
class Boxes {
 public:
  /// \param    diameter   of the largest grain
  Boxes(double edge, double diameter)
      : edge_(edge), along_(static_cast<std::size_t>(edge / diameter)),
        first_(along_ * along_ * along_, none) {}

  [[nodiscard]] bool is_free(const Vec3& x, double radius, const dem::Specimen& state) const {
    std::array<std::array<std::size_t, 3>, 3> near{};
    for (int axis = 0; axis < 3; ++axis) {
      const std::size_t k = index(x[axis]);
      near[static_cast<std::size_t>(axis)] = {k == 0 ? along_ - 1 : k - 1, k, k + 1 == along_ ? 0 : k + 1};
    }
    for (const std::size_t i : near[0])
      for (const std::size_t j : near[1])
        for (const std::size_t k : near[2])
          for (std::uint32_t g = first_[(i * along_ + j) * along_ + k]; g != none; g = next_[g])
            if (distance(x, state.position[g]) <= radius + state.radius_of(g))
              return false;
    return true;
  }

  void add(const Vec3& x) {
    std::uint32_t& first = first_[(index(x.x) * along_ + index(x.y)) * along_ + index(x.z)];
    next_.push_back(first);
    first = static_cast<std::uint32_t>(next_.size() - 1);
  }

 private:
  static constexpr std::uint32_t none = std::numeric_limits<std::uint32_t>::max();

  [[nodiscard]] std::size_t index(double x) const {
    return std::min(along_ - 1, static_cast<std::size_t>(x / edge_ * static_cast<double>(along_)));
  }
  [[nodiscard]] double distance(const Vec3& a, const Vec3& b) const {
    Vec3 d = a - b;
    for (int axis = 0; axis < 3; ++axis)
      d[axis] -= edge_ * std::round(d[axis] / edge_);
    return norm(d);
  }

  double edge_;
  std::size_t along_;
  std::vector<std::uint32_t> first_; ///< grain of each box, or none
  std::vector<std::uint32_t> next_;  ///< grain in the same box as this one, or none
};

} // namespace

dem::Specimen scattered_specimen(const SpecimenRecipe& recipe, double solid_fraction) {
  require_valid(recipe);
  if (!(solid_fraction > 0 && solid_fraction <= 0.3))
    throw InvalidArgument("solid_fraction", solid_fraction, "", "(0, 0.3]");
  dem::Specimen state;
  state.radius = recipe.radius;
  state.size = drawn_sizes(recipe);
  // Large grains come first, while there is room for them.
  std::sort(state.size.begin(), state.size.end(), std::greater<>());
  state.position.resize(recipe.grains);
  const double edge = std::cbrt(grain_volume(state) / solid_fraction);
  state.position.clear();
  state.cell = Mat3::diagonal(edge, edge, edge);
  Boxes boxes(edge, 2 * recipe.radius * largest_size(state));
  std::mt19937_64 random(recipe.seed);
  boost::random::uniform_real_distribution<double> along(0, edge);
  while (state.grain_count() < recipe.grains) {
    Vec3 x;
    for (int axis = 0; axis < 3; ++axis)
      x[axis] = along(random);
    if (!boxes.is_free(x, state.radius_of(state.grain_count()), state))
      continue;
    boxes.add(x);
    state.position.push_back(x);
  }
  return state;
}

} // namespace granum::triaxial

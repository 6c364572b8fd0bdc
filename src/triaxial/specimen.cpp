// SPDX-License-Identifier: GPL-3.0-or-later
#include <granum/triaxial/specimen.hpp>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <random>
#include <string>

#include <boost/random/uniform_real_distribution.hpp>

#include <granum/core/error.hpp>
#include <granum/sizes/distribution.hpp>

namespace granum::triaxial {

namespace {

using Random = std::mt19937_64;

/// Boost's distribution: the same numbers from the same bits on every standard library.
Vec3 uniform_in_cube(Random& random, double low, double high) {
  boost::random::uniform_real_distribution<double> along(low, high);
  const double x = along(random);
  const double y = along(random);
  const double z = along(random);
  return {x, y, z};
}

dem::Specimen seeds(const SpecimenRecipe& recipe) {
  dem::Specimen state;
  state.radius = recipe.radius;
  state.size = drawn_sizes(recipe);
  state.position.resize(recipe.grains);
  const double edge = std::cbrt(grain_volume(state) * (1 + recipe.expansion_void_ratio));
  Random random(recipe.seed);
  state.cell = Mat3::diagonal(edge, edge, edge);
  if (recipe.wall_friction)
    state.walls = dem::Walls{.friction_coefficient = *recipe.wall_friction, .history = {}};
  for (Vec3& x : state.position)
    x = uniform_in_cube(random, 0, edge);
  return state;
}

/// Overlaps are only to vanish here, so a linear law of any stiffness will do.
contact::PowerLaw linear_law(const SpecimenRecipe& recipe) {
  return contact::PowerLaw::flat(recipe.material.law.grain(), 0.01 * recipe.radius);
}

dem::RelaxReport arrived(const dem::RelaxReport& report, const std::string& stage) {
  if (report.stopped)
    throw Stopped();
  if (!report.converged)
    throw NotConverged("specimen preparation, " + stage + ": unbalanced force ratio " +
                       std::to_string(report.unbalanced_force_ratio) + " after " +
                       std::to_string(report.steps) + " steps");
  return report;
}

/// Grains grow at fixed cell from a solid fraction of 0.2 to the whole of the recipe's.
std::size_t expand(dem::Specimen& state, const SpecimenRecipe& recipe, const StopRequest& stop_requested) {
  constexpr double first_fraction = 0.2, last_stage = 0.55, stage = 0.05;
  const double full = 1 / (1 + recipe.expansion_void_ratio);
  const contact::NormalLaw law = linear_law(recipe);
  dem::MinimiseOptions options;
  options.overlap_tolerance = 1e-3;
  options.force_tolerance = 1e-2;
  options.stop_requested = stop_requested;
  std::size_t steps = 0;
  const auto relax_at = [&](double fraction) {
    state.radius = recipe.radius * std::cbrt(fraction / full);
    steps += arrived(dem::minimise_energy(state, law, options), "growth").steps;
  };
  for (double fraction = first_fraction; fraction < std::min(last_stage, full); fraction += stage)
    relax_at(fraction);
  relax_at(full);
  state.radius = recipe.radius;
  return steps;
}

} // namespace

std::size_t least_grains(const sizes::Distribution& sizes) {
  if (sizes.is_equal())
    return 40;
  const double narrowest = 4 * sizes.largest() + 0.6; // of the cell over R, the skin of the pair list with it
  const double grain = 4.0 / 3.0 * std::numbers::pi * 1.2 * sizes.moment(3); // and its voids at e = 0.2
  return std::max<std::size_t>(40, static_cast<std::size_t>(std::ceil(std::pow(narrowest, 3) / grain)));
}

std::vector<double> drawn_sizes(const SpecimenRecipe& recipe) {
  if (recipe.sizes.is_equal())
    return {};
  return sizes::sample_radii(recipe.sizes, recipe.grains, recipe.seed ^ 0xd1b54a32d192ed03ULL);
}

void require_valid(const SpecimenRecipe& recipe) {
  dem::require_valid(recipe.material);
  require_closed("radius", recipe.radius, 1e-9, 1e3, "m"); // its fifth power must fit into a double
  const std::size_t least = least_grains(recipe.sizes);
  if (recipe.grains < least || recipe.grains > 10'000'000)
    throw InvalidArgument(
        "grains", static_cast<double>(recipe.grains), "",
        "[" + std::to_string(least) + ", 1e7]" +
            (recipe.sizes.is_equal() ? "" : ": the cell must be wider than four of the largest grains"));
  if (recipe.wall_friction)
    dem::require_valid(dem::Walls{.friction_coefficient = *recipe.wall_friction, .history = {}});
  require_open("expansion_void_ratio", recipe.expansion_void_ratio, 0.4, 1.0);
  require_positive("first_pressure", recipe.first_pressure, "Pa");
  require_open("unjamming_strain", recipe.unjamming_strain, 0, 0.1);
  require_closed("agitation", recipe.agitation, 0, 0.5);
}

FrictionlessPacking frictionless_specimen(const SpecimenRecipe& recipe, const StopRequest& stop_requested) {
  require_valid(recipe);
  FrictionlessPacking preparation;
  preparation.state = seeds(recipe);
  preparation.minimiser_steps = expand(preparation.state, recipe, stop_requested);
  const auto compress = [&](double factor, double tolerance, std::size_t max_steps) {
    dem::MinimiseOptions options;
    options.force_tolerance = options.pressure_tolerance = tolerance;
    options.max_steps = max_steps;
    options.stop_requested = stop_requested;
    preparation.last = dem::minimise_enthalpy(preparation.state, recipe.material.law,
                                              factor * recipe.first_pressure, options);
    preparation.minimiser_steps += preparation.last.steps;
    return preparation.last;
  };
  constexpr double near = 1e-3;
  constexpr std::size_t patience = 30000, no_limit = 200000;
  for (const double factor : {100.0, 10.0})
    (void)arrived(compress(factor, near, no_limit), "frictionless compression");
  // Thousands of grains near isostaticity rearrange again and again before they rest without friction.
  if (!compress(1, 1e-5, patience).converged)
    (void)arrived(compress(1, near, no_limit), "frictionless compression");
  return preparation;
}

dem::Specimen unjam(dem::Specimen state, const SpecimenRecipe& recipe, const StopRequest& stop_requested) {
  require_valid(recipe);
  const double growth = 1 + recipe.unjamming_strain;
  Random random(recipe.seed ^ 0x9e3779b97f4a7c15ULL);
  state.cell = growth * state.cell;
  for (std::size_t g = 0; g < state.grain_count(); ++g) {
    const double reach = recipe.agitation * state.radius_of(g);
    state.position[g] = growth * state.position[g];
    if (reach > 0)
      state.position[g] += uniform_in_cube(random, -reach, reach);
  }
  dem::MinimiseOptions options;
  options.overlap_tolerance = 1e-6;
  options.stop_requested = stop_requested;
  const dem::RelaxReport report =
      arrived(dem::minimise_energy(state, linear_law(recipe), options), "unjamming");
  if (report.unbalanced_force_ratio < options.force_tolerance && report.pressure() > 0)
    throw NotConverged("unjamming_strain " + std::to_string(recipe.unjamming_strain) +
                       " does not unjam this specimen; make it larger");
  return state;
}

dem::Specimen start_of_compression(const dem::Specimen& frictionless, Density density,
                                   const SpecimenRecipe& recipe, const StopRequest& stop_requested) {
  return density == Density::loose ? unjam(frictionless, recipe, stop_requested) : frictionless;
}

dem::QuasistaticOptions compression_options() {
  dem::QuasistaticOptions options;
  options.inertial_number = 5e-4;
  options.force_tolerance = 1e-5;
  options.stress_tolerance = 1e-5;
  return options;
}

bool isotropic_path(dem::Specimen state, const dem::Material& material, const std::vector<double>& pressures,
                    const dem::QuasistaticOptions& options,
                    const std::function<bool(const Snapshot&)>& visit) {
  for (const double pressure : pressures) {
    dem::Engine engine(std::move(state), material);
    Snapshot snapshot;
    snapshot.pressure = pressure;
    snapshot.report = dem::equilibrate(engine, {pressure, pressure, pressure}, options);
    engine.rest();
    snapshot.state = engine.state();
    state = snapshot.state;
    if (!visit(snapshot) || !snapshot.report.converged())
      return false;
  }
  return true;
}

} // namespace granum::triaxial

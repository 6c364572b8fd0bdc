// SPDX-License-Identifier: GPL-3.0-or-later
// How the specimens of validation/relaxation and of validation/gradation are made.
#pragma once

#include <mutex>

#include <granum/contact/grains.hpp>
#include <granum/contact/normal_law.hpp>
#include <granum/contact/power_law.hpp>
#include <granum/dem/engine.hpp>
#include <granum/dem/quasistatic.hpp>
#include <granum/sizes/distribution.hpp>
#include <granum/triaxial/probe.hpp>
#include <granum/triaxial/specimen.hpp>

#include "../common.hpp"
#include "contact_counts.hpp"

namespace relaxation {

using namespace granum;

inline constexpr contact::GrainMaterial grain{.shear_modulus = 30e9, .poisson_ratio = 0.15};
inline constexpr double kPa = 1e3, MPa = 1e6;
/// Of the grains of Table 1 of the paper [Chung2014].
inline double usual_friction() { return contact::Friction::from_angle(26.5 * M_PI / 180).coefficient(); }

/// Mean stress and stress ratio q/p of one state on a path.
struct Stage {
  double pressure = 0;     ///< [Pa]
  double stress_ratio = 0; ///< (stress_v - stress_h)/p
};

/// How a jammed specimen is opened before friction is switched on.
struct Opening {
  double strain = 0.003;   ///< linear, each time
  double agitation = 0.03; ///< of the grains after it, over the radius
  int times = 1;
};
inline constexpr Opening slight{.strain = 0.01, .agitation = 0.1};
inline constexpr Opening stirred{.strain = 0.02, .agitation = 0.3};
/// To a solid fraction of 0.23.
inline constexpr Opening to_a_gas{.strain = 0.09, .agitation = 0.5, .times = 4};

/// One way to make a specimen, and its stress path.
struct Preparation {
  const char* name;
  triaxial::Density density = triaxial::Density::loose;
  double friction_coefficient; ///< of the compression
  std::vector<Stage> path;
  Opening opening = {};
  std::size_t grains = 4000;
  std::size_t max_steps = 40000; ///< of a stage
  double approach = 1;           ///< how many times faster than usual the first stage may be compressed
  double time_step_fraction = dem::default_time_step_fraction; ///< of the stability limit
  bool unfitted_shapes = false; ///< makes packings of the shapes that no fit sees as well
  std::string sizes = {};       ///< of the grains: a text of sizes::parse_distribution; empty: all are equal
};

inline Preparation gas(const char* name, double friction_coefficient, const std::vector<Stage>& path,
                       bool unfitted_shapes = false) {
  return {.name = name,
          .friction_coefficient = friction_coefficient,
          .path = path,
          .opening = to_a_gas,
          .grains = 2000,
          .max_steps = 200000,
          .approach = 20,
          .unfitted_shapes = unfitted_shapes};
}

inline sizes::Distribution sizes_of(const Preparation& preparation) {
  return preparation.sizes.empty() ? sizes::Distribution::equal()
                                   : sizes::parse_distribution(preparation.sizes);
}

/// \param    radius   of the grains, by number the mean [m]
inline triaxial::SpecimenRecipe recipe(const contact::NormalLaw& law, double radius,
                                       const Preparation& preparation, std::uint64_t seed) {
  return {.material = {.law = law,
                       .tangential_ratio = contact::mindlin_stiffness_ratio(grain.poisson_ratio),
                       .friction_coefficient = preparation.friction_coefficient},
          .radius = radius,
          .sizes = sizes_of(preparation),
          .grains = preparation.grains,
          .seed = seed,
          .first_pressure = preparation.path.front().pressure,
          .unjamming_strain = preparation.opening.strain,
          .agitation = preparation.opening.agitation};
}

/// Spheres of Table 1 of the paper [Chung2014].
inline triaxial::SpecimenRecipe sphere_recipe(std::size_t grains, std::uint64_t seed) {
  return {.material = {.law = contact::PowerLaw::sphere(grain, 0.5e-3),
                       .tangential_ratio = contact::mindlin_stiffness_ratio(grain.poisson_ratio),
                       .friction_coefficient = usual_friction()},
          .radius = 0.5e-3,
          .grains = grains,
          .seed = seed};
}

/// A frictionless specimen compressed with friction through these pressures: at rest under the last.
inline triaxial::Snapshot compressed(const dem::Specimen& frictionless, triaxial::Density density,
                                     const triaxial::SpecimenRecipe& recipe,
                                     const std::vector<double>& pressures) {
  triaxial::Snapshot last;
  const auto keep = [&last](const triaxial::Snapshot& snapshot) {
    last = snapshot;
    return snapshot.report.converged();
  };
  if (!triaxial::isotropic_path(triaxial::start_of_compression(frictionless, density, recipe),
                                recipe.material, pressures, triaxial::compression_options(), keep))
    throw std::runtime_error("a specimen did not come to rest");
  return last;
}

/// Specimens without friction at 10 kPa, each made once and then used by every preparation of its shape,
/// seed and grains.
class Packings {
 public:
  dem::Specimen get(const std::string& shape, triaxial::SpecimenRecipe recipe) {
    recipe.first_pressure = 10 * kPa;
    Entry& entry = find({shape, recipe.sizes.text(), recipe.seed, recipe.grains, recipe.radius});
    const std::lock_guard lock(entry.mutex);
    if (!entry.state)
      entry.state = triaxial::frictionless_specimen(recipe).state;
    return *entry.state;
  }

 private:
  struct Entry {
    std::mutex mutex;
    std::optional<dem::Specimen> state;
  };
  using Name = std::tuple<std::string, std::string, std::uint64_t, std::size_t, double>;
  Entry& find(const Name& name) {
    const std::lock_guard lock(mutex_);
    return entries_[name];
  }
  std::mutex mutex_;
  std::map<Name, Entry> entries_;
};

/// The state from which the path begins: jammed if it is to be dense, else opened as often as the preparation
/// says.
inline dem::Specimen start_of_path(const dem::Specimen& packing, const Preparation& preparation,
                                   const triaxial::SpecimenRecipe& recipe) {
  dem::Specimen state = triaxial::start_of_compression(packing, preparation.density, recipe);
  for (int opening = 1; opening < preparation.opening.times; ++opening) {
    triaxial::SpecimenRecipe again = recipe;
    again.seed += 1000 * static_cast<std::uint64_t>(opening);
    state = triaxial::unjam(std::move(state), again);
  }
  return state;
}

/// Goes on to a stage of the path. The loosest specimens creep for long: one that runs out of steps stays as
/// it stands, and its stress is measured on the contacts.
inline dem::Specimen at_stage(dem::Specimen state, const Preparation& preparation, std::size_t stage,
                              const dem::Material& material) {
  const auto [p, eta] = preparation.path[stage];
  const double stress_h = p * (1 - eta / 3), stress_v = p * (1 + 2 * eta / 3);
  dem::QuasistaticOptions options = triaxial::compression_options();
  options.max_steps = preparation.max_steps;
  options.inertial_number *= stage == 0 ? preparation.approach : 1;
  options.time_step_fraction = preparation.time_step_fraction;
  dem::Engine engine(std::move(state), material);
  const dem::QuasistaticReport report = dem::equilibrate(engine, {stress_h, stress_h, stress_v}, options);
  if (report.outcome == dem::Outcome::unstable)
    throw std::runtime_error("stage " + std::to_string(stage) + " became unstable");
  engine.rest();
  return engine.state();
}

/// Why a state is no packing at rest; empty for one that is.
inline std::string why_left_out(const triaxial::FrozenState& frozen, const dem::Material& material) {
  if (!frozen.at_rest())
    return "not at rest, unbalanced force ratio " + short_text(frozen.report.unbalanced_force_ratio, 2);
  if (!is_jammed(dem::contact_network(frozen.state(), material)))
    return "its steps ran out before the grains met";
  return "";
}

} // namespace relaxation

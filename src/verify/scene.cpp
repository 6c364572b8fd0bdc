// SPDX-License-Identifier: GPL-3.0-or-later
#include <granum/verify/scene.hpp>

#include <algorithm>
#include <thread>

#include <granum/contact/friction.hpp>
#include <granum/core/check.hpp>
#include <granum/core/error.hpp>
#include <granum/triaxial/shear_test.hpp>

namespace granum::verify {

std::string_view name(Shape shape) {
  switch (shape) {
  case Shape::cone:
    return "cone";
  case Shape::sphere:
    return "sphere";
  case Shape::flat:
    return "flat";
  case Shape::power_law:
    return "power-law";
  }
  throw InvalidArgument("contact shape is not one of the known ones");
}

std::string_view name(triaxial::Density density) {
  return density == triaxial::Density::dense ? "dense" : "loose";
}

std::size_t thread_count(const Scene& scene) {
  return scene.threads > 0 ? scene.threads : std::max(1U, std::thread::hardware_concurrency());
}

contact::PowerLaw law(const Scene& scene, Shape shape) {
  const contact::GrainMaterial grain{scene.grain_shear_modulus, scene.grain_poisson_ratio};
  switch (shape) {
  case Shape::cone:
    return contact::PowerLaw::cone(grain, scene.cone_slope);
  case Shape::sphere:
    return contact::PowerLaw::sphere(grain, scene.radius);
  case Shape::flat:
    return contact::PowerLaw::flat(grain, scene.punch_radius);
  case Shape::power_law:
    return contact::PowerLaw::general(grain, scene.alpha, scene.profile_constant);
  }
  throw InvalidArgument("contact shape is not one of the known ones");
}

triaxial::SpecimenRecipe recipe(const Scene& scene, Shape shape, std::uint64_t seed) {
  const contact::PowerLaw contact_law =
      law(scene, shape); // first: it names the grain's values that cannot be
  const double ratio = scene.tangential_ratio < 0
                           ? contact::mindlin_stiffness_ratio(scene.grain_poisson_ratio)
                           : scene.tangential_ratio;
  return {
      .material = {.law = contact_law,
                   .tangential_ratio = ratio,
                   .friction_coefficient = contact::Friction::from_angle(scene.friction_angle).coefficient(),
                   .density = scene.density},
      .radius = scene.radius,
      .grains = scene.grains,
      .seed = seed,
      .wall_friction = scene.walls ? std::optional(scene.wall_friction) : std::nullopt,
      .expansion_void_ratio = scene.expansion_void_ratio,
      .first_pressure = scene.pressures.front(),
      .unjamming_strain = scene.unjamming_strain,
      .agitation = scene.agitation};
}

namespace {

/// One kind of specimen twice would enter the mean over the seeds twice.
template <class Kind>
void require_distinct(const std::string& list, const std::vector<Kind>& kinds) {
  for (auto kind = kinds.begin(); kind != kinds.end(); ++kind)
    if (std::find(kinds.begin(), kind, *kind) != kind)
      throw InvalidArgument(list + ": " + std::string(name(*kind)) + " is given twice");
}

} // namespace

void require_valid(const Scene& scene) {
  if (scene.pressures.size() < 3)
    throw InvalidArgument("pressures: at least 3 are needed to fit an exponent, " +
                          std::to_string(scene.pressures.size()) + " given");
  double last = 0;
  for (const double pressure : scene.pressures) {
    require_positive("pressures", pressure, "Pa");
    if (!(pressure > last))
      throw InvalidArgument("pressures must rise: " + std::to_string(pressure) + " Pa follows " +
                            std::to_string(last) + " Pa");
    last = pressure;
  }
  for (const double pressure : scene.probe_pressures)
    if (std::find(scene.pressures.begin(), scene.pressures.end(), pressure) == scene.pressures.end())
      throw InvalidArgument("probe_pressures", pressure, "Pa", "the list of pressures");
  if (scene.contacts.empty() || scene.densities.empty())
    throw InvalidArgument("contacts and densities: at least one of each is needed");
  require_distinct("contacts", scene.contacts);
  require_distinct("densities", scene.densities);
  if (scene.seeds < 1 || scene.seeds > 1000)
    throw InvalidArgument("seeds", static_cast<double>(scene.seeds), "", "[1, 1000]");
  if (scene.threads > 1024)
    throw InvalidArgument("threads", static_cast<double>(scene.threads), "", "[0, 1024]");
  require_distinct("paths", scene.paths);
  require_closed("probe_eta_step", scene.probe_eta_step, 0, 3);
  require_closed("loop_strain", scene.loop_strain, 0, 0.01);
  triaxial::require_valid({.mean_stress = scene.pressures.back(),
                           .inertial_number = scene.inertial_number,
                           .eta_step = scene.eta_step,
                           .strain_step = scene.strain_step,
                           .largest_strain = scene.largest_strain});
  for (const Shape shape : scene.contacts)
    triaxial::require_valid(recipe(scene, shape, scene.first_seed));
}

} // namespace granum::verify

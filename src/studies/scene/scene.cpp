// SPDX-License-Identifier: GPL-3.0-or-later
#include "studies/scene/scene.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>
#include <thread>

#include "studies/scene/scene_keys.hpp"
#include <granum/contact/grains.hpp>
#include <granum/core/error.hpp>
#include <granum/core/text.hpp>
#include <granum/core/units.hpp>
#include <granum/triaxial/shear_test.hpp>

namespace granum::studies {

std::string_view name(triaxial::Density density) {
  return density == triaxial::Density::dense ? "dense" : "loose";
}

std::size_t thread_count(std::size_t asked) {
  return asked > 0 ? asked : std::max(1U, std::thread::hardware_concurrency());
}

std::size_t thread_count(const Scene& scene) { return thread_count(scene.study.threads); }

double tangential_ratio(const Scene& scene) {
  if (scene.grain.friction_angle == 0 && !(scene.specimen.walls && scene.specimen.wall_friction > 0))
    return 0; // no contact carries a tangential force
  return scene.contact.tangential_ratio ? contact::given_stiffness_ratio(*scene.contact.tangential_ratio)
                                        : contact::mindlin_stiffness_ratio(scene.grain.poisson_ratio);
}

contact::NormalLaw law(const Scene& scene, contact::Shape shape) {
  return contact::law_of(shape, {scene.grain.shear_modulus, scene.grain.poisson_ratio}, scene.grain.radius,
                         scene.contact.numbers);
}

triaxial::SpecimenRecipe recipe(const Scene& scene, contact::Shape shape, std::uint64_t seed) {
  return {.material = {.law = law(scene, shape),
                       .tangential_ratio = tangential_ratio(scene),
                       .friction_coefficient =
                           contact::Friction::from_angle(scene.grain.friction_angle).coefficient(),
                       .density = scene.grain.density},
          .radius = scene.grain.radius,
          .sizes = scene.grain.sizes,
          .grains = scene.study.grains,
          .seed = seed,
          .wall_friction = scene.specimen.walls ? std::optional(scene.specimen.wall_friction) : std::nullopt,
          .expansion_void_ratio = scene.specimen.expansion_void_ratio,
          .first_pressure = scene.study.pressures.front(),
          .unjamming_strain = scene.specimen.unjamming_strain,
          .agitation = scene.specimen.agitation};
}

namespace {

/// Mean force of a dense packing of the paper's spheres.
double predicted_force(const Scene& scene, double pressure) {
  constexpr double void_ratio = 0.558, coordination_number = 5.73;
  const double radius = scene.grain.radius;
  return 4 * std::numbers::pi * radius * radius * (1 + void_ratio) * pressure / coordination_number;
}

} // namespace

double predicted_overlap(const Scene& scene, contact::Shape shape, double pressure) {
  return law(scene, shape).overlap(predicted_force(scene, pressure)) / (2 * scene.grain.radius);
}

double contact_exponent(const Scene& scene, contact::Shape shape) {
  const double middle = std::sqrt(scene.study.pressures.front() * scene.study.pressures.back());
  return law(scene, shape).exponent_at_force(predicted_force(scene, middle));
}

namespace {

template <class Kind>
std::string_view name_of(const Kind& kind) {
  return name(kind);
}

/// One kind of specimen twice would enter the mean over the seeds twice.
template <class Kind>
void require_distinct(const std::string& list, const std::vector<Kind>& kinds) {
  for (auto kind = kinds.begin(); kind != kinds.end(); ++kind)
    if (std::find(kinds.begin(), kind, *kind) != kind)
      throw InvalidArgument(list + ": " + std::string(name_of(*kind)) + " is given twice");
}

void require_lists(const StudySection& study) {
  constexpr std::size_t most_pressures = 1000; // each is a state that is kept
  const std::vector<double>& pressures = study.pressures;
  if (pressures.size() < 3)
    throw InvalidArgument("study.pressures: at least 3 are needed to fit an exponent, " +
                          std::to_string(pressures.size()) + " given");
  if (pressures.size() > most_pressures)
    throw InvalidArgument("study.pressures: " + std::to_string(pressures.size()) + " are given, at most " +
                          std::to_string(most_pressures) + " are possible");
  for (std::size_t k = 1; k < pressures.size(); ++k)
    if (!(pressures[k] > pressures[k - 1]))
      throw InvalidArgument("study.pressures must rise: " + short_text(pressures[k], 6) + " Pa follows " +
                            short_text(pressures[k - 1], 6) + " Pa");
  for (const double pressure : study.probe_pressures)
    if (std::find(pressures.begin(), pressures.end(), pressure) == pressures.end())
      throw InvalidArgument("study.probe_pressures", pressure, "Pa",
                            "study.pressures; give pressures of that list, or [] for no probes");
  if (study.contacts.empty() || study.densities.empty())
    throw InvalidArgument("study.contacts and study.densities: at least one of each is needed");
  require_distinct("study.contacts", study.contacts);
  require_distinct("study.densities", study.densities);
}

/// A length within a grain must not exceed its size.
void require_within_grain(const Scene& scene, contact::Shape shape) {
  for (const contact::LawParameter& parameter : contact::row_of(shape).parameters) {
    const double value = value_of(parameter, scene.contact.numbers);
    if (parameter.within_grain && value > scene.grain.radius)
      throw InvalidArgument("contact." + parameter.key, value, "m",
                            "(0, grain.radius = " + exact_text(scene.grain.radius) + "]");
  }
}

void require_overlap(const Scene& scene, contact::Shape shape, double pressure) {
  const double overlap = predicted_overlap(scene, shape, pressure);
  if (overlap >= least_predicted_overlap && overlap <= largest_predicted_overlap)
    return;
  const std::string range = detail::closed_range(least_predicted_overlap, largest_predicted_overlap, overlap);
  throw InvalidArgument("study.pressures: at " + pretty(pressure, Dimension::pressure) + " " +
                        std::string(name(shape)) + " contacts of these grains would overlap by " +
                        detail::refused_text(overlap, range, 2) + " of a diameter, which is outside " +
                        range + ": " +
                        (overlap < least_predicted_overlap
                             ? "rounding of the positions would disturb the forces"
                             : "the contact law is valid only for small overlaps, and the voids would "
                               "close"));
}

/// Measurements between walls are made two diameters inside: the number of grains that leaves one diameter
/// there, packed as densely as they can be.
void require_inside(const Scene& scene) {
  constexpr double edge = 2 * 4 + 2, densest = 0.55; // in radii
  const double volume = 4 * std::numbers::pi / 3 * scene.grain.sizes.moment(3) * (1 + densest);
  const double least = std::ceil(edge * edge * edge / volume);
  if (scene.specimen.walls && static_cast<double>(scene.study.grains) < least)
    throw InvalidArgument(
        "study.grains", static_cast<double>(scene.study.grains), "",
        "numbers of at least " + short_text(least) +
            ": with specimen.boundary = walls, only grains two diameters away from the walls are measured");
}

} // namespace

std::vector<SpecimenName> specimens_of(const Scene& scene) {
  const StudySection& study = scene.study;
  std::vector<SpecimenName> out;
  for (std::size_t shape = 0; shape < study.contacts.size(); ++shape)
    for (const triaxial::Density density : study.densities)
      for (std::size_t k = 0; k < study.seeds; ++k)
        out.push_back({study.contacts[shape], density, study.first_seed + k, shape * study.seeds + k});
  return out;
}

void require_periodic_cell(const Scene& scene) {
  if (scene.specimen.walls)
    throw InvalidArgument("specimen.boundary = walls: this command works in the periodic cell only; granum "
                          "reproduce also has walls");
}

void require_valid(const Scene& scene) {
  for (const SceneKey& key : scene_keys())
    require_in_range(key, scene);
  require_lists(scene.study);
  require_distinct("shear.paths", scene.shear.paths);
  require_inside(scene);
  triaxial::require_valid({.mean_stress = scene.study.pressures.back(),
                           .inertial_number = scene.shear.inertial_number,
                           .eta_step = scene.shear.eta_step,
                           .strain_step = scene.shear.strain_step,
                           .largest_strain = scene.shear.largest_strain});
  for (const contact::Shape shape : scene.study.contacts) {
    require_within_grain(scene, shape);
    triaxial::require_valid(recipe(scene, shape, scene.study.first_seed));
    for (const double pressure : {scene.study.pressures.front(), scene.study.pressures.back()})
      require_overlap(scene, shape, pressure);
  }
}

} // namespace granum::studies

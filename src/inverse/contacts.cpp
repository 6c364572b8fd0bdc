// SPDX-License-Identifier: GPL-3.0-or-later
#include <granum/inverse/contacts.hpp>

#include <array>
#include <cmath>

#include <granum/core/error.hpp>

namespace granum::inverse {

namespace {

constexpr std::array<std::string_view, 3> all_names{"given", "rough", "power-law"};

const contact::PowerLaw& smooth_sphere(const contact::NormalLaw& given) {
  const contact::PowerLaw* const law = given.power_law();
  if (law == nullptr || law->alpha() != 2)
    throw InvalidArgument(
        "inferred contacts replace the law of smooth spheres: the given law must be of smooth spheres");
  return *law;
}

} // namespace

std::span<const std::string_view> unknown_contact_names() { return all_names; }

contact::PowerLaw power_law_through(const contact::GrainMaterial& grain, double alpha, double force,
                                    double stiffness) {
  require_positive("alpha", alpha);
  require_positive("force", force, "N");
  require_positive("stiffness", stiffness, "N/m");
  // k_n = m f/d, so that d = m f/k_n and c = f/d^m.
  const double m = 1 + 1 / alpha;
  return contact::PowerLaw::of_numbers(grain, {alpha, force * std::pow(m * force / stiffness, -m)});
}

UnknownContacts unknown_contacts(std::string_view name) {
  if (name == "given")
    return {};
  if (name == "rough")
    return {.name = "rough",
            .numbers = {{.key = "roughness", .expected = 20e-9, .scatter = std::log(10.0), .unit = "m"}},
            .law = [](const contact::NormalLaw& given, double, std::span<const double> numbers) {
              return contact::RoughSphere::of_numbers(given.grain(),
                                                      {2, smooth_sphere(given).coefficient(), numbers[0]});
            }};
  if (name == "power-law")
    return {.name = "power-law",
            .numbers = {{.key = "softness", .expected = 1, .scatter = std::log(3.0)},
                        {.key = "alpha", .expected = 2, .scatter = std::log(2.0)}},
            .law = [](const contact::NormalLaw& given, double force, std::span<const double> numbers) {
              const double hertz = smooth_sphere(given).stiffness_at_force(force);
              return power_law_through(given.grain(), numbers[1], force, numbers[0] * hertz);
            }};
  throw InvalidArgument("contacts '" + std::string(name) + "' is unknown; known are given, rough, power-law");
}

} // namespace granum::inverse

// SPDX-License-Identifier: GPL-3.0-or-later
#include <granum/estimate/question.hpp>

#include <algorithm>
#include <cmath>
#include <numbers>

#include <granum/core/error.hpp>
#include <granum/core/text.hpp>
#include <granum/effective/relaxation.hpp>
#include <granum/elastic/isotropic.hpp>
#include <granum/estimate/input_values.hpp>
#include <granum/estimate/inputs.hpp>
#include <granum/stress/stress.hpp>

#include "parts.hpp"

namespace granum::estimate {

std::string_view name(GrainShape shape) { return shape == GrainShape::sand ? "sand" : "sphere"; }

GrainShape grain_shape_of(std::string_view text) {
  for (const GrainShape shape : all_grain_shapes)
    if (name(shape) == text)
      return shape;
  throw InvalidArgument("grain_shape is sphere or sand, not '" + std::string(text) + "'");
}

namespace {

constexpr double degree = std::numbers::pi / 180;

/// Friction angle without which the stresses are not possible; 0 without stress.
double mobilised_friction_angle(const Question& q) {
  return q.state.stress_v > 0 ? stress::mobilised_friction_angle({q.state.stress_v, q.state.stress_h}) : 0;
}

} // namespace

void require_possible(const Question& q) {
  require_closed("saturation", q.saturation, 0, 1);
  if (q.grain_density)
    require_positive("grain_density", *q.grain_density, "kg/m3");
  if (q.grain_shape == GrainShape::sand) {
    sands::require_sand(q.sand);
    effective::require_valid(q.state);
    return;
  }
  if (q.shear_strain)
    throw InvalidArgument(
        "shear_strain", *q.shear_strain, "",
        "what spheres have: the laws of strain are measured on sands; for spheres only small "
        "strain is available");
  if (q.sand.uniformity.value_or(1) > sphere_uniformity_limit)
    throw InvalidArgument("uniformity", *q.sand.uniformity, "",
                          "[1, 4] for spheres, the validated range; use grain shape sand");
}

void require_valid(const Question& q) {
  for (const InputRow& row : inputs())
    if (const std::optional<double> value = row.read != nullptr ? row.read(q) : std::nullopt)
      require_within(row, *value, row.name(), true); // a hint on signs is the door's
  sands::require_density(q.sand, q.state.void_ratio);
  if (q.grain_shape == GrainShape::sphere)
    effective::require_valid(q.preparation, q.state);
  constexpr double rounding = 1e-9;
  const double v = q.state.stress_v, least = stress::least_stress_ratio * v * (1 - rounding),
               largest = stress::largest_stress_ratio * v * (1 + rounding);
  if (v > 0 && !(q.state.stress_h >= least && q.state.stress_h <= largest))
    throw InvalidArgument("stress_h", q.state.stress_h, "Pa",
                          detail::closed_range(least, largest, q.state.stress_h) +
                              ": friction of 70 degrees holds no other beside this stress_v");
  require_possible(q);
}

void note_strength(const Question& q, Validity& validity) {
  constexpr double strongest_soil = 50 * degree;
  if (const double angle = mobilised_friction_angle(q); angle > strongest_soil)
    validity.add("stress_h is " + short_text(q.state.stress_h / q.state.stress_v) +
                 " stress_v (K_0): only a friction angle of " + short_text(angle / degree, 3) +
                 " degrees holds that, and soils have at most 50");
}

double assumed_fabric_deviation(double stress_v, double stress_h) {
  constexpr double poured = 0.05, by_shear = 0.2;
  return std::hypot(poured, stress_v > 0 && stress_h > 0 ? by_shear * std::log(stress_v / stress_h) : 0);
}

contact::GrainMaterial grain_of(const InputValues& values) {
  const double modulus = values.number(Input::grain_shear_modulus);
  if (!values.given(Input::grain_bulk_modulus))
    return {modulus, values.number(Input::grain_poisson_ratio)};
  if (values.stated(Input::grain_poisson_ratio))
    throw InvalidArgument(values.spelled(conflict::grain));
  const double bulk = values.number(Input::grain_bulk_modulus);
  require_positive(values.name(Input::grain_bulk_modulus), bulk, "Pa");
  require_positive(values.name(Input::grain_shear_modulus), modulus, "Pa");
  return {modulus, elastic::Isotropic::from_bulk_and_shear(bulk, modulus).poisson_ratio()};
}

// ---- contact law and sizes

namespace {

/// Numbers of other laws are not given, and those without a published default are.
void require_numbers_of_contact(const InputValues& values) {
  const std::string contact = values.name(Input::contact), chosen(contact::name(values.contact));
  std::string needed;
  bool missing = false;
  for (const InputRow& row : inputs()) {
    if (row.law == nullptr)
      continue;
    const bool own = row.law->shape == values.contact;
    if (!own && values.given(row.input))
      throw InvalidArgument(values.name(row.input) + " goes with " + contact + " " +
                            std::string(contact::name(row.law->shape)) + ", not with " + contact + " " +
                            chosen);
    if (own && row.origin.empty()) {
      needed += (needed.empty() ? "" : " and ") + values.name(row.input);
      missing = missing || !values.given(row.input);
    }
  }
  if (missing)
    throw InvalidArgument(contact + " " + chosen + " needs " + needed);
}

} // namespace

contact::NormalLaw law_of(const InputValues& values) {
  if (values.law)
    return grain_of(values) == values.law->grain() ? *values.law : values.law->of_grain(grain_of(values));
  return law_of(values, grain_of(values), radius_of(values) * contact_means_of(values).pair_radius);
}

contact::NormalLaw law_of(const InputValues& values, const contact::GrainMaterial& grain, double radius) {
  require_numbers_of_contact(values);
  contact::LawNumbers numbers;
  for (const InputRow& row : inputs())
    if (row.law != nullptr)
      numbers[row.parameter->key] = values.number(row.input);
  return contact::law_of(values.contact, grain, radius, numbers);
}

double radius_of(const InputValues& values) {
  if (values.law)
    return values.within(Input::radius);
  const bool by_radius = values.given(Input::radius), by_d50 = values.given(Input::d50);
  if (by_radius && by_d50)
    throw InvalidArgument(values.spelled(conflict::size));
  if (const std::optional<double> of_sieve = values.sizes ? values.sizes->mean_radius() : std::nullopt) {
    if (by_radius || by_d50)
      throw InvalidArgument("the sieve curve gives the size of the grains: leave out " +
                            values.name(by_radius ? Input::radius : Input::d50));
    return *of_sieve;
  }
  const double size = values.within(by_d50 ? Input::d50 : Input::radius);
  if (!by_d50)
    return size;
  return values.sizes ? sizes::mean_radius_of(*values.sizes, size) : size / 2;
}

sizes::ContactMeans contact_means_of(const InputValues& values) {
  if (values.contact_means)
    return *values.contact_means;
  if (!values.sizes)
    return {};
  double rattlers = 0;
  const double z = values.number(Input::mechanical_coordination_number);
  if (values.given(Input::rattler_fraction))
    rattlers = values.number(Input::rattler_fraction);
  else if (values.given(Input::coordination_number) && values.given(Input::mechanical_coordination_number) &&
           z > 0)
    rattlers = std::max(0.0, 1 - values.number(Input::coordination_number) / z);
  return sizes::expected_contact_means(*values.sizes, rattlers);
}

// ---- state

namespace {

bool gives_density(const InputValues& values) {
  return values.given(Input::void_ratio) || values.given(Input::porosity) ||
         values.given(Input::solid_fraction);
}

/// A share of the volume whose void ratio is possible.
double open_share(const InputValues& values, Input input) {
  const double least = row_of(Input::void_ratio).limits.low;
  return require_closed(values.name(input), values.within(input), least, 1 - least);
}

double void_ratio_of(const InputValues& values) {
  if (!gives_density(values))
    throw InvalidArgument(
        values.spelled("the density is missing: give one of {void_ratio}, {porosity}, {solid_fraction}"));
  if (values.given(Input::void_ratio) + values.given(Input::porosity) + values.given(Input::solid_fraction) >
      1)
    throw InvalidArgument(values.spelled(conflict::density));
  if (values.given(Input::porosity)) {
    const double porosity = open_share(values, Input::porosity);
    return porosity / (1 - porosity);
  }
  if (values.given(Input::solid_fraction)) {
    const double solid_fraction = open_share(values, Input::solid_fraction);
    return (1 - solid_fraction) / solid_fraction;
  }
  return values.within(Input::void_ratio);
}

} // namespace

stress::AxialStress stresses_of(const InputValues& values) {
  const bool v = values.given(Input::stress_v), h = values.given(Input::stress_h);
  if (values.given(Input::pressure)) {
    if (v || h)
      throw InvalidArgument(values.spelled(conflict::stress));
    const double pressure = values.within(Input::pressure);
    return {pressure, pressure};
  }
  if (!v && !h)
    throw InvalidArgument(
        values.spelled("the stress is missing: give {pressure}, or {stress_v} and {stress_h}"));
  if (!v || !h)
    throw InvalidArgument(values.name(v ? Input::stress_h : Input::stress_v) +
                          values.spelled(" is missing: {stress_v} and {stress_h} go together, or give "
                                         "{pressure} for both"));
  return {values.number(Input::stress_v), values.number(Input::stress_h)};
}

effective::State state_of(const InputValues& values, const stress::AxialStress& stress) {
  if (values.stated(Input::fines) && known_shape(values) == GrainShape::sphere)
    throw InvalidArgument(values.name(Input::fines) +
                          " is silt and clay of a sand: spheres have a sieve curve");
  const effective::State state{
      .law = law_of(values),
      .tangential_ratio = values.given(Input::tangential_ratio)
                              ? contact::given_stiffness_ratio(values.number(Input::tangential_ratio))
                              : contact::mindlin_stiffness_ratio(grain_of(values).poisson_ratio),
      .radius = radius_of(values),
      .void_ratio = void_ratio_of(values),
      .coordination_number = values.if_given(Input::coordination_number),
      .mechanical_coordination_number = values.if_given(Input::mechanical_coordination_number),
      .fabric_anisotropy = values.number(Input::fabric),
      .stress_v = stress.v,
      .stress_h = stress.h,
      .contacts = contact_means_of(values),
      .pair_shares = mixed_contacts_of(values).pair_shares,
      .rolling = values.within(Input::rolling)};
  effective::require_valid(state);
  return state;
}

std::optional<double> uniformity_of(const InputValues& values) {
  if (values.given(Input::uniformity))
    return values.number(Input::uniformity);
  if (values.sizes)
    return sizes::gradation(*values.sizes, 1).uniformity();
  return values.known_sand != nullptr ? values.known_sand->uniformity : std::nullopt;
}

namespace {

/// The share of silt and clay: as it is given, or of a sieve curve.
std::optional<double> fines_of(const InputValues& values) {
  if (values.given(Input::fines) || !values.sizes || !values.sizes->mean_radius())
    return values.given(Input::fines) ? std::optional(values.within(Input::fines)) : std::nullopt;
  constexpr double by_mass = 3;
  return values.sizes->share_below(sands::silt_size / 2 / *values.sizes->mean_radius(), by_mass);
}

} // namespace

sands::Sand sand_of(const InputValues& values) {
  sands::Sand sand{.uniformity = uniformity_of(values), .fines = fines_of(values)};
  const bool sized = values.given(Input::d50) || (values.given(Input::radius) && !values.law);
  if (values.sizes) {
    if (values.sizes->mean_radius() || sized)
      sand.d50 = sizes::gradation(*values.sizes, radius_of(values)).d50;
    if (sand.d50 && *sand.d50 < sands::silt_size)
      throw InvalidArgument(values.name(values.given(Input::sieve) ? Input::sieve : Input::sizes) +
                            " has d50 = " + short_text(*sand.d50 * 1e3) + " mm: finer than 0.063 mm the " +
                            "ground is silt or clay, to which laws of sands do not apply");
  } else if (values.law)
    sand.d50 = values.if_given(Input::d50);
  else if (sized)
    sand.d50 = 2 * radius_of(values);
  if (values.known_sand != nullptr)
    sand.tests = values.known_sand->tests;
  if (values.sizes || values.given(Input::uniformity) || values.given(Input::fines) ||
      values.stated(Input::least_void_ratio) || values.stated(Input::largest_void_ratio))
    sand.tests.reset(); // of another batch
  sand.least_void_ratio = values.if_given(Input::least_void_ratio);
  sand.largest_void_ratio = values.if_given(Input::largest_void_ratio);
  sand.relative_density = values.if_given(Input::relative_density);
  sand.quartz = std::all_of(values.minerals.begin(), values.minerals.end(), [](const auto& part) {
    const std::string_view mineral = part.mineral->key;
    return mineral == "quartz" || mineral == "feldspar";
  });
  return sand;
}

Question question_of(const InputValues& values) {
  if (!gives_density(values) && !values.given(Input::pressure) && !values.given(Input::stress_v) &&
      !values.given(Input::stress_h))
    throw InvalidArgument(
        values.spelled("density and stress are missing: give {void_ratio}, {porosity} or {solid_fraction}, "
                       "and {pressure}, or {stress_v} and {stress_h}"));
  // A row of a table may contain all three numbers of contacts: C_n and z* are enough.
  const bool enough = values[Input::coordination_number].source == Source::table &&
                      values[Input::mechanical_coordination_number].source == Source::table;
  effective::Preparation preparation = values.preparation;
  if (known_shape(values) == GrainShape::sphere &&
      values.stated(Input::least_void_ratio)) // that of a named sand is of no spheres
    preparation.densest_void_ratio = values.number(Input::least_void_ratio);
  return {.state = state_of(values, stresses_of(values)),
          .preparation = preparation,
          .rattler_fraction = enough || !values.given(Input::rattler_fraction)
                                  ? std::nullopt
                                  : std::optional(values.within(Input::rattler_fraction)),
          .grain_density = values.without_density && !values.given(Input::grain_density)
                               ? std::nullopt
                               : std::optional(values.within(Input::grain_density)),
          .saturation = values.within(Input::saturation),
          .grain_shape = known_shape(values).value_or(GrainShape::sphere),
          .sand = sand_of(values),
          .shear_strain = values.given(Input::shear_strain)
                              ? std::optional(values.within(Input::shear_strain))
                              : std::nullopt};
}

} // namespace granum::estimate

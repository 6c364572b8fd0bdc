// SPDX-License-Identifier: GPL-3.0-or-later
#include <granum/estimate/input_values.hpp>

#include <algorithm>
#include <cmath>
#include <utility>

#include <granum/core/error.hpp>

#include "parts.hpp"

namespace granum::estimate {

namespace {

std::size_t index_of(Input input) { return static_cast<std::size_t>(input); }

/// The defaults of all rows.
const std::vector<InputValue>& defaults() {
  static const std::vector<InputValue> all = [] {
    std::vector<InputValue> values;
    for (const InputRow& row : inputs())
      values.push_back({.number = row.by_default.value_or(0)});
    return values;
  }();
  return all;
}

} // namespace

InputValues::InputValues() : values_(defaults()) {}

const InputValue& InputValues::operator[](Input input) const { return values_[index_of(input)]; }

std::optional<double> InputValues::if_given(Input input) const {
  return given(input) ? std::optional(number(input)) : std::nullopt;
}

double InputValues::within(Input input) const {
  const InputValue& value = (*this)[input];
  require_within(row_of(input), value.number, name(input), value.per_cent || by_keywords);
  return value.number;
}

void InputValues::give(Input input, double number, Source source, bool per_cent) {
  values_[index_of(input)] = {.number = number, .source = source, .per_cent = per_cent};
  if (input == Input::uniformity && !law)
    set_sizes(sizes::Distribution::uniformity(number));
}

void InputValues::give(contact::NormalLaw made) {
  give(Input::grain_shear_modulus, made.grain().shear_modulus);
  give(Input::grain_poisson_ratio, made.grain().poisson_ratio);
  law = std::move(made);
}

void InputValues::give(Input input, const std::string& text, Source source) {
  row_of(input).take(*this, text);
  values_[index_of(input)].source = source;
}

void InputValues::give(Input input, sizes::Distribution distribution) {
  set_sizes(std::move(distribution));
  values_[index_of(input)].source = Source::typed;
}

void InputValues::imply(Input input, double number, double deviation) {
  if (!stated(input))
    values_[index_of(input)] = {.number = number, .deviation = deviation, .source = Source::implied};
}

void InputValues::leave_out(Input input) { values_[index_of(input)] = defaults()[index_of(input)]; }

void InputValues::set_stresses(const stress::AxialStress& stress) {
  leave_out(Input::pressure);
  for (const auto& [input, number] : {std::pair{Input::stress_v, stress.v}, {Input::stress_h, stress.h}})
    values_[index_of(input)] = {.number = number, .source = Source::implied};
}

void InputValues::set_sizes(sizes::Distribution distribution) {
  if (sizes)
    throw InvalidArgument(spelled(conflict::sizes));
  sizes = std::move(distribution);
}

std::string InputValues::name(Input input) const {
  const InputRow& row = row_of(input);
  return by_keywords ? std::string(row.name()) : row.option();
}

std::string InputValues::spelled(std::string_view sentence) const {
  std::string out;
  for (std::size_t at = sentence.find('{'); at != std::string_view::npos; at = sentence.find('{')) {
    const std::size_t end = sentence.find('}', at);
    const InputRow* const row = find_input(sentence.substr(at + 1, end - at - 1));
    out += std::string(sentence.substr(0, at)) + (row != nullptr ? name(row->input) : "");
    sentence.remove_prefix(end + 1);
  }
  return out + std::string(sentence);
}

std::optional<GrainShape> known_shape(const InputValues& values) {
  if (values.grain_shape)
    return values.grain_shape;
  if (values.known_sand != nullptr)
    return GrainShape::sand;
  const auto made = [](const contact::MineralShare& part) {
    const std::string_view key = part.mineral->key;
    return key == "glass" || key == "steel";
  };
  if (!values.minerals.empty() && std::all_of(values.minerals.begin(), values.minerals.end(), made))
    return GrainShape::sphere;
  for (const GrainShape shape : {GrainShape::sand, GrainShape::sphere})
    if (std::any_of(inputs().begin(), inputs().end(),
                    [&](const InputRow& row) { return row.implies == shape && values.given(row.input); }))
      return shape;
  return values.ground ? std::optional(GrainShape::sand) : std::nullopt;
}

effective::MixedContacts mixed_contacts_of(const InputValues& values) {
  if (values.minerals.size() < 2)
    return {};
  for (const Input own : {Input::grain_shear_modulus, Input::grain_poisson_ratio, Input::grain_bulk_modulus})
    if (values.stated(own))
      throw InvalidArgument("several minerals set the moduli of the grains: leave out " + values.name(own));
  std::vector<contact::GrainMaterial> materials;
  std::vector<double> shares;
  for (const auto& [mineral, share] : values.minerals) {
    materials.push_back(mineral->material);
    shares.push_back(share);
  }
  constexpr double any_radius = 1e3; // [m] no grain is larger, and exponents are those of every radius
  const std::optional<double> b = law_of(values, materials.front(), any_radius).constant_exponent();
  if (!b)
    throw InvalidArgument(
        "several minerals need a contact law whose exponent is the same at every force, not " +
        std::string(contact::name(values.contact)));
  return effective::mixed_contacts(materials, shares, *b);
}

// ---- what values imply

namespace {

void imply_by_sand(InputValues& values) {
  if (values.known_sand == nullptr)
    return;
  const sands::KnownSand& sand = *values.known_sand;
  if (values.minerals.empty())
    values.minerals = contact::mineral_shares(sand.mineral);
  const bool sized = (values.given(Input::radius) && !values.law) || values.stated(Input::d50) ||
                     (values.sizes && values.sizes->mean_radius());
  if (sand.d50 && !sized)
    values.imply(Input::d50, *sand.d50);
  if (sand.least_void_ratio)
    values.imply(Input::least_void_ratio, *sand.least_void_ratio);
  if (sand.largest_void_ratio)
    values.imply(Input::largest_void_ratio, *sand.largest_void_ratio);
}

void imply_by_mineral(InputValues& values) {
  if (values.minerals.empty() && known_shape(values) == GrainShape::sand)
    values.minerals = contact::mineral_shares("quartz");
  if (values.minerals.empty())
    return;
  double density = 0, square = 0; // of the relative spread of the moduli, which differ independently
  for (const auto& [mineral, share] : values.minerals) {
    density += share * mineral->density;
    square += share * share * mineral->modulus_spread * mineral->modulus_spread;
  }
  const contact::GrainMaterial material = values.minerals.size() == 1
                                              ? values.minerals.front().mineral->material
                                              : mixed_contacts_of(values).mean;
  values.imply(Input::grain_shear_modulus, material.shear_modulus,
               std::sqrt(square) * material.shear_modulus);
  values.imply(Input::grain_poisson_ratio, material.poisson_ratio);
  if (!values.without_density)
    values.imply(Input::grain_density, density);
}

} // namespace

bool by_usual_limits(const InputValues& values) {
  return values.given(Input::relative_density) && !values.given(Input::least_void_ratio);
}

std::pair<double, double> void_ratio_limits(const InputValues& values) {
  if (by_usual_limits(values)) {
    const sands::UsualLimits usual = sands::usual_limits(uniformity_of(values));
    return {usual.least, usual.largest};
  }
  return {values.number(Input::least_void_ratio), values.number(Input::largest_void_ratio)};
}

namespace {

void imply_by_relative_density(InputValues& values) {
  if (!values.given(Input::relative_density) || (values.by_keywords && values.stated(Input::void_ratio)))
    return;
  if (values.stated(Input::void_ratio) || values.stated(Input::porosity) ||
      values.stated(Input::solid_fraction))
    throw InvalidArgument(values.spelled(conflict::density));
  if (values.given(Input::least_void_ratio) != values.given(Input::largest_void_ratio))
    throw InvalidArgument(
        values.spelled("{least_void_ratio} and {largest_void_ratio} go together: give both, or neither"));
  const bool usual = by_usual_limits(values);
  if (usual && known_shape(values) != GrainShape::sand)
    throw InvalidArgument(
        values.spelled("{relative_density} of spheres needs {least_void_ratio} and {largest_void_ratio}"));
  const auto [least, largest] = void_ratio_limits(values);
  values.imply(Input::void_ratio,
               sands::void_ratio_of_relative_density(values.within(Input::relative_density), least, largest),
               usual ? sands::usual_limits(uniformity_of(values)).deviation : 0);
}

/// sigma_h from sigma_v and K_0.
void imply_by_stress_ratio(InputValues& values) {
  if (!values.given(Input::k0))
    return;
  const double ratio = values.within(Input::k0), stress_v = values.number(Input::stress_v);
  if (values.stated(Input::stress_h)) {
    constexpr double rounding = 0.01; // a row of a table may have both, as far as they agree
    const double stress_h = values.number(Input::stress_h);
    if (values[Input::k0].source == Source::table &&
        std::abs(ratio * stress_v - stress_h) <= rounding * stress_h)
      return;
    throw InvalidArgument(values.spelled("{k0} sets {stress_h} from {stress_v}: give one of the two"));
  }
  if (!values.given(Input::stress_v))
    throw InvalidArgument(values.spelled("{k0} needs {stress_v}"));
  values.imply(Input::stress_h, ratio * stress_v);
}

} // namespace

InputValues completed(InputValues values) {
  imply_by_sand(values);
  imply_by_mineral(values);
  imply_by_relative_density(values);
  imply_by_stress_ratio(values);
  return values;
}

InputValues as_sand(InputValues values) {
  values.grain_shape = GrainShape::sand;
  return completed(std::move(values));
}

} // namespace granum::estimate

// SPDX-License-Identifier: GPL-3.0-or-later
#include <granum/estimate/answer.hpp>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>
#include <string>
#include <utility>

#include <granum/contact/grains.hpp>
#include <granum/core/error.hpp>
#include <granum/core/text.hpp>
#include <granum/effective/exponents.hpp>
#include <granum/effective/relaxation.hpp>
#include <granum/elastic/waves.hpp>

#include "effective/relaxed_constants.hpp"
#include "parts.hpp"

namespace granum::estimate {

namespace {

constexpr double unlimited = std::numeric_limits<double>::max();

constexpr FieldRow modulus(Field field, const char* key, const char* symbol, const char* directed,
                           const char* column, const char* meaning, const char* directed_meaning,
                           const char* in_water, Shown shown) {
  return {.field = field,
          .key = key,
          .symbol = symbol,
          .directed_symbol = directed,
          .column = column,
          .dimension = Dimension::pressure,
          .meaning = meaning,
          .directed_meaning = directed_meaning,
          .in_water = in_water,
          .shown = shown,
          .needs_density = false,
          .spreading = Spreading::logarithmic,
          .least = 0,
          .most = unlimited};
}

constexpr FieldRow of_density(Field field, const char* key, const char* symbol, const char* directed,
                              const char* column, Dimension dimension, const char* meaning,
                              const char* directed_meaning, const char* in_water, Shown shown) {
  FieldRow row = modulus(field, key, symbol, directed, column, meaning, directed_meaning, in_water, shown);
  row.dimension = dimension;
  row.needs_density = true;
  return row;
}

constexpr FieldRow pure(Field field, const char* key, const char* symbol, const char* column,
                        const char* meaning, Shown shown, Spreading spreading, double least, double most) {
  FieldRow row = modulus(field, key, symbol, symbol, column, meaning, meaning, "", shown);
  row.dimension = Dimension::dimensionless;
  row.spreading = spreading;
  row.least = least;
  row.most = most;
  return row;
}

constexpr FieldRow nu() {
  FieldRow row = pure(Field::poisson_ratio, "poisson_ratio", "nu", "nu", "Poisson's ratio", Shown::always,
                      Spreading::difference, -1, 0.5);
  row.directed_symbol = "nu_vh";
  row.in_water = ", drained";
  return row;
}

constexpr FieldRow table[] = {
    modulus(Field::shear_modulus, "shear_modulus", "G", "G_vh", "G", "shear modulus",
            "shear modulus, vertical plane", "", Shown::always),
    of_density(Field::shear_wave_speed, "shear_wave_speed", "V_s", "V_s", "V_s", Dimension::speed,
               "shear wave", "shear wave, vertical", "", Shown::always),
    of_density(Field::compression_wave_speed, "compression_wave_speed", "V_p", "V_p", "V_p", Dimension::speed,
               "compression wave", "compression wave, vertical", ", wet", Shown::always),
    modulus(Field::bulk_modulus, "bulk_modulus", "K", "K", "K", "bulk modulus", "bulk modulus", ", drained",
            Shown::always),
    modulus(Field::young_modulus, "young_modulus", "E", "E_v", "E", "Young's modulus",
            "Young's modulus, vertical", ", drained", Shown::always),
    nu(),
    modulus(Field::horizontal_shear_modulus, "horizontal_shear_modulus", "G_hh", "G_hh", "G_hh",
            "shear modulus, horizontal plane", "shear modulus, horizontal plane", "", Shown::by_direction),
    of_density(Field::horizontal_shear_wave_speed, "horizontal_shear_wave_speed", "V_s,h", "V_s,h", "V_s_h",
               Dimension::speed, "shear wave in the horizontal plane", "shear wave in the horizontal plane",
               "", Shown::by_direction),
    of_density(Field::horizontal_compression_wave_speed, "horizontal_compression_wave_speed", "V_p,h",
               "V_p,h", "V_p_h", Dimension::speed, "compression wave, horizontal",
               "compression wave, horizontal", ", wet", Shown::by_direction),
    modulus(Field::horizontal_young_modulus, "horizontal_young_modulus", "E_h", "E_h", "E_h",
            "Young's modulus, lateral", "Young's modulus, lateral", ", drained", Shown::by_direction),
    of_density(Field::bulk_density, "bulk_density", "density", "density", "density", Dimension::density,
               "bulk density", "bulk density", ", with its water", Shown::always),
    pure(Field::mechanical_coordination_number, "mechanical_coordination_number", "z*", "z_star",
         "mechanical coordination number", Shown::always, Spreading::logarithmic, 0, unlimited),
    pure(Field::rattler_fraction, "rattler_fraction", "x_0", "rattlers", "share of grains without load",
         Shown::in_full, Spreading::difference, 0, 1),
    pure(Field::coordination_number, "coordination_number", "C_n", "C_n", "coordination number",
         Shown::in_full, Spreading::logarithmic, 0, unlimited),
    pure(Field::contact_softness, "contact_softness", "k/k_H", "k_over_k_hertz",
         "inferred contact stiffness over that of smooth spheres", Shown::always, Spreading::logarithmic, 0,
         unlimited),
    pure(Field::vertical_exponent, "vertical_exponent", "n", "n", "exponent of sigma_v in G",
         Shown::by_direction, Spreading::difference, -unlimited, unlimited),
    pure(Field::horizontal_exponent, "horizontal_exponent", "m", "m", "exponent of sigma_h in G",
         Shown::by_direction, Spreading::difference, -unlimited, unlimited),
    pure(Field::stress_exponent, "stress_exponent", "s", "s", "exponent of p' in G", Shown::always,
         Spreading::difference, -unlimited, unlimited),
    modulus(Field::strained_shear_modulus, "strained_shear_modulus", "G(g)", "G(g)", "G_strained",
            "shear modulus at the strain", "shear modulus at the strain, vertical plane", "", Shown::always),
    pure(Field::modulus_ratio, "modulus_ratio", "G/G0", "G_over_G0",
         "G at the strain over that at small strain", Shown::always, Spreading::logarithmic, 0, 1),
    pure(Field::damping_ratio, "damping_ratio", "D", "damping", "damping ratio at the strain", Shown::always,
         Spreading::difference, 0, 1),
    pure(Field::slip_strain, "slip_strain", "g_slip", "slip_strain",
         "strain at which slip at contacts reduces G by 1 %", Shown::always, Spreading::logarithmic, 0,
         unlimited),
    pure(Field::pm4sand_coefficient, "pm4sand_coefficient", "G_o", "G_o",
         "shear modulus coefficient of PM4Sand, G/(p_atm sqrt(p'/p_atm)), p_atm = 101.3 kPa", Shown::in_full,
         Spreading::logarithmic, 0, unlimited),
};
static_assert(std::size(table) == field_count);

} // namespace

std::span<const FieldRow, field_count> fields() { return table; }

const FieldRow& row_of(Field field) {
  const auto found = std::find_if(std::begin(table), std::end(table),
                                  [field](const FieldRow& row) { return row.field == field; });
  if (found == std::end(table))
    throw InvalidArgument("field is not one of the known ones");
  return *found;
}

const FieldRow& field_of(std::string_view key) {
  std::string keys;
  for (const FieldRow& row : table) {
    if (key == row.key)
      return row;
    keys += (keys.empty() ? "" : ", ") + std::string(row.key);
  }
  throw InvalidArgument("field is one of " + keys + ", not " + std::string(key));
}

namespace {

using effective::ContactCounts;
using effective::RelaxedEstimate;
using elastic::TransverselyIsotropic;

/// Accuracy of s of rung 3 against s fitted to contact networks (effective/exponents.hpp).
constexpr double exponent_error = 0.03;

} // namespace

void set_speeds(Values& all, const Question& q, const TransverselyIsotropic& c) {
  const double rho = elastic::bulk_density({.grain_density = *q.grain_density,
                                            .void_ratio = q.state.void_ratio,
                                            .pore_density = q.saturation * elastic::water_density});
  const TransverselyIsotropic undrained =
      q.saturation > 0
          ? elastic::saturated(c, {.grain_bulk_modulus = contact::bulk_modulus(q.state.law.grain()),
                                   .fluid_bulk_modulus = elastic::water_and_air_bulk_modulus(q.saturation),
                                   .void_ratio = q.state.void_ratio})
          : c;
  at(all, Field::bulk_density) = rho;
  at(all, Field::shear_wave_speed) = std::sqrt(c.C44 / rho);
  at(all, Field::horizontal_shear_wave_speed) = std::sqrt(c.C66() / rho);
  at(all, Field::compression_wave_speed) = std::sqrt(undrained.C33 / rho);
  at(all, Field::horizontal_compression_wave_speed) = std::sqrt(undrained.C11 / rho);
}

void require_finite_values(const Values& all) {
  if (!std::all_of(all.begin(), all.end(), [](double value) { return std::isfinite(value); }))
    throw InvalidArgument("the moduli exceed the range of a double; check the units of the inputs");
}

namespace {

/// All numbers except the exponents.
/// \throws   InvalidArgument if one exceeds the range of a double
Values values_of(const Question& q, const ContactCounts& counts, const TransverselyIsotropic& c) {
  Values all{};
  const bool stiff = c.positive_definite();
  at(all, Field::shear_modulus) = c.G_vh();
  at(all, Field::bulk_modulus) = c.bulk_modulus();
  at(all, Field::young_modulus) = stiff ? c.E_v() : 0;
  at(all, Field::poisson_ratio) = stiff ? c.nu_vh() : 0.5; // the limit of vanishing shear stiffness
  at(all, Field::horizontal_shear_modulus) = c.G_hh();
  at(all, Field::horizontal_young_modulus) = stiff ? c.E_h() : 0;
  at(all, Field::coordination_number) = q.state.coordination_number.value_or(counts.coordination_number());
  at(all, Field::mechanical_coordination_number) = counts.mechanical_coordination_number;
  at(all, Field::rattler_fraction) = counts.rattler_fraction;
  if (q.grain_density)
    set_speeds(all, q, c);
  require_finite_values(all);
  return all;
}

/// The state of a question with given contacts, and how uneven its preparation left the forces. A given C_n
/// is reported as given, not recomputed from z*.
effective::State with(const Question& q, const ContactCounts& counts) {
  effective::State known = q.state;
  known.coordination_number = q.state.coordination_number.value_or(counts.coordination_number());
  known.mechanical_coordination_number = counts.mechanical_coordination_number;
  const double p = known.mean_stress();
  const bool dense = q.preparation.kind == effective::Preparation::Kind::dense;
  if (!known.unevenness && dense && p > 0 && *known.coordination_number > 0)
    known.unevenness = effective::dense_unevenness(
        known,
        q.preparation.pressure > 0 ? std::optional(std::min(q.preparation.pressure, p)) : std::nullopt);
  return known;
}

/// The stiffness of a question with given contacts, and all numbers that follow.
struct Solution {
  RelaxedEstimate estimate;
  Values values;
};

Solution solution(const Question& q, const ContactCounts& counts) {
  RelaxedEstimate estimate = effective::relaxed(with(q, counts), counts.mechanical_coordination_number);
  Values values = values_of(q, counts, estimate.stiffness);
  return {std::move(estimate), values};
}

/// Whether a packing has exponents: it is loaded, and rigid.
bool has_exponents(const Question& q, const ContactCounts& counts, const TransverselyIsotropic& c) {
  return q.state.stress_v > 0 && c.C44 > 0 &&
         counts.mechanical_coordination_number >
             effective::isostatic_coordination_number(q.state.tangential_ratio);
}

void set_exponents(Values& all, const effective::StressExponents& s) {
  at(all, Field::vertical_exponent) = s.stress_v;
  at(all, Field::horizontal_exponent) = s.stress_h;
  at(all, Field::stress_exponent) = s.sum();
}

/// Exponents of G_vh; those of `otherwise` where the packing is not rigid there.
void set_exponents(Values& all, const Question& q, const ContactCounts& counts,
                   const effective::Growth& growth, const Values& otherwise) {
  if (all[static_cast<std::size_t>(Field::shear_modulus)] > 0 &&
      counts.mechanical_coordination_number >
          effective::isostatic_coordination_number(q.state.tangential_ratio))
    return set_exponents(all,
                         effective::relaxed_exponents(with(q, counts), counts.mechanical_coordination_number,
                                                      growth, effective::Modulus::G_vh));
  for (const Field field : {Field::vertical_exponent, Field::horizontal_exponent, Field::stress_exponent})
    at(all, field) = otherwise[static_cast<std::size_t>(field)];
}

/// A stiffness of another K and another G, by factors.
TransverselyIsotropic scaled(const TransverselyIsotropic& c, double bulk, double shear) {
  const auto r =
      effective::kernel::unbounded_relax<double>({c.C11, c.C33, c.C12, c.C13, c.C44}, bulk, shear, 0.0);
  return {.C11 = r.C11, .C33 = r.C33, .C12 = r.C12, .C13 = r.C13, .C44 = r.C44};
}

/// A factor that reduces a modulus by its standard error, which may be larger than the modulus.
double less(double relative_error) { return std::max(0.0, 1 - relative_error); }

/// Void ratios of the calibrated sphere packings; beyond them the weight of the laws measured on sands grows
/// to 1 within 0.05.
constexpr double densest_spheres = 0.50, loosest_spheres = 0.75, fading = 0.05;

/// Factor by which the range of a stiffness extends from spheres to sands if the contacts are unknown: 1
/// within the calibration.
double reach_to_sands(const Question& q, double G) {
  const double e = q.state.void_ratio;
  const double weight = std::clamp(std::max(densest_spheres - e, e - loosest_spheres) / fading, 0.0, 1.0);
  if (weight == 0 || q.knows_contacts() || !(G > 0) || e >= 2.9)
    return 1;
  return std::pow(sands::pooled_shear_modulus({}, e, q.state.mean_stress()) / G, weight);
}

/// One standard error of rung 3: of G, of K and of s in turn.
void add_calibration(std::vector<Effect>& effects, const Question& q, const ContactCounts& counts,
                     const Solution& middle, bool exponents) {
  const auto k = static_cast<std::size_t>(Field::shear_modulus);
  const auto scaled_by = [&](double bulk, double shear) {
    Values values = values_of(q, counts, scaled(middle.estimate.stiffness, bulk, shear));
    for (const Field field : {Field::vertical_exponent, Field::horizontal_exponent, Field::stress_exponent})
      at(values, field) = middle.values[static_cast<std::size_t>(field)];
    return values;
  };
  const auto add = [&](const Values& a, const Values& b) {
    effects.push_back(effect_of("rung 3", false, middle.values, a, b));
  };
  const double G_error = middle.estimate.relative_error.G_vh;
  const double K_error = middle.estimate.relative_error.bulk_modulus;
  add(scaled_by(1, less(G_error)), scaled_by(1, 1 + G_error));
  add(scaled_by(less(K_error), 1), scaled_by(1 + K_error, 1));
  if (const double reach = reach_to_sands(q, middle.values[k]); reach != 1)
    effects.push_back(
        effect_of("measured sands", true, middle.values, middle.values, scaled_by(reach, reach)));
  if (!exponents)
    return;
  Values low = middle.values, high = middle.values;
  const double s = middle.values[static_cast<std::size_t>(Field::stress_exponent)];
  for (const Field field : {Field::vertical_exponent, Field::horizontal_exponent, Field::stress_exponent}) {
    const double share = s != 0 ? std::abs(at(low, field) / s) : 1;
    at(low, field) -= share * exponent_error;
    at(high, field) += share * exponent_error;
  }
  add(low, high);
}

/// Whether both have the same contacts: all inputs of the prior and of the counts agree.
bool same_contacts(const Question& a, const Question& b) {
  return a.state.law == b.state.law && a.state.radius == b.state.radius &&
         a.state.void_ratio == b.state.void_ratio && a.state.stress_v == b.state.stress_v &&
         a.state.stress_h == b.state.stress_h && a.state.contacts == b.state.contacts &&
         a.preparation == b.preparation && a.state.coordination_number == b.state.coordination_number &&
         a.state.mechanical_coordination_number == b.state.mechanical_coordination_number &&
         a.rattler_fraction == b.rattler_fraction;
}

/// Whether both have the same stiffness as well.
bool same_packing(const Question& a, const Question& b) {
  return same_contacts(a, b) && a.state.tangential_ratio == b.state.tangential_ratio &&
         a.state.rolling == b.state.rolling && a.state.fabric_anisotropy == b.state.fabric_anisotropy;
}

} // namespace

Answer answer(const Question& question, std::span<const Spread> spreads) {
  require_valid(question);
  return possible_answer(question, spreads);
}

Answer possible_answer(const Question& question, std::span<const Spread> spreads) {
  require_possible(question);
  if (question.grain_shape == GrainShape::sand)
    return sand_answer(question, spreads);
  const KnownContacts contacts = contacts_of(question);
  Solution middle = solution(question, contacts.middle);
  const bool exponents = has_exponents(question, contacts.middle, middle.estimate.stiffness);
  const ContactGrowth growth = exponents ? growth_of(question) : ContactGrowth{};
  if (exponents)
    set_exponents(middle.values, question, contacts.middle, growth.middle, middle.values);

  Answer all(with(question, contacts.middle));
  all.middle_ = middle.values;
  add_calibration(all.effects_, question, contacts.middle, middle, exponents);
  const auto counted = [&](const Question& q, const ContactCounts& counts,
                           const effective::Growth& of_counts) {
    Values values = solution(q, counts).values;
    if (exponents)
      set_exponents(values, q, counts, of_counts, middle.values);
    return values;
  };
  Question densest = question; // the most contacts are those of a dense packing, and so are its forces
  if (!question.knows_contacts() && question.preparation.kind == effective::Preparation::Kind::unknown)
    densest.preparation.kind = effective::Preparation::Kind::dense;
  all.effects_.push_back(effect_of("contacts", !question.knows_contacts(), middle.values,
                                   counted(question, contacts.fewer, growth.fewer),
                                   counted(densest, contacts.more, growth.more)));
  // Numbers that do not depend on the input are not computed again.
  const auto moved = [&](const Question& q) {
    require_possible(q);
    const ContactCounts counts = same_contacts(q, question) ? contacts.middle : contacts_of(q).middle;
    Values values = same_packing(q, question) ? values_of(q, counts, middle.estimate.stiffness)
                                              : solution(q, counts).values;
    if (exponents)
      set_exponents(values, q, counts, growth.middle, middle.values);
    return values;
  };
  for (const Spread& spread : spreads)
    all.effects_.push_back(
        effect_of(spread.input, spread.assumed, middle.values, moved(spread.less), moved(spread.more)));
  for (const FieldRow& row : fields()) {
    const bool of_sands = row.field == Field::contact_softness || row.field == Field::modulus_ratio ||
                          row.field == Field::strained_shear_modulus || row.field == Field::damping_ratio ||
                          row.field == Field::slip_strain || row.field == Field::pm4sand_coefficient;
    const bool exponent = row.field == Field::vertical_exponent || row.field == Field::horizontal_exponent ||
                          row.field == Field::stress_exponent;
    if (!of_sands && (!row.needs_density || question.grain_density) && (!exponent || exponents))
      all.ranges_[static_cast<std::size_t>(row.field)] = range_of(row, all.middle_, all.effects_);
  }
  all.validity_ = contacts.validity;
  all.validity_.merge(middle.estimate.validity);
  note_strength(question, all.validity_);
  constexpr double most_rattlers = 0.25; // loose packings of hard friction have 0.2
  if (contacts.middle.rattler_fraction > most_rattlers)
    all.validity_.add("a share of rattlers of " + percent_text(contacts.middle.rattler_fraction) +
                      ": packings that were tested have 25 % at most");
  all.validity_.keep_each_once();
  return all;
}

const Range& Answer::operator[](Field field) const {
  const std::optional<Range>& range = find(field);
  if (!range)
    throw InvalidArgument(std::string(row_of(field).key) + (row_of(field).needs_density
                                                                ? " needs the density of the grains"
                                                                : " does not exist for this packing"));
  return *range;
}

Range Answer::without(Field field, std::string_view input) const {
  (void)(*this)[field];
  return range_of(row_of(field), middle_, effects_, input);
}

std::vector<Share> Answer::shares() const { return shares_of(Field::shear_modulus, effects_); }

bool Answer::assumes(std::string_view input) const {
  return std::any_of(effects_.begin(), effects_.end(),
                     [&](const Effect& effect) { return effect.input == input && effect.assumed; });
}

} // namespace granum::estimate

// SPDX-License-Identifier: GPL-3.0-or-later
#include <granum/estimate/fields.hpp>

#include <algorithm>
#include <iterator>
#include <limits>
#include <string>

#include <granum/core/error.hpp>

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

} // namespace granum::estimate

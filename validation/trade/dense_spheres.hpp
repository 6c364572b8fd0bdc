// SPDX-License-Identifier: GPL-3.0-or-later
// Dense spheres of Table 1 of the paper at 100 kPa, and friction angles of what is sheared from there.
#pragma once

#include <granum/core/error.hpp>
#include <granum/io/csv/table.hpp>
#include <granum/io/output_file.hpp>
#include <granum/stress/stress.hpp>
#include <granum/triaxial/specimen.hpp>

#include "../common.hpp"
#include "../relaxation/specimens.hpp"

namespace trade {

using namespace granum;
using relaxation::kPa;

inline constexpr double pressure = 100 * kPa, degree = M_PI / 180;

inline triaxial::SpecimenRecipe recipe_of(bool walls, std::uint64_t seed, std::size_t grains) {
  triaxial::SpecimenRecipe recipe = relaxation::sphere_recipe(grains, seed);
  if (walls)
    recipe.wall_friction = 0;
  return recipe;
}

/// The specimen under isotropic pressure.
inline dem::Specimen compressed(const triaxial::SpecimenRecipe& recipe) {
  return relaxation::compressed(triaxial::frictionless_specimen(recipe).state, triaxial::Density::dense,
                                recipe, {10 * kPa, 30 * kPa, pressure})
      .state;
}

/// Mobilised friction angle of q/p' on a path [deg].
inline double angle_at(stress::ShearPath path, double eta) {
  return stress::mobilised_friction_angle(stress::stress_on_path(path, pressure, eta)) / degree;
}

/// Of a command line.
struct Asked {
  std::string table; ///< to be written; or empty
  std::uint64_t specimens = 3;
  std::size_t grains = 1000;
  double last = 0; ///< a further number
};
inline Asked asked(const Arguments& arguments, double usual) {
  const auto has = [&](std::size_t k) { return arguments.size() > k; };
  const Asked found{.table = has(0) ? arguments[0] : "",
                    .specimens = has(1) ? std::stoull(arguments[1]) : 3,
                    .grains = has(2) ? std::stoull(arguments[2]) : 1000,
                    .last = has(3) ? std::stod(arguments[3]) : usual};
  if (found.specimens < 1 || found.grains < 40)
    throw InvalidArgument("less than one specimen of 40 grains");
  return found;
}

inline void write(const Asked& asked, const io::CsvContent& table) {
  if (!asked.table.empty())
    io::write_file(asked.table, io::csv_text(table), io::Existing::replace);
}

} // namespace trade

// SPDX-License-Identifier: GPL-3.0-or-later
#include "exports.hpp"

#include <cstddef>

#include <granum/core/error.hpp>
#include <granum/core/version.hpp>

namespace granum::web {

std::vector<double>& numbers() {
  static std::vector<double> row;
  return row;
}

std::string& words() {
  static std::string text;
  return text;
}

void say(const Validity& validity) {
  words().clear();
  for (const std::string& note : validity.notes)
    words() += note + "\n";
}

contact::Shape shape_of(double number) {
  const auto place = static_cast<std::size_t>(number);
  if (!(number >= 0) || place > 2)
    throw InvalidArgument("shape", number, "", "0 (cone), 1 (sphere) or 2 (flat)");
  return contact::all_shapes[place];
}

contact::PowerLaw law_of(const PageGrain& grain) {
  return contact::law_of(
      shape_of(grain.shape), {.shear_modulus = grain.shear_modulus, .poisson_ratio = grain.poisson_ratio},
      {.radius = grain.radius, .cone_slope = grain.cone_slope, .punch_radius = grain.punch_radius});
}

} // namespace granum::web

using namespace granum;

GRANUM_EXPORT(numbers_address) const double* numbers_address() { return web::numbers().data(); }
GRANUM_EXPORT(numbers_count) std::size_t numbers_count() { return web::numbers().size(); }
GRANUM_EXPORT(words_address) const char* words_address() { return web::words().data(); }
GRANUM_EXPORT(words_count) std::size_t words_count() { return web::words().size(); }
/// Before a call, which may have no words or no numbers to say.
GRANUM_EXPORT(forget) void forget() {
  web::numbers().clear();
  web::words().clear();
}
GRANUM_EXPORT(version) void version() { web::words() = std::string(granum::version()); }

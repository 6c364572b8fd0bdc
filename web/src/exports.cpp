// SPDX-License-Identifier: GPL-3.0-or-later
#include "exports.hpp"

#include <cstddef>
#include <span>

#include <granum/core/error.hpp>
#include <granum/core/text.hpp>
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

contact::Shape shape_of(double place) {
  if (!(place >= 0 && place < static_cast<double>(contact::laws().size())))
    throw InvalidArgument("shape", place, "", "an index in the table of contact laws");
  return contact::laws()[static_cast<std::size_t>(place)].shape;
}

contact::NormalLaw law_of(const PageGrain& grain) {
  const contact::LawRow& row = contact::row_of(shape_of(grain.shape));
  const double numbers[] = {grain.first, grain.second};
  return row.make({.shear_modulus = grain.shear_modulus, .poisson_ratio = grain.poisson_ratio}, grain.radius,
                  std::span(numbers).first(row.parameters.size()));
}

} // namespace granum::web

using namespace granum;

GRANUM_EXPORT(numbers_address) const double* numbers_address() { return web::numbers().data(); }
GRANUM_EXPORT(numbers_count) std::size_t numbers_count() { return web::numbers().size(); }
GRANUM_EXPORT(words_address) const char* words_address() { return web::words().data(); }
GRANUM_EXPORT(words_count) std::size_t words_count() { return web::words().size(); }
/// Clears words and numbers before a call.
GRANUM_EXPORT(forget) void forget() {
  web::numbers().clear();
  web::words().clear();
}
/// The table of contact laws, one line each: name, plural, and key and value of its numbers, separated by
/// tabs.
GRANUM_EXPORT(laws) void laws() {
  for (const contact::LawRow& row : contact::laws()) {
    web::words() += std::string(name(row.shape)) + "\t" + row.plural;
    for (const contact::LawParameter& parameter : row.parameters)
      web::words() += "\t" + parameter.key + "\t" + exact_text(parameter.value);
    web::words() += "\n";
  }
}
GRANUM_EXPORT(version) void version() { web::words() = std::string(granum::version()); }

// SPDX-License-Identifier: GPL-3.0-or-later
#include <granum/contact/laws.hpp>

#include <algorithm>
#include <type_traits>
#include <utility>

#include <granum/core/error.hpp>

namespace granum::contact {

namespace {

using Numbers = std::span<const double>;

const char* const fitted = "fitted to Table 5 of Chung et al. 2014";
const char* const power_law_header = "contact/power_law.hpp";

LawRow cone() {
  LawRow row("cone");
  row.plural = "cones";
  row.maker = "cone";
  row.title = "Contact of two equal cones, c = G/(pi (1-nu) A_1).";
  row.source = "[Sneddon1965]";
  row.cpp_name = "PowerLaw::cone";
  row.header = power_law_header;
  row.synonyms = {"conical"};
  row.parameters = {{.key = "cone_slope",
                     .name = "slope",
                     .symbol = "A_1",
                     .help = "tangent of the flank angle",
                     .value = 0.4,
                     .origin = fitted,
                     .low = 1e-6,
                     .high = 1e6,
                     .reason = "a cone is neither a plane nor a needle"}};
  row.make = [](const GrainMaterial& grain, double, Numbers x) { return PowerLaw::cone(grain, x[0]); };
  return row;
}

LawRow sphere() {
  LawRow row("sphere");
  row.plural = "spheres";
  row.maker = "sphere";
  row.title = "Hertz contact of two equal spheres, c = 2 G sqrt(2R)/(3(1-nu)).";
  row.source = "Overlaps are small against R. [Hertz1882]";
  row.cpp_name = "PowerLaw::sphere";
  row.header = power_law_header;
  row.synonyms = {"hertz", "hertzian", "mindlin", "hertz-mindlin", "spherical"};
  row.depends_on_size = true;
  row.make = [](const GrainMaterial& grain, double radius, Numbers) {
    return PowerLaw::sphere(grain, radius);
  };
  return row;
}

LawRow flat() {
  LawRow row("flat");
  row.plural = "flat contacts";
  row.maker = "flat_punch";
  row.title = "Contact of two flat punches, of the same stiffness at every force.";
  row.source = "c = 2 G (punch radius)/(1-nu). [Sneddon1965]";
  row.cpp_name = "PowerLaw::flat";
  row.header = power_law_header;
  row.synonyms = {"linear", "punch"};
  row.parameters = {{.key = "punch_radius",
                     .name = "punch_radius",
                     .symbol = "punch radius",
                     .help = "the radius of the contact at every force",
                     .dimension = Dimension::length,
                     .value = 5.7e-6,
                     .origin = fitted,
                     .low = 1e-15,
                     .high = 1e3,
                     .reason = "it is up to the radius of the grains",
                     .within_grain = true}};
  row.make = [](const GrainMaterial& grain, double, Numbers x) { return PowerLaw::flat(grain, x[0]); };
  return row;
}

LawRow power_law() {
  LawRow row("power-law");
  row.plural = "power-law contacts";
  row.maker = "power_law";
  row.title = "Contact of two profiles z = A r^alpha.";
  row.source = "The family of cones, spheres and flat punches. [Galin1946] [Sneddon1965]";
  row.cpp_name = "PowerLaw::general";
  row.header = power_law_header;
  row.parameters = {
      {.key = "alpha",
       .name = "alpha",
       .symbol = "alpha",
       .help = "exponent > 0 of the profile A r^alpha; simulations need 1 or more",
       .value = 1.5,
       .low = 1,
       .high = 100,
       .reason = "beyond, the contact is flat within 1 %; below 1 it is a cusp, for closed forms only"},
      {.key = "profile_constant",
       .name = "profile_constant",
       .symbol = "A",
       .help = "factor of the profile A r^alpha of one grain",
       .unit = "m^(1-alpha)",
       .value = 180,
       .low = 1e-300,
       .high = 1e300,
       .reason = "its powers must fit into a double"}};
  row.make = [](const GrainMaterial& grain, double, Numbers x) {
    return PowerLaw::general(grain, x[0], x[1]);
  };
  return row;
}

LawRow rough() {
  LawRow row("rough");
  row.plural = "rough spheres";
  row.maker = "rough_sphere";
  row.title =
      "Contact of two equal spheres with rough surfaces, k_n ~ f under little force, Hertz under much.";
  row.source = "1/k_n = u0/f + 1/(k_H sqrt(h)), h calibrated. [Persson2007] [Hertz1882]";
  row.cpp_name = "RoughSphere";
  row.header = "contact/rough_sphere.hpp";
  row.synonyms = {"roughness", "rough-sphere", "rough-spheres"};
  row.depends_on_size = true;
  row.parameters = {{.key = "roughness",
                     .name = "roughness",
                     .symbol = "u0",
                     .help = "0.4 times the combined rms height of the two surfaces; 0 is smooth",
                     .dimension = Dimension::length,
                     .value = 20e-9,
                     .low = 0,
                     .high = RoughSphere::largest_roughness,
                     .reason = "beyond, few asperities touch",
                     .within_grain = true}};
  row.make = [](const GrainMaterial& grain, double radius, Numbers x) {
    return RoughSphere(grain, radius, x[0]);
  };
  return row;
}

/// The law of a kind, if that is Law or one of those behind it in AnyLaw.
template <class Law, class... Others>
NormalLaw of_kind(std::size_t kind, const GrainMaterial& grain, std::span<const double> given,
                  std::type_identity<std::variant<Law, Others...>> /*laws*/) {
  if (kind == 0) {
    decltype(std::declval<Law>().numbers()) numbers{};
    if (given.size() != numbers.size())
      throw InvalidArgument("a contact law of this kind has " + std::to_string(numbers.size()) +
                            " numbers, not " + std::to_string(given.size()));
    std::copy(given.begin(), given.end(), numbers.begin());
    return Law::of_numbers(grain, numbers);
  }
  if constexpr (sizeof...(Others) > 0)
    return of_kind(kind - 1, grain, given, std::type_identity<std::variant<Others...>>{});
  throw InvalidArgument("no contact law is of this kind");
}

void require_known(const LawNumbers& numbers) {
  for (const auto& [key, value] : numbers) {
    const auto has_key = [&key = key](const LawRow& row) {
      return std::any_of(row.parameters.begin(), row.parameters.end(),
                         [&](const LawParameter& parameter) { return parameter.key == key; });
    };
    if (std::none_of(laws().begin(), laws().end(), has_key))
      throw InvalidArgument("no contact law has a number " + key);
  }
}

} // namespace

NormalLaw NormalLaw::of_numbers(std::size_t kind, const GrainMaterial& grain,
                                std::span<const double> numbers) {
  return of_kind(kind, grain, numbers, std::type_identity<AnyLaw>{});
}

std::string LawParameter::si_unit() const { return unit.empty() ? std::string(si_symbol(dimension)) : unit; }

std::string LawParameter::option() const {
  std::string text = "--" + name;
  std::replace(text.begin(), text.end(), '_', '-');
  return text;
}

std::span<const LawRow> laws() {
  static const std::vector<LawRow> table{cone(), sphere(), flat(), power_law(), rough()};
  return table;
}

const LawRow& row_of(const Shape& shape) {
  return *std::find_if(laws().begin(), laws().end(), [&](const LawRow& row) { return row.shape == shape; });
}

std::optional<Shape> find_shape(std::string_view text) {
  for (const LawRow& row : laws())
    if (name(row.shape) == text)
      return row.shape;
  return std::nullopt;
}

std::string shape_names() {
  std::string all;
  for (const LawRow& row : laws())
    all += (all.empty() ? "" : ", ") + std::string(name(row.shape));
  return all;
}

double value_of(const LawParameter& parameter, const LawNumbers& numbers) {
  const auto found = numbers.find(parameter.key);
  return found != numbers.end() ? found->second : parameter.value;
}

NormalLaw law_of(const Shape& shape, const GrainMaterial& grain, double radius, const LawNumbers& numbers) {
  require_known(numbers);
  const LawRow& row = row_of(shape);
  std::vector<double> own;
  for (const LawParameter& parameter : row.parameters) {
    own.push_back(value_of(parameter, numbers));
    if (parameter.within_grain && radius > 0) // a law that needs the radius refuses another
      require_closed(parameter.name, own.back(), 0, radius, "m");
  }
  return row.make(grain, radius, own);
}

} // namespace granum::contact

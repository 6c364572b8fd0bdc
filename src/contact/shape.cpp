// SPDX-License-Identifier: GPL-3.0-or-later
#include <granum/contact/shape.hpp>

#include <algorithm>

#include <granum/core/error.hpp>

namespace granum::contact {

namespace {

[[noreturn]] void refuse_unknown() {
  throw InvalidArgument("contact shape is not one of the known ones: " + shape_names());
}

} // namespace

std::string_view name(Shape shape) {
  switch (shape) {
  case Shape::cone:
    return "cone";
  case Shape::sphere:
    return "sphere";
  case Shape::flat:
    return "flat";
  case Shape::power_law:
    return "power-law";
  }
  refuse_unknown();
}

std::optional<Shape> find_shape(std::string_view text) {
  const auto* const found =
      std::find_if(all_shapes.begin(), all_shapes.end(), [&](Shape shape) { return name(shape) == text; });
  return found != all_shapes.end() ? std::optional(*found) : std::nullopt;
}

std::string shape_names() {
  std::string all;
  for (const Shape shape : all_shapes)
    all += (all.empty() ? "" : ", ") + std::string(name(shape));
  return all;
}

PowerLaw law_of(Shape shape, const GrainMaterial& grain, const ShapeParameters& parameters) {
  switch (shape) {
  case Shape::cone:
    return PowerLaw::cone(grain, parameters.cone_slope);
  case Shape::sphere:
    return PowerLaw::sphere(grain, parameters.radius);
  case Shape::flat:
    return PowerLaw::flat(grain, parameters.punch_radius);
  case Shape::power_law:
    return PowerLaw::general(grain, parameters.alpha, parameters.profile_constant);
  }
  refuse_unknown();
}

} // namespace granum::contact

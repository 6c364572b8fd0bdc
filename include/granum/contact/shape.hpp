// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <optional>
#include <string>
#include <string_view>

#include <granum/contact/power_law.hpp>

namespace granum::contact {

/// Shapes of grains near their contacts. Each is a member of the power-law family, PowerLaw.
enum class Shape {
  cone,      ///< z = A_1 r
  sphere,    ///< z = r^2/(2R)
  flat,      ///< a disc of one radius at any force
  power_law, ///< z = A_alpha r^alpha
};

inline constexpr std::array all_shapes{Shape::cone, Shape::sphere, Shape::flat, Shape::power_law};

/// "cone", "sphere", "flat", "power-law".
/// \throws   InvalidArgument for a value that is none of the enumerators
[[nodiscard]] std::string_view name(Shape shape);

/// The shape that `text` names exactly; nothing if none does.  Checked by tests/contact/test_shape.cpp
[[nodiscard]] std::optional<Shape> find_shape(std::string_view text);

/// The names of all shapes, ", " between them, for messages.
[[nodiscard]] std::string shape_names();

/// What the profiles of the shapes are made of. A shape reads its own numbers alone.
struct ShapeParameters {
  double radius = 0;           ///< R of the sphere [m]
  double cone_slope = 0;       ///< A_1 of the cone, tangent of the flank angle [1]
  double punch_radius = 0;     ///< a of the flat contact [m]
  double alpha = 0;            ///< of the power-law contact [1]
  double profile_constant = 0; ///< A_alpha of the power-law contact [m^(1-alpha)]
};

/// The contact law of two equal grains of a shape: the one place that chooses among PowerLaw's makers.
/// \throws   InvalidArgument as the maker of the shape does, for the grain or for one of its own parameters
/// Accuracy  that of the maker.  Checked by tests/contact/test_shape.cpp
[[nodiscard]] PowerLaw law_of(Shape shape, const GrainMaterial& grain, const ShapeParameters& parameters);

} // namespace granum::contact

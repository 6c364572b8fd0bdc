// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <map>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include <granum/contact/normal_law.hpp>
#include <granum/core/units.hpp>

/// The table of contact laws. Options, keys of scenes, functions of Python, the page and the words of reports
/// follow from its rows.
namespace granum::contact {

/// The shape of grains near their contacts: the name of a row of the table, and of no other.
class Shape {
 public:
  static const Shape cone;      ///< z = A_1 r
  static const Shape sphere;    ///< z = r^2/(2R)
  static const Shape flat;      ///< a disc of one radius at any force
  static const Shape power_law; ///< z = A_alpha r^alpha
  static const Shape rough;     ///< spheres with an interface of roughness

  [[nodiscard]] constexpr std::string_view name() const { return name_; }
  constexpr bool operator==(const Shape&) const = default;

 private:
  friend struct LawRow;
  explicit constexpr Shape(const char* name) : name_(name) {}

  std::string_view name_;
};
inline constexpr Shape Shape::cone{"cone"};
inline constexpr Shape Shape::sphere{"sphere"};
inline constexpr Shape Shape::flat{"flat"};
inline constexpr Shape Shape::power_law{"power-law"};
inline constexpr Shape Shape::rough{"rough"};

/// "cone", "sphere", "flat", "power-law", "rough": as options, scenes and tables have it.
[[nodiscard]] constexpr std::string_view name(const Shape& shape) { return shape.name(); }

/// A parameter of a law, in addition to the grain's material and radius.
struct LawParameter {
  std::string key;    ///< no other number of the table has it: in scenes, "cone_slope"
  std::string name;   ///< where the law is known: in options (with dashes), JSON and Python, "slope"
  std::string symbol; ///< "A_1"
  std::string help;   ///< its meaning, for a line of help
  Dimension dimension = Dimension::dimensionless;
  std::string unit = {};     ///< of its value in SI where no Dimension has it: "m^(1-alpha)"
  double value = 0;          ///< default
  std::string origin = {};   ///< of that value; empty: a command line must give the number
  double low = 0, high = 0;  ///< range in studies, both ends included
  std::string reason = {};   ///< why no more
  bool within_grain = false; ///< it is a length, at most the radius of the grains

  /// In SI: "m"; "" for a pure number.
  [[nodiscard]] std::string si_unit() const;
  /// "--punch-radius".
  [[nodiscard]] std::string option() const;
};

/// A law by its name. Its numbers are given in the order of its parameters.
struct LawRow {
  /// \param    text   the one place where a Shape is made of a text
  explicit LawRow(const char* text) : shape(text) {}

  Shape shape;
  std::string plural;                     ///< "flat contacts"
  std::string maker;                      ///< its function in Python: "flat_punch"
  std::string title;                      ///< description, a sentence
  std::string source;                     ///< entries of validation/references.bib, and assumptions
  std::string cpp_name;                   ///< "PowerLaw::flat", of contact/power_law.hpp
  std::string header;                     ///< where that is, below granum/
  std::vector<std::string> synonyms = {}; ///< words that people use for it
  bool depends_on_size = false;           ///< its constructor needs the radius of the grains
  std::vector<LawParameter> parameters = {};
  /// \throws   InvalidArgument where a number is out of the law's range
  std::function<NormalLaw(const GrainMaterial& grain, double radius, std::span<const double> numbers)> make;
};

/// All laws, those of the paper first.                                                            [Chung2014]
[[nodiscard]] std::span<const LawRow> laws();
/// The row of a shape.
[[nodiscard]] const LawRow& row_of(const Shape& shape);

/// The shape with the exact name `text`; empty if there is none.  Checked by tests/contact/test_laws.cpp
[[nodiscard]] std::optional<Shape> find_shape(std::string_view text);
/// The names of all shapes, ", " between them, for messages.
[[nodiscard]] std::string shape_names();

/// Numbers of laws by their keys; one that is missing has the value of the table.
using LawNumbers = std::map<std::string, double, std::less<>>;

/// The value of a parameter among these numbers.
[[nodiscard]] double value_of(const LawParameter& parameter, const LawNumbers& numbers);

/// The law of two equal grains of a shape, from its own parameters only.
/// \param    radius   R of the grains [m], read where the shape depends on it
/// \throws   InvalidArgument as the maker of the law does, and for a key that the table does not have
/// Accuracy  that of the maker.  Checked by tests/contact/test_laws.cpp
[[nodiscard]] NormalLaw law_of(const Shape& shape, const GrainMaterial& grain, double radius,
                               const LawNumbers& numbers = {});

} // namespace granum::contact

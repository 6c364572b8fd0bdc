// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <limits>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include <granum/core/units.hpp>
#include <granum/estimate/question.hpp>

/// The numbers that a question is made of, a row each: what they mean, their limits, defaults and names.
/// Options, columns of tables and messages of the program are made of these rows.
/// Checked by tests/estimate/test_inputs.cpp
namespace granum::estimate {

/// The inputs, in the order in which the effects of uncertain ones are added up: sums keep their bits.
enum class Input {
  grain_shear_modulus,
  grain_poisson_ratio,
  grain_bulk_modulus,
  radius,
  d50,
  tangential_ratio,
  void_ratio,
  porosity,
  solid_fraction,
  coordination_number,
  mechanical_coordination_number,
  rattler_fraction,
  fabric,
  pressure,
  stress_v,
  stress_h,
  grain_density,
  relative_density,
  least_void_ratio,
  largest_void_ratio,
  saturation,
  k0,
  shear_strain
};

/// The values that an input may have, and why no others.
struct Limits {
  double low = -std::numeric_limits<double>::infinity();
  double high = std::numeric_limits<double>::infinity();
  bool without_low = false, without_high = false; ///< the end itself is excluded
  const char* reason = "";

  /// Never a NaN or an infinity.
  [[nodiscard]] bool contain(double value) const;
  /// "(0, 1]", with as many digits as exclude a refused value, and the reason behind a colon.
  [[nodiscard]] std::string text(double refused) const;
};

/// Words that people try for an input, separated by blanks, without hyphens, and a remark on them.
struct OtherWords {
  const char* words;
  const char* remark = "";
};

/// Other inputs by their keys, separated by blanks, beside which an input contradicts itself, and the
/// sentence for both. A key in braces is replaced by the name of that input at the door.
struct Conflict {
  const char* keys;
  const char* sentence;
};

/// Sentences of conflicts that more than one row has, or that programs find themselves.
namespace conflict {
inline constexpr const char* density =
    "the density is given more than once: give one of {void_ratio}, {porosity}, {solid_fraction}, "
    "{relative_density}";
inline constexpr const char* stress = "{pressure} sets both stresses: leave out {stress_v} and {stress_h}";
inline constexpr const char* size = "{radius} and {d50} are alternatives: give one";
inline constexpr const char* grain =
    "{grain_poisson_ratio} and {grain_bulk_modulus} are alternatives: give one, "
    "besides the shear modulus";
} // namespace conflict

/// Groups of inputs, as help lists them.
inline constexpr const char *state_group = "Density and stress", *grains_group = "Grains",
                            *contacts_group = "Contacts", *sizes_group = "Sizes of the grains",
                            *law_group = "Shape of the contacts";

struct InputRow {
  Input input;
  const char* key; ///< in JSON, and of the heading of its column: "void_ratio"
  const char* group;
  const char* meaning;
  Dimension dimension = Dimension::dimensionless;
  bool share = false;       ///< a value above 1 probably lacks a per cent sign
  const char* symbols = ""; ///< other headings of its column, separated by blanks
  std::vector<OtherWords> synonyms = {};
  Limits limits = {};
  std::optional<double> by_default = {};  ///< in SI; without one it is not used unless it is given
  std::optional<GrainShape> implies = {}; ///< what the grains are, for who gives it
  std::vector<Conflict> excludes = {};    ///< one of two rows lists the other
  /// Its value in a question; null for inputs that others follow from.
  std::optional<double> (*read)(const Question& question) = nullptr;
  const char* argument = nullptr; ///< its name in C++ and Python, where that is not the key

  /// "--void-ratio".
  [[nodiscard]] std::string option() const;
  /// In messages of the library: "fabric_anisotropy".
  [[nodiscard]] std::string_view name() const { return argument != nullptr ? argument : key; }
};

/// All rows, in the order of Input.
[[nodiscard]] std::span<const InputRow> inputs();
/// The row of an input.
[[nodiscard]] const InputRow& row_of(Input input);
/// The row of a key, or of the name of an argument; null for another text.
[[nodiscard]] const InputRow* find_input(std::string_view key);

/// \throws   InvalidArgument naming the number as `name`, if the row's limits do not contain it
/// \param    signed_per_cent   it had a per cent sign, so that no hint on one is due
void require_within(const InputRow& row, double value, std::string_view name, bool signed_per_cent = false);

/// A sentence in which each {key} is replaced by the option of that input.
[[nodiscard]] std::string with_options(std::string_view sentence);

} // namespace granum::estimate

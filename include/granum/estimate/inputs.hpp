// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <limits>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include <granum/contact/laws.hpp>
#include <granum/core/units.hpp>
#include <granum/estimate/question.hpp>

/// What a question is made of, a row each: what it means, its limits, default and names. Options, columns of
/// tables, keywords of Python and messages are made of these rows; values of them are in input_values.hpp.
/// Checked by tests/estimate/test_inputs.cpp
namespace granum::estimate {

class InputValues;

/// The inputs, in the order in which the effects of uncertain ones are added up: sums keep their bits. Those
/// of the contact laws have no names here: they follow the others in the table, and are added up first.
enum class Input : std::size_t {
  grain_shear_modulus,
  grain_poisson_ratio,
  grain_bulk_modulus,
  radius,
  d50,
  tangential_ratio,
  rolling,
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
  fines,
  saturation,
  k0,
  shear_strain,
  contact,
  preparation,
  grain,
  sand,
  grain_shape,
  sizes,
  sieve,
  uniformity,
  of_laws ///< the first number of a contact law
};

/// What the value of an input is.
enum class Kind {
  number,
  word,        ///< one of a few words, or begins with one
  distribution ///< of sizes, as sizes::parse_distribution reads it, or a file
};

/// Which commands and tables have an input.
enum class Belongs {
  to_packing, ///< wherever a packing is described
  to_answer,  ///< beside it, wherever its stiffness is asked: sand, preparation, grains and pores
  to_state    ///< the state asked, of single commands
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
inline constexpr const char* sizes =
    "{sizes}, {sieve} and {uniformity} are alternatives: give one of them, once";
inline constexpr const char* grain =
    "{grain_poisson_ratio} and {grain_bulk_modulus} are alternatives: give one, "
    "besides the shear modulus";
} // namespace conflict

/// Groups of inputs, as help lists them.
inline constexpr const char *state_group = "Density and stress", *grains_group = "Grains",
                            *contacts_group = "Contacts", *sizes_group = "Sizes of the grains",
                            *law_group = "Shape of the contacts";

/// Another word for one of the words of an input: "hertz" for "sphere".
struct WordAlias {
  std::string other, word;
};

struct InputRow {
  Input input;
  const char* key; ///< in JSON, and of the heading of its column: "void_ratio"
  const char* group;
  std::string meaning;
  Kind kind = Kind::number;
  Dimension dimension = Dimension::dimensionless;
  Belongs belongs = Belongs::to_packing;
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
  /// Standard deviation of the default, which is an assumption; null: none.
  double (*deviation)(const InputValues& values) = nullptr;
  std::string origin = {};             ///< of the default: "isotropic contact directions"
  bool uncertain = true;               ///< a number that may have a standard deviation
  std::vector<std::string> words = {}; ///< a word is one of these, or begins with one: "friction:NUMBER"
  std::vector<WordAlias> aliases = {}; ///< of these words
  /// Sets the value of a text. \throws InvalidArgument that does not name the input
  void (*take)(InputValues& values, const std::string& text) = nullptr;
  const contact::LawRow* law = nullptr; ///< to which a number of a contact law belongs
  const contact::LawParameter* parameter = nullptr;

  /// "--void-ratio".
  [[nodiscard]] std::string option() const;
  /// In messages of the library: "fabric_anisotropy".
  [[nodiscard]] std::string_view name() const { return argument != nullptr ? argument : key; }
};

/// All rows, in the order of Input, then the numbers of the contact laws.
[[nodiscard]] std::span<const InputRow> inputs();
/// The row of an input.
[[nodiscard]] const InputRow& row_of(Input input);
/// The row of a key, or of the name of an argument; null for another text.
[[nodiscard]] const InputRow* find_input(std::string_view key);

/// \throws   InvalidArgument naming the number as `name`, if the row's limits do not contain it
/// \param    signed_per_cent   it had a per cent sign, so that no hint on one is due
void require_within(const InputRow& row, double value, std::string_view name, bool signed_per_cent = false);

} // namespace granum::estimate

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <map>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include <granum/contact/grains.hpp>
#include <granum/estimate/inputs.hpp>
#include <granum/sands/known_sands.hpp>
#include <granum/sizes/distribution.hpp>
#include <granum/stress/stress.hpp>

/// The one way from what is known of a packing to a question: options, rows of tables and keywords of Python
/// give values to inputs, `completed` adds what these imply, and `question_of` makes the question.
/// Checked by tests/estimate/test_input_values.cpp
namespace granum::estimate {

/// Who gave a value.
enum class Source {
  nobody,
  implied, ///< it follows from another input, such as the name of a mineral
  table,   ///< a row of a table
  typed    ///< an option or a keyword
};

struct InputValue {
  double number = 0;    ///< in SI; the default of the row unless it is given
  double deviation = 0; ///< of an implied or computed value, one standard deviation
  Source source = Source::nobody;
  bool per_cent = false; ///< its text or the heading of its column has a per cent sign

  [[nodiscard]] bool given() const { return source != Source::nobody; }
  /// Not implied.
  [[nodiscard]] bool stated() const { return source == Source::table || source == Source::typed; }
};

/// What is known of a packing, by its inputs.
class InputValues {
 public:
  InputValues();

  [[nodiscard]] const InputValue& operator[](Input input) const;
  [[nodiscard]] bool given(Input input) const { return (*this)[input].given(); }
  [[nodiscard]] bool stated(Input input) const { return (*this)[input].stated(); }
  /// The number given, or else the default.
  [[nodiscard]] double number(Input input) const { return (*this)[input].number; }
  [[nodiscard]] std::optional<double> if_given(Input input) const;
  /// The number, if the limits of its row contain it.
  /// \throws   InvalidArgument with the name of the input
  double within(Input input) const;

  void give(Input input, double number, Source source = Source::typed, bool per_cent = false);
  /// A contact law made elsewhere, with the moduli of its grains.
  void give(contact::NormalLaw made);
  /// \throws   InvalidArgument for a text that the input does not know; it does not name the input
  void give(Input input, const std::string& text, Source source = Source::typed);
  /// A distribution of sizes that was read from a file.
  void give(Input input, sizes::Distribution distribution);
  /// The standard deviation of a number that was computed for the question, used unless one is stated.
  void set_deviation(Input input, double deviation) {
    values_[static_cast<std::size_t>(input)].deviation = deviation;
  }
  /// As if nobody had given it.
  void leave_out(Input input);
  /// Sets a value that was not stated.
  void imply(Input input, double number, double deviation = 0);
  /// Another number, whoever gave it.
  void set(Input input, double number) { values_[static_cast<std::size_t>(input)].number = number; }
  /// Stresses that follow from elsewhere, instead of all that are given.
  void set_stresses(const stress::AxialStress& stress);
  /// \throws   InvalidArgument if sizes are set already
  void set_sizes(sizes::Distribution distribution);

  /// The name of an input in messages: its option, or by_keywords its keyword.
  [[nodiscard]] std::string name(Input input) const;
  /// A sentence with the names of the keys in braces.
  [[nodiscard]] std::string spelled(std::string_view sentence) const;

  contact::Shape contact = contact::Shape::sphere;
  effective::Preparation preparation = {};
  /// Of the grains, if given by name or implied: one, or several by their shares.
  std::vector<contact::MineralShare> minerals = {};
  const sands::KnownSand* known_sand = nullptr;  ///< if given by name
  std::optional<GrainShape> grain_shape = {};    ///< if given
  std::optional<sizes::Distribution> sizes = {}; ///< of unequal grains
  bool ground = false;                           ///< the question is about the ground, which is soil
  /// A contact law made elsewhere, for grains of `radius`: shape and sizes are its own then, and d50 and C_u
  /// are of a sand alone.
  std::optional<contact::NormalLaw> law = {};
  std::optional<sizes::ContactMeans> contact_means = {}; ///< of unequal grains, beside a law
  bool without_density = false; ///< the density of the grains is unknown unless it is given
  bool by_keywords = false;     ///< names in messages are those of Python

 private:
  std::vector<InputValue> values_;
};

/// The kind of grains, as given or implied: a name, a relative density, limits of the void ratio, a sieve
/// curve or C_u of a soil, a shear strain and the ground imply a sand; glass, steel, numbers of contacts and
/// their shape imply spheres; empty if neither is implied.
[[nodiscard]] std::optional<GrainShape> known_shape(const InputValues& values);

/// The values with everything that they imply: a named sand its mineral, size and limits; a mineral its
/// moduli and density; a relative density the void ratio (by keywords unless that is given); K_0 the
/// horizontal stress. It may be applied again:
/// implied values are computed anew.
/// \throws   InvalidArgument if a relative density lacks its limits, or for values that contradict each other
[[nodiscard]] InputValues completed(InputValues values);

/// The same packing as a sand, with what that implies.
/// \throws   InvalidArgument as completed
[[nodiscard]] InputValues as_sand(InputValues values);

/// The contacts of grains of several minerals that are mixed at random; without pair_shares where there is
/// one.
/// \throws   InvalidArgument for a contact law whose exponent depends on the force
[[nodiscard]] effective::MixedContacts mixed_contacts_of(const InputValues& values);
/// The material of the grains: the shear modulus, and Poisson's ratio or the bulk modulus.
/// \throws   InvalidArgument if both are given, or for impossible moduli
[[nodiscard]] contact::GrainMaterial grain_of(const InputValues& values);
/// The contact law for two grains; for unequal grains that of the mean pair.
/// \throws   InvalidArgument for values that contradict each other or are out of range
[[nodiscard]] contact::NormalLaw law_of(const InputValues& values);
/// The same for another material and radius [m] of the grains.
[[nodiscard]] contact::NormalLaw law_of(const InputValues& values, const contact::GrainMaterial& grain,
                                        double radius);
/// The mean radius of the grains by number [m]: that of the sieve curve, or by d50, or the radius.
/// \throws   InvalidArgument if the size is given twice
[[nodiscard]] double radius_of(const InputValues& values);
/// Means over the contacts of unequal grains, with the share of rattlers as given or by C_n and z*; without
/// sizes, those of equal grains.
/// \throws   InvalidArgument for a share out of range
[[nodiscard]] sizes::ContactMeans contact_means_of(const InputValues& values);
/// \throws   InvalidArgument if the stresses are missing or given more than once
[[nodiscard]] stress::AxialStress stresses_of(const InputValues& values);
/// The packing at a stress.
/// \throws   InvalidArgument for values that contradict each other or are impossible
[[nodiscard]] effective::State state_of(const InputValues& values, const stress::AxialStress& stress);
/// What is known of a sand besides its state.
[[nodiscard]] sands::Sand sand_of(const InputValues& values);

/// The question of completed values; of spheres, if they do not determine the kind of grains.
/// \throws   InvalidArgument for missing values, contradictions and numbers outside of their limits
[[nodiscard]] Question question_of(const InputValues& completed);

// ---- uncertain inputs

/// Standard deviations that are stated, by input.
using Deviations = std::map<Input, double>;

/// Whether the question depends on the number of a row: it is given, or its default is used.
[[nodiscard]] bool in_use(const InputValues& completed, const InputRow& row);
/// The rows that may be uncertain, in the order in which their effects are added up.
[[nodiscard]] std::span<const InputRow* const> uncertain_rows();
/// Reads key=sd, with the unit of the key, or in per cent of its value.
/// \param    rows    the key is the name of one of these: "void-ratio"
/// \param    other   a sentence on another key, before the list of keys
/// \throws   InvalidArgument for another key, a key that is given twice, and a bad deviation
[[nodiscard]] Deviations deviations_of(std::span<const std::string> texts, const InputValues& completed,
                                       std::span<const InputRow* const> rows, std::string_view other);
/// The same for all inputs of the packing.
[[nodiscard]] Deviations deviations_of(std::span<const std::string> texts, const InputValues& completed);
/// The name of an input among the uncertain ones: "void-ratio".
[[nodiscard]] std::string key_of(const InputRow& row);
/// The row of that name, or of its key or argument: "void_ratio".
/// \throws   InvalidArgument for another text
[[nodiscard]] const InputRow& uncertain_row(std::string_view key);
/// The uncertain inputs: those of stated deviations, and values that are assumed or implied with one.
[[nodiscard]] std::vector<UncertainInput> uncertain_inputs(const InputValues& completed,
                                                           const Deviations& stated);
/// The same for key=sd.
/// \throws   InvalidArgument as deviations_of
[[nodiscard]] std::vector<UncertainInput> uncertain_inputs(const InputValues& completed,
                                                           std::span<const std::string> texts);

} // namespace granum::estimate

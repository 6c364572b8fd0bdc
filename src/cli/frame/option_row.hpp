// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <functional>
#include <initializer_list>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include <granum/core/units.hpp>

/// One row per option; parser, help, manual pages, completion, suggestions and contradictions are derived
/// from it. Checked by tests/cli
namespace granum::cli {

/// The last group in the help of every command.
inline constexpr const char* output_group = "Output";

/// A number from the command line or a table: its value in SI, the default unless it is given.
struct Number {
  double value = 0;
  Dimension dimension = Dimension::dimensionless;
  /// Other names of its column in tables, separated by blanks.
  std::string_view symbols = {};
  std::string name = {}; ///< of the option, "--radius"
  bool typed = false;    ///< on the command line
  bool in_table = false; ///< given by a row of a table
  bool per_cent = false; ///< its text or the heading of its column has a per cent sign

  [[nodiscard]] bool given() const { return typed || in_table; }
};

/// Kind of value of an option, and the variable that receives it.
struct Value {
  std::string type = {};                   ///< "PRESSURE", "FILE"; empty for a flag
  std::vector<std::string> choices = {};   ///< the words that it chooses from
  std::string by_default = {};             ///< as help shows it
  std::string limits = {};                 ///< "2 to 1000000", for help
  std::optional<Dimension> dimension = {}; ///< of its number; a separate unit belongs to it
  bool joins_units = false;                ///< also for numbers after keys or within ranges
  bool repeated = false;                   ///< may be typed again
  bool several = false;                    ///< takes all words up to the next option
  char delimiter = '\0';                   ///< between several in one word
  Number* number = nullptr;                ///< receives the name of the option
  /// Reads one text, without the delimiter, of the option as typed.
  /// \throws   InvalidArgument, FileError
  std::function<void(const std::string& name, const std::string& text)> take = {};

  [[nodiscard]] bool flag() const { return type.empty(); }
};

/// Other options, separated by blanks, that exclude an option, and the message; without one, a standard
/// message. One of the two rows lists the other.
struct Exclusion {
  std::string_view others;
  std::string_view sentence = {};
};

/// Other options, one of which is required too.
struct Need {
  std::string_view one_of;
  std::string_view reason = {}; ///< follows "--pressure goes with "; empty: "requires" the other one
  std::string_view beside = {}; ///< only where one of these is typed; empty: always
};

/// Required values of another option. They may be in a table too; with a table nothing is reported.
struct Belonging {
  std::string_view chooser;
  std::string_view choices;
  std::string_view otherwise; ///< the choice if none is typed
  std::string reason = {};    ///< follows "--eta goes with "; empty: chooser and choice
};

/// Other names of an input, separated by blanks, without hyphens, in small letters unless case matters.
struct Synonyms {
  std::string_view words;
  std::string_view remark = {};
};

struct OptionRow {
  std::string name; ///< all names: "--out", "-h,--help"; without hyphens for an argument
  Value value = {};
  std::string group = {};
  std::string meaning = {};
  std::vector<Exclusion> excludes = {};
  std::vector<Need> needs = {};
  std::vector<Belonging> belongs = {};
  std::vector<Synonyms> synonyms = {};
  bool required = false;

  [[nodiscard]] bool positional() const { return !name.starts_with('-'); }
};

enum class ExitCode : int {
  ok = 0,
  fell_short = 1,    ///< some rows or checks failed
  usage = 2,         ///< invalid arguments
  file = 3,          ///< a file that cannot be read or written
  not_converged = 4, ///< numerics did not converge, or --strict and outside validity
  // stopped work: 128 plus the number of the signal, see exit_code_of_stop
};

/// The program, or a command with its options or subcommands. Its work runs after parsing and throws granum's
/// errors, which main converts to a message and an exit code.
struct Command {
  std::string name; ///< "lammps"
  std::string meaning;
  std::string called = {}; ///< "granum export lammps"
  std::string group = {};  ///< of commands in help; empty: not listed
  std::string notes = {};  ///< below the options
  std::vector<OptionRow> options = {};
  std::vector<Command> within = {};
  std::function<ExitCode()> run = {};

  void add(OptionRow row);
  /// \param    their_group   of the rows that name none
  void add(const std::string& their_group, std::initializer_list<OptionRow> rows);
  /// The row of an option by any of its names. \throws std::logic_error if the command has none
  [[nodiscard]] OptionRow& row(std::string_view option);
  [[nodiscard]] const OptionRow* find(std::string_view option) const;
  void remove(std::string_view option);
  [[nodiscard]] bool takes_arguments() const; ///< words without an option
};

/// "-h" and "--help"; empty for a positional argument.
[[nodiscard]] std::vector<std::string> names_of(const OptionRow& row);
/// The name used in tables and contradictions; "--vs" in "--shear-wave-speed,--vs" is the second name.
[[nodiscard]] std::string first_name(const OptionRow& row);
[[nodiscard]] bool is_named(const OptionRow& row, std::string_view option);
/// The parts of a text between separators.
[[nodiscard]] std::vector<std::string> split_at(std::string_view text, char separator);
/// The words of a text that blanks separate.
[[nodiscard]] std::vector<std::string> words_of(std::string_view text);
/// "--stress-h" for "stress_h".
[[nodiscard]] std::string option_of(std::string name);
/// Splits words at blanks.
[[nodiscard]] bool has_word(std::string_view list, std::string_view word);

// ---- values

[[nodiscard]] Value flag(bool& target);
/// A number with its unit, in SI.
/// \throws   InvalidArgument naming the option, with a hint to commands for several states
[[nodiscard]] double quantity_in(const std::string& name, const std::string& text, Dimension dimension);
/// A number with its unit; its value is the default that help shows.
[[nodiscard]] Value number(Number& target);
[[nodiscard]] Value number_without_default(Number& target);
[[nodiscard]] Value quantity(double& target, Dimension dimension);
[[nodiscard]] Value quantity(std::optional<double>& target, Dimension dimension);
/// A count, 0 or more.
[[nodiscard]] Value count(std::optional<std::size_t>& target);
[[nodiscard]] Value whole_number(std::size_t& target, std::size_t least, std::size_t most);
/// The name of a file or folder. Empty text, for instance of an unset shell variable, is refused: `target`
/// is empty only if the option is not given.
[[nodiscard]] Value path(std::string& target, std::string type = "FILE");
[[nodiscard]] Value text(std::string& target, std::string type = "TEXT");
/// A text that may be given repeatedly.
[[nodiscard]] Value texts(std::vector<std::string>& target, std::string type);

using Take = std::function<void(const std::string& text)>;
/// Reads a text; a refusal that does not begin with the name of the option gets it.
void take_as(const std::string& name, const std::string& text, const Take& take);
/// Text read by `take`, which rejects it with an InvalidArgument that does not name the option.
[[nodiscard]] Value read_by(Take take, std::string type);
/// The same for a text that is one of a few words, or begins with one: "friction:NUMBER".
[[nodiscard]] Value read_by(Take take, std::vector<std::string> choices);

/// Synonyms of a choice, and the choice: "hertz" for sphere.
using OtherWords = std::vector<std::pair<std::string, std::string>>;
/// One of a few words, in large or small letters; similar words get a suggestion.
[[nodiscard]] Value choice(std::vector<std::string> words, Take take, OtherWords others = {});
/// The same; the current value is the default.
[[nodiscard]] Value choice(std::vector<std::string> words, std::string& target);

/// The name of a number of this dimension in help: PRESSURE, LENGTH, ..., NUMBER.
[[nodiscard]] std::string type_name(Dimension dimension);
[[nodiscard]] std::string in_small_letters(std::string text);

} // namespace granum::cli

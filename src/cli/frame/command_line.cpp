// SPDX-License-Identifier: GPL-3.0-or-later
#include "command_line.hpp"

#include <algorithm>
#include <cctype>
#include <string_view>

#include <CLI/CLI.hpp>
#include <granum/core/number.hpp>

namespace granum::cli {

namespace {

constexpr Dimension all_dimensions[] = {Dimension::dimensionless, Dimension::pressure, Dimension::length,
                                        Dimension::angle,         Dimension::density,  Dimension::unit_weight,
                                        Dimension::time,          Dimension::force,    Dimension::speed};

/// "--name", "-n" or, cut off its value, "--name=value"; empty for other words and negative numbers.
std::string option_name(const std::string& word) {
  if (word.size() < 2 || word[0] != '-' || parse_number(word) || word == "--")
    return {};
  const bool number = std::isdigit(static_cast<unsigned char>(word[1])) || word[1] == '.';
  return number ? std::string() : word.substr(0, word.find('='));
}

/// Whether a value ends in a number that may still get its unit, as 100, 280+-5, radius=0.5 and 0m..30 do.
bool awaits_unit(std::string_view value) {
  for (const std::string_view mark : {"=", ",", ":", "+-", "\u00b1", ".."})
    if (const std::size_t at = value.rfind(mark); at != std::string_view::npos)
      value.remove_prefix(at + mark.size());
  return parse_number(value).has_value();
}

bool is_unit(const std::string& word) { return !word.empty() && find_unit(word).has_value(); }

bool is_error_sign(const std::string& word) { return word == "+-" || word == "+/-" || word == "\u00b1"; }

/// Whether an option takes numbers with units, in its value or behind a key.
bool takes_units(const CLI::Option& option) {
  const std::string type = option.get_type_name();
  return dimension_of(option) || type.starts_with("KEY=") || type.find("..") != std::string::npos;
}

/// Reads one word after the other.
class Reader {
 public:
  Reader(const CLI::App& command, const std::vector<std::string>& words) : command_(command), words_(words) {
    positionals_ = !command.get_options([](const CLI::Option* o) { return o->get_positional(); }).empty();
  }

  std::vector<TypedArgument> read() {
    std::vector<TypedArgument> all;
    while (next_ < words_.size())
      all.push_back(argument());
    return all;
  }

 private:
  TypedArgument argument() {
    const std::string& word = words_[next_++];
    TypedArgument typed{.word = word, .option = nullptr, .values = {}, .joined = false};
    const std::string name = option_name(word);
    if (name.empty())
      return typed;
    typed.option = command_.get_option_no_throw(name);
    if (name.size() < word.size()) {
      typed.joined = true;
      typed.word = name;
      typed.values.push_back(word.substr(name.size() + 1));
    } else if (typed.option != nullptr) {
      take_values(*typed.option, typed.values);
    }
    if (typed.option != nullptr && takes_units(*typed.option) && !typed.values.empty())
      join_unit(*typed.option, typed.values.back());
    return typed;
  }

  /// A value may begin with a hyphen where it is no option that the command knows.
  void take_values(const CLI::Option& option, std::vector<std::string>& values) {
    const bool many = option.get_items_expected_max() > 1 && option.get_allow_extra_args();
    while (next_ < words_.size() && option.get_items_expected_max() > 0 && (values.empty() || many)) {
      const std::string name = option_name(words_[next_]);
      if (!name.empty() && (!values.empty() || command_.get_option_no_throw(name) != nullptr))
        return;
      values.push_back(words_[next_++]);
    }
  }

  void join_unit(const CLI::Option& option, std::string& value) {
    while (next_ < words_.size()) {
      const std::string& word = words_[next_];
      const bool unit = awaits_unit(value) && (is_unit(word) || must_be_unit(option, word));
      if (is_error_sign(word) && next_ + 1 < words_.size())
        value += "+-" + words_[++next_];
      else if (word == ".." && next_ + 1 < words_.size())
        value += ".." + words_[++next_];
      else if (unit)
        value += word;
      else
        return;
      ++next_;
    }
  }

  /// A word that can be nothing but a unit which nobody knows: the message is that of the number then.
  [[nodiscard]] bool must_be_unit(const CLI::Option& option, const std::string& word) const {
    const bool needed = dimension_of(option).value_or(Dimension::dimensionless) != Dimension::dimensionless;
    return needed && !positionals_ && !word.empty() && std::isalpha(static_cast<unsigned char>(word[0])) &&
           word.find('=') == std::string::npos;
  }

  const CLI::App& command_;
  const std::vector<std::string>& words_;
  bool positionals_ = false;
  std::size_t next_ = 0;
};

} // namespace

std::vector<TypedArgument> read_arguments(const CLI::App& command, const std::vector<std::string>& words) {
  return Reader(command, words).read();
}

std::vector<std::string> words_of(const std::vector<TypedArgument>& arguments) {
  std::vector<std::string> words;
  for (const TypedArgument& argument : arguments) {
    words.push_back(argument.word);
    if (argument.joined)
      words.back() += "=" + argument.values.front();
    else
      words.insert(words.end(), argument.values.begin(), argument.values.end());
  }
  return words;
}

CheckedValue checked(const CLI::Option& option, const std::string& value) {
  CheckedValue out{.value = value, .complaint = {}};
  auto& with_checks = const_cast<CLI::Option&>(option); // NOLINT: the parser shows them of such alone
  for (int k = 0; out.complaint.empty(); ++k) {
    try {
      out.complaint = (*with_checks.get_validator(k))(out.value);
    } catch (const CLI::OptionNotFound&) { // there are no more
      break;
    }
  }
  return out;
}

std::string in_small_letters(std::string text) {
  for (char& c : text)
    c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  return text;
}

std::string type_name(Dimension dimension) {
  if (dimension == Dimension::dimensionless)
    return "NUMBER";
  const std::string_view words = description(dimension);
  std::string name(words.substr(words.find(' ') + 1));
  for (char& c : name)
    c = c == ' ' ? '_' : static_cast<char>(std::toupper(static_cast<unsigned char>(c)));
  return name;
}

std::optional<Dimension> dimension_of(const CLI::Option& option) {
  const std::string type = option.get_type_name();
  for (const Dimension dimension : all_dimensions)
    if (type.starts_with(type_name(dimension)))
      return dimension;
  return std::nullopt;
}

} // namespace granum::cli

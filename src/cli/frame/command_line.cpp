// SPDX-License-Identifier: GPL-3.0-or-later
#include "command_line.hpp"

#include <algorithm>
#include <cctype>
#include <cmath>
#include <exception>
#include <string_view>

#include <fmt/format.h>
#include <granum/core/error.hpp>
#include <granum/core/text.hpp>
#include <granum/estimate/inputs.hpp>

#include "contradictions.hpp"
#include "suggest.hpp"

namespace granum::cli {

namespace {

/// "--name", "-n" or, cut off its value, "--name=value"; empty for other words and negative numbers.
std::string option_name(const std::string& word) {
  if (word.size() < 2 || word[0] != '-' || parse_number(word) || word == "--")
    return {};
  const bool number = std::isdigit(static_cast<unsigned char>(word[1])) || word[1] == '.';
  return number ? std::string() : word.substr(0, word.find('='));
}

/// Whether a value ends in a number whose unit may follow, as in 100, 280+-5, radius=0.5 and 0m..30.
bool awaits_unit(std::string_view value) {
  for (const std::string_view mark : {"=", ",", ":", "+-", "\u00b1", ".."})
    if (const std::size_t at = value.rfind(mark); at != std::string_view::npos)
      value.remove_prefix(at + mark.size());
  return parse_number(value).has_value();
}

bool is_unit(const std::string& word) { return !word.empty() && find_unit(word).has_value(); }

bool is_error_sign(const std::string& word) { return word == "+-" || word == "+/-" || word == "\u00b1"; }

/// Reads the words in order.
class Reader {
 public:
  Reader(const Command& command, const std::vector<std::string>& words)
      : command_(command), words_(words), positionals_(command.takes_arguments()) {
    for (const OptionRow& row : command.options)
      if (row.positional())
        argument_ = &row;
  }

  std::vector<TypedArgument> read() {
    std::vector<TypedArgument> all;
    while (next_ < words_.size())
      all.push_back(next());
    return all;
  }

 private:
  TypedArgument next() {
    const std::string& word = words_[next_++];
    TypedArgument typed{.word = word, .option = nullptr, .values = {}};
    const std::string name = option_name(word);
    if (name.empty())
      return argument_named(std::move(typed));
    typed.option = command_.find(name);
    const bool joined = name.size() < word.size();
    if (joined && typed.option != nullptr) {
      typed.word = name;
      typed.values.push_back(word.substr(name.size() + 1));
    } else if (joined) {
      typed.word = name;
    } else if (typed.option != nullptr) {
      take_values(typed.option->value, typed.values);
    }
    if (typed.option != nullptr && !typed.values.empty())
      join_unit(typed.option->value, typed.values.back());
    return typed;
  }

  /// A word that is an argument, such as the name of a file.
  TypedArgument argument_named(TypedArgument typed) {
    if (argument_ != nullptr && (arguments_ == 0 || argument_->value.several)) {
      typed.option = argument_;
      typed.values = {typed.word};
      typed.word = argument_->name;
      ++arguments_;
    } else
      typed.stray = true;
    return typed;
  }

  /// A value may begin with a hyphen unless it is an option of the command.
  void take_values(const Value& value, std::vector<std::string>& values) {
    while (next_ < words_.size() && !value.flag() && (values.empty() || value.several)) {
      const std::string name = option_name(words_[next_]);
      if (!name.empty() && (!values.empty() || command_.find(name) != nullptr))
        return;
      values.push_back(words_[next_++]);
    }
  }

  void join_unit(const Value& takes, std::string& value) {
    while (next_ < words_.size() && (takes.dimension || takes.joins_units)) {
      const std::string& word = words_[next_];
      const bool unit = awaits_unit(value) && (is_unit(word) || must_be_unit(takes, word));
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

  /// A word that can only be an unknown unit; the error is then that of the number.
  [[nodiscard]] bool must_be_unit(const Value& takes, const std::string& word) const {
    const bool needed = takes.dimension.value_or(Dimension::dimensionless) != Dimension::dimensionless;
    return needed && !positionals_ && !word.empty() && std::isalpha(static_cast<unsigned char>(word[0])) &&
           word.find('=') == std::string::npos;
  }

  const Command& command_;
  const std::vector<std::string>& words_;
  bool positionals_;
  const OptionRow* argument_ = nullptr; ///< for words without an option
  std::size_t arguments_ = 0;
  std::size_t next_ = 0;
};

/// Whether an option was typed with one number, this one.
bool is_number(const TypedArgument& typed, double value) {
  constexpr double rounding = 1e-12; // of units
  try {
    const double number = parse_quantity(typed.word, typed.values.at(0),
                                         typed.option->value.dimension.value_or(Dimension::dimensionless));
    return std::abs(number - value) <= rounding * std::abs(value);
  } catch (const InvalidArgument&) { // of several numbers, or of none
    return false;
  }
}

/// Passes the values to an option.
/// \return   the first error; empty if there is none
std::string fault_of_value(const TypedArgument& typed, std::exception_ptr& unreadable) {
  const Value& value = typed.option->value;
  if (value.flag() != typed.values.empty())
    return typed.word + (value.flag() ? " takes no value" : " has no value");
  try {
    if (value.flag() && value.take)
      value.take(typed.word, {});
    for (const std::string& given : typed.values)
      for (const std::string& text : split_at(given, value.delimiter))
        value.take(typed.word, text);
  } catch (const InvalidArgument& error) {
    return error.what();
  } catch (const FileError&) {
    unreadable = std::current_exception();
  }
  return {};
}

} // namespace

std::vector<TypedArgument> read_arguments(const Command& command, const std::vector<std::string>& words) {
  return Reader(command, words).read();
}

std::vector<std::string> take_arguments(const Command& program, const Command& command,
                                        const std::vector<TypedArgument>& arguments) {
  std::vector<std::string> faults;
  std::vector<const OptionRow*> before;
  std::exception_ptr unreadable;
  Contradictions contradictions(arguments);
  bool of_unknown = false; // the previous word is an unknown option: this one may be its value
  for (std::size_t k = 0; k < arguments.size(); ++k) {
    const TypedArgument& typed = arguments[k];
    const OptionRow* row = typed.option;
    std::string fault;
    const bool again = row != nullptr && std::find(before.begin(), before.end(), row) != before.end();
    if (again && !row->value.repeated && !row->value.several)
      fault = typed.word + " is given twice";
    else if (row != nullptr)
      fault = fault_of_value(typed, unreadable);
    else if (!typed.stray)
      fault = unknown_option(program, command, typed.word);
    else if (!of_unknown)
      fault = stray_word(program, command, typed.word);
    if (!fault.empty())
      faults.push_back(fault);
    if (const std::string contradiction = contradictions.of(k); !contradiction.empty())
      faults.push_back(contradiction);
    before.push_back(row);
    of_unknown = (row == nullptr && !typed.stray) || (of_unknown && row == nullptr);
  }
  for (const OptionRow& row : command.options)
    if (row.required && std::find(before.begin(), before.end(), &row) == before.end())
      faults.push_back(fmt::format("{} is required; see {} --help", row.name, command.called));
  if (faults.empty() && unreadable)
    std::rethrow_exception(unreadable);
  return faults;
}

namespace {

std::vector<AskedOption>& asked() {
  static std::vector<AskedOption> all;
  return all;
}

} // namespace

const std::vector<AskedOption>& asked_options() { return asked(); }

void remember_asked(const std::vector<TypedArgument>& arguments) {
  for (const TypedArgument& typed : arguments)
    if (typed.option != nullptr && typed.option->group != output_group)
      asked().push_back({typed.word, fmt::format("{}", fmt::join(typed.values, " ")), typed.option->meaning});
}

InvalidArgument as_typed(const InvalidArgument& error, const std::vector<TypedArgument>& arguments) {
  const auto& refused = error.refused();
  const std::string text = error.what();
  if (!refused) { // "<name>: ...", whose option was typed
    const std::size_t end = text.find(": ");
    std::string name = text.substr(0, end);
    std::replace(name.begin(), name.end(), ' ', '_');
    for (const TypedArgument& typed : arguments)
      if (end != std::string::npos && typed.option != nullptr && is_named(*typed.option, option_of(name)))
        return InvalidArgument(typed.word + text.substr(end));
    return error;
  }
  if (!text.starts_with(refused->name))
    return error;
  const estimate::InputRow* const row = estimate::find_input(refused->name);
  const std::string option = row != nullptr ? row->option() : option_of(refused->name);
  for (const TypedArgument& typed : arguments)
    if (typed.option != nullptr && is_named(*typed.option, option) && is_number(typed, refused->value))
      return {option, refused->value, refused->unit, refused->range};
  for (const TypedArgument& typed : arguments)
    if (refused->name == "void_ratio" && typed.option != nullptr &&
        (is_named(*typed.option, "--porosity") || is_named(*typed.option, "--solid-fraction")))
      return InvalidArgument(typed.word + " " + typed.values.at(0) + ": " + error.what());
  return error;
}

} // namespace granum::cli

// SPDX-License-Identifier: GPL-3.0-or-later
#include "scene_file.hpp"

#include <algorithm>
#include <filesystem>
#include <string_view>
#include <system_error>

#include <fmt/core.h>
#include <fmt/ranges.h>
#include <granum/core/error.hpp>
#include <granum/core/text.hpp>
#include <granum/io/text/source.hpp>
#include <toml++/toml.h>

namespace granum::cli {

namespace {

namespace fs = std::filesystem;
using studies::Scene;
using studies::SceneCommand;
using studies::SceneKey;

// ---- the text of a scene file, checked before a parser sees it

constexpr std::size_t largest_file = 1'000'000; ///< bytes
constexpr std::size_t most_parts = 8;           ///< of a key
constexpr std::size_t deepest = 8;              ///< brackets within brackets
constexpr std::size_t longest = 1000;           ///< key or value, characters

/// Reads a TOML text and counts the depth of a parser's stack.
class FlatCheck {
 public:
  FlatCheck(std::string_view text, const std::string& path) : text_(text), path_(path) {}

  void run() {
    while (place_ < text_.size()) {
      const char c = text_[place_];
      if (c == '"' || c == '\'')
        pass_string(c);
      else
        pass(c);
    }
  }

 private:
  [[noreturn]] void refuse(const std::string& what) const {
    throw FileError(path_, line_, what + "; a scene has sections, and keys with a value");
  }

  void begin_item() { parts_ = 1, length_ = 0; }

  void lengthen(std::size_t by) {
    length_ += by;
    if (length_ > longest)
      refuse("a key or value of more than " + std::to_string(longest) + " characters");
  }

  void pass(char c) {
    ++place_;
    switch (c) {
    case '\n':
      ++line_;
      return begin_item();
    case '#':
      place_ = std::min(text_.find('\n', place_), text_.size());
      return;
    case '.':
      if (++parts_ > most_parts)
        refuse("a key of more than " + std::to_string(most_parts) + " parts");
      return lengthen(1);
    case '[':
    case '{':
      if (++depth_ > deepest)
        refuse("brackets more than " + std::to_string(deepest) + " deep");
      return begin_item();
    case ']':
    case '}':
      depth_ -= depth_ > 0;
      return begin_item();
    case ',':
    case '=':
      return begin_item();
    default:
      return lengthen(1);
    }
  }

  /// Moves to the end of a text in single or triple quotes; an unclosed text ends with its line.
  void pass_string(char quote) {
    const std::size_t begin = place_;
    const std::string three(3, quote);
    const bool many_lines = text_.substr(place_, 3) == three;
    place_ += many_lines ? 3 : 1;
    for (; place_ < text_.size(); ++place_) {
      const char c = text_[place_];
      if (c == '\n') {
        ++line_;
        if (!many_lines)
          break;
      } else if (c == '\\' && quote == '"') {
        ++place_;
      } else if (c == quote && (!many_lines || text_.substr(place_, 3) == three)) {
        place_ += many_lines ? 3 : 1;
        break;
      }
    }
    place_ = std::min(place_, text_.size());
    lengthen(place_ - begin);
  }

  std::string_view text_;
  const std::string& path_;
  std::size_t place_ = 0;
  std::size_t line_ = 1;
  std::size_t parts_ = 1;
  std::size_t length_ = 0;
  std::size_t depth_ = 0;
};

/// The text of a regular file or a pipe of at most one megabyte.
/// \throws   FileError for a folder, a device, a larger file, or one that cannot be read
std::string read_scene_text(const std::string& path) {
  std::error_code unknown; // a file that cannot be found is reported on reading
  const fs::file_type type = fs::status(path, unknown).type();
  if (type == fs::file_type::character || type == fs::file_type::block)
    throw FileError(path, 0, "is a device; a scene is a TOML file or comes through a pipe");
  return io::file_content(path, largest_file);
}

/// Scenes are flat: [section] and key = value. In deeply nested texts the recursion of the parser would
/// overflow the stack.
/// \throws   FileError with path and line for a key of more than 8 parts, brackets more than 8 deep, or a key
///           or value of more than 1,000 characters
void require_flat(std::string_view text, const std::string& path) { FlatCheck(text, path).run(); }

// ---- its keys

/// A TOML value as a text for --set.
std::string text_of(const toml::node& node, const std::string& path) {
  const auto line = node.source().begin.line;
  if (const auto* text = node.as_string())
    return text->get();
  if (const auto* integer = node.as_integer())
    return std::to_string(integer->get());
  if (const auto* number = node.as_floating_point())
    return exact_text(number->get());
  if (const auto* list = node.as_array()) {
    std::string joined;
    for (const toml::node& item : *list) {
      if (item.is_array() || item.is_table())
        throw FileError(path, line, "a list may contain texts and numbers only");
      joined += (joined.empty() ? "" : ",") + text_of(item, path);
    }
    return joined;
  }
  throw FileError(path, line, "expected a text such as \"0.5mm\", a number, or a list of them");
}

/// Calls take(name, node) for every key of a table, those of its sections as "section.key".
template <class Take>
void each_key(const toml::table& table, const std::string& prefix, const Take& take) {
  for (const auto& [key, node] : table) {
    const std::string name = prefix + std::string(key.str());
    if (const toml::table* section = node.as_table())
      each_key(*section, name + ".", take);
    else
      take(name, node);
  }
}

} // namespace

void SceneInput::read_file(const std::string& path) {
  const std::string text = read_scene_text(path);
  require_flat(text, path);
  toml::table table;
  try {
    table = toml::parse(text, path);
  } catch (const toml::parse_error& error) {
    throw FileError(path, error.source().begin.line, std::string(error.description()));
  }
  path_ = path;
  each_key(table, "", [&](const std::string& name, const toml::node& node) {
    const auto line = static_cast<std::size_t>(node.source().begin.line);
    try {
      (void)studies::scene_key(name); // an unknown key is reported before a wrong kind of value
      builder_.set_listed(name, text_of(node, path), line);
    } catch (const InvalidArgument& error) {
      throw FileError(path, line, error.what());
    }
  });
  builder_.end_list();
}

void SceneInput::set(const std::string& setting) {
  const std::size_t equals = setting.find('=');
  if (equals == std::string::npos)
    throw InvalidArgument("--set " + setting + ": expected key=value");
  builder_.set(std::string(trimmed(setting.substr(0, equals))),
               std::string(trimmed(setting.substr(equals + 1))));
}

Scene SceneInput::finished() {
  studies::require_valid(builder_.scene());
  if (const auto idle = builder_.without_effect(); idle && idle->line)
    throw FileError(path_, *idle->line, idle->message);
  return builder_.finished();
}

Scene read_scene(const std::string& path, SceneCommand command) {
  SceneInput input(command, {});
  input.read_file(path);
  studies::require_valid(input.scene());
  return input.scene();
}

nlohmann::ordered_json json_of(const Scene& scene) {
  nlohmann::ordered_json json;
  for (const SceneKey& key : studies::scene_keys())
    std::visit([&](const auto& value) { json[key.section()][key.json_name] = value; }, key.resolved(scene));
  return json;
}

std::string key_help(SceneCommand command) {
  std::string text = "Keys of scenes and of --set:\n";
  for (const SceneKey& key : studies::scene_keys())
    if (key.taken_by(command))
      text += fmt::format("  {:<30} {}\n", key.name, key.description());
  return text;
}

} // namespace granum::cli

// SPDX-License-Identifier: GPL-3.0-or-later
#include "frame.hpp"

#include <algorithm>

#include <unistd.h>

#include <CLI/CLI.hpp>
#include <fmt/core.h>
#include <granum/core/error.hpp>
#include <granum/core/near_miss.hpp>
#include <granum/core/utf8.hpp>
#include <granum/core/version.hpp>
#include <granum/io/output_file.hpp>

#include "command_line.hpp"
#include "help.hpp"
#include "messages.hpp"

namespace granum::cli {

void add_output_options(CLI::App& command, OutputOptions& options) {
  command.add_flag("--json", options.json, "Print one JSON object, SI units");
  command.add_flag("--strict", options.strict,
                   "Fail (exit code 4) if the result lies outside a formula's validity");
  auto* out = add_path(command, "--out", options.out, "Write the result to this file")->type_name("FILE");
  command.add_flag("--force", options.force, "Let --out replace an existing file")->needs(out);
  in_group(command, output_group, {"--json", "--strict", "--out", "--force"});
}

ExitCode code_of_failed(std::size_t failed, std::size_t all) {
  return failed == 0 ? ExitCode::ok : failed == all ? ExitCode::not_converged : ExitCode::fell_short;
}

CLI::Option* add_quantity(CLI::App& command, const std::string& name, double& target, Dimension dimension,
                          const std::string& help) {
  const auto take = [name, dimension, &target](const std::string& text) {
    target = parse_quantity(name, text, dimension);
  };
  return command.add_option_function<std::string>(name, take, help)
      ->type_name(type_name(dimension))
      ->default_str(pretty(target, dimension));
}

CLI::Option* add_quantity(CLI::App& command, const std::string& name, std::optional<double>& target,
                          Dimension dimension, const std::string& help) {
  const auto take = [name, dimension, &target](const std::string& text) {
    target = parse_quantity(name, text, dimension);
  };
  return command.add_option_function<std::string>(name, take, help)->type_name(type_name(dimension));
}

std::string threads_text(std::size_t threads) {
  return fmt::format("{} thread{}", threads, threads == 1 ? "" : "s");
}

std::optional<std::array<std::string, 2>> ends_of_range(const std::string& text) {
  const std::size_t dots = text.find("..");
  if (dots == std::string::npos || text.substr(dots + 2).starts_with('.'))
    return {};
  return std::array{text.substr(0, dots), text.substr(dots + 2)};
}

CLI::Option* add_path(CLI::App& command, const std::string& name, std::string& target,
                      const std::string& help) {
  const auto take = [name, &target](const std::string& text) {
    if (text.empty())
      throw InvalidArgument(name + " is empty: give a name, or leave the option out");
    target = text;
  };
  return command.add_option_function<std::string>(name, take, help);
}

CLI::Option* add_picture(CLI::App& command, std::string& target, const std::string& help) {
  CLI::Option* force = command.get_option("--force");
  force->remove_needs(command.get_option("--out"));
  force->description("Let --out and --picture replace existing files");
  return add_path(command, "--picture", target, help)->type_name("FILE.svg")->group(output_group);
}

CLI::Validator one_of(const std::vector<std::string>& words, const OtherWords& others) {
  std::string list;
  for (const std::string& word : words)
    list += (list.empty() ? "" : ",") + word;
  const auto take = [words, others, list](std::string& text) -> std::string {
    const std::vector<std::string> near = near_misses(text, words);
    if (near.size() == 1 && slips_between(in_small_letters(text), in_small_letters(near[0])) == 0) {
      text = near[0];
      return {};
    }
    std::string question = did_you_mean(text, words);
    for (const auto& [other, word] : others)
      if (in_small_letters(text) == other)
        question = "; did you mean " + word + "?";
    return text + " not in {" + list + "}" + question;
  };
  return CLI::Validator(take, "{" + list + "}");
}

CLI::Validator taken_by(const std::function<void(const std::string&)>& read) {
  const auto take = [read](std::string& text) -> std::string {
    try {
      read(text);
    } catch (const InvalidArgument& error) {
      return error.what();
    }
    return {};
  };
  return CLI::Validator(take, "");
}

void prepare_folder(const std::filesystem::path& folder, std::span<const char* const> names, bool force) {
  for (const char* name : names)
    if (!force && io::is_taken(folder / name))
      throw FileError((folder / name).string(), 0, "exists already and is kept; --force replaces it");
  std::error_code error;
  std::filesystem::create_directories(folder, error);
  if (error)
    throw FileError(folder.string(), 0, "cannot be made: " + error.message());
  if (access(folder.c_str(), W_OK) != 0)
    throw FileError(folder.string(), 0, "cannot be written to");
}

std::filesystem::path results_folder(const std::string& out, std::string_view command,
                                     std::span<const char* const> names, bool force) {
  std::filesystem::path folder = out;
  for (int number = 1; out.empty() && (number == 1 || std::filesystem::exists(folder)); ++number)
    folder = fmt::format("granum-{}-{}", command, number);
  prepare_folder(folder, names, force);
  return folder;
}

nlohmann::ordered_json json_head(std::string_view command) {
  return {{"program", "granum"}, {"version", version()}, {"compiler", compiler()}, {"command", command}};
}

std::string json_text(const nlohmann::ordered_json& json, int indent) {
  return json.dump(indent, ' ', false, nlohmann::ordered_json::error_handler_t::replace) +
         (indent >= 0 ? "\n" : "");
}

nlohmann::ordered_json with_warnings(nlohmann::ordered_json json, const Validity& validity) {
  if (json.is_object() && !validity.ok())
    json["warnings"] = validity.notes;
  return json;
}

ExitCode deliver(const OutputOptions& options, const std::string& table, const nlohmann::ordered_json& json,
                 const Validity& validity) {
  const std::string text = options.json ? json_text(with_warnings(json, validity)) : table;
  if (options.out.empty())
    print(options.json ? text : printable(text));
  else
    io::write_file(options.out, text, options.force ? io::Existing::replace : io::Existing::keep);
  for (const std::string& note : validity.notes)
    say(options.strict ? "error" : "warning", note);
  return options.strict && !validity.ok() ? ExitCode::not_converged : ExitCode::ok;
}

} // namespace granum::cli

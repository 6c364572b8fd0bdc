// SPDX-License-Identifier: GPL-3.0-or-later
#include "frame.hpp"

#include <cstdio>

#include <unistd.h>

#include <CLI/CLI.hpp>
#include <fmt/core.h>
#include <granum/core/error.hpp>
#include <granum/core/utf8.hpp>
#include <granum/core/version.hpp>
#include <granum/io/output_file.hpp>

#include "command_line.hpp"
#include "messages.hpp"

namespace granum::cli {

namespace {

void print(const std::string& text) {
  if (std::fwrite(text.data(), 1, text.size(), stdout) != text.size() || std::fflush(stdout) != 0)
    throw FileError("standard output", 0, "cannot be written");
}

/// The warnings stand in the JSON too, so that its reader does not need standard error.
nlohmann::ordered_json with_warnings(nlohmann::ordered_json json, const Validity& validity) {
  if (json.is_object() && !validity.ok())
    json["warnings"] = validity.notes;
  return json;
}

} // namespace

void add_output_options(CLI::App& command, OutputOptions& options) {
  command.add_flag("--json", options.json, "Print one JSON object, SI units");
  command.add_flag("--strict", options.strict,
                   "Fail (exit code 4) if the result lies outside a formula's validity");
  auto* out = add_path(command, "--out", options.out, "Write the result to this file")->type_name("FILE");
  command.add_flag("--force", options.force, "Let --out replace an existing file")->needs(out);
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

CLI::Option* add_path(CLI::App& command, const std::string& name, std::string& target,
                      const std::string& help) {
  const auto take = [name, &target](const std::string& text) {
    if (text.empty())
      throw InvalidArgument(name + " is empty: give a name, or leave the option out");
    target = text;
  };
  return command.add_option_function<std::string>(name, take, help);
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

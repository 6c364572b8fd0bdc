// SPDX-License-Identifier: GPL-3.0-or-later
#include "frame.hpp"

#include <cerrno>
#include <cstring>

#include <unistd.h>

#include <fmt/core.h>
#include <granum/core/error.hpp>
#include <granum/core/text.hpp>
#include <granum/core/version.hpp>
#include <granum/io/output_file.hpp>

#include "messages.hpp"

namespace granum::cli {

void add_output_options(Command& command, OutputOptions& options) {
  command.add(output_group,
              {{.name = "--json", .value = flag(options.json), .meaning = "Print one JSON object, SI units"},
               {.name = "--strict",
                .value = flag(options.strict),
                .meaning = "Treat every warning as an error (exit code 4)"}});
  add_output_place(command, options.out, options.force, "FILE", "Write the result to this file",
                   "an existing file");
}

void add_output_place(Command& command, std::string& out, bool& force, std::string type, std::string out_help,
                      const std::string& replaced) {
  command.add(output_group, {{.name = "--out",
                              .value = path(out, std::move(type)),
                              .meaning = std::move(out_help),
                              .synonyms = {{"o output outfile"}}},
                             {.name = "--force",
                              .value = flag(force),
                              .meaning = "Let --out replace " + replaced,
                              .needs = {{"--out"}},
                              .synonyms = {{"f overwrite"}}}});
}

void add_picture(Command& command, std::string& target, const std::string& help) {
  OptionRow& force = command.row("--force");
  force.needs = {{"--out --picture", "--out or --picture"}};
  force.meaning = "Let --out and --picture replace existing files";
  command.add(output_group, {{.name = "--picture",
                              .value = path(target, "FILE.svg"),
                              .meaning = help,
                              .synonyms = {{"plot figure svg chart graph"}}}});
}

void require_free(const OutputOptions& output, const std::string& picture) {
  if (!picture.empty() && std::filesystem::path(picture).extension() != ".svg")
    throw InvalidArgument("--picture = '" + picture + "' must end in .svg");
  for (const std::string& file : {output.out, picture})
    if (!output.force && !file.empty() && io::is_taken(file))
      throw FileError(file, 0, "exists already and is kept; --force replaces it");
}

ExitCode code_of_failed(std::size_t failed, std::size_t all) {
  return failed == 0 ? ExitCode::ok : failed == all ? ExitCode::not_converged : ExitCode::fell_short;
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

void prepare_folder(const std::filesystem::path& folder, std::span<const char* const> names, bool force) {
  for (const char* name : names)
    if (!force && io::is_taken(folder / name))
      throw FileError((folder / name).string(), 0, "exists already and is kept; --force replaces it");
  std::error_code error;
  std::filesystem::create_directories(folder, error);
  if (error)
    throw FileError(folder.string(), 0, "cannot be made: " + error.message());
  if (access(folder.c_str(), W_OK) != 0)
    throw FileError(folder.string(), 0, std::string("cannot be written to: ") + std::strerror(errno));
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
  return printable_json(json.dump(indent, ' ', false, nlohmann::ordered_json::error_handler_t::replace)) +
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
    io::write_file(options.out, text, existing(options.force));
  for (const std::string& note : validity.notes)
    say(options.strict ? "error" : "warning", note);
  return options.strict && !validity.ok() ? ExitCode::not_converged : ExitCode::ok;
}

} // namespace granum::cli

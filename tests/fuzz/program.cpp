// SPDX-License-Identifier: GPL-3.0-or-later
// What the program is given beside files of data: scenes, command lines, and texts of analyse.
#include <algorithm>
#include <cmath>
#include <limits>
#include <memory>
#include <vector>

#include "cli/analyse/analyse_options.hpp"
#include "cli/commands.hpp"
#include "cli/frame/command_line.hpp"
#include "cli/frame/suggest.hpp"
#include "cli/options/scene_file.hpp"
#include "input.hpp"

namespace {

using namespace granum;
using fuzz::demand;

std::vector<std::string> parts(std::string_view text, std::string_view borders) {
  std::vector<std::string> out;
  while (!text.empty()) {
    const std::size_t end = std::min(text.find_first_of(borders), text.size());
    out.emplace_back(text.substr(0, end));
    text.remove_prefix(std::min(end + 1, text.size()));
  }
  return out;
}

studies::Scene finished(std::string_view text, studies::SceneCommand command) {
  const fuzz::MemoryFile file(text);
  cli::SceneInput input(command, {});
  input.read_file(file.path());
  return input.finished();
}

/// As every command that has a scene reads it: a scene that is taken is written as TOML and read again.
void scene(std::string_view text) {
  for (const studies::SceneCommand command : studies::all_scene_commands)
    fuzz::taken_or_refused<FileError>([&] {
      studies::Scene scene;
      bool taken = false; // unless the keys contradict one another
      fuzz::taken_or_refused<InvalidArgument>([&] {
        scene = finished(text, command);
        taken = true;
      });
      if (!taken)
        return;
      const std::string written = studies::toml_of(scene);
      const fuzz::MemoryFile file(written);
      demand(studies::toml_of(cli::read_scene(file.path(), command)) == written);
    });
}

/// Words between spaces: every line is taken or refused with a message. No command runs.
void command_line(std::string_view text) {
  std::vector<std::string> arguments = parts(text, " \n");
  for (std::string& argument : arguments) // as the system passes them: up to the first zero byte
    argument.resize(std::min(argument.find('\0'), argument.size()));
  const std::unique_ptr<cli::Command> program = cli::make_program();
  for (const cli::Command& command : program->within) // what is asked back, whatever the command
    fuzz::taken_or_refused<FileError>([&] {
      for (const std::string& fault :
           cli::take_arguments(*program, command, cli::read_arguments(command, arguments)))
        demand(!fault.empty());
    });
  if (!arguments.empty())
    demand(!cli::unknown_command(*program, arguments).empty());
}

/// One a line: frames, box, stress, window, depth, materials.
void analyse_options(std::string_view text) {
  std::vector<std::string> texts = parts(text, "\n");
  const std::vector<std::string> materials(
      texts.begin() + static_cast<long>(std::min<std::size_t>(texts.size(), 5)), texts.end());
  texts.resize(5);
  const auto check = [](const auto& action) { fuzz::taken_or_refused<InvalidArgument>(action); };
  check([&] {
    const cli::FrameChoice frames = cli::parse_frames(texts[0]);
    demand(frames.stride > 0 && frames.first <= frames.last);
    (void)frames.takes(std::numeric_limits<std::size_t>::max());
  });
  check([&] {
    if (const auto box = cli::parse_box(texts[1]))
      for (const double value : {box->cell(0, 0), box->cell(1, 1), box->cell(2, 2)})
        demand(value > 0 && std::isfinite(value));
  });
  check([&] {
    for (const double value : cli::parse_stress(texts[2]))
      demand(std::isfinite(value));
  });
  check([&] {
    if (const auto window = cli::parse_window(texts[3], texts[4])) {
      for (std::size_t k = 0; k < 3; ++k)
        for (const auto& end : {window->low[k], window->high[k]})
          demand(!end || std::isfinite(*end));
      if (window->depth)
        demand(window->depth->first >= 0 && window->depth->second > 0);
    }
  });
  check([&] {
    for (const auto& material : cli::parse_materials(materials))
      demand(material.second.shear_modulus > 0 && material.second.poisson_ratio > -1 &&
             material.second.poisson_ratio <= 0.5);
  });
}

const fuzz::Named of_program[] = {
    {"scene", scene}, {"command_line", command_line}, {"analyse_options", analyse_options}};

} // namespace

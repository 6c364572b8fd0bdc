// SPDX-License-Identifier: GPL-3.0-or-later
// Scene files, as every command that has a scene reads them: a scene that is taken is written as TOML and
// read again.
#include <string>

#include "cli/options/scene_file.hpp"
#include "input.hpp"
#include "memory_file.hpp"

using namespace granum;

namespace {

studies::Scene finished(std::string_view text, studies::SceneCommand command) {
  const fuzz::MemoryFile file(text);
  cli::SceneInput input(command, {});
  input.read_file(file.path());
  return input.finished();
}

} // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  for (const studies::SceneCommand command : studies::all_scene_commands)
    fuzz::run([&] {
      studies::Scene scene;
      try {
        scene = finished(fuzz::text(data, size), command);
      } catch (const InvalidArgument& error) { // the keys contradict one another
        fuzz::demand(!std::string(error.what()).empty());
        return;
      }
      const std::string written = studies::toml_of(scene);
      const fuzz::MemoryFile file(written);
      fuzz::demand(studies::toml_of(cli::read_scene(file.path(), command)) == written);
    });
  return 0;
}

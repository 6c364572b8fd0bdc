// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <string_view>

/// The part of a LAMMPS deck that is the same for every scene. Its numbers stand in scene.lmp.
namespace granum::io::lammps_scripts {

struct Script {
  std::string_view name;
  std::string_view text;
};

extern const std::string_view scene_head;
extern const std::array<Script, 17> files;     ///< preparation, isotropic compression, probes
extern const std::array<Script, 7> path_files; ///< stress path and its probes

} // namespace granum::io::lammps_scripts

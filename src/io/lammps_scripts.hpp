// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <string_view>
#include <utility>

/// The part of a LAMMPS deck that is the same for every scene. Its numbers stand in scene.lmp.
namespace granum::io::lammps_scripts {

extern const std::string_view scene_head;
/// Name and text of each file.
extern const std::array<std::pair<std::string_view, std::string_view>, 16> files;

} // namespace granum::io::lammps_scripts

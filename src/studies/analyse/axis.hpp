// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string_view>

#include <granum/io/imported_packing.hpp>

/// The axis of symmetry of a state that is not z.
/// Checked by tests/studies/test_axis.cpp
namespace granum::studies {

/// The axis of the files that is to be axis 3.
enum class Axis { x, y, z, principal };

/// "x", "y", "z", "principal"; empty for other text.
[[nodiscard]] std::optional<Axis> parse_axis(std::string_view text);

/// The packing in other axes: for x and y they change places in a cycle, so that the cell and its faces keep
/// their meaning. principal: the axes of the stress by contacts, the one as axis 3 whose two others differ
/// least.
/// \throws   InvalidArgument for principal, unless all faces are periodic and forces are known
/// Accuracy  exact for x, y and z.
[[nodiscard]] io::ImportedPacking about_axis(io::ImportedPacking packing, Axis axis);

} // namespace granum::studies

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <granum/io/imported_packing.hpp>

namespace granum::io {

/// The packing twice, side by side along an edge of its cell: the same material, with other numbers of
/// grains. Contacts between grains of ids i go on between i and its copy, whose id is larger by the range of
/// all ids. A contact of a grain with its own image becomes two of the grain and its copy.
/// \param    axis   0, 1 or 2, periodic
/// Checked by tests/io/test_own_image.cpp
[[nodiscard]] ImportedPacking doubled(const ImportedPacking& packing, int axis);

/// The packing, doubled until no grain is in contact with its own image, or, where contacts are not known,
/// so large that it would be, with a note if it was. Unchanged if that needs more than 64 copies.
/// Checked by tests/io/test_own_image.cpp
[[nodiscard]] ImportedPacking without_own_images(ImportedPacking packing);

} // namespace granum::io

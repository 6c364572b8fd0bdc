// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <vector>

#include <granum/core/vec3.hpp>
#include <granum/io/lammps/arrays.hpp>

#include "contact_layout.hpp"
#include "dump_file.hpp"
#include "io/packing_builder.hpp"

namespace granum::io {

/// A row of contacts, not yet joined with its grains.
struct LocalRow {
  long id1 = 0, id2 = 0;
  std::size_t line = 0;
  Vec3 difference{}; ///< x1 - x2
  bool through = false;
  bool turns = false; ///< carries a rolling or twisting moment
  double overlap = 0, force = 0, normal_stiffness = 0, tangential_stiffness = 0;
  Vec3 normal{}, tangential{}; ///< on grain 1; `normal` is the whole force where the layout has that
};

/// The contacts of one frame.
struct LocalFrame {
  DumpFrame frame;
  std::vector<std::string> columns;
  std::optional<ContactLayout> layout; ///< empty until identified by the values
  std::vector<LocalRow> rows;
  UnnamedTable unnamed; ///< rows without identified columns, or as numbers already
  DigitWatch digits, force_digits;
};

/// Reads the next frame; empty at the end of the file.
/// \throws   FileError as DumpFile::next, contact_layout, or for text where a number should be
[[nodiscard]] std::optional<LocalFrame> read_locals(DumpFile& file, const ColumnMap& map);

/// Adds the contacts of a frame to the packing, with a note on the interpretation: its rows, or its
/// unnamed table, which it makes into rows. Empties the rows.
/// \throws   FileError as layout_by_values and PackingBuilder::add
void join(PackingBuilder& builder, LocalFrame& locals, const DumpUnits& units);

/// Notes the data of contacts that a state of LAMMPS does not contain; the state may have no contacts.
/// Assumes   the contacts were joined
/// \param    where   "in a dump"
void note_unknown_contacts(PackingBuilder& builder, const LocalFrame* contacts, const std::string& where);

} // namespace granum::io

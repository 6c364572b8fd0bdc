// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <functional>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include <granum/packing/assembly.hpp>

/// A packing read from the output of any DEM code.
namespace granum::io {

/// Findings of an import that matter for the use of its numbers.
enum class Finding {
  few_digits,             ///< coordinates or overlaps have at most 8 significant digits
  duplicated,             ///< a pair is listed more than once with the same values; it counts once
  unsorted,               ///< contacts were not in the order of their grains; sorted here
  through_faces,          ///< contacts cross periodic faces; the nearest image was used
  open_contacts,          ///< contacts whose grains do not overlap
  wall_contacts,          ///< contacts with walls: they carry stress, but are not in C_n and fabric
  one_sided,              ///< pairs with one of two expected rows
  columns_told,           ///< columns were identified by their values, not by a heading
  forces_swapped,         ///< normal and tangential force are in the reverse order of the layout
  viscous_forces,         ///< the forces may contain viscous parts
  contacts_unknown,       ///< no contacts in the files
  contacts_from_overlaps, ///< contacts are overlapping spheres, because no file contains contacts
  walls_unknown,          ///< the files contain only the number of contacts with walls
  forces_unknown,         ///< contacts, but no forces
  tangential_unknown,     ///< normal forces, but no tangential ones
  ids_assumed,            ///< grains have no ids in the file; they were numbered
  cell_unknown,           ///< no box in the files: the cell is the smallest upright box around the grains
  boundary_unknown,       ///< which faces are periodic is not in the files
  units_unknown,          ///< no units in the files: SI assumed
  stiffness_unknown,      ///< k_n, k_t are zero until assign_stiffness is called
  law_unknown,            ///< contact law and grain material are not in the files
  contact_moments,        ///< columns of rolling or twisting moments are not zero
  bodies,                 ///< grains are parts of rigid bodies
  cell_turned,            ///< two edges of a left-handed cell were swapped
  own_image,              ///< a grain touches its own image: the cell is doubled
  units_differ,           ///< one file states other units than the other
  unbalanced_rows,        ///< grains whose contacts do not add up to the force that the file of grains states
  history_unknown,        ///< loading history of the tangential springs is not in the files
  signs_turned,           ///< all forces pulled overlapping spheres apart: they were turned
  shapes,                 ///< columns of shapes: grains are taken as spheres all the same
  not_used,               ///< columns or arrays that were not used
  empty_rows,             ///< rows of contacts that hold zeros alone; left out
  air_left_out,           ///< the box has an empty slab: it ends where the grains do
  axes_turned,            ///< the axes of the packing are others than those of the files
};

/// A finding and the words for it, with counts where there are any.
struct ImportNote {
  Finding finding;
  std::string text;
};

/// How far numbers may be from those that the code had, by the digits that the files print: half a unit of
/// the last digit of the largest number. 0 where there are more than 8 digits, which do not matter.
struct Rounding {
  double length = 0; ///< of coordinates [m]
  double overlap =
      0; ///< of overlaps: by their own digits where the files state them, else by those of lengths [m]
  double force = 0; ///< relative [1]
};

/// Columns of quantities in a dump: quantity -> name of the column (parse_column_map).
using ColumnMap = std::map<std::string, std::string, std::less<>>;

/// The box of a packing, which some files do not contain.
struct CsvBox {
  Mat3 cell; ///< columns are its edges [m]
  std::array<bool, 3> periodic{true, true, true};
};

/// What a user states about files, of any format.
struct PackingFileOptions {
  ColumnMap columns = {};         ///< of dumps; of any format "body" and "shape", if their column is "none"
  std::optional<CsvBox> box = {}; ///< used by files without one; must agree with that of others
  bool si = false;                ///< numbers without units are SI

  /// Whether the user says that there is no such quantity.
  [[nodiscard]] bool none(std::string_view quantity) const {
    const auto entry = columns.find(quantity);
    return entry != columns.end() && entry->second == "none";
  }
};

/// One state of a packing, SI, compression positive, grains in the order of their ids.
struct ImportedPacking {
  packing::Assembly assembly;
  std::vector<long> id;        ///< of each grain, as the files name it, ascending; of arrays in their order
  std::vector<long> type = {}; ///< of each grain; empty unless all have one
  std::array<bool, 3> periodic{true, true, true};
  long step = 0;
  std::optional<double> time; ///< [s]
  std::vector<ImportNote> notes;
  Rounding rounding = {};

  [[nodiscard]] bool has(Finding finding) const {
    for (const ImportNote& note : notes)
      if (note.finding == finding)
        return true;
    return false;
  }
};

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

/// The packing in the part of its box that the grains fill, so that volume, void ratio, stress and stiffness
/// do not depend on the size of the box. Across each edge of the cell: where a slab without any grain is
/// thicker than two mean diameters, the cell ends at the grains, with faces that are not periodic, and a
/// note. Nothing is left out of fewer than 100 grains, nor of a gas, where less than a tenth is solid.
/// Checked by tests/io/test_air.cpp
[[nodiscard]] ImportedPacking without_air(ImportedPacking packing);

} // namespace granum::io

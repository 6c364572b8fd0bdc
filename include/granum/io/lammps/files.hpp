// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include <granum/io/imported_packing.hpp>
#include <granum/io/lammps/arrays.hpp>
#include <granum/io/text/source.hpp>

/// Packings from files of LAMMPS and LIGGGHTS.
namespace granum::io {

/// Packings out of the dumps of LAMMPS (`dump custom` of atoms, `dump local` of contacts) and of LIGGGHTS,
/// which writes the same text; frame by frame, in memory no more than one frame.
///
/// Grains: id; radius or diameter; x y z, xu yu zu or xs ys zs. Boxes upright, tilted or of three
/// given edges.
/// Contacts, without a column map:
///   LAMMPS    property/local patom1 patom2 ... beside pair/local dist force fx fy fz p1 ... p12 (17 values),
///             or beside any usual part of dist dx dy dz eng force fx fy fz p1 p2 ... in this order: the
///             values are compared with the positions of the grains, and a note lists what they were taken
///             for. Forces are those on patom1, p10-p12 is x1 - x2.
///   LIGGGHTS  pair/gran/local pos id force force_normal force_tangential torque history contactPoint delta
///             (28 values). Forces are those on the first id; positions lie in the box, a flag marks pairs
///             that reach through a face.
/// Contacts with walls, among the grains' columns: the f_name[1] to f_name[8] of fix wall/gran ... contacts.
/// Which of two force vectors is the normal one is checked against the lines of centres, frame by frame;
/// if they are in the reverse order they are swapped, with a note.
///
/// Not in such files, and so noted: contact law, grain material, stiffnesses, loading history, and how much
/// of the force is viscous. SI is assumed unless there is ITEM: UNITS (si, cgs, micro, nano).
/// Checked by tests/io/lammps/test_dump.cpp, tests/io/lammps/test_layouts.cpp and
/// tests/io/liggghts/test_dump.cpp
class LammpsDump {
 public:
  /// Grains, and contacts if there are any; frames of equal time step belong together. `options`
  /// name columns without clear headings (parse_column_map).
  explicit LammpsDump(TextSource atoms, std::optional<TextSource> contacts = {},
                      PackingFileOptions options = {});
  LammpsDump(LammpsDump&&) noexcept;
  LammpsDump& operator=(LammpsDump&&) noexcept;
  ~LammpsDump();

  /// The next state that is in all files; empty at their end.
  /// \throws   FileError with path and line for text that is not such a dump, fields that are not
  ///           numbers, a frame cut off, a row of other length than the heading, ids that are missing or
  ///           occur twice, a radius that is not positive, a grain in contact with itself, one pair with
  ///           two forces, files of different states, columns that no layout or several fit, time steps
  ///           of a pipe that go back, and for files without one time step in common
  [[nodiscard]] std::optional<ImportedPacking> next();

  /// Frames passed over so far because the other file has none of that time step.
  [[nodiscard]] std::size_t skipped() const;
  /// Steps of all frames of grains, in the order of the file; none for a pipe. Frames that a later run of a
  /// restarted job wrote again are left out by next().
  [[nodiscard]] const std::vector<double>& moments() const;

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

/// The grains of a LAMMPS data file (write_data), atom style sphere: diameters, upright or tilted box. The
/// step is the one that the first line names. Not in such a file, and so noted: contacts, which faces are
/// periodic (all are assumed to be), units, contact law.
/// \throws   FileError with path and line for text that is no data file, another atom style, a box or count
///           that is missing, rows too few or too many, fields that are not numbers, repeated ids, a
///           diameter that is not positive
/// Checked by tests/io/lammps/test_data.cpp
[[nodiscard]] ImportedPacking read_lammps_data(TextSource source, const PackingFileOptions& options = {});

/// The grains as a data file that LAMMPS reads with atom style sphere: one atom type, all digits, at rest.
/// \param    density    of the grains [kg/m^3]
/// \param    id         empty for 1, 2, ... in the order of the grains, or one positive number each
/// \throws   InvalidArgument as require_valid(Assembly); for a cell that is not LAMMPS's (first edge along x,
///           second in the xy plane), a density that is not positive, ids that do not fit
/// Checked by tests/io/lammps/test_data.cpp
[[nodiscard]] std::string lammps_data(const packing::Assembly& assembly, double density,
                                      std::span<const long> id = {});

} // namespace granum::io

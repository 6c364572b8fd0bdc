// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <span>
#include <string>
#include <vector>

#include <granum/io/grain_fields.hpp>
#include <granum/packing/assembly.hpp>

/// Packings as VTK's XML files, for ParaView and every other reader of them. Text in ASCII,
/// SI, with all digits of every number.
/// Checked by tests/io/vtk/test_paraview.cpp
namespace granum::io {

/// Grains as an unstructured grid (.vtu) of one vertex each. Point data: id, the index or the value of `id`,
/// and the fields. Field data: cell, its three edges one after the other [m]; TimeValue. Show them as spheres
/// by a glyph scaled with the radius.
/// \param    id   empty, or one number for each grain
/// \param    time   of the state, if it is known [s]
/// \param    fields   without them grain_fields() of known forces
/// \throws   InvalidArgument as require_valid(Assembly), and for another number of ids or values of a field
[[nodiscard]] std::string grains_vtu(const packing::Assembly& assembly, std::span<const long> id,
                                     std::optional<double> time, std::span<const GrainField> fields);
[[nodiscard]] std::string grains_vtu(const packing::Assembly& assembly, std::span<const long> id = {},
                                     std::optional<double> time = {});

/// Contacts as lines (.vtp) from the centre of one grain to that of the other, its nearest periodic image,
/// and behind them those with walls, from the centre to the wall. Cell data: normal_force and
/// tangential_force [N] where they are known, the latter the vector exerted by grain i on j or the wall;
/// overlap [m];
/// normal_stiffness and tangential_stiffness [N/m], 0 where they are not known; sliding, 0 or 1;
/// through_face, 1 if the line leaves the periodic cell; grains, the two indices or values of `id`, twice
/// that of i at a wall; wall, its number, or -1 between grains. A tube of a radius by normal_force shows the
/// force chains. read_vtk_xml (xml.hpp) reads both files back.
/// \throws   as grains_vtu
[[nodiscard]] std::string contacts_vtp(const packing::Assembly& assembly, std::span<const long> id = {},
                                       KnownForces known = KnownForces::all);

/// A file at a time of a series, its name relative to the folder of the collection.
struct SeriesEntry {
  double time = 0; ///< or whatever orders the files
  std::string file;
  /// Files ahead of it that were left out, because a restarted job wrote their times again.
  std::size_t replaced = 0;
};

/// Files of a series (.pvd), which ParaView opens as one animated source.
[[nodiscard]] std::string pvd(std::span<const SeriesEntry> series);

} // namespace granum::io

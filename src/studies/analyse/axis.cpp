// SPDX-License-Identifier: GPL-3.0-or-later
#include "studies/analyse/axis.hpp"

#include <cmath>
#include <string>

#include <granum/core/error.hpp>
#include <granum/core/text.hpp>
#include <granum/packing/forces.hpp>

#include "core/compiled_once.hpp"

namespace granum::studies {

namespace {

/// Rows are the new axes in the old ones.
void turn(packing::Assembly& assembly, const Mat3& rows) {
  assembly.cell = rows * assembly.cell;
  for (Vec3& x : assembly.position)
    x = rows * x;
  for (auto* contacts : {&assembly.contacts, &assembly.wall_contacts})
    for (packing::Contact& c : *contacts) {
      c.branch = rows * c.branch;
      c.tangential_force = rows * c.tangential_force;
    }
}

Mat3 principal_axes(const io::ImportedPacking& packing) {
  if (packing.has(io::Finding::forces_unknown) || packing.assembly.contacts.empty())
    throw InvalidArgument("--axis principal needs the forces of contacts");
  if (!packing.periodic[0] || !packing.periodic[1] || !packing.periodic[2])
    throw InvalidArgument("--axis principal needs periodic faces: walls have axes of their own");
  const Mat3 stress = packing::contact_stress(packing.assembly).symmetric;
  Eigen::Matrix3d matrix;
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j < 3; ++j)
      matrix(i, j) = stress(i, j);
  const SymmetricEigen<3> found = symmetric_eigen<3>(matrix);
  const auto axis = [&](int k) {
    return Vec3{found.vectors(0, k), found.vectors(1, k), found.vectors(2, k)};
  };
  const bool smallest = found.values[2] - found.values[1] < found.values[1] - found.values[0];
  const Vec3 v = axis(smallest ? 0 : 2), h = axis(1), other = cross(v, h);
  return {{{h.x, h.y, h.z}, {other.x, other.y, other.z}, {v.x, v.y, v.z}}};
}

/// Columns of the cell and flags of its faces change places as the axes do.
void cycle_edges(io::ImportedPacking& packing, int first) {
  const Mat3 cell = packing.assembly.cell;
  const std::array<bool, 3> periodic = packing.periodic;
  for (int k = 0; k < 3; ++k) {
    const int from = (first + k) % 3;
    for (int row = 0; row < 3; ++row)
      packing.assembly.cell(row, k) = cell(row, from);
    packing.periodic[static_cast<std::size_t>(k)] = periodic[static_cast<std::size_t>(from)];
  }
}

} // namespace

std::optional<Axis> parse_axis(std::string_view text) {
  if (text == "x")
    return Axis::x;
  if (text == "y")
    return Axis::y;
  if (text == "z")
    return Axis::z;
  return text == "principal" ? std::optional(Axis::principal) : std::nullopt;
}

io::ImportedPacking about_axis(io::ImportedPacking packing, Axis axis) {
  if (axis == Axis::z)
    return packing;
  Mat3 rows = axis == Axis::x ? Mat3{{{0, 1, 0}, {0, 0, 1}, {1, 0, 0}}}  // y z x
                              : Mat3{{{0, 0, 1}, {1, 0, 0}, {0, 1, 0}}}; // z x y
  if (axis == Axis::principal)
    rows = principal_axes(packing);
  turn(packing.assembly, rows);
  if (axis != Axis::principal)
    cycle_edges(packing, axis == Axis::x ? 1 : 2);
  std::string text = "axes 1, 2, 3 of the results are ";
  for (int k = 0; k < 3; ++k)
    text += (k > 0 ? ", (" : "(") + short_text(rows(k, 0), 4) + ", " + short_text(rows(k, 1), 4) + ", " +
            short_text(rows(k, 2), 4) + ")";
  packing.notes.push_back({io::Finding::axes_turned, text + " of the files (--axis)"});
  return packing;
}

} // namespace granum::studies

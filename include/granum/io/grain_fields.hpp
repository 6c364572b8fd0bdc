// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include <granum/packing/assembly.hpp>

/// Numbers of each grain for programs that draw packings: ParaView (vtk/paraview.hpp) and OVITO.
/// Checked by tests/io/vtk/test_paraview.cpp
namespace granum::io {

/// Forces of contacts that are known.
enum class KnownForces { none, normal, all };

/// Numbers of all grains under one name.
struct GrainField {
  std::string name;
  std::size_t components = 1; ///< of a grain, one after the other
  std::vector<double> values = {};
  bool whole = false; ///< they are whole numbers
};

/// radius [m]; contacts with other grains [1]; rattler, 1 for a grain that carries no load according to
/// mechanical_coordination with friction; from known forces pressure [Pa], a third of the trace of
/// packing::grain_stresses, and if all are known grain_stress, the nine components of the latter, row by row.
/// \throws   InvalidArgument as require_valid(Assembly)
[[nodiscard]] std::vector<GrainField> grain_fields(const packing::Assembly& assembly,
                                                   KnownForces known = KnownForces::all);

/// Grains as extended XYZ, as OVITO and others read it: a line with their number; one with the cell, its
/// periodic faces, Time [s] and the columns; then a line for each grain: id, pos [m] and the fields. SI, with
/// all digits of every number.
/// \param    periodic   whether the pairs of faces are
/// \param    id   empty, or one number for each grain
/// \param    time   of the state, if it is known [s]
/// \throws   InvalidArgument as require_valid(Assembly), and for another number of ids or values of a field
[[nodiscard]] std::string grains_xyz(const packing::Assembly& assembly, const std::array<bool, 3>& periodic,
                                     std::span<const GrainField> fields, std::span<const long> id = {},
                                     std::optional<double> time = {});

} // namespace granum::io

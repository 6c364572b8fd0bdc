// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>
#include <vector>

#include <granum/packing/assembly.hpp>

namespace granum::packing {

/// Unit normals of all contacts, from i to j, in the order of the contacts.
/// \throws   InvalidArgument for an assembly that require_valid rejects
/// Checked by tests/packing/test_fabric_tensor.cpp
[[nodiscard]] std::vector<Vec3> contact_normals(const Assembly& assembly);

/// F_ij = mean of n_i n_j over all contacts; trace 1.                                          [Satake1982]
/// Assumes   every listed contact counts once, whatever force it carries.
/// \throws   InvalidArgument for an assembly without contacts: the mean has no value
/// Accuracy  rounding.  Checked by tests/packing/test_fabric_tensor.cpp
[[nodiscard]] Mat3 fabric_tensor(const Assembly& assembly);
/// The same of normals alone.
[[nodiscard]] Mat3 fabric_tensor(std::span<const Vec3> normals);

} // namespace granum::packing

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <span>
#include <vector>

#include <granum/packing/assembly.hpp>

namespace granum::analysis {

/// D2min of each grain: how far its neighbours moved, between two states, otherwise than by one uniform
/// deformation. The sum over the neighbours of |b' - J b|^2, with the branches b before and b' after, and J
/// the matrix that makes the sum smallest. [FalkLanger1998]
/// Assumes   the same grains in both, in the same order; two neighbours move by less than half of the cell
///           beside each other.
/// \param    neighbours   pairs i, j with their branches in the state before; contacts, or pairs within some
///                        distance
/// \param    periodic     pairs of faces that are periodic, in both states
/// \return   one for each grain [m2]; 0 with up to three neighbours, which one matrix explains
/// \throws   InvalidArgument for assemblies that require_valid rejects, of different numbers of grains, or a
///           pair of grains that are not there
/// Accuracy  1e-14 of the sum of |b' - b|^2.  Checked by tests/analysis/test_rearrangement.cpp
[[nodiscard]] std::vector<double> d2min(const packing::Assembly& before, const packing::Assembly& after,
                                        std::span<const packing::Contact> neighbours,
                                        const std::array<bool, 3>& periodic = {true, true, true});

} // namespace granum::analysis

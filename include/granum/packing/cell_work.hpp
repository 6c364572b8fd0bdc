// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <granum/contact/normal_law.hpp>
#include <granum/packing/assembly.hpp>

namespace granum::packing {

/// Mean stress by the work of the cell, p = -dU/dV, U the elastic energy of the contacts under a uniform
/// change of size: the independent route to the mean of contact_stress. Tangential forces do no work in it,
/// because they are normal to the branches.
/// Assumes   contacts of the given law, with overlaps as listed; walls are rigid planes, at which a grain
///           has a contact as with its mirror image.
/// \param    law_radius   of the two equal grains that the law is of [m]; pairs of others by
/// contact::of_sizes
/// \return   p [Pa], compression positive; 0 without contacts
/// Accuracy  1e-8 relative: a central difference over 1e-6 of the mean overlap. A contact that opens within
///           that, of flat punches the worst, adds 3e-7 of its share.
///           Checked by tests/packing/test_cell_work.cpp
[[nodiscard]] double pressure_by_cell_work(const Assembly& assembly, const contact::NormalLaw& law,
                                           double law_radius);

} // namespace granum::packing

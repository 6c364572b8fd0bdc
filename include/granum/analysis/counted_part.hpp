// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <granum/contact/normal_law.hpp>
#include <granum/packing/assembly.hpp>

namespace granum::analysis {

/// The part of a packing whose contacts closed forms count, in C_n, z* and the mean force. Where b is the
/// same at every force: all. Of rough grains: those at least 5 % as stiff as a contact of the mean force, as
/// contacts of rough grains begin with almost no force, and many bear next to nothing. That share makes the
/// factors of rung 3 those of smooth grains most nearly (validation/relaxation); the smoother the grains, the
/// fewer are left out.
/// Assumes   the contacts hold their normal forces; the mean that the share refers to is over all contacts.
/// \param    law   of two grains of the mean radius; it stands for all pairs
/// \return   the assembly without the other contacts between grains; those with walls all stay
/// Checked by tests/analysis/test_counted_part.cpp
[[nodiscard]] packing::Assembly counted_part(const packing::Assembly& assembly,
                                             const contact::NormalLaw& law);

} // namespace granum::analysis

// SPDX-License-Identifier: GPL-3.0-or-later
// Contacts between spheres of several materials, which follow Hertz' law, for the closed forms.
#pragma once

#include <span>
#include <vector>

#include <granum/contact/power_law.hpp>
#include <granum/effective/mixture.hpp>
#include <granum/packing/assembly.hpp>

namespace granum::analysis {

/// The mean material of the contacts and their kinds, weighed by the squares of branches, with the mean force
/// of each kind.
/// \param    materials   one for each grain
/// \throws   InvalidArgument as effective::mixed_contacts, and unless there is one material for each grain
[[nodiscard]] effective::MixedContacts mixed_contacts(const packing::Assembly& assembly,
                                                      std::span<const contact::GrainMaterial> materials);

/// k_n of each contact over that of contacts of the mean material, at the same force [1]; nothing without
/// materials.
[[nodiscard]] std::vector<double> relative_stiffnesses(const packing::Assembly& assembly,
                                                       std::span<const contact::GrainMaterial> materials,
                                                       const contact::GrainMaterial& mean);

/// Whether the forces of Hertz contacts have other factors between other types of grains, by more than 2 %:
/// the medians of f/(R^(1/2) d^(3/2)) over at least 5 contacts of a pair of types.
/// \param    type   of each grain, or empty
/// Checked by tests/studies/test_materials.cpp
[[nodiscard]] bool factors_differ(const packing::Assembly& assembly, std::span<const long> type);

} // namespace granum::analysis

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>

#include <granum/contact/normal_law.hpp>
#include <granum/packing/assembly.hpp>
#include <granum/packing/coordination.hpp>
#include <granum/packing/interior.hpp>

/// Parts of a packing that are measured by themselves.
namespace granum::analysis {

/// The part of a packing whose contacts are counted in closed forms, in C_n, z* and the mean force. All
/// contacts if b is the same at every force. For rough grains, only those at least 5 % as stiff as a contact
/// of the mean force, because contacts of rough grains begin with almost no force, and many carry almost
/// none. With this share the factors of rung 3 are closest to those of smooth grains (validation/relaxation);
/// the smoother the grains, the fewer contacts are left out.
/// Assumes   the contacts hold their normal forces; the mean that the share refers to is over all contacts.
/// \param    law   of two grains of the mean radius, used for all pairs
/// \return   the assembly without the other contacts between grains; those with walls all stay
/// Checked by tests/analysis/test_counted_part.cpp
[[nodiscard]] packing::Assembly counted_part(const packing::Assembly& assembly,
                                             const contact::NormalLaw& law);

/// The contact network in numbers.
struct Microstructure {
  double coordination_number = 0;            ///< C_n, all grains
  double mechanical_coordination_number = 0; ///< z*, rattlers left out
  double rattler_fraction = 0;
  double fabric_anisotropy = 0;       ///< a of E(gamma; a)
  double fabric_anisotropy_error = 0; ///< standard error
  double sliding_fraction = 0;        ///< contacts at the Coulomb limit (Contact::sliding)

  bool operator==(const Microstructure&) const = default;
};

/// The part of a packing between walls that keeps a distance from them, where walls do not order the grains.
struct InteriorMeasures {
  std::size_t grains = 0; ///< with their centres inside
  double void_ratio = 0;  ///< of the inside, from the volumes of all grains there, whole or cut [1]
  /// C_n, z* and rattlers: of these grains and all their contacts; a and sliding: of contacts whose middle is
  /// inside.
  Microstructure micro;
  Mat3 stress; ///< contact stress, walls', too, each contact with the share of its branch that is inside [Pa]
};

/// \param    assembly    between six walls that are the faces of its cell
/// \param    mechanical  of the whole assembly, frictional contacts
/// \param    layer       left out at every wall [m]; two diameters are the custom
/// \throws   InvalidArgument if the layers leave too little: no grain, or fewer than 2 contacts
/// Accuracy  the stress is above that of the walls by up to (L/(L - 2R))^2, L the edge of the box: within R
///           of a side wall no contact between grains carries force along it.
/// Checked by tests/triaxial/test_walls.cpp
[[nodiscard]] InteriorMeasures interior_measures(const packing::Assembly& assembly,
                                                 const packing::MechanicalCoordination& mechanical,
                                                 double layer);

/// What a window holds, be it air: without grains the void ratio is 0, as are the numbers of what there is
/// not.
[[nodiscard]] InteriorMeasures part_measures(const packing::Assembly& assembly,
                                             const packing::MechanicalCoordination& mechanical,
                                             const packing::Interior& interior);

/// The same as interior_measures for a window of any packing.
[[nodiscard]] InteriorMeasures interior_measures(const packing::Assembly& assembly,
                                                 const packing::MechanicalCoordination& mechanical,
                                                 const packing::Interior& interior);

} // namespace granum::analysis

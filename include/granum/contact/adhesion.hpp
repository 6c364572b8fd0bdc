// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <granum/contact/solid.hpp>

/// Elastic spheres that attract each other. No contact law of packings: its force is not zero where k_n is.
namespace granum::contact {

/// Theories of where the surfaces attract.
enum class AdhesionModel {
  jkr, ///< within the contact: soft and large spheres, short range [Johnson1971]
  dmt  ///< around the contact, a constant force beside Hertz': stiff and small spheres [Derjaguin1975]
};

struct Adhesion {
  AdhesionModel model = AdhesionModel::jkr;
  /// gamma of each of the two surfaces, half of the work of adhesion, >= 0 [J/m2]; LAMMPS' cohesion
  double surface_energy = 0;

  bool operator==(const Adhesion&) const = default;
};

/// One state of an adhesive contact.
struct AdhesiveContact {
  double radius = 0;    ///< a of the contact area [m]
  double overlap = 0;   ///< full approach; below 0 for a neck of the JKR theory [m]
  double force = 0;     ///< compression positive, with the attraction [N]
  double stiffness = 0; ///< k_n = df/dd [N/m]; of JKR below 0 between pull-off and separation
  /// 2 E* a, k_n of a Hertz contact of this radius; k_t is the same part of it [N/m; Mindlin1949]
  double hertz_stiffness = 0;
};

/// \throws   InvalidArgument for a surface energy that is negative or not finite
void require_valid(const Adhesion& adhesion);

/// The largest tension that a contact carries: 3 pi gamma R* (JKR), 4 pi gamma R* (DMT).
/// \param    pair_radius  2 R* > 0 (grains.hpp) [m]
/// \return   [N], >= 0
/// \throws   InvalidArgument for a surface energy or a radius out of range
/// Checked by tests/contact/test_adhesion.cpp
[[nodiscard]] double pull_off_force(const Adhesion& adhesion, double pair_radius);

/// The stable state at a force: JKR F = 4 E* a^3/(3 R*) - 4 (pi gamma E* a^3)^(1/2), d = a^2/R* - 2 (pi gamma
/// a/E*)^(1/2); DMT F = Hertz' force - 4 pi gamma R*, d = a^2/R*. E* = G_g/(1 - nu_g).
/// Assumes   two spheres of this material; smooth surfaces; loading without hysteresis.
/// \param    force  [N]; a tension above the pull-off force is taken as that, k_n is 0 there
/// \throws   InvalidArgument for a material, surface energy or radius out of range, a force not finite
/// Accuracy  1e-14, of k_n and f of what they are without attraction.
///           Checked by tests/contact/test_adhesion.cpp
[[nodiscard]] AdhesiveContact adhesive_contact_at_force(const Adhesion& adhesion, const GrainMaterial& grain,
                                                        double pair_radius, double force);

/// The same at an overlap, as in a DEM code. All zero where the surfaces have separated: at d < 0 (DMT), or
/// below the least d of the JKR theory, -(3/4) (4 pi^2 gamma^2 R*/E*^2)^(1/3).
/// Accuracy  as above, but beside the least d, where k_n has no bound.
[[nodiscard]] AdhesiveContact adhesive_contact_at_overlap(const Adhesion& adhesion,
                                                          const GrainMaterial& grain, double pair_radius,
                                                          double overlap);

} // namespace granum::contact

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>

/// What grains are made of, and what the surfaces in contact mean for a packing of them.
namespace granum::contact {

/// Isotropic elastic solid of a grain.
struct GrainMaterial {
  double shear_modulus = 0; ///< G_g > 0 [Pa]
  double poisson_ratio = 0; ///< -1 < nu_g <= 0.5

  bool operator==(const GrainMaterial&) const = default;
};

/// Why contacts stiffen as k_n ~ f^b, which decides how packings of them relax.
enum class Stiffening {
  power_law, ///< one b at every force; beyond 1/2 in packings made with another law
  rough      ///< rough spheres in their own packings; b decreases to 1/3 as the roughness is flattened
};

/// What every contact law says of its surfaces. Checked by tests/contact/test_laws.cpp
struct Surface {
  Stiffening stiffening = Stiffening::power_law;
  /// Whether the overlap is 0 where the surfaces touch. Where that is a convention, forces are more accurate
  /// than overlaps, and contacts that are hardly stiff need not count.
  bool begins_at_touch = true;
  /// The force below which the surfaces determine k_n, and above which the solid does [N]; empty where there
  /// is none.
  std::optional<double> transition_force = {};
};

} // namespace granum::contact

// SPDX-License-Identifier: GPL-3.0-or-later
#include <granum/rock_physics/walton_uniaxial.hpp>

#include <cmath>
#include <utility>

#include "strained_contacts.hpp"

namespace granum::rock_physics {

namespace {

Validity checked(const UniaxialPacking& p) {
  sphere::require_grain(p);
  sphere::require_strain("uniaxial_strain", p.uniaxial_strain);
  require_closed("no_slip_fraction", p.no_slip_fraction, 0, 1);
  Validity validity;
  sphere::note_coordination(p, validity);
  sphere::note_contact_radius(std::sqrt(p.uniaxial_strain), validity);
  return validity;
}

} // namespace

effective::Estimate walton_uniaxial(const UniaxialPacking& packing) {
  Validity validity = checked(packing);
  const double M = sphere::contact_modulus(packing, packing.uniaxial_strain);
  const double r = sphere::mean_tangential_ratio(packing);
  return {{.C11 = M * (1 + r) / 16,
           .C33 = M * (2 + r) / 12,
           .C12 = M * (1 - r) / 48,
           .C13 = M * (1 - r) / 24,
           .C44 = M * (4 + 5 * r) / 96},
          std::move(validity)};
}

stress::AxialStress walton_uniaxial_stress(const UniaxialPacking& packing) {
  checked(packing);
  const double strain = packing.uniaxial_strain;
  const double M = sphere::contact_modulus(packing, strain);
  const double r = sphere::mean_tangential_ratio(packing);
  return {.v = M * strain * (2 + r) / 18, .h = M * strain * (1 - r) / 36};
}

} // namespace granum::rock_physics

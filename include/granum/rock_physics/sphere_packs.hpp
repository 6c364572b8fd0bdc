// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <limits>

#include <granum/core/error.hpp>
#include <granum/effective/uniform_field.hpp>
#include <granum/stress/stress.hpp>

/// Common part of the classical closed forms: equal elastic spheres with Hertz contacts, and the moduli
/// that come out.
namespace granum::rock_physics {

/// An isotropic packing of equal spheres under mean pressure, as the classical models see it. A number that
/// is left out stays NaN and is refused by name.
struct SpherePacking {
  static constexpr double unset = std::numeric_limits<double>::quiet_NaN();

  double shear_modulus = unset;       ///< G_g > 0 of the grain [Pa]
  double poisson_ratio = unset;       ///< nu_g of the grain, -1 < nu_g <= 0.5
  double porosity = unset;            ///< pore volume by total volume, in [0, 1)
  double coordination_number = unset; ///< C_n = 2 N_c/N >= 0
  double pressure = unset;            ///< p >= 0, effective, compression positive [Pa]
  double no_slip_fraction = 1;        ///< share of no-slip contacts in [0, 1]: 1 rough, 0 smooth grains
};

/// Moduli of an isotropic packing. Unlike elastic::Isotropic it may contain zeros, for an unloaded packing.
struct IsotropicEstimate {
  double bulk_modulus = 0;  ///< K >= 0 [Pa]
  double shear_modulus = 0; ///< G >= 0 [Pa]
  Validity validity;
};

/// Checks every member of a packing.
/// \throws   InvalidArgument naming the first member that no packing can have
/// \return   notes if C_n > 12, if no contact carries the pressure, or if the contact radius exceeds a tenth
///           of the grain radius, as it does when modulus and pressure are given in different units
/// Checked by tests/rock_physics/test_hertz_mindlin.cpp
Validity require_valid(const SpherePacking& packing);

/// Published relations between coordination number and porosity, all from Murphy's compilation [Murphy1982];
/// the exponential is given in [Zimmer2007].
enum class CoordinationRelation {
  murphy_table,       ///< eleven points from 14.007 at 0.2 to 3.744 at 0.7, linear in between
  murphy_quadratic,   ///< 20 - 34 phi + 14 phi^2
  murphy_exponential, ///< 24 exp(-2.547 phi) - 0.3731
};

/// Porosities that a relation was made for.
struct PorosityRange {
  double low = 0;
  double high = 0;
};
/// \throws   InvalidArgument for a value that is no CoordinationRelation
[[nodiscard]] PorosityRange porosity_range(CoordinationRelation relation);

/// C_n of clean, well sorted grains at a porosity. The relations differ by up to 0.7 from each other: none of
/// them replaces a measured coordination number, and none knows how the packing was made.       [Murphy1982]
/// \param    porosity   in porosity_range(relation), [0.2, 0.7]; no extrapolation
/// \throws   InvalidArgument for a porosity out of that range
/// Accuracy  4 ulp of the relation.  Checked by tests/rock_physics/test_coordination_relations.cpp
[[nodiscard]] double coordination_number(double porosity, CoordinationRelation relation);

/// Moduli of a random packing of equal spheres under uniform strain, without fabric:
/// K = [C_n^2 (1-phi)^2 G_g^2 p/(18 pi^2 (1-nu_g)^2)]^(1/3) and G = K 3 (2 + 3 r)/10, where
/// r = no_slip_fraction 2(1-nu_g)/(2-nu_g) is the mean k_t/k_n. Exactly 0 at p = 0 and at C_n = 0.
///                                                                              [Mindlin1949; Walton1987]
/// Assumes   contacts follow the mean strain: an upper bound, far above the truth in loose packings.
/// \throws   InvalidArgument as require_valid(SpherePacking)
/// Accuracy  8 ulp for p from 1e-300 to 1e12 Pa.  Checked by tests/rock_physics/test_hertz_mindlin.cpp
[[nodiscard]] IsotropicEstimate hertz_mindlin(const SpherePacking& packing);

/// Equal spheres that were bonded over small discs before the pressure came. A number that is left out stays
/// NaN and is refused by name.
struct BondedPacking {
  double shear_modulus = SpherePacking::unset;       ///< G_g > 0 of the grain [Pa]
  double poisson_ratio = SpherePacking::unset;       ///< nu_g of the grain, -1 < nu_g <= 0.5
  double porosity = SpherePacking::unset;            ///< in [0, 1)
  double coordination_number = SpherePacking::unset; ///< C_n = 2 N_c/N >= 0
  double pressure = SpherePacking::unset;            ///< p >= 0, effective, compression positive [Pa]
  double bond_radius_ratio = SpherePacking::unset;   ///< radius of the bonds by that of the grains, in [0, 1)
};

/// Moduli of a bonded packing. Pressure widens the contact discs from b to a = sqrt(b^2 + d^2), d the real
/// root of d^3 + 3/2 b^2 d = 3 pi (1-nu_g) p/(2 C_n (1-phi) G_g), radii by grain radius; only the bond itself
/// resists sliding: K = C_n (1-phi) G_g a/(3 pi (1-nu_g)), G = 0.6 K (1 + 3 (1-nu_g)/(2-nu_g) b/a).
/// Without bonds it is the smooth packing of hertz_mindlin, without pressure a = b; 0 at C_n = 0.
///                                                                                               [Digby1981]
/// Assumes   contacts follow the mean strain.
/// \throws   InvalidArgument naming the first member that no packing can have
/// \return   moduli, with notes if C_n > 12 or if contacts exceed a tenth of the grain radius
/// Accuracy  8 ulp for p from 1e-300 to 1e12 Pa.  Checked by tests/rock_physics/test_digby.cpp
[[nodiscard]] IsotropicEstimate digby(const BondedPacking& packing);

/// Ratio to the uniform-strain shear modulus if pairs of frictionless spheres may deviate from the
/// mean strain: a function of the coordination number alone, 0.30 at k = 6. The published coefficients have
/// two digits; those of the bulk modulus could not be confirmed (as coded in public they lift it above its
/// upper bound) and are left out.                                                             [Jenkins2005]
/// \param    coordination_number   k in [5.1, 11]: below, the expansion turns G negative; above, it passes
///           the upper bound 1
/// \throws   InvalidArgument outside that range
/// Accuracy  1e-13 absolute, of the published polynomials.  Checked by tests/rock_physics/test_jenkins.cpp
[[nodiscard]] double jenkins_shear_factor(double coordination_number);

/// Shear modulus of an isotropic aggregate of identical frictionless spheres with pair fluctuations [Pa]:
/// that of the smooth packing by hertz_mindlin times jenkins_shear_factor.                    [Jenkins2005]
/// \param    packing   with no_slip_fraction = 0, the only contacts that the theory is made for
/// \throws   InvalidArgument as require_valid(SpherePacking) and jenkins_shear_factor, and for
///           no_slip_fraction other than 0
/// Accuracy  as jenkins_shear_factor.  Checked by tests/rock_physics/test_jenkins.cpp
[[nodiscard]] double jenkins_shear_modulus(const SpherePacking& packing);

/// Equal spheres compressed by the mean strain e0 in all directions plus e3 along axis 3. A number that is
/// left out stays NaN and is refused by name.
struct StrainedPacking {
  double shear_modulus = effective::State::unset;       ///< G_g > 0 of the grain [Pa]
  double poisson_ratio = effective::State::unset;       ///< nu_g of the grain, -1 < nu_g <= 0.5
  double porosity = effective::State::unset;            ///< in [0, 1)
  double coordination_number = effective::State::unset; ///< C_n = 2 N_c/N >= 0
  double hydrostatic_strain = effective::State::unset;  ///< e0 in [0, 1), compression positive
  double uniaxial_strain = effective::State::unset;     ///< e3 in [0, 1), compression positive, on top of e0
  double no_slip_fraction = 1;                          ///< share of no-slip contacts in [0, 1]
};

/// In which order the two strains were applied. Tangential forces remember it; the stiffness does not.
enum class StrainPath { hydrostatic_first, uniaxial_first, simultaneous };

/// Transversely isotropic stiffness of the strained packing: contacts follow the mean strain, so that a
/// contact at n3 = x carries k_n ~ sqrt(e0 + e3 x^2). Exactly isotropic at e3 = 0, Walton's uniaxial state at
/// e0 = 0, zero without strain.                                           [NorrisJohnson1997; Walton1987]
/// Assumes   no fabric, no sliding of no-slip contacts, isotropic distribution of contacts.
/// \throws   InvalidArgument naming the first member that no packing can have
/// \return   stiffness, with notes if C_n > 12 or if contacts exceed a tenth of the grain radius
/// Accuracy  relative 4e-15, C12 and C13 of C11, for any e0/e3.
/// Checked by tests/rock_physics/test_norris_johnson.cpp
[[nodiscard]] effective::Estimate norris_johnson(const StrainedPacking& packing);

/// Stresses of the packing at these strains when they were applied along the path; no-slip contacts
/// keep the tangential forces that they gathered on the way.                             [NorrisJohnson1997]
/// Assumes   as norris_johnson; no contact slides on the path.
/// \throws   InvalidArgument as norris_johnson
/// Accuracy  relative 1e-14 of the vertical stress.  Checked by tests/rock_physics/test_norris_johnson.cpp
[[nodiscard]] stress::AxialStress norris_johnson_stress(const StrainedPacking& packing, StrainPath path);

/// Equal spheres compressed along axis 3 only, from the state in which they just touch.
struct UniaxialPacking {
  double shear_modulus = effective::State::unset;       ///< G_g > 0 of the grain [Pa]
  double poisson_ratio = effective::State::unset;       ///< nu_g of the grain, -1 < nu_g <= 0.5
  double porosity = effective::State::unset;            ///< in [0, 1)
  double coordination_number = effective::State::unset; ///< C_n = 2 N_c/N >= 0
  double uniaxial_strain = effective::State::unset;     ///< e3 in [0, 1), compression positive
  double no_slip_fraction = 1; ///< share of no-slip contacts in [0, 1]: 1 rough, 0 smooth
};

/// Stiffness after uniaxial compression. With M = 3 C_n (1-phi) G_g sqrt(e3)/(pi (1-nu_g)) and r the mean
/// k_t/k_n: C11 = M (1+r)/16, C33 = M (2+r)/12, C12 = M (1-r)/48, C13 = M (1-r)/24, C44 = M (4+5r)/96.
/// The C44 that is often reprinted is M (2+7r)/96, against the average over the contacts.        [Walton1987]
/// Assumes   as norris_johnson; this is its limit e0 = 0.
/// \throws   InvalidArgument naming the first member that no packing can have
/// Accuracy  8 ulp.  Checked by tests/rock_physics/test_walton_uniaxial.cpp
[[nodiscard]] effective::Estimate walton_uniaxial(const UniaxialPacking& packing);

/// Its stresses; the ratio horizontal/vertical is nu_g/(4 (3 - 2 nu_g)) for rough grains and 1/4
/// for smooth ones.                                                                           [Walton1987]
/// \throws   InvalidArgument as walton_uniaxial
/// Accuracy  8 ulp.  Checked by tests/rock_physics/test_walton_uniaxial.cpp
[[nodiscard]] stress::AxialStress walton_uniaxial_stress(const UniaxialPacking& packing);

} // namespace granum::rock_physics

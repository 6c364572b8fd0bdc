// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>

#include <granum/core/error.hpp>
#include <granum/effective/state.hpp>
#include <granum/elastic/transverse_isotropic.hpp>

/// Rung 3: the modulus relative to that of uniform strain (rungs 0 to 2), which is too stiff because grains
/// do not follow the mean strain. Calibrated on contact networks of granum's own specimens; for the data, the
/// fit and the errors see validation/relaxation.
namespace granum::effective {

/// A factor and its standard error, from the covariance of the coefficients and the scatter between recipes
/// and between specimens; for K also between DEM codes.
struct RelaxationFactor {
  double value = 0;          ///< modulus over that of uniform strain with k_n at the mean force [1]
  double relative_error = 0; ///< standard error over value [1]; 0 where value is 0
};

struct Relaxation {
  RelaxationFactor shear; ///< of G
  RelaxationFactor bulk;  ///< of K
  Validity validity;
};

/// z* = C_n/(1 - x_0), coordination number without the rattlers.                          [AgnolinRoux2007a]
/// Assumes   rattlers have no contacts. If N_x contacts belong to rattlers (grains with one contact), the
///           true z* is smaller by 2 N_x/(N (1 - x_0)): less than 2 % for specimens at rest.
/// \param    coordination_number   C_n >= 0 over all grains [1]
/// \param    rattler_fraction      x_0 in [0, 1) [1]
/// \throws   InvalidArgument if a value is out of its range
/// Accuracy  1 ulp of the formula.  Checked by tests/effective/test_relaxation.cpp
[[nodiscard]] double mechanical_coordination_number(double coordination_number, double rattler_fraction);

/// z* at which a network of contacts loses its rigidity: 3.954, and 6 for r = 0.
/// [validation/relaxation]
/// \param    tangential_ratio   r = k_t/k_n >= 0 [1]
/// \throws   InvalidArgument if r is out of its range
/// Accuracy  0.010, the standard error of the fit.  Checked by tests/effective/test_relaxation.cpp
[[nodiscard]] double isostatic_coordination_number(double tangential_ratio);

/// Share of the variance of G about its curve, far above the isostatic point, that is common to all packings
/// of one preparation (scatter between recipes, as opposed to within a recipe): 0.45. [validation/relaxation]
/// Assumes   equal grains.
/// Accuracy  not measured; the value is that of the fit.  Checked by tests/effective/test_relaxation.cpp
[[nodiscard]] double scatter_share_of_preparation();

/// Factors of an isotropic packing of equal spheres. With x = z* minus the isostatic point (3.95; 6 for
/// r = 0), the factor of G is 0 at x = 0, grows linearly in x, as sqrt(r) at z* = 6 and small r, and tends to
/// 1 for large z*. The factor of K has a jump at the isostatic point and tends to 1 as well. Both are exactly
/// 0 at that point and below. They depend weakly on the contact law, through the scatter of the contact
/// stiffnesses. Beyond b = 1/2 (power laws) or 1/3 (rough spheres) the factor of G decreases; that of K rises
/// to 1 less the effect of tangential forces at b = 1.
/// Assumes   no sliding contact, rattlers left out of z*; for rough grains also contacts less than 5 % as
///           stiff as one of the mean force, as in analysis::counted_part.
/// \param    mechanical_coordination_number   z* >= 0 [1]
/// \param    tangential_ratio                 r = k_t/k_n >= 0 [1]
/// \param    stiffness_exponent               b of k_n ~ f^b, contact_exponent(state), in [0, 1]
/// \param    stiffening                       the cause of this b, NormalLaw::surface()
/// \return   notes where z* is at or below the isostatic point or beyond the calibrated range (4.1 to 8.7),
///           where r exceeds 1 or lies between 0 and 0.1
/// \throws   InvalidArgument if a value is out of its range
/// Accuracy  of recipes left out of the fit, r >= 0.5: G 3 % rms and 10 % at worst; K 2 % rms, worse for z* <
///           4.3. The stated errors include the scatter of recipes and of specimens: for z* >= 4.3 they cover
///           64 % of G and 74 % of K, twice as large 94 and 99 %. K of loose packings made by other codes is
///           3 to 8 % larger: its stated error also includes a scatter between codes, 18 % over (1 + 2x)^2,
///           derived from packings of LAMMPS and tested on YADE's. Grains compressed from a gas with much
///           friction are up to 6 % stiffer than the curve. At r = 0.1: G 4 %, K 6 %; at r = 0: 8 % both.
///           Beyond b = 1/2, networks of k_n ~ f^b on packings never fitted: G 5, 6 and 8 % rms at b = 2/3,
///           0.8 and 1, K 2 %, and the stated errors grow with it; rough packings never fitted, b from 0.96
///           to 0.35: G 2.5 % and K 1.4 % rms, dense ones of 10 kPa up to 8 %. Rounding: relative 1e-13.
/// Checked by tests/effective/test_relaxation.cpp, validation/relaxation
[[nodiscard]] Relaxation relaxation(double mechanical_coordination_number, double tangential_ratio,
                                    double stiffness_exponent,
                                    contact::Stiffening stiffening = contact::Stiffening::power_law);

/// Standard errors of moduli, over the moduli [1].
struct ModulusErrors {
  double bulk_modulus = 0;
  double G_hh = 0;
  double G_vh = 0;
};

/// A relaxed stiffness, the standard errors of its moduli and its validity notes.
struct RelaxedEstimate {
  elastic::TransverselyIsotropic stiffness;
  ModulusErrors relative_error;
  Validity validity;
};

/// Q of a dense packing whose grains were compressed without friction up to a pressure and with friction from
/// there. Without friction the relative variance of the forces of equal grains is about 0.55; friction holds
/// the grains, so that the increments of all overlaps are even, and the variance fades as the overlap grows:
/// Q = b(1-b)(-0.041 - 0.052 b - 0.26 (w_0/w)^2 - 0.14 (q/p)^2) + 0.18 v, with w the mean overlap, w_0 that
/// at the pressure of preparation, v the relative variance of the lengths of branches and q = stress_v -
/// stress_h. Packings with fewer contacts, z* below 5.8, were not made so: down to 5.5 their Q passes over to
/// that of the fit of rung 3, with its scatter. [validation/relaxation]
/// Assumes   the packing was not reloaded since, w below 1 %.
/// \param    state                  with its coordination number, isotropic or sheared from there; without
///                                 z* as if that were 6
/// \param    preparation_pressure   in (0, p] [Pa]; without it (w_0/w)^2 is taken as 0.1 +- 0.25, as of
///                                 packings that are used at three times that pressure or more
/// \throws   InvalidArgument as mean_contact_force, or for a pressure out of this range
/// Accuracy  0.0023 rms of equal grains of seeds never fitted, 0.03 sqrt(v) of others: as standard_error.
/// Checked by tests/effective/test_unevenness.cpp, validation/relaxation
[[nodiscard]] Unevenness dense_unevenness(const State& state, std::optional<double> preparation_pressure);

/// uniform_strain(state), relaxed. Its volumetric and its deviatoric part are reduced by the two factors.
/// Where fabric or stresses are anisotropic, C33/C11 is then multiplied by exp((1 - h)(A ln(F33/F11) + B b
/// ln(stress_v/stress_h))) at constant volume, h the factor of G, because directions with many or stiff
/// contacts relax less. Far beyond the calibration this could raise K above that of uniform strain, its upper
/// bound: then all constants are scaled down to it, with a note. The result is transversely isotropic,
/// positive definite where uniform_strain is, and exactly isotropic where that is isotropic. Unequal grains,
/// with v = <l^2>/<l>^2 - 1 of state.contacts: the factor of G is that of equal grains at a z* larger by 1.6
/// v/(1 + 2x)^2, the factor of K is divided by 1 + 0.60 v/(z* - 3.46 + 0.96 b), and the errors grow with v: 6
/// % of G for C_u = 2, more beyond. b is contact_exponent(state). Contacts count as rough where b depends on
/// the force. In the exponent above, b is limited to 1/2, because no sheared packings beyond it were
/// available. Overlaps shorten branches by w, the overlap at the mean force over the diameter, which uniform
/// strain leaves out: all moduli are multiplied by (1 - w)^(2-b), w at most 0.1. For power laws of b beyond
/// 1/2, which are given by k_n(f) alone, it is the overlap of b = 1/2 at the same stiffness.
/// Where the unevenness Q of the forces is known, ln G grows by 1.06 Q + 0.028 (1 - h) + b(1-b) (0.26 - 0.076
/// (z* - 5)) and ln K by 0.45 Q + ... likewise, because uneven contacts are softer, and the stated errors are
/// smaller: wholly from z* = 4.4 on, not below 4.2.
/// Grains of several materials (state.pair_shares): G and K are multiplied by effective_stiffness of their
/// contacts, at exchanges of 0.757 4/z* (G) and 0.708 (4/z*)^2 (K); K not below what known forces allow.
/// Where contacts resist rolling (state.rolling), the coupling of G to the tangential stiffness passes over
/// to that of a network without spins, by k_r over k_t/k_n, and a part of the loss of K is taken back; what
/// is gained has an error of its own. Fitted for k_r from 0.003 to 1 and k_t/k_n from 0.1 to 0.92, to
/// packings that were made without it: with it, they may rest with fewer contacts than were seen. Towards
/// k_r = 0 the gain vanishes as k_r^0.69 (G) and k_r^0.39 (K).
/// Assumes   as relaxation and uniform_strain; moduli of a packing at rest, not during shear.
/// \param    state    of the packing; its coordination_number counts all grains
/// \param    mechanical_coordination_number   z* >= 0, see the function of that name [1]
/// \return   zero stiffness where the factor of G is 0 (the packing is not rigid); notes where sqrt(v)
///           exceeds 0.51 (counted in packings with C_u = 4; estimated from sizes with C_u = 3), and where w
///           exceeds 0.055
/// \throws   InvalidArgument as require_valid(State) and relaxation
/// Accuracy  see relaxation; C33/C11 2 % rms for stress ratios from 0.5 to 2.1 and a from 0 to 0.3. Overlaps
///           of 1.1 to 5.6 %, seeds never fitted: G 1.9 %, K 1.1 % rms.
///           Gain by rolling resistance in packings left out of its fit: G 1.4 % rms, 5.0 % at worst, K 0.7
///           and 2.7 %; at k_t/k_n = 0.1 2.2 % rms of G, 2.0 % of K.
/// Checked by tests/effective/test_relaxation.cpp, tests/effective/test_rolling.cpp,
/// tests/effective/test_mixture.cpp, validation/relaxation, validation/mixtures
[[nodiscard]] RelaxedEstimate relaxed(const State& state, double mechanical_coordination_number);

} // namespace granum::effective

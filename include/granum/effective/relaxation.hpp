// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <granum/core/validity.hpp>
#include <granum/effective/state.hpp>
#include <granum/elastic/transverse_isotropic.hpp>

/// Rung 3: by what factor uniform strain (rungs 0 to 2) is too stiff, because grains do not follow the mean
/// strain. Calibrated on contact networks of granum's own specimens; validation/relaxation holds the data,
/// the fit and the errors.
namespace granum::effective {

/// A factor and its standard error: covariance of the coefficients, scatter of recipes and of specimens, for
/// K of codes too.
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
/// Assumes   rattlers carry no contacts. Those that do, grains with one contact, make the true z* smaller by
///           2 N_x/(N (1 - x_0)), N_x their contacts: less than 2 % for specimens at rest.
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

/// Of the variance of G about its curve, far above the isostatic point, what all packings of one preparation
/// share: how recipes scatter, beside the packings of one. 0.45. [validation/relaxation]
/// Assumes   equal grains.
/// Accuracy  not measured: the share that the fit says.  Checked by tests/effective/test_relaxation.cpp
[[nodiscard]] double scatter_share_of_preparation();

/// How contacts come to stiffen as f^b. Up to b = 1/3 the factors do not ask.
enum class Stiffening {
  power_law, ///< one b at every force; beyond 1/2 on packings that something else made
  rough      ///< of rough spheres in their own packings, whose b falls to 1/3 as roughness is pressed flat
};

/// That of a law: rough where it has no b of its own.
[[nodiscard]] Stiffening stiffening_of(const contact::NormalLaw& law);

/// Factors of an isotropic packing of equal spheres. With x = z* minus the isostatic point (3.95; 6 for
/// r = 0), G's is 0 at x = 0, grows as x, as sqrt(r) at z* = 6 and small r, and tends to 1 for large z*. K's
/// has a jump at the isostatic point and tends to 1 as well. Both are exactly 0 at that point and below, and
/// depend weakly on the contact law, as the scatter of its stiffnesses does. Those of power laws go on from b
/// = 1/2, those of rough spheres from smooth ones: G's falls, K's rises to what tangential forces leave of it
/// at b = 1.
/// Assumes   overlaps below 1 % of the diameter, no sliding contact, rattlers left out of z*; of rough grains
///           contacts less than 5 % as stiff as one of the mean force as well, as analysis::counted_part
///           does.
/// \param    mechanical_coordination_number   z* >= 0 [1]
/// \param    tangential_ratio                 r = k_t/k_n >= 0 [1]
/// \param    stiffness_exponent               b of k_n ~ f^b, contact_exponent(state), in [0, 1]
/// \param    stiffening                       how the contacts come to it
/// \return   notes where z* is at or below the isostatic point or beyond the calibrated range (4.1 to 8.7),
///           where r exceeds 1 or lies between 0 and 0.1
/// \throws   InvalidArgument if a value is out of its range
/// Accuracy  of recipes left out of the fit, r >= 0.5: G 3 % rms and 10 % at worst; K 2 % rms, worse for
///           z* < 4.3. The stated errors hold the scatter of recipes and of specimens: for z* >= 4.3 they
///           cover 64 % of G and 74 % of K, twice as large 94 and 99 %. K of loose packings that other codes
///           made is 3 to 8 % larger: its stated error holds a scatter between codes besides, 18 % over
///           (1 + 2x)^2, taken from packings of LAMMPS and tested on YADE's. Grains compressed from a gas
///           with much friction are up to 6 % stiffer than the curve. At r = 0.1: G 4 %, K 6 %; at r = 0:
///           8 % both. Beyond b = 1/2, networks of k_n ~ f^b on packings never fitted: G 5, 6 and 8 % rms at
///           b = 2/3, 0.8 and 1, K 2 %, and the stated errors grow with it; rough packings never fitted, b
///           from 0.96 to 0.35: G 2.5 % and K 1.4 % rms, dense ones of 10 kPa up to 8 %. Rounding: relative
///           1e-13.
/// Checked by tests/effective/test_relaxation.cpp, validation/relaxation
[[nodiscard]] Relaxation relaxation(double mechanical_coordination_number, double tangential_ratio,
                                    double stiffness_exponent, Stiffening stiffening = Stiffening::power_law);

/// Standard errors of moduli, over the moduli [1].
struct ModulusErrors {
  double bulk_modulus = 0;
  double G_hh = 0;
  double G_vh = 0;
};

/// A relaxed stiffness, the standard errors of its moduli and the remarks that go with it.
struct RelaxedEstimate {
  elastic::TransverselyIsotropic stiffness;
  ModulusErrors relative_error;
  Validity validity;
};

/// uniform_strain(state), relaxed: its volumetric and its deviatoric part by the two factors; then, where
/// fabric or stresses are anisotropic, C33/C11 by exp((1 - h)(A ln(F33/F11) + B b ln(stress_v/stress_h))) at
/// constant volume, h the factor of G, because directions of many or stiff contacts relax less. Far beyond
/// the calibration that could raise K above that of uniform strain, its upper bound: then all constants are
/// scaled down to it, with a note. Transversely
/// isotropic, positive definite where uniform_strain is, and exactly isotropic where that is isotropic.
/// Unequal grains have G's factor of equal ones of a larger z*, by 1.6 v/(1 + 2x)^2 with v = <l^2>/<l>^2 - 1
/// of state.contacts, K's over 1 + 0.60 v/(z* - 3.46 + 0.96 b), and errors that grow with v: 6 % of G
/// for C_u = 2, more beyond. b is contact_exponent(state), and contacts are rough where their law
/// has no b of its own. The exponent of the stretch has b up to
/// 1/2 alone, as no sheared packings beyond are known.
/// Assumes   as relaxation and uniform_strain; moduli of the packing at rest, not of one that is sheared on.
/// \param    state    of the packing; its coordination_number counts all grains
/// \param    mechanical_coordination_number   z* >= 0, see the function of that name [1]
/// \return   a zero stiffness where G's factor is 0, as a packing that is not rigid has none; a note where
///           sqrt(v) exceeds 0.51, beyond C_u of about 4
/// \throws   InvalidArgument as require_valid(State) and relaxation
/// Accuracy  see relaxation; C33/C11 2 % rms for stress ratios from 0.5 to 2.1 and a from 0 to 0.3.
/// Checked by tests/effective/test_relaxation.cpp, validation/relaxation
[[nodiscard]] RelaxedEstimate relaxed(const State& state, double mechanical_coordination_number);

} // namespace granum::effective

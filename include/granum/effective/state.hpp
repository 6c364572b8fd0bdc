// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <limits>
#include <optional>
#include <vector>

#include <granum/contact/normal_law.hpp>
#include <granum/core/error.hpp>
#include <granum/effective/mixture.hpp>
#include <granum/sizes/contact_means.hpp>

/// Effective stiffness of a packing from the average over its contacts.
namespace granum::effective {

/// How unevenly the contacts of a packing share its forces. Its number Q is ln of K under uniform strain of
/// the contacts as they are over that of the closed form, in which all contacts carry the mean force: 0 where
/// forces are equal or k_n does not depend on them, usually from -0.25 to 0, for grains of many sizes above 0
/// too. Of equal grains it is ln(<f^b>/<f>^b).
struct Unevenness {
  double value = 0;          ///< Q [1]
  double standard_error = 0; ///< of Q
  double by_pressure = 0;    ///< dQ/d ln p of the same contacts, for exponents [1]
};

/// The state of a packing of nearly spherical grains. By default the fabric has no preferred direction and
/// the grains are equal. Contacts may be unknown: a closed form that needs them refuses a state without them.
/// Any other number that is left out stays NaN and is refused by name. For unequal grains the law is that of
/// the mean pair, for spheres contact::PowerLaw::sphere(grain, radius * contacts.pair_radius).
struct State {
  static constexpr double unset = std::numeric_limits<double>::quiet_NaN();

  contact::NormalLaw law;          ///< normal contact of two grains, of the mean pair
  double tangential_ratio = unset; ///< k_t/k_n in [0, 100], e.g. contact::mindlin_stiffness_ratio(nu_g)
  double radius = unset;           ///< R > 0 of a grain, or the radius that `contacts` refer to [m]
  double void_ratio = unset;       ///< e > 0
  std::optional<double> coordination_number = std::nullopt; ///< C_n = 2 N_c/N over all grains, >= 0
  std::optional<double> mechanical_coordination_number = std::nullopt; ///< z*, without rattlers, >= 0
  double fabric_anisotropy = 0; ///< a of E(gamma; a), in (-7/3, 7/5), a density in [-1, 1]
  double stress_v = unset;      ///< vertical stress, compression positive [Pa]
  double stress_h = unset;      ///< horizontal stress in both directions, compression positive [Pa]
  sizes::ContactMeans contacts =
      {}; ///< means over contacts of unequal grains, relative to those of equal ones
  /// Where it is known, from forces (packing::force_unevenness) or from the preparation (dense_unevenness);
  /// without it rung 3 is that of packings as uneven as those of its fit.
  std::optional<Unevenness> unevenness = std::nullopt;
  /// Of grains of several materials (mixed_contacts), whose mean the law is; empty where there is one.
  std::vector<PairShare> pair_shares = {};
  /// k_r in [0, 1]: rolling stiffness of a contact (moment over angle) over k_n R*^2, R* = R_i R_j/(R_i +
  /// R_j), the same for all contacts at any force [1]. Rung 3 uses it. Under uniform strain nothing rolls.
  double rolling = 0;

  /// p = (stress_v + 2 stress_h)/3 [Pa].
  [[nodiscard]] double mean_stress() const { return (stress_v + 2 * stress_h) / 3; }
};

/// Checks every member of a state. Contacts may be unknown; prefactor, forces and stiffnesses of such a state
/// are refused.
/// Stresses are both zero or both positive: grains without bonds carry no tension, and a zero stress across
/// loaded contacts would need unlimited friction. Forces of the static field may differ by a factor of 1e4.
/// k_t/k_n is at most 4/3 in elastic grains (nu_g = -1); beyond 100 the bulk modulus would be lost in the
/// rounding of the five constants. C_n = 0 is treated as a limit: forces grow as 1/C_n, k_n no faster than
/// C_n^(-1/2), so that every modulus tends to 0 with the number of contacts.
/// \throws   InvalidArgument naming the first member that is impossible, or "force" where the contact force
///           exceeds the range of a double
/// \return   notes if |a| > 1, if C_n = 0 (nothing carries the stress), if C_n > 12 (equal spheres touch at
///           most 12), or if the largest contact radius exceeds a tenth of the grain radius, where contact
///           laws of the half-space are no longer valid
/// Checked by tests/effective/test_state.cpp
Validity require_valid(const State& state);

/// P = N_c <l^2>/V, for equal grains 3 C_n/(2 pi R (1+e)), the factor of every modulus [1/m].
/// [Walton1987]
/// Assumes   spheres that touch, branch length l = R_i + R_j.
/// \throws   InvalidArgument as require_valid
/// Accuracy  4 ulp.  Checked by tests/effective/test_state.cpp
[[nodiscard]] double prefactor(const State& state);

/// Mean normal contact force 3 p V/(N_c <l>), for equal grains 4 pi R^2 (1+e) p/C_n, at the mean stress
/// p = (stress_v + 2 stress_h)/3 [N]. Exact for equal spheres in static equilibrium and any fabric. In
/// unequal spheres longer branches carry more force: the true mean is smaller, by 4 to 6 % for C_u of 1.5 and
/// 1.7.
/// \throws   InvalidArgument as require_valid, and if C_n = 0
/// Accuracy  6 ulp.  Checked by tests/effective/test_state.cpp
[[nodiscard]] double mean_contact_force(const State& state);

/// b = d ln k_n/d ln f of the state's law at the mean contact force (laws of one b have it at any force);
/// without contacts, b at zero force.
/// \throws   InvalidArgument as require_valid
/// Accuracy  that of the law.  Checked by tests/effective/test_state.cpp
[[nodiscard]] double contact_exponent(const State& state);

/// Contact forces f = V/(N_c <l>) stress F^-1 n of the static hypothesis: in the plane of axis 3 and the
/// normal n, f = (horizontal sin gamma, vertical cos gamma).
struct StaticForceField {
  double horizontal = 0; ///< V/(N_c <l>) stress_h/F11, normal force of a horizontal contact normal [N]
  double vertical = 0;   ///< V/(N_c <l>) stress_v/F33, normal force of a vertical contact normal [N]

  /// f_n at n3 = cos gamma [N]; n3 in [-1, 1], not checked.
  [[nodiscard]] double normal_force(double n3) const {
    return horizontal * (1 - n3) * (1 + n3) + vertical * n3 * n3;
  }
  /// f_t along growing gamma at n3 = cos gamma >= 0, (horizontal - vertical) sin gamma cos gamma [N].
  [[nodiscard]] double tangential_force(double n3) const;
  /// Largest |f_t|/f_n over all directions, the friction coefficient required by the field:
  /// |vertical - horizontal|/(2 sqrt(vertical horizontal)), 0 without load.
  [[nodiscard]] double mobilised_friction() const;
};

/// Forces of the static hypothesis at this state; their mean normal part is mean_contact_force. They
/// balance the stress on average, but not on each grain.                                      [ChangLiao1994]
/// \throws   InvalidArgument as require_valid, and if C_n = 0
/// Accuracy  8 ulp.  Checked by tests/effective/test_state.cpp
[[nodiscard]] StaticForceField static_force_field(const State& state);

/// Mean stress p* at which X = u0 k_H/f is 1 at the mean force of rough spheres: below it roughness
/// determines the contact stiffness, above it Hertz' law. For equal spheres
/// sqrt(3)/(4 pi) C_n/(1+e) G/(1-nu) (u0/R)^(3/2),
/// Goddard's scaling with its constant.                                                        [Goddard1990]
/// Assumes   constant C_n and e; the stresses of the state are not used.
/// \return   p* [Pa]; empty for any other contact law
/// \throws   InvalidArgument as require_valid(State), and if C_n = 0
/// Accuracy  relative 1e-14.  Checked by tests/effective/test_transition_pressure.cpp
[[nodiscard]] std::optional<double> transition_pressure(const State& state);

/// p* of rough spheres whose moduli grow as p^s at the given mean stress, with a constant number of contacts:
/// solves b(X) = s, where X decreases as p^(-2/3).
/// \param    exponent      s in (1/3, 1) [1]
/// \param    mean_stress   p > 0 [Pa]
/// \return   [Pa]
/// \throws   InvalidArgument outside of these ranges, and for s within 1e-9 of an end
/// Accuracy  relative 1e-9.  Checked by tests/effective/test_transition_pressure.cpp
[[nodiscard]] double transition_pressure_of(double exponent, double mean_stress);

/// Roughness u0 of the grains of a packing with a known p*.
/// \param    state   its radius, grain material, C_n and e are used
/// \param    transition_pressure   p* > 0 [Pa]
/// \return   [m]
/// \throws   InvalidArgument as transition_pressure(State), and for p* out of range
/// Accuracy  relative 1e-14.  Checked by tests/effective/test_transition_pressure.cpp
[[nodiscard]] double roughness_of(State state, double transition_pressure);

} // namespace granum::effective

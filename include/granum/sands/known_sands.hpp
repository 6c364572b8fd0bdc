// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <string_view>

#include <granum/core/error.hpp>

/// Sands that are often used in laboratories.
namespace granum::sands {

/// Fit to the tests of one sand: G = level F^power at 100 kPa, F = (2.17-e)^2/(1+e), and its exponent.
struct SandTests {
  double level = 0;      ///< [Pa]
  double power = 0;      ///< of F [1]
  double exponent = 0;   ///< s of G ~ p^s [1]
  std::size_t count = 0; ///< of tests
  double void_ratio_low = 0, void_ratio_high = 0;
  double stress_low = 0, stress_high = 0; ///< [Pa]

  bool operator==(const SandTests&) const = default;
};

/// Properties of a sand, as far as its sources state them. Batches of one name differ.
struct KnownSand {
  const char* key;                               ///< on a command line
  const char* name;                              ///< for people
  const char* source;                            ///< of what follows, entries of validation/references.bib
  const char* mineral;                           ///< key of contact::mineral
  std::optional<double> d50 = {};                ///< [m]
  std::optional<double> uniformity = {};         ///< C_u [1]
  std::optional<double> least_void_ratio = {};   ///< e_min [1]
  std::optional<double> largest_void_ratio = {}; ///< e_max [1]
  std::optional<SandTests> tests = {};           ///< of resonant columns and bender elements [Lo2021]
  const char* remark = "";                       ///< on the tests
};

/// Sands of many laboratories, and the gradings of one: "karlsruhe-0.6-3" has d50 = 0.6 mm and C_u = 3. All
/// tests are taken from [Lo2021], whose table names no sands: they are identified by their limits of the void
/// ratio. [CubrinovskiIshihara2002; YangSze2011; CareyStoneKutter2020; Azeiteiro2017; Fioravante2015]
/// [Arulmoli1992; Tsomokos2010; WichtmannTriantafyllidis2009]
[[nodiscard]] std::span<const KnownSand> known_sands();
/// The one of that key.
/// \throws   InvalidArgument for an unknown key; the message lists the known ones
/// Checked by tests/sands/test_known_sands.cpp
[[nodiscard]] const KnownSand& known_sand(std::string_view key);

/// Refuses limits that no soil has: those of well graded gravels differ by 0.15, those of glass beads also.
/// \throws   InvalidArgument unless e_min >= 0.1, e_max <= 5 and e_max - e_min >= 0.05
/// Checked by tests/sands/test_known_sands.cpp
void require_void_ratio_limits(double least, double largest);

/// e of a relative density D_r, e_max - D_r (e_max - e_min).
/// \param    relative_density     D_r, in [0, 1.2]; above 1 if the sand is denser than at e_min [1]
/// \throws   InvalidArgument outside of this range, and as require_void_ratio_limits
/// Accuracy  2 ulp of e_max.  Checked by tests/sands/test_known_sands.cpp
[[nodiscard]] double void_ratio_of_relative_density(double relative_density, double least_void_ratio,
                                                    double largest_void_ratio);

/// \file
/// Published laws of the small-strain shear modulus of sands under isotropic stress, measured in
/// laboratories, for comparison with results for spheres.

/// The properties of a sand used by those laws.
struct SandState {
  double void_ratio = 0;   ///< e > 0 [1]
  double mean_stress = 0;  ///< p > 0 [Pa]
  double uniformity = 1.5; ///< C_u = d60/d10 >= 1 [1]; used by four laws
  double d50 = 0.4e-3;     ///< > 0, < 1 [m]; used by two laws, with an effect of some per cent
};

/// Range of the tests of a law. Outside of it the law is evaluated with a note.
struct TestedRange {
  double void_ratio_low = 0, void_ratio_high = 0;
  double stress_low = 0, stress_high = 0; ///< [Pa]
  double uniformity_high = 0;             ///< C_u from 1 to this; 0: the law does not use C_u
};

/// Agreement of a law with 166 tests of 23 clean sands, each sand with the same weight [Lo2021]. The 623
/// tests of that table which come from one laboratory, and on which one of the laws is based, are left out.
/// validation/sands repeats the comparison with a table of the user.
struct LawRecord {
  double bias = 1;      ///< law over measured, geometric mean [1]
  double rms_log10 = 0; ///< root mean square of log10 of law over measured [1]
};

/// A published law. Its constants are taken from public codes and bibliographies, its range from citations of
/// its tests; they were not checked against the printed pages.
struct MeasuredLaw {
  const char* key;     ///< on a command line
  const char* sand;    ///< tested material
  const char* source;  ///< entry of validation/references.bib
  const char* formula; ///< in kPa, as in its source
  TestedRange tested;
  LawRecord record;
  double (*modulus)(const SandState& sand) = nullptr; ///< unchecked [Pa]; call shear_modulus
};

/// All of them, in the order of their years. [HardinRichart1963; Kokusho1980; Jamiolkowski1991]
/// [Menq2003; WichtmannTriantafyllidis2009; OztoprakBolton2013; WangStokoe2022]
/// Clean laboratory sands scatter about the better laws by 0.06 to 0.09 in log10 G (LawRecord); all
/// materials, including gravel, carbonate sand and natural ground, by a factor of 1.6.
[[nodiscard]] std::span<const MeasuredLaw> measured_laws();
/// The law of that key.
/// \throws   InvalidArgument for an unknown key; the message lists the known ones
[[nodiscard]] const MeasuredLaw& measured_law(std::string_view key);

/// (zero - e)^2/(1 + e), the void-ratio function of Hardin and Richart.            [HardinRichart1963]
/// \param    zero   void ratio at which it vanishes [1]
/// \throws   InvalidArgument unless 0 < void_ratio < zero
/// Accuracy  4 ulp.  Checked by tests/hardin/test_equation.cpp
[[nodiscard]] double hardin_richart_factor(double zero, double void_ratio);

/// A modulus and its validity notes.
struct SandModulus {
  double shear_modulus = 0; ///< G [Pa]
  Validity validity;
};

/// The shear modulus of a sand according to a law.
/// \return   notes where void ratio, stress or C_u lie outside of the law's tests
/// \throws   InvalidArgument if a member of the sand is out of its range, or if the void ratio exceeds the
///           value at which the law is zero
/// Accuracy  formula: relative 1e-15; Toyoura sand at 98 kPa within 1.5 % of the cited moduli.
///           Checked by tests/sands/test_measured_sands.cpp
[[nodiscard]] SandModulus shear_modulus(const MeasuredLaw& law, const SandState& sand);

} // namespace granum::sands

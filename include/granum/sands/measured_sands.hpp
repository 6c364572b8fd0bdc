// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <span>
#include <string_view>

#include <granum/core/error.hpp>

/// Published laws of the small-strain shear modulus of sands under isotropic stress, measured in
/// laboratories, for comparison with results for spheres.
namespace granum::sands {

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

/// Agreement of a law with 789 tests of 38 clean sands, C_u 1.3 to 8, e 0.40 to 0.93, p 25 to 500 kPa
/// [Lo2021], each sand with the same weight. validation/sands repeats the comparison with a table of the
/// user.
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
/// Accuracy  4 ulp.  Checked by tests/hardin/test_void_ratio_function.cpp
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

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <span>
#include <string_view>

#include <granum/core/validity.hpp>

/// What laboratories measured: published laws of the small-strain shear modulus of sands under isotropic
/// stress, to set beside an answer about spheres.
namespace granum::sands {

/// A sand as those laws know one.
struct SandState {
  double void_ratio = 0;   ///< e > 0 [1]
  double mean_stress = 0;  ///< p > 0 [Pa]
  double uniformity = 1.5; ///< C_u = d60/d10 >= 1 [1]; four laws ask for it
  double d50 = 0.4e-3;     ///< > 0 [m]; two laws ask for it, and change by some per cent with it
};

/// Where the tests behind a law lie. Beyond, a law still answers, with a note.
struct TestedRange {
  double void_ratio_low = 0, void_ratio_high = 0;
  double stress_low = 0, stress_high = 0; ///< [Pa]
  double uniformity_high = 0;             ///< C_u from 1 to this; 0: the law does not ask for it
};

/// How a law did on 789 tests of 38 clean sands, C_u 1.3 to 8, e 0.40 to 0.93, p 25 to 500 kPa [Lo2021], each
/// sand with the same weight. validation/sands repeats it on a table that a user has.
struct LawRecord {
  double bias = 1;      ///< law over measured, geometric mean [1]
  double rms_log10 = 0; ///< root mean square of log10 of law over measured [1]
};

/// A published law. Its constants are those that public codes and bibliographies carry, its range that of its
/// tests as it is usually cited; nobody checked them against the printed pages.
struct MeasuredLaw {
  const char* key;     ///< on a command line
  const char* sand;    ///< what was tested
  const char* source;  ///< entry of validation/references.bib
  const char* formula; ///< in kPa, as its source has it
  TestedRange tested;
  LawRecord record;
  double (*modulus)(const SandState& sand) = nullptr; ///< unchecked [Pa]; call shear_modulus
};

/// All of them, in the order of their years. [HardinRichart1963; Kokusho1980; Jamiolkowski1991]
/// [Menq2003; WichtmannTriantafyllidis2009; OztoprakBolton2013; WangStokoe2022]
/// Clean laboratory sands scatter about the better ones by 0.06 to 0.09 in log10 G (LawRecord); all materials
/// together, gravel, carbonate sand and natural ground among them, by a factor of 1.6.
[[nodiscard]] std::span<const MeasuredLaw> measured_laws();
/// The law of that key.
/// \throws   InvalidArgument for an unknown key; the text lists the known ones
[[nodiscard]] const MeasuredLaw& measured_law(std::string_view key);

/// (zero - e)^2/(1 + e), the void-ratio function of Hardin and Richart.            [HardinRichart1963]
/// \param    zero   void ratio at which it vanishes [1]
/// \throws   InvalidArgument unless 0 < void_ratio < zero
/// Accuracy  4 ulp.  Checked by tests/hardin/test_void_ratio_function.cpp
[[nodiscard]] double hardin_richart_factor(double zero, double void_ratio);

/// A modulus and the remarks that go with it.
struct SandModulus {
  double shear_modulus = 0; ///< G [Pa]
  Validity validity;
};

/// What a law says of a sand.
/// \return   notes where void ratio, stress or C_u lie outside of the law's tests
/// \throws   InvalidArgument if a member of the sand is out of its range, or the void ratio beyond that at
///           which the law reaches zero
/// Accuracy  of the formula 1e-15 relative; Toyoura sand at 98 kPa within 1.5 % of the moduli that are cited.
///           Checked by tests/sands/test_measured_sands.cpp
[[nodiscard]] SandModulus shear_modulus(const MeasuredLaw& law, const SandState& sand);

} // namespace granum::sands

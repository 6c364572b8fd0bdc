// SPDX-License-Identifier: GPL-3.0-or-later
// Everything that src/effective/relaxation_coefficients.hpp holds, and how it follows from the recorded
// networks.
#pragma once

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "../constants.hpp"
#include "effective/relaxation_coefficients.hpp"
#include "stiff_contacts.hpp"
#include "uneven_fits.hpp"

namespace relaxation {

// ---- closing gaps ----

struct ClosingGaps {
  Fit<4> growth;   ///< z_0, A, q, s
  Fit<2> rattlers; ///< c, k
  double scatter = 0;
};

/// z* = z_0 + A (1 - s b) w^q with w the relative overlap; x_0 = c exp(-k (z* - 4)).
inline ClosingGaps fit_closing_gaps(const std::vector<Packing>& packings, const std::string& preparation) {
  std::vector<Observation<4>> growth;
  std::vector<Observation<2>> rattlers;
  for (const Packing& p : packings)
    if (p.preparation == preparation && p.relative_overlap < largest_overlap) {
      growth.push_back(
          {[log_overlap = std::log(p.relative_overlap), b = p.exponent()](const Numbers<Dual<4>, 4>& c) {
             return c[0] + c[1] * (1.0 - c[3] * b) * exp(c[2] * log_overlap);
           },
           p.mechanical_coordination, 1, p.specimen});
      rattlers.push_back({[above = p.mechanical_coordination - 4](const Numbers<Dual<2>, 2>& c) {
                            return c[0] * exp(-c[1] * above);
                          },
                          p.rattler_fraction, 1, p.specimen});
    }
  ClosingGaps gaps{.growth = least_squares<4>(growth, {preparation == "dense" ? 6.0 : 4.0, 20, 0.5, 0.1}),
                   .rattlers = least_squares<2>(std::move(rattlers), {0.1, 1})};
  Errors left;
  for (const Observation<4>& row : growth)
    left.add(row.model(gaps.growth.duals()).value - row.target);
  gaps.scatter = left.rms();
  return gaps;
}

// ---- all fits ----

struct Result {
  EqualFit equal;
  StretchFit stretch = {};
  double stretch_scatter = 0;                     ///< what is left of ln C33/C11, over ln of the stretch
  double shear_by_stress = 0, bulk_by_stress = 0; ///< under unequal stresses, over |ln(stress_v/stress_h)|
  ClosingGaps dense = {}, loose = {};
  SizeEffect sizes = {};
  double bulk_codes = 0; ///< scatter of K between codes, over kernel::looseness
  Beyond beyond = {};
  KnownForces shear_known = {}, bulk_known = {};
  DenseFit dense_forces = {};
};

/// How far sheared states are from the formula: C33/C11 by the stretch, G and K by the stress ratio, beyond
/// the scatter of isotropic states.
inline void fit_sheared_scatter(const std::vector<Packing>& packings, Result& result) {
  double left = 0, stretch = 0, G_left = 0, K_left = 0, stress = 0;
  for (const Packing& p : packings)
    for (const Network& n : p.networks)
      if (!p.isotropic() && n.ratio >= lowest_usual_ratio) {
        const RelaxedState r = relaxed_state(p, n, result.equal, result.stretch.coefficients);
        const TransverselyIsotropic relaxed{
            .C11 = r.c.C11, .C33 = r.c.C33, .C12 = r.c.C12, .C13 = r.c.C13, .C44 = r.c.C44};
        const TransverselyIsotropic& measured = n.stiffness;
        left += std::pow(std::log(r.c.C33 / r.c.C11 / (measured.C33 / measured.C11)), 2);
        stretch += r.log_stretch * r.log_stretch;
        G_left +=
            std::pow(std::log(isotropic_shear_modulus(relaxed) / isotropic_shear_modulus(measured)), 2) -
            result.equal.shear.scatter.squared_base();
        K_left += std::pow(std::log(relaxed.bulk_modulus() / measured.bulk_modulus()), 2) -
                  result.equal.bulk.scatter.squared_base();
        stress += r.log_stress * r.log_stress;
      }
  result.stretch_scatter = std::sqrt(left / stretch);
  result.shear_by_stress = std::sqrt(std::max(0.0, G_left / stress));
  result.bulk_by_stress = std::sqrt(std::max(0.0, K_left / stress));
}

/// The files that the fits are made from.
struct Records {
  std::vector<Packing> packings; ///< of equal grains
  std::vector<Packing> unfitted; ///< of the shape that is left out
  std::vector<Packing> unequal;  ///< of unequal grains, and of equal ones made as they were
  std::vector<Packing> gradations, codes;
  std::vector<StiffNetwork> stiff; ///< of b up to 1

  /// \param    files   states.csv unequal.csv gradations.csv codes.csv exponents.csv rough.csv
  explicit Records(const std::vector<std::string>& files)
      : unequal(read_packings(files[1])), gradations(read_gradations(files[2])),
        codes(read_packings(files[3])), stiff(read_stiff_networks(files[4], false)) {
    for (const Packing& p : read_packings(files[0]))
      (p.contact == unfitted_contact ? unfitted : packings).push_back(p);
    std::ranges::move(read_stiff_networks(files[5], true), std::back_inserter(stiff));
  }
};

inline Result fit_everything(const Records& r) {
  Result result{.equal = fit_equal(r.packings, everything),
                .dense = fit_closing_gaps(r.packings, "dense"),
                .loose = fit_closing_gaps(r.packings, "loose")};
  const EqualFit& equal = result.equal;
  result.stretch = fit_stretch(r.packings, equal);
  fit_sheared_scatter(r.packings, result);
  result.sizes = fit_size_effect(r.unequal, r.gradations, equal, everything);
  result.shear_known = fit_known_forces(Of::shear, r.packings, r.unequal, equal, result.sizes, everything);
  result.bulk_known = fit_known_forces(Of::bulk, r.packings, r.unequal, equal, result.sizes, everything);
  result.dense_forces = fit_dense(r.packings, r.unequal);
  result.bulk_codes = fit_code_scatter(r.codes, equal, result.sizes);
  result.beyond = fit_beyond(r.stiff, equal, result.bulk_codes);
  return result;
}

// ---- the header ----

inline constexpr const char* header_intro =
    R"(// Written by `relaxation_fit coefficients` in validation/relaxation, whose README says from which files; the
// test "validation: relaxation" fits them again and compares. Not to be edited by hand.
// clang-format off
#pragma once

#include <array>

namespace granum::effective::kernel {

template <class T>
using ShearCoefficients = std::array<T, 8>;
template <class T>
using BulkCoefficients = std::array<T, 6>;
template <class T>
using StretchCoefficients = std::array<T, 2>;
template <class T>
using UnevennessCoefficients = std::array<T, 7>;
template <class T>
using DenseUnevenness = std::array<T, 5>;

)";

/// Coefficients and their covariances: entries near 0 have no digits of their own, they are compared with the
/// errors.
template <int n, std::size_t m>
void add_fit(std::vector<Constant>& all, const std::string& name, const Fit<n>& fit,
             const Numbers<double, n>& recorded, const double (&recorded_covariance)[m][m]) {
  const std::string size = std::to_string(n);
  all.push_back({"inline constexpr std::array<double, " + size + "> " + name + "_coefficients{\n    ",
                 joined(fit.coefficients), joined(recorded)});
  std::string before =
      "inline constexpr double " + name + "_covariance[" + size + "][" + size + "] = {\n    {";
  for (std::size_t k = 0; k < m; ++k, before = "    {") {
    std::vector<double> scales;
    for (std::size_t j = 0; j < m; ++j)
      scales.push_back(100 * std::sqrt(recorded_covariance[k][k] * recorded_covariance[j][j]));
    all.push_back({before, joined(fit.covariance[k]), joined(recorded_covariance[k]),
                   k + 1 < m ? "},\n" : "}};\n", 5, scales});
  }
}

inline void add_scatter(std::vector<Constant>& all, const std::string& name, const ScatterParts& parts,
                        const Scatter& sizes, const kernel::FactorScatter& recorded) {
  const auto pair = [](const auto& s) { return joined(s.base, s.gain); };
  all.push_back({"inline constexpr FactorScatter " + name + "{\n    {", pair(parts.recipes),
                 pair(recorded.recipes), "}, {"});
  all.push_back({"", pair(parts.packings), pair(recorded.packings), "}, {"});
  all.push_back({"", pair(sizes), pair(recorded.sizes), "}};\n"});
}

inline void add_gaps(std::vector<Constant>& all, const std::string& name, const ClosingGaps& gaps,
                     const std::array<double, 7>& recorded) {
  const auto& [growth, rattlers, scatter] = gaps;
  all.push_back({"// ",
                 joined(growth.error(0), growth.error(1), growth.error(2), growth.error(3), rattlers.error(0),
                        rattlers.error(1)),
                 std::vector<double>(6), "\n", 2, std::vector<double>(6, INFINITY)}); // a comment
  all.push_back({"inline constexpr std::array<double, 7> " + name + "_gaps{\n    ",
                 joined(growth.coefficients, rattlers.coefficients, scatter), joined(recorded)});
}

inline std::vector<Constant> constants_of(const Result& r) {
  std::vector<Constant> all;
  const auto array = [&](const std::string& before, const auto& fitted, const auto& recorded) {
    all.push_back({before, joined(fitted), joined(recorded)});
  };
  const auto number = [&](const std::string& before, double fitted, double recorded) {
    all.push_back({before + " = ", {fitted}, {recorded}, ";\n"});
  };
  add_fit(all, "shear", r.equal.shear, kernel::shear_coefficients, kernel::shear_covariance);
  add_fit(all, "bulk", r.equal.bulk, kernel::bulk_coefficients, kernel::bulk_covariance);
  add_fit(all, "stretch", r.stretch, kernel::stretch_coefficients, kernel::stretch_covariance);
  array(R"(
/// Coefficients of gain_by_unevenness, for G and K.
inline constexpr UnevennessCoefficients<double> shear_gain{
    )",
        r.shear_known.gain, kernel::shear_gain);
  array("inline constexpr UnevennessCoefficients<double> bulk_gain{\n    ", r.bulk_known.gain,
        kernel::bulk_gain);
  array(
      R"(/// Coefficients of unevenness_of_dense, and the scatter about it: of equal grains, of others over the
/// root of the relative variance of the lengths of branches.
inline constexpr DenseUnevenness<double> dense_unevenness{
    )",
      r.dense_forces.coefficients, kernel::dense_unevenness);
  array("inline constexpr std::array<double, 2> dense_unevenness_scatter{", r.dense_forces.scatter,
        kernel::dense_unevenness_scatter);
  all.back().after +=
      R"(/// Relative scatter about a factor: base, and gain times d ln/dz* (shear) or d ln/d ln r (bulk), in
/// quadrature; of recipes about the curve, of the packings of one recipe, and what unequal grains add: of
/// G over the root of the relative variance of the lengths of branches, of K over bulk_size_measure.
struct Scatter {
  double base;
  double gain;
};
struct FactorScatter {
  Scatter recipes, packings, sizes;
};
)";
  add_scatter(all, "shear_scatter", r.equal.shear.scatter, r.sizes.shear, kernel::shear_scatter);
  add_scatter(all, "bulk_scatter", r.equal.bulk.scatter, {r.sizes.bulk, 0}, kernel::bulk_scatter);
  all.back().after += "/// The same where the unevenness of forces is known.\n";
  add_scatter(all, "shear_scatter_known", r.shear_known.scatter, r.shear_known.sizes,
              kernel::shear_scatter_known);
  add_scatter(all, "bulk_scatter_known", r.bulk_known.scatter, r.bulk_known.sizes,
              kernel::bulk_scatter_known);
  number(
      R"(/// Shift of z* in G at the isostatic point and its standard error, over the relative variance of the
/// lengths of branches.
inline constexpr double size_shift)",
      r.sizes.shift, kernel::size_shift);
  number("inline constexpr double size_shift_error", r.sizes.shift_error, kernel::size_shift_error);
  number(R"(/// What unequal grains lose of K, and its standard error.
inline constexpr double size_loss)",
         r.sizes.loss, kernel::size_loss);
  number("inline constexpr double size_loss_error", r.sizes.loss_error, kernel::size_loss_error);
  number(R"(/// Scatter of K between codes: this times the looseness.
inline constexpr double bulk_codes)",
         r.bulk_codes, kernel::bulk_codes);
  number(R"(/// Scatter of ln C33/C11 over ln of the stretch.
inline constexpr double stretch_scatter)",
         r.stretch_scatter, kernel::stretch_scatter);
  number(R"(/// Further errors under unequal stresses, over |ln(stress_v/stress_h)|.
inline constexpr double shear_by_stress)",
         r.shear_by_stress, kernel::shear_by_stress);
  number("inline constexpr double bulk_by_stress", r.bulk_by_stress, kernel::bulk_by_stress);
  all.back().after += R"(
/// Where the packings of the fit end: what G loses by b = 1, and the power of what K loses by the scatter of
/// forces; the further errors of G and K there, over 1 - h. Of power laws, of rough spheres.
)";
  const auto& [power_laws, rough] = r.beyond;
  array("inline constexpr std::array<double, 2> power_law_losses{",
        joined(power_laws.shear_loss, power_laws.scatter_power), kernel::power_law_losses);
  array("inline constexpr std::array<double, 2> power_law_errors{", power_laws.errors,
        kernel::power_law_errors);
  array("inline constexpr std::array<double, 2> rough_losses{", joined(rough.shear_loss, rough.scatter_power),
        kernel::rough_losses);
  array("inline constexpr std::array<double, 2> rough_errors{", rough.errors, kernel::rough_errors);
  all.back().after += R"(
/// z_0, A, q, s, c, k and the scatter of z* of a ClosingGapLaw; in the comments the standard errors.
)";
  add_gaps(all, "dense", r.dense, kernel::dense_gaps);
  add_gaps(all, "loose", r.loose, kernel::loose_gaps);
  return all;
}

} // namespace relaxation

// SPDX-License-Identifier: GPL-3.0-or-later
// How the coefficients of the relaxation factors follow from the recorded networks.
#pragma once

#include <algorithm>
#include <cmath>

#include "code_scatter.hpp"
#include "factor_fits.hpp"
#include "scatter.hpp"
#include "size_fits.hpp"
#include "stiff_contacts.hpp"
#include "uneven_fits.hpp"

namespace relaxation {

// ---- closing gaps ----

struct ClosingGaps {
  Fit<4> growth;   ///< z_0, A, q, s
  Fit<2> rattlers; ///< c, k
  double scatter = 0;

  [[nodiscard]] double mechanical_coordination(const Packing& p) const {
    const auto& [initial, amplitude, exponent, spread] = growth.coefficients;
    return initial + amplitude * (1 - spread * p.exponent()) * std::pow(p.relative_overlap, exponent);
  }
};

/// z* = z_0 + A (1 - s b) w^q with w the relative overlap; x_0 = c exp(-k (z* - 4)).
inline ClosingGaps fit_closing_gaps(const std::vector<Packing>& packings, const std::string& preparation) {
  std::vector<Observation<4>> growth;
  std::vector<Observation<2>> rattlers;
  const auto belongs = [&](const Packing& p) {
    return p.preparation == preparation && p.relative_overlap < largest_overlap;
  };
  for (const Packing& p : packings) {
    if (!belongs(p))
      continue;
    const Dual<4> log_overlap(std::log(p.relative_overlap));
    const double b = p.exponent();
    growth.push_back({[=](const Numbers<Dual<4>, 4>& c) {
                        const Dual<4> power = c[2] * log_overlap;
                        const Dual<4> amplitude = c[1] * (1.0 - c[3] * b);
                        return Dual<4>(c[0] + amplitude * exp(power));
                      },
                      p.mechanical_coordination, 1, p.specimen});
    const Dual<2> above(p.mechanical_coordination - 4);
    rattlers.push_back({[=](const Numbers<Dual<2>, 2>& c) {
                          const Dual<2> power = -c[1] * above;
                          return Dual<2>(c[0] * exp(power));
                        },
                        p.rattler_fraction, 1, p.specimen});
  }
  ClosingGaps gaps{
      .growth = least_squares<4>(std::move(growth), {preparation == "dense" ? 6.0 : 4.0, 20, 0.5, 0.1}),
      .rattlers = least_squares<2>(std::move(rattlers), {0.1, 1})};
  double sum = 0;
  int count = 0;
  for (const Packing& p : packings)
    if (belongs(p)) {
      sum += std::pow(p.mechanical_coordination - gaps.mechanical_coordination(p), 2);
      ++count;
    }
  gaps.scatter = std::sqrt(sum / count);
  return gaps;
}

// ---- everything that relaxation_coefficients.hpp holds ----

struct Result {
  ShearFit shear;
  BulkFit bulk;
  StretchFit stretch;
  ScatterParts shear_scatter;
  ScatterParts bulk_scatter;
  ClosingGaps dense;
  ClosingGaps loose;
  double shear_by_stress = 0; ///< further error of G under unequal stresses, over |ln(stress_v/stress_h)|
  double bulk_by_stress = 0;  ///< the same of K
  SizeEffect sizes = {};
  double bulk_codes = 0; ///< scatter of K between codes, over kernel::looseness
  Beyond beyond = {};
  KnownForces shear_known = {}, bulk_known = {};
  DenseFit dense_forces = {};
  double stretch_scatter = 0; ///< what is left of ln C33/C11, over ln of the stretch
};

/// The relaxed closed form of one network of one state, with the coefficients of a result.
struct RelaxedState {
  kernel::RelaxedConstants<double> c;
  double log_stretch = 0;
};
inline RelaxedState relaxed_state(const Packing& p, const Network& n, const Result& result) {
  State state = p.state;
  state.tangential_ratio = n.ratio;
  const double h = shear_model(p, n, result.shear.coefficients);
  const double a = state.fabric_anisotropy;
  const double stretch =
      kernel::log_stretch(h, p.exponent(), std::log((5 + a) / (5 - 3 * a)),
                          std::log(state.stress_v / state.stress_h), result.stretch.coefficients);
  return {kernel::relax(constants_of(granum::effective::uniform_strain(state).stiffness),
                        bulk_model(p, n, result.bulk.coefficients), h, stretch),
          stretch};
}

/// How far sheared states are from the formula: C33/C11 by the stretch, G and K by the stress ratio, beyond
/// the scatter of isotropic states.
inline void fit_sheared_scatter(const std::vector<Packing>& packings, Result& result) {
  double left = 0, stretch = 0, G_left = 0, K_left = 0, stress = 0;
  for (const Packing& p : packings)
    for (const Network& n : p.networks)
      if (!p.isotropic() && n.ratio >= lowest_usual_ratio) {
        const auto [c, log_stretch] = relaxed_state(p, n, result);
        const TransverselyIsotropic relaxed{
            .C11 = c.C11, .C33 = c.C33, .C12 = c.C12, .C13 = c.C13, .C44 = c.C44};
        const TransverselyIsotropic& measured = n.stiffness;
        left += std::pow(std::log(c.C33 / c.C11 / (measured.C33 / measured.C11)), 2);
        stretch += log_stretch * log_stretch;
        G_left +=
            std::pow(std::log(isotropic_shear_modulus(relaxed) / isotropic_shear_modulus(measured)), 2) -
            squared_base(result.shear_scatter);
        K_left += std::pow(std::log(relaxed.bulk_modulus() / measured.bulk_modulus()), 2) -
                  squared_base(result.bulk_scatter);
        stress += std::pow(std::log(p.state.stress_v / p.state.stress_h), 2);
      }
  result.stretch_scatter = std::sqrt(left / stretch);
  result.shear_by_stress = std::sqrt(std::max(0.0, G_left / stress));
  result.bulk_by_stress = std::sqrt(std::max(0.0, K_left / stress));
}

inline EqualFit equal_fit(const Result& result) {
  return {.shear = result.shear,
          .bulk = result.bulk,
          .shear_scatter = result.shear_scatter,
          .bulk_scatter = result.bulk_scatter};
}

/// \param    unequal      packings of unequal grains, and of equal ones made as they were
/// \param    gradations   further ones, for the scatter of K between them
/// \param    of_codes     packings that other codes made
/// \param    stiff        networks of b up to 1
inline Result fit_everything(const std::vector<Packing>& packings, const std::vector<Packing>& unequal,
                             const std::vector<Packing>& gradations, const std::vector<Packing>& of_codes,
                             const std::vector<StiffNetwork>& stiff) {
  Result result{.shear = fit_shear(packings, everything),
                .bulk = fit_bulk(packings, everything),
                .stretch = {},
                .shear_scatter = {},
                .bulk_scatter = {},
                .dense = fit_closing_gaps(packings, "dense"),
                .loose = fit_closing_gaps(packings, "loose")};
  result.stretch = fit_stretch(packings, result.shear, result.bulk, everything);
  result.shear_scatter = scatter_parts(residuals(packings, result.shear, shear_residual, everything));
  result.bulk_scatter = scatter_parts(residuals(packings, result.bulk, bulk_residual, everything));
  fit_sheared_scatter(packings, result);
  result.sizes = fit_size_effect(unequal, gradations, equal_fit(result), everything);
  result.shear_known =
      fit_known_forces(Of::shear, packings, unequal, equal_fit(result), result.sizes, everything);
  result.bulk_known =
      fit_known_forces(Of::bulk, packings, unequal, equal_fit(result), result.sizes, everything);
  result.dense_forces = fit_dense(packings, unequal, everything);
  result.bulk_codes = fit_code_scatter(of_codes, equal_fit(result), result.sizes);
  result.beyond = fit_beyond(stiff, equal_fit(result), result.bulk_codes);
  return result;
}

} // namespace relaxation

// SPDX-License-Identifier: GPL-3.0-or-later
// Everything that src/effective/relaxation_coefficients.hpp holds, and how it follows from the recorded
// networks.
#pragma once

#include "../common.hpp"
#include "../constants.hpp"
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

/// Coefficients and their covariances: entries near 0 have no digits of their own, they are compared with the
/// errors.
template <int n>
void add_fit(std::vector<Constant>& all, const std::string& name, const Fit<n>& fit) {
  all.push_back({name + "_coefficients{", joined(fit.coefficients)});
  std::string before = name + "_covariance[" + std::to_string(n) + "][" + std::to_string(n) + "] = {";
  for (std::size_t k = 0; k < fit.coefficients.size(); ++k, before = "{") {
    std::vector<double> scales;
    for (std::size_t j = 0; j < fit.coefficients.size(); ++j)
      scales.push_back(10 * fit.error(k) * fit.error(j));
    all.push_back({before, joined(fit.covariance[k]), 5, scales});
  }
}

inline std::vector<double> numbers_of(const ScatterParts& parts, const Scatter& sizes) {
  return joined(parts.recipes.base, parts.recipes.gain, parts.packings.base, parts.packings.gain, sizes.base,
                sizes.gain);
}

/// The numbers of src/effective/relaxation_coefficients.hpp, in its order.
inline std::vector<Constant> constants_of(const Result& r) {
  std::vector<Constant> all;
  add_fit(all, "shear", r.equal.shear);
  add_fit(all, "bulk", r.equal.bulk);
  add_fit(all, "stretch", r.stretch);
  const auto& [power_laws, rough] = r.beyond;
  const std::vector<Constant> others{
      {"shear_gain{", joined(r.shear_known.gain)},
      {"bulk_gain{", joined(r.bulk_known.gain)},
      {"dense_unevenness{", joined(r.dense_forces.coefficients)},
      {"dense_unevenness_scatter{", joined(r.dense_forces.scatter)},
      {"shear_scatter{", numbers_of(r.equal.shear.scatter, r.sizes.shear)},
      {"bulk_scatter{", numbers_of(r.equal.bulk.scatter, {r.sizes.bulk, 0})},
      {"shear_scatter_known{", numbers_of(r.shear_known.scatter, r.shear_known.sizes)},
      {"bulk_scatter_known{", numbers_of(r.bulk_known.scatter, r.bulk_known.sizes)},
      {"size_shift = ", {r.sizes.shift}},
      {"size_shift_error = ", {r.sizes.shift_error}},
      {"size_loss = ", {r.sizes.loss}},
      {"size_loss_error = ", {r.sizes.loss_error}},
      {"bulk_codes = ", {r.bulk_codes}},
      {"stretch_scatter = ", {r.stretch_scatter}},
      {"shear_by_stress = ", {r.shear_by_stress}},
      {"bulk_by_stress = ", {r.bulk_by_stress}},
      {"power_law_losses{", joined(power_laws.shear_loss, power_laws.scatter_power)},
      {"power_law_errors{", joined(power_laws.errors)},
      {"rough_losses{", joined(rough.shear_loss, rough.scatter_power)},
      {"rough_errors{", joined(rough.errors)}};
  all.insert(all.end(), others.begin(), others.end());
  for (const ClosingGaps* gaps : {&r.dense, &r.loose}) {
    const auto& [growth, rattlers, scatter] = *gaps;
    std::vector<double> errors; // in a comment
    for (std::size_t k = 0; k < 6; ++k)
      errors.push_back(k < 4 ? growth.error(k) : rattlers.error(k - 4));
    all.push_back({"\n// ", errors, 2});
    all.push_back({"_gaps{", joined(growth.coefficients, rattlers.coefficients, scatter)});
  }
  return all;
}

} // namespace relaxation

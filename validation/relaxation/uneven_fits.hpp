// SPDX-License-Identifier: GPL-3.0-or-later
// What the unevenness of forces adds to rung 3: fitted to what the factors of equal and of unequal grains
// leave; and whether stated errors hold where forces are known.
#pragma once

#include "../common.hpp"
#include "effective/unevenness_kernel.hpp"
#include "size_fits.hpp"

namespace relaxation {

enum class Of { shear, bulk };

/// What is left of G or K of a network, and what it may depend on.
struct Left {
  Residual residual; ///< of the factors of equal and of unequal grains
  double unevenness = 0;
  double factor = 0; ///< of G
  double b = 0, z = 0, variance = 0;
  std::string recipe;

  /// ln of the gain of these coefficients.
  template <class T>
  [[nodiscard]] T gain(const kernel::UnevennessCoefficients<T>& c) const {
    return kernel::gain_by_unevenness<T>(unevenness, factor, b, z, variance, c);
  }
};

inline bool has_unevenness(const Packing& p, const Network& n) {
  return p.isotropic() && n.ratio >= lowest_usual_ratio &&
         p.mechanical_coordination >= lowest_usual_coordination;
}

inline Left left_of(Of of, const Packing& p, const Network& n, const EqualFit& equal,
                    const SizeEffect& sizes) {
  return {.residual = of == Of::shear ? shifted_shear_residual(p, n, equal, sizes.shift)
                                      : lessened_bulk_residual(p, n, equal, sizes.loss),
          .unevenness = p.unevenness,
          .factor = shifted_shear<double>(p, n, equal.shear.coefficients, sizes.shift),
          .b = p.exponent(),
          .z = p.mechanical_coordination,
          .variance = branch_variance(p),
          .recipe = p.recipe};
}

/// Coefficients of the gain: those of equal grains, then, with these given, those that unequal grains add.
/// Every recipe counts the same.
inline std::array<double, 7> fit_gain(const std::vector<Left>& all) {
  const std::map<std::string, double> counts = counts_of(all);
  std::array<double, 7> found{};
  const auto fit = [&]<std::size_t count>(const std::array<std::size_t, count>& places, bool unequal) {
    constexpr int n = static_cast<int>(count);
    using D = Dual<n>;
    std::vector<Observation<n>> rows;
    for (const Left& one : all)
      if ((one.variance > 0) == unequal)
        rows.push_back({[=](const Numbers<D, n>& k) {
                          kernel::UnevennessCoefficients<D> c = kernel::constants<D>(found);
                          for (std::size_t i = 0; i < count; ++i)
                            c[places[i]] = k[i];
                          return one.gain<D>(c);
                        },
                        -one.residual.error, 1 / std::sqrt(counts.at(one.recipe)), one.recipe});
    const Fit<n> result = least_squares<n>(std::move(rows), {});
    for (std::size_t i = 0; i < count; ++i)
      found[places[i]] = result.coefficients[i];
  };
  fit(std::array<std::size_t, 4>{0, 2, 3, 4}, false);
  fit(std::array<std::size_t, 3>{1, 5, 6}, true);
  return found;
}

/// What is known of a factor where the unevenness of forces is known.
struct KnownForces {
  std::array<double, 7> gain{};
  ScatterParts scatter; ///< that the gain leaves
  Scatter sizes;        ///< what unequal grains add to it, as SizeEffect has it; of K the base alone
};

/// \param    packings   of equal grains
/// \param    unequal    packings of unequal grains, and of equal ones in specimens as small
inline KnownForces fit_known_forces(Of of, const std::vector<Packing>& packings,
                                    const std::vector<Packing>& unequal, const EqualFit& equal,
                                    const SizeEffect& sizes, const Choice& chosen) {
  std::vector<Packing> all = packings;
  for (const Packing& p : unequal) // small specimens are stiffer: recipes of their own
    all.emplace_back(p).recipe += " small";
  std::vector<Left> left;
  for (const Packing& p : all)
    for (const Network& n : p.networks)
      if (has_unevenness(p, n) && chosen(p))
        left.push_back(left_of(of, p, n, equal, sizes));
  KnownForces known{.gain = fit_gain(left), .scatter = {}, .sizes = {}};
  std::vector<Residual> of_equal, of_sizes;
  std::vector<double> variances;
  for (const Left& one : left) {
    (one.variance > 0 ? of_sizes : of_equal).push_back(one.residual);
    (one.variance > 0 ? of_sizes : of_equal).back().error += one.gain<double>(known.gain);
    if (one.variance > 0)
      variances.push_back(one.variance);
  }
  known.scatter = scatter_parts(of_equal);
  if (of == Of::shear)
    known.sizes = shear_size_scatter(of_sizes, variances, known.scatter);
  else
    known.sizes.base = bulk_size_scatter(of_sizes, variances, known.scatter);
  return known;
}

/// As coverage_of, with the gains and what they leave: each preparation of the judged packings left out of
/// all fits in turn, of equal grains and of unequal ones.
inline ErrorsOfBoth coverage_of_left_out_forces(const std::vector<Packing>& packings,
                                                const std::vector<Packing>& unequal,
                                                const std::vector<Packing>& gradations,
                                                const std::vector<Packing>& judged) {
  return left_out(judged, "preparation", preparation_of, [&](const Choice& left, const Choice& kept) {
    const EqualFit equal = fit_equal(packings, kept);
    const SizeEffect sizes = fit_size_effect(unequal, gradations, equal, kept);
    const KnownForces G = fit_known_forces(Of::shear, packings, unequal, equal, sizes, kept),
                      K = fit_known_forces(Of::bulk, packings, unequal, equal, sizes, kept);
    EqualFit known = equal;
    known.shear.scatter = G.scatter;
    known.bulk.scatter = K.scatter;
    SizeEffect known_sizes = sizes;
    known_sizes.shear = G.sizes;
    known_sizes.bulk = K.sizes.base;
    ErrorsOfBoth all;
    for (const Packing& p : judged)
      for (const Network& n : p.networks)
        if (is_usual(p, n) && has_unevenness(p, n) && left(p)) {
          const Judged of_G = judged_shear(p, n, known, known_sizes),
                       of_K = judged_bulk(p, n, known, known_sizes);
          all.G.add(of_G.error + left_of(Of::shear, p, n, equal, sizes).gain<double>(G.gain), of_G.stated);
          all.K.add(of_K.error + left_of(Of::bulk, p, n, equal, sizes).gain<double>(K.gain), of_K.stated);
        }
    return all;
  });
}

// ---- dense packings, whose forces remember the preparation ----

inline constexpr double preparation_pressure = 10e3; ///< of all dense packings that are recorded [Pa]

struct DenseFit {
  std::array<double, 5> coefficients{};
  std::array<double, 2> scatter{}; ///< of equal grains, and of others over sqrt(v)
};

/// To packings whose forces count, before branches are short.
inline DenseFit fit_dense(const std::vector<Packing>& packings, const std::vector<Packing>& unequal) {
  using D = Dual<5>;
  std::vector<Observation<5>> rows;
  std::vector<double> variances;
  for (const std::vector<Packing>* all : {&packings, &unequal})
    for (const Packing& p : *all)
      if (preparation_of(p) == "dense" && p.exponent() > 0 && p.relative_overlap < largest_overlap) {
        // The square of the overlap at the pressure of preparation over the present one.
        const double faded = std::pow(preparation_pressure / p.state.mean_stress(), 2 * (1 - p.exponent()));
        const double v = branch_variance(p);
        rows.push_back({[b = p.exponent(), faded, v, ratio = p.stress_ratio](const Numbers<D, 5>& c) {
                          return kernel::unevenness_of_dense<D>(b, faded, v, ratio, c);
                        },
                        p.unevenness, v > 0 ? 0.1 : 1, p.recipe}); // others scatter ten times as much
        variances.push_back(v);
      }
  DenseFit fit{.coefficients = least_squares<5>(rows, {}).coefficients};
  std::array<Errors, 2> left;
  for (std::size_t k = 0; k < rows.size(); ++k) {
    const double error = rows[k].model(kernel::constants<D>(fit.coefficients)).value - rows[k].target;
    left[variances[k] > 0].add(variances[k] > 0 ? error / std::sqrt(variances[k]) : error);
  }
  fit.scatter = {left[0].rms(), left[1].rms()};
  return fit;
}

} // namespace relaxation

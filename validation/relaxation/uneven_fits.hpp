// SPDX-License-Identifier: GPL-3.0-or-later
// What the unevenness of forces adds to rung 3: fitted to what the factors of equal and of unequal grains
// leave.
#pragma once

#include <cmath>
#include <map>
#include <string>
#include <vector>

#include "effective/unevenness_kernel.hpp"
#include "size_fits.hpp"

namespace relaxation {

/// What is left of G or K of a network, ln of measured over fitted, and what it may depend on.
struct Left {
  double left = 0;
  double unevenness = 0;
  double factor = 0; ///< of G
  double b = 0, z = 0, variance = 0;
  double weight = 1; ///< every recipe counts the same
  std::string recipe;
};

enum class Of { shear, bulk };

inline bool has_unevenness(const Packing& p, const Network& n) {
  return p.isotropic() && n.ratio >= lowest_usual_ratio &&
         p.mechanical_coordination >= lowest_usual_coordination;
}

inline Residual residual_of(Of of, const Packing& p, const Network& n, const EqualFit& equal,
                            const SizeEffect& sizes) {
  return of == Of::shear ? shifted_shear_residual(p, n, equal.shear, sizes.shift)
                         : lessened_bulk_residual(p, n, equal.bulk, sizes.loss);
}

inline Left left_of(Of of, const Packing& p, const Network& n, const EqualFit& equal,
                    const SizeEffect& sizes) {
  const double h = shifted_shear<double, shear_size>(p, n, equal.shear.coefficients, sizes.shift);
  return {.left = -residual_of(of, p, n, equal, sizes).error,
          .unevenness = p.unevenness,
          .factor = h,
          .b = p.exponent(),
          .z = p.mechanical_coordination,
          .variance = branch_variance(p),
          .recipe = p.recipe};
}

inline std::vector<Left> all_left(Of of, const std::vector<Packing>& packings, const EqualFit& equal,
                                  const SizeEffect& sizes, const Choice& chosen) {
  std::vector<Left> all;
  std::map<std::string, double> counts;
  for (const Packing& p : packings)
    for (const Network& n : p.networks)
      if (has_unevenness(p, n) && chosen(p)) {
        all.push_back(left_of(of, p, n, equal, sizes));
        counts[p.recipe] += 1;
      }
  for (Left& one : all)
    one.weight = 1 / std::sqrt(counts.at(one.recipe));
  return all;
}

/// ln of the gain of these coefficients.
template <class T>
T gain(const Left& of, const kernel::UnevennessCoefficients<T>& c) {
  return kernel::gain_by_unevenness(T(of.unevenness), T(of.factor), T(of.b), T(of.z), of.variance, c);
}

/// Coefficients of the gain: those of equal grains, then, with these given, those that unequal grains add.
inline std::array<double, 7> fit_gain(const std::vector<Left>& all) {
  constexpr std::array<std::size_t, 4> of_equal = {0, 2, 3, 4};
  constexpr std::array<std::size_t, 3> of_sizes = {1, 5, 6};
  std::array<double, 7> found{};
  const auto fit = [&]<std::size_t places_count>(const std::array<std::size_t, places_count>& places,
                                                 bool unequal) {
    constexpr int count = static_cast<int>(places_count);
    using D = Dual<count>;
    std::vector<Observation<count>> rows;
    for (const Left& one : all)
      if ((one.variance > 0) == unequal)
        rows.push_back({[=](const Numbers<D, count>& k) {
                          kernel::UnevennessCoefficients<D> c = kernel::constants<D>(found);
                          for (std::size_t i = 0; i < places_count; ++i)
                            c[places[i]] = k[i];
                          return gain<D>(one, c);
                        },
                        one.left, one.weight, one.recipe});
    const Fit<count> result = least_squares<count>(std::move(rows), {});
    for (std::size_t i = 0; i < places_count; ++i)
      found[places[i]] = result.coefficients[i];
  };
  fit(of_equal, false);
  fit(of_sizes, true);
  return found;
}

/// What is known of a factor where the unevenness of forces is known.
struct KnownForces {
  std::array<double, 7> gain{};
  ScatterParts scatter; ///< that the gain leaves
  Scatter sizes;        ///< what unequal grains add to it, as SizeEffect has it; of K the base alone
};

/// The residual that the gain leaves.
inline Residual known_residual(Of of, const Packing& p, const Network& n, const EqualFit& equal,
                               const SizeEffect& sizes, const std::array<double, 7>& c) {
  Residual r = residual_of(of, p, n, equal, sizes);
  r.error += gain<double>(left_of(of, p, n, equal, sizes), c);
  return r;
}

/// \param    packings   of equal grains
/// \param    unequal    packings of unequal grains, and of equal ones in specimens as small
inline KnownForces fit_known_forces(Of of, const std::vector<Packing>& packings,
                                    const std::vector<Packing>& unequal, const EqualFit& equal,
                                    const SizeEffect& sizes, const Choice& chosen) {
  std::vector<Packing> all = packings;
  for (const Packing& p : unequal) { // small specimens are stiffer: recipes of their own
    all.push_back(p);
    all.back().recipe += " small";
  }
  KnownForces known{.gain = fit_gain(all_left(of, all, equal, sizes, chosen)), .scatter = {}, .sizes = {}};
  std::vector<Residual> of_equal, of_sizes;
  std::vector<double> variances;
  for (const Packing& p : all)
    for (const Network& n : p.networks)
      if (has_unevenness(p, n) && chosen(p)) {
        const Residual r = known_residual(of, p, n, equal, sizes, known.gain);
        if (branch_variance(p) > 0) {
          of_sizes.push_back(r);
          variances.push_back(branch_variance(p));
        } else
          of_equal.push_back(r);
      }
  known.scatter = scatter_parts(of_equal);
  if (of == Of::shear)
    known.sizes = shear_size_scatter(of_sizes, variances, known.scatter);
  else
    known.sizes.base = bulk_size_scatter(of_sizes, variances, known.scatter);
  return known;
}

// ---- dense packings, whose forces remember the preparation ----

inline constexpr double preparation_pressure = 10e3; ///< of all dense packings that are recorded [Pa]

/// Contacts whose forces count, before branches are short.
inline bool remembers(const Packing& p) {
  return unsheared(p.preparation) == "dense" && p.exponent() > 0 && p.relative_overlap < largest_overlap;
}

/// The square of the overlap at the pressure of preparation over the present one.
inline double faded(const Packing& p) {
  return std::pow(preparation_pressure / p.state.mean_stress(), 2 * (1 - p.exponent()));
}

struct DenseFit {
  std::array<double, 5> coefficients{};
  std::array<double, 2> scatter{}; ///< of equal grains, and of others over sqrt(v)
};

template <class T>
T dense_model(const Packing& p, const kernel::DenseUnevenness<T>& c) {
  return kernel::unevenness_of_dense(T(p.exponent()), T(faded(p)), branch_variance(p), p.stress_ratio, c);
}

/// Root mean square of what the fit leaves, of equal grains or of others over sqrt(v).
inline double dense_scatter(const std::vector<Packing>& packings, const std::array<double, 5>& c,
                            bool unequal) {
  double sum = 0, count = 0;
  for (const Packing& p : packings)
    if (remembers(p) && (branch_variance(p) > 0) == unequal) {
      const double left = dense_model<double>(p, c) - p.unevenness;
      sum += left * left / (unequal ? branch_variance(p) : 1);
      count += 1;
    }
  return std::sqrt(sum / count);
}

inline DenseFit fit_dense(const std::vector<Packing>& packings, const std::vector<Packing>& unequal,
                          const Choice& chosen) {
  using D = Dual<5>;
  std::vector<Packing> all = packings;
  all.insert(all.end(), unequal.begin(), unequal.end());
  std::erase_if(all, [&](const Packing& p) { return !remembers(p) || !chosen(p); });
  std::vector<Observation<5>> rows;
  for (const Packing& p : all) // others scatter ten times as much
    rows.push_back({[p](const Numbers<D, 5>& c) { return dense_model<D>(p, c); }, p.unevenness,
                    branch_variance(p) > 0 ? 0.1 : 1, p.recipe});
  DenseFit fit{.coefficients = least_squares<5>(std::move(rows), {}).coefficients};
  fit.scatter = {dense_scatter(all, fit.coefficients, false), dense_scatter(all, fit.coefficients, true)};
  return fit;
}

} // namespace relaxation

// SPDX-License-Identifier: GPL-3.0-or-later
#include <granum/fabric/goodness_of_fit.hpp>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

#include <granum/fabric/likelihood_estimate.hpp>
#include <granum/fabric/polar_distribution.hpp>

#include "core/compiled_once.hpp"
#include "normals.hpp"

namespace granum::fabric {

namespace {

constexpr std::size_t fewest_for_counts = 20; // four bins of five

ChiSquareTest chi_square(double statistic, int degrees_of_freedom) {
  return {.statistic = statistic,
          .degrees_of_freedom = degrees_of_freedom,
          .p_value = p_value(statistic, static_cast<std::size_t>(std::max(degrees_of_freedom, 0)))};
}

/// Largest k with k^5 <= 32 N^2, that is k <= 2 N^(2/5), and N/k >= 5.
std::size_t bin_count(std::size_t contacts) {
  const auto count = static_cast<double>(contacts);
  std::size_t bins = 1;
  while (std::pow(static_cast<double>(bins + 1), 5) <= 32 * count * count && 5 * (bins + 1) <= contacts)
    ++bins;
  return bins;
}

DensityTest counted(std::span<const Vec3> normals, double anisotropy, int fitted_parameters) {
  const std::size_t bins = bin_count(normals.size());
  std::vector<double> counts(bins, 0.0);
  for (const Vec3& n : normals) {
    const double probability =
        cumulative_probability(std::min(std::sqrt(squared_cosine(n)), 1.0), anisotropy);
    const auto bin = static_cast<std::size_t>(probability * static_cast<double>(bins));
    counts[std::min(bin, bins - 1)] += 1;
  }
  const double expected = static_cast<double>(normals.size()) / static_cast<double>(bins);
  double statistic = 0;
  for (const double count : counts)
    statistic += (count - expected) * (count - expected) / expected;
  return {.anisotropy = anisotropy,
          .bins = bins,
          .chi_square = chi_square(statistic, static_cast<int>(bins) - 1 - fitted_parameters)};
}

/// Two components that share a variance, from the sums over the sample of each and of the variance.
ChiSquareTest pair_test(double u, double v, double variance) {
  return variance > 0 ? chi_square((u * u + v * v) / variance, 2) : chi_square(0, 0);
}

} // namespace

IsotropyTest test_isotropy(std::span<const Vec3> normals) {
  require_normals(normals, 2);
  double sum = 0;
  for (const Vec3& n : normals)
    sum += legendre_2(n);
  const double z_score =
      sum * std::sqrt(5 / static_cast<double>(normals.size())); // the variance of P2 is 1/5
  const double gain = estimate_anisotropy_by_likelihood(normals).log_likelihood_gain;
  return {.z_score = z_score,
          .p_value = std::erfc(std::abs(z_score) / std::numbers::sqrt2),
          .likelihood_ratio = chi_square(2 * gain, 1)};
}

DensityTest test_density(std::span<const Vec3> normals, double anisotropy) {
  require_normals(normals, fewest_for_counts);
  return counted(normals, anisotropy, 0);
}

DensityTest test_density(std::span<const Vec3> normals) {
  require_normals(normals, fewest_for_counts);
  return counted(normals, estimate_anisotropy_by_likelihood(normals).anisotropy, 1);
}

AxisymmetryTest test_axisymmetry(std::span<const Vec3> normals) {
  require_normals(normals, fewest_for_counts);
  double difference = 0, n12 = 0, n13 = 0, n23 = 0;
  double horizontal_variance = 0, tilt_variance = 0; // sums of n1^2 n2^2 and n1^2 n3^2, averaged about axis 3
  for (const Vec3& n : normals) {
    const double sine_2 = n.x * n.x + n.y * n.y;
    difference += (n.x * n.x - n.y * n.y) / 2;
    n12 += n.x * n.y, n13 += n.x * n.z, n23 += n.y * n.z;
    horizontal_variance += sine_2 * sine_2 / 8;
    tilt_variance += sine_2 * n.z * n.z / 2;
  }
  AxisymmetryTest test{.horizontal = pair_test(difference, n12, horizontal_variance),
                       .tilt = pair_test(n13, n23, tilt_variance),
                       .both = {}};
  test.both = chi_square(test.horizontal.statistic + test.tilt.statistic,
                         test.horizontal.degrees_of_freedom + test.tilt.degrees_of_freedom);
  return test;
}

} // namespace granum::fabric

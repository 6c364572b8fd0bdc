// SPDX-License-Identifier: GPL-3.0-or-later
#include <granum/fabric/estimates.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <numbers>
#include <numeric>
#include <span>
#include <string>
#include <vector>

#include <granum/core/error.hpp>
#include <granum/core/stop.hpp>
#include <granum/core/vec3.hpp>
#include <granum/fabric/orientation.hpp>

#include "core/compiled_once.hpp"

namespace granum::fabric {

namespace {

/// A sufficiently large sample of contact normals, all unit vectors.
/// \throws   InvalidArgument for fewer than `fewest`, or a length that differs from 1 by more than 1e-6
void require_normals(std::span<const Vec3> normals, std::size_t fewest) {
  if (normals.size() < fewest)
    throw InvalidArgument("number of contact normals", static_cast<double>(normals.size()), "",
                          "[" + std::to_string(fewest) + ", inf)");
  for (std::size_t i = 0; i < normals.size(); ++i) {
    stop_point(i);
    if (const double length = norm(normals[i]); !(std::abs(length - 1) <= 1e-6))
      throw InvalidArgument("length of contact normal " + std::to_string(i), length, "", "1 +- 1e-6");
  }
}

/// n3^2 of the normal at length 1: in [0, 1] whatever the rounding of its length.
double squared_cosine(const Vec3& n) { return n.z * n.z / dot(n, n); }

/// Legendre polynomial of the polar cosine, (3 cos^2 - 1)/2, in [-1/2, 1].
double legendre_2(const Vec3& n) { return (3 * squared_cosine(n) - 1) / 2; }

} // namespace

AnisotropyEstimate estimate_anisotropy(std::span<const Vec3> normals) {
  require_normals(normals, 2);
  const auto count = static_cast<double>(normals.size());
  double sum = 0;
  for (const Vec3& n : normals)
    sum += n.z * n.z;
  const double F33 = std::min(sum / count, 1.0); // lengths may exceed 1 by their rounding
  double squares = 0;
  for (const Vec3& n : normals)
    squares += (n.z * n.z - F33) * (n.z * n.z - F33);
  const double error_of_F33 = std::sqrt(squares / (count - 1) / count);
  const double slope = 40 / ((5 * F33 + 1) * (5 * F33 + 1)); // da/dF33

  AnisotropyEstimate estimate{.anisotropy = anisotropy_from_F33(F33),
                              .standard_error = slope * error_of_F33,
                              .F33 = F33,
                              .contacts = normals.size(),
                              .validity = {}};
  estimate.validity = anisotropy_validity(estimate.anisotropy);
  return estimate;
}

double isotropic_standard_error(std::size_t contacts) {
  if (contacts == 0)
    throw InvalidArgument("number of contacts", 0, "", "[1, inf)");
  return std::sqrt(45.0 / 16 / static_cast<double>(contacts));
}

// Notation: a_c coefficient of P2 in the density (1 + a_c P2)/(4 pi), in [-1, 2] for a in [-1, 1]; x values
// of P2 on the sample.

namespace {

constexpr double lowest = -1, highest = 2; // a_c of a = -1 and a = 1

/// First derivative of the log-likelihood and minus the second. Where a boundary density vanishes in the
/// direction of a contact, the score there is infinite, with the sign that sends the maximum inside.
struct Slopes {
  double score = 0;
  double information = 0;
};

Slopes slopes(const std::vector<double>& x, double a_c) {
  stop_point();
  Slopes sum;
  for (const double value : x) {
    const double ratio = value / (1 + a_c * value);
    sum.score += ratio;
    sum.information += ratio * ratio;
  }
  return sum;
}

double most_likely(const std::vector<double>& x) {
  if (slopes(x, highest).score >= 0)
    return highest;
  if (slopes(x, lowest).score <= 0)
    return lowest;
  double low = lowest, high = highest, a_c = 0;
  for (int i = 0; i < 100; ++i) { // halving alone would need fifty
    const Slopes at = slopes(x, a_c);
    (at.score > 0 ? low : high) = a_c;
    double next = a_c + at.score / at.information;
    if (!(next > low && next < high))
      next = low + (high - low) / 2;
    const double step = std::abs(next - a_c);
    a_c = next;
    if (step <= 1e-15)
      break;
  }
  return a_c;
}

/// ln L - ln L(isotropic)
double gain(const std::vector<double>& x, double a_c) {
  stop_point();
  double sum = 0;
  for (const double value : x)
    sum += std::log1p(a_c * value);
  return sum;
}

} // namespace

LikelihoodEstimate estimate_anisotropy_by_likelihood(std::span<const Vec3> normals) {
  require_normals(normals, 2);
  std::vector<double> x(normals.size());
  std::transform(normals.begin(), normals.end(), x.begin(), legendre_2);

  LikelihoodEstimate estimate;
  estimate.contacts = normals.size();
  // Contacts along the diagonals of a cube, as in a body-centred lattice, have P2 = 0: any a is as likely.
  const bool flat = std::all_of(x.begin(), x.end(), [](double value) { return std::abs(value) < 1e-12; });
  const double a_c = flat ? 0 : most_likely(x);
  const double information = flat ? 0 : slopes(x, a_c).information;
  estimate.anisotropy = measures_from_P2_coefficient(a_c).anisotropy;
  estimate.standard_error = information > 0 ? 12 / ((4 + a_c) * (4 + a_c)) / std::sqrt(information)
                                            : std::numeric_limits<double>::infinity();
  estimate.log_likelihood_gain = std::max(gain(x, a_c), 0.0);
  estimate.at_boundary = a_c == lowest || a_c == highest;
  if (estimate.at_boundary)
    estimate.validity.add("the likelihood of the fabric anisotropy is largest at the end of [-1, 1]: the "
                          "contacts may be more strongly oriented than E(gamma; a) can describe");
  if (estimate.standard_error > 1)
    estimate.validity.add(
        "the contact directions barely constrain the fabric anisotropy: its standard error is "
        "above 1");
  return estimate;
}

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

namespace {

/// Acute angle with axis 3, without the loss of digits that the arc cosine has near it.
double polar_angle(const Vec3& n) { return std::atan2(std::sqrt(n.x * n.x + n.y * n.y), std::abs(n.z)); }

double share_above(double angle, double anisotropy) {
  return cumulative_probability(std::clamp(std::cos(angle), 0.0, 1.0), anisotropy);
}

} // namespace

std::vector<RoseBin> rose_of_counts(std::span<const std::size_t> counts, double anisotropy) {
  require_closed("fabric_anisotropy", anisotropy, -1, 1);
  require_closed("bins", static_cast<double>(counts.size()), 1, 1000);
  const auto contacts = static_cast<double>(std::accumulate(counts.begin(), counts.end(), std::size_t{0}));
  require_positive("contacts", contacts);
  const double width = std::numbers::pi / 2 / static_cast<double>(counts.size());
  std::vector<RoseBin> histogram(counts.size());
  for (std::size_t i = 0; i < histogram.size(); ++i) {
    RoseBin& bin = histogram[i];
    bin.count = counts[i];
    bin.low = static_cast<double>(i) * width;
    bin.high = static_cast<double>(i + 1) * width;
    // 4 pi (cos low - cos high)
    const double solid_angle =
        8 * std::numbers::pi * std::sin((bin.low + bin.high) / 2) * std::sin((bin.high - bin.low) / 2);
    bin.count_error = std::sqrt(static_cast<double>(bin.count));
    bin.expected_count = contacts * (share_above(bin.low, anisotropy) - share_above(bin.high, anisotropy));
    bin.density = static_cast<double>(bin.count) / (contacts * solid_angle);
    bin.density_error = bin.count_error / (contacts * solid_angle);
    bin.expected_density = bin.expected_count / (contacts * solid_angle);
  }
  return histogram;
}

std::vector<RoseBin> rose(std::span<const Vec3> normals, double anisotropy, std::size_t bins) {
  require_normals(normals, 1);
  require_closed("bins", static_cast<double>(bins), 1, 1000);
  const double width = std::numbers::pi / 2 / static_cast<double>(bins);
  std::vector<std::size_t> counts(bins);
  for (std::size_t k = 0; k < normals.size(); ++k) {
    stop_point(k);
    ++counts[std::min(static_cast<std::size_t>(polar_angle(normals[k]) / width), bins - 1)];
  }
  return rose_of_counts(counts, anisotropy);
}

std::vector<RoseBin> readable_rose(std::span<const std::size_t> counts, double anisotropy) {
  constexpr double enough = 25; // contacts
  constexpr std::size_t least_bins = 3;
  const auto contacts = static_cast<double>(std::accumulate(counts.begin(), counts.end(), std::size_t{0}));
  const std::size_t bins = counts.size();
  std::size_t taken = 1; // into one
  for (std::size_t next = 1; next <= bins && bins / next >= std::min(bins, least_bins); ++next) {
    if (bins % next != 0)
      continue;
    taken = next;
    const double width = std::numbers::pi / 2 * static_cast<double>(taken) / static_cast<double>(bins);
    if (contacts * (1 - std::cos(width)) >= enough)
      break;
  }
  std::vector<std::size_t> merged(bins / taken);
  for (std::size_t i = 0; i < bins; ++i)
    merged[i / taken] += counts[i];
  return rose_of_counts(merged, anisotropy);
}

} // namespace granum::fabric

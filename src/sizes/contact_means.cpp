// SPDX-License-Identifier: GPL-3.0-or-later
#include <granum/sizes/contact_means.hpp>

#include <algorithm>
#include <cmath>
#include <numeric>

#include <granum/core/error.hpp>
#include <granum/core/numerics.hpp>

#include "core/root.hpp"
#include "sorted_radii.hpp"

namespace granum::sizes {

namespace {

/// Grains of one radius, counted by their contacts.
struct Partners {
  double radius = 0;
  double contacts = 0;
};

/// Contacts, or how often such contacts are found: the pair radius whose k_n is their mean over l^2.
class MeanPair {
 public:
  void add(double radius_i, double radius_j, double often = 1) {
    const double length = radius_i + radius_j;
    const double weight = often * (length * length);
    weights_ += weight;
    roots_ += weight * std::cbrt(harmonic_mean(radius_i, radius_j));
  }
  [[nodiscard]] double radius() const {
    const double root = roots_ / weights_;
    return root * root * root;
  }

 private:
  double weights_ = 0, roots_ = 0;
};

/// Of independent partners, each found as often as it has contacts.
double mean_pair_radius(const std::vector<Partners>& partners) {
  MeanPair mean;
  for (std::size_t i = 0; i < partners.size(); ++i) {
    const auto& [x, of_x] = partners[i];
    mean.add(x, x, of_x * of_x);
    for (std::size_t j = 0; j < i; ++j)
      mean.add(x, partners[j].radius, 2 * of_x * partners[j].contacts);
  }
  return mean.radius();
}

/// How often grains of the nodes touch others, over a grain of the mean radius, where a share of the grains
/// are rattlers.
std::vector<double> contact_numbers(std::span<const SizeNode> nodes, double rattler_fraction) {
  require_closed("rattler_fraction", rattler_fraction, 0, 1 - 1e-9);
  std::vector<double> numbers;
  for (const SizeNode& node : nodes)
    numbers.push_back(relative_contact_number(node.radius));
  if (rattler_fraction == 0)
    return numbers;
  const double of_point = relative_contact_number(0);
  const auto excess = [&](double k) { // falls with k
    double rattlers = 0, all = 0;
    for (std::size_t n = 0; n < nodes.size(); ++n) {
      rattlers += nodes[n].share * std::exp(-k * (numbers[n] - of_point));
      all += nodes[n].share;
    }
    return rattlers / all - rattler_fraction;
  };
  double above = 1;
  while (excess(above) > 0)
    above *= 2;
  const double k = root_between(excess, 0.0, above, within_bits(48)).first;
  for (double& number : numbers)
    number *= -std::expm1(-k * (number - of_point));
  return numbers;
}

/// Sums over grains, each with a share of their number, a radius x and how often it touches others.
class Sums {
 public:
  void add(const SizeNode& node, double contact_number) {
    const auto& [x, share] = node;
    const double often = share * contact_number;
    number_ += share;
    cubes_ += share * (x * x * x);
    contacts_ += often;
    mean_ += often * x;
    square_ += often * x * x;
  }
  [[nodiscard]] ContactMeans means(double pair_radius) const {
    const double mean = mean_ / contacts_; // <R_i + R_j>/2
    return {.branch = mean,
            .branch_square = 0.5 * (square_ / contacts_ + mean * mean),
            .pair_radius = pair_radius,
            .grain_volume = cubes_ / number_};
  }

 private:
  double number_ = 0, cubes_ = 0, contacts_ = 0, mean_ = 0, square_ = 0;
};

/// \param  classes  at most so many are paired with each other; the nodes ascend
ContactMeans expected(std::span<const SizeNode> nodes, double rattler_fraction, std::size_t classes) {
  const std::vector<double> numbers = contact_numbers(nodes, rattler_fraction);
  classes = std::min(classes, nodes.size());
  Sums sums;
  std::vector<Partners> partners(classes);
  for (std::size_t k = 0; k < classes; ++k) {
    double lengths = 0;
    for (std::size_t n = k * nodes.size() / classes; n < (k + 1) * nodes.size() / classes; ++n) {
      sums.add(nodes[n], numbers[n]);
      partners[k].contacts += nodes[n].share * numbers[n];
      lengths += nodes[n].share * numbers[n] * nodes[n].radius;
    }
    partners[k].radius = lengths / partners[k].contacts;
  }
  return sums.means(mean_pair_radius(partners));
}

} // namespace

void require_valid(const ContactMeans& means) {
  require_positive("contact means: branch", means.branch);
  require_positive("contact means: branch_square", means.branch_square);
  require_positive("contact means: pair_radius", means.pair_radius);
  require_positive("contact means: grain_volume", means.grain_volume);
  constexpr double rounding = 1e-9;
  if (!(means.branch_square >= (1 - rounding) * means.branch * means.branch))
    throw InvalidArgument(
        "contact means: the mean square of the branches, branch_square, is smaller than the "
        "square of their mean");
}

ContactMeans counted_contact_means(std::span<const double> radii, std::span<const TouchingPair> contacts,
                                   double reference) {
  require_positive("reference radius", reference, "m");
  if (radii.empty() || contacts.empty())
    throw InvalidArgument("contact means need one grain and one contact or more");
  double volume = 0;
  for (const double radius : radii) {
    const double relative = require_positive("radius", radius, "m") / reference;
    volume += relative * relative * relative;
  }
  ContactMeans sum{.branch = 0, .branch_square = 0};
  MeanPair pair;
  for (const auto& [radius_i, radius_j] : contacts) {
    const double i = require_positive("radius of a contact", radius_i, "m") / reference;
    const double j = require_positive("radius of a contact", radius_j, "m") / reference;
    const double half = 0.5 * (i + j);
    sum.branch += half;
    sum.branch_square += half * half;
    pair.add(i, j);
  }
  const double count = static_cast<double>(contacts.size());
  return {.branch = sum.branch / count,
          .branch_square = sum.branch_square / count,
          .pair_radius = pair.radius(),
          .grain_volume = volume / static_cast<double>(radii.size())};
}

double relative_contact_number(double x) {
  // 1/Omega = (1 + sqrt(1 - s))/s with s = 1/(1 + x)^2; at x = 1 s = 1/4.
  const double inverse_s = (1 + x) * (1 + x);
  return inverse_s * (1 + std::sqrt(1 - 1 / inverse_s)) / (4 * (1 + std::sqrt(0.75)));
}

ContactMeans expected_contact_means(const Distribution& sizes, double rattler_fraction) {
  if (sizes.is_equal())
    return {};
  const std::vector<SizeNode> nodes = sizes.nodes();
  return expected(nodes, rattler_fraction, nodes.size());
}

ContactMeans expected_contact_means(std::span<const double> radii, double rattler_fraction) {
  constexpr std::size_t most_classes = 1024;
  if (radii.empty())
    throw InvalidArgument("contact means need one grain or more");
  const std::vector<double> sorted = sorted_radii(radii);
  if (sorted.front() == sorted.back())
    return {};
  const double mean = std::accumulate(sorted.begin(), sorted.end(), 0.0) / static_cast<double>(sorted.size());
  std::vector<SizeNode> nodes;
  for (const double radius : sorted)
    nodes.push_back({.radius = radius / mean, .share = 1});
  return expected(nodes, rattler_fraction, most_classes);
}

ContactMeans with_reference(const ContactMeans& means, double scale) {
  require_positive("scale of the reference radius", scale);
  return {.branch = means.branch / scale,
          .branch_square = means.branch_square / (scale * scale),
          .pair_radius = means.pair_radius / scale,
          .grain_volume = means.grain_volume / (scale * scale * scale)};
}

} // namespace granum::sizes

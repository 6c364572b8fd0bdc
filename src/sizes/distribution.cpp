// SPDX-License-Identifier: GPL-3.0-or-later
// A Gaussian in t = ln x, counted x^k times, is a Gaussian about median + k deviation^2; a power x^slope is
// one of exponent slope + k. So number, mass and every moment are one integral with another k.
#include <granum/sizes/distribution.hpp>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>
#include <span>
#include <utility>
#include <vector>

#include <boost/math/special_functions/erf.hpp>
#include <boost/random/mersenne_twister.hpp>
#include <boost/random/uniform_int_distribution.hpp>
#include <boost/random/uniform_real_distribution.hpp>

#include <granum/core/error.hpp>
#include <granum/core/numerics.hpp>
#include <granum/core/stop.hpp>
#include <granum/core/text.hpp>
#include <granum/core/units.hpp>

#include "core/root.hpp"
#include "sorted_radii.hpp"

namespace granum::sizes {

namespace {

constexpr double largest_ratio = 1e3;
constexpr double largest_cut_ratio = 1e6;
constexpr double nothing_beyond = 9; ///< standard deviations

/// Doubles all the way: long double differs between machines.
using Doubles = boost::math::policies::policy<boost::math::policies::promote_double<false>>;

/// Normal probability between a <= b.
double normal_share(double a, double b) {
  if (a > 0)
    return normal_share(-b, -a);
  constexpr double root = std::numbers::sqrt2;
  return 0.5 * (std::erfc(-b / root) - std::erfc(-a / root));
}

/// The number below which a share of the normal probability between a <= b lies.
double normal_quantile(double a, double b, double share) {
  if (a > 0)
    return -normal_quantile(-b, -a, 1 - share);
  constexpr double root = std::numbers::sqrt2;
  const double below = std::erfc(-a / root) + share * (std::erfc(-b / root) - std::erfc(-a / root));
  if (below <= 0)
    return a;
  return std::clamp(-root * boost::math::erfc_inv(below, Doubles()), a, b);
}

/// Integral of exp(slope t) over 0 < t < length.
double growth(double slope, double length) {
  return slope == 0 ? length : std::expm1(slope * length) / slope;
}

} // namespace

double Distribution::Part::moment(double k) const {
  if (is_one_radius())
    return std::pow(low, k);
  const double length = std::log(high / low);
  if (!(deviation > 0))
    return std::pow(low, k) * (growth(slope + k, length) / growth(slope, length));
  const double a = (std::log(low) - median) / deviation, b = (std::log(high) - median) / deviation;
  const double shift = k * deviation;
  return std::exp(k * median + shift * shift / 2) * (normal_share(a - shift, b - shift) / normal_share(a, b));
}

double Distribution::Part::share_below(double x, double k) const {
  if (x >= high)
    return 1;
  if (x <= low)
    return 0;
  if (!(deviation > 0))
    return growth(slope + k, std::log(x / low)) / growth(slope + k, std::log(high / low));
  const double centre = median + k * deviation * deviation;
  const auto at = [&](double radius) { return (std::log(radius) - centre) / deviation; };
  return normal_share(at(low), at(x)) / normal_share(at(low), at(high));
}

double Distribution::Part::quantile(double part, double k) const {
  if (is_one_radius() || part <= 0)
    return low;
  if (part >= 1)
    return high;
  double x = 0;
  if (deviation > 0) {
    const double centre = median + k * deviation * deviation;
    const auto at = [&](double radius) { return (std::log(radius) - centre) / deviation; };
    x = std::exp(centre + deviation * normal_quantile(at(low), at(high), part));
  } else if (slope + k == 1) { // the same number for every step of radius
    x = low + part * (high - low);
  } else {
    const double n = slope + k, length = std::log(high / low);
    x = low * std::exp(n == 0 ? part * length : std::log1p(part * std::expm1(n * length)) / n);
  }
  return std::clamp(x, low, high);
}

double Distribution::Part::density(double t) const {
  if (!(deviation > 0))
    return std::exp(slope * (t - std::log(low))) / growth(slope, std::log(high / low));
  const auto at = [&](double place) { return (place - median) / deviation; };
  const double z = at(t);
  return std::exp(-z * z / 2) / (deviation * std::sqrt(2 * std::numbers::pi)) /
         normal_share(at(std::log(low)), at(std::log(high)));
}

void Distribution::Part::append_nodes(std::vector<SizeNode>& nodes) const {
  if (is_one_radius()) {
    nodes.push_back({.radius = low, .share = share});
    return;
  }
  const double start = std::log(low), half = std::log(high / low) / 2;
  const double widths = deviation > 0 ? half / deviation : half;
  const int order = 16 + static_cast<int>(8 * std::min(std::max(half, widths), 12.0));
  for (const auto& [y, weight] : gauss_legendre(order)) {
    const double t = start + half * (1 + y);
    nodes.push_back({.radius = std::exp(t), .share = share * weight * half * density(t)});
  }
}

Distribution::Distribution(std::vector<Part> parts, std::string text)
    : parts_(std::move(parts)), text_(std::move(text)) {
  const double mean = moment(1);
  for (Part& part : parts_) {
    part.low /= mean;
    part.high /= mean;
    part.median -= std::log(mean);
  }
}

Distribution Distribution::equal() { return {{Part{}}, "equal"}; }

Distribution Distribution::bidisperse(double ratio, double share) {
  require_closed("bidisperse size ratio", ratio, 1, largest_ratio);
  require_open("bidisperse share of large grains", share, 0, 1);
  if (ratio == 1)
    return equal();
  return {{Part{.share = 1 - share}, Part{.share = share, .low = ratio, .high = ratio}},
          "bidisperse:" + exact_text(ratio) + ":" + exact_text(share)};
}

Distribution Distribution::uniform(double smallest, double largest) {
  require_positive("uniform smallest radius", smallest);
  require_closed("uniform largest over smallest radius", largest / smallest, 1, largest_ratio);
  if (smallest == largest)
    return equal();
  return {{Part{.low = smallest, .high = largest, .slope = 1}},
          "uniform:" + exact_text(smallest) + ":" + exact_text(largest)};
}

Distribution::Part Distribution::cut_lognormal(double sigma, double centre, double half_width) {
  return {.low = std::exp(centre - half_width), .high = std::exp(centre + half_width), .deviation = sigma};
}

Distribution Distribution::lognormal(double sigma, std::optional<double> size_ratio) {
  constexpr double one_per_cent = 2.3263478740408408; // standard deviations that leave 1 % beyond
  require_closed("lognormal sigma", sigma, 0, 1.2);
  if (size_ratio)
    require_closed("lognormal size ratio", *size_ratio, 1 + 1e-6, largest_cut_ratio);
  if (sigma == 0)
    return equal();
  const double centre = 1.5 * sigma * sigma; // between the medians by number and by mass
  const double half_width = size_ratio ? std::min(std::log(*size_ratio) / 2, centre + nothing_beyond * sigma)
                                       : centre + one_per_cent * sigma;
  return {{cut_lognormal(sigma, centre, half_width)},
          "lognormal:" + exact_text(sigma) + (size_ratio ? ":" + exact_text(*size_ratio) : "")};
}

Distribution Distribution::power_law(double exponent, double size_ratio) {
  require_closed("power-law exponent", exponent, -10, 10);
  require_closed("power-law size ratio", size_ratio, 1, largest_ratio);
  if (size_ratio == 1)
    return equal();
  return {{Part{.high = size_ratio, .slope = 1 - exponent}},
          "power-law:" + exact_text(exponent) + ":" + exact_text(size_ratio)};
}

Distribution Distribution::uniformity(double coefficient, std::optional<double> size_ratio) {
  constexpr double five_per_cent = 1.6448536269514722; // standard deviations that leave 5 % beyond
  require_closed("coefficient of uniformity", coefficient, 1, 20);
  if (size_ratio)
    require_closed("uniformity size ratio", *size_ratio, coefficient * coefficient * (1 + 1e-6),
                   largest_cut_ratio);
  if (coefficient == 1)
    return equal();
  // ln C_u of a lognormal by mass, cut `width` standard deviations beside its median, in standard deviations.
  const auto spread = [](double width) {
    return normal_quantile(-width, width, 0.6) - normal_quantile(-width, width, 0.1);
  };
  const double log_coefficient = std::log(coefficient);
  double width = five_per_cent;
  if (size_ratio) { // half the log of the ratio is width sigma; spread/width falls from 1 on with the width
    const double share = 2 * log_coefficient / std::log(*size_ratio);
    const auto excess = [&](double w) { return spread(w) / w - share; };
    constexpr double narrow = 1e-3;
    if (excess(narrow) > 0 && excess(nothing_beyond) < 0)
      width = root_between(excess, narrow, nothing_beyond, within_bits(48), 100).first;
    else
      width = excess(nothing_beyond) >= 0 ? nothing_beyond : narrow;
  }
  const double sigma = log_coefficient / spread(width);
  return {{cut_lognormal(sigma, 3 * sigma * sigma, width * sigma)},
          "uniformity:" + exact_text(coefficient) + (size_ratio ? ":" + exact_text(*size_ratio) : "")};
}

std::optional<SieveFault> find_fault(std::span<const SievePoint> curve) {
  if (curve.size() < 2)
    return SieveFault{0, "two points or more are needed"};
  for (std::size_t k = 0; k < curve.size(); ++k) {
    const auto& [d, passing] = curve[k];
    if (!(d > 0 && std::isfinite(d)))
      return SieveFault{k, detail::formatted("d = %g m is outside (0, inf)", d)};
    if (!(passing >= 0 && passing <= 1))
      return SieveFault{k, "passing = " + detail::refused_text(passing, "[0, 1]", 6) +
                               " is outside [0, 1], or 0 to 100 %"};
    if (k > 0 && !(d > curve[k - 1].diameter))
      return SieveFault{k, "d must be larger than at the point before"};
    if (k > 0 && !(passing >= curve[k - 1].passing))
      return SieveFault{k, "less passes than at the point before"};
  }
  if (curve.front().passing != 0)
    return SieveFault{0, "passing must begin at 0: add the size of the finest grains"};
  if (curve.back().passing != 1)
    return SieveFault{curve.size() - 1, "passing must end at 1 (100 %): add the size of the coarsest grains"};
  if (!(curve.back().diameter / curve.front().diameter <= largest_cut_ratio))
    return SieveFault{curve.size() - 1, "d is more than 1e6 times that of the first point"};
  return std::nullopt;
}

Distribution Distribution::sieve(std::span<const SievePoint> curve) {
  if (const auto fault = find_fault(curve))
    throw InvalidArgument("sieve curve, point " + std::to_string(fault->point + 1) + ": " + fault->what);
  std::string text = "sieve";
  for (const auto& [d, passing] : curve)
    text += ":" + exact_text(d) + "m=" + exact_text(passing);
  std::vector<Part> parts;
  double number = 0, finest = 0; // finest: of grains that there are [m]
  for (std::size_t k = 1; k < curve.size(); ++k) {
    const double mass = curve[k].passing - curve[k - 1].passing;
    if (mass == 0)
      continue;
    // In units of the coarsest grain, so that no cube underflows.
    Part part{.low = curve[k - 1].diameter / curve.back().diameter,
              .high = curve[k].diameter / curve.back().diameter,
              .slope = -3};
    part.share = mass / part.moment(3);
    if (parts.empty())
      finest = curve[k - 1].diameter;
    number += part.share;
    parts.push_back(part);
  }
  for (Part& part : parts)
    part.share /= number;
  Distribution sizes(std::move(parts), std::move(text));
  sizes.mean_radius_ = finest / 2 / sizes.smallest();
  return sizes;
}

double Distribution::moment(double k) const {
  require_finite("order of the moment", k);
  double sum = 0;
  for (const Part& part : parts_)
    sum += part.share * part.moment(k);
  return sum;
}

double Distribution::share_below(double x, double k) const {
  double below = 0, all = 0;
  for (const Part& part : parts_) {
    const double weight = part.share * part.moment(k);
    below += weight * part.share_below(x, k);
    all += weight;
  }
  return below / all;
}

double Distribution::quantile(double share, double k) const {
  require_closed("share", share, 0, 1);
  double left = share * moment(k);
  for (const Part& part : parts_) {
    const double weight = part.share * part.moment(k);
    if (left <= weight)
      return part.quantile(left / weight, k);
    left -= weight;
  }
  return largest();
}

std::vector<SizeNode> Distribution::nodes() const {
  std::vector<SizeNode> all;
  for (const Part& part : parts_)
    part.append_nodes(all);
  return all;
}

Gradation gradation(const Distribution& sizes, double mean_radius) {
  require_positive("mean_radius", mean_radius, "m");
  const auto diameter = [&](double share) { return 2 * mean_radius * sizes.quantile(share, 3); };
  return {.d10 = diameter(0.1), .d50 = diameter(0.5), .d60 = diameter(0.6)};
}

Gradation gradation(std::span<const double> radii) {
  if (radii.empty())
    throw InvalidArgument("radii: a gradation needs one grain or more");
  const std::vector<double> sorted = sorted_radii(radii);
  const auto mass_of = [&](double r) { // in units of the largest
    const double relative = r / sorted.back();
    return relative * relative * relative;
  };
  double all = 0;
  for (const double r : sorted)
    all += mass_of(r);
  const auto diameter = [&](double share) {
    double mass = 0;
    for (const double r : sorted)
      if ((mass += mass_of(r)) >= share * all)
        return 2 * r;
    return 2 * sorted.back();
  };
  return {.d10 = diameter(0.1), .d50 = diameter(0.5), .d60 = diameter(0.6)};
}

double mean_radius_of(const Distribution& sizes, double d50) {
  require_positive("d50", d50, "m");
  return d50 / (2 * sizes.quantile(0.5, 3));
}

namespace {

using Numbers = std::span<const double>;

std::optional<double> second(Numbers numbers) {
  return numbers.size() > 1 ? std::optional(numbers[1]) : std::nullopt;
}

/// A form whose parameters are pure numbers.
struct Form {
  std::string_view name;
  std::string_view written; ///< for messages
  std::size_t fewest;
  std::size_t most;
  Distribution (*make)(Numbers numbers);
};

constexpr Form forms[] = {
    {"equal", "equal", 0, 0, [](Numbers) { return Distribution::equal(); }},
    {"bidisperse", "bidisperse:RATIO[:SHARE]", 1, 2,
     [](Numbers n) { return Distribution::bidisperse(n[0], second(n).value_or(0.5)); }},
    {"uniform", "uniform:SMALLEST:LARGEST", 2, 2,
     [](Numbers n) { return Distribution::uniform(n[0], n[1]); }},
    {"lognormal", "lognormal:SIGMA[:SIZE_RATIO]", 1, 2,
     [](Numbers n) { return Distribution::lognormal(n[0], second(n)); }},
    {"power-law", "power-law:EXPONENT:SIZE_RATIO", 2, 2,
     [](Numbers n) { return Distribution::power_law(n[0], n[1]); }},
    {"uniformity", "uniformity:C_U[:SIZE_RATIO]", 1, 2,
     [](Numbers n) { return Distribution::uniformity(n[0], second(n)); }},
};
constexpr std::string_view sieve_form = "sieve:D=PASSING:D=PASSING...";

[[noreturn]] void refuse(std::string_view text) {
  throw InvalidArgument("sizes '" + std::string(text) + "' are not one of " + distribution_forms());
}

/// The parts between the colons.
std::vector<std::string_view> split(std::string_view text) {
  std::vector<std::string_view> parts;
  while (true) {
    const std::size_t colon = text.find(':');
    parts.push_back(trimmed(text.substr(0, colon)));
    if (colon == std::string_view::npos)
      return parts;
    text.remove_prefix(colon + 1);
  }
}

Distribution parse_sieve(std::string_view text, std::span<const std::string_view> points) {
  std::vector<SievePoint> curve;
  for (const std::string_view point : points) {
    const std::size_t equals = point.find('=');
    if (equals == std::string_view::npos)
      refuse(text);
    curve.push_back(
        {.diameter = parse_quantity("sieve d", trimmed(point.substr(0, equals)), Dimension::length),
         .passing =
             parse_quantity("sieve passing", trimmed(point.substr(equals + 1)), Dimension::dimensionless)});
  }
  return Distribution::sieve(curve);
}

} // namespace

Distribution parse_distribution(std::string_view text) {
  const std::vector<std::string_view> parts = split(text);
  const std::span<const std::string_view> parameters(parts.begin() + 1, parts.end());
  if (parts.front() == "sieve")
    return parse_sieve(text, parameters);
  const auto* const form = std::find_if(std::begin(forms), std::end(forms),
                                        [&](const Form& f) { return f.name == parts.front(); });
  if (form == std::end(forms) || parameters.size() < form->fewest || parameters.size() > form->most)
    refuse(text);
  std::vector<double> numbers;
  for (const std::string_view parameter : parameters) {
    const std::optional<double> number = parse_number(parameter);
    if (!number)
      refuse(text);
    numbers.push_back(*number);
  }
  return form->make(numbers);
}

std::string distribution_forms() {
  std::string all;
  for (const Form& form : forms)
    all += std::string(form.written) + ", ";
  return all + std::string(sieve_form);
}

std::vector<double> sample_radii(const Distribution& sizes, std::size_t count, std::uint64_t seed,
                                 Drawing drawing) {
  boost::random::mt19937_64 bits(seed);
  boost::random::uniform_real_distribution<double> unit(0, 1);
  std::vector<double> radii(count);
  if (drawing == Drawing::plain) {
    for (std::size_t k = 0; k < count; ++k) {
      stop_point(k);
      radii[k] = sizes.quantile(unit(bits));
    }
    return radii;
  }
  for (std::size_t k = 0; k < count; ++k) {
    stop_point(k);
    radii[k] = sizes.quantile((static_cast<double>(k) + unit(bits)) / static_cast<double>(count));
  }
  for (std::size_t k = count; k > 1; --k) // the standard library's shuffle differs between vendors
    std::swap(radii[k - 1], radii[boost::random::uniform_int_distribution<std::size_t>(0, k - 1)(bits)]);
  return radii;
}

} // namespace granum::sizes

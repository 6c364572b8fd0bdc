// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

/// How large the grains of a packing are: distributions, their moments and sieve curves.
namespace granum::sizes {

/// A point of a sieve curve.
struct SievePoint {
  double diameter = 0; ///< d > 0, opening of the sieve [m]
  double passing = 0;  ///< share of the grains' mass that is finer, in [0, 1]
};

/// A part of the grains in quadrature: so many of them, all of one radius.
struct SizeNode {
  double radius = 0; ///< over the mean radius [1]
  double share = 0;  ///< of the number of grains [1]
};

/// Faults of a list of points as a sieve curve.
struct SieveFault {
  std::size_t point = 0; ///< counted from 0
  std::string what;
};

/// The first fault of a sieve curve: it needs two points or more, ascending d > 0 with d_last <= 1e6
/// d_first, and passing from exactly 0 to exactly 1, never less than before. Nothing if there is none.
/// Checked by tests/sizes/test_distribution.cpp
[[nodiscard]] std::optional<SieveFault> find_fault(std::span<const SievePoint> curve);

/// A distribution of grain radii x = r/<r>, each relative to the mean by number, so that <x> = 1: a size in
/// metres comes with the mean radius that it is used with. All grains are spheres of one material, so that
/// shares of mass are shares of volume.
/// Checked by tests/sizes/test_distribution.cpp
class Distribution {
 public:
  /// All grains of one radius: x = 1 to the bit, in every function.
  [[nodiscard]] static Distribution equal();
  /// Two radii.
  /// \param    ratio   large over small, in [1, 1e3]; equal() at 1
  /// \param    share   of large grains, by number, in (0, 1)
  /// \throws   InvalidArgument outside these ranges
  [[nodiscard]] static Distribution bidisperse(double ratio, double share = 0.5);
  /// The same number of grains for every step of radius.
  /// \param    smallest, largest   0 < smallest <= largest <= 1e3 smallest, in any unit; equal() if the same
  /// \throws   InvalidArgument outside that range
  [[nodiscard]] static Distribution uniform(double smallest, double largest);
  /// ln r normally distributed by number, with standard deviation sigma; hence ln r of the mass as well, with
  /// its mean 3 sigma^2 higher. Its tails are cut where they contain little: of the whole, 1 % of the number
  /// of grains below and 1 % of the mass above, which leaves the size ratio exp(3 sigma^2 + 4.65 sigma), 7.4
  /// for 0.35; or at a size ratio, about the same centre (equal losses of number below and mass above), but
  /// never beyond 9 standard deviations.
  /// \param    sigma        in [0, 1.2]; equal() at 0
  /// \param    size_ratio   largest over smallest radius, in (1, 1e6]
  /// \throws   InvalidArgument outside these ranges
  [[nodiscard]] static Distribution lognormal(double sigma, std::optional<double> size_ratio = std::nullopt);
  /// Density by number r^-exponent over a size ratio: 0 is uniform; 3.5, as crushed grains; 4 gives a sieve
  /// curve that is straight in log d.
  /// \param    exponent     in [-10, 10]
  /// \param    size_ratio   largest over smallest radius, in [1, 1e3]; equal() at 1
  /// \throws   InvalidArgument outside these ranges
  [[nodiscard]] static Distribution power_law(double exponent, double size_ratio);
  /// Lognormal by mass with the given uniformity coefficient C_u = d60/d10. The finest and the
  /// coarsest 5 % of the mass are cut off, which leaves the size ratio C_u^2.52: else the finest, which
  /// hardly touch, would be nearly all grains by number. Or it is cut at a size ratio, about the median by
  /// mass, but never beyond 9 standard deviations.
  /// \param    coefficient   C_u in [1, 20]; equal() at 1
  /// \param    size_ratio    largest over smallest radius, in (C_u^2, 1e6]
  /// \throws   InvalidArgument outside these ranges
  [[nodiscard]] static Distribution uniformity(double coefficient,
                                               std::optional<double> size_ratio = std::nullopt);
  /// A sieve curve, straight in log d between its points, as it is drawn: between two sieves the mass is
  /// spread evenly over ln d, the number as d^-4. It knows its mean radius.
  /// \throws   InvalidArgument with its first fault, as find_fault
  [[nodiscard]] static Distribution sieve(std::span<const SievePoint> curve);

  /// Mean radius by number of a sieve curve, whose sizes are absolute [m]; empty for the others.
  [[nodiscard]] std::optional<double> mean_radius() const { return mean_radius_; }
  /// Whether all grains have one radius.
  [[nodiscard]] bool is_equal() const { return smallest() == largest(); }
  /// Smallest and largest x.
  [[nodiscard]] double smallest() const { return parts_.front().low; }
  [[nodiscard]] double largest() const { return parts_.back().high; }
  /// Largest over smallest radius.
  [[nodiscard]] double size_ratio() const { return largest() / smallest(); }

  /// <x^k> by number [1]; any finite k. Accuracy  relative 1e-13 for |k| <= 6.
  [[nodiscard]] double moment(double k) const;
  /// Of all grains counted x^k times, the share that is smaller than or as small as x: k = 0 by number,
  /// k = 3 by mass [1]. Accuracy  1e-13.
  [[nodiscard]] double share_below(double x, double k = 0) const;
  /// The inverse of share_below: the x up to which grains have a given share in [0, 1].
  /// \throws   InvalidArgument for a share out of range
  /// Accuracy  relative 1e-12.
  [[nodiscard]] double quantile(double share, double k = 0) const;
  /// Points and weights for sums over the distribution: sum of share g(radius) is <g> by number.
  /// Accuracy  relative 1e-12 for smooth g, as x^k with |k| <= 6.
  [[nodiscard]] std::vector<SizeNode> nodes() const;

  /// How the distribution is written on a command line and in a scene; parse_distribution reads it back.
  [[nodiscard]] const std::string& text() const { return text_; }
  /// Of one text, so of one meaning to the bit.
  bool operator==(const Distribution& other) const { return text_ == other.text_; }

 private:
  /// A share of the grains, by number, with a density over t = ln x between low and high: Gaussian about
  /// `median` where deviation > 0, else x^slope; one radius where low is high.
  struct Part {
    double share = 1;
    double low = 1;
    double high = 1;
    double slope = 0;
    double deviation = 0;
    double median = 0;

    [[nodiscard]] bool is_one_radius() const { return low == high; }
    [[nodiscard]] double moment(double k) const;
    [[nodiscard]] double share_below(double x, double k) const;
    [[nodiscard]] double quantile(double share, double k) const;
    [[nodiscard]] double density(double t) const;
    void append_nodes(std::vector<SizeNode>& nodes) const;
  };

  Distribution(std::vector<Part> parts, std::string text);
  /// A lognormal of standard deviation sigma about 1 by number, cut at exp(centre -+ half_width).
  [[nodiscard]] static Part cut_lognormal(double sigma, double centre, double half_width);

  std::vector<Part> parts_; ///< ascending
  std::string text_;
  std::optional<double> mean_radius_;
};

/// The diameters that a sieve analysis names, by mass.
struct Gradation {
  double d10 = 0; ///< [m]
  double d50 = 0; ///< [m]
  double d60 = 0; ///< [m]

  /// C_u = d60/d10.
  [[nodiscard]] double uniformity() const { return d60 / d10; }
};

/// d10, d50 and d60 of a distribution.
/// \param    mean_radius   <r> by number > 0 [m]
/// \throws   InvalidArgument if the radius is not positive
/// Checked by tests/sizes/test_distribution.cpp
[[nodiscard]] Gradation gradation(const Distribution& sizes, double mean_radius);
/// The same of grains: the smallest diameter up to which grains have the share of the mass.
/// \param    radii   at least one, each > 0 [m]
/// \throws   InvalidArgument for no radii, or one that is not positive
/// Checked by tests/sizes/test_distribution.cpp
[[nodiscard]] Gradation gradation(std::span<const double> radii);

/// The mean radius by number <r> of grains with half of their mass finer than d50 [m].
/// \throws   InvalidArgument unless d50 > 0
/// Checked by tests/sizes/test_distribution.cpp
[[nodiscard]] double mean_radius_of(const Distribution& sizes, double d50);

/// The distribution that a text names, as command lines and scenes write it; Distribution::text() writes it
/// back.
///   equal
///   bidisperse:RATIO[:SHARE]          large over small radius, share of large grains by number (0.5)
///   uniform:SMALLEST:LARGEST          radii, in any unit, by number
///   lognormal:SIGMA[:SIZE_RATIO]      of ln r, by number
///   power-law:EXPONENT:SIZE_RATIO     density r^-EXPONENT by number
///   uniformity:C_U[:SIZE_RATIO]       lognormal by mass with d60/d10 = C_U
///   sieve:D=PASSING:D=PASSING...      d with its unit, passing 0 to 1 or with %
/// \throws   InvalidArgument for another text, listing these forms, and as the maker of the distribution
/// Checked by tests/sizes/test_distribution_text.cpp
[[nodiscard]] Distribution parse_distribution(std::string_view text);

/// The forms that parse_distribution knows, ", " between them, for messages and help.
[[nodiscard]] std::string distribution_forms();

/// How radii are drawn.
enum class Drawing {
  stratified, ///< one of each of N classes of equal number, shuffled: moments as near as N grains can be
  plain       ///< independently; a longer sample begins with the shorter
};

/// Radii x = r/<r> of grains, in no order. Random bits by Boost, then the quantile function: the same seed
/// gives the same bits on every machine for equal, bidisperse and uniform grains, elsewhere up to the last
/// digit of the C library's exp and log.
/// \param    count   number of grains, 0 allowed
/// \param    seed    any number; one seed, one sample
/// Accuracy  of moments: plain, the standard error of independent draws; stratified, far better for size
///           ratios up to 10. Beyond, few large grains have most of the mass: <x^3> of 20,000 grains of
///           uniformity:4 is 2 % off. Checked by tests/sizes/test_sampling.cpp
[[nodiscard]] std::vector<double> sample_radii(const Distribution& sizes, std::size_t count,
                                               std::uint64_t seed, Drawing drawing = Drawing::stratified);

} // namespace granum::sizes

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "studies/trade/trade.hpp"

/// Results of a study of speed against accuracy, plain power laws through the measured errors, and the
/// setting that each gives for a wanted accuracy.
/// Checked by tests/studies/test_trade_findings.cpp and tests/studies/test_trade_rule.cpp
namespace granum::studies {

/// How far specimens lie from the reference, in parts of it (G, peak) or in itself (s).
struct Deviation {
  double bias = 0;           ///< of the mean
  double standard_error = 0; ///< of the bias
  double scatter = 0;        ///< standard deviation of one specimen about the mean
};

/// All specimens of one value of one varied quantity.
struct TradeRow {
  Varied varied = Varied::grains;
  Boundary boundary = Boundary::periodic;
  double value = 0;
  triaxial::Density density = triaxial::Density::dense;
  std::size_t specimens = 0;
  bool reference = false;                 ///< the others of its quantity are compared with it
  std::optional<Deviation> shear_modulus; ///< of the geometric mean over the pressures
  std::optional<Deviation> exponent;
  std::optional<Deviation> peak_ratio;
  double cpu_seconds = 0; ///< mean of one specimen [s]
  double steps = 0;
};

/// The reference is the finest value: the most grains, the smallest rate or time step, the network for
/// probes, the largest periodic cell for walls. Where both have the same packings (all but grains and
/// boundary) specimens are compared each with itself, so that their scatter drops out of the bias and
/// `scatter` is that of the differences; otherwise the means are compared, with the standard deviation c
/// N^(-1/2) that all sizes of one boundary agree on. Fewer than two specimens on either side give no
/// deviation. Samples that failed do not count.
[[nodiscard]] std::vector<TradeRow> trade_rows(const std::vector<TradeSample>& samples);

/// Root mean square error of one specimen: bias and scatter; of settings that leave the packing as it is,
/// the bias alone.
/// Assumes   a row with a deviation of G
[[nodiscard]] double error_of(const TradeRow& row);

/// How many samples failed, the first of them, and why; empty where none did.
[[nodiscard]] std::string failures_text(const std::vector<TradeSample>& samples);

// ---- power laws

/// Error of one specimen of N grains: a standard deviation c N^(-1/2) between seeds, and a bias b/N of its
/// mean. Errors of G and of the peak are relative, those of s absolute.
struct SizeLaw {
  double scatter = 0;    ///< c
  double bias = 0;       ///< b
  double bias_error = 0; ///< standard error of b
  double smallest = 0;   ///< N that was measured; beyond smallest and largest the law is drawn out
  double largest = 0;
};

/// Bias k I of runs at inertial number I.
struct RateLaw {
  double bias = 0;       ///< k
  double bias_error = 0; ///< standard error of k
};

/// The laws of one quantity of one kind of specimen.
struct ErrorLaw {
  SizeLaw size;
  RateLaw rate; ///< of compression for G and s, of shear for the peak
};

struct TradeLaws {
  ErrorLaw dense_modulus, dense_exponent;
  ErrorLaw loose_modulus, loose_exponent;
  ErrorLaw dense_peak;
};

/// Least squares through the rows. c is fitted to all sizes, weighted by their numbers of specimens; b and k,
/// weighted by the standard errors, are slopes of the bias against 1/N and I, with the reference where its
/// own N and I put it.
/// Assumes   rows of trade_rows; missing quantities stay 0.
[[nodiscard]] TradeLaws laws_of(const std::vector<TradeRow>& rows);

/// The laws of validation/trade/, for spheres between 10 and 100 kPa.
[[nodiscard]] const TradeLaws& recorded_laws();

/// Errors of one specimen according to the laws: standard deviation between seeds, bias by size, bias by
/// rate.
/// \param    grains   >= 1
[[nodiscard]] double scatter_of(const ErrorLaw& law, double grains);
[[nodiscard]] double size_bias_of(const ErrorLaw& law, double grains);
[[nodiscard]] double rate_bias_of(const ErrorLaw& law, double inertial_number);

/// Root mean square error of the mean over some specimens.
/// \param    grains, specimens   >= 1
/// \throws   InvalidArgument for an inertial number that is negative, or no grains or specimens
[[nodiscard]] double expected_error(const ErrorLaw& law, std::size_t grains, std::size_t specimens,
                                    double inertial_number);

/// Settings for a required error of the mean over some specimens.
struct Recipe {
  std::size_t grains = 0;     ///< two significant digits, rounded up
  double inertial_number = 0; ///< largest with a bias within a third of the error
};

/// \param    error       > 0 [1]
/// \param    specimens   >= 1
/// \return   the inertial number is 0.01 at most, the largest measured
/// \throws   InvalidArgument for an error that is not positive, or no specimens
[[nodiscard]] Recipe recipe_for(const ErrorLaw& law, double error, std::size_t specimens);

} // namespace granum::studies

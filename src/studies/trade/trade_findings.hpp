// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "studies/trade/trade.hpp"

/// Results of a study of speed against accuracy.
/// Checked by tests/studies/test_trade_findings.cpp
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

} // namespace granum::studies

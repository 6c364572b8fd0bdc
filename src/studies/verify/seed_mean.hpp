// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include <granum/contact/laws.hpp>
#include <granum/triaxial/specimen.hpp>

namespace granum::studies {

/// A measured number, with its standard error where there is one: the larger of the scatter between seeds and
/// the mean error of each, over the root of the number of seeds.
struct TableValue {
  double value = 0;
  std::optional<double> standard_error;
};

/// Prior knowledge of the scatter between specimens of one kind.
struct KnownScatter {
  double deviation = 0;            ///< standard deviation of one specimen
  double degrees = 0;              ///< degrees of freedom of its measurement; 0: unknown
  std::optional<double> mean = {}; ///< of the same specimens; none for a contact that was not measured
};

/// Mean over several specimens. Its error is the larger of their scatter, pooled with what is known
/// of it, and their mean own error, over the root of their number; one specimen without an error of its own,
/// without a known scatter, has none. Nothing from none.
[[nodiscard]] std::optional<TableValue> mean_over_seeds(const std::vector<TableValue>& each,
                                                        const KnownScatter& known = {});

enum class ExponentRoute { closed_form, network, probe };

/// How much s of G ~ p^s differs from one specimen of N grains to another of the same kind, by 16 seeds of
/// 1,000 grains at ten pressures from 10 to 100 kPa (probed at three), times (1000/N)^(1/2). A regression
/// along one path does not know of it: for loose specimens its own error is a third of this. Power-law
/// contacts are treated as flat ones, which scatter most.
/// Source    validation/verify_default/scatter.csv
/// Checked by tests/studies/test_exponent_scatter.cpp
[[nodiscard]] KnownScatter exponent_scatter(contact::Shape contact, triaxial::Density density,
                                            ExponentRoute route, std::size_t grains);

} // namespace granum::studies

// SPDX-License-Identifier: GPL-3.0-or-later
// Numbers that carry their derivatives through the kernels.
#pragma once

#include <cmath>

#include <Eigen/Core>
#include <unsupported/Eigen/AutoDiff>

namespace granum::effective::kernel {

/// A number with its N derivatives.
template <int N>
using Dual = Eigen::AutoDiffScalar<Eigen::Matrix<double, N, 1>>;

template <int N>
Dual<N> power(const Dual<N>& x, double exponent) {
  const double value = std::exp(exponent * std::log(x.value()));
  return {value, x.derivatives() * (value * exponent / x.value())};
}

template <int N>
Dual<N> power(const Dual<N>& x, const Dual<N>& exponent) {
  const double log_x = std::log(x.value());
  const double value = std::exp(exponent.value() * log_x);
  return {value, x.derivatives() * (value * exponent.value() / x.value()) +
                     exponent.derivatives() * (value * log_x)};
}

} // namespace granum::effective::kernel

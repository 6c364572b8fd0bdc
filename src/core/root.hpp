// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <utility>

#include <boost/math/tools/toms748_solve.hpp>

/// Roots of functions of one number.
namespace granum {

/// Ends of the last interval in which a continuous function changes its sign; both are the root itself where
/// the function is exactly 0.
using RootInterval = std::pair<double, double>;

/// Near enough, where the ends agree within so many bits.
[[nodiscard]] inline auto within_bits(unsigned bits) {
  return boost::math::tools::eps_tolerance<double>(bits);
}

/// Near enough, where the ends of an interval above 0 differ by a share of the upper one.
[[nodiscard]] inline auto within_share(double share) {
  return [share](double low, double high) { return high - low <= share * high; };
}

/// Narrows the interval between low and high around a root, by algorithm 748 of ACM TOMS in Boost.Math.
/// \param    at_low, at_high   values of the function there, of different signs
/// \param    near              near(low, high): whether the ends are near enough
/// \param    most              calls of the function
/// Checked by tests/core/test_root.cpp
template <class Function, class Near>
[[nodiscard]] RootInterval root_between(const Function& function, double low, double high, double at_low,
                                        double at_high, const Near& near, std::uintmax_t most = 200) {
  return boost::math::tools::toms748_solve(function, low, high, at_low, at_high, near, most);
}
template <class Function, class Near>
[[nodiscard]] RootInterval root_between(const Function& function, double low, double high, const Near& near,
                                        std::uintmax_t most = 200) {
  return root_between(function, low, high, function(low), function(high), near, most);
}

/// The middle of an interval.
[[nodiscard]] inline double middle(const RootInterval& interval) {
  return (interval.first + interval.second) / 2;
}

} // namespace granum

// SPDX-License-Identifier: GPL-3.0-or-later
// Included by every source of a build with planted faults (tests/mutation/faults.py): fault n is awake where
// the environment variable GRANUM_FAULT is n. Constant expressions stay as they are.
#pragma once

#if __cplusplus >= 202002L // not where cmake tries the compiler
#include <cstdlib>
#include <type_traits>

namespace granum::planted {

inline int awake() {
  static const int number = [] {
    const char* const text = std::getenv("GRANUM_FAULT");
    return text == nullptr ? 0 : std::atoi(text);
  }();
  return number;
}

constexpr bool here(int n) { return !std::is_constant_evaluated() && awake() == n; }

/// Of a term: the other sign.
constexpr int sign(int n) { return here(n) ? -1 : 1; }
/// Of a term: left out.
constexpr int part(int n) { return here(n) ? 0 : 1; }
/// Of a condition: the opposite where true.
constexpr bool flip(int n) { return here(n); }
/// Of a number: a quarter more, and the next whole number.
template <class Number>
constexpr Number number(int n, Number x) {
  if constexpr (std::is_floating_point_v<Number>)
    return here(n) ? (x == 0 ? Number(1) : x * Number(1.25)) : x;
  else
    return here(n) ? Number(x + 1) : x;
}
/// Of an index: its neighbour.
constexpr int index(int n, int k) { return here(n) ? (k == 0 ? 1 : k - 1) : k; }
/// Of a unit: a thousand times.
constexpr double unit(int n, double x) { return here(n) ? 1000 * x : x; }
/// Of the larger and the smaller of two: the other one.
template <class Number>
constexpr Number larger(int n, const Number& a, const Number& b) {
  return here(n) != (a < b) ? b : a;
}
template <class Number>
constexpr Number smaller(int n, const Number& a, const Number& b) {
  return here(n) != (b < a) ? b : a;
}

} // namespace granum::planted
#endif

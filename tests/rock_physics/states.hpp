// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <initializer_list>
#include <limits>

#include <doctest/doctest.h>
#include <granum/core/error.hpp>

namespace granum::test {

template <class State>
State with(State state, double State::*member, double value) {
  state.*member = value;
  return state;
}

/// Each member is refused where it is no number, negative or infinite.
template <class State, class Model>
void check_refused(const State& good, std::initializer_list<double State::*> members, const Model& model) {
  using Limits = std::numeric_limits<double>;
  for (const auto member : members)
    for (const double bad : {Limits::quiet_NaN(), -1.0, Limits::infinity()})
      CHECK_THROWS_AS((void)model(with(good, member, bad)), InvalidArgument);
}

} // namespace granum::test

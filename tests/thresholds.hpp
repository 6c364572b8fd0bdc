// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <doctest/doctest.h>

#include <granum/core/error.hpp>

/// One note comes or goes, and nothing else changes, as a value passes a threshold.
/// \param    notes   number of notes at a value
template <class Notes>
void check_threshold(double threshold, const Notes& notes) {
  CAPTURE(threshold);
  const auto below = notes(0.995 * threshold), above = notes(1.005 * threshold);
  CHECK((below < above ? above - below : below - above) == 1);
}

/// 1 if an action is refused, else 0.
template <class Action>
int refusals(const Action& action) {
  try {
    action();
  } catch (const granum::Error&) {
    return 1;
  }
  return 0;
}

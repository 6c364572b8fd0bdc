// SPDX-License-Identifier: GPL-3.0-or-later
// Notation: (3-a) P(t) = linear t + cubic t^3.
#include <granum/fabric/polar_distribution.hpp>

#include <algorithm>

#include <granum/core/error.hpp>

namespace granum::fabric {

double cumulative_probability(double polar_cosine, double anisotropy) {
  const double t = require_closed("polar_cosine", polar_cosine, 0, 1);
  const double a = require_closed("fabric_anisotropy", anisotropy, -1, 1);
  return t * (3 * (1 - a) + 2 * a * (t * t)) / (3 - a);
}

double polar_cosine_quantile(double probability, double anisotropy) {
  require_closed("probability", probability, 0, 1);
  const double a = require_closed("fabric_anisotropy", anisotropy, -1, 1);
  if (probability == 0 || probability == 1)
    return probability;
  const double linear = 3 * (1 - a), cubic = 2 * a, target = (3 - a) * probability;
  // Newton's rule from the root of the linear term alone. P is convex for a >= 0, where that root or 1 is an
  // upper bound, and concave for a < 0, where it is a lower one: the iterates run one way until rounding
  // stops them.
  double t = target < linear ? target / linear : 1;
  for (;;) {
    const double square = t * t;
    const double slope = linear + 3 * cubic * square;
    if (slope <= 0) // t = 1 at a = -1
      return t;
    const double next = std::min(t - (t * (linear + cubic * square) - target) / slope, 1.0);
    if (a >= 0 ? !(next < t) : !(next > t))
      return t;
    t = next;
  }
}

} // namespace granum::fabric

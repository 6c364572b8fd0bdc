// SPDX-License-Identifier: GPL-3.0-or-later
// Notation: a_c coefficient of P2 in the density (1 + a_c P2)/(4 pi), in [-1, 2] for a in [-1, 1]; x values
// of P2 on the sample.
#include <granum/fabric/likelihood_estimate.hpp>

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include <granum/core/stop.hpp>
#include <granum/fabric/measures.hpp>

#include "normals.hpp"

namespace granum::fabric {

namespace {

constexpr double lowest = -1, highest = 2; // a_c of a = -1 and a = 1

/// First derivative of the log-likelihood and minus the second. Where a boundary density vanishes in the
/// direction of a contact, the score there is infinite, with the sign that sends the maximum inside.
struct Slopes {
  double score = 0;
  double information = 0;
};

Slopes slopes(const std::vector<double>& x, double a_c) {
  stop_point();
  Slopes sum;
  for (const double value : x) {
    const double ratio = value / (1 + a_c * value);
    sum.score += ratio;
    sum.information += ratio * ratio;
  }
  return sum;
}

double most_likely(const std::vector<double>& x) {
  if (slopes(x, highest).score >= 0)
    return highest;
  if (slopes(x, lowest).score <= 0)
    return lowest;
  double low = lowest, high = highest, a_c = 0;
  for (int i = 0; i < 100; ++i) { // halving alone would need fifty
    const Slopes at = slopes(x, a_c);
    (at.score > 0 ? low : high) = a_c;
    double next = a_c + at.score / at.information;
    if (!(next > low && next < high))
      next = low + (high - low) / 2;
    const double step = std::abs(next - a_c);
    a_c = next;
    if (step <= 1e-15)
      break;
  }
  return a_c;
}

/// ln L - ln L(isotropic)
double gain(const std::vector<double>& x, double a_c) {
  stop_point();
  double sum = 0;
  for (const double value : x)
    sum += std::log1p(a_c * value);
  return sum;
}

} // namespace

LikelihoodEstimate estimate_anisotropy_by_likelihood(std::span<const Vec3> normals) {
  require_normals(normals, 2);
  std::vector<double> x(normals.size());
  std::transform(normals.begin(), normals.end(), x.begin(), legendre_2);

  LikelihoodEstimate estimate;
  estimate.contacts = normals.size();
  // Contacts along the diagonals of a cube, as in a body-centred lattice, have P2 = 0: any a is as likely.
  const bool flat = std::all_of(x.begin(), x.end(), [](double value) { return std::abs(value) < 1e-12; });
  const double a_c = flat ? 0 : most_likely(x);
  const double information = flat ? 0 : slopes(x, a_c).information;
  estimate.anisotropy = measures_from_P2_coefficient(a_c).anisotropy;
  estimate.standard_error = information > 0 ? 12 / ((4 + a_c) * (4 + a_c)) / std::sqrt(information)
                                            : std::numeric_limits<double>::infinity();
  estimate.log_likelihood_gain = std::max(gain(x, a_c), 0.0);
  estimate.at_boundary = a_c == lowest || a_c == highest;
  if (estimate.at_boundary)
    estimate.validity.add("the likelihood of the fabric anisotropy is largest at the end of [-1, 1]: the "
                          "contacts may be more strongly oriented than E(gamma; a) can describe");
  if (estimate.standard_error > 1)
    estimate.validity.add(
        "the contact directions barely constrain the fabric anisotropy: its standard error is "
        "above 1");
  return estimate;
}

} // namespace granum::fabric

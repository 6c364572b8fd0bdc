// SPDX-License-Identifier: GPL-3.0-or-later
#include <granum/effective/slip.hpp>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

#include <granum/core/error.hpp>
#include <granum/core/numerics.hpp>
#include <granum/effective/relaxation.hpp>

#include "kernels.hpp"

namespace granum::effective {

namespace {

/// Density of x = f/<f>, 27/2 x^2 exp(-3 x): its moments are Gamma(3 + power)/(2 3^power).
double force_moment(double power) { return std::tgamma(3 + power) / (2 * std::pow(3, power)); }

/// Loss of contacts of one force that slide at displacement c: the mean of u^2 - u c over displacements u >
/// c, u^2 exponentially distributed, over <u^2>; q = c/sqrt(<u^2>).
double shed_by_sliding(double q) {
  return std::exp(-q * q) - std::sqrt(std::numbers::pi) / 2 * q * std::erfc(q);
}

/// The same over all forces; k_t grows as x^b, and the limiting displacement as x^(1-b).
double shed_by_sliding(const SlipOnset& onset, double root_mean_square) {
  static const std::vector<QuadratureNode> rule = gauss_legendre(64);
  constexpr double most = 2.3; // of w = x^(1/3): beyond, exp(-3 x) is 1e-16
  double sum = 0;
  for (const QuadratureNode& node : rule) {
    const double w = most / 2 * (1 + node.abscissa), x = w * w * w;
    const double share = 13.5 * x * x * std::exp(-3 * x) * 3 * w * w * most / 2 * node.weight;
    sum += share * std::pow(x, onset.exponent) *
           shed_by_sliding(std::pow(x, 1 - onset.exponent) / root_mean_square);
  }
  return sum / force_moment(onset.exponent);
}

/// A contact sheds u/6 of its limit's displacement, of Mindlin's (1 - (1 - 2u/3)^(3/2))/u to first order.
double shed_by_partial_slip(const SlipOnset& onset, double root_mean_square) {
  return std::tgamma(2.5) * root_mean_square / 6 * force_moment(2 * onset.exponent - 1) /
         force_moment(onset.exponent);
}

} // namespace

SlipOnset slip_onset(const State& state, double mechanical_coordination_number, double friction_coefficient) {
  require_positive("friction_coefficient", friction_coefficient);
  const auto geometry = kernel::checked_geometry(state);
  kernel::require_contacts(state);
  const double r = require_positive("tangential_ratio", state.tangential_ratio),
               z = mechanical_coordination_number;
  require_positive("mean_stress", state.mean_stress(), "Pa");
  const double b = contact_exponent(state);
  const auto factor = [&](double ratio) {
    return relaxation(z, ratio, b, state.law.surface().stiffening).shear.value;
  };
  const double least = isostatic_coordination_number(r), h = factor(r);
  if (!(h > 0))
    throw InvalidArgument("mechanical_coordination_number", z, "",
                          "above that of a packing that is just rigid");
  constexpr double step = 2e-3; // of ln r: truncation and rounding of the difference are both 1e-13
  const auto logarithm = [&](double steps) { return std::log(factor(r * std::exp(steps * step))); };
  const double slope = (8 * (logarithm(1) - logarithm(-1)) - (logarithm(2) - logarithm(-2))) / (12 * step);
  const double share = 3 * r / (2 + 3 * r) + slope;
  const double force = mean_contact_force(state);
  const double stiffness = kernel::contact_stiffness(state.law, geometry.force_area, 3 * state.mean_stress());
  return {.reference_strain =
              friction_coefficient * force / (r * stiffness * 2 * state.radius * state.contacts.branch),
          .tangential_share = share,
          .mean_square = share * h * (1.0 / 15 + r / 10) / r,
          .amplification = z / (z - least),
          .exponent = b};
}

double slip_loss(const SlipOnset& onset, double strain, ContactSlip slip) {
  require_non_negative("strain", strain);
  if (strain == 0)
    return 0;
  const double size = strain / onset.reference_strain * std::sqrt(onset.mean_square);
  const double shed =
      slip == ContactSlip::sliding ? shed_by_sliding(onset, size) : shed_by_partial_slip(onset, size);
  return std::min(1.0, onset.amplification * onset.tangential_share * shed);
}

double strain_of_slip_loss(const SlipOnset& onset, double loss) {
  if (!(loss > 0 && loss <= largest_slip_loss))
    throw InvalidArgument("loss", loss, "", "(0, 0.05]");
  return loss / slip_loss(onset, onset.reference_strain * 1e-6, ContactSlip::partial) *
         onset.reference_strain * 1e-6; // it is proportional to the strain
}

} // namespace granum::effective

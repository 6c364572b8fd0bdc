// SPDX-License-Identifier: GPL-3.0-or-later
#include <granum/effective/relaxation.hpp>

#include <algorithm>
#include <cmath>
#include <string>

#include <Eigen/Core>
#include <unsupported/Eigen/AutoDiff>

#include <granum/core/error.hpp>
#include <granum/core/text.hpp>
#include <granum/effective/uniform_field.hpp>
#include <granum/fabric/orientation.hpp>

#include "kernels.hpp"
#include "mixture_kernel.hpp"
#include "relaxation_kernel.hpp"
#include "relaxed_constants.hpp"
#include "unevenness_kernel.hpp"

namespace granum::effective {

namespace {

using kernel::frictionless_isostatic;

/// A relaxation factor; all zero where the packing is not rigid.
struct RelaxingFactor {
  double value = 0;
  double error = 0;           ///< relative standard error
  double by_coordination = 0; ///< d value/d z*
  double by_ratio = 0;        ///< d value/d r
};

struct RelaxingFactors {
  RelaxingFactor shear;
  RelaxingFactor bulk;
};

/// ln of the stretch along the axis.
struct Stretch {
  double logarithm = 0;
  double error = 0; ///< standard error of the logarithm
};

// Range of the calibration; see validation/relaxation/README.md.
constexpr double smallest_coordination = 4.1, largest_coordination = 8.7;
constexpr double smallest_ratio = 0.1, largest_ratio = 1;
constexpr double largest_overlap = 0.055;
/// Far beyond it the factors no longer change, and powers of larger numbers would overflow.
constexpr double infinite = 1e9;
constexpr double largest_stress_ratio = 2.2, largest_anisotropy = 0.25;
/// Standard deviation of branch lengths over their mean, at C_u = 4.
constexpr double largest_branch_deviation = 0.51;
/// A factor with its derivatives by its n coefficients, then by z* and r.
template <std::size_t n>
using Dual = Eigen::AutoDiffScalar<Eigen::Matrix<double, static_cast<int>(n) + 2, 1>>;

template <std::size_t n>
Dual<n> variable(double value, std::size_t index) {
  return {value, static_cast<int>(n) + 2, static_cast<int>(index)};
}

template <std::size_t n>
Dual<n> constant(double value) {
  return {value, Dual<n>::DerType::Zero()};
}

template <std::size_t n>
std::array<Dual<n>, n> variables(const std::array<double, n>& values) {
  std::array<Dual<n>, n> duals;
  for (std::size_t k = 0; k < n; ++k)
    duals[k] = variable<n>(values[k], k);
  return duals;
}

/// The error includes that of the coefficients only.
template <std::size_t n>
RelaxingFactor with_slopes(const Dual<n>& factor, const double (&covariance)[n][n]) {
  constexpr int size = static_cast<int>(n);
  const double h = factor.value();
  if (!(h > 0))
    return {};
  const auto& slopes = factor.derivatives();
  const Eigen::Map<const Eigen::Matrix<double, size, size>> matrix(&covariance[0][0]);
  const auto by_coefficients = slopes.template head<size>();
  return {.value = h,
          .error = std::sqrt(by_coefficients.dot(matrix * by_coefficients)) / h,
          .by_coordination = slopes[size],
          .by_ratio = slopes[size + 1]};
}

/// Adds the scatter between recipes and between packings of a recipe, which acts on a variable with the
/// derivative `leverage`.
RelaxingFactor with_scatter(RelaxingFactor factor, const kernel::Scatter& recipes,
                            const kernel::Scatter& packings, double leverage) {
  if (factor.value > 0)
    for (const kernel::Scatter& scatter : {recipes, packings})
      factor.error = std::hypot(factor.error, scatter.base, scatter.gain * leverage / factor.value);
  return factor;
}

/// Adds the effect of unequal grains.
RelaxingFactor with_size_scatter(RelaxingFactor factor, const kernel::Scatter& sizes, double shift_error,
                                 double leverage, double variance) {
  if (factor.value > 0 && variance > 0) {
    const double deviation = std::sqrt(variance), relative = leverage / factor.value;
    factor.error = std::hypot(factor.error, deviation * sizes.base, deviation * sizes.gain * relative);
    factor.error = std::hypot(factor.error, variance * shift_error * relative);
  }
  return factor;
}

/// Scatters of both factors.
struct Scatters {
  kernel::FactorScatter shear, bulk;
};

kernel::Scatter mixed(const kernel::Scatter& a, const kernel::Scatter& b, double share) {
  return {std::lerp(a.base, b.base, share), std::lerp(a.gain, b.gain, share)};
}
kernel::FactorScatter mixed(const kernel::FactorScatter& a, const kernel::FactorScatter& b, double share) {
  return {mixed(a.recipes, b.recipes, share), mixed(a.packings, b.packings, share),
          mixed(a.sizes, b.sizes, share)};
}
/// \param    known   share to which the unevenness of forces is known
Scatters scatters(double known) {
  return {.shear = mixed(kernel::shear_scatter, kernel::shear_scatter_known, known),
          .bulk = mixed(kernel::bulk_scatter, kernel::bulk_scatter_known, known)};
}

/// Adds the error of what rolling resistance makes of a factor.
/// \param    without   the factor without it
RelaxingFactor with_rolling_error(RelaxingFactor factor, double without, double error) {
  if (factor.value > 0)
    factor.error = std::hypot(factor.error, error * std::sqrt(std::max(0.0, 1 - without / factor.value)));
  return factor;
}

/// \param    b     up to 1/2
/// \param    k_r   rolling stiffness over k_n R*^2
RelaxingFactor shear_factor(double z, double r, double b, double k_r, const kernel::FactorScatter& scatter) {
  constexpr std::size_t n = kernel::shear_coefficients.size();
  const Dual<n> h = kernel::rolled_shear_relaxation(variable<n>(z, n), variable<n>(r, n + 1), constant<n>(b),
                                                    variables(kernel::shear_coefficients), k_r);
  RelaxingFactor factor = with_slopes<n>(h, kernel::shear_covariance);
  factor = with_scatter(factor, scatter.recipes, scatter.packings, factor.by_coordination);
  if (!(k_r > 0))
    return factor;
  const double without = kernel::shear_relaxation(z, r, b, kernel::shear_coefficients);
  return with_rolling_error(factor, without, kernel::rolling_errors[0]);
}

RelaxingFactor bulk_factor(double z, double r, const kernel::ByExponent<double>& b, double k_r,
                           double branch_variance, const kernel::FactorScatter& scatter) {
  constexpr std::size_t n = kernel::bulk_coefficients.size();
  const std::array<Dual<n>, n> coefficients = variables(kernel::bulk_coefficients);
  const Dual<n> Z = variable<n>(z, n);
  const kernel::ByExponent<Dual<n>> B{constant<n>(b.own), constant<n>(b.lost), constant<n>(b.scatter_left)};
  const Dual<n> equal = kernel::stiffened_bulk(Z, variable<n>(r, n + 1), B, coefficients, k_r);
  const Dual<n> share =
      kernel::size_bulk_share(Z, B, constant<n>(kernel::size_loss), branch_variance, coefficients);
  RelaxingFactor factor = with_slopes<n>(equal * share, kernel::bulk_covariance);
  factor = with_scatter(factor, scatter.recipes, scatter.packings, r * factor.by_ratio);
  factor.error = std::hypot(factor.error, kernel::bulk_codes * kernel::looseness(z));
  const double lost = (1 - share.value()) / kernel::size_loss; // of a loss of 1
  factor.error = std::hypot(factor.error, lost * kernel::size_loss_error);
  factor.error = std::hypot(factor.error, kernel::bulk_size_measure(branch_variance) * scatter.sizes.base);
  if (!(k_r > 0))
    return factor;
  const double without = kernel::stiffened_bulk(z, r, b, kernel::bulk_coefficients);
  return with_rolling_error(factor, without * share.value(), kernel::rolling_errors[1]);
}

double isostatic(double r) {
  return r > 0 ? kernel::frictional_isostatic(kernel::shear_coefficients) : frictionless_isostatic;
}

/// Remarks on a z* >= 0, r >= 0 and k_r >= 0.
Validity notes_of(double z, double r, double k_r = 0) {
  Validity validity;
  if (!(z > isostatic(r)))
    validity.add(
        detail::formatted(
            "z* = %.4g is not above the isostatic point %.4g: such a network of contacts is not rigid", z,
            isostatic(r)) +
        (k_r > 0 ? " without rolling resistance, and nothing was fitted there with it" : ""));
  if (z < smallest_coordination || z > largest_coordination)
    validity.add(detail::formatted("z* is %.3g: the relaxation factors are calibrated from 4.1 to 8.7", z));
  if (r > largest_ratio)
    validity.add(detail::formatted("k_t/k_n is %.3g: the relaxation factors are calibrated up to 1", r));
  if (r > 0 && r < smallest_ratio)
    validity.add(
        detail::formatted("k_t/k_n is %.3g: between 0 and 0.1 the relaxation factor of K depends on the "
                          "tangential forces in the packing, which are not known",
                          r));
  return validity;
}

double log_stress_ratio(const State& s) { return s.stress_h > 0 ? std::log(s.stress_v / s.stress_h) : 0; }

Stretch stretch_of(const State& s, double shear) {
  const fabric::SecondMoments F = fabric::second_moments(s.fabric_anisotropy);
  const double b = kernel::up_to_half(kernel::local_exponent(s));
  const double log_fabric = std::log(F.F33 / F.F11), log_stress = log_stress_ratio(s);
  const double logarithm =
      kernel::log_stretch(shear, b, log_fabric, log_stress, kernel::stretch_coefficients);
  const Eigen::Vector2d slopes = (1 - shear) * Eigen::Vector2d(log_fabric, b * log_stress);
  const Eigen::Map<const Eigen::Matrix2d> covariance(&kernel::stretch_covariance[0][0]);
  const double scatter = kernel::stretch_scatter * logarithm;
  return {.logarithm = logarithm, .error = std::sqrt(slopes.dot(covariance * slopes) + scatter * scatter)};
}

void note_state(const State& s, double z, double overlap, Validity& validity) {
  const double C_n = *s.coordination_number;
  if (z < 0.99 * C_n)
    validity.add(
        detail::formatted("z* = %.4g is smaller than C_n = %.4g: taking rattlers out cannot lower the "
                          "coordination number",
                          z, C_n));
  if (overlap > largest_overlap)
    validity.add(detail::formatted(
        "mean overlap is %.3g diameters: the relaxation factors were tested up to 0.055", overlap));
  const double ratio = s.stress_h > 0 ? std::max(s.stress_v / s.stress_h, s.stress_h / s.stress_v) : 1;
  if (ratio > largest_stress_ratio || std::abs(s.fabric_anisotropy) > largest_anisotropy)
    validity.add(detail::formatted(
        "stress ratio %.3g (larger over smaller stress) or fabric anisotropy %.3g is beyond the range in "
        "which the relaxation of anisotropic packings was validated (2.2 and 0.25)",
        ratio, s.fabric_anisotropy));
}

void note_sizes(const State& s, Validity& validity) {
  const double deviation = std::sqrt(kernel::branch_variance(s.contacts));
  if (deviation > 0 && !s.pair_shares.empty())
    validity.add(
        "grains of several sizes and materials: where the sizes go with the materials, rung 3 is up to a "
        "quarter too soft at 1:100, which its error includes");
  if (deviation > largest_branch_deviation)
    validity.add(detail::formatted(
        "the lengths of branches scatter by %.2g of their mean: the relaxation factors are calibrated up to "
        "0.51, counted in packings with C_u = 4; estimated from sizes alone, C_u = 3 has as much",
        deviation));
}

void note_bound(const kernel::RelaxedConstants<double>& strained,
                const kernel::RelaxedConstants<double>& unbounded, Validity& validity) {
  const double excess = kernel::bulk_modulus(unbounded) / kernel::bulk_modulus(strained) - 1;
  if (excess > 1e-12)
    validity.add(detail::formatted(
        "the relaxed K would be %.2g %% above that of uniform strain, its upper bound: all moduli "
        "are scaled down to that",
        100 * excess));
}

struct StiffContacts {
  double exponent; ///< b
  contact::Stiffening stiffening;
  double rolling = 0; ///< k_r

  [[nodiscard]] const kernel::GoingOn& going_on() const { return kernel::going_on(stiffening); }
  [[nodiscard]] kernel::ByExponent<double> effect() const {
    return kernel::by_exponent(exponent, going_on());
  }
};

StiffContacts contacts_of(const State& s) {
  return {
      .exponent = kernel::local_exponent(s), .stiffening = s.law.surface().stiffening, .rolling = s.rolling};
}

/// Subtracts from the factor of G its loss beyond the b of the packings of the fit, and adds the uncertainty
/// of this range to the errors of both.
RelaxingFactors with_stiffening(RelaxingFactors factors, const StiffContacts& contacts) {
  const double h = factors.shear.value;
  factors.shear.value *= kernel::left_of_shear(h, contacts.effect());
  const double unknown = (1 - h) * kernel::share_beyond(contacts.exponent, contacts.going_on().from);
  const auto& [shear, bulk] = contacts.going_on().errors;
  factors.shear.error = std::hypot(factors.shear.error, shear * unknown);
  factors.bulk.error = std::hypot(factors.bulk.error, bulk * unknown);
  return factors;
}

/// Both factors at z* >= 0, r >= 0, 0 <= b <= 1, not checked.
/// \param    branch_variance   as the kernel's function of that name; 0 for equal grains
RelaxingFactors relaxing_factors(double z, double r, const StiffContacts& contacts, double branch_variance,
                                 const Scatters& scatter) {
  if (!(z > isostatic(r)))
    return {};
  const double near_z = std::min(z, infinite), near_r = std::min(r, infinite);
  const Dual<0> of_equal = kernel::coordination_of_equal(variable<0>(near_z, 0), branch_variance);
  const kernel::ByExponent<double> b = contacts.effect();
  RelaxingFactor shear = shear_factor(of_equal.value(), near_r, b.own, contacts.rolling, scatter.shear);
  shear = with_size_scatter(shear, scatter.shear.sizes, kernel::looseness(near_z) * kernel::size_shift_error,
                            shear.by_coordination, branch_variance);
  return with_stiffening(
      {.shear = shear,
       .bulk = bulk_factor(near_z, near_r, b, contacts.rolling, branch_variance, scatter.bulk)},
      contacts);
}

/// Multiplies both factors by what the unevenness of forces says.
/// \param    known   share to which it does
void add_unevenness(const State& s, double z, double known, RelaxingFactors& factors) {
  if (!(known > 0 && factors.shear.value > 0))
    return;
  const double h = factors.shear.value, b = kernel::local_exponent(s), near_z = std::min(z, infinite),
               v = kernel::branch_variance(s.contacts);
  for (const auto& [factor, c] :
       {std::pair{&factors.shear, &kernel::shear_gain}, std::pair{&factors.bulk, &kernel::bulk_gain}}) {
    factor->value *= std::exp(known * kernel::gain_by_unevenness(s.unevenness->value, h, b, near_z, v, *c));
    const double slope = (*c)[0] + (*c)[1] * std::sqrt(v);
    factor->error = std::hypot(factor->error, known * slope * s.unevenness->standard_error);
  }
}

/// The same for a state; the errors include the effect of unequal stresses.
RelaxingFactors relaxing_factors(const State& s, double z) {
  const double known = s.unevenness ? kernel::share_of_unevenness(z) : 0;
  RelaxingFactors factors = relaxing_factors(z, s.tangential_ratio, contacts_of(s),
                                             kernel::branch_variance(s.contacts), scatters(known));
  add_unevenness(s, z, known, factors);
  const double stresses = std::abs(log_stress_ratio(s));
  factors.shear.error = std::hypot(factors.shear.error, kernel::shear_by_stress * stresses);
  factors.bulk.error = std::hypot(factors.bulk.error, kernel::bulk_by_stress * stresses);
  return factors;
}

/// Multiplies both factors by what several materials leave of the mean stiffness of their contacts.
void add_mixture(const State& s, double z, RelaxingFactors& factors) {
  const double root_variance = std::sqrt(kernel::branch_variance(s.contacts));
  for (const auto& [factor, mixing] :
       {std::pair{&factors.shear, &kernel::shear_mixing}, std::pair{&factors.bulk, &kernel::bulk_mixing}}) {
    const double left = kernel::left_by_mixing(s.pair_shares, z, *mixing).left;
    factor->value *= left;
    const double scatter = std::hypot(mixing->error, mixing->size_error * root_variance);
    factor->error = std::hypot(factor->error, scatter * std::log(left));
  }
}

/// The stiffness at branches that overlaps shorten.
kernel::RelaxedConstants<double> with_shortened_branches(const kernel::RelaxedConstants<double>& c,
                                                         double overlap, double b) {
  const double left = kernel::shortened_branches(std::min(overlap, kernel::longest_shortening), b);
  return {left * c.C11, left * c.C33, left * c.C12, left * c.C13, left * c.C44};
}

RelaxationFactor published(const RelaxingFactor& factor) { return {factor.value, factor.error}; }

} // namespace

double mechanical_coordination_number(double coordination_number, double rattler_fraction) {
  require_non_negative("coordination_number", coordination_number);
  require_closed("rattler_fraction", rattler_fraction, 0, 1);
  require_positive("1 - rattler_fraction", 1 - rattler_fraction);
  return coordination_number / (1 - rattler_fraction);
}

double isostatic_coordination_number(double tangential_ratio) {
  return isostatic(require_non_negative("tangential_ratio", tangential_ratio));
}

double scatter_share_of_preparation() {
  constexpr double recipes = kernel::shear_scatter.recipes.base,
                   packings = kernel::shear_scatter.packings.base;
  return recipes * recipes / (recipes * recipes + packings * packings);
}

Relaxation relaxation(double mechanical_coordination_number, double tangential_ratio,
                      double stiffness_exponent, contact::Stiffening stiffening) {
  const double z = require_non_negative("mechanical_coordination_number", mechanical_coordination_number);
  const double r = require_non_negative("tangential_ratio", tangential_ratio);
  const double b = require_closed("stiffness_exponent", stiffness_exponent, 0, 1);
  const RelaxingFactors factors =
      relaxing_factors(z, r, {.exponent = b, .stiffening = stiffening}, 0, scatters(0));
  return {.shear = published(factors.shear), .bulk = published(factors.bulk), .validity = notes_of(z, r)};
}

Unevenness dense_unevenness(const State& state, std::optional<double> preparation_pressure) {
  constexpr double usual_share = 0.1, share_error = 0.25; // of the scatter of the first forces that is left
  const double force = mean_contact_force(state), p = state.mean_stress();
  if (preparation_pressure && !(require_positive("preparation_pressure", *preparation_pressure, "Pa") <= p))
    throw InvalidArgument("preparation_pressure", *preparation_pressure, "Pa",
                          "at most the mean stress, " + short_text(p));
  const auto faded = [&](double pressure) {
    const double before = state.law.overlap(force * (pressure / p)) / state.law.overlap(force);
    return before * before;
  };
  const double b = kernel::local_exponent(state), v = kernel::branch_variance(state.contacts),
               left = preparation_pressure ? faded(*preparation_pressure) : usual_share,
               ratio = (state.stress_v - state.stress_h) / p,
               by_share = kernel::dense_unevenness[2] * b * (1 - b);
  const auto& [of_equal, of_others] = kernel::dense_unevenness_scatter;
  Unevenness dense{.value = kernel::unevenness_of_dense(b, left, v, ratio, kernel::dense_unevenness),
                   .standard_error = std::hypot(of_equal, of_others * std::sqrt(v),
                                                preparation_pressure ? 0.0 : share_error * by_share),
                   .by_pressure = -2 * kernel::overlap_exponent(state.law, force) * by_share * left};
  const double z = state.mechanical_coordination_number.value_or(kernel::dense_coordination);
  const double share = kernel::smooth_step((z - kernel::least_dense_coordination) /
                                           (kernel::dense_coordination - kernel::least_dense_coordination));
  if (share == 1)
    return dense;
  const double h =
      relaxing_factors(z, state.tangential_ratio, contacts_of(state), v, scatters(0)).shear.value;
  return {.value = std::lerp(kernel::usual_unevenness(h, b, z, v, kernel::shear_gain), dense.value, share),
          .standard_error = std::lerp(kernel::usual_unevenness_scatter, dense.standard_error, share),
          .by_pressure = share * dense.by_pressure};
}

RelaxedEstimate relaxed(const State& state, double mechanical_coordination_number) {
  const Estimate uniform = uniform_strain(state);
  const double z = require_non_negative("mechanical_coordination_number", mechanical_coordination_number);
  RelaxingFactors factors = relaxing_factors(state, z);
  const Stretch stretch = stretch_of(state, factors.shear.value);
  if (!state.pair_shares.empty())
    add_mixture(state, z, factors);
  const auto& [shear, bulk] = factors;
  RelaxedEstimate estimate{.stiffness = {}, .relative_error = {}, .validity = uniform.validity};
  estimate.validity.merge(notes_of(z, state.tangential_ratio, state.rolling));
  const double overlap = kernel::mean_overlap(state);
  note_state(state, z, overlap, estimate.validity);
  note_sizes(state, estimate.validity);
  if (!(shear.value > 0))
    return estimate;
  const elastic::TransverselyIsotropic& u = uniform.stiffness;
  const kernel::RelaxedConstants<double> strained{u.C11, u.C33, u.C12, u.C13, u.C44};
  const kernel::RelaxedConstants<double> c =
      with_shortened_branches(kernel::relax(strained, bulk.value, shear.value, stretch.logarithm), overlap,
                              kernel::local_exponent(state));
  note_bound(strained, kernel::unbounded_relax(strained, bulk.value, shear.value, stretch.logarithm),
             estimate.validity);
  estimate.stiffness = {.C11 = c.C11, .C33 = c.C33, .C12 = c.C12, .C13 = c.C13, .C44 = c.C44};
  estimate.relative_error = {.bulk_modulus = bulk.error,
                             .G_hh = std::hypot(shear.error, stretch.error / 3),
                             .G_vh = std::hypot(shear.error, stretch.error / 6)};
  return estimate;
}

} // namespace granum::effective

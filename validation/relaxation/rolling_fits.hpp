// SPDX-License-Identifier: GPL-3.0-or-later
// The recorded networks with rolling resistance, and the fit of what that adds to G and K.
#pragma once

#include <granum/effective/relaxation.hpp>

#include "../common.hpp"
#include "least_squares.hpp"
#include "reading.hpp"
#include "recording.hpp"

namespace relaxation {

inline constexpr double rolling_ratios[] = {0, 0.003, 0.01, 0.03, 0.1, 0.3, 0.6, 1}; ///< k_r
inline constexpr double rolled_tangential_ratios[] = {0.1, 0.3, no_slip_ratio};      ///< k_t/k_n
inline constexpr double least_judged_ratio = 0.3; ///< k_t/k_n from which on errors are stated

inline std::string rolling_suffix(double tangential_ratio, double rolling_ratio) {
  return short_number(tangential_ratio) + "_" + short_number(rolling_ratio);
}

/// One packing with one k_t/k_n and one k_r, beside the same without k_r.
struct Rolled {
  State state; ///< with k_t/k_n, z* and the unevenness of the forces, without k_r
  double k_r = 0;
  TransverselyIsotropic without, with;
  bool isotropic = true, fitted = false;

  [[nodiscard]] double z() const { return state.mechanical_coordination_number.value(); }
  [[nodiscard]] State rolled() const {
    State resisting = state;
    resisting.rolling = k_r;
    return resisting;
  }
  [[nodiscard]] double shear_gain() const {
    return std::log(isotropic_shear_modulus(with) / isotropic_shear_modulus(without));
  }
  [[nodiscard]] double bulk_gain() const { return std::log(with.bulk_modulus() / without.bulk_modulus()); }
};

inline std::vector<Rolled> read_rolled(const std::string& path) {
  std::vector<Rolled> all;
  for (const Entry& row : read_record(path)) {
    Packing p = detail::packing(row, row.text("contact"), row.text("preparation"), 0);
    const double K = detail::stiffness(row, "affine").bulk_modulus();
    p.state.mechanical_coordination_number = p.mechanical_coordination;
    p.state.unevenness =
        granum::effective::Unevenness{.value = std::log(K / detail::closed_strain_bulk_modulus(p, true))};
    for (const double r : rolled_tangential_ratios)
      for (const double k_r : rolling_ratios)
        if (k_r > 0) {
          all.push_back({.state = p.state,
                         .k_r = k_r,
                         .without = detail::stiffness(row, rolling_suffix(r, 0)),
                         .with = detail::stiffness(row, rolling_suffix(r, k_r)),
                         .isotropic = row("stress_ratio") == 0,
                         .fitted = p.seed % 2 == 0});
          all.back().state.tangential_ratio = r;
        }
  }
  return all;
}

struct RollingFit {
  Fit<5> shear;
  Fit<3> bulk;
};

/// Real grains have k_t/k_n from 0.6 to 1.
inline double rolling_weight(const Rolled& one) {
  const double r = one.state.tangential_ratio;
  return r > 0.5 ? 2 : r > 0.2 ? 1 : 0.5;
}

/// ln of the curve of G with k_r over that without.
template <class T>
T shear_gain_of_curve(const Rolled& one, const std::array<T, 5>& c) {
  using std::log;
  namespace kernel = granum::effective::kernel;
  const T z(kernel::coordination_of_equal(one.z(), kernel::branch_variance(one.state.contacts))),
      r(one.state.tangential_ratio), b(one.state.law.constant_exponent().value());
  const auto own = kernel::constants<T>(kernel::shear_coefficients);
  return log(
      T(kernel::rolled_shear_relaxation(z, r, b, own, one.k_r, c) / kernel::shear_relaxation(z, r, b, own)));
}

template <class T>
T bulk_gain_of_curve(const Rolled& one, const std::array<T, 3>& c) {
  using std::log;
  namespace kernel = granum::effective::kernel;
  const T z(one.z()), r(one.state.tangential_ratio);
  const auto b = kernel::own_exponent(T(one.state.law.constant_exponent().value()));
  const auto own = kernel::constants<T>(kernel::bulk_coefficients);
  return log(T(kernel::stiffened_bulk(z, r, b, own, one.k_r, c) / kernel::stiffened_bulk(z, r, b, own)));
}

inline RollingFit fit_rolling(const std::vector<Rolled>& all) {
  std::vector<Observation<5>> shear;
  std::vector<Observation<3>> bulk;
  for (const Rolled& one : all) {
    if (!one.fitted || !one.isotropic)
      continue;
    const std::string packing = std::to_string(one.z());
    shear.push_back({.model = [one](const auto& c) { return shear_gain_of_curve(one, c); },
                     .target = one.shear_gain(),
                     .weight = rolling_weight(one),
                     .group = packing});
    bulk.push_back({.model = [one](const auto& c) { return bulk_gain_of_curve(one, c); },
                    .target = one.bulk_gain(),
                    .weight = rolling_weight(one),
                    .group = packing});
  }
  return {.shear = least_squares<5>(std::move(shear), {0.8, 0.7, 5.4, -0.2, 4.1}),
          .bulk = least_squares<3>(std::move(bulk), {1.3, 0.4, 3.6})};
}

/// Errors of packings left out of the fit over the root of the share of G or K that k_r makes.
inline std::array<double, 2> rolling_errors(const std::vector<Rolled>& all, const RollingFit& fit) {
  Errors shear, bulk;
  for (const Rolled& one : all) {
    if (one.fitted || !one.isotropic || one.state.tangential_ratio < least_judged_ratio)
      continue;
    const double G = shear_gain_of_curve(one, fit.shear.coefficients),
                 K = bulk_gain_of_curve(one, fit.bulk.coefficients);
    shear.add((G - one.shear_gain()) / std::sqrt(1 - std::exp(-G)));
    bulk.add((K - one.bulk_gain()) / std::sqrt(1 - std::exp(-K)));
  }
  return {shear.rms(), bulk.rms()};
}

} // namespace relaxation

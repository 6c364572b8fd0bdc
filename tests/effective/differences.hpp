// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cmath>
#include <functional>
#include <vector>

#include <granum/effective/sensitivity/gradients.hpp>

#include "support.hpp"

/// Derivatives by differences, against which gradients are tested.
namespace granum::test {

inline const std::vector<effective::Modulus> all_moduli{
    effective::Modulus::K,   effective::Modulus::G_hh, effective::Modulus::G_vh,
    effective::Modulus::E_v, effective::Modulus::E_h,  effective::Modulus::C11,
    effective::Modulus::C33, effective::Modulus::C12,  effective::Modulus::C13};

/// A packing by the numbers that a user gives.
struct Numbers {
  double alpha, profile, shear, poisson, ratio, radius, voids, contacts, anisotropy, stress_v, stress_h;
  double z = 0; ///< mechanical coordination number
};

inline State state_from(const Numbers& x) {
  return {.law = contact::PowerLaw::general({x.shear, x.poisson}, x.alpha, x.profile),
          .tangential_ratio = x.ratio,
          .radius = x.radius,
          .void_ratio = x.voids,
          .coordination_number = x.contacts,
          .fabric_anisotropy = x.anisotropy,
          .stress_v = x.stress_v,
          .stress_h = x.stress_h};
}

/// An input, by how much to move it for its size, and how it is moved.
struct Move {
  effective::Input input;
  double size;
  std::function<void(Numbers&, double)> by;
};

inline std::vector<Move> moves(const Numbers& x) {
  const double p = (x.stress_v + 2 * x.stress_h) / 3;
  return {{effective::Input::mean_stress, p,
           [p](Numbers& n, double d) {
             n.stress_v *= 1 + d / p;
             n.stress_h *= 1 + d / p;
           }},
          {effective::Input::stress_v, x.stress_v, [](Numbers& n, double d) { n.stress_v += d; }},
          {effective::Input::stress_h, x.stress_h, [](Numbers& n, double d) { n.stress_h += d; }},
          {effective::Input::coordination_number, x.contacts, [](Numbers& n, double d) { n.contacts += d; }},
          {effective::Input::void_ratio, x.voids, [](Numbers& n, double d) { n.voids += d; }},
          {effective::Input::fabric_anisotropy, 1, [](Numbers& n, double d) { n.anisotropy += d; }},
          {effective::Input::alpha, x.alpha, [](Numbers& n, double d) { n.alpha += d; }},
          {effective::Input::grain_shear_modulus, x.shear, [](Numbers& n, double d) { n.shear += d; }},
          {effective::Input::grain_poisson_ratio, 1, [](Numbers& n, double d) { n.poisson += d; }},
          {effective::Input::grain_poisson_ratio_mindlin, 1,
           [](Numbers& n, double d) {
             n.poisson += d;
             n.ratio = contact::mindlin_stiffness_ratio(n.poisson);
           }},
          {effective::Input::tangential_ratio, 1, [](Numbers& n, double d) { n.ratio += d; }},
          {effective::Input::radius, x.radius, [](Numbers& n, double d) { n.radius += d; }}};
}

/// Central differences at three steps, the longest 4e-3 of the size, extrapolated to an error of sixth order.
template <class Value>
double difference_quotient(const Numbers& x, const Move& move, const Value& value) {
  const auto central = [&](double step) {
    Numbers low = x, high = x;
    move.by(low, -step);
    move.by(high, step);
    return (value(high) - value(low)) / (2 * step);
  };
  const double h = 4e-3 * move.size;
  const double d1 = central(h), d2 = central(h / 2), d4 = central(h / 4);
  const double fine = (4 * d4 - d2) / 3, coarse = (4 * d2 - d1) / 3;
  return (16 * fine - coarse) / 15;
}

} // namespace granum::test

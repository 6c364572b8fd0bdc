// SPDX-License-Identifier: GPL-3.0-or-later
// The exponent s of recorded paths: networks beside what the library says of their growth.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <map>
#include <string>
#include <vector>

#include <granum/effective/exponents.hpp>
#include <granum/effective/relaxation.hpp>
#include <granum/hardin/fit.hpp>

#include "packings.hpp"

namespace relaxation {

inline granum::effective::MeasuredPacking measured(const Packing& p) {
  return {.pressure = p.pressure,
          .coordination_number = *p.state.coordination_number,
          .mechanical_coordination_number = p.mechanical_coordination,
          .void_ratio = p.state.void_ratio};
}

inline double own_shear_modulus(const Packing& p) {
  for (const Network& n : p.networks)
    if (n.ratio == p.state.tangential_ratio)
      return isotropic_shear_modulus(n.stiffness);
  throw std::runtime_error("no network of the specimen's own stiffness");
}

/// Pressure at which friction came on in the specimens [Pa].
inline constexpr double first_pressure = 10e3;

/// The state with the forces that the preparation left, if it is dense.
inline State remembering(State state, const Packing& p) {
  if (p.preparation == "dense")
    state.unevenness = granum::effective::dense_unevenness(state, first_pressure);
  return state;
}

/// s from 10 to 100 kPa at the middle of the path, the growth of C_n and z* given by its two ends.
inline double exponent_by_growth(const Packing& first, const Packing& last) {
  State state = last.state;
  state.stress_v = state.stress_h = std::sqrt(first.pressure * last.pressure);
  state.coordination_number = std::sqrt(*first.state.coordination_number * *last.state.coordination_number);
  state.void_ratio = (first.state.void_ratio + last.state.void_ratio) / 2;
  state.fabric_anisotropy = 0;
  const double z = (first.mechanical_coordination + last.mechanical_coordination) / 2;
  return granum::effective::relaxed_exponents(
             remembering(state, last), z, granum::effective::growth_between(measured(first), measured(last)),
             granum::effective::Modulus::G_vh)
      .sum();
}

/// The same from a closing-gap law alone.
inline double exponent_by_law(const Packing& last, const granum::effective::ClosingGapLaw& law) {
  State state = last.state;
  const double middle = std::sqrt(10e3 * 100e3);
  state.stress_v = state.stress_h = middle;
  state.fabric_anisotropy = 0;
  const auto packing = granum::effective::predict_packing(law, state, middle);
  state.coordination_number = packing.coordination_number;
  return granum::effective::relaxed_exponents(remembering(state, last),
                                              packing.mechanical_coordination_number, packing.growth,
                                              granum::effective::Modulus::G_vh)
      .sum();
}

/// s of a path, fitted as `granum verify` does.
inline double fitted_exponent(const std::vector<const Packing*>& path) {
  std::vector<granum::hardin::MeasuredModulus> rows;
  for (const Packing* p : path)
    rows.push_back({own_shear_modulus(*p), {p->pressure, p->pressure, p->state.void_ratio}});
  return granum::hardin::fit_exponent_sum(rows,
                                          {.atmospheric_pressure = 100e3,
                                           .void_ratio_function = granum::hardin::VoidRatioFunction::none,
                                           .weights = granum::hardin::Weights::absolute})
      .fit()
      .exponent_sum.value;
}

/// Largest differences between the fitted s and the predicted one.
struct ExponentErrors {
  double dense = 0, loose = 0;
};

/// Prints s of every specimen with states from 10 to 100 kPa.
inline ExponentErrors compare_exponents(const std::vector<Packing>& packings) {
  std::printf("exponent s of G, 10 to 100 kPa: network by its ends, by the fit of verify; by the growth "
              "found; by the "
              "closing-gap law\n");
  std::map<std::string, std::vector<const Packing*>> paths;
  for (const Packing& p : packings)
    if (p.pressure <= 100e3 && p.isotropic() && p.preparation != "cycle")
      paths[p.contact + " " + p.preparation + " #" + std::to_string(p.seed)].push_back(&p);
  ExponentErrors errors;
  for (auto& [name, path] : paths) {
    std::ranges::sort(path, {}, &Packing::pressure);
    const Packing &first = *path.front(), &last = *path.back();
    if (first.pressure != 10e3 || last.pressure != 100e3)
      continue;
    const double predicted = exponent_by_growth(first, last);
    std::printf("  %-24s %.3f", name.c_str(),
                std::log(own_shear_modulus(last) / own_shear_modulus(first)) / std::log(10.0));
    if (path.size() < 3) {
      std::printf("         %.3f\n", predicted);
      continue;
    }
    const double network = fitted_exponent(path);
    std::printf("  %.3f  %.3f", network, predicted);
    const bool dense = first.preparation == "dense", loose = first.preparation == "loose";
    if (dense || loose) {
      double& worst = dense ? errors.dense : errors.loose;
      worst = std::max(worst, std::abs(predicted - network));
      std::printf("  %.3f", exponent_by_law(last, dense ? granum::effective::dense_closing_gaps()
                                                        : granum::effective::loose_closing_gaps()));
    }
    std::printf("\n");
  }
  std::printf("  largest difference, growth given: dense %.3f, loose %.3f\n", errors.dense, errors.loose);
  return errors;
}

} // namespace relaxation

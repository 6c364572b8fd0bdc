// SPDX-License-Identifier: GPL-3.0-or-later
// The exponent s of recorded paths: networks beside what the library says of their growth.
#pragma once

#include <granum/effective/exponents.hpp>
#include <granum/effective/relaxation.hpp>
#include <granum/hardin/fit.hpp>

#include "../common.hpp"
#include "packings.hpp"

namespace relaxation {

inline double own_shear_modulus(const Packing& p) {
  for (const Network& n : p.networks)
    if (n.ratio == p.state.tangential_ratio)
      return isotropic_shear_modulus(n.stiffness);
  throw std::runtime_error("no network of the specimen's own stiffness");
}

/// s at the middle of a path from 10 kPa, where friction came on, to 100 kPa: the growth of C_n and z* given
/// by its two ends, or by a closing-gap law alone. Dense packings have the forces that the preparation left.
inline double predicted_exponent(const Packing& first, const Packing& last,
                                 const granum::effective::ClosingGapLaw* law = nullptr) {
  namespace effective = granum::effective;
  State state = last.state;
  const double middle = std::sqrt(first.pressure * last.pressure);
  state.stress_v = state.stress_h = middle;
  state.fabric_anisotropy = 0;
  const auto s_of = [&](double z, const effective::Growth& growth) {
    if (last.preparation == "dense")
      state.unevenness = effective::dense_unevenness(state, first.pressure);
    return effective::relaxed_exponents(state, z, growth, effective::Modulus::G_vh).sum();
  };
  if (law != nullptr) {
    const auto packing = effective::predict_packing(*law, state, middle);
    state.coordination_number = packing.coordination_number;
    return s_of(packing.mechanical_coordination_number, packing.growth);
  }
  const auto measured = [](const Packing& p) -> effective::MeasuredPacking {
    return {.pressure = p.pressure,
            .coordination_number = *p.state.coordination_number,
            .mechanical_coordination_number = p.mechanical_coordination,
            .void_ratio = p.state.void_ratio};
  };
  state.coordination_number = std::sqrt(*first.state.coordination_number * *last.state.coordination_number);
  state.void_ratio = (first.state.void_ratio + last.state.void_ratio) / 2;
  return s_of((first.mechanical_coordination + last.mechanical_coordination) / 2,
              effective::growth_between(measured(first), measured(last)));
}

/// s of moduli, fitted as `granum verify` does.
inline double fitted_exponent(const std::vector<granum::hardin::MeasuredModulus>& rows) {
  return granum::hardin::fit_exponent_sum(rows,
                                          {.atmospheric_pressure = 100e3,
                                           .void_ratio_function = granum::hardin::VoidRatioFunction::none,
                                           .weights = granum::hardin::Weights::absolute})
      .fit()
      .exponent_sum.value;
}

/// Prints s of every specimen with states from 10 to 100 kPa.
/// \return   largest difference of the fitted s from the predicted one, of dense and of loose ones
inline std::map<std::string, double> compare_exponents(const std::vector<Packing>& packings) {
  namespace effective = granum::effective;
  std::printf("exponent s of G, 10 to 100 kPa: network by its ends, by the fit of verify; by the growth "
              "found; by the closing-gap law\n");
  std::map<std::string, std::vector<const Packing*>> paths;
  for (const Packing& p : packings)
    if (p.pressure <= 100e3 && p.isotropic() && p.preparation != "cycle")
      paths[p.contact + " " + p.preparation + " #" + std::to_string(p.seed)].push_back(&p);
  const std::map<std::string, effective::ClosingGapLaw> laws{{"dense", effective::dense_closing_gaps()},
                                                             {"loose", effective::loose_closing_gaps()}};
  std::map<std::string, double> worst;
  for (auto& [name, path] : paths) {
    std::ranges::sort(path, {}, &Packing::pressure);
    const Packing &first = *path.front(), &last = *path.back();
    if (first.pressure != 10e3 || last.pressure != 100e3)
      continue;
    const double by_growth = predicted_exponent(first, last);
    std::printf("  %-24s %.3f", name.c_str(),
                std::log(own_shear_modulus(last) / own_shear_modulus(first)) / std::log(10.0));
    std::vector<granum::hardin::MeasuredModulus> rows;
    for (const Packing* p : path)
      rows.push_back({own_shear_modulus(*p), {p->pressure, p->pressure, p->state.void_ratio}});
    if (path.size() >= 3)
      std::printf("  %.3f  %.3f", fitted_exponent(rows), by_growth);
    else
      std::printf("         %.3f", by_growth);
    if (const auto law = laws.find(first.preparation); law != laws.end() && path.size() >= 3) {
      double& largest = worst[first.preparation];
      largest = std::max(largest, std::abs(by_growth - fitted_exponent(rows)));
      std::printf("  %.3f", predicted_exponent(first, last, &law->second));
    }
    std::printf("\n");
  }
  std::printf("  largest difference, growth given: dense %.3f, loose %.3f\n", worst["dense"], worst["loose"]);
  return worst;
}

} // namespace relaxation

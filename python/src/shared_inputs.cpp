// SPDX-License-Identifier: GPL-3.0-or-later
#include "shared_inputs.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

#include <granum/core/check.hpp>
#include <granum/core/error.hpp>

namespace granum::python {

namespace {

enum class Input { shear_modulus, poisson_ratio, tangential_ratio, void_ratio, fabric, density };

/// In the order in which the program adds them up.
constexpr std::pair<const char*, Input> inputs[] = {
    {"grain_shear_modulus", Input::shear_modulus}, {"grain_poisson_ratio", Input::poisson_ratio},
    {"tangential_ratio", Input::tangential_ratio}, {"void_ratio", Input::void_ratio},
    {"fabric_anisotropy", Input::fabric},          {"grain_density", Input::density}};

/// An input and its standard deviation, relative to the value if that is positive by definition.
struct Uncertain {
  Input input;
  double deviation = 0;
};

double value_of(Input input, const effective::State& state, double density) {
  switch (input) {
  case Input::shear_modulus:
    return state.law.grain().shear_modulus;
  case Input::tangential_ratio:
    return state.tangential_ratio;
  case Input::void_ratio:
    return state.void_ratio;
  case Input::density:
    return density;
  case Input::poisson_ratio:
  case Input::fabric:
    break;
  }
  return 1; // changed by the deviation itself
}

} // namespace

inverse::SharedInputs shared_inputs(const std::map<std::string, double>& deviations,
                                    const effective::State& first, double grain_density,
                                    bool tangential_ratio) {
  inverse::SharedInputs out;
  std::vector<Uncertain> uncertain;
  for (const auto& [name, input] : inputs)
    if (const auto found = deviations.find(name); found != deviations.end()) {
      require_non_negative("uncertainty of " + found->first, found->second);
      out.keys.emplace_back(name);
      uncertain.push_back({input, found->second / value_of(input, first, grain_density)});
    }
  for (const auto& [name, deviation] : deviations)
    if (std::find(out.keys.begin(), out.keys.end(), name) == out.keys.end())
      throw InvalidArgument("uncertainty: " + name + " is not an input common to all measurements");
  out.move = [uncertain, tangential_ratio](effective::State& state, double& density,
                                           std::span<const double> by) {
    contact::GrainMaterial grain = state.law.grain();
    for (std::size_t k = 0; k < uncertain.size(); ++k) {
      const double change = uncertain[k].deviation * by[k], factor = std::exp(change);
      switch (uncertain[k].input) {
      case Input::shear_modulus:
        grain.shear_modulus *= factor;
        break;
      case Input::poisson_ratio:
        grain.poisson_ratio += change;
        break;
      case Input::tangential_ratio:
        state.tangential_ratio *= factor;
        break;
      case Input::void_ratio:
        state.void_ratio *= factor;
        break;
      case Input::fabric:
        state.fabric_anisotropy += change;
        break;
      case Input::density:
        density *= factor;
        break;
      }
    }
    if (grain != state.law.grain()) {
      state.law = state.law.of_grain(grain);
      if (!tangential_ratio)
        state.tangential_ratio = contact::mindlin_stiffness_ratio(grain.poisson_ratio);
    }
  };
  return out;
}

} // namespace granum::python

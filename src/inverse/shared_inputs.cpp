// SPDX-License-Identifier: GPL-3.0-or-later
#include <granum/inverse/shared_inputs.hpp>

#include <cmath>

namespace granum::inverse {

namespace {

using effective::State;
using estimate::Input;
using estimate::InputRow;
using estimate::InputValues;

bool is_shared(const InputRow& row) {
  switch (row.input) {
  case Input::grain_shear_modulus:
  case Input::grain_poisson_ratio:
  case Input::grain_bulk_modulus:
  case Input::radius:
  case Input::d50:
  case Input::tangential_ratio:
  case Input::void_ratio:
  case Input::porosity:
  case Input::solid_fraction:
  case Input::fabric:
  case Input::grain_density:
    return true;
  default:
    return row.law != nullptr;
  }
}

/// An input that may be changed, and its standard deviation.
struct Uncertain {
  Input input;
  double deviation = 0;
};

double moved(const InputValues& values, const Uncertain& one, double deviations) {
  const double value = values.number(one.input);
  const bool positive = value > 0 && one.input != Input::fabric && one.input != Input::grain_poisson_ratio;
  return positive ? value * std::exp(one.deviation / value * deviations) : value + one.deviation * deviations;
}

State state_at_any_stress(const InputValues& values) {
  constexpr double any_stress = 1e5; // neither law nor density depends on it
  return state_of(values, {any_stress, any_stress});
}

void move_all(const InputValues& before, const std::vector<Uncertain>& uncertain,
              std::span<const double> deviations, State& state, double& density) {
  InputValues after = before;
  for (std::size_t k = 0; k < uncertain.size(); ++k)
    if (uncertain[k].input == Input::grain_density)
      density *= std::exp(uncertain[k].deviation / density * deviations[k]);
    else
      after.set(uncertain[k].input, moved(after, uncertain[k], deviations[k]));
  const State from = state_at_any_stress(before), to = state_at_any_stress(after);
  state.law = to.law;
  state.tangential_ratio = to.tangential_ratio;
  state.radius = to.radius;
  state.contacts = to.contacts;
  state.fabric_anisotropy += to.fabric_anisotropy - from.fabric_anisotropy;
  state.void_ratio *= to.void_ratio / from.void_ratio;
}

} // namespace

std::vector<const InputRow*> shared_rows(const InputValues& completed) {
  std::vector<const InputRow*> rows;
  for (const InputRow* const row : estimate::uncertain_rows())
    if (is_shared(*row) && in_use(completed, *row) &&
        !(completed.law && (row->input == Input::radius || row->input == Input::d50))) // sizes are the law's
      rows.push_back(row);
  return rows;
}

SharedInputs shared_inputs(const InputValues& completed, std::span<const estimate::UncertainInput> inputs) {
  SharedInputs out;
  std::vector<Uncertain> uncertain;
  for (const estimate::UncertainInput& one : inputs) {
    const InputRow& row = estimate::uncertain_row(one.input);
    if (!is_shared(row))
      continue;
    out.keys.push_back(one.input);
    uncertain.push_back({row.input, one.deviation});
  }
  out.move = [completed, uncertain](State& state, double& density, std::span<const double> deviations) {
    move_all(completed, uncertain, deviations, state, density);
  };
  return out;
}

} // namespace granum::inverse

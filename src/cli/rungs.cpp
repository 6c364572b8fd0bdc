// SPDX-License-Identifier: GPL-3.0-or-later
#include "rungs.hpp"

#include <algorithm>
#include <cmath>

#include <granum/core/error.hpp>
#include <granum/effective/relaxed_exponents.hpp>
#include <granum/effective/uniform_field.hpp>

namespace granum::cli {

namespace {

using effective::State;
using elastic::TransverselyIsotropic;

constexpr effective::Modulus G_hv = effective::Modulus::G_vh; // equal, by the symmetry of the stiffness

/// The state at which exponents are taken: they depend on the stress ratio alone, which at zero stress is
/// that of the isotropic path.
State loaded(State state) {
  if (state.stress_v == 0 && state.stress_h == 0)
    state.stress_v = state.stress_h = 1;
  return state;
}

/// Exponents where there are contacts that they could be of.
using ExponentsOf = effective::StressExponents (*)(const State& state, effective::Modulus which);
std::optional<effective::StressExponents> exponents(ExponentsOf of, const State& state) {
  return state.coordination_number > 0 ? std::optional(of(loaded(state), G_hv)) : std::nullopt;
}

effective::StressExponents exponents_at_mean_force(const State& at, effective::Modulus) {
  const double share_v = at.stress_v / (at.stress_v + 2 * at.stress_h);
  const double b = at.law.stiffness_exponent();
  return {.stress_v = b * share_v, .stress_h = b * (1 - share_v)};
}

/// Contacts of one stiffness, that of the mean force, which grows with the mean stress p' alone: a modulus
/// goes as p'^b, and stress_v and stress_h share b as they share 3 p'. No contacts, no stiffness.
FieldAnswer at_mean_force(const State& state) {
  TransverselyIsotropic stiffness;
  if (state.coordination_number > 0)
    stiffness = effective::uniform_strain_stiffness(effective::uniform_contacts(state));
  return {.stiffness = stiffness,
          .exponents = exponents(exponents_at_mean_force, state),
          .validity = effective::require_valid(state)};
}

FieldAnswer fabric_at_mean_force(const Packing& packing) { return at_mean_force(packing.state); }

FieldAnswer isotropic(const Packing& packing) {
  State without_fabric = packing.state;
  without_fabric.fabric_anisotropy = 0;
  return at_mean_force(without_fabric);
}

FieldAnswer directional(const Packing& packing) {
  const State& state = packing.state;
  effective::Estimate estimate = effective::uniform_strain(state);
  return {.stiffness = estimate.stiffness,
          .exponents = exponents(effective::uniform_strain_exponents, state),
          .validity = std::move(estimate.validity)};
}

FieldAnswer uniform_stress(const Packing& packing) {
  const State& state = packing.state;
  effective::Estimate estimate = effective::uniform_stress(state);
  FieldAnswer answer{
      .stiffness = estimate.stiffness, .exponents = std::nullopt, .validity = std::move(estimate.validity)};
  if (state.tangential_ratio > 0)
    answer.exponents = exponents(effective::uniform_stress_exponents, state);
  return answer;
}

/// Exponents at frozen contacts: they do not know how C_n and z* grow.
FieldAnswer relaxed(const Packing& packing) {
  const double z = *packing.mechanical_coordination_number;
  effective::RelaxedEstimate estimate = effective::relaxed(packing.state, z);
  FieldAnswer answer{.stiffness = estimate.stiffness,
                     .exponents = std::nullopt,
                     .validity = std::move(estimate.validity),
                     .relative_error = estimate.relative_error};
  if (estimate.stiffness.C44 > 0)
    answer.exponents = effective::relaxed_exponents(loaded(packing.state), z, {}, G_hv);
  return answer;
}

constexpr Rung rungs[] = {
    {"0", "rung0", "uniform strain, isotropic, every contact at the mean force", "nothing more", false,
     isotropic},
    {"1", "rung1", "uniform strain with fabric, every contact at the mean force", "a", false,
     fabric_at_mean_force},
    {"2", "rung2", "uniform strain with fabric, contacts as stiff as the force in their direction",
     "a, sigma_v, sigma_h", false, directional},
    {"3", "rung3", "rung 2 relaxed, as contact networks of this coordination do", "z* as well", true,
     relaxed},
    {"uniform-stress", "uniform_stress", "uniform stress with fabric and forces as rung 2",
     "a, sigma_v, sigma_h", false, uniform_stress},
};

const Rung& rung(std::string_view key) {
  return *std::find_if(std::begin(rungs), std::end(rungs), [key](const Rung& r) { return key == r.key; });
}

} // namespace

std::optional<double> young_modulus(const TransverselyIsotropic& stiffness, Loading loading) {
  if (stiffness.positive_definite())
    return loading == Loading::vertical ? stiffness.E_v() : stiffness.E_h();
  const bool without_shear_stiffness = stiffness.C44 == 0 && stiffness.C66() == 0;
  return without_shear_stiffness ? std::optional(0.0) : std::nullopt;
}

std::span<const Rung> all_rungs() { return rungs; }

FieldAnswer answer(const Rung& rung, const Packing& packing) {
  if (rung.needs_mechanical_coordination_number && !packing.mechanical_coordination_number)
    throw InvalidArgument(std::string("rung ") + rung.key +
                          " needs z*: give --mechanical-coordination-number or --rattler-fraction");
  FieldAnswer answer = rung.answer(packing);
  const TransverselyIsotropic& c = answer.stiffness;
  for (const double value : {c.C11, c.C33, c.C12, c.C13, c.C44})
    if (!std::isfinite(value))
      throw InvalidArgument("the moduli exceed what a double can hold; check the units of the inputs");
  return answer;
}

const Rung& uniform_strain_rung() { return rung("2"); }
const Rung& uniform_stress_rung() { return rung("uniform-stress"); }
const Rung& relaxed_rung() { return rung("3"); }

void keep_each_once(Validity& validity) {
  std::vector<std::string> once;
  for (const std::string& note : validity.notes)
    if (std::find(once.begin(), once.end(), note) == once.end())
      once.push_back(note);
  validity.notes = once;
}

} // namespace granum::cli

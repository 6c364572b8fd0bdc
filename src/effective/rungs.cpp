// SPDX-License-Identifier: GPL-3.0-or-later
#include <granum/effective/rungs.hpp>

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>

#include <granum/core/error.hpp>
#include <granum/effective/exponents.hpp>

#include "stress_derivatives.hpp"

namespace granum::effective {

namespace {

constexpr Model mean_force{.hypothesis = Hypothesis::uniform_strain, .forces = ContactForces::mean};
constexpr Model uniform_strain_model{.hypothesis = Hypothesis::uniform_strain};
constexpr Model uniform_stress_model{.hypothesis = Hypothesis::uniform_stress};

// ---- uniform fields

template <const Model& model>
RungAnswer field(const State& packing) {
  Estimate estimate = uniform_field(packing, model);
  return {.stiffness = estimate.stiffness, .validity = std::move(estimate.validity)};
}
template <const Model& model>
StressExponents field_exponents(const State& packing, Modulus which) {
  return uniform_field_exponents(packing, model, which);
}

// ---- rung 0: rung 1 without fabric

State without_fabric(State packing) {
  packing.fabric_anisotropy = 0;
  return packing;
}
RungAnswer isotropic(const State& packing) { return field<mean_force>(without_fabric(packing)); }
StressExponents isotropic_exponents(const State& packing, Modulus which) {
  return field_exponents<mean_force>(without_fabric(packing), which);
}

// ---- rung 3

RungAnswer relaxed_answer(const State& packing) {
  RelaxedEstimate estimate = relaxed(packing, *packing.mechanical_coordination_number);
  return {.stiffness = estimate.stiffness,
          .validity = std::move(estimate.validity),
          .relative_error = estimate.relative_error};
}
StressExponents frozen_exponents(const State& packing, Modulus which) {
  return relaxed_exponents(packing, *packing.mechanical_coordination_number, {}, which);
}

// ---- the table

constexpr const char* distance = "distance from rung 3, and the standard error of rung 3";

constexpr Rung table[] = {
    {.name = RungName::isotropic,
     .number = 0,
     .key = "0",
     .column = "rung0",
     .title = "uniform strain, isotropic",
     .description = "uniform strain, isotropic, every contact at the mean force",
     .needs = "nothing more",
     .typical_time = 11e-9,
     .error_source = distance,
     .answer = isotropic,
     .exponents = isotropic_exponents},
    {.name = RungName::fabric,
     .number = 1,
     .key = "1",
     .column = "rung1",
     .title = "uniform strain with fabric",
     .description = "uniform strain with fabric, every contact at the mean force",
     .needs = "a",
     .needs_fabric = true,
     .typical_time = 24e-9,
     .error_source = distance,
     .answer = field<mean_force>,
     .exponents = field_exponents<mean_force>},
    {.name = RungName::directional,
     .number = 2,
     .key = "2",
     .column = "rung2",
     .title = "uniform strain, contact stiffness by direction",
     .description = "uniform strain with fabric, contact stiffness from the force in each direction",
     .needs = "a, sigma_v, sigma_h",
     .needs_fabric = true,
     .typical_time = 0.21e-6,
     .error_source = distance,
     .answer = field<uniform_strain_model>,
     .exponents = field_exponents<uniform_strain_model>},
    {.name = RungName::relaxed,
     .number = 3,
     .key = "3",
     .column = "rung3",
     .title = "relaxed",
     .description = "rung 2 times the relaxation factor of contact networks of this coordination number",
     .needs = "z* as well",
     .needs_coordination = true,
     .typical_time = 0.56e-6,
     .error_source = "its calibration, and the standard errors of z* and a",
     .answer = relaxed_answer,
     .exponents = frozen_exponents},
    {.name = RungName::uniform_stress,
     .key = "uniform-stress",
     .column = "uniform_stress",
     .title = "uniform stress",
     .description = "uniform stress with fabric and the forces of rung 2",
     .needs = "a, sigma_v, sigma_h",
     .needs_fabric = true,
     .typical_time = 0.21e-6,
     .error_source = distance,
     .answer = field<uniform_stress_model>,
     .exponents = field_exponents<uniform_stress_model>},
    {.name = RungName::network,
     .number = 4,
     .key = "4",
     .column = "rung4",
     .title = "linear response of the contact network",
     .description = "linear response of the contact network, every grain in equilibrium",
     .needs = "a packing",
     .needs_packing = true,
     .typical_time = 0.021,
     .error_source = "only that of the solver: the reference of the other errors"},
    {.name = RungName::probe,
     .number = 5,
     .key = "5",
     .column = "rung5",
     .title = "cyclic probe by DEM",
     .description = "small cyclic shear of the specimen at rest, by DEM",
     .needs = "a packing",
     .needs_packing = true,
     .typical_time = 0.035,
     .error_source = "within 0.6 % of rung 4 (validation/verify_default)"},
};
constexpr auto needs_packing = [](const Rung& rung) { return rung.needs_packing; };
constexpr std::size_t closed_form_count =
    static_cast<std::size_t>(std::find_if(std::begin(table), std::end(table), needs_packing) - table);
static_assert(std::all_of(table + closed_form_count, std::end(table), needs_packing));

void require_inputs(const Rung& rung, const State& packing) {
  if (rung.needs_packing)
    throw InvalidArgument(std::string("rung ") + rung.key +
                          " needs a packing of grains: it is not a closed form");
  if (rung.needs_coordination && !packing.mechanical_coordination_number)
    throw InvalidArgument(std::string("rung ") + rung.key + " needs z*, or the share of rattlers");
}

/// The state at which exponents are evaluated. At zero stress it is one of the isotropic path, with overlaps
/// too small to shorten branches.
State loaded(State packing) {
  constexpr double nearly_none = 1e-24; // [Pa]
  if (packing.stress_v == 0 && packing.stress_h == 0)
    packing.stress_v = packing.stress_h = nearly_none;
  return packing;
}

} // namespace

std::span<const Rung> rungs() { return table; }

std::span<const Rung> closed_forms() { return rungs().first(closed_form_count); }

const Rung& rung(RungName name) {
  const auto found =
      std::find_if(std::begin(table), std::end(table), [name](const Rung& row) { return row.name == name; });
  if (found == std::end(table))
    throw InvalidArgument("rung is not one of the known ones");
  return *found;
}

std::string label(const Rung& rung) { return (rung.number ? "rung " : "") + std::string(rung.key); }

bool has_inputs(const State& packing, const Rung& rung) {
  return !rung.needs_packing && packing.coordination_number &&
         (!rung.needs_coordination || packing.mechanical_coordination_number);
}

RungAnswer answer(const Rung& rung, const State& packing) {
  require_inputs(rung, packing);
  RungAnswer answer = rung.answer(packing);
  const elastic::TransverselyIsotropic& c = answer.stiffness;
  for (const double value : {c.C11, c.C33, c.C12, c.C13, c.C44})
    if (!std::isfinite(value))
      throw InvalidArgument("the moduli exceed the range of a double; check the units of the inputs");
  return answer;
}

bool declines(const RungAnswer& answer) {
  const auto& error = answer.relative_error; // present wherever the rung is evaluated, also at zero stress
  return error && error->bulk_modulus == 0 && error->G_hh == 0 && error->G_vh == 0;
}

std::optional<StressExponents> exponents(const Rung& rung, const State& packing, Modulus which) {
  const State at = loaded(packing);
  const elastic::TransverselyIsotropic stiffness = answer(rung, at).stiffness;
  const std::optional<double> value = modulus_if_any(stiffness, which);
  if (!value || kernel::vanishes(*value, stiffness.C11, which))
    return std::nullopt;
  return rung.exponents(at, which);
}

RungAnswer answer_with_exponents(const Rung& rung, const State& packing) {
  RungAnswer with = answer(rung, packing);
  with.exponents = exponents(rung, packing, Modulus::G_vh);
  return with;
}

} // namespace granum::effective

// SPDX-License-Identifier: GPL-3.0-or-later
#include "studies/verify/local_exponents.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <string>

#include <granum/effective/rungs.hpp>
#include <granum/effective/state.hpp>

namespace granum::studies {

namespace {

/// G by uniform strain, rung 3, network and probe, where there is one.
using Routes = std::array<std::optional<double>, 4>;

struct StateModuli {
  double exponent;
  std::optional<double> transition;
  Routes moduli;
};

/// Of the state of a specimen at that pressure, if it has one.
std::optional<StateModuli> moduli_at(double pressure, const SpecimenResult& specimen) {
  const auto found = std::ranges::find(specimen.states, pressure, &CompressedState::pressure);
  if (found == specimen.states.end() || !found->packing.state || !(found->G_closed > 0))
    return std::nullopt;
  const CompressedState& state = *found;
  Routes moduli{state.G_closed, relaxed_modulus(state)};
  if (state.packing.network)
    moduli[2] = state.network().shear_modulus();
  if (state.probes)
    moduli[3] = (state.probes->G_hh + state.probes->G_hv + state.probes->G_vh) / 3;
  return StateModuli{.exponent = effective::contact_exponent(*state.packing.state),
                     .transition = effective::transition_pressure(*state.packing.state),
                     .moduli = moduli};
}

double mean(const std::vector<double>& values) {
  double sum = 0;
  for (const double value : values)
    sum += value / static_cast<double>(values.size());
  return sum;
}

/// The exponents of one kind of specimen between two pressures, over the seeds; empty if none has both.
std::optional<LocalExponents> between(double low, double high, contact::Shape contact,
                                      triaxial::Density density,
                                      const std::vector<SpecimenResult>& specimens) {
  std::vector<double> contact_law, transition;
  std::array<std::vector<TableValue>, std::tuple_size_v<Routes>> slopes;
  for (const SpecimenResult& specimen : specimens) {
    if (specimen.contact != contact || specimen.density != density)
      continue;
    const std::optional<StateModuli> from = moduli_at(low, specimen), to = moduli_at(high, specimen);
    if (!from || !to)
      continue;
    const double step = std::log(high / low);
    contact_law.push_back((from->exponent + to->exponent) / 2);
    if (from->transition && to->transition)
      transition.push_back(std::sqrt(*from->transition * *to->transition));
    for (std::size_t k = 0; k < slopes.size(); ++k)
      if (from->moduli[k] && to->moduli[k])
        slopes[k].push_back({std::log(*to->moduli[k] / *from->moduli[k]) / step, std::nullopt});
  }
  if (contact_law.empty())
    return std::nullopt;
  return LocalExponents{.contact = contact,
                        .density = density,
                        .pressure = std::sqrt(low * high),
                        .transition = transition.empty() ? std::nullopt : std::optional(mean(transition)),
                        .contact_law = mean(contact_law),
                        .uniform_strain = mean_over_seeds(slopes[0]).value(),
                        .relaxed = mean_over_seeds(slopes[1]),
                        .network = mean_over_seeds(slopes[2]),
                        .probe = mean_over_seeds(slopes[3])};
}

} // namespace

std::vector<LocalExponents> local_exponents(const Scene& scene,
                                            const std::vector<SpecimenResult>& specimens) {
  const std::vector<double>& pressures = scene.study.pressures;
  std::vector<LocalExponents> rows;
  for (const contact::Shape contact : scene.study.contacts)
    if (!law(scene, contact).constant_exponent())
      for (const triaxial::Density density : scene.study.densities)
        for (std::size_t k = 1; k < pressures.size(); ++k)
          if (const auto row = between(pressures[k - 1], pressures[k], contact, density, specimens))
            rows.push_back(*row);
  return rows;
}

io::Columns<LocalExponents> local_exponent_columns() {
  using Row = LocalExponents;
  const auto shown = [](std::string heading, int width) {
    return io::ShownColumn{
        .heading = std::move(heading), .width = width, .digits = 3, .fixed = true, .absent = "-"};
  };
  const auto value = [](std::optional<TableValue> Row::*of) {
    return [of](const Row& row) { return row.*of ? std::optional((row.*of)->value) : std::nullopt; };
  };
  const auto error = [](std::optional<TableValue> Row::*of) {
    return [of](const Row& row) { return row.*of ? (row.*of)->standard_error : std::nullopt; };
  };
  return {
      {"contact", "contact", [](const Row& row) { return name(row.contact); },
       io::ShownColumn{.heading = "contact", .width = -9}},
      {"density", "density", [](const Row& row) { return name(row.density); },
       io::ShownColumn{.heading = "density", .width = -7}},
      {"p_Pa", "pressure_Pa", &Row::pressure, io::ShownColumn{.heading = "p [kPa]", .width = 8, .unit = 1e3}},
      {"p_transition_Pa", "transition_pressure_Pa", [](const Row& row) { return row.transition; },
       io::ShownColumn{.heading = "p* [kPa]", .width = 9, .unit = 1e3, .absent = "-"}},
      {"contact_law", "contact_law", &Row::contact_law, shown("law", 6)},
      {"uniform_strain", "uniform_strain", [](const Row& row) { return row.uniform_strain.value; },
       shown("strain", 7)},
      {"rung3", "rung3", value(&Row::relaxed), shown("rung 3", 7)},
      {"rung3_error", "rung3_standard_error", error(&Row::relaxed)},
      {"network", "network", value(&Row::network), shown("network", 8)},
      {"network_error", "network_standard_error", error(&Row::network)},
      {"probe", "probe", value(&Row::probe), shown("probe", 7)},
      {"probe_error", "probe_standard_error", error(&Row::probe)},
  };
}

} // namespace granum::studies

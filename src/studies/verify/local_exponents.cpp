// SPDX-License-Identifier: GPL-3.0-or-later
#include "studies/verify/local_exponents.hpp"

#include <cmath>
#include <string>

#include <granum/effective/rungs.hpp>
#include <granum/effective/state.hpp>

namespace granum::studies {

namespace {

/// Moduli of one state by every method, and its contacts.
struct StateModuli {
  double pressure, exponent, uniform_strain;
  std::optional<double> transition, relaxed, network, probe;
};

std::optional<double> relaxed_modulus(const CompressedState& state) {
  const effective::RungAnswer answer =
      effective::answer(effective::rung(effective::RungName::relaxed), state.packing.state.value());
  return effective::declines(answer) ? std::nullopt : std::optional(answer.stiffness.G_vh());
}

std::optional<StateModuli> moduli_of(const CompressedState& state) {
  if (!state.packing.state || !(state.G_closed > 0))
    return std::nullopt;
  return StateModuli{
      .pressure = state.pressure,
      .exponent = effective::contact_exponent(*state.packing.state),
      .uniform_strain = state.G_closed,
      .transition = effective::transition_pressure(*state.packing.state),
      .relaxed = relaxed_modulus(state),
      .network = state.packing.network ? std::optional(state.network().shear_modulus()) : std::nullopt,
      .probe = state.probes
                   ? std::optional((state.probes->G_hh + state.probes->G_hv + state.probes->G_vh) / 3)
                   : std::nullopt};
}

/// The exponents of one specimen between two states, gathered over the seeds.
struct Interval {
  std::vector<double> contact_law, transition;
  std::vector<TableValue> uniform_strain, relaxed, network, probe;

  void add(const StateModuli& low, const StateModuli& high) {
    const double step = std::log(high.pressure / low.pressure);
    const auto slope = [step](double before, double after) {
      return TableValue{std::log(after / before) / step, std::nullopt};
    };
    const auto add_if = [&](std::vector<TableValue>& to, const std::optional<double>& before,
                            const std::optional<double>& after) {
      if (before && after)
        to.push_back(slope(*before, *after));
    };
    contact_law.push_back((low.exponent + high.exponent) / 2);
    if (low.transition && high.transition)
      transition.push_back(std::sqrt(*low.transition * *high.transition));
    uniform_strain.push_back(slope(low.uniform_strain, high.uniform_strain));
    add_if(relaxed, low.relaxed, high.relaxed);
    add_if(network, low.network, high.network);
    add_if(probe, low.probe, high.probe);
  }
};

double mean(const std::vector<double>& values) {
  double sum = 0;
  for (const double value : values)
    sum += value / static_cast<double>(values.size());
  return sum;
}

/// Pairs of neighbouring pressures of one kind of specimen.
std::vector<LocalExponents> rows_of(const Scene& scene, contact::Shape contact, triaxial::Density density,
                                    const std::vector<SpecimenResult>& specimens) {
  std::vector<LocalExponents> rows;
  const std::vector<double>& pressures = scene.study.pressures;
  for (std::size_t k = 1; k < pressures.size(); ++k) {
    Interval interval;
    for (const SpecimenResult& specimen : specimens) {
      if (specimen.contact != contact || specimen.density != density)
        continue;
      std::optional<StateModuli> low, high;
      for (const CompressedState& state : specimen.states) {
        if (state.pressure == pressures[k - 1])
          low = moduli_of(state);
        if (state.pressure == pressures[k])
          high = moduli_of(state);
      }
      if (low && high)
        interval.add(*low, *high);
    }
    if (interval.uniform_strain.empty())
      continue;
    rows.push_back(
        {.contact = contact,
         .density = density,
         .pressure = std::sqrt(pressures[k - 1] * pressures[k]),
         .transition = interval.transition.empty() ? std::nullopt : std::optional(mean(interval.transition)),
         .contact_law = mean(interval.contact_law),
         .uniform_strain = mean_over_seeds(interval.uniform_strain).value(),
         .relaxed = mean_over_seeds(interval.relaxed),
         .network = mean_over_seeds(interval.network),
         .probe = mean_over_seeds(interval.probe)});
  }
  return rows;
}

} // namespace

std::vector<LocalExponents> local_exponents(const Scene& scene,
                                            const std::vector<SpecimenResult>& specimens) {
  std::vector<LocalExponents> rows;
  for (const contact::Shape contact : scene.study.contacts)
    if (!law(scene, contact).constant_exponent())
      for (const triaxial::Density density : scene.study.densities) {
        const std::vector<LocalExponents> of_kind = rows_of(scene, contact, density, specimens);
        rows.insert(rows.end(), of_kind.begin(), of_kind.end());
      }
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

// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>

#include <granum/core/error.hpp>
#include <granum/elastic/isotropic.hpp>

#include "figure_parts.hpp"
#include "studies/report/compression.hpp"

namespace granum::studies {

namespace {

/// G of the nearest isotropic material; empty for a network without stiffness.
std::optional<double> isotropic_G(const elastic::VoigtStiffness& stiffness) {
  try {
    return elastic::isotropic_projection(stiffness).shear_modulus();
  } catch (const InvalidArgument&) {
    return std::nullopt;
  }
}

} // namespace

std::optional<double> network_over_uniform_strain(const StateRecord& point) {
  if (!point.closed)
    return std::nullopt;
  elastic::VoigtStiffness relaxed;
  for (int i = 0; i < 6; ++i)
    for (int j = 0; j < 6; ++j)
      relaxed.matrix(i, j) = point.network[static_cast<std::size_t>(6 * i + j)];
  const std::optional<double> network = isotropic_G(relaxed);
  const std::optional<double> uniform = isotropic_G(voigt(point.closed->uniform_strain));
  return network && uniform ? std::optional(*network / *uniform) : std::nullopt;
}

namespace {

/// All states of all seeds of a contact and density.
plot::Series states(const Experiment& experiment, const Kind& kind) {
  plot::Series out{.name = kind.title(),
                   .mark = plot::Mark::marker,
                   .style = kind.density == triaxial::Density::dense ? 0 : 1,
                   .tone = plot::Tone::faint,
                   .colour = colour_of(kind.contact)};
  for (const ExperimentSpecimen& specimen : experiment.specimens)
    if (specimen.contact == kind.contact && specimen.density == kind.density)
      for (const PathRun& run : specimen.runs)
        for (const StateRecord& point : run.points)
          if (const std::optional<double> ratio = network_over_uniform_strain(point))
            out.add(point.micro.mechanical_coordination_number, *ratio);
  return out;
}

} // namespace

void add_relaxation_figure(std::vector<Figure>& to, const Experiment& experiment) {
  Panel all = panel("more_relaxation", "All frozen states",
                    {"z_star", {.title = "z* (contacts of a grain, rattlers left out)"}},
                    {"G_over_G_uniform_strain", {.title = "G of the network / G under uniform strain"}});
  all.chart.width = 520;
  all.chart.height = 380;
  std::vector<double> found;
  for (const Kind& kind : kinds(experiment)) {
    plot::Series series = states(experiment, kind);
    found.insert(found.end(), series.x.begin(), series.x.end());
    add(all, std::move(series), kind.key());
  }
  if (found.empty())
    return;
  const auto [low, high] = std::minmax_element(found.begin(), found.end());
  for (const contact::Shape contact : experiment.scene.study.contacts) {
    plot::Series line = relaxation_curve(experiment.scene, contact, *low, *high, 80);
    line.name = "closed form, " + std::string(name(contact));
    line.style = 0;
    line.colour = colour_of(contact);
    add(all, std::move(line), "closed form " + std::string(name(contact)));
  }
  Figure figure{
      .name = "Beyond the paper",
      .title = "How much softer than uniform strain",
      .caption =
          "The shear modulus of the network over that of uniform strain in closed form, isotropic parts "
          "of both, for every frozen state of every path and seed, also past the peak. It depends almost "
          "only on the number of contacts of grains that carry load. Lines: the closed form calibrated "
          "on other specimens (validation/relaxation).",
      .panels = {}};
  add(figure, std::move(all));
  to.push_back(std::move(figure));
}

} // namespace granum::studies

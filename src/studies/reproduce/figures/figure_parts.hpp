// SPDX-License-Identifier: GPL-3.0-or-later
// Common parts of the figures of an experiment.
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "studies/reproduce/figures/experiment_figures.hpp"

namespace granum::studies {

[[nodiscard]] inline Quantity stress_ratio() { return {"eta", {.title = "\u03b7 = q/p'"}}; }
[[nodiscard]] inline Quantity axial_strain() {
  return {"axial_strain", {.title = "axial strain [%]", .unit = 0.01}};
}
[[nodiscard]] inline Quantity mean_stress() { return {"p_Pa", {.title = "p' [kPa]", .unit = 1e3}}; }

/// Adds a panel, unless it has no series.
void add(Figure& to, Panel panel);

/// A contact and a density, of which the first seed is drawn.
struct Kind {
  contact::Shape contact = contact::Shape::sphere;
  triaxial::Density density = triaxial::Density::dense;
  const ExperimentSpecimen* specimen = nullptr; ///< never nullptr in kinds()

  [[nodiscard]] std::string title() const; ///< "sphere, dense"
  [[nodiscard]] std::string key() const;   ///< "sphere_dense"
};

/// In the order of the paper's panels: contacts, dense before loose.
[[nodiscard]] std::vector<Kind> kinds(const Experiment& experiment);

/// " (first of 3 specimens of a kind)"; empty with one seed.
[[nodiscard]] std::string seeds_note(const Experiment& experiment);

/// Each path keeps its dashes and marker, and its colour, in all figures; isotropic compression too.
[[nodiscard]] std::size_t style_of(const std::optional<stress::ShearPath>& path);
[[nodiscard]] plot::Colour colour_of(const std::optional<stress::ShearPath>& path);

/// Frozen states of a run until |eta| falls for the first time, or those behind it: past the first peak eta
/// goes up and down. Isotropic compression has no peak.
[[nodiscard]] std::vector<const StateRecord*> up_to_peak(const PathRun& run);
[[nodiscard]] std::vector<const StateRecord*> past_peak(const PathRun& run);

/// The former, and in front of them the end of isotropic compression, where the paths start.
[[nodiscard]] std::vector<const StateRecord*> from_start(const ExperimentSpecimen& specimen,
                                                         const PathRun& run);

/// Coordinate of a frozen state in a figure; empty if not measured.
using Coordinate = std::function<std::optional<double>(const StateRecord&)>;
[[nodiscard]] std::optional<double> eta_of(const StateRecord& point);
[[nodiscard]] std::optional<double> mean_stress_of(const StateRecord& point); ///< [Pa]

/// Isotropic part of G of the network over that of uniform strain in closed form; empty for a network that
/// does not resist, or without closed forms.
[[nodiscard]] std::optional<double> network_over_uniform_strain(const StateRecord& point);

/// The points that have both coordinates, in the style of their run.
[[nodiscard]] plot::Series series_of(const PathRun& run, const std::vector<const StateRecord*>& points,
                                     const Coordinate& x, const Coordinate& y);

// The figures, file by file.
void add_path_figures(std::vector<Figure>& to, const Experiment& experiment);           ///< 4, 6, 7, 8
void add_modulus_figures(std::vector<Figure>& to, const Experiment& experiment);        ///< 9 to 14
void add_exponent_figure(std::vector<Figure>& to, const Experiment& experiment);        ///< 15
void add_direction_figure(std::vector<Figure>& to, const Experiment& experiment);       ///< 16
void add_microstructure_figures(std::vector<Figure>& to, const Experiment& experiment); ///< 17 to 19
void add_relaxation_figure(std::vector<Figure>& to, const Experiment& experiment);      ///< beyond the paper

} // namespace granum::studies

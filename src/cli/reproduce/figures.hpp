// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "studies/report/panel.hpp"
#include "studies/reproduce/experiment.hpp"
#include <granum/plot/svg_text.hpp>

/// The paper's figures, drawn from an experiment: lines and markers of the first seed, tables of all seeds.
/// Checked by tests/cli/test_figures.cpp
namespace granum::cli {

using studies::Experiment;
using studies::ExperimentSpecimen;
using studies::Panel;
using studies::PathRun;
using studies::StateRecord;

struct Figure {
  std::string name; ///< "Fig. 9"; "Beyond the paper" for additional ones
  std::string title;
  std::string caption; ///< in plain words
  std::vector<Panel> panels = {};
};

/// All figures but the assembly, in the paper's order: 4 (paths), 6 to 8 (stress ratio, volumetric strain,
/// cycles of shear), 9 to 14 (moduli), 15 (exponents), 16 (directions of contacts), 17 to 19
/// (microstructure), and the relaxation of all frozen states. Panels and figures without data are left out.
/// Numbers are in SI. [Chung2014]
[[nodiscard]] std::vector<Figure> experiment_figures(const Experiment& experiment);

/// Fig. 3: a specimen at the end of isotropic compression.
struct AssemblyPicture {
  std::string stem;         ///< "fig03_sphere_dense"
  plot::SvgPicture drawing; ///< its finding is the caption
};

/// The first dense specimen of spheres, or else the first specimen that was compressed.
/// \return   empty if there is none
[[nodiscard]] std::optional<AssemblyPicture> assembly_picture(const Experiment& experiment);

/// The grains of a state seen from above and aside, nearest in front, and the edges of its cell. Grains that
/// lie deeper than four diameters behind the faces that are seen are left out, as others hide them.
/// \param    state   with grains; in a periodic cell they are moved into it
/// \throws   InvalidArgument for a state without grains
[[nodiscard]] plot::SvgPicture assembly_drawing(const dem::Specimen& state);

// ---- parts of the figures

/// A contact and a density; the first seed is drawn.
struct Kind {
  contact::Shape contact = contact::Shape::sphere;
  triaxial::Density density = triaxial::Density::dense;
  const ExperimentSpecimen* specimen = nullptr; ///< never nullptr in kinds()

  [[nodiscard]] std::string title() const; ///< "sphere, dense"
  [[nodiscard]] std::string key() const;   ///< "sphere_dense"
};

/// In the order of the paper's panels: contacts, dense before loose.
[[nodiscard]] std::vector<Kind> kinds(const Experiment& experiment);

/// A figure without panels; its caption says of how many specimens the first is drawn.
[[nodiscard]] Figure figure_of(const Experiment& experiment, std::string name, std::string title,
                               const std::string& caption);
/// Adds a panel, unless it has no series.
void add(Figure& to, Panel panel);

[[nodiscard]] studies::Quantity stress_ratio();
[[nodiscard]] studies::Quantity mean_stress();

/// Frozen states of a run until |eta| falls for the first time, or those behind it: past the first peak eta
/// goes up and down. Isotropic compression has no peak.
using Points = std::vector<const StateRecord*>;
[[nodiscard]] Points up_to_peak(const PathRun& run);
[[nodiscard]] Points past_peak(const PathRun& run);
/// The former, and in front of them the end of isotropic compression, where the paths start.
[[nodiscard]] Points from_start(const ExperimentSpecimen& specimen, const PathRun& run);

/// Coordinate of a frozen state in a figure; empty if not measured.
using Coordinate = std::function<std::optional<double>(const StateRecord&)>;
[[nodiscard]] std::optional<double> eta_of(const StateRecord& point);
[[nodiscard]] std::optional<double> mean_stress_of(const StateRecord& point); ///< [Pa]
/// Isotropic part of G of the network over that of uniform strain in closed form; empty for a network that
/// does not resist, or without closed forms.
[[nodiscard]] std::optional<double> network_over_uniform_strain(const StateRecord& point);

/// The points that have both coordinates. Each path keeps its dashes and marker, and its colour, in all
/// figures; isotropic compression too.
[[nodiscard]] plot::Series series_of(const PathRun& run, const Points& points, const Coordinate& x,
                                     const Coordinate& y, plot::Mark mark = plot::Mark::line,
                                     plot::Tone tone = plot::Tone::full);

// The figures, source by source.
void add_path_figures(std::vector<Figure>& to, const Experiment& experiment);      ///< 4, 6, 7, 8
void add_modulus_figures(std::vector<Figure>& to, const Experiment& experiment);   ///< 9 to 14
void add_structure_figures(std::vector<Figure>& to, const Experiment& experiment); ///< 15 to 19, relaxation

} // namespace granum::cli

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "studies/report/panel.hpp"
#include "studies/reproduce/experiment.hpp"
#include <granum/plot/svg_text.hpp>

/// The paper's figures, drawn from an experiment: lines and markers of the first seed, tables of all seeds.
/// Checked by tests/studies/test_experiment_figures.cpp
namespace granum::studies {

struct Figure {
  std::string name; ///< "Fig. 9"; "Beyond the paper" for additional ones
  std::string title;
  std::string caption; ///< in plain words
  std::vector<Panel> panels;
};

/// All figures but the assembly, in the paper's order: 4 (paths), 6 to 8 (stress ratio, volumetric strain,
/// cycles of shear), 9 to 14 (moduli), 15 (exponents), 16 (directions of contacts), 17 to 19
/// (microstructure), and the relaxation of all frozen states. Panels and figures without data are left out.
/// Numbers are in SI. [Chung2014]
[[nodiscard]] std::vector<Figure> experiment_figures(const Experiment& experiment);

/// Fig. 3: a specimen at the end of isotropic compression.
struct AssemblyPicture {
  std::string stem; ///< "fig03_sphere_dense"
  std::string caption;
  std::string svg;     ///< a file of its own
  std::string in_page; ///< a part of the report
};

/// The first dense specimen of spheres, or else the first specimen that was compressed.
/// \return   empty if there is none
[[nodiscard]] std::optional<AssemblyPicture> assembly_picture(const Experiment& experiment);

/// The grains of a state seen from above and aside, nearest in front, and the edges of its cell. Grains that
/// lie deeper than four diameters behind the faces that are seen are left out, as others hide them.
/// \param    state   with grains; in a periodic cell they are moved into it
/// \throws   InvalidArgument for a state without grains
[[nodiscard]] plot::SvgPicture assembly_drawing(const dem::Specimen& state);

} // namespace granum::studies

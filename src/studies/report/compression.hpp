// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "studies/report/panel.hpp"
#include "studies/scene/scene.hpp"
#include <granum/core/numerics.hpp>
#include <granum/plot/page.hpp>

/// Isotropic compression, explained for readers who ask why G grows as p^s: common to the reports of verify
/// and reproduce begin with.  Checked by tests/studies/test_compression_report.cpp
namespace granum::studies {

/// The three shear moduli in the order of their names [Pa]; empty if not found.
using ShearModuli = std::array<std::optional<double>, 3>;
inline constexpr std::array shear_modulus_names{"G_hv", "G_vh", "G_hh"};

/// A state of isotropic compression by every route.
struct RouteState {
  double pressure = 0;                       ///< [Pa]
  double mechanical_coordination_number = 0; ///< z*
  ShearModuli network = {};
  ShearModuli relaxed = {};             ///< closed form, rung 3
  ShearModuli probe = {};               ///< cyclic shear by DEM
  std::optional<double> softening = {}; ///< isotropic G of the network over uniform strain [1]
};

/// A specimen on its way.
struct Compression {
  contact::Shape contact = contact::Shape::sphere;
  triaxial::Density density = triaxial::Density::dense;
  double contact_exponent = 0;               ///< of a single contact, contact_exponent(scene, contact)
  std::optional<Measured> exponent = {};     ///< s of the network, over all seeds
  std::optional<double> paper_exponent = {}; ///< as printed
  std::vector<RouteState> states = {};       ///< of the first seed
};

/// The question at the top of the report.
inline constexpr const char* compression_question =
    "Why does the stiffness of a packing of grains grow as p\u02e2, and what is s?";

/// Meaning of s, its value for dense packings and the reason, the same for loose ones: a sentence each, with
/// numbers of the run.
[[nodiscard]] std::vector<std::string> compression_answer(const std::vector<Compression>& all);

/// log G against log p by every method, for one of the three moduli (an index of shear_modulus_names).
[[nodiscard]] Panel modulus_panel(const std::vector<Compression>& all, std::size_t modulus);

/// The part of a report about compression, and the files of its pictures.
struct CompressionStory {
  std::string first_screen; ///< question, answer, and the moduli
  std::string why;          ///< contact law, contacts, and relaxation, as a section
  std::vector<Panel> panels;
};

/// \param    figures   folder of the panels' files, as seen from the page
[[nodiscard]] CompressionStory compression_story(const Scene& scene, const std::vector<Compression>& all,
                                                 const std::string& figures);

/// Link to the data of a panel.
[[nodiscard]] plot::PageFile file_of(const Panel& panel, const std::string& figures);

/// G of a packing of the scene over G under uniform strain, by rung 3.
[[nodiscard]] double shear_relaxation(const Scene& scene, contact::Shape shape,
                                      double mechanical_coordination_number);
/// The same as a line over z*.
[[nodiscard]] plot::Series relaxation_curve(const Scene& scene, contact::Shape shape, double low, double high,
                                            int steps);

/// "spheres", "flat contacts".
[[nodiscard]] std::string plural(contact::Shape shape);

/// Colour of a shape in all pictures of a report: its own, otherwise the colour of power laws.
[[nodiscard]] plot::Colour colour_of(contact::Shape shape);

} // namespace granum::studies

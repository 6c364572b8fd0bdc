// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "studies/report/panel.hpp"
#include "studies/scene/scene.hpp"
#include <granum/core/numerics.hpp>

#include "cli/document/document.hpp"

/// Isotropic compression, explained for readers who ask why G grows as p^s: with this the pages of verify and
/// reproduce begin.  Checked by tests/cli/test_compression.cpp
namespace granum::cli {

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
  double contact_exponent = 0;           ///< of a single contact, contact_exponent(scene, contact)
  std::optional<Measured> exponent = {}; ///< s of the network, over all seeds
  std::vector<RouteState> states = {};   ///< of the first seed
};

/// The folder of the pictures' files, beside the page.
inline constexpr const char* figures_name = "figures";

/// Meaning of s, its value for dense packings and the reason, the same for loose ones: a sentence each, with
/// numbers of the run.
[[nodiscard]] std::vector<std::string> compression_answer(const std::vector<Compression>& all);

/// log G against log p by every method, for one of the three moduli (an index of shear_modulus_names).
[[nodiscard]] studies::Panel modulus_panel(const std::vector<Compression>& all, std::size_t modulus);

/// Adds question, answer and pictures: the moduli, contact law, contacts, and relaxation.
/// \return   the panels of the pictures, whose files belong into the folder of figures
std::vector<studies::Panel> add_compression(Document& to, const studies::Scene& scene,
                                            const std::vector<Compression>& all);

/// Panels side by side with links to their numbers, one modulus at a time.
[[nodiscard]] Picture picture_of(const std::vector<studies::Panel>& panels, std::string caption);

/// G of a packing of the scene over G under uniform strain, by rung 3.
[[nodiscard]] double shear_relaxation(const studies::Scene& scene, contact::Shape shape,
                                      double mechanical_coordination_number);
/// The same as a line over z*.
[[nodiscard]] plot::Series relaxation_curve(const studies::Scene& scene, contact::Shape shape, double low,
                                            double high, int steps);

/// Colour of a shape in all pictures of a page: its own, otherwise the colour of power laws.
[[nodiscard]] plot::Colour colour_of(contact::Shape shape);

} // namespace granum::cli

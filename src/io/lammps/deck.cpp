// SPDX-License-Identifier: GPL-3.0-or-later
#include <granum/io/lammps/deck.hpp>

#include <algorithm>
#include <cctype>
#include <cmath>
#include <map>
#include <numbers>
#include <string_view>
#include <utility>

#include <granum/core/error.hpp>
#include <granum/core/text.hpp>
#include <granum/io/lammps/files.hpp>
#include <granum/packing/assembly.hpp>

namespace granum::io {

namespace {

/// The files of share/lammps in the order of a deck; the same for every scene but for the numbers in
/// scene.lmp.
constexpr std::pair<std::string_view, std::string_view> scripts[] = {
#include "lammps_scripts.inc" // written by CMake
};

void require_spheres(const contact::NormalLaw& law, double radius) {
  const contact::PowerLaw* const power = law.power_law();
  if (power == nullptr || power->alpha() != 2)
    throw InvalidArgument("LAMMPS has no contact law " + law.text() +
                          "; supported is sphere (alpha = 2), no other law");
  const double expected = contact::PowerLaw::sphere(law.grain(), radius).coefficient();
  if (std::abs(power->coefficient() - expected) > 1e-12 * expected)
    throw InvalidArgument("the contact law is not that of spheres of the grains' radius " +
                          short_text(radius) + " m, the only one of alpha = 2 that LAMMPS has");
}

void require_valid(const LammpsPath& path) {
  if (path.name.empty() || path.name == "none" ||
      !std::all_of(path.name.begin(), path.name.end(),
                   [](unsigned char c) { return c < 128 && std::isalnum(c) != 0; }))
    throw InvalidArgument("path.name must be letters and digits, and not none: " + path.name);
  require_open("path.inertial_number", path.inertial_number, 0, 0.1);
  if (!(path.eta_step >= 1e-3 && path.eta_step < 3))
    throw InvalidArgument("path.eta_step", path.eta_step, "", "[0.001, 3)");
  require_open("path.largest_strain", path.largest_strain, 0, 1);
}

void require_valid(const LammpsExperiment& experiment) {
  require_positive("radius", experiment.radius, "m");
  require_spheres(experiment.law, experiment.radius);
  require_non_negative("tangential_ratio", experiment.tangential_ratio);
  require_non_negative("friction_coefficient", experiment.friction_coefficient);
  if (experiment.pressures.empty())
    throw InvalidArgument("pressures: at least 1 is needed");
  double last = 0;
  for (const double pressure : experiment.pressures) {
    require_positive("pressures", pressure, "Pa");
    if (!(pressure > last))
      throw InvalidArgument("pressures must rise: " + short_text(pressure) + " Pa follows " +
                            short_text(last) + " Pa");
    last = pressure;
  }
  for (const double pressure : experiment.probe_pressures)
    if (std::find(experiment.pressures.begin(), experiment.pressures.end(), pressure) ==
        experiment.pressures.end())
      throw InvalidArgument("probe_pressures", pressure, "Pa", "the list of pressures");
  if (experiment.path)
    require_valid(*experiment.path);
}

std::string list_of(const std::vector<double>& values) {
  std::string text;
  for (const double value : values)
    text += (text.empty() ? "" : " ") + exact_text(value);
  return text;
}

/// Names of isotropic states, "100kPa"; the word "none" for an empty list, which LAMMPS cannot express.
std::string names_of(const std::vector<double>& pressures) {
  std::string text;
  for (const double pressure : pressures)
    text += (text.empty() ? "" : " ") + exact_text(pressure / 1e3) + "kPa";
  return text.empty() ? "none" : text;
}

/// Of sqrt(m/k_n) of a grain of the mean radius. LAMMPS has the true masses of grains: that of a
/// smaller one is proportional to R^3, and its stiffness to R at equal stress.
constexpr double usual_time_step_share = 0.1;

std::string sizes_text(double smallest, double largest) {
  return "which are of " + short_text(smallest) + " to " + short_text(largest);
}

using Numbers = std::map<std::string, std::string, std::less<>>;

/// Without a triaxial test the deck still contains the numbers of one, under the name "none".
void add_path(Numbers& numbers, const LammpsExperiment& e) {
  const LammpsPath path = e.path.value_or(LammpsPath{.name = "none"});
  numbers.insert({{"path", path.name},
                  {"path_start", names_of({e.pressures.back()})},
                  {"path_drives", path.drives_vertical ? "axial" : "lateral"},
                  {"path_sense", path.compresses ? "1" : "-1"},
                  {"path_eta_sign", path.drives_vertical == path.compresses ? "1" : "-1"},
                  {"path_eta_step", exact_text(path.eta_step)},
                  {"path_largest_strain", exact_text(path.largest_strain)},
                  {"shear_inertial_number", exact_text(path.inertial_number)}});
}

/// Values of the placeholders of scene.lmp; their meaning and units are described there.
Numbers numbers_of(const packing::Assembly& start, const LammpsExperiment& e) {
  const contact::GrainMaterial& grain = e.law.grain();
  const auto [smallest, largest] = std::minmax_element(start.radius.begin(), start.radius.end());
  const bool equal = *smallest == *largest;
  const double volume = 4.0 / 3.0 * std::numbers::pi * std::pow(e.radius, 3);
  const double solid_fraction = equal ? volume * static_cast<double>(start.grain_count()) / start.volume()
                                      : packing::solid_fraction(start);
  // k_n = 2 G a/(1 - nu) with a the radius of the contact; LAMMPS needs k_t/a.
  const double tangential = e.tangential_ratio * 2 * grain.shear_modulus / (1 - grain.poisson_ratio);
  Numbers numbers{
      {"start", e.start == LammpsStart::packed ? "packed" : "scattered"},
      {"pressure", list_of(e.pressures)},
      {"state", names_of(e.pressures)},
      {"probe_state", names_of(e.probe_pressures)},
      {"probed_states", std::to_string(e.probe_pressures.size())},
      {"radius", exact_text(e.radius)},
      {"radius_of", equal ? "every grain" : "all grains in the mean, " + sizes_text(*smallest, *largest)},
      {"time_step_share",
       exact_text(equal ? usual_time_step_share : usual_time_step_share * *smallest / e.radius)},
      {"density", exact_text(e.density)},
      {"young", exact_text(2 * grain.shear_modulus * (1 + grain.poisson_ratio))},
      {"poisson", exact_text(grain.poisson_ratio)},
      {"hertz", exact_text(e.law.power_law()->coefficient())},
      {"tangential_stiffness", exact_text(tangential)},
      {"tangential_ratio", exact_text(e.tangential_ratio)},
      {"friction", exact_text(e.friction_coefficient)},
      {"prepare_friction", exact_text(e.friction_while_prepared ? e.friction_coefficient : 0.0)},
      {"first_solid_fraction", exact_text(solid_fraction)},
      {"relaxed_share", e.friction_while_prepared ? "0.1" : "0.3"}};
  add_path(numbers, e);
  return numbers;
}

/// A script with its placeholders {NAME} filled in; comments begin in one column where values leave room.
std::string filled(std::string_view script, const Numbers& numbers) {
  constexpr std::size_t width = 44; // before the comment
  std::string text;
  while (!script.empty()) {
    std::string line(script.substr(0, script.find('\n')));
    script.remove_prefix(line.size() + 1);
    for (std::size_t at = line.find('{'); at != std::string::npos; at = line.find('{', at)) {
      const std::size_t end = line.find('}', at);
      line.replace(at, end + 1 - at,
                   numbers.find(std::string_view(line).substr(at + 1, end - at - 1))->second);
    }
    const std::size_t comment = line.find(" # ");
    if (comment != std::string::npos && comment < width)
      line.insert(comment, width - comment, ' ');
    text += line + '\n';
  }
  return text;
}

} // namespace

std::vector<DeckFile> lammps_deck(const packing::Assembly& start, const LammpsExperiment& experiment) {
  require_valid(experiment);
  std::vector<DeckFile> files{{"grains.data", lammps_data(start, experiment.density)}};
  for (const auto& [name, text] : scripts)
    files.push_back({std::string(name),
                     name == "scene.lmp" ? filled(text, numbers_of(start, experiment)) : std::string(text)});
  return files;
}

} // namespace granum::io

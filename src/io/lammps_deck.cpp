// SPDX-License-Identifier: GPL-3.0-or-later
#include <granum/io/lammps_deck.hpp>

#include <algorithm>
#include <cctype>
#include <cmath>
#include <numbers>

#include <granum/core/check.hpp>
#include <granum/core/error.hpp>
#include <granum/core/number.hpp>
#include <granum/io/lammps_data.hpp>

#include "lammps_scripts.hpp"

namespace granum::io {

namespace {

void require_spheres(const contact::PowerLaw& law, double radius) {
  if (law.alpha() != 2)
    throw InvalidArgument("LAMMPS has no contact law of alpha = " + short_text(law.alpha()) +
                          "; supported is sphere (alpha = 2), not cone, flat or power-law");
  const double expected = contact::PowerLaw::sphere(law.grain(), radius).coefficient();
  if (std::abs(law.coefficient() - expected) > 1e-12 * expected)
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

void require_valid(const Assembly& start, const LammpsExperiment& experiment) {
  require_positive("radius", experiment.radius, "m");
  require_spheres(experiment.law, experiment.radius);
  for (const double radius : start.radius)
    if (radius != experiment.radius)
      throw InvalidArgument("radius", radius, "m", "the radius of the experiment: all grains are equal");
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

/// The numbers of a deck, one a line: name, value, and what it is, with its unit.
class Numbers {
 public:
  void heading(const std::string& words) { text_ += "\n# " + words + "\n"; }
  void add(const std::string& name, const std::string& value, const std::string& comment) {
    std::string line = "variable " + name + " index " + value;
    line.resize(std::max(line.size(), std::size_t{44}), ' ');
    text_ += line + " # " + comment + "\n";
  }
  void add(const std::string& name, double value, const std::string& comment) {
    add(name, exact_text(value), comment);
  }
  [[nodiscard]] const std::string& text() const { return text_; }

 private:
  std::string text_{lammps_scripts::scene_head};
};

std::string list_of(const std::vector<double>& values) {
  std::string text;
  for (const double value : values)
    text += (text.empty() ? "" : " ") + exact_text(value);
  return text;
}

/// Names of isotropic states, "100kPa"; none where there are none, which a list of LAMMPS cannot say.
std::string names_of(const std::vector<double>& pressures) {
  std::string text;
  for (const double pressure : pressures)
    text += (text.empty() ? "" : " ") + exact_text(pressure / 1e3) + "kPa";
  return text.empty() ? "none" : text;
}

/// A test that no deck has been asked for is there with its numbers, under the name none.
void add_path(Numbers& n, const LammpsExperiment& e) {
  const LammpsPath path = e.path.value_or(LammpsPath{.name = "none"});
  n.heading("Stress path");
  n.add("path", path.name, "of in.path; none: no path [-]");
  n.add("path_start", names_of({e.pressures.back()}), "state that it starts from [-]");
  n.add("path_drives", path.drives_vertical ? "axial" : "lateral", "stress that changes [-]");
  n.add("path_sense", path.compresses ? "1" : "-1", "1: it grows, -1: it falls [1]");
  n.add("path_eta_sign", path.drives_vertical == path.compresses ? "1" : "-1", "sign of q/p on the path [1]");
  n.add("path_eta_step", path.eta_step, "of q/p between snapshots [1]");
  n.add("path_largest_strain", path.largest_strain, "axial strain, either sense, at the end [1]");
  n.add("shear_inertial_number", path.inertial_number, "driven strain rate times 2R sqrt(density/p) [1]");
  n.add("segment_steps", "25", "with constant rates of strain between two looks at the stress [1]");
}

std::string scene_text(const Assembly& start, const LammpsExperiment& e) {
  const contact::GrainMaterial& grain = e.law.grain();
  const double volume = 4.0 / 3.0 * std::numbers::pi * std::pow(e.radius, 3);
  const double solid_fraction = volume * static_cast<double>(start.grain_count()) / start.volume();
  // k_n = 2 G a/(1 - nu) with a the radius of the contact; LAMMPS takes k_t/a.
  const double tangential = e.tangential_ratio * 2 * grain.shear_modulus / (1 - grain.poisson_ratio);
  Numbers n;
  n.heading("The experiment");
  n.add("start", e.start == LammpsStart::packed ? "packed" : "scattered",
        "packed: grains.data is (nearly) jammed; scattered: far from it [-]");
  n.add("pressure", list_of(e.pressures), "isotropic states that in.iso stops at [Pa]");
  n.add("state", names_of(e.pressures), "their names [-]");
  n.add("probe_state", names_of(e.probe_pressures), "those that in.probe shears [-]");
  n.add("probed_states", std::to_string(e.probe_pressures.size()), "how many these are; 0: no probe [1]");
  n.heading("Grains");
  n.add("radius", e.radius, "of every grain [m]");
  n.add("density", e.density, "of the grains, sets the time scale alone [kg/m^3]");
  n.add("young", 2 * grain.shear_modulus * (1 + grain.poisson_ratio), "2 G_g (1 + nu_g) [Pa]");
  n.add("poisson", grain.poisson_ratio, "nu_g [1]");
  n.add("hertz", e.law.coefficient(), "c of f_n = c overlap^1.5 [N/m^1.5]");
  n.add("tangential_stiffness", tangential,
        "k_t over radius of the contact, " + exact_text(e.tangential_ratio) + " k_n [Pa]");
  n.add("friction", e.friction_coefficient, "mu from the first pressure on [1]");
  n.add("prepare_friction", e.friction_while_prepared ? e.friction_coefficient : 0.0,
        "mu up to the first pressure [1]");
  n.add("probe_friction", "1e6", "mu in frozen states, in which no contact slides [1]");
  n.heading("What the motion is steered by; the answer at rest does not depend on it");
  n.add("solid_fraction", "0.62", "for estimates of force and stiffness only [1]");
  n.add("coordination", "4", "likewise, contacts per grain [1]");
  n.add("first_solid_fraction", solid_fraction, "of grains.data [1]");
  n.add("gathered_solid_fraction", "0.5", "up to which scattered grains are moved together [1]");
  n.add("gather_steps", "20000", "in that many steps [1]");
  n.add("gather_inertial_number", "0.005 0.001 0.0003", "of the box until scattered grains jam, in turn [1]");
  n.add("gather_tolerance", "0.02", "as below, of the servo that packs them without drag [1]");
  n.add("restitution", "0.5", "of the contacts' damping [1]");
  n.add("tangential_damping", "0.5", "over the normal one [1]");
  n.add("time_step_share", "0.1", "of sqrt(m/k_n); LAMMPS does not tell when it is unstable, near 0.18 [1]");
  n.add("iso_inertial_number", "0.0005", "strain rate times 2R sqrt(density/pressure), at most [1]");
  n.add("relaxed_share", e.friction_while_prepared ? "0.1" : "0.3",
        "of the shear modulus under uniform strain that grains at rest have [1]");
  n.add("prepare_tolerance", "0.001",
        "of stresses and unbalanced over mean force, up to the first pressure [1]");
  n.add("iso_tolerance", "0.0001", "the same while the servo works from there on [1]");
  n.add("rest_tolerance", "1e-08", "of unbalanced over mean force in states at rest [1]");
  n.add("servo_steps", "400000", "at most for each pressure [1]");
  n.add("rest_steps", "40000", "at most for each rest [1]");
  add_path(n, e);
  n.heading("Probes");
  n.add("probe_share", "0.0003", "strain of the probes over (mean overlap / diameter) [1]");
  n.add("ramp_steps", "100", "in which the box takes this strain [1]");
  return n.text();
}

} // namespace

std::vector<DeckFile> lammps_deck(const Assembly& start, const LammpsExperiment& experiment) {
  require_valid(start, experiment);
  std::vector<DeckFile> files{{"grains.data", lammps_data(start, experiment.density)},
                              {"scene.lmp", scene_text(start, experiment)}};
  for (const auto& [name, text] : lammps_scripts::files)
    files.push_back({std::string(name), std::string(text)});
  for (const auto& [name, text] : lammps_scripts::path_files)
    files.push_back({std::string(name), std::string(text)});
  return files;
}

} // namespace granum::io

// SPDX-License-Identifier: GPL-3.0-or-later
#include <granum/io/lammps/deck.hpp>

#include <set>

#include <granum/core/text.hpp>
#include <granum/io/lammps/files.hpp>

#include "io/import_support.hpp"

using namespace granum::io;
using namespace granum::samples;

namespace {

constexpr contact::GrainMaterial quartz{.shear_modulus = 30e9, .poisson_ratio = 0.15};
constexpr double radius = 0.5e-3;

packing::Assembly three_grains() {
  return {.cell = Mat3::diagonal(4e-3, 4e-3, 4e-3),
          .position = {{1e-3, 2e-3, 2e-3}, {1.9999e-3, 2e-3, 2e-3}, {1.9999e-3, 2e-3, 2.9998e-3}},
          .radius = {radius, radius, radius},
          .contacts = {}};
}

LammpsExperiment experiment_of(const contact::PowerLaw& law) {
  return {.law = law,
          .radius = radius,
          .tangential_ratio = contact::mindlin_stiffness_ratio(0.15),
          .friction_coefficient = 0.5,
          .pressures = {10e3, 30e3},
          .probe_pressures = {30e3}};
}

LammpsExperiment spheres() { return experiment_of(contact::PowerLaw::sphere(quartz, radius)); }

std::string text_of(const std::vector<DeckFile>& deck, const std::string& name) {
  const auto file = std::find_if(deck.begin(), deck.end(), [&](const auto& f) { return f.name == name; });
  REQUIRE(file != deck.end());
  return file->text;
}

/// Value of a number in scene.lmp.
std::string scene_value(const LammpsExperiment& experiment, const std::string& name) {
  std::istringstream scene(text_of(lammps_deck(three_grains(), experiment), "scene.lmp"));
  const std::string start = "variable " + name + " index ";
  for (std::string line; std::getline(scene, line);)
    if (line.starts_with(start))
      return std::string(trimmed(line.substr(start.size(), line.find('#') - start.size())));
  return "missing";
}

double scene_number(const LammpsExperiment& experiment, const std::string& name) {
  return parse_number(scene_value(experiment, name)).value_or(std::numeric_limits<double>::quiet_NaN());
}

std::string refused(const LammpsExperiment& experiment) {
  try {
    (void)lammps_deck(three_grains(), experiment);
  } catch (const InvalidArgument& error) {
    return error.what();
  }
  return "";
}

/// Words that follow `start` at every place in a text.
std::set<std::string> words_after(const std::string& text, const std::string& start) {
  std::set<std::string> words;
  for (std::size_t at = text.find(start); at != std::string::npos; at = text.find(start, at + 1)) {
    const std::size_t from = at + start.size();
    words.insert(text.substr(from, text.find_first_of(" \n\"}", from) - from));
  }
  return words;
}

} // namespace

TEST_CASE("LAMMPS deck: the material is that of the contact law") {
  const LammpsExperiment experiment = spheres();
  CHECK(scene_number(experiment, "young") == relative(69e9, 1e-15)); // 2 G (1 + nu)
  CHECK(scene_number(experiment, "poisson") == 0.15);
  CHECK(scene_number(experiment, "hertz") == experiment.law.power_law()->coefficient());
  // LAMMPS's own default for tangential mindlin is 8 G_eff = 4 G/(2 - nu): Mindlin without slip.
  CHECK(scene_number(experiment, "tangential_stiffness") == relative(4 * 30e9 / (2 - 0.15), 1e-14));
  CHECK(scene_value(experiment, "pressure") == "10000 30000");
  CHECK(scene_value(experiment, "state") == "10kPa 30kPa");
  CHECK(scene_value(experiment, "probe_state") == "30kPa");
  CHECK(scene_value(experiment, "probed_states") == "1");
  CHECK(scene_number(experiment, "friction") == 0.5);
}

TEST_CASE("LAMMPS deck: dense is prepared without friction, states are named by their pressure in kPa") {
  LammpsExperiment experiment = spheres();
  CHECK(scene_number(experiment, "prepare_friction") == 0);
  experiment.friction_while_prepared = true;
  CHECK(scene_number(experiment, "prepare_friction") == 0.5);
  experiment.probe_pressures.clear();
  experiment.pressures = {12.5e3, 100e3, 1e6};
  experiment.start = LammpsStart::scattered;
  CHECK(scene_value(experiment, "probed_states") == "0");
  CHECK(scene_value(experiment, "start") == "scattered");
  CHECK(scene_value(experiment, "state") == "12.5kPa 100kPa 1000kPa");
  CHECK(scene_value(experiment, "pressure") == "12500 100000 1000000");
}

TEST_CASE("LAMMPS deck: a stress path drives one stress in one sense") {
  LammpsExperiment experiment = spheres();
  CHECK(scene_value(experiment, "path") == "none");
  const auto says = [&](bool vertical, bool compresses, const char* drives, const char* sense,
                        const char* sign) {
    experiment.path = LammpsPath{.name = "X1", .drives_vertical = vertical, .compresses = compresses};
    CHECK(scene_value(experiment, "path") == "X1");
    CHECK(scene_value(experiment, "path_start") == "30kPa");
    CHECK(scene_value(experiment, "path_drives") == drives);
    CHECK(scene_value(experiment, "path_sense") == sense);
    CHECK(scene_value(experiment, "path_eta_sign") == sign);
  };
  says(true, true, "axial", "1", "1");      // TXC
  says(true, false, "axial", "-1", "-1");   // RTXE
  says(false, true, "lateral", "1", "-1");  // TXE
  says(false, false, "lateral", "-1", "1"); // RTXC
}

TEST_CASE("LAMMPS deck: every file that is included and every number that is used is there") {
  const std::vector<DeckFile> deck = lammps_deck(three_grains(), spheres());
  std::string all;
  std::set<std::string> names;
  for (const DeckFile& file : deck) {
    names.insert(file.name);
    if (file.name.starts_with("in.") || file.name.ends_with(".lmp"))
      all += file.text + "\n";
  }
  // Named by a variable, or written by a part of the deck.
  const std::set<std::string> written{"${modulus", "path_${path_drives", "state.${path_start",
                                      "state.${probe_state", "path_states.lmp"};
  for (const std::string& name : words_after(all, "include "))
    CHECK_MESSAGE((names.contains(name) || written.contains(name)), name);
  for (const std::string& name : words_after(all, "variable modulus index "))
    CHECK_MESSAGE((name == "" || names.contains(name + ".lmp")), name);
  const std::set<std::string> defined = words_after(all, "variable ");
  for (const std::string& used : words_after(all, "${"))
    CHECK_MESSAGE(defined.contains(used), used);
  CHECK(names.size() == deck.size());
  CHECK(names.contains("in.all"));
}

TEST_CASE("LAMMPS deck: grains of hardly unequal radii give the numbers of equal ones") {
  packing::Assembly unequal = three_grains();
  unequal.radius[1] *= 1 + 1e-9;
  const auto scene = [](const packing::Assembly& start) {
    return text_of(lammps_deck(start, spheres()), "scene.lmp");
  };
  std::istringstream one(scene(three_grains())), other(scene(unequal));
  std::size_t numbers = 0;
  for (std::string a, b; std::getline(one, a) && std::getline(other, b);) {
    const auto value = [](const std::string& line) { // of "variable name index value # meaning"
      std::istringstream words(line);
      std::string word;
      for (int k = 0; k < 4; ++k)
        words >> word;
      return parse_number(word);
    };
    if (const auto x = value(a); x) {
      CAPTURE(a);
      CHECK(std::abs(*x - value(b).value()) <= 1e-7 * std::abs(*x));
      ++numbers;
    }
  }
  CHECK(numbers > 10);
}

TEST_CASE("LAMMPS deck: every number of the scene and every quantity has a unit in its comment") {
  for (const DeckFile& file : lammps_deck(three_grains(), spheres())) {
    std::istringstream lines(file.text);
    bool continued = false;
    for (std::string line; std::getline(lines, line);) {
      CHECK_MESSAGE(line.size() <= 120, (file.name + ": " + line));
      const bool number = line.starts_with("variable ") &&
                          (file.name == "scene.lmp" || line.find(" equal ") != std::string::npos ||
                           line.find(" atom ") != std::string::npos);
      const bool goes_on = line.ends_with("&");
      if ((number || continued) && !goes_on) {
        const std::size_t comment = line.find('#');
        CHECK_MESSAGE((comment != std::string::npos && line.find(']', comment) != std::string::npos),
                      (file.name + ": " + line));
      }
      continued = (number || continued) && goes_on;
    }
  }
}

TEST_CASE("LAMMPS deck: other laws are refused by the name of the one that LAMMPS has") {
  for (const contact::PowerLaw& law :
       {contact::PowerLaw::cone(quartz, 0.4), contact::PowerLaw::flat(quartz, 5.7e-6),
        contact::PowerLaw::general(quartz, 1.5, 180)})
    CHECK(refused(experiment_of(law)).find("sphere") != std::string::npos);
  CHECK(refused(experiment_of(contact::PowerLaw::sphere(quartz, 2 * radius))).find("0.0005 m") !=
        std::string::npos);
  // A profile of alpha = 2 with the sphere's curvature 1/(2R) is the sphere.
  CHECK_NOTHROW((void)lammps_deck(three_grains(),
                                  experiment_of(contact::PowerLaw::general(quartz, 2, 1 / (2 * radius)))));
}

TEST_CASE("LAMMPS deck: impossible experiments are refused by name") {
  using Change = void (*)(LammpsExperiment&);
  const std::pair<const char*, Change> wrong[] = {
      {"pressures", [](auto& e) { e.pressures.clear(); }},
      {"pressures",
       [](auto& e) {
         e.pressures = {30e3, 10e3};
       }},
      {"probe_pressures = 20000", [](auto& e) { e.probe_pressures = {20e3}; }},
      {"friction_coefficient", [](auto& e) { e.friction_coefficient = -1; }},
      {"tangential_ratio", [](auto& e) { e.tangential_ratio = -1; }},
      {"density", [](auto& e) { e.density = 0; }},
      {"path.name", [](auto& e) { e.path->name = ""; }},
      {"path.name", [](auto& e) { e.path->name = "none"; }},
      {"path.name", [](auto& e) { e.path->name = "T.C"; }},
      {"path.name", [](auto& e) { e.path->name = "a b"; }},
      {"path.inertial_number", [](auto& e) { e.path->inertial_number = 0.1; }},
      {"path.eta_step", [](auto& e) { e.path->eta_step = 1e-4; }},
      {"path.largest_strain", [](auto& e) { e.path->largest_strain = 1; }}};
  LammpsExperiment right = spheres();
  right.path = LammpsPath{.name = "TXC"};
  CHECK(refused(right).empty());
  for (const auto& [name, change] : wrong) {
    const std::string named = name;
    CAPTURE(named);
    LammpsExperiment experiment = right;
    change(experiment);
    CHECK(refused(experiment).find(named) != std::string::npos);
  }
}

TEST_CASE("grains of unequal radii: their diameters in the data, a time step for the smallest") {
  packing::Assembly sizes = three_grains();
  sizes.radius = {0.25e-3, 0.5e-3, 0.75e-3};
  const std::vector<DeckFile> deck = lammps_deck(sizes, spheres());
  const std::string data = text_of(deck, "grains.data"), scene = text_of(deck, "scene.lmp");
  for (const char* diameter : {"1 1 0.0005 ", "2 1 0.001 ", "3 1 0.0015 "})
    CHECK(data.find(diameter) != std::string::npos);
  CHECK(scene.find("variable time_step_share index 0.05 ") != std::string::npos);
  CHECK(scene.find("0.00025 to 0.00075 [m]") != std::string::npos);
  const double volume = 4.0 / 3 * 3.14159265358979 * (0.125 + 1 + 3.375) * std::pow(radius, 3);
  const std::string start = "variable first_solid_fraction index ";
  const std::size_t at = scene.find(start) + start.size();
  CHECK(parse_number(scene.substr(at, scene.find(' ', at) - at)).value() ==
        relative(volume / sizes.volume(), 1e-12));
}

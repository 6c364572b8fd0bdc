// SPDX-License-Identifier: GPL-3.0-or-later
#include <filesystem>
#include <memory>
#include <optional>

#include <fmt/core.h>
#include <granum/core/error.hpp>
#include <granum/core/stop.hpp>
#include <granum/io/lammps/deck.hpp>
#include <granum/io/output_file.hpp>
#include <granum/stress/stress.hpp>
#include <granum/triaxial/probe.hpp>

#include "cli/document/document.hpp"
#include "cli/frame/help.hpp"
#include "cli/frame/long_work.hpp"
#include "cli/options/likely_mistakes.hpp"
#include "cli/options/scene_file.hpp"
#include "cli/options/study_options.hpp"

namespace granum::cli {

namespace {

using stress::ShearPath;
namespace fs = std::filesystem;

struct ExportOptions {
  StudyOptions study;
  std::string start = "packed";
  std::string path = "none";
  double eta_step = 0.1;
  double largest_strain = 0.03;
  std::string out;
  bool json = false;
  bool force = false;
  bool strict = false;
};

/// One deck is one specimen of the scene, and has a folder.
using Specimen = studies::SpecimenName;
std::string folder_of(const Specimen& specimen) {
  return fmt::format("{}-{}", studies::name(specimen.density), specimen.seed);
}

void require_spheres(const studies::Scene& scene) {
  for (const contact::Shape shape : scene.study.contacts)
    if (shape != contact::Shape::sphere)
      throw InvalidArgument(fmt::format("LAMMPS has no contact law for study.contacts = {}; supported is "
                                        "sphere: add --set study.contacts=sphere",
                                        contact::name(shape)));
}

/// The test named by --path; empty for none.
std::optional<io::LammpsPath> path_of(const ExportOptions& options) {
  for (const ShearPath path : stress::all_shear_paths)
    if (in_small_letters(std::string(stress::name(path))) == options.path)
      return io::LammpsPath{.name = std::string(stress::name(path)),
                            .drives_vertical = path == ShearPath::txc || path == ShearPath::rtxe,
                            .compresses = path == ShearPath::txc || path == ShearPath::txe,
                            .eta_step = options.eta_step,
                            .largest_strain = options.largest_strain};
  return {};
}

io::LammpsStart start_of(const ExportOptions& options) {
  return options.start == "scattered" ? io::LammpsStart::scattered : io::LammpsStart::packed;
}

io::LammpsExperiment experiment_of(const studies::Scene& scene, const Specimen& specimen,
                                   const ExportOptions& options) {
  const dem::Material material = studies::recipe(scene, contact::Shape::sphere, specimen.seed).material;
  return {.law = material.law,
          .radius = scene.grain.radius,
          .density = material.density,
          .tangential_ratio = material.tangential_ratio,
          .friction_coefficient = material.friction_coefficient,
          .start = start_of(options),
          .friction_while_prepared = specimen.density == triaxial::Density::loose,
          .pressures = scene.study.pressures,
          .probe_pressures = scene.study.probe_pressures,
          .path = path_of(options)};
}

dem::Specimen start_state(const studies::Scene& scene, const Specimen& specimen, io::LammpsStart start,
                          const StopRequest& stop_requested) {
  const triaxial::SpecimenRecipe recipe = studies::recipe(scene, contact::Shape::sphere, specimen.seed);
  if (start == io::LammpsStart::scattered)
    return triaxial::scattered_specimen(recipe);
  return triaxial::start_of_compression(triaxial::frictionless_specimen(recipe, stop_requested).state,
                                        specimen.density, recipe, stop_requested);
}

std::vector<io::DeckFile> deck_of(const studies::Scene& scene, const Specimen& specimen,
                                  const ExportOptions& options, const StopRequest& stop_requested = {}) {
  throw_if_stopped(stop_requested);
  const io::LammpsExperiment experiment = experiment_of(scene, specimen, options);
  packing::Assembly grains =
      dem::contact_network(start_state(scene, specimen, start_of(options), stop_requested),
                           studies::recipe(scene, contact::Shape::sphere, specimen.seed).material);
  std::vector<io::DeckFile> files = io::lammps_deck(grains, experiment);
  Items of;
  io::add_item(of.items, "seed", specimen.seed);
  io::add_item(of.items, "density", std::string(studies::name(specimen.density)));
  Document manifest{.command = "export lammps"};
  manifest.add(Seen::data, std::move(of));
  manifest.add(Seen::data, Data{"scene", json_of(scene)});
  files.push_back({"manifest.json", json_text(with_warnings(json(manifest), likely_mistakes(scene)))});
  return files;
}

/// Makes the folders. The files of a deck have the same names for every specimen, found with a small one.
void prepare_folders(studies::Scene scene, const ExportOptions& options) {
  const std::vector<Specimen> specimens = studies::specimens_of(scene);
  ExportOptions small = options;
  small.start = "scattered";
  scene.study.grains = triaxial::least_grains(scene.grain.sizes);
  const std::vector<io::DeckFile> deck = deck_of(scene, specimens.front(), small);
  std::vector<const char*> names;
  for (const io::DeckFile& file : deck)
    names.push_back(file.name.c_str());
  for (const Specimen& specimen : specimens)
    prepare_folder(fs::path(options.out) / folder_of(specimen), names, options.force);
}

ExitCode run(const ExportOptions& options) {
  const studies::Scene scene = resolve(options.study, studies::SceneCommand::export_lammps);
  require_spheres(scene);
  const Validity slips = likely_mistakes(scene);
  if (refuses(slips, options.strict))
    return ExitCode::not_converged;
  prepare_folders(scene, options);
  const StopRequest stop_requested = [&stop = listen_for_stop()] { return stop.load(); };

  Document to{.command = "export lammps", .title = "input files of LAMMPS"};
  nlohmann::ordered_json written = nlohmann::ordered_json::array();
  Prose folders;
  for (const Specimen& specimen : studies::specimens_of(scene)) {
    const fs::path folder = fs::path(options.out) / folder_of(specimen);
    for (const io::DeckFile& file : deck_of(scene, specimen, options, stop_requested)) {
      io::write_file(folder / file.name, file.text, existing(options.force));
      written.push_back((folder / file.name).string());
    }
    folders.lines.push_back(fmt::format("{}: {} grains", folder.string(), scene.study.grains));
  }
  to.add(Seen::data, Data{"scene", json_of(scene)});
  to.add(Seen::data, Data{"files", std::move(written)});
  to.add(Seen::always, std::move(folders));
  to.add(Seen::always, Prose{{"run in each of these folders: lmp -in in.all (one core), or",
                              "mpirun -np N lmp -in in.all (N cores)"}});
  return deliver({.json = options.json, .strict = false, .force = false, .out = {}}, screen(to, true),
                 with_warnings(json(to), slips), {}); // which are said already
}

} // namespace

Command make_export() {
  auto options = std::make_shared<ExportOptions>();
  Command lammps{.name = "lammps",
                 .meaning = "Input files of LAMMPS (a deck): grains, preparation, isotropic compression, "
                            "a stress path, snapshots, probes",
                 .group = "Commands",
                 .run = [options] { return run(*options); }};
  add_study_options(lammps, options->study, studies::SceneCommand::export_lammps);
  lammps.add(
      "Deck",
      {{.name = "--start",
        .value = choice({"packed", "scattered"}, options->start),
        .meaning =
            "packed: granum makes the initial packing; scattered: LAMMPS makes it from grains that do not "
            "touch, for packings too large for one machine"},
       {.name = "--path",
        .value = choice({"none", "txc", "rtxc", "rtxe", "txe"}, options->path),
        .meaning = "Triaxial test from the last pressure of the isotropic compression; its states are probed "
                   "too"},
       {.name = "--eta-step",
        .value = quantity(options->eta_step, Dimension::dimensionless),
        .meaning = "Increment of q/p between two recorded states of --path"},
       {.name = "--largest-strain",
        .value = quantity(options->largest_strain, Dimension::dimensionless),
        .meaning = "Axial strain at which --path ends"}});
  add_output_place(lammps, options->out, options->force, "DIR",
                   "Folder for the files; each specimen has its own folder in it", "existing files");
  lammps.row("--out").required = true;
  lammps.row("--force").needs.clear();
  lammps.add(output_group, {{.name = "--json",
                             .value = flag(options->json),
                             .meaning = "Print one JSON object: the scene in SI and the files written"}});
  add_strict_scene(lammps, options->strict);
  Command command{.name = "export", .meaning = "Write a scene as input files of another DEM code (LAMMPS)"};
  command.within.push_back(std::move(lammps));
  return command;
}

} // namespace granum::cli

// SPDX-License-Identifier: GPL-3.0-or-later
#include "verify_output.hpp"

#include <algorithm>
#include <fstream>

#include "studies/verify/tables.hpp"
#include <fmt/core.h>
#include <granum/core/error.hpp>

#include "cli/frame/frame.hpp"
#include "cli/frame/json_members.hpp"
#include "cli/options/judgement.hpp"
#include "cli/options/panel_files.hpp"
#include "cli/options/scene_file.hpp"
#include "verify_page.hpp"

namespace granum::cli {

namespace {

using nlohmann::ordered_json;
namespace fs = std::filesystem;

constexpr const char* states_name = "states.csv";
constexpr const char* exponents_name = "exponents.csv";
constexpr const char* local_exponents_name = "local_exponents.csv";
constexpr const char* scene_name = "scene.toml";
constexpr const char* manifest_name = "manifest.json";
constexpr const char* report_name = "report.html";
constexpr const char* figures_name = "figures";
constexpr const char* file_names[] = {states_name,   exponents_name, local_exponents_name, scene_name,
                                      manifest_name, report_name,    figures_name};

/// Writes the report from scene and manifest only, so that it can be repeated for a finished run.
void write_report(const fs::path& folder, const studies::Scene& scene, const ordered_json& manifest,
                  io::Existing existing) {
  const StudyPage page = study_page(scene, manifest);
  write_panels(folder / figures_name, page.panels);
  io::write_file(folder / report_name, page.html, existing);
}

} // namespace

bool StudyOutcome::complete() const {
  return std::all_of(specimens.begin(), specimens.end(), [](const auto& s) { return s.failure.empty(); });
}

std::span<const char* const> study_file_names() { return file_names; }

ordered_json manifest_of(const StudyOutcome& outcome, const std::string& scene_file,
                         const std::vector<std::string>& settings) {
  ordered_json json = json_head("verify");
  json["wall_time_s"] = outcome.seconds;
  json["complete"] = outcome.complete();
  json["scene_file"] = scene_file;
  json["settings"] = settings;
  json["scene"] = json_of(outcome.scene);
  json["threads_used"] = studies::thread_count(outcome.scene);
  json["conventions"] = {
      {"units", "SI, as in the names"},
      {"signs", "compression positive; overlap is the full approach of two centres; z is vertical"},
      {"mass_scaling",
       "translation: none, density times volume; rotational inertia m R^2 instead of 0.4 m R^2"},
      {"time_step", "0.8 of 2/omega with a strict upper bound on omega, chosen by the program"},
      {"damping", "mass-proportional on the non-affine motion, twice the lowest frequency seen"}};
  json["exponents"] = members_of_all(studies::exponent_columns(), outcome.exponents);
  if (!outcome.local_exponents.empty())
    json["local_exponents"] = members_of_all(studies::local_exponent_columns(), outcome.local_exponents);
  json["verdicts"] = members_of_all(studies::verdict_columns(), outcome.verdicts);
  json["specimens"] = ordered_json::array();
  for (const studies::SpecimenResult& specimen : outcome.specimens) {
    json["specimens"].push_back({{"contact", contact::name(specimen.contact)},
                                 {"density", studies::name(specimen.density)},
                                 {"seed", specimen.seed},
                                 {"failure", specimen.failure},
                                 {"left_out", specimen.left_out},
                                 {"states", members_of_all(studies::state_columns(), specimen.states)}});
  }
  return json;
}

void write_results(const fs::path& folder, const StudyOutcome& outcome, const ordered_json& manifest,
                   io::Existing existing) {
  io::write_file(folder / states_name, studies::states_csv(outcome.scene, outcome.specimens), existing);
  io::write_file(folder / exponents_name, studies::exponents_csv(outcome.exponents), existing);
  if (!outcome.local_exponents.empty())
    io::write_file(folder / local_exponents_name, studies::local_exponents_csv(outcome.local_exponents),
                   existing);
  io::write_file(folder / scene_name, studies::toml_of(outcome.scene), existing);
  write_report(folder, outcome.scene, manifest, existing);
  io::write_file(folder / manifest_name, json_text(manifest), existing);
}

void rewrite_report(const fs::path& folder) {
  const studies::Scene scene = read_scene((folder / scene_name).string(), studies::SceneCommand::verify);
  const fs::path file = folder / manifest_name;
  std::ifstream in(file, std::ios::binary);
  if (!in)
    throw FileError(file.string(), 0, "could not be opened");
  try {
    write_report(folder, scene, ordered_json::parse(in), io::Existing::replace);
  } catch (const nlohmann::json::exception& error) {
    throw FileError(file.string(), 0, std::string("is not a manifest of granum verify: ") + error.what());
  } catch (const std::bad_optional_access&) {
    throw FileError(file.string(), 0, "contains an unknown shape of contacts");
  }
}

std::string report_of(const StudyOutcome& outcome) {
  return fmt::format(
      "{}\n{}\n{}{}\n{} specimens of {} grains in {:.1f} s on {}\n", studies::states_table(outcome.specimens),
      studies::exponents_table(outcome.exponents),
      outcome.local_exponents.empty() ? "" : studies::local_exponents_table(outcome.local_exponents) + "\n",
      studies::verdicts_table(outcome.verdicts), outcome.specimens.size(), outcome.scene.study.grains,
      outcome.seconds, threads_text(studies::thread_count(outcome.scene)));
}

} // namespace granum::cli

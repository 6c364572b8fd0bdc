// SPDX-License-Identifier: GPL-3.0-or-later
#include "verify_output.hpp"

#include <algorithm>

#include "studies/report/compression.hpp"
#include "studies/report/verdict_lists.hpp"
#include "studies/verify/tables.hpp"
#include <fmt/core.h>
#include <granum/core/error.hpp>
#include <granum/io/text/source.hpp>
#include <granum/plot/page.hpp>

#include "cli/frame/frame.hpp"
#include "cli/frame/json_members.hpp"
#include "cli/options/scene_file.hpp"
#include "cli/options/study_options.hpp"

namespace granum::cli {

namespace {

using nlohmann::ordered_json;
using studies::Compression;
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

std::optional<double> number_at(const ordered_json& json, const char* key) {
  return io::number_of(value_at(json, key));
}

std::optional<Measured> measured_at(const ordered_json& json, const char* key) {
  const io::Value value = value_at(json, key);
  const auto* measured = std::get_if<Measured>(&value);
  return measured == nullptr ? std::nullopt : std::optional(*measured);
}

/// Rung 3 of a state: uniform strain from the manifest, times the relaxation factor at its z*.
std::optional<double> relaxed_modulus(const studies::Scene& scene, contact::Shape shape, double z_star,
                                      const std::optional<double>& uniform_strain) {
  if (!uniform_strain)
    return std::nullopt;
  return *uniform_strain * studies::shear_relaxation(scene, shape, z_star);
}

studies::RouteState route_state(const studies::Scene& scene, contact::Shape shape,
                                const ordered_json& state) {
  const double z_star = state.at("mechanical_coordination_number").get<double>();
  const auto relaxed = relaxed_modulus(scene, shape, z_star, number_at(state, "G_closed_Pa"));
  const auto vertical = number_at(state, "G_vh_network_Pa");
  const auto network = number_at(state, "G_network_Pa"), affine = number_at(state, "G_uniform_strain_Pa");
  studies::RouteState out{.pressure = state.at("pressure_Pa").get<double>(),
                          .mechanical_coordination_number = z_star,
                          .network = {vertical, vertical, number_at(state, "G_hh_network_Pa")},
                          .relaxed = {relaxed, relaxed, relaxed}};
  if (network && affine)
    out.softening = *network / *affine;
  out.probe = {number_at(state, "probes/G_hv_Pa"), number_at(state, "probes/G_vh_Pa"),
               number_at(state, "probes/G_hh_Pa")};
  return out;
}

contact::Shape shape_of(const ordered_json& row) {
  return contact::find_shape(row.at("contact").get<std::string>()).value();
}

triaxial::Density density_of(const ordered_json& row) {
  return row.at("density").get<std::string>() == studies::name(triaxial::Density::dense)
             ? triaxial::Density::dense
             : triaxial::Density::loose;
}

std::vector<studies::Verdict> verdicts_of(const ordered_json& manifest) {
  std::vector<studies::Verdict> out;
  for (const ordered_json& one : manifest.at("verdicts"))
    out.push_back({.claim = one.at("claim").get<std::string>(),
                   .holds = one.at("holds").get<bool>(),
                   .measured = one.at("measured").get<std::string>(),
                   .finding = one.at("finding").get<bool>()});
  return out;
}

constexpr const char* columns_text =
    "Columns of the tables below: p mean stress, e void ratio, C_n contacts per grain, z* contacts per grain "
    "without rattlers (grains that carry no load); G in MPa. G formula: closed form of uniform strain, from "
    "C_n and e. G network: linear response of the contact network, every grain in equilibrium. G_hh "
    "(horizontal plane), G_hv and G_vh (vertical plane): by the DEM probe, a small cyclic shear.";

std::string all_states(const ordered_json& manifest) {
  std::string out;
  for (const ordered_json& specimen : manifest.at("specimens")) {
    const std::string failure = specimen.at("failure").get<std::string>();
    out += plot::html_folded(fmt::format("{}, {}, seed {}", specimen.at("contact").get<std::string>(),
                                         specimen.at("density").get<std::string>(),
                                         specimen.at("seed").get<std::uint64_t>()),
                             page_table_of(studies::state_columns(), specimen.at("states")) +
                                 (failure.empty() ? "" : plot::html_paragraph("Ended early: " + failure)));
  }
  return out;
}

std::string run_text(const studies::Scene& scene, const ordered_json& manifest) {
  return fmt::format("granum {} verify: {} specimens of {} grains in {:.1f} s on {}{}. All numbers are in "
                     "states.csv and exponents.csv, the input in scene.toml and manifest.json.",
                     manifest.at("version").get<std::string>(), manifest.at("specimens").size(),
                     scene.study.grains, manifest.at("wall_time_s").get<double>(),
                     threads_text(manifest.at("threads_used").get<std::size_t>()),
                     manifest.at("complete").get<bool>() ? "" : "; NOT COMPLETE, some specimens ended early");
}

/// The first specimen of each contact and density in a manifest of verify, with s over all seeds.
/// \throws   nlohmann::json::exception if it is not such a manifest
std::vector<Compression> compressions_of(const studies::Scene& scene, const ordered_json& manifest) {
  std::vector<Compression> out;
  for (const ordered_json& row : manifest.at("exponents")) {
    Compression one{.contact = shape_of(row),
                    .density = density_of(row),
                    .contact_exponent = row.at("contact_law").get<double>(),
                    .exponent = measured_at(row, "network"),
                    .paper_exponent = number_at(row, "paper")};
    const ordered_json& specimens = manifest.at("specimens");
    const auto first = std::find_if(specimens.begin(), specimens.end(), [&](const ordered_json& specimen) {
      return shape_of(specimen) == one.contact && density_of(specimen) == one.density;
    });
    if (first != specimens.end())
      for (const ordered_json& state : first->at("states"))
        one.states.push_back(route_state(scene, one.contact, state));
    out.push_back(std::move(one));
  }
  return out;
}

/// The report as a page.
struct StudyPage {
  std::string html;
  std::vector<studies::Panel> panels; ///< its pictures
};

/// The report of a run, from its scene and its manifest only.
/// \throws   nlohmann::json::exception if that is not a manifest of verify
StudyPage study_page(const studies::Scene& scene, const ordered_json& manifest) {
  studies::CompressionStory story =
      studies::compression_story(scene, compressions_of(scene, manifest), figures_name);
  const std::string body =
      story.first_screen + story.why +
      plot::html_section(
          "verdicts", "Agreement and differences with the paper",
          plot::html_paragraph(
              "s by uniform strain, contact network and DEM probe, compared with the paper: "
              "G_hv in Table 5 of Chung, Jang, Baek and Jung, Granular Matter 16 (2014) 23-39. "
              "Law: the exponent of a single contact, 1/(1+\u03b1) for the profile r^\u03b1; formula: closed "
              "form of uniform strain; with f(e): G of the network divided by f(e) = (2.17 - e)^2/(1 + e), e "
              "the void ratio.",
              "soft") +
              page_table_of(studies::exponent_columns(), manifest.at("exponents")) +
              studies::verdict_lists(verdicts_of(manifest))) +
      plot::html_section("run", "The run",
                         plot::html_paragraph(run_text(scene, manifest)) +
                             plot::html_paragraph(columns_text, "soft") + all_states(manifest));
  return {.html = plot::html_page("granum verify: why G grows as p^s", body),
          .panels = std::move(story.panels)};
}

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
  const fs::path file = folder / manifest_name;
  try {
    const ordered_json manifest = ordered_json::parse(io::file_content(file));
    if (const std::string command = manifest.at("command").get<std::string>(); command != "verify")
      throw FileError(folder.string(), 0,
                      fmt::format("holds results of granum {}, none of granum verify", command));
    const studies::Scene scene = read_scene((folder / scene_name).string(), studies::SceneCommand::verify);
    write_report(folder, scene, manifest, io::Existing::replace);
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

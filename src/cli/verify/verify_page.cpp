// SPDX-License-Identifier: GPL-3.0-or-later
#include "verify_page.hpp"

#include <algorithm>

#include "studies/report/verdict_lists.hpp"
#include "studies/verify/tables.hpp"
#include <fmt/core.h>
#include <granum/plot/page.hpp>

#include "cli/frame/frame.hpp"
#include "cli/frame/json_members.hpp"

namespace granum::cli {

namespace {

using nlohmann::ordered_json;
using studies::Compression;

constexpr const char* figures_folder = "figures";

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

} // namespace

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

StudyPage study_page(const studies::Scene& scene, const ordered_json& manifest) {
  studies::CompressionStory story =
      studies::compression_story(scene, compressions_of(scene, manifest), figures_folder);
  const std::string body =
      story.first_screen + story.why +
      plot::html_section(
          "verdicts", "Agreement and differences with the paper",
          plot::html_paragraph(
              "s by uniform strain, contact network and DEM probe, compared with the paper: "
              "G_hv in Table 5 of Chung, Jang, Baek and Jung, Granular Matter 16 (2014) 23-39. "
              "Law: 1/(1+\u03b1) of a single contact; with f(e): G of the network divided "
              "by a function of the void ratio.",
              "soft") +
              page_table_of(studies::exponent_columns(), manifest.at("exponents")) +
              studies::verdict_lists(verdicts_of(manifest))) +
      plot::html_section("run", "The run",
                         plot::html_paragraph(run_text(scene, manifest)) + all_states(manifest));
  return {.html = plot::html_page("granum verify: why G grows as p^s", body),
          .panels = std::move(story.panels)};
}

} // namespace granum::cli

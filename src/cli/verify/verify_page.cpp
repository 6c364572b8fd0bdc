// SPDX-License-Identifier: GPL-3.0-or-later
#include "verify_page.hpp"

#include <algorithm>

#include "studies/report/verdict_lists.hpp"
#include <fmt/core.h>
#include <granum/core/number.hpp>
#include <granum/effective/relaxation.hpp>
#include <granum/plot/page.hpp>

namespace granum::cli {

namespace {

using nlohmann::ordered_json;
using studies::Compression;

constexpr const char* figures_folder = "figures";

std::optional<double> number_at(const ordered_json& json, const char* name) {
  const auto found = json.find(name);
  return found == json.end() || found->is_null() ? std::nullopt : std::optional(found->get<double>());
}

std::optional<Measured> measured_at(const ordered_json& json, const char* name) {
  const ordered_json& found = json.at(name);
  if (found.is_null())
    return std::nullopt;
  return Measured{found.at("value").get<double>(), found.at("standard_error").get<double>()};
}

/// Rung 3 of a state: the uniform strain that the manifest has, times the relaxation of its z*.
std::optional<double> relaxed_modulus(const studies::Scene& scene, contact::Shape shape, double z_star,
                                      const std::optional<double>& uniform_strain) {
  if (!uniform_strain)
    return std::nullopt;
  const dem::Material material = studies::recipe(scene, shape, scene.study.first_seed).material;
  return *uniform_strain *
         effective::relaxation(z_star, material.tangential_ratio, material.law.stiffness_exponent())
             .shear.value;
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
  if (const auto probes = state.find("probes"); probes != state.end())
    out.probe = {number_at(*probes, "G_hv_Pa"), number_at(*probes, "G_vh_Pa"), number_at(*probes, "G_hh_Pa")};
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

std::string shown(const std::optional<Measured>& exponent) {
  return exponent ? fmt::format("{:.3f} \u00b1 {:.3f}", exponent->value, exponent->standard_error) : "";
}

std::string exponents_table(const ordered_json& manifest) {
  std::vector<std::vector<std::string>> rows;
  for (const ordered_json& row : manifest.at("exponents")) {
    const auto paper = number_at(row, "paper");
    rows.push_back({row.at("contact").get<std::string>(), row.at("density").get<std::string>(),
                    fmt::format("{:.3f}", row.at("contact_law").get<double>()),
                    shown(measured_at(row, "closed_form")), shown(measured_at(row, "network")),
                    shown(measured_at(row, "probe")), paper ? fmt::format("{:.3f}", *paper) : ""});
  }
  return plot::html_table({"Contact", "Density", "1/(1+\u03b1)", "closed form", "network", "probe", "paper"},
                          rows);
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

std::string states_table(const ordered_json& specimen) {
  std::vector<std::vector<std::string>> rows;
  const auto cell = [](const ordered_json& state, const char* name, double unit, int digits) {
    const auto value = number_at(state, name);
    return value ? short_text(*value / unit, digits) : "";
  };
  for (const ordered_json& state : specimen.at("states"))
    rows.push_back({cell(state, "pressure_Pa", 1e3, 4), cell(state, "coordination_number", 1, 4),
                    cell(state, "mechanical_coordination_number", 1, 4), cell(state, "void_ratio", 1, 4),
                    cell(state, "G_closed_Pa", 1e6, 4), cell(state, "G_network_Pa", 1e6, 4)});
  return plot::html_table({"p' [kPa]", "C_n", "z*", "e", "G uniform strain [MPa]", "G network [MPa]"}, rows);
}

std::string all_states(const ordered_json& manifest) {
  std::string out;
  for (const ordered_json& specimen : manifest.at("specimens")) {
    const std::string failure = specimen.at("failure").get<std::string>();
    out += plot::html_folded(
        fmt::format("{}, {}, seed {}", specimen.at("contact").get<std::string>(),
                    specimen.at("density").get<std::string>(), specimen.at("seed").get<std::uint64_t>()),
        states_table(specimen) + (failure.empty() ? "" : plot::html_paragraph("Ended early: " + failure)));
  }
  return out;
}

std::string run_text(const studies::Scene& scene, const ordered_json& manifest) {
  return fmt::format(
      "granum {} verify: {} specimens of {} grains in {:.1f} s on {} threads{}. All numbers stand in "
      "states.csv and exponents.csv, all that was asked for in scene.toml and manifest.json.",
      manifest.at("version").get<std::string>(), manifest.at("specimens").size(), scene.study.grains,
      manifest.at("wall_time_s").get<double>(), manifest.at("threads_used").get<std::size_t>(),
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
          "verdicts", "What agrees with the paper, and what does not",
          plot::html_paragraph("Closed form, contact network and DEM probe beside Table 5 of Chung, Jang, "
                               "Baek and Jung, Granular Matter 16 (2014) 23-39.",
                               "soft") +
              exponents_table(manifest) + studies::verdict_lists(verdicts_of(manifest))) +
      plot::html_section("run", "The run",
                         plot::html_paragraph(run_text(scene, manifest)) + all_states(manifest));
  return {.html = plot::html_page("granum verify: why G grows as p^s", body),
          .panels = std::move(story.panels)};
}

} // namespace granum::cli

// SPDX-License-Identifier: GPL-3.0-or-later
#include "verify_document.hpp"

#include <algorithm>

#include "studies/plan/plan.hpp"
#include "studies/verify/local_exponents.hpp"
#include "studies/verify/tables.hpp"
#include <fmt/format.h>
#include <granum/core/error.hpp>
#include <granum/io/text/source.hpp>

#include "cli/frame/json_members.hpp"
#include "cli/options/scene_file.hpp"
#include "compression.hpp"

namespace granum::cli {

namespace {

using nlohmann::ordered_json;
using studies::Verdict;
namespace fs = std::filesystem;

constexpr const char* states_name = "states.csv";
constexpr const char* exponents_name = "exponents.csv";
constexpr const char* local_exponents_name = "local_exponents.csv";
constexpr const char* scene_name = "scene.toml";
constexpr const char* manifest_name = "manifest.json";
constexpr const char* page_name = "report.html";
constexpr const char* file_names[] = {states_name,   exponents_name, local_exponents_name, scene_name,
                                      manifest_name, page_name,      figures_name};

// ---- results read again

/// The value at the key of a column, null where it is null.
io::Value value_at(const ordered_json& object, const std::string& key) {
  const ordered_json::json_pointer place("/" + key);
  if (!object.contains(place))
    return {};
  const ordered_json& at = object.at(place);
  if (at.is_object())
    return Measured{at.at("value").get<double>(), at.at("standard_error").get<double>()};
  if (at.is_null())
    return nullptr;
  if (at.is_boolean())
    return at.get<bool>();
  if (at.is_number_integer())
    return at.get<std::int64_t>();
  return at.is_number() ? io::Value(at.get<double>()) : io::Value(at.get<std::string>());
}

/// The columns of a table that have a key in JSON, of rows as it has them.
template <class Row>
io::Columns<ordered_json> of_results(const io::Columns<Row>& columns) {
  io::Columns<ordered_json> out;
  for (const io::Column<Row>& column : columns)
    if (!column.key.empty()) {
      out.emplace_back(
          column.heading, column.key,
          [key = column.key](const ordered_json& row) { return value_at(row, key); }, column.shown);
      out.back().has_error = column.has_error;
    }
  return out;
}

using Objects = std::vector<ordered_json>;
Objects rows_of(const ordered_json& list) { return {list.begin(), list.end()}; }

std::optional<double> number_at(const ordered_json& json, const char* key) {
  return io::number_of(value_at(json, key));
}

std::vector<Verdict> verdicts_of(const ordered_json& results) {
  std::vector<Verdict> out;
  for (const ordered_json& one : results.at("verdicts"))
    out.push_back({.claim = one.at("claim").get<std::string>(),
                   .holds = one.at("holds").get<bool>(),
                   .measured = one.at("measured").get<std::string>(),
                   .finding = one.at("finding").get<bool>(),
                   .decided = one.value("decided", true)});
  return out;
}

// ---- compression

RouteState route_state(const studies::Scene& scene, contact::Shape shape, const ordered_json& state) {
  const double z_star = state.at("mechanical_coordination_number").get<double>();
  const auto uniform = number_at(state, "G_closed_Pa"), vertical = number_at(state, "G_vh_network_Pa");
  RouteState out{.pressure = state.at("pressure_Pa").get<double>(),
                 .mechanical_coordination_number = z_star,
                 .network = {vertical, vertical, number_at(state, "G_hh_network_Pa")},
                 .probe = {number_at(state, "probes/G_hv_Pa"), number_at(state, "probes/G_vh_Pa"),
                           number_at(state, "probes/G_hh_Pa")}};
  if (const auto rung3 = number_at(state, "G_rung3_Pa"))
    out.relaxed.fill(*rung3);
  else if (uniform) // of a run before this column was there
    out.relaxed.fill(*uniform * shear_relaxation(scene, shape, z_star));
  const auto network = number_at(state, "G_network_Pa"), affine = number_at(state, "G_uniform_strain_Pa");
  if (network && affine)
    out.softening = *network / *affine;
  return out;
}

/// The first specimen of each contact and density, with s over all seeds.
std::vector<Compression> compressions_of(const studies::Scene& scene, const ordered_json& results) {
  std::vector<Compression> out;
  for (const ordered_json& row : results.at("exponents")) {
    Compression one{.contact = contact::find_shape(row.at("contact").get<std::string>()).value(),
                    .density = row.at("density") == studies::name(triaxial::Density::dense)
                                   ? triaxial::Density::dense
                                   : triaxial::Density::loose,
                    .contact_exponent = row.at("contact_law").get<double>()};
    const io::Value network = value_at(row, "network");
    if (const auto* exponent = std::get_if<Measured>(&network))
      one.exponent = *exponent;
    const ordered_json& specimens = results.at("specimens");
    const auto first = std::ranges::find_if(specimens, [&row](const ordered_json& specimen) {
      return specimen.at("contact") == row.at("contact") && specimen.at("density") == row.at("density");
    });
    if (first != specimens.end())
      for (const ordered_json& state : first->at("states"))
        one.states.push_back(route_state(scene, one.contact, state));
    out.push_back(std::move(one));
  }
  return out;
}

// ---- sections

/// The states of each specimen, and what was left out.
void add_states(Document& to, const ordered_json& results) {
  Prose left_out;
  for (const ordered_json& specimen : results.at("specimens")) {
    const std::string title =
        fmt::format("{}, {}, seed {}", specimen.at("contact").get<std::string>(),
                    specimen.at("density").get<std::string>(), specimen.at("seed").get<std::uint64_t>());
    Table table = table_of("", title, of_results(studies::state_columns()), rows_of(specimen.at("states")));
    table.folded = true;
    to.add(Seen::always, std::move(table));
    for (const ordered_json& why : specimen.at("left_out"))
      left_out.lines.push_back(fmt::format("{}: left out: at {}", title, why.get<std::string>()));
    if (const auto failure = specimen.at("failure").get<std::string>(); !failure.empty())
      left_out.lines.push_back(fmt::format("{}: ended early: {}", title, failure));
  }
  if (!left_out.lines.empty())
    to.add(Seen::always, std::move(left_out));
  to.add(
      Seen::always,
      Prose{{"G in MPa; C_n: contacts per grain, z*: the same without rattlers (grains that carry no load); "
             "G formula: closed form of uniform strain, from C_n and e (void ratio); G network: linear "
             "response, every grain in equilibrium; G_hh (horizontal plane), G_hv, G_vh (vertical plane): "
             "by the probe, a small cyclic shear of the DEM specimen; * G network / G of the same network "
             "under uniform strain"}});
}

Table exponent_table(const ordered_json& results) {
  Table out = table_of("", "s of G ~ p^s, +- standard error; law: 1/(1+alpha)",
                       of_results(studies::exponent_columns()), rows_of(results.at("exponents")));
  out.remark =
      "law: s of a single contact; alpha: exponent of its profile, cone 1, sphere 2; formula: closed "
      "form of uniform strain; with f(e): G of the network divided by f(e) = (2.17-e)^2/(1+e); paper: "
      "G_hv in Table 5 of Chung et al. 2014";
  return out;
}

/// Without rows for laws of one exponent.
Table local_exponent_table(const ordered_json& results) {
  Table out = table_of("", "s between neighbouring pressures", of_results(studies::local_exponent_columns()),
                       rows_of(results.value("local_exponents", ordered_json::array())));
  out.remark =
      "below p* roughness matters; law: d ln k_n/d ln f of a contact, k_n its normal stiffness, f its "
      "force; strain: uniform strain; rung 3: uniform strain with the relaxation factor";
  return out;
}

Table all_states(const ordered_json& results) {
  io::Columns<ordered_json> columns = of_results(studies::state_columns());
  for (const char* key : {"seed", "density", "contact"})
    columns.insert(columns.begin(),
                   {key, "", [key](const ordered_json& state) { return value_at(state, key); }});
  Objects rows;
  for (const ordered_json& specimen : results.at("specimens"))
    for (const ordered_json& state : specimen.at("states"))
      rows.emplace_back(specimen).update(state);
  return table_of("", "", columns, rows);
}

/// A file of rows with its comments.
std::string csv_of(Table table, std::vector<std::pair<std::string, std::string>> comments) {
  Document out{.command = "verify", .signs = "", .comments = std::move(comments)};
  out.add(Seen::data, std::move(table));
  return csv(out);
}

} // namespace

bool complete(const std::vector<studies::SpecimenResult>& specimens) {
  return std::ranges::all_of(specimens, [](const auto& specimen) { return specimen.failure.empty(); });
}

ordered_json results_of(const studies::Scene& scene, const std::vector<studies::SpecimenResult>& specimens,
                        const std::vector<Verdict>& verdicts, double seconds, const StudyOptions& options,
                        const Validity& slips) {
  ordered_json json = {
      {"wall_time_s", seconds},
      {"complete", complete(specimens)},
      {"scene_file", options.scene_file},
      {"settings", options.settings},
      {"scene", json_of(scene)},
      {"threads_used", studies::thread_count(scene)},
      {"conventions",
       {{"units", "SI, as in the names"},
        {"signs", "compression positive; overlap is the full approach of two centres; z is vertical"},
        {"mass_scaling",
         "translation: none, density times volume; rotational inertia m R^2 instead of 0.4 m R^2"},
        {"time_step", "0.8 of 2/omega with a strict upper bound on omega, chosen by the program"},
        {"damping", "mass-proportional on the non-affine motion, twice the lowest frequency seen"}}},
      {"exponents", members_of_all(studies::exponent_columns(), studies::exponents(scene, specimens))}};
  if (const auto local = studies::local_exponents(scene, specimens); !local.empty())
    json["local_exponents"] = members_of_all(studies::local_exponent_columns(), local);
  json["verdicts"] = members_of_all(studies::verdict_columns(), verdicts);
  ordered_json& each = json["specimens"] = ordered_json::array();
  for (const studies::SpecimenResult& specimen : specimens)
    each.push_back({{"contact", contact::name(specimen.contact)},
                    {"density", studies::name(specimen.density)},
                    {"seed", specimen.seed},
                    {"failure", specimen.failure},
                    {"left_out", specimen.left_out},
                    {"states", members_of_all(studies::state_columns(), specimen.states)}});
  return with_warnings(std::move(json), slips);
}

Table verdict_table(const std::vector<Verdict>& verdicts) {
  io::Columns<Verdict> columns = studies::verdict_columns();
  columns.push_back({"", "", studies::word_of, io::ShownColumn{.heading = "", .width = -11}});
  columns.push_back({"", "", [](const Verdict& v) { return v.claim + ": " + v.measured; },
                     io::ShownColumn{.heading = "", .width = -1}});
  Table out =
      table_of("verdicts", "agreement with the paper, and checks of granum itself", columns, verdicts);
  const auto findings = std::ranges::count_if(verdicts, &Verdict::finding);
  const auto of = [&](bool decided) {
    return std::ranges::count_if(verdicts, [=](const Verdict& v) {
      return v.finding && v.decided == decided && (v.holds || !decided);
    });
  };
  if (findings > 0)
    out.remark = fmt::format(
        "{} of {} results of the paper are reproduced{}; a difference is a result, not a "
        "failure",
        of(true), findings,
        of(false) > 0 ? fmt::format(", {} undecided: the limit is within a standard error", of(false)) : "");
  return out;
}

Items scene_items(const studies::Scene& scene) {
  Items out{.title = "the scene, in SI"};
  const ordered_json all = json_of(scene);
  for (const auto& [section, keys] : all.items())
    for (const auto& [key, value] : keys.items()) {
      const io::ShownColumn look = shown_as(fmt::format("{}.{}", section, key));
      if (value.is_number_float())
        io::add_item(out.items, "", value.get<double>(), look);
      else
        io::add_item(out.items, "", value.is_string() ? value.get<std::string>() : json_text(value, -1),
                     look);
    }
  return out;
}

void add_cost_of_sizes(Document& to, const studies::Scene& scene) {
  if (const std::string cost = studies::cost_of_sizes(scene); !cost.empty())
    to.add_notes(std::vector<std::string>{cost});
}

StudyDocument study_document(const studies::Scene& scene, const ordered_json& results) {
  StudyDocument out;
  Document& to = out.document = {.command = "verify"};
  const std::size_t specimens = results.at("specimens").size();
  to.title =
      fmt::format("Why G grows as p^s: {} specimen{} of {} grains in {:.1f} s on {}{}", specimens,
                  specimens == 1 ? "" : "s", scene.study.grains, results.at("wall_time_s").get<double>(),
                  threads_text(results.at("threads_used").get<std::size_t>()),
                  results.at("complete").get<bool>() ? "" : "; not complete, some ended early");
  out.panels = add_compression(to, scene, compressions_of(scene, results));
  add_states(to, results);
  to.add(Seen::always, exponent_table(results));
  to.add(Seen::always, local_exponent_table(results));
  Table verdicts = verdict_table(verdicts_of(results));
  verdicts.key.clear(); // among the results
  to.add(Seen::always, std::move(verdicts));
  const ordered_json head = json_head("verify");
  for (const auto& [key, value] : results.items())
    if (!head.contains(key) && key != "notes" && key != "warnings")
      to.add(Seen::data, Data{key, value});
  to.add(Seen::full, scene_items(scene));
  add_cost_of_sizes(to, scene);
  to.add_notes(std::vector<std::string>{
      "The paper is [Chung2014]; s of its G_hv is that of Table 5.",
      "All numbers are in states.csv, exponents.csv and manifest.json, the input in scene.toml."});
  for (const ordered_json& warning : results.value("warnings", ordered_json::array()))
    to.warnings.add(warning.get<std::string>());
  return out;
}

std::span<const char* const> study_file_names() { return file_names; }

namespace {

void write_page(const fs::path& folder, const StudyDocument& study, io::Existing existing) {
  write_panels(folder / figures_name, study.panels);
  io::write_file(folder / page_name, page(study.document), existing);
}

} // namespace

void write_results(const fs::path& folder, const studies::Scene& scene, const StudyDocument& study,
                   const ordered_json& manifest, io::Existing existing) {
  const auto write = [&](const char* name, const std::string& text) {
    io::write_file(folder / name, text, existing);
  };
  write(states_name, csv_of(all_states(manifest),
                            {{"grains", std::to_string(scene.study.grains)},
                             {"signs", "compression positive; z is the vertical axis v"},
                             {"moduli", "closed: closed form of uniform strain; uniform_strain: the contact "
                                        "network with every grain moved by the mean strain; network: every "
                                        "grain in equilibrium; probe: cyclic shear by DEM; K_lower, K_upper: "
                                        "bounds of K_network"}}));
  write(
      exponents_name,
      csv_of(exponent_table(manifest),
             {{"meaning", "s of G ~ p^s, fitted to G by the Levenberg-Marquardt method; paper: s of G_hv in "
                          "Table 5 of Chung et al. 2014"},
              {"columns", "contact_law: of a single contact; closed_form: uniform strain; network_with_f_e: "
                          "G of the network divided by f(e) = (2.17-e)^2/(1+e); *_error: standard error"}}));
  if (Table local = local_exponent_table(manifest); !local.rows.empty())
    write(local_exponents_name,
          csv_of(std::move(local),
                 {{"meaning", "d ln G/d ln p between neighbouring pressures; p_Pa: their geometric mean; "
                              "contact_law: d ln k_n/d ln f (k_n: normal stiffness, f: normal force) at the "
                              "mean force"}}));
  write(scene_name, studies::toml_of(scene));
  write_page(folder, study, existing);
  write(manifest_name, json_text(manifest));
}

void rewrite_page(const fs::path& folder) {
  const fs::path file = folder / manifest_name;
  try {
    const ordered_json manifest = ordered_json::parse(io::file_content(file));
    if (const std::string command = manifest.at("command").get<std::string>(); command != "verify")
      throw FileError(folder.string(), 0,
                      fmt::format("holds results of granum {}, none of granum verify", command));
    const studies::Scene scene = read_scene((folder / scene_name).string(), studies::SceneCommand::verify);
    write_page(folder, study_document(scene, manifest), io::Existing::replace);
  } catch (const nlohmann::json::exception& error) {
    throw FileError(file.string(), 0, std::string("is not a manifest of granum verify: ") + error.what());
  } catch (const std::bad_optional_access&) {
    throw FileError(file.string(), 0, "contains an unknown shape of contacts");
  }
}

} // namespace granum::cli

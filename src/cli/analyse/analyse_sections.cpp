// SPDX-License-Identifier: GPL-3.0-or-later
// What was measured of all frames, as a document.
#include <algorithm>
#include <cmath>

#include <fmt/format.h>
#include <granum/core/text.hpp>
#include <granum/core/units.hpp>

#include "analyse_fields.hpp"
#include "cli/frame/json_members.hpp"
#include "cli/options/packing_json.hpp"

namespace granum::cli {

namespace {

using analysis::Measurement;
using io::ShownColumn;
using nlohmann::ordered_json;

// ---- sections of a frame

/// Values that are shown in a list.
template <class Part>
void add_values(Items& to, const io::Columns<Part>& fields, const Part& part) {
  for (const io::Column<Part>& field : fields)
    if (field.shown)
      io::add_item(to.items, "", field.of(part), field.shown);
}
void add_text(Items& to, const std::string& label, const std::string& value,
              const std::string& meaning = "") {
  io::add_item(to.items, "", value, ShownColumn{.heading = label, .meaning = meaning});
}
/// A part under its title, if it exists.
template <class Part>
void add_part(Document& to, const char* title, const io::Columns<Part>& fields,
              const std::optional<Part>& part) {
  Items list{.title = title};
  if (part)
    add_values(list, fields, *part);
  to.add(Seen::always, std::move(list));
}

Prose heading_of(const FrameAnswer& frame) {
  std::string title = fmt::format("frame {}, step {}", frame.number, frame.measured.step);
  if (frame.measured.time)
    title += fmt::format(", time {} s", short_text(*frame.measured.time, 6));
  Prose out{{title}};
  for (const bool missing : {false, true}) {
    const std::size_t before = out.lines.size();
    for (const io::ImportNote& note : frame.read)
      if (says_what_is_missing(note.finding) == missing)
        out.lines.push_back("- " + note.text);
    if (out.lines.size() > before)
      out.lines.insert(out.lines.begin() + static_cast<std::ptrdiff_t>(before),
                       missing ? "not in the files" : "found while reading");
  }
  return out;
}

Items counts_of(const studies::MeasuredFrame& frame) {
  const Measurement& a = frame.packing;
  Items list{.title = "grains and contacts"};
  add_values(list, packing_fields(), a);
  add_values(list, grain_count_fields(), a.counts);
  if (!frame.contacts_known) {
    add_text(list, "C_n, z*, rattlers", "unknown", "no file contains contacts");
    return list;
  }
  if (a.sizes.smallest != a.sizes.largest)
    add_text(list, "means", means_text(a.sizes.contacts), "for closed forms");
  const bool rigid_bodies = a.counts.bodies != 0 && a.counts.bodies != a.counts.grains;
  if (rigid_bodies)
    add_text(list, "rigid bodies N", std::to_string(a.counts.bodies), "counted below");
  add_values(list, contact_count_fields(rigid_bodies ? "bodies" : "grains"), a.counts);
  return list;
}

Items window_of(const analysis::Window& window, const analysis::InteriorMeasures& inside) {
  Items list{.title = "window, used for the closed forms; the network covers the whole packing, because the "
                      "stiffness of a part depends on the support of the grains at its faces"};
  for (int k = 0; k < 3; ++k)
    add_text(list, std::string(1, "xyz"[k]),
             pretty(window.low[k], Dimension::length) + " to " + pretty(window.high[k], Dimension::length));
  add_values(list, window_fields(), inside);
  return list;
}

void add_stress(Document& to, const FrameAnswer& frame) {
  const studies::PrintedStress stress = studies::printed(*frame.measured.packing.stress);
  const auto differences = studies::stress_differences(frame);
  const auto pressure = [](const char* heading) {
    return ShownColumn{.heading = heading, .width = 19, .digits = 10, .fixed = true, .unit = 1e3};
  };
  io::Columns<std::size_t> columns = {
      {"", "", [](std::size_t k) { return studies::stress_names[k]; },
       ShownColumn{.heading = "", .width = -5}},
      {"", "", [&](std::size_t k) { return stress[k]; }, pressure("by contacts")}};
  if (frame.code_stress) {
    columns.emplace_back(
        "", "", [&](std::size_t k) { return (*frame.code_stress)[k]; }, pressure("by code"));
    columns.emplace_back(
        "", "", [&](std::size_t k) { return differences[k]; },
        ShownColumn{.heading = "relative difference", .width = 21, .digits = 2, .absent = "-"});
  }
  const std::string against = frame.code_stress ? " against the code's own" : "";
  to.add(Seen::always, table_of("", "stress [kPa], from the contact forces" + against, columns,
                                std::vector<std::size_t>{0, 1, 2, 3, 4, 5}));
  add_part(to, "", stress_fields(), frame.measured.packing.stress);
}

void add_moduli(Document& to, const FrameAnswer& frame) {
  std::vector<RungResult> known;
  std::vector<std::pair<std::string, std::string>> refused; // titles and their reason
  for (const RungResult& rung : frame.rungs)
    if (rung.moduli)
      known.push_back(rung);
    else if (!refused.empty() && refused.back().second == rung.error)
      refused.back().first += ", " + rung.title;
    else
      refused.emplace_back(rung.title, rung.error);
  Table table = table_of("", "moduli", rung_fields(), known);
  table.remark =
      "K and G of the nearest isotropic stiffness, the others of the nearest stiffness that is symmetric "
      "about "
      "z: G_hh in the horizontal plane, G_vh in vertical planes; net/K and net/G: K and G of the network "
      "divided by those of the row; error: standard error of G_vh in the row. Rungs 0 to 2 and affine: every "
      "grain moves with the mean strain; rung 3: grains relax, by a calibrated formula; rung 4: the forces "
      "on "
      "every grain balance";
  if (frame.measured.triaxial)
    table.remark +=
        "; -: the stress is not symmetric about z, and moduli of one axis have no meaning: use the 6x6";
  to.add(Seen::always, std::move(table));
  Prose reasons;
  for (const auto& [titles, reason] : refused)
    reasons.lines.push_back(titles + "  " + reason);
  to.add(Seen::always, std::move(reasons));
}

Items probes_of(const FrameAnswer& frame) {
  Items list{.title = "probes by the code"};
  for (const studies::ProbedModulus& probe : frame.probes)
    add_text(list, probe.modulus + " by probe", pretty(probe.value, Dimension::pressure),
             probe.network_over_probe ? fmt::format("network over probe {:.4f}", *probe.network_over_probe)
                                      : "no network to compare with");
  return list;
}

/// A matrix; zeros within the error of the solver are shown as 0.
Table table_of_matrix(const NamedMatrix& named) {
  constexpr double nothing = 1e-7;
  const elastic::Matrix6& matrix = named.matrix->stiffness.matrix;
  const double least = nothing * matrix.cwiseAbs().maxCoeff();
  io::Columns<int> columns = {
      {"", "", [](int row) { return voigt_names[row]; }, ShownColumn{.heading = named.name, .width = -8}}};
  for (int k = 0; k < 6; ++k)
    columns.emplace_back(
        "", "",
        [&matrix, least, k](int row) { return std::abs(matrix(row, k)) < least ? 0 : matrix(row, k); },
        ShownColumn{.heading = voigt_names[k], .width = 11, .unit = 1e6});
  Table table = table_of("", "", columns, std::vector<int>{0, 1, 2, 3, 4, 5});
  const elastic::SymmetryDistances& distance = named.matrix->symmetry;
  table.remark =
      fmt::format("relative distance from the nearest stiffness that is symmetric about z: {}, from "
                  "the nearest isotropic one: {}",
                  short_text(distance.transversely_isotropic, 2), short_text(distance.isotropic, 2));
  return table;
}

void add_waves(Document& to, std::vector<NamedMatrix> matrices, const std::optional<double>& bulk_density) {
  Prose without;
  if (!bulk_density)
    without.lines = {"no wave speeds: the density of the grains is not known; state it with --grain-density"};
  else
    for (const NamedMatrix& m : matrices)
      if (!m.matrix->waves)
        without.lines.push_back(std::string(m.name) + ": no wave speeds: it is not positive semidefinite");
  std::erase_if(matrices, [&](const NamedMatrix& m) { return !bulk_density || !m.matrix->waves; });
  to.add(Seen::always,
         table_of("",
                  fmt::format("wave speeds [m/s] along 1, 2 and 3, fastest first; dry packing of {} kg/m3",
                              short_text(bulk_density.value_or(0), 5)),
                  wave_fields(), matrices));
  to.add(Seen::always, std::move(without));
}

void add_stiffness(Document& to, const FrameAnswer& frame) {
  const std::vector<NamedMatrix> matrices = network_matrices(frame);
  if (matrices.empty())
    return;
  std::string title = "stiffness of this network in the axes of the file [MPa], Voigt notation";
  for (const NamedMatrix& m : matrices)
    if (m.matrix != &frame.measured.packing.network->affine_all) { // its moduli below suffice
      Table table = table_of_matrix(m);
      table.title = std::exchange(title, "");
      to.add(Seen::always, std::move(table));
    }
  to.add(Seen::always, table_of("",
                                "along these axes; affine: uniform strain without the contacts of rattlers; "
                                "affine_all: with them; relaxed: rung 4",
                                matrix_fields(), matrices));
  add_waves(to, matrices, frame.measured.packing.bulk_density);
}

void add_frame(Document& to, const FrameAnswer& frame) {
  const Measurement& a = frame.measured.packing;
  to.add(Seen::always, heading_of(frame));
  if (a.counts.grains > 0)
    to.add(Seen::always, counts_of(frame.measured));
  if (frame.window && a.interior)
    to.add(Seen::always, window_of(*frame.window, *a.interior));
  add_part(to, "fabric", fabric_fields(), a.fabric);
  if (a.stress)
    add_stress(to, frame);
  add_part(to, "forces", force_fields(), a.forces);
  if (a.law_check && a.law_check->contacts > 0)
    add_part(to, "contact law, from forces against overlaps", law_fields(), a.law_check);
  if (!frame.rungs.empty()) {
    add_moduli(to, frame);
    to.add(Seen::always, probes_of(frame));
    add_stiffness(to, frame);
  }
  add_profile(to, frame);
  if (!frame.modes.empty()) {
    Table modes = table_of("", "lowest modes of the network", mode_fields(), frame.modes);
    modes.remark = "free oscillations without damping; participation: 1 if all grains that carry load have "
                   "the same kinetic energy, 1/N if one of N has all";
    to.add(Seen::always, std::move(modes));
  }
  Prose notes;
  for (const std::string& note : a.notes)
    notes.lines.push_back("- " + note);
  to.add(Seen::always, std::move(notes));
}

// ---- all frames

/// The files, one per line; of many files only the first and the last of each kind.
std::string files_text(const AnalyseAnswer& answer) {
  constexpr std::size_t many = 8;
  std::vector<std::string> lines;
  std::size_t alike = 0; // consecutive files of the same kind before this one
  for (std::size_t k = 0; k < answer.files.size(); ++k) {
    alike = k > 0 && answer.kinds[k] == answer.kinds[k - 1] ? alike + 1 : 0;
    const bool last = k + 1 == answer.files.size() || !(answer.kinds[k + 1] == answer.kinds[k]);
    if (answer.files.size() > many && alike > 0 && !last)
      continue;
    if (answer.files.size() > many && alike > 1)
      lines.push_back(fmt::format("  ... {} more", alike - 1));
    lines.push_back(answer.files[k] + ": " + std::string(io::description(answer.kinds[k])));
  }
  return fmt::format("{}", fmt::join(lines, "\n"));
}

/// Exponents of a series, or why there are none.
void add_series(Document& to, const StateSeries& series, const std::string& name) {
  std::vector<RungSeries> fitted, separate;
  Prose remarks;
  for (const RungSeries& rung : series.rungs) {
    if (rung.fit.sum)
      fitted.push_back(rung);
    else
      remarks.lines.push_back(rung.title + ": " + rung.fit.remark);
    if (rung.separate)
      separate.push_back(rung);
  }
  if (fitted.empty())
    remarks.lines = series.rungs.empty() ? std::vector<std::string>{}
                                         : std::vector{name + series.rungs.front().fit.remark};
  else if (separate.empty() && !series.rungs.front().separate_remark.empty())
    remarks.lines.push_back("m, n: " + series.rungs.front().separate_remark);
  to.add(Seen::always,
         table_of("", name.empty() ? "" : fmt::format("{}{} states", name, series.frames.size()),
                  sum_fields(), fitted));
  to.add(Seen::always, table_of("", "", separate_fields(), separate));
  to.add(Seen::always, std::move(remarks));
}

void add_all_frames(Document& to, const AnalyseAnswer& answer) {
  io::Columns<FrameAnswer> columns = frame_fields(answer.frames.front());
  std::erase_if(columns, [](const auto& column) { return !column.shown || column.shown->width == 0; });
  if (answer.frames.size() > 1)
    to.add(Seen::always, table_of("", "all frames; G in MPa, ratio: G of the network over G of rung 3",
                                  columns, answer.frames));
  for (const StateSeries& series : answer.series)
    add_series(to, series, answer.series.size() > 1 ? series.name + ": " : "");
  if (answer.skipped > 0)
    to.add(Seen::always,
           Prose{{fmt::format("{} frames are in one of the files only and were skipped", answer.skipped)}});
}

// ---- JSON

ordered_json frame_json(const FrameAnswer& frame, const io::Columns<FrameAnswer>& fields) {
  const Measurement& a = frame.measured.packing;
  ordered_json json = members(fields, frame);
  if (a.counts.grains == 0)
    return json;
  json["gradation"] = json_of(a.sizes.gradation);
  json["contact_means"] = frame.measured.contacts_known ? json_of(a.sizes.contacts) : ordered_json();
  if (!frame.profile.empty())
    json["profile"] = members_of_all(profile_fields(), frame.profile);
  if (!frame.modes.empty())
    json["modes"] = members_of_all(mode_fields(), frame.modes);
  for (const char* part : {"stress", "forces"})
    if (!a.forces && !json.contains(part))
      json[part] = nullptr;
  return json;
}

ordered_json series_json(const StateSeries& series, const AnalyseAnswer& answer) {
  ordered_json json = {{"name", series.name}, {"frames", ordered_json::array()}};
  for (const std::size_t k : series.frames)
    json["frames"].push_back(answer.frames[k].number);
  for (const RungSeries& rung : series.rungs)
    for (const auto* fields : {&sum_fields(), &separate_fields()})
      put_members(json["exponents"][rung.name], *fields, rung);
  return json;
}

void add_data(Document& to, const AnalyseAnswer& answer) {
  ordered_json files, frames = ordered_json::array(), series;
  for (std::size_t k = 0; k < answer.files.size(); ++k)
    files.push_back({{"path", answer.files[k]}, {"kind", io::description(answer.kinds[k])}});
  for (const FrameAnswer& frame : answer.frames)
    frames.push_back(frame_json(frame, frame_fields(frame)));
  for (const StateSeries& one : answer.series)
    series.push_back(series_json(one, answer));
  to.add(Seen::data, Data{"files", std::move(files)});
  to.add(Seen::data,
         Data{"conventions",
              {{"units", "SI"},
               {"signs", to.signs},
               {"stiffness",
                "C of the network in the axes of the file (or of --axis), Voigt order 11 22 33 23 13 12, "
                "engineering shear strains; moduli are projections: K and G isotropic, the others symmetric "
                "about z"}}});
  to.add(Seen::data, Data{"frames_skipped", answer.skipped});
  to.add(Seen::data, Data{"frames", std::move(frames)});
  if (!answer.series.empty())
    to.add(Seen::data, Data{"series", std::move(series)});
}

// ---- answer in words, and pictures

std::string stiffness_sentence(const FrameAnswer& frame) {
  const RungResult* network = find_rung(frame, network_name());
  return network == nullptr
             ? "The stiffness of the contact network does not follow from these files."
             : fmt::format("The network of contacts in this packing has a shear modulus G of {} and a bulk "
                           "modulus K of {}.",
                           megapascal(network->moduli->G), megapascal(network->moduli->K));
}

std::string contacts_sentence(const FrameAnswer& frame) {
  const analysis::Measurement& m = frame.measured.packing;
  if (!frame.measured.contacts_known)
    return fmt::format("Its contacts are unknown; the {} grains have a void ratio of {:.3f}.",
                       m.counts.grains, m.void_ratio);
  return fmt::format(
      "A grain has {:.2f} contacts on average (C_n), or {:.2f} without rattlers (z*): {} % of {} "
      "grains are rattlers, which carry no load. The void ratio is {:.3f}.",
      m.counts.coordination_number, m.counts.mechanical.coordination_number,
      short_text(100 * m.counts.mechanical.rattler_fraction, 2), m.counts.grains, m.void_ratio);
}

std::string rungs_sentence(const FrameAnswer& frame) {
  const RungResult *relaxed = find_rung(frame, studies::relaxed_name()),
                   *network = find_rung(frame, network_name());
  if (relaxed == nullptr)
    return "Rung 3, the relaxed closed form, was not evaluated; the table below states why.";
  const std::string text = "The relaxed closed form (rung 3) gives G = " + megapascal(relaxed->moduli->G);
  return network == nullptr ? text + "."
                            : fmt::format("{}, {:+.1f} % from the network.", text,
                                          100 * (relaxed->moduli->G / network->moduli->G - 1));
}

/// "G grows as p^0.36 +- 0.01 (dense), ..."; empty if no exponent was found.
std::string series_sentence(const AnalyseAnswer& answer) {
  std::string text;
  for (const StateSeries& series : answer.series)
    if (const RungSeries* rung = shown_rung(series); rung != nullptr && rung->fit.sum) {
      const Measured& s = rung->fit.sum->exponent_sum;
      text += fmt::format("{} s = {:.3f} \u00b1 {:.3f}{}", text.empty() ? "" : ",", s.value, s.standard_error,
                          answer.series.size() > 1 ? " (" + series.name + ")" : "");
    }
  return text.empty() ? "" : "Over the given states, G grows with the mean stress as p^s:" + text + ".";
}

std::vector<std::string> first_sentences(const AnalyseAnswer& answer) {
  const FrameAnswer& last = answer.frames.back();
  std::vector<std::string> out{stiffness_sentence(last), contacts_sentence(last), rungs_sentence(last)};
  if (answer.frames.size() > 1)
    out.back() += fmt::format(" Shown is the last of {} frames.", answer.frames.size());
  if (std::string growth = series_sentence(answer); !growth.empty())
    out.push_back(std::move(growth));
  return out;
}

void add_pictures(Document& to, const AnalyseAnswer& answer) {
  const FrameAnswer& last = answer.frames.back();
  const plot::Chart rungs = rung_chart(last);
  to.add(Seen::data, rungs.series.empty()
                         ? Picture{{}, "No stiffness could be computed; the numbers below give the reasons."}
                         : Picture{{rungs},
                                   "The shear modulus of this packing by each closed form (rungs 0 to "
                                   "3) and of its contact network (rung 4)."});
  for (Picture& picture : state_pictures(answer))
    to.add(Seen::data, std::move(picture));
  if (last.measured.packing.fabric)
    to.add(Seen::data,
           Picture{
               {rose_chart(last)},
               "Directions of the contacts. The length of a bar is the number of contacts per solid angle at "
               "that angle from the vertical, with its counting error. The number of bars, 3 to 18, leaves "
               "at least 25 contacts in the bar at the vertical; rose.csv has all 18.",
               "",
               {"rose.csv"}});
  add_profile_charts(to, last);
  if (answer.chains)
    to.add(Seen::data,
           Picture{{},
                   answer.chains->finding + " The width of a line shows the force; forces above the mean are "
                                            "coloured. Seen along y, z upwards.",
                   answer.chains->in_page});
  if (last.measured.packing.forces)
    to.add(
        Seen::data,
        Picture{
            {force_chart(last)},
            "Distribution of the contact forces: share of contacts by force over mean force, with counting "
            "errors.",
            "",
            {"forces.csv"}});
}

} // namespace

Document analysed(const AnalyseAnswer& answer) {
  constexpr std::size_t whole = 2; // frames that are shown with all results
  Document document{.command = "analyse",
                    .title = files_text(answer),
                    .question = "How stiff is this packing, and how accurate are the closed forms?",
                    .sentences = first_sentences(answer)};
  const std::size_t count = answer.frames.size();
  if (count > whole)
    document.add(Seen::always, Prose{{fmt::format("the last of {} frames:", count)}});
  for (std::size_t k = count > whole ? count - 1 : 0; k < count; ++k)
    add_frame(document, answer.frames[k]);
  add_all_frames(document, answer);
  add_data(document, answer);
  add_pictures(document, answer);
  return document;
}

} // namespace granum::cli

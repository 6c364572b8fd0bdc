// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <numbers>
#include <utility>

#include <granum/core/number.hpp>
#include <granum/core/version.hpp>
#include <granum/fabric/orientation.hpp>
#include <granum/io/csv/table.hpp>
#include <granum/plot/chart.hpp>

#include "analyse_stiffness.hpp"
#include "cli/frame/frame.hpp"

namespace granum::cli {

namespace {

constexpr double degrees = 180 / std::numbers::pi;

std::vector<std::pair<std::string, std::string>> notes(const AnalyseAnswer& answer) {
  std::vector<std::pair<std::string, std::string>> out{
      {"program", "granum " + std::string(version()) + " analyse"},
      {"signs", "compression positive; z is the vertical axis v"}};
  for (const std::string& file : answer.files)
    out.emplace_back("file", file);
  return out;
}

std::string frames_csv(const AnalyseAnswer& answer) {
  io::CsvContent csv{.notes = notes(answer), .headings = {}, .rows = {}};
  const io::Columns<FrameAnswer> columns = frame_columns(answer);
  io::add_headings(csv, columns);
  for (const FrameAnswer& frame : answer.frames) {
    std::vector<io::CsvCell> row;
    io::add_cells(row, columns, frame);
    csv.rows.push_back(std::move(row));
  }
  return io::csv_text(csv);
}

std::string rose_csv(const AnalyseAnswer& answer) {
  io::CsvContent csv{.notes = notes(answer),
                     .headings = {"frame", "gamma_low_deg", "gamma_high_deg", "count", "count_error",
                                  "expected_count", "density", "density_error", "expected_density"},
                     .rows = {}};
  for (const FrameAnswer& frame : answer.frames)
    if (frame.measured.packing.fabric)
      for (const fabric::RoseBin& bin : frame.measured.packing.fabric->rose)
        csv.rows.push_back({number(frame.number), bin.low * degrees, bin.high * degrees, number(bin.count),
                            bin.count_error, bin.expected_count, bin.density, bin.density_error,
                            bin.expected_density});
  return io::csv_text(csv);
}

std::string forces_csv(const AnalyseAnswer& answer) {
  io::CsvContent csv{
      .notes = notes(answer),
      .headings = {"frame", "f_over_mean_low", "f_over_mean_high", "count", "density", "density_error"},
      .rows = {}};
  for (const FrameAnswer& frame : answer.frames)
    if (frame.measured.packing.forces)
      for (const packing::ForceBin& bin : frame.measured.packing.forces->distribution.bins)
        csv.rows.push_back(
            {number(frame.number), bin.low, bin.high, number(bin.count), bin.density, bin.density_error});
  return io::csv_text(csv);
}

/// E(gamma; a), smooth.
plot::Series density_curve(double anisotropy) {
  constexpr int points = 90;
  plot::Series curve{
      .name = "E(\u03b3; a = " + short_text(anisotropy, 3) + ")", .mark = plot::Mark::line, .x = {}, .y = {}};
  for (int k = 0; k <= points; ++k) {
    const double gamma = std::numbers::pi / 2 * k / points;
    curve.x.push_back(gamma * degrees);
    curve.y.push_back(fabric::density(gamma, anisotropy));
  }
  return curve;
}

std::string rose_picture(const FrameAnswer& frame) {
  const analysis::Fabric& f = *frame.measured.packing.fabric;
  plot::Series bins{.name = "contacts, \u221an bars", .mark = plot::Mark::marker, .x = {}, .y = {}};
  for (const fabric::RoseBin& bin : f.rose) {
    bins.x.push_back((bin.low + bin.high) / 2 * degrees);
    bins.y.push_back(bin.density);
    bins.y_error.push_back(bin.density_error);
  }
  return plot::svg({.title = "Contact directions of " + std::to_string(f.contacts) + " contacts, step " +
                             std::to_string(frame.measured.step),
                    .x = {.title = "\u03b3 from the vertical [deg]"},
                    .y = {.title = "E [1/sr]"},
                    .series = {bins, density_curve(f.by_likelihood.value().anisotropy)}});
}

std::string force_picture(const FrameAnswer& frame) {
  const packing::ForceDistribution& d = frame.measured.packing.forces->distribution;
  plot::Series bins{.name = "contacts, \u221an bars", .mark = plot::Mark::marker, .x = {}, .y = {}};
  for (const packing::ForceBin& bin : d.bins) {
    if (bin.count == 0)
      continue; // the axis is logarithmic
    bins.x.push_back((bin.low + bin.high) / 2);
    bins.y.push_back(bin.density);
    bins.y_error.push_back(bin.count > 1 ? bin.density_error : 0);
  }
  return plot::svg({.title = "Normal forces of " + std::to_string(d.pressing) + " contacts, step " +
                             std::to_string(frame.measured.step),
                    .x = {.title = "f_n/\u27e8f_n\u27e9"},
                    .y = {.title = "probability density", .scale = plot::Scale::logarithmic},
                    .series = {bins}});
}

} // namespace

void write_analysis(const std::filesystem::path& folder, const AnalyseAnswer& answer, io::Existing existing) {
  std::vector<std::pair<const char*, std::string>> files; // all made before the first is written
  const auto add = [&](const char* name, std::string text) { files.emplace_back(name, std::move(text)); };
  const FrameAnswer& last = answer.frames.back();
  add("frames.csv", frames_csv(answer));
  if (std::any_of(answer.frames.begin(), answer.frames.end(),
                  [](const FrameAnswer& frame) { return !network_matrices(frame).empty(); })) {
    io::CsvContent stiffness = stiffness_csv(answer);
    stiffness.notes = notes(answer);
    add("stiffness.csv", io::csv_text(stiffness));
  }
  if (last.measured.packing.fabric) {
    add("rose.csv", rose_csv(answer));
    add("rose.svg", rose_picture(last));
  }
  if (last.measured.packing.forces) {
    add("forces.csv", forces_csv(answer));
    add("forces.svg", force_picture(last));
  }
  add("analysis.json", json_text(analyse_json(answer)));
  for (const auto& [name, text] : files)
    io::write_file(folder / name, text, existing);
}

} // namespace granum::cli

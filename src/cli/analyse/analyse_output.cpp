// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <numbers>
#include <utility>

#include <granum/core/number.hpp>
#include <granum/core/version.hpp>
#include <granum/fabric/orientation.hpp>
#include <granum/io/csv/table.hpp>
#include <granum/plot/chart.hpp>

#include "analyse_page.hpp"
#include "analyse_series.hpp"
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

} // namespace

void write_analysis(const std::filesystem::path& folder, const AnalyseAnswer& answer,
                    const std::string& table, io::Existing existing) {
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
    add("rose.svg", plot::svg(rose_chart(last)));
  }
  if (last.measured.packing.forces) {
    add("forces.csv", forces_csv(answer));
    add("forces.svg", plot::svg(force_chart(last)));
  }
  if (answer.chains)
    add("chains.svg", answer.chains->svg);
  std::vector<plot::Chart> states;
  for (SeriesPicture& picture : series_pictures(answer))
    states.push_back(std::move(picture.chart));
  if (!states.empty())
    add("states.svg", plot::svg(states, 3));
  add("report.html", analyse_page(answer, table));
  add("analysis.json", json_text(analyse_json(answer)));
  for (const auto& [name, text] : files)
    io::write_file(folder / name, text, existing);
}

} // namespace granum::cli

// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <map>
#include <numbers>
#include <utility>

#include <fmt/core.h>
#include <granum/core/version.hpp>
#include <granum/io/csv/table.hpp>
#include <granum/io/matrix_market.hpp>
#include <granum/network/stiffness_matrix.hpp>
#include <granum/plot/chart.hpp>

#include "analyse_fields.hpp"
#include "cli/frame/frame.hpp"

namespace granum::cli {

namespace {

std::vector<std::pair<std::string, std::string>> notes(const AnalyseAnswer& answer) {
  std::vector<std::pair<std::string, std::string>> out{
      {"program", "granum " + std::string(version()) + " analyse"},
      {"signs", "compression positive; z is the vertical axis v"}};
  for (const std::string& file : answer.files)
    out.emplace_back("file", file);
  return out;
}

std::string frames_csv(const AnalyseAnswer& answer) {
  io::Columns<FrameAnswer> columns = frame_fields(answer.frames.front());
  std::map<std::size_t, std::string> names; // of the series of each frame, by its number
  for (const StateSeries& series : answer.series)
    for (const std::size_t k : series.frames)
      names[answer.frames[k].number] = series.name;
  if (answer.series.size() > 1)
    columns.insert(columns.begin() + 1,
                   {"series", "", [names](const FrameAnswer& f) { return names.at(f.number); }});
  return io::csv_text(columns, answer.frames, notes(answer));
}

/// A table with a row for each item of a list in the frames, beginning with the number of the frame.
template <class Row, class RowsOf>
std::string csv_of_frames(const AnalyseAnswer& answer, const io::Columns<Row>& columns,
                          const RowsOf& rows_of) {
  io::CsvContent csv{.notes = notes(answer), .headings = {"frame"}, .rows = {}};
  io::add_headings(csv, columns);
  for (const FrameAnswer& frame : answer.frames)
    for (const Row& row : rows_of(frame)) {
      csv.rows.push_back({static_cast<double>(frame.number)});
      io::add_cells(csv.rows.back(), columns, row);
    }
  return io::csv_text(csv);
}

std::string rose_csv(const AnalyseAnswer& answer) {
  using Bin = fabric::RoseBin;
  const auto in_degrees = [](double Bin::*angle) {
    return [=](const Bin& bin) { return bin.*angle * (180 / std::numbers::pi); };
  };
  return csv_of_frames<Bin>(answer,
                            {{"gamma_low_deg", "", in_degrees(&Bin::low)},
                             {"gamma_high_deg", "", in_degrees(&Bin::high)},
                             {"count", "", &Bin::count},
                             {"count_error", "", &Bin::count_error},
                             {"expected_count", "", &Bin::expected_count},
                             {"density", "", &Bin::density},
                             {"density_error", "", &Bin::density_error},
                             {"expected_density", "", &Bin::expected_density}},
                            [](const FrameAnswer& frame) {
                              const auto& fabric = frame.measured.packing.fabric;
                              return fabric ? fabric->rose : std::vector<Bin>{};
                            });
}

std::string forces_csv(const AnalyseAnswer& answer) {
  using Bin = packing::ForceBin;
  return csv_of_frames<Bin>(answer,
                            {{"f_over_mean_low", "", &Bin::low},
                             {"f_over_mean_high", "", &Bin::high},
                             {"count", "", &Bin::count},
                             {"density", "", &Bin::density},
                             {"density_error", "", &Bin::density_error}},
                            [](const FrameAnswer& frame) {
                              const auto& forces = frame.measured.packing.forces;
                              return forces ? forces->distribution.bins : std::vector<Bin>{};
                            });
}

/// A row of a matrix of the network.
struct MatrixRow {
  NamedMatrix matrix;
  int row = 0;
};

std::vector<MatrixRow> matrix_rows(const FrameAnswer& frame) {
  std::vector<MatrixRow> rows;
  for (const NamedMatrix& matrix : network_matrices(frame))
    for (int row = 0; row < 6; ++row)
      rows.push_back({matrix, row});
  return rows;
}

std::string stiffness_csv(const AnalyseAnswer& answer) {
  io::Columns<MatrixRow> columns = {{"matrix", "", [](const MatrixRow& row) { return row.matrix.name; }},
                                    {"row", "", [](const MatrixRow& row) { return voigt_names[row.row]; }}};
  for (int k = 0; k < 6; ++k)
    columns.emplace_back(std::string(voigt_names[k]) + "_Pa", "", [k](const MatrixRow& row) {
      return row.matrix.matrix->stiffness.matrix(row.row, k);
    });
  return csv_of_frames(answer, columns, matrix_rows);
}

} // namespace

std::string stiffness_file(const io::ImportedPacking& packing, const studies::MeasureOptions& options) {
  constexpr std::size_t in_a_line = 20;
  analysis::Given given = options.given;
  given.materials = studies::materials_of(packing, options.materials);
  const network::StiffnessMatrix h = network::stiffness_matrix(studies::stiffened(packing, given));
  const bool bodies = !packing.assembly.body.empty();
  std::vector<std::string> comments{
      "granum " + std::string(version()) + ": stiffness matrix of a contact network [N/m]",
      fmt::format("rows of a {}: displacement u [m]{}; {}, in this order:", bodies ? "body" : "grain",
                  h.unknowns_per_grain == 6 ? ", then radius times rotation, R w [m]" : "",
                  bodies ? "numbers of bodies, from 0" : "ids of grains")};
  for (std::size_t k = 0; k < h.grain.size(); ++k) {
    if (k % in_a_line == 0)
      comments.emplace_back();
    comments.back() += fmt::format(" {}", bodies || packing.id.empty() ? static_cast<long>(h.grain[k])
                                                                       : packing.id[h.grain[k]]);
  }
  return io::matrix_market(h.matrix, comments);
}

void write_analysis(const std::filesystem::path& folder, const AnalyseAnswer& answer,
                    const Document& document, io::Existing existing) {
  std::vector<std::pair<const char*, std::string>> files; // all composed before the first is written
  const auto add = [&](const char* name, std::string text) { files.emplace_back(name, std::move(text)); };
  const FrameAnswer& last = answer.frames.back();
  add("frames.csv", frames_csv(answer));
  if (std::any_of(answer.frames.begin(), answer.frames.end(),
                  [](const FrameAnswer& frame) { return !network_matrices(frame).empty(); }))
    add("stiffness.csv", stiffness_csv(answer));
  if (last.measured.packing.fabric) {
    add("rose.csv", rose_csv(answer));
    add("rose.svg", plot::svg(rose_chart(last)));
  }
  if (last.measured.packing.forces) {
    add("forces.csv", forces_csv(answer));
    add("forces.svg", plot::svg(force_chart(last)));
  }
  if (!last.profile.empty())
    add("profile.csv",
        csv_of_frames(answer, profile_fields(), [](const FrameAnswer& frame) { return frame.profile; }));
  if (!last.modes.empty())
    add("modes.csv",
        csv_of_frames(answer, mode_fields(), [](const FrameAnswer& frame) { return frame.modes; }));
  if (answer.chains)
    add("chains.svg", answer.chains->svg);
  std::vector<plot::Chart> states;
  for (Picture& picture : state_pictures(answer))
    states.push_back(std::move(picture.charts.front()));
  if (!states.empty())
    add("states.svg", plot::svg(states, 3));
  add("report.html", page(document));
  add("analysis.json", json_text(json(document)));
  for (const auto& [name, text] : files)
    io::write_file(folder / name, text, existing);
}

} // namespace granum::cli

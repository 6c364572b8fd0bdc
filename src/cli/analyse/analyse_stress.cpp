// SPDX-License-Identifier: GPL-3.0-or-later
#include "analyse_stress.hpp"

#include <algorithm>
#include <string>

#include <fmt/core.h>
#include <granum/core/error.hpp>
#include <granum/core/number.hpp>
#include <granum/io/csv/table.hpp>

#include "analyse_options.hpp"

namespace granum::cli {

namespace {

/// Which row of a table belongs to each frame.
std::vector<std::size_t> rows_of(const io::CsvTable& table, const std::string& path,
                                 const std::vector<FrameAnswer>& frames) {
  std::vector<std::size_t> rows;
  if (!table.has("step")) {
    if (table.row_count() != frames.size())
      throw FileError(path, 0,
                      fmt::format("expected one row of stresses for each of {} frames, found {}; a column "
                                  "step would match them",
                                  frames.size(), table.row_count()));
    for (std::size_t k = 0; k < frames.size(); ++k)
      rows.push_back(k);
    return rows;
  }
  const std::vector<double> steps = table.numbers("step", Dimension::dimensionless);
  for (const FrameAnswer& frame : frames) {
    const auto step = static_cast<double>(frame.measured.step);
    const auto count = std::count(steps.begin(), steps.end(), step);
    if (count != 1)
      throw FileError(path, 0,
                      fmt::format("expected one row of step {}, found {}", frame.measured.step, count));
    rows.push_back(static_cast<std::size_t>(std::find(steps.begin(), steps.end(), step) - steps.begin()));
  }
  return rows;
}

void take_from_file(const std::string& path, std::vector<FrameAnswer>& frames) {
  const io::CsvTable table = io::read_csv(path);
  const std::vector<std::size_t> rows = rows_of(table, path, frames);
  for (FrameAnswer& frame : frames)
    frame.code_stress.emplace();
  for (std::size_t k = 0; k < std::size(studies::stress_names); ++k) {
    const std::string sigma =
        std::string("sigma_") + studies::stress_names[k]; // as the decks of granum export have it
    const std::vector<double> column =
        table.numbers(table.has(sigma) ? sigma : studies::stress_names[k], Dimension::pressure);
    for (std::size_t f = 0; f < frames.size(); ++f)
      (*frames[f].code_stress)[k] = column[rows[f]];
  }
}

} // namespace

void take_code_stress(const std::vector<std::string>& given, std::vector<FrameAnswer>& frames) {
  if (given.empty())
    return;
  if (given.size() == 1 && given.front().find(',') == std::string::npos)
    return take_from_file(given.front(), frames);
  if (given.size() != frames.size())
    throw InvalidArgument(fmt::format(
        "--stress is given {} times for {} frames: give it once a frame, choose frames with --frames, or "
        "name a CSV file",
        given.size(), frames.size()));
  for (std::size_t k = 0; k < frames.size(); ++k)
    frames[k].code_stress = parse_stress(given[k]);
}

void judge_code_stress(const FrameAnswer& frame, Validity& out) {
  constexpr double agrees = 1e-6;
  if (const auto apart = studies::largest_stress_difference(frame); apart && *apart > agrees)
    out.add(fmt::format("the stress by contacts differs from the code's own by {} of its largest component",
                        short_text(*apart, 2)));
}

} // namespace granum::cli

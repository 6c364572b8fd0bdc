// SPDX-License-Identifier: GPL-3.0-or-later
#include "analyse_stress.hpp"

#include <algorithm>
#include <functional>
#include <iterator>
#include <optional>
#include <span>
#include <string>

#include <fmt/core.h>
#include <granum/core/error.hpp>
#include <granum/core/text.hpp>
#include <granum/elastic/isotropic.hpp>
#include <granum/io/csv/table.hpp>

#include "analyse_options.hpp"

namespace granum::cli {

namespace {

/// The row of a table for each frame.
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
        std::string("sigma_") + studies::stress_names[k]; // as in the decks of granum export
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
  const auto is_file = [](const std::string& text) { // whose name may hold commas, and begins with no number
    return text.find(',') == std::string::npos || !leading_number(trimmed(text));
  };
  if (given.size() == 1 && is_file(given.front()))
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
    out.add(fmt::format("the stress computed from contacts differs from that reported by the code by {} of "
                        "its largest component",
                        short_text(*apart, 2)));
}

namespace {

/// Whether `part` is a part of a file's name between points, or at an end.
bool names_state(const std::string& file, const std::string& state) {
  const std::string name = "." + file.substr(file.find_last_of('/') + 1) + ".";
  return name.find("." + state + ".") != std::string::npos;
}

/// The text columns of a table of probes.
std::size_t place_of(const io::CsvTable& table, std::string_view heading) {
  const auto& headings = table.headings();
  return static_cast<std::size_t>(std::find(headings.begin(), headings.end(), heading) - headings.begin());
}

template <int row, int column>
double component(const elastic::VoigtStiffness& c) {
  return c.matrix(row, column);
}

/// A probe shears one plane. A projection about axis 3 averages over planes: of 500 grains it was off by up
/// to 6 %.
constexpr Probing probing_table[] = {
    {"K", [](const elastic::VoigtStiffness& c) { return elastic::isotropic_projection(c).bulk_modulus(); }},
    {"G", [](const elastic::VoigtStiffness& c) { return elastic::isotropic_projection(c).shear_modulus(); }},
    {"G_vh", component<4, 4>},
    {"G_hh", component<5, 5>},
    {"C11", component<0, 0>},
    {"C22", component<1, 1>},
    {"C33", component<2, 2>},
    {"C12", component<0, 1>},
    {"C13", component<0, 2>},
    {"C23", component<1, 2>},
    {"C44", component<3, 3>},
    {"C55", component<4, 4>},
    {"C66", component<5, 5>},
};

const Probing& probing_of(const io::CsvTable& table, std::size_t row, const std::string& name) {
  const auto found = std::find_if(std::begin(probing_table), std::end(probing_table),
                                  [&](const Probing& of) { return of.name == name; });
  if (found != std::end(probing_table))
    return *found;
  std::string names;
  for (const Probing& of : probing_table)
    names += std::string(names.empty() ? "" : ", ") + of.name;
  throw FileError(table.name(), table.line(row), "modulus '" + name + "' is not one of " + names);
}

/// The stiffness of the network; null if it was not solved, or there is none.
const elastic::VoigtStiffness* network_stiffness(const FrameAnswer& frame) {
  const auto& network = frame.measured.packing.network;
  return network && network->response.converged() ? &network->relaxed.stiffness : nullptr;
}

/// The frame of a row, in words for an error, and whether a given frame is that one.
struct ProbedState {
  std::string words;
  std::function<bool(const FrameAnswer&)> is;
};

ProbedState state_of(const io::CsvTable& table, std::size_t row, std::span<const double> steps) {
  const std::size_t place = place_of(table, "state");
  const std::optional<double> step = steps.empty() ? std::nullopt : std::optional(steps[row]);
  const std::optional<std::string> state =
      place < table.headings().size() ? std::optional(table.fields(row)[place]) : std::nullopt;
  if (!step && !state)
    return {"a single frame, because there is no column step or state",
            [](const FrameAnswer&) { return true; }};
  return {(step ? fmt::format("step {}", *step) : "") + (step && state ? " of " : "") +
              (state ? "state " + *state : ""),
          [step, state](const FrameAnswer& frame) {
            return (!step || static_cast<double>(frame.measured.step) == *step) &&
                   (!state || (step && state->empty()) || names_state(frame.file, *state));
          }};
}

} // namespace

std::span<const Probing> probings() { return probing_table; }

void take_probes(const std::string& path, std::vector<FrameAnswer>& frames) {
  if (path.empty())
    return;
  const io::CsvTable table = io::read_csv(path);
  const std::size_t name = place_of(table, "modulus");
  if (name == table.headings().size())
    throw FileError(path, table.heading_line(), "expected a column modulus, of K, G, G_vh and so on");
  const std::vector<double> values = table.numbers("value", Dimension::pressure);
  const std::vector<double> steps =
      table.has("step") ? table.numbers("step", Dimension::dimensionless) : std::vector<double>{};
  for (std::size_t row = 0; row < values.size(); ++row) {
    const Probing& modulus = probing_of(table, row, table.fields(row)[name]);
    const ProbedState state = state_of(table, row, steps);
    const auto frame = std::find_if(frames.begin(), frames.end(), state.is);
    if (frame == frames.end() || std::count_if(frames.begin(), frames.end(), state.is) > 1)
      throw FileError(path, table.line(row),
                      fmt::format("{}: no frame matches, or more than one", state.words));
    const auto known = [&](const studies::ProbedModulus& probe) { return probe.modulus == modulus.name; };
    if (std::any_of(frame->probes.begin(), frame->probes.end(), known))
      throw FileError(path, table.line(row), fmt::format("a second {} of {}", modulus.name, state.words));
    if (!(values[row] > 0))
      throw FileError(path, table.line(row), "the value of a modulus must be more than 0 Pa");
    studies::ProbedModulus probe{.modulus = modulus.name, .value = values[row]};
    if (const elastic::VoigtStiffness* const network = network_stiffness(*frame))
      probe.network_over_probe = modulus.of(*network) / probe.value;
    frame->probes.push_back(std::move(probe));
  }
}

} // namespace granum::cli

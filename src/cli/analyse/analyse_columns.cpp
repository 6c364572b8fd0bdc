// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <map>
#include <string>

#include "analyse_parts.hpp"
#include "analyse_stiffness.hpp"

namespace granum::cli {

namespace {

using FrameColumns = io::Columns<FrameAnswer>;

/// Rung 3 in the list of a frame's rungs.
std::string relaxed_column() { return effective::rung(effective::RungName::relaxed).column; }

/// Adds the columns of a part of the measurement. `part_of` finds it in a frame; null where there is none.
template <class Part, class PartOf>
void add_part(FrameColumns& to, const io::Columns<Part>& columns, PartOf part_of) {
  for (const io::Column<Part>& column : columns) {
    to.emplace_back(column.heading, "",
                    [part_of, of = column.of](const FrameAnswer& frame) -> std::optional<double> {
                      const Part* part = part_of(frame);
                      return part == nullptr ? std::nullopt : of(*part);
                    });
    to.back().shown = column.shown;
  }
}

/// Where a frame has a part that not every measurement has.
template <class Part>
auto optional_part(std::optional<Part> analysis::Measurement::*member) {
  return [member](const FrameAnswer& frame) -> const Part* {
    const std::optional<Part>& part = frame.measured.packing.*member;
    return part ? &*part : nullptr;
  };
}

const analysis::Counts* counts(const FrameAnswer& frame) { return &frame.measured.packing.counts; }
const analysis::Counts* counts_of_contacts(const FrameAnswer& frame) {
  return frame.measured.contacts_known ? counts(frame) : nullptr;
}

std::optional<double> pressure_by_code(const FrameAnswer& frame) {
  if (!frame.code_stress)
    return std::nullopt;
  const PrintedStress& s = *frame.code_stress;
  return (s[0] + s[1] + s[2]) / 3;
}

FrameColumns state_columns() {
  using analysis::Measurement;
  using io::ShownColumn;
  FrameColumns columns = {
      {"file", [](const FrameAnswer& f) { return f.file; }},
      {"frame", "", [](const FrameAnswer& f) { return number(f.number); },
       ShownColumn{.heading = "frame", .width = 6, .digits = 10, .ahead = true}},
      {"step", "", [](const FrameAnswer& f) { return static_cast<double>(f.measured.step); },
       ShownColumn{.heading = "step", .width = 11, .digits = 10, .ahead = true}},
      {"time_s", "", [](const FrameAnswer& f) { return f.measured.time; }},
      {"e", "", [](const FrameAnswer& f) { return f.measured.packing.void_ratio; },
       ShownColumn{"e", 9, 4, true}},
  };
  add_part(columns, contact_count_columns(), counts_of_contacts);
  add_part(columns, grain_count_columns(), counts);
  add_part(columns, fabric_columns(), optional_part(&Measurement::fabric));
  add_part(columns, stress_columns(), optional_part(&Measurement::stress));
  columns.emplace_back("p_by_code_Pa", "", pressure_by_code);
  add_part(columns, force_columns(), optional_part(&Measurement::forces));
  return columns;
}

/// A number of the k-th rung of a frame.
auto moduli_of_rung(std::size_t k) {
  return [k](const FrameAnswer& f) -> const Moduli* {
    return k < f.rungs.size() && f.rungs[k].moduli ? &*f.rungs[k].moduli : nullptr;
  };
}

void add_rung_columns(FrameColumns& to, const std::vector<RungResult>& rungs) {
  constexpr double MPa = 1e6;
  for (std::size_t k = 0; k < rungs.size(); ++k) {
    io::Columns<Moduli> columns = modulus_columns();
    for (io::Column<Moduli>& column : columns) {
      if (column.heading == "G" && rungs[k].name == relaxed_column())
        column.shown = io::ShownColumn{"G rung 3 [MPa]", 15, 4, false, MPa, "-"};
      if (column.heading == "G" && rungs[k].name == network_name)
        column.shown = io::ShownColumn{"G network", 15, 4, false, MPa, "-"};
      if (!column.heading.empty())
        column.heading += "_" + rungs[k].name + "_Pa";
    }
    add_part(to, columns, moduli_of_rung(k));
  }
}

/// What is read off both matrices of the network, "relaxed_E_1_Pa" and so on.
void add_matrix_columns(FrameColumns& to, const FrameAnswer& first) {
  const std::vector<NamedMatrix> matrices = network_matrices(first);
  for (std::size_t k = 0; k < matrices.size(); ++k) {
    io::Columns<analysis::NetworkMatrix> columns = matrix_columns();
    for (io::Column<analysis::NetworkMatrix>& column : columns) {
      column.heading = std::string(matrices[k].name) + "_" + column.heading;
      column.shown.reset();
    }
    add_part(to, columns, [k](const FrameAnswer& frame) -> const analysis::NetworkMatrix* {
      const std::vector<NamedMatrix> its = network_matrices(frame);
      return k < its.size() ? its[k].matrix : nullptr;
    });
  }
}

/// G of the network over that of rung 3.
std::optional<double> network_over_relaxed(const FrameAnswer& frame) {
  const Moduli* network = network_moduli(frame);
  const RungResult* relaxed = find_rung(frame, relaxed_column());
  if (network == nullptr || relaxed == nullptr || !(relaxed->moduli->G > 0))
    return std::nullopt;
  return network->G / relaxed->moduli->G;
}

/// The name of the series that a frame is of.
FrameColumns::value_type::Text series_names(const AnalyseAnswer& answer) {
  std::map<std::size_t, std::string> names; // by the number of the frame
  for (const StateSeries& series : answer.series)
    for (const std::size_t k : series.frames)
      names[answer.frames[k].number] = series.name;
  return [names](const FrameAnswer& frame) { return names.at(frame.number); };
}

} // namespace

io::Columns<FrameAnswer> frame_columns(const AnalyseAnswer& answer) {
  FrameColumns columns = state_columns();
  if (answer.series.size() > 1)
    columns.emplace(columns.begin() + 1, "series", series_names(answer));
  add_rung_columns(columns, answer.frames.front().rungs);
  add_matrix_columns(columns, answer.frames.front());
  columns.emplace_back("", "", network_over_relaxed, io::ShownColumn{"ratio", 9, 3, true, 1, "-"});
  return columns;
}

} // namespace granum::cli

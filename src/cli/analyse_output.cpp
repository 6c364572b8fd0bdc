// SPDX-License-Identifier: GPL-3.0-or-later
#include <functional>
#include <numbers>

#include <granum/core/number.hpp>
#include <granum/fabric/orientation.hpp>
#include <granum/io/chart.hpp>
#include <granum/io/csv.hpp>
#include <granum/verify/version.hpp>

#include "analyse.hpp"
#include "frame.hpp"

namespace granum::cli {

namespace {

constexpr double degrees = 180 / std::numbers::pi;

std::vector<std::pair<std::string, std::string>> notes(const AnalyseAnswer& answer) {
  std::vector<std::pair<std::string, std::string>> out{
      {"program", "granum " + std::string(verify::version()) + " analyse"},
      {"signs", "compression positive; z is the vertical axis v"}};
  for (const std::string& file : answer.files)
    out.emplace_back("file", file);
  return out;
}

double number(std::size_t count) { return static_cast<double>(count); }

/// A column of frames.csv: a number of each frame, nothing where it has none.
struct Column {
  std::string heading;
  std::function<double(const FrameAnswer&)> of;
};

/// A column that is empty for frames without the part that it is of.
template <class Part, class Of>
Column part(std::string heading, std::optional<Part> analysis::Measurement::*member, Of of) {
  return {std::move(heading), [member, of](const FrameAnswer& f) {
            const std::optional<Part>& value = f.measured.packing.*member;
            return value ? double{of(*value)} : nothing;
          }};
}

std::vector<Column> state_columns() {
  using analysis::Fabric;
  using analysis::Forces;
  using analysis::Measurement;
  return {
      {"frame", [](const FrameAnswer& f) { return number(f.number); }},
      {"step", [](const FrameAnswer& f) { return static_cast<double>(f.measured.step); }},
      {"time_s", [](const FrameAnswer& f) { return f.measured.time.value_or(nothing); }},
      {"e", [](const FrameAnswer& f) { return f.measured.packing.void_ratio; }},
      {"C_n", [](const FrameAnswer& f) { return f.measured.packing.counts.coordination_number; }},
      {"z_star",
       [](const FrameAnswer& f) { return f.measured.packing.counts.mechanical.coordination_number; }},
      {"rattler_fraction",
       [](const FrameAnswer& f) { return f.measured.packing.counts.mechanical.rattler_fraction; }},
      {"grains_without_contact",
       [](const FrameAnswer& f) { return number(f.measured.packing.counts.without_contact); }},
      {"wall_contacts", [](const FrameAnswer& f) { return number(f.measured.packing.counts.wall_contacts); }},
      part("a", &Measurement::fabric, [](const Fabric& x) { return x.by_moment.anisotropy; }),
      part("a_error", &Measurement::fabric, [](const Fabric& x) { return x.by_moment.standard_error; }),
      part("sigma_v_Pa", &Measurement::stress, [](const ContactStress& x) { return x.symmetric(2, 2); }),
      part("sigma_h_Pa", &Measurement::stress,
           [](const ContactStress& x) { return (x.symmetric(0, 0) + x.symmetric(1, 1)) / 2; }),
      part("p_Pa", &Measurement::stress, [](const ContactStress& x) { return x.mean(); }),
      {"p_by_code_Pa",
       [](const FrameAnswer& f) {
         const auto& s = f.code_stress;
         return s ? ((*s)[0] + (*s)[1] + (*s)[2]) / 3 : nothing;
       }},
      part("f_n_mean_N", &Measurement::forces, [](const Forces& x) { return x.distribution.mean; }),
      part("Z_2", &Measurement::forces, [](const Forces& x) { return x.Z_2; }),
      part("sliding_fraction", &Measurement::forces,
           [](const Forces& x) { return x.sliding_fraction.value_or(nothing); }),
      part("unbalanced_force_ratio", &Measurement::forces,
           [](const Forces& x) { return x.unbalance.force_ratio; }),
  };
}

std::string frames_csv(const AnalyseAnswer& answer) {
  io::CsvContent csv{.notes = notes(answer), .headings = {}, .rows = {}};
  const std::vector<Column> columns = state_columns();
  for (const Column& column : columns)
    csv.headings.push_back(column.heading);
  for (const char* name : stress_names)
    csv.headings.push_back(std::string("stress_") + name + "_Pa");
  const std::vector<RungResult>& rungs = answer.frames.front().rungs;
  for (const RungResult& rung : rungs)
    for (const char* modulus : {"K", "G", "G_hh", "G_vh"})
      csv.headings.push_back(modulus + ("_" + rung.name) + "_Pa");
  for (const FrameAnswer& frame : answer.frames) {
    std::vector<io::CsvCell> row;
    for (const Column& column : columns)
      row.emplace_back(column.of(frame));
    for (std::size_t k = 0; k < std::size(stress_names); ++k)
      row.emplace_back(frame.measured.packing.stress ? printed(*frame.measured.packing.stress)[k] : nothing);
    for (std::size_t k = 0; k < rungs.size(); ++k) {
      const bool there = k < frame.rungs.size() && frame.rungs[k].moduli;
      const Moduli m = there ? *frame.rungs[k].moduli : Moduli{};
      for (const double modulus : {m.K, m.G, m.G_hh, m.G_vh})
        row.emplace_back(there ? modulus : nothing);
    }
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
      for (const ForceBin& bin : frame.measured.packing.forces->distribution.bins)
        csv.rows.push_back(
            {number(frame.number), bin.low, bin.high, number(bin.count), bin.density, bin.density_error});
  return io::csv_text(csv);
}

/// E(gamma; a), smooth.
io::Series density_curve(double anisotropy) {
  constexpr int points = 90;
  io::Series curve{
      .name = "E(\u03b3; a = " + short_text(anisotropy, 3) + ")", .mark = io::Mark::line, .x = {}, .y = {}};
  for (int k = 0; k <= points; ++k) {
    const double gamma = std::numbers::pi / 2 * k / points;
    curve.x.push_back(gamma * degrees);
    curve.y.push_back(fabric::density(gamma, anisotropy));
  }
  return curve;
}

std::string rose_picture(const FrameAnswer& frame) {
  const analysis::Fabric& f = *frame.measured.packing.fabric;
  io::Series bins{.name = "contacts, \u221an bars", .mark = io::Mark::marker, .x = {}, .y = {}};
  for (const fabric::RoseBin& bin : f.rose) {
    bins.x.push_back((bin.low + bin.high) / 2 * degrees);
    bins.y.push_back(bin.density);
    bins.y_error.push_back(bin.density_error);
  }
  return io::svg({.title = "Contact directions of " + std::to_string(f.contacts) + " contacts, step " +
                           std::to_string(frame.measured.step),
                  .x = {.title = "\u03b3 from the vertical [deg]"},
                  .y = {.title = "E [1/sr]"},
                  .series = {bins, density_curve(f.by_likelihood.value().anisotropy)}});
}

std::string force_picture(const FrameAnswer& frame) {
  const ForceDistribution& d = frame.measured.packing.forces->distribution;
  io::Series bins{.name = "contacts, \u221an bars", .mark = io::Mark::marker, .x = {}, .y = {}};
  for (const ForceBin& bin : d.bins) {
    if (bin.count == 0)
      continue; // the axis is logarithmic
    bins.x.push_back((bin.low + bin.high) / 2);
    bins.y.push_back(bin.density);
    bins.y_error.push_back(bin.count > 1 ? bin.density_error : 0);
  }
  return io::svg({.title = "Normal forces of " + std::to_string(d.pressing) + " contacts, step " +
                           std::to_string(frame.measured.step),
                  .x = {.title = "f_n/\u27e8f_n\u27e9"},
                  .y = {.title = "probability density", .scale = io::Scale::logarithmic},
                  .series = {bins}});
}

} // namespace

void write_analysis(const std::filesystem::path& folder, const AnalyseAnswer& answer, io::Existing existing) {
  const auto write = [&](const char* name, const std::string& text) {
    io::write_file(folder / name, text, existing);
  };
  const FrameAnswer& last = answer.frames.back();
  write("frames.csv", frames_csv(answer));
  if (last.measured.packing.fabric) {
    write("rose.csv", rose_csv(answer));
    write("rose.svg", rose_picture(last));
  }
  if (last.measured.packing.forces) {
    write("forces.csv", forces_csv(answer));
    write("forces.svg", force_picture(last));
  }
  write("analysis.json", analyse_json(answer).dump(2) + "\n");
}

} // namespace granum::cli

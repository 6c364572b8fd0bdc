// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cmath>

#include <fmt/core.h>
#include <granum/core/number.hpp>
#include <granum/core/units.hpp>

#include "analyse_fields.hpp"
#include "cli/options/packing_json.hpp"

namespace granum::cli {

namespace {

using analysis::Measurement;

std::string line(const std::string& label, const std::string& value, const std::string& meaning = "") {
  return io::list_line({.heading = label, .meaning = meaning}, value);
}

std::string reading_text(const FrameAnswer& frame) {
  std::string text;
  for (const bool missing : {false, true}) {
    std::string list;
    for (const io::ImportNote& note : frame.read)
      if (says_what_is_missing(note.finding) == missing)
        list += "    - " + note.text + "\n";
    if (!list.empty())
      text += (missing ? "  not in the files\n" : "  found while reading\n") + list;
  }
  return text;
}

std::string counts_text(const studies::MeasuredFrame& frame) {
  const Measurement& a = frame.packing;
  std::string text = "\ngrains and contacts\n" + io::list_text(packing_fields(), a) +
                     io::list_text(grain_count_fields(), a.counts);
  if (!frame.contacts_known)
    return text + line("C_n, z*, rattlers", "unknown", "no file contains contacts");
  if (a.sizes.smallest != a.sizes.largest)
    text += "  means for closed forms: " + means_text(a.sizes.contacts) + "\n";
  const bool rigid_bodies = a.counts.bodies != 0 && a.counts.bodies != a.counts.grains;
  if (rigid_bodies)
    text += line("rigid bodies N", std::to_string(a.counts.bodies), "counted below");
  return text + io::list_text(contact_count_fields(rigid_bodies ? "bodies" : "grains"), a.counts);
}

std::string window_text(const analysis::Window& window, const analysis::InteriorMeasures& inside) {
  std::string text =
      "\nwindow, used for the closed forms; the network covers the whole packing, because the stiffness of a "
      "part depends on the support of the grains at its faces\n";
  for (int k = 0; k < 3; ++k)
    text += line(std::string(1, "xyz"[k]), pretty(window.low[k], Dimension::length) + " to " +
                                               pretty(window.high[k], Dimension::length));
  return text + io::list_text(window_fields(), inside);
}

std::string stress_text(const FrameAnswer& frame) {
  const studies::PrintedStress stress = studies::printed(*frame.measured.packing.stress);
  const auto differences = studies::stress_differences(frame);
  std::string text = "\nstress [kPa], from the contact forces";
  text += frame.code_stress ? " against the code's own\n" : "\n";
  for (std::size_t k = 0; k < stress.size(); ++k) {
    text += fmt::format("  {:<4} {:>18.10f}", studies::stress_names[k], stress[k] / 1e3);
    if (frame.code_stress)
      text += fmt::format(" {:>18.10f}   relative difference {}", (*frame.code_stress)[k] / 1e3,
                          differences[k] ? short_text(*differences[k], 2) : "-");
    text += "\n";
  }
  return text + io::list_text(stress_fields(), *frame.measured.packing.stress);
}

std::string moduli_text(const FrameAnswer& frame) {
  std::string text =
      "\nmoduli: K and G of the nearest isotropic stiffness, the others of the nearest stiffness that is "
      "symmetric about z: G_hh in the horizontal plane, G_vh in vertical planes; net/K and net/G: K and G of "
      "the network divided by those of the row; error: standard error of G_vh in the row. Rungs 0 to 2 and "
      "affine: every grain moves with the mean strain; rung 3: grains relax, by a calibrated formula; "
      "rung 4: the forces on every grain balance\n" +
      io::heading_line(rung_fields()) + "\n";
  const std::vector<RungResult>& rungs = frame.rungs;
  for (std::size_t k = 0; k < rungs.size(); ++k) {
    if (rungs[k].moduli) {
      text += io::row_line(rung_fields(), rungs[k]) + "\n";
      continue;
    }
    const std::size_t first = k;
    std::string titles = rungs[k].title;
    for (; k + 1 < rungs.size() && !rungs[k + 1].moduli && rungs[k + 1].error == rungs[first].error; ++k)
      titles += ", " + rungs[k + 1].title;
    text += k == first ? fmt::format("{:<15} {}\n", titles, rungs[first].error)
                       : fmt::format("{}\n{:<15} {}\n", titles, "", rungs[first].error);
  }
  return text;
}

std::string probes_text(const FrameAnswer& frame) {
  std::string text;
  for (const studies::ProbedModulus& probe : frame.probes)
    text +=
        line(probe.modulus + " by probe", pretty(probe.value, Dimension::pressure),
             probe.network_over_probe ? fmt::format("network over probe {:.4f}", *probe.network_over_probe)
                                      : "no network to compare with");
  return text;
}

/// A matrix, each column as wide as its longest number; zeros within the error of the solver are shown as 0.
std::string matrix_text(const NamedMatrix& named) {
  constexpr double nothing = 1e-7;
  const elastic::Matrix6& matrix = named.matrix->stiffness.matrix;
  const double least = nothing * matrix.cwiseAbs().maxCoeff();
  std::string text = fmt::format("{:<10}", named.name);
  for (const char* const name : voigt_names)
    text += fmt::format("{:>11}", name);
  for (int row = 0; row < 6; ++row) {
    text += fmt::format("\n{:>10}", voigt_names[row]);
    for (int column = 0; column < 6; ++column)
      text +=
          fmt::format(" {:>10.4g}", std::abs(matrix(row, column)) < least ? 0 : matrix(row, column) / 1e6);
  }
  const elastic::SymmetryDistances& distance = named.matrix->symmetry;
  return text + fmt::format("\n  relative distance from the nearest stiffness that is symmetric about z: {}, "
                            "from the nearest isotropic one: {}\n",
                            short_text(distance.transversely_isotropic, 2),
                            short_text(distance.isotropic, 2));
}

std::string waves_text(const std::vector<NamedMatrix>& matrices, const std::optional<double>& bulk_density) {
  if (!bulk_density)
    return "no wave speeds: the density of the grains is not known; state it with --grain-density\n";
  std::string text =
      fmt::format("wave speeds [m/s] along 1, 2 and 3, fastest first; dry packing of {} kg/m3\n{}\n",
                  short_text(*bulk_density, 5), io::heading_line(wave_fields()));
  for (const NamedMatrix& m : matrices)
    text += m.matrix->waves ? io::row_line(wave_fields(), m) + "\n"
                            : fmt::format("{:<11}none: the matrix is not positive semidefinite\n", m.name);
  return text;
}

std::string stiffness_text(const FrameAnswer& frame) {
  const std::vector<NamedMatrix> matrices = network_matrices(frame);
  if (matrices.empty())
    return "";
  std::string text = "\nstiffness of this network in the axes of the file [MPa], Voigt notation\n";
  for (const NamedMatrix& m : matrices)
    if (m.matrix != &frame.measured.packing.network->affine_all) // its moduli below suffice
      text += matrix_text(m);
  text += "\nalong these axes; affine: uniform strain without the contacts of rattlers; affine_all: with "
          "them; relaxed: rung 4\n";
  return text + io::table_text(matrix_fields(), matrices) +
         waves_text(matrices, frame.measured.packing.bulk_density);
}

/// A part under its title, if it exists.
template <class Part>
std::string titled(const char* title, const io::Columns<Part>& fields, const std::optional<Part>& part) {
  return part ? "\n" + std::string(title) + "\n" + io::list_text(fields, *part) : "";
}

std::string frame_text(const FrameAnswer& frame) {
  const Measurement& a = frame.measured.packing;
  std::string text = fmt::format("frame {}, step {}", frame.number, frame.measured.step);
  if (frame.measured.time)
    text += fmt::format(", time {} s", short_text(*frame.measured.time, 6));
  text += "\n" + reading_text(frame);
  if (a.counts.grains > 0)
    text += counts_text(frame.measured);
  if (frame.window && a.interior)
    text += window_text(*frame.window, *a.interior);
  text += titled("fabric", fabric_fields(), a.fabric);
  if (a.stress)
    text += stress_text(frame);
  text += titled("forces", force_fields(), a.forces);
  if (a.law_check && a.law_check->contacts > 0)
    text += titled("contact law, from forces against overlaps", law_fields(), a.law_check);
  if (!frame.rungs.empty())
    text += moduli_text(frame) + probes_text(frame) + stiffness_text(frame);
  if (!a.notes.empty())
    text += "\n";
  for (const std::string& note : a.notes)
    text += "- " + note + "\n";
  return text;
}

/// Exponents of the series.
std::string series_text(const AnalyseAnswer& answer) {
  std::string text;
  for (const StateSeries& series : answer.series) {
    const std::string name = answer.series.size() > 1 ? series.name + ": " : "";
    const auto fitted = [](const RungSeries& rung) { return rung.fit.sum.has_value(); };
    if (std::none_of(series.rungs.begin(), series.rungs.end(), fitted)) {
      if (!series.rungs.empty())
        text += "\n" + name + series.rungs.front().fit.remark + "\n";
      continue;
    }
    if (!name.empty())
      text += fmt::format("\n{}{} states", name, series.frames.size());
    text += "\n" + io::heading_line(sum_fields()) + "\n";
    std::vector<RungSeries> separate;
    for (const RungSeries& rung : series.rungs) {
      text += rung.fit.sum ? io::row_line(sum_fields(), rung) + "\n"
                           : fmt::format("{:<23} {}\n", rung.title, rung.fit.remark);
      if (rung.separate)
        separate.push_back(rung);
    }
    if (!separate.empty())
      text += "\n" + io::table_text(separate_fields(), separate);
    else if (!series.rungs.front().separate_remark.empty())
      text += "m, n: " + series.rungs.front().separate_remark + "\n";
  }
  return text;
}

/// The files, one per line; of many files only the first and the last of each kind.
std::string files_text(const AnalyseAnswer& answer) {
  constexpr std::size_t many = 8;
  std::string text;
  std::size_t alike = 0; // consecutive files of the same kind before this one
  for (std::size_t k = 0; k < answer.files.size(); ++k) {
    alike = k > 0 && answer.kinds[k] == answer.kinds[k - 1] ? alike + 1 : 0;
    const bool last = k + 1 == answer.files.size() || !(answer.kinds[k + 1] == answer.kinds[k]);
    if (answer.files.size() > many && alike > 0 && !last)
      continue;
    if (answer.files.size() > many && alike > 1)
      text += fmt::format("  ... {} more\n", alike - 1);
    text += answer.files[k] + ": " + std::string(io::description(answer.kinds[k])) + "\n";
  }
  return text;
}

} // namespace

std::string analyse_table(const AnalyseAnswer& answer) {
  std::string text = files_text(answer);
  constexpr std::size_t whole = 2; // frames that are shown with all results
  if (answer.frames.size() > whole)
    text += fmt::format("\nthe last of {} frames:\n", answer.frames.size());
  for (std::size_t k = answer.frames.size() > whole ? answer.frames.size() - 1 : 0; k < answer.frames.size();
       ++k)
    text += "\n" + frame_text(answer.frames[k]);
  if (answer.frames.size() > 1)
    text += "\nall frames; G in MPa, ratio: G of the network over G of rung 3\n" +
            io::table_text(frame_fields(answer.frames.front()), answer.frames) + series_text(answer);
  if (answer.skipped > 0)
    text += fmt::format("\n{} frames are in one of the files only and were skipped\n", answer.skipped);
  return text;
}

} // namespace granum::cli

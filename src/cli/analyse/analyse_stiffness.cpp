// SPDX-License-Identifier: GPL-3.0-or-later
#include "analyse_stiffness.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include <fmt/core.h>
#include <granum/core/number.hpp>

#include "cli/frame/json_members.hpp"

namespace granum::cli {

namespace {

using analysis::NetworkMatrix;
using elastic::EngineeringModuli;
using elastic::PlaneWaves;
using io::ShownColumn;
using MatrixColumns = io::Columns<NetworkMatrix>;

constexpr double MPa = 1e6;

void add_distances(MatrixColumns& to) {
  to.emplace_back("distance_from_isotropy", "distance_from_isotropy",
                  [](const NetworkMatrix& m) { return m.symmetry.isotropic; });
  to.emplace_back("distance_from_transverse_isotropy", "distance_from_transverse_isotropy",
                  [](const NetworkMatrix& m) { return m.symmetry.transversely_isotropic; });
}

void add_moduli(MatrixColumns& to) {
  const auto add = [&](const std::string& name, double EngineeringModuli::*of) {
    to.emplace_back(
        name + "_Pa", "engineering_moduli/" + name, [of](const NetworkMatrix& m) { return m.moduli.*of; },
        ShownColumn{.heading = name, .width = 10, .digits = 4, .unit = MPa});
  };
  add("K", &EngineeringModuli::bulk_modulus);
  add("E_1", &EngineeringModuli::E_1);
  add("E_2", &EngineeringModuli::E_2);
  add("E_3", &EngineeringModuli::E_3);
  add("C44", &EngineeringModuli::C44);
  add("C55", &EngineeringModuli::C55);
  add("C66", &EngineeringModuli::C66);
}

void add_waves(MatrixColumns& to) {
  const auto add = [&](std::size_t axis, const std::string& which, elastic::PlaneWave PlaneWaves::*of) {
    const std::string number = std::to_string(axis + 1);
    to.emplace_back("v_" + number + "_" + which + "_m_per_s", "wave_speeds/along_" + number + "/" + which,
                    [axis, of](const NetworkMatrix& m) -> std::optional<double> {
                      if (!m.waves)
                        return std::nullopt;
                      return ((*m.waves)[axis].*of).speed;
                    });
  };
  for (std::size_t axis = 0; axis < 3; ++axis) {
    add(axis, "fastest", &PlaneWaves::fastest);
    add(axis, "middle", &PlaneWaves::middle);
    add(axis, "slowest", &PlaneWaves::slowest);
  }
}

/// An entry as it is shown; what the solver leaves of a zero is shown as one.
double shown(const elastic::Matrix6& matrix, int row, int column) {
  constexpr double nothing = 1e-7;
  const double entry = matrix(row, column);
  return std::abs(entry) < nothing * matrix.cwiseAbs().maxCoeff() ? 0 : entry / MPa;
}

std::string matrix_text(const NamedMatrix& named) {
  const NetworkMatrix& m = *named.matrix;
  std::array<std::array<std::string, 6>, 6> entries;
  std::size_t width = 11;
  for (int row = 0; row < 6; ++row)
    for (int column = 0; column < 6; ++column) {
      std::string& entry = entries[static_cast<std::size_t>(row)][static_cast<std::size_t>(column)];
      entry = fmt::format("{:.5g}", shown(m.stiffness.matrix, row, column));
      width = std::max(width, entry.size() + 1);
    }
  std::string text = fmt::format("  {:<10}", named.name);
  for (const char* const name : voigt_names)
    text += fmt::format("{:>{}}", name, width);
  text += "\n";
  for (std::size_t row = 0; row < 6; ++row) {
    text += fmt::format("{:>12}", voigt_names[row]);
    for (const std::string& entry : entries[row])
      text += fmt::format("{:>{}}", entry, width);
    text += "\n";
  }
  return text +
         fmt::format("  distance from the nearest stiffness that is symmetric about z: {}, isotropic: {}\n",
                     short_text(m.symmetry.transversely_isotropic, 2), short_text(m.symmetry.isotropic, 2));
}

std::string moduli_text(const std::vector<NamedMatrix>& matrices) {
  std::string text =
      fmt::format("\n{:<24}{}\n", "along these axes [MPa]", io::heading_line(matrix_columns()));
  for (const NamedMatrix& m : matrices)
    text += fmt::format("  {:<22}{}\n", m.name, io::number_line(matrix_columns(), *m.matrix));
  return text;
}

std::string waves_text(const std::vector<NamedMatrix>& matrices, const std::optional<double>& bulk_density) {
  if (!bulk_density)
    return "no wave speeds: the density of the grains is not known; --grain-density gives it\n";
  std::string text =
      fmt::format("wave speeds [m/s] along 1, 2 and 3, fastest first; dry packing of {} kg/m3\n",
                  short_text(*bulk_density, 5));
  for (const NamedMatrix& m : matrices) {
    text += fmt::format("  {:<22}", m.name);
    if (m.matrix->waves)
      for (const PlaneWaves& along : *m.matrix->waves)
        text += fmt::format(" {:>8.4g} {:>6.4g} {:>6.4g}", along.fastest.speed, along.middle.speed,
                            along.slowest.speed);
    else
      text += " none: the matrix is not positive semidefinite";
    text += "\n";
  }
  return text;
}

} // namespace

std::vector<NamedMatrix> network_matrices(const FrameAnswer& frame) {
  if (!frame.measured.packing.network)
    return {};
  const analysis::Network& network = *frame.measured.packing.network;
  std::vector<NamedMatrix> out{{"affine", &network.affine}};
  if (network.response.converged())
    out.push_back({"relaxed", &network.relaxed});
  return out;
}

const MatrixColumns& matrix_columns() {
  static const MatrixColumns columns = [] {
    MatrixColumns out;
    add_distances(out);
    add_moduli(out);
    add_waves(out);
    return out;
  }();
  return columns;
}

nlohmann::ordered_json matrix_json(const NetworkMatrix& matrix) {
  nlohmann::ordered_json json;
  for (int row = 0; row < 6; ++row) {
    nlohmann::ordered_json entries = nlohmann::ordered_json::array();
    for (int column = 0; column < 6; ++column)
      entries.push_back(matrix.stiffness.matrix(row, column));
    json["C"].push_back(std::move(entries));
  }
  put_members(json, matrix_columns(), matrix);
  if (!matrix.waves)
    json["wave_speeds"] = nullptr;
  return json;
}

std::string stiffness_text(const FrameAnswer& frame) {
  const std::vector<NamedMatrix> matrices = network_matrices(frame);
  if (matrices.empty())
    return "";
  std::string text = "\nstiffness of this network in the axes of the file [MPa], Voigt notation\n";
  for (const NamedMatrix& m : matrices)
    text += matrix_text(m);
  return text + moduli_text(matrices) + waves_text(matrices, frame.measured.packing.bulk_density);
}

io::CsvContent stiffness_csv(const AnalyseAnswer& answer) {
  io::CsvContent csv{.notes = {}, .headings = {"frame", "matrix", "row"}, .rows = {}};
  for (const char* const name : voigt_names)
    csv.headings.push_back(std::string(name) + "_Pa");
  for (const FrameAnswer& frame : answer.frames)
    for (const NamedMatrix& m : network_matrices(frame))
      for (int row = 0; row < 6; ++row) {
        std::vector<io::CsvCell> cells{number(frame.number), m.name, voigt_names[row]};
        for (int column = 0; column < 6; ++column)
          cells.emplace_back(m.matrix->stiffness.matrix(row, column));
        csv.rows.push_back(std::move(cells));
      }
  return csv;
}

} // namespace granum::cli

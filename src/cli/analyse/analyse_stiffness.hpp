// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "analyse.hpp"

/// The two 6 x 6 matrices of the network in words, JSON and CSV, in the axes of the file.
namespace granum::cli {

/// Voigt indices, of rows and columns.
inline constexpr const char* voigt_names[] = {"11", "22", "33", "23", "13", "12"};

/// What there is of a frame: "affine" and, if it was found, "relaxed".
struct NamedMatrix {
  const char* name;
  const analysis::NetworkMatrix* matrix;
};
[[nodiscard]] std::vector<NamedMatrix> network_matrices(const FrameAnswer& frame);

/// What is read off one matrix: distances from symmetry, engineering moduli, wave speeds.
[[nodiscard]] const io::Columns<analysis::NetworkMatrix>& matrix_columns();

[[nodiscard]] nlohmann::ordered_json matrix_json(const analysis::NetworkMatrix& matrix);
/// A frame's both matrices and what is read off them; nothing without a network.
[[nodiscard]] std::string stiffness_text(const FrameAnswer& frame);
/// A row of each matrix of each frame a line.
[[nodiscard]] io::CsvContent stiffness_csv(const AnalyseAnswer& answer);

} // namespace granum::cli

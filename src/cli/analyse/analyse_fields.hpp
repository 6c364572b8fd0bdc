// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "analyse.hpp"

/// Results of a frame, part by part, as lists of columns, from which JSON, the tables of CSV, the
/// screen and the page are written.
namespace granum::cli {

/// The components of a vector as a value of a column.
[[nodiscard]] inline std::vector<double> values(const Vec3& v) { return {v.x, v.y, v.z}; }

/// Sizes of the grains and the void ratio.
[[nodiscard]] const io::Columns<analysis::Measurement>& packing_fields();
/// Counts without contacts, and counts that need them: of grains, or of bodies made of grains.
[[nodiscard]] const io::Columns<analysis::Counts>& grain_count_fields();
[[nodiscard]] io::Columns<analysis::Counts> contact_count_fields(const std::string& counted = "grains");
[[nodiscard]] const io::Columns<analysis::InteriorMeasures>& window_fields();
[[nodiscard]] const io::Columns<analysis::Fabric>& fabric_fields();
[[nodiscard]] const io::Columns<packing::ContactStress>& stress_fields();
[[nodiscard]] const io::Columns<analysis::Forces>& force_fields();
[[nodiscard]] const io::Columns<analysis::LawCheck>& law_fields();
/// Headings are prefixes, completed by the name of a rung.
[[nodiscard]] const io::Columns<RungResult>& rung_fields();
[[nodiscard]] const io::Columns<analysis::Network>& network_fields();

/// A matrix of the network, and its name in tables, files and JSON.
struct NamedMatrix {
  const char* name;
  const analysis::NetworkMatrix* matrix;
};
/// Affine, the same of all contacts, and relaxed where the network was solved; none without a network.
[[nodiscard]] std::vector<NamedMatrix> network_matrices(const FrameAnswer& frame);
inline constexpr const char* voigt_names[] = {"11", "22", "33", "23", "13", "12"};
/// Moduli along the axes with the distances from symmetry, and wave speeds.
[[nodiscard]] const io::Columns<NamedMatrix>& matrix_fields();
[[nodiscard]] const io::Columns<NamedMatrix>& wave_fields();

/// Slices of a profile.
[[nodiscard]] const io::Columns<analysis::Slice>& profile_fields();
/// The profile of a frame, if it has one, as a table and as charts.
void add_profile(Document& to, const FrameAnswer& frame);
void add_profile_charts(Document& to, const FrameAnswer& frame);
[[nodiscard]] const io::Columns<network::Mode>& mode_fields();

/// Exponents of a rung over a series: s, then m and n.
[[nodiscard]] const io::Columns<RungSeries>& sum_fields();
[[nodiscard]] const io::Columns<RungSeries>& separate_fields();

/// All columns of a frame, including the parts above: a frame of the JSON, a row of frames.csv, and a line of
/// the table of frames on the screen.
/// \param    like   has the requested rungs and matrices
[[nodiscard]] io::Columns<FrameAnswer> frame_fields(const FrameAnswer& like);

} // namespace granum::cli

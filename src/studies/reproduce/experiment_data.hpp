// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <vector>

#include "studies/reproduce/experiment.hpp"

/// Parts of an experiment that its tables, claims and figures all use.
namespace granum::studies {

/// eta up to which the paper fits its Table 5 and calls a dense specimen's structure constant.
inline constexpr double early_eta = 0.6;

/// \return   nullptr if the specimen has no such run
[[nodiscard]] const PathRun* find_run(const ExperimentSpecimen& specimen,
                                      const std::optional<stress::ShearPath>& path);

/// Frozen states of the shear paths with |eta| <= early_eta, not counting those past the peak.
[[nodiscard]] std::vector<const StateRecord*> early_points(const ExperimentSpecimen& specimen);
/// The same with those of isotropic compression, for the fit of Eq. (1).
[[nodiscard]] std::vector<const StateRecord*> fit_points(const ExperimentSpecimen& specimen);

/// Cells of further_exponents that a claim needs.
inline constexpr const char* exponent_h_of_G_hh = "exponent of sigma_h in G_hh";
inline constexpr const char* exponent_v_of_G_hh = "exponent of sigma_v in G_hh";

/// A modulus of a frozen state [Pa]; empty if not measured.
using ModulusOf = std::optional<double> (*)(const StateRecord&);
[[nodiscard]] std::optional<double> network_G_hh(const StateRecord& point);
[[nodiscard]] std::optional<double> network_G_vh(const StateRecord& point);
[[nodiscard]] std::optional<double> probe_G_hh(const StateRecord& point);
[[nodiscard]] std::optional<double> probe_G_hv(const StateRecord& point);
[[nodiscard]] std::optional<double> probe_G_vh(const StateRecord& point);

} // namespace granum::studies

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "studies/reproduce/experiment.hpp"
#include "studies/verify/findings.hpp"
#include "studies/verify/seed_mean.hpp"

/// The paper's tables and claims, measured on an experiment and compared with the printed ones.
/// Checked by tests/studies/test_experiment_findings.cpp
namespace granum::studies {

/// \return   nullptr if the specimen has no such run
[[nodiscard]] const PathRun* find_run(const ExperimentSpecimen& specimen,
                                      const std::optional<stress::ShearPath>& path);

/// A modulus of a frozen state [Pa]; empty if not measured.
using ModulusOf = std::optional<double> (*)(const StateRecord&);
[[nodiscard]] std::optional<double> network_G_hh(const StateRecord& point);
[[nodiscard]] std::optional<double> network_G_vh(const StateRecord& point);
[[nodiscard]] std::optional<double> probe_G_hh(const StateRecord& point);
[[nodiscard]] std::optional<double> probe_G_hv(const StateRecord& point);
[[nodiscard]] std::optional<double> probe_G_vh(const StateRecord& point);

/// Whether the difference from the paper is within its limit.
enum class Agreement {
  not_asked, ///< no printed value, or no limit
  within,
  beyond,
  undecided, ///< the standard error of ours is larger than the reach
};

/// One cell of a table, of a contact and a density over all seeds, with the paper's value.
struct Cell {
  contact::Shape contact = contact::Shape::sphere;
  triaxial::Density density = triaxial::Density::dense;
  std::string quantity; ///< "C_n", "e", "friction angle TXC [deg]", "s of G_hv", ...
  TableValue ours;
  std::optional<double> printed = {};
  std::optional<double> reach = {}; ///< limit of |ours - printed|

  [[nodiscard]] Agreement agreement() const;
};

/// C_n of all grains and e at the first pressure, e between walls two diameters inside. The error of C_n of
/// one specimen is that of the mean number of contacts of a grain.
[[nodiscard]] std::vector<Cell> table_2(const Experiment& experiment);

/// Friction angles mobilised at the peak of each path [deg].
[[nodiscard]] std::vector<Cell> table_4(const Experiment& experiment);

/// Eq. (1) with f(e) = (2.17 - e)^2/(1 + e), fitted as in the paper (unweighted residuals of G) to the
/// network moduli of isotropic compression and of all paths for |eta| <= 0.6: s of G_hh; m, n, s and C of
/// G_hv, C with p_a = 100 kPa. G_vh is the same number as G_hv in a network, with m and n exchanged.
[[nodiscard]] std::vector<Cell> table_5(const Experiment& experiment);

/// The same exponents from the cyclic shear of the probed states, if at least 4 were probed, and that of
/// sigma_v in G_hh ~ sigma_h^m sigma_v^n.
[[nodiscard]] std::vector<Cell> further_exponents(const Experiment& experiment);

/// Verdict on each claim of the paper for which the experiment has data.
[[nodiscard]] std::vector<Verdict> experiment_verdicts(const Experiment& experiment);

} // namespace granum::studies

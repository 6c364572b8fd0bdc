// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "studies/verify/study.hpp"
#include <granum/core/numerics.hpp>

namespace granum::studies {

/// s of G ~ p^s by every route, for one contact and density.
struct ExponentRow {
  contact::Shape contact = contact::Shape::sphere;
  triaxial::Density density = triaxial::Density::dense;
  double contact_law = 0;              ///< 1/(1+alpha), or b at the force of the middle pressure
  bool local = false;                  ///< b is not the same at every force
  std::optional<Measured> closed_form; ///< uniform strain with the measured C_n and e
  std::optional<Measured> network;     ///< relaxed network
  std::optional<Measured>
      network_void;              ///< the same with f(e) = (2.17-e)^2/(1+e) in the fit, as Table 5 has it
  std::optional<Measured> probe; ///< mean of the three probes
  std::optional<double> paper;   ///< Table 5, s of G_hv                                      [Chung2014]
};

/// Exponents of the specimens that have at least three states, by Levenberg-Marquardt on G itself, as in the
/// paper: the mean over the seeds. Its standard error is, over the root of their number, the larger of two:
/// the scatter between specimens, pooled from earlier studies (seed_mean.hpp) and these seeds, and the
/// mean regression error. Empty with fewer than three states, or if the fit does not converge. Order:
/// contacts, then densities, as in the scene.
/// Checked by tests/studies/test_findings.cpp
[[nodiscard]] std::vector<ExponentRow> exponents(const Scene& scene,
                                                 const std::vector<SpecimenResult>& specimens);

/// A claim, and whether the study confirms it.
struct Verdict {
  std::string claim;
  bool holds = false;
  std::string measured;
  bool finding = false; ///< about packings, which the paper may see otherwise; else a check of granum itself
  /// Whether the measured number is a standard error or more from the limit of the claim.
  bool decided = true;
};

/// "holds" or "differs", "undecided" where that does not follow, or "FAILS" for a check of granum itself.
[[nodiscard]] const char* word_of(const Verdict& verdict);
/// Failed verdicts on granum itself.
[[nodiscard]] std::vector<Verdict> failed_checks(const std::vector<Verdict>& verdicts);
/// Verdicts that differ from the paper.
[[nodiscard]] std::vector<Verdict> differing_findings(const std::vector<Verdict>& verdicts);

/// Verdict on each claim for which the study has data.
[[nodiscard]] std::vector<Verdict> verdicts(const Scene& scene, const std::vector<SpecimenResult>& specimens);

/// A cubic through G / G_uniform-strain against z* of all states.
struct RelaxationCurve {
  std::size_t states = 0;
  double rms = 0; ///< distance of the states from the curve [1]
};
/// \return   empty with fewer than 8 states
[[nodiscard]] std::optional<RelaxationCurve> relaxation_curve(const std::vector<SpecimenResult>& specimens);

} // namespace granum::studies

// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cmath>

#include <granum/core/number.hpp>

#include "analysis_parts.hpp"

namespace granum::verify {

namespace {

using io::Finding;

std::string percent(double share) { return short_text(100 * share, 3) + " %"; }

/// What the reader found that ruins a comparison.
void pass_on(const io::ImportedPacking& packing, std::vector<std::string>& out) {
  for (const io::ImportNote& note : packing.notes)
    switch (note.finding) {
    case Finding::few_digits:
    case Finding::duplicated:
    case Finding::one_sided:
    case Finding::cell_unknown:
      out.push_back(note.text);
      break;
    default:
      break;
    }
}

void judge_forces(const ForceAnalysis& forces, std::vector<std::string>& out) {
  constexpr double at_rest = 1e-3;
  if (forces.distribution.in_tension > 0)
    out.push_back(std::to_string(forces.distribution.in_tension) +
                  " contacts are in tension: forces with viscous or cohesive parts");
  if (forces.unbalance.force_ratio > at_rest)
    out.push_back("the packing is not at rest: the mean force left on a grain is " +
                  percent(forces.unbalance.force_ratio) + " of the mean contact force");
}

void judge_law(const LawCheck& check, bool few_digits, std::vector<std::string>& out) {
  constexpr double scatter = 1e-2;
  if (check.contacts == 0)
    return;
  if (few_digits) {
    out.emplace_back("forces against overlaps say little: the overlaps are rounded");
    return;
  }
  if (check.misfit_90 > scatter)
    out.push_back(
        "forces are no function of the overlap as the law has it: 10 % of the contacts are off by " +
        percent(check.misfit_90) + " or more (viscous parts, another law, or grains of several sizes)");
}

} // namespace

void add_warnings(const io::ImportedPacking& packing, Analysis& analysis) {
  std::vector<std::string>& out = analysis.warnings;
  pass_on(packing, out);
  if (analysis.forces)
    judge_forces(*analysis.forces, out);
  if (analysis.law_check)
    judge_law(*analysis.law_check, packing.has(Finding::few_digits), out);
}

} // namespace granum::verify

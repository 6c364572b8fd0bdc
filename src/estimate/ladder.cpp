// SPDX-License-Identifier: GPL-3.0-or-later
#include <granum/estimate/ladder.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <string_view>

#include <granum/core/error.hpp>
#include <granum/core/text.hpp>

namespace granum::estimate {

namespace {

using effective::ModulusErrors;
using effective::Rung;
using effective::RungName;
using elastic::TransverselyIsotropic;

/// The moduli whose errors are stated, or a value for each of them.
using Triple = std::array<double, 3>;
constexpr std::array stated_fields{Field::bulk_modulus, Field::horizontal_shear_modulus,
                                   Field::shear_modulus};

Triple moduli(const TransverselyIsotropic& c) { return {c.bulk_modulus(), c.G_hh(), c.G_vh()}; }

ModulusErrors errors_of(const Triple& errors) {
  return {.bulk_modulus = errors[0], .G_hh = errors[1], .G_vh = errors[2]};
}
double largest(const ModulusErrors& e) { return std::max({e.bulk_modulus, e.G_hh, e.G_vh}); }

/// Rung 3 of the answer, the reference of the others. `exact` names an input that is assumed to be exact.
struct Truth {
  Triple moduli{};
  Triple relative_errors{};

  Truth(const Answer& answer, std::string_view exact) {
    for (std::size_t k = 0; k < stated_fields.size(); ++k) {
      const Range range = answer.without(stated_fields[k], exact);
      moduli[k] = range.value;
      relative_errors[k] = range.relative_error();
    }
  }
};

/// Error of a stiffness: its distance from rung 3, and the error of rung 3.
ModulusErrors stated_error(const TransverselyIsotropic& stiffness, const Truth& truth) {
  const Triple own = moduli(stiffness);
  Triple errors{};
  for (std::size_t k = 0; k < errors.size(); ++k) {
    const double ratio = own[k] / truth.moduli[k];
    errors[k] = std::abs(ratio - 1) + std::abs(ratio) * truth.relative_errors[k];
  }
  return errors_of(errors);
}

// ---- the rungs

/// Inputs of a rung that are not given for this packing.
std::vector<std::string> missing(const Rung& row, const Answer& answer) {
  if (row.needs_packing)
    return {"a packing"};
  if (row.needs_fabric && answer.assumes(fabric_input))
    return {"the fabric a"};
  return {};
}

std::vector<RungAssessment> rungs_of(const Answer& answer) {
  std::vector<RungAssessment> all;
  for (const Rung& row : effective::rungs())
    if (row.number) {
      RungAssessment& rung = all.emplace_back();
      rung.rung = &row;
      rung.missing = missing(row, answer);
      if (rung.missing.empty())
        rung.stiffness = effective::answer(row, answer.state()).stiffness;
    }
  std::sort(all.begin(), all.end(), [](const RungAssessment& a, const RungAssessment& b) {
    return *a.rung->number < *b.rung->number;
  });
  return all;
}

/// "rung 3 2.7 %, contacts 10 %": the largest contribution of each input.
std::string parts_text(const Answer& answer) {
  std::vector<std::pair<std::string, double>> parts;
  for (const Effect& effect : answer.effects()) {
    double part = 0;
    for (const Field field : stated_fields) {
      const auto k = static_cast<std::size_t>(field);
      part = std::max(part, (effect.high[k] - effect.low[k]) / (2 * answer[field].value));
    }
    const auto same = std::find_if(parts.begin(), parts.end(),
                                   [&](const auto& other) { return other.first == effect.input; });
    if (same != parts.end())
      same->second = std::max(same->second, part);
    else
      parts.emplace_back(effect.input, part);
  }
  std::string text;
  for (const auto& [input, part] : parts)
    if (part > 0)
      text += (text.empty() ? "" : ", ") + (input == "rung 3" ? "its calibration" : input) + " " +
              percent_text(part);
  return text;
}

/// States the errors of all rungs as if one input were exact.
void state_errors(std::vector<RungAssessment>& rungs, const Answer& answer, std::string_view exact = {}) {
  const Truth truth(answer, exact);
  for (RungAssessment& rung : rungs)
    if (rung.stiffness)
      rung.relative_error = rung.rung->name == RungName::relaxed ? errors_of(truth.relative_errors)
                                                                 : stated_error(*rung.stiffness, truth);
}

void name_sources(std::vector<RungAssessment>& rungs, const Answer& answer) {
  for (RungAssessment& rung : rungs)
    if (rung.stiffness || rung.rung->needs_packing)
      rung.error_source =
          rung.rung->name == RungName::relaxed ? parts_text(answer) : std::string(rung.rung->error_source);
}

// ---- the choice

std::string number_of(const Ladder& ladder, std::size_t k) {
  return std::to_string(*ladder.rungs[k].rung->number);
}

/// The first rung of the smallest error, errors below the tolerance counting as equal; empty if none states
/// one.
std::optional<std::size_t> best_of(const std::vector<RungAssessment>& rungs, double tolerance) {
  std::optional<std::size_t> best;
  for (std::size_t k = 0; k < rungs.size(); ++k) {
    const auto error = rungs[k].largest_error();
    if (error && (!best || std::max(*error, tolerance) < std::max(*rungs[*best].largest_error(), tolerance)))
      best = k;
  }
  return best;
}

std::string joined(const std::vector<std::string>& words) {
  std::string text;
  for (const std::string& word : words)
    text += (text.empty() ? "" : " and ") + word;
  return text;
}

void give_reason(RungAssessment& rung, const Ladder& ladder) {
  const auto error = rung.largest_error();
  const bool chosen = &rung == &ladder.choice();
  if (!rung.missing.empty()) {
    rung.verdict = RungVerdict::inputs_missing;
    rung.reason = "needs " + joined(rung.missing);
  } else if (!error) {
    rung.verdict = chosen ? RungVerdict::chosen : RungVerdict::error_unknown;
    rung.reason = "its error is not known";
  } else if (chosen) {
    rung.verdict = RungVerdict::chosen;
    rung.reason = ladder.tolerance_met ? "the cheapest whose stated error fits" : "the smallest stated error";
  } else if (*error <= ladder.tolerance) {
    rung.verdict = RungVerdict::cheaper_does;
    rung.reason = "fits as well, but rung " + number_of(ladder, ladder.chosen) + " is cheaper";
  } else {
    rung.verdict = RungVerdict::beyond_tolerance;
    rung.reason = "its stated error exceeds the tolerance";
  }
}

/// Advice on an input whose better knowledge would change the choice or the error.
void advise_input(Ladder& ladder, const Answer& answer, const std::string& input) {
  std::vector<RungAssessment> rungs = ladder.rungs;
  if (input == fabric_input) // if it were measured, it would not be missing
    for (RungAssessment& rung : rungs)
      if (!rung.rung->needs_packing)
        rung.stiffness = effective::answer(*rung.rung, answer.state()).stiffness;
  state_errors(rungs, answer, input);
  const std::size_t then = *best_of(rungs, ladder.tolerance);
  const double now = *ladder.choice().largest_error(), error = *rungs[then].largest_error();
  const std::string known = input == "contacts" ? "z* and the share of rattlers" : input;
  if (ladder.tolerance_met && then < ladder.chosen)
    ladder.advice.push_back(known + ", if known exactly, would allow rung " + number_of(ladder, then) +
                            ", which is cheaper");
  else if (!ladder.tolerance_met && error < 0.95 * now)
    ladder.advice.push_back(known + ", if known exactly, would leave rung " + number_of(ladder, then) +
                            " an error of " + percent_text(error) + ", " +
                            (error <= ladder.tolerance ? "within" : "still beyond") + " the tolerance");
}

/// Advice on cheaper rungs, except those for which a still cheaper one is nearly as good.
void advise_tolerance(Ladder& ladder) {
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t k = 0; k < ladder.chosen; ++k) {
    const auto error = ladder.rungs[k].largest_error();
    if (!error || !(*error < 0.95 * least))
      continue;
    ladder.advice.push_back("rung " + number_of(ladder, k) + " would be enough for a tolerance of " +
                            percent_text(*error));
    least = *error;
  }
}

void advise(Ladder& ladder, const Answer& answer) {
  for (const Share& share : answer.shares())
    if (share.input != "rung 3")
      advise_input(ladder, answer, share.input);
  if (!ladder.tolerance_met)
    ladder.advice.emplace_back(
        "a packing of grains, from a DEM code or made by granum, would allow rung 4, the "
        "response of its contact network, which has no such error");
  advise_tolerance(ladder);
}

void note_tolerance(Ladder& ladder) {
  const auto error = ladder.choice().largest_error();
  if (!error)
    ladder.validity.add("the error of no rung is known: the packing may not be rigid, and the tolerance of " +
                        percent_text(ladder.tolerance) + " is not met");
  else if (!ladder.tolerance_met)
    ladder.validity.add("the tolerance of " + percent_text(ladder.tolerance) +
                        " is not met: the best rung, " + number_of(ladder, ladder.chosen) +
                        ", has a stated error of " + percent_text(*error));
}

// ---- the three kinds of packing

/// No relaxation: every rung gives zero.
void settle_without_stiffness(Ladder& ladder, const Answer& answer) {
  for (RungAssessment& rung : ladder.rungs) {
    if (!rung.missing.empty())
      continue;
    rung.stiffness = TransverselyIsotropic{};
    rung.relative_error = ModulusErrors{};
    rung.error_source = *answer.state().coordination_number > 0
                            ? "exact: contacts without force have no stiffness"
                            : "exact: no contacts, no stiffness";
  }
  ladder.tolerance_met = true;
}

/// The loosest packings may not be rigid: rung 3 is chosen, but its error is not known.
void settle_unknown(Ladder& ladder, const Answer& answer) {
  const auto relaxed = std::find_if(ladder.rungs.begin(), ladder.rungs.end(), [](const RungAssessment& rung) {
    return rung.rung->name == RungName::relaxed;
  });
  ladder.chosen = static_cast<std::size_t>(relaxed - ladder.rungs.begin());
  if (answer.assumes("contacts"))
    ladder.advice.emplace_back("z* or the share of rattlers would decide whether the packing is rigid");
}

void settle(Ladder& ladder, const Answer& answer) {
  state_errors(ladder.rungs, answer);
  name_sources(ladder.rungs, answer);
  ladder.chosen = *best_of(ladder.rungs, ladder.tolerance);
  ladder.tolerance_met = *ladder.choice().largest_error() <= ladder.tolerance;
  advise(ladder, answer);
}

} // namespace

const char* name(RungVerdict verdict) {
  switch (verdict) {
  case RungVerdict::chosen:
    return "chosen";
  case RungVerdict::cheaper_does:
    return "cheaper_does";
  case RungVerdict::beyond_tolerance:
    return "beyond_tolerance";
  case RungVerdict::error_unknown:
    return "error_unknown";
  case RungVerdict::inputs_missing:
    return "inputs_missing";
  }
  throw InvalidArgument("verdict is not one of the known ones");
}

std::optional<double> RungAssessment::largest_error() const {
  return relative_error ? std::optional(largest(*relative_error)) : std::nullopt;
}

Ladder choose(const Answer& answer, double tolerance) {
  require_positive("tolerance", tolerance);
  if (answer.grain_shape() == GrainShape::sand)
    throw InvalidArgument(
        "tolerance: rungs apply to spheres; the answer for a sand is measured, and its range is its error. "
        "Use grain shape sphere for the rungs");
  Ladder ladder{.tolerance = tolerance,
                .mechanical_coordination_number = answer[Field::mechanical_coordination_number],
                .rungs = rungs_of(answer),
                .advice = {},
                .validity = answer.validity()};
  const auto rigid = [&](Field field) { return answer[field].value > 0; };
  const auto affine = effective::answer(effective::rung(RungName::directional), answer.state()).stiffness;
  if (affine == TransverselyIsotropic{})
    settle_without_stiffness(ladder, answer);
  else if (std::all_of(stated_fields.begin(), stated_fields.end(), rigid))
    settle(ladder, answer);
  else
    settle_unknown(ladder, answer);
  if (!(affine == TransverselyIsotropic{}))
    note_tolerance(ladder);
  for (RungAssessment& rung : ladder.rungs)
    give_reason(rung, ladder);
  return ladder;
}

} // namespace granum::estimate

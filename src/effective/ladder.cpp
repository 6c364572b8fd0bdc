// SPDX-License-Identifier: GPL-3.0-or-later
#include <granum/effective/ladder.hpp>

#include <algorithm>
#include <cmath>
#include <limits>

#include <granum/core/check.hpp>
#include <granum/core/error.hpp>
#include <granum/core/number.hpp>
#include <granum/effective/rungs.hpp>

namespace granum::effective {

namespace {

using elastic::TransverselyIsotropic;

constexpr double smallest_specimen = 3.6, largest_specimen = 8.7; // C_n of the estimate of z*

/// K, G_hh and G_vh, the moduli whose errors are stated, or what belongs to each of them.
using Triple = std::array<double, 3>;

Triple moduli(const TransverselyIsotropic& c) { return {c.bulk_modulus(), c.G_hh(), c.G_vh()}; }

std::string join(const std::vector<std::string>& words) {
  std::string text;
  for (const std::string& word : words)
    text += (text.empty() ? "" : " and ") + word;
  return text;
}

// --- what is known -------------------------------------------------------------------------------------

struct Coordination {
  Measured z;
  bool estimated;
};

Coordination coordination_of(const KnownPacking& packing) {
  const auto& z = packing.mechanical_coordination_number;
  const auto& rattlers = packing.rattler_fraction;
  if (z && rattlers)
    throw InvalidArgument("mechanical_coordination_number and rattler_fraction say the same: give one");
  if (z) {
    require_non_negative("mechanical_coordination_number", z->value);
    require_non_negative("standard error of mechanical_coordination_number", z->standard_error);
    return {*z, false};
  }
  const double C_n = packing.state.coordination_number;
  if (!rattlers)
    return {estimated_mechanical_coordination_number(C_n), true};
  const double value = mechanical_coordination_number(C_n, rattlers->value);
  const double error = require_non_negative("standard error of rattler_fraction", rattlers->standard_error);
  return {{value, value * error / (1 - rattlers->value)}, false};
}

/// Scatter of a of specimens that were made without a preferred direction and then sheared.
double assumed_fabric_error(const State& s) {
  return std::hypot(0.012, s.stress_h > 0 ? 0.2 * std::log(s.stress_v / s.stress_h) : 0);
}

// --- what rung 3 says, and how far it may be trusted ----------------------------------------------------

/// Standard errors over the modulus, by where they come from.
struct Relaxed {
  TransverselyIsotropic stiffness;
  Triple calibration{};  ///< of the relaxation factors
  Triple coordination{}; ///< of z*
  Triple fabric{};       ///< of a
  Validity validity;

  [[nodiscard]] bool rigid() const {
    const Triple values = moduli(stiffness);
    return std::all_of(values.begin(), values.end(),
                       [](double value) { return value > 0 && std::isfinite(value); });
  }
};

RungAnswer rung3(const State& state, double z) {
  return effective::answer(rung(RungName::relaxed), {.state = state, .mechanical_coordination_number = z});
}

/// |X_2 - X_1|/X of each modulus.
Triple differences(const TransverselyIsotropic& first, const TransverselyIsotropic& second,
                   const Triple& middle) {
  Triple shares{};
  for (std::size_t k = 0; k < shares.size(); ++k)
    shares[k] = std::abs(moduli(second)[k] - moduli(first)[k]) / middle[k];
  return shares;
}

/// What a standard error of z* to either side makes of each modulus.
Triple error_by_coordination(const State& state, const Measured& z, const Triple& middle) {
  if (z.standard_error == 0)
    return {};
  Triple shares = differences(rung3(state, std::max(0.0, z.value - z.standard_error)).stiffness,
                              rung3(state, z.value + z.standard_error).stiffness, middle);
  for (double& share : shares)
    share /= 2;
  return shares;
}

/// What a standard error of a makes of each modulus. It is taken to the side where the contact forces are
/// more alike: to the other they might be more unequal than a State may have them.
Triple error_by_fabric(const State& state, double z, double error, const TransverselyIsotropic& estimate) {
  const double a = state.fabric_anisotropy;
  const bool upright_contacts_carry_more = state.stress_v * (5 - 3 * a) > state.stress_h * (5 + a);
  State other = state; // |a| <= 1: a density of contacts that is nowhere negative
  other.fabric_anisotropy = std::clamp(upright_contacts_carry_more ? a + error : a - error, -1.0, 1.0);
  return differences(estimate, rung3(other, z).stiffness, moduli(estimate));
}

Relaxed relax(const State& state, const Measured& z, double fabric_error) {
  const RungAnswer estimate = rung3(state, z.value);
  Relaxed answer{.stiffness = estimate.stiffness, .validity = estimate.validity};
  if (!answer.rigid())
    return answer;
  const Triple middle = moduli(estimate.stiffness);
  const ModulusErrors& own = *estimate.relative_error;
  answer.calibration = {own.bulk_modulus, own.G_hh, own.G_vh};
  answer.coordination = error_by_coordination(state, z, middle);
  if (fabric_error > 0)
    answer.fabric = error_by_fabric(state, z.value, fabric_error, estimate.stiffness);
  return answer;
}

/// Which inputs are not exact.
struct Doubts {
  bool coordination = true;
  bool fabric = true;
};

/// Stated error of a stiffness: its distance from rung 3, and the standard error of that.
ModulusErrors stated_error(const TransverselyIsotropic& stiffness, const Relaxed& truth,
                           const Doubts& doubts = {}) {
  Triple errors{};
  for (std::size_t k = 0; k < errors.size(); ++k) {
    const double ratio = moduli(stiffness)[k] / moduli(truth.stiffness)[k];
    const double own = std::hypot(truth.calibration[k], doubts.coordination ? truth.coordination[k] : 0.0,
                                  doubts.fabric ? truth.fabric[k] : 0.0);
    errors[k] = std::abs(ratio - 1) + std::abs(ratio) * own;
  }
  return {.bulk_modulus = errors[0], .G_hh = errors[1], .G_vh = errors[2]};
}

double largest(const ModulusErrors& e) { return std::max({e.bulk_modulus, e.G_hh, e.G_vh}); }

// --- the rungs ------------------------------------------------------------------------------------------

std::size_t place(const Rung& row) { return static_cast<std::size_t>(*row.number); }
std::size_t relaxed_place() { return place(rung(RungName::relaxed)); }

/// What the rung lacks of this packing.
std::vector<std::string> missing(const Rung& row, const KnownPacking& packing) {
  if (row.needs_packing)
    return {"a packing"};
  if (row.needs_fabric && !packing.fabric_standard_error)
    return {"the fabric a"};
  return {};
}

std::array<RungAssessment, 6> ladder(const KnownPacking& packing) {
  std::array<RungAssessment, 6> ladder;
  for (const Rung& row : rungs())
    if (row.number) {
      RungAssessment& assessment = ladder[place(row)];
      assessment.rung = *row.number;
      assessment.title = row.title;
      assessment.typical_time = row.typical_time;
      assessment.missing = missing(row, packing);
    }
  return ladder;
}

/// Those below rung 3, which has been worked out before.
void work_out(std::array<RungAssessment, 6>& ladder, const State& state) {
  for (const Rung& row : closed_forms())
    if (row.number && !row.needs_coordination && ladder[place(row)].missing.empty())
      ladder[place(row)].stiffness = effective::answer(row, {.state = state}).stiffness;
}

/// "its calibration 2.7 %, z* 10 %": the largest part of each kind.
std::string parts_text(const Relaxed& truth, const Coordination& z, bool fabric_assumed) {
  const auto most = [](const Triple& errors) { return *std::max_element(errors.begin(), errors.end()); };
  std::string text = "its calibration " + percent_text(most(truth.calibration));
  if (most(truth.coordination) > 0)
    text += (z.estimated ? ", z* estimated from C_n " : ", z* ") + percent_text(most(truth.coordination));
  if (most(truth.fabric) > 0)
    text += (fabric_assumed ? ", a assumed " : ", a ") + percent_text(most(truth.fabric));
  return text;
}

void state_errors(std::array<RungAssessment, 6>& ladder, const Relaxed& truth, const std::string& parts) {
  for (const Rung& row : rungs()) {
    if (!row.number)
      continue;
    RungAssessment& assessment = ladder[place(row)];
    if (assessment.stiffness)
      assessment.relative_error = stated_error(*assessment.stiffness, truth);
    if (assessment.stiffness || row.needs_packing)
      assessment.error_source = row.name == RungName::relaxed ? parts : row.error_source;
  }
}

// --- the choice -----------------------------------------------------------------------------------------

/// The first rung of the smallest error that is not below the tolerance; nothing if none states an error.
std::optional<std::size_t> choose(const std::array<RungAssessment, 6>& rungs, double tolerance) {
  std::optional<std::size_t> best;
  for (std::size_t k = 0; k < rungs.size(); ++k) {
    const auto error = rungs[k].largest_error();
    if (error && (!best || std::max(*error, tolerance) < std::max(*rungs[*best].largest_error(), tolerance)))
      best = k;
  }
  return best;
}

void give_reason(RungAssessment& rung, const LadderEstimate& ladder) {
  const auto error = rung.largest_error();
  const bool chosen = &rung == &ladder.choice();
  if (!rung.missing.empty()) {
    rung.verdict = RungVerdict::inputs_missing;
    rung.reason = "needs " + join(rung.missing);
  } else if (!error) {
    rung.verdict = chosen ? RungVerdict::chosen : RungVerdict::error_unknown;
    rung.reason = "its error is not known";
  } else if (chosen) {
    rung.verdict = RungVerdict::chosen;
    rung.reason = ladder.tolerance_met ? "the cheapest whose stated error fits" : "the smallest stated error";
  } else if (*error <= ladder.tolerance) {
    rung.verdict = RungVerdict::cheaper_does;
    rung.reason = "fits as well, but rung " + std::to_string(ladder.chosen) + " is cheaper";
  } else {
    rung.verdict = RungVerdict::beyond_tolerance;
    rung.reason = "its stated error exceeds the tolerance";
  }
}

/// The same rungs, had some inputs been exact.
std::array<RungAssessment, 6> without(std::array<RungAssessment, 6> rungs, const Relaxed& truth,
                                      const Doubts& doubts) {
  for (RungAssessment& rung : rungs)
    if (rung.relative_error)
      rung.relative_error = stated_error(*rung.stiffness, truth, doubts);
  return rungs;
}

/// What a better knowledge of an input would change, if anything that matters.
void advise_input(LadderEstimate& ladder, const Relaxed& truth, const Doubts& doubts,
                  const std::string& input) {
  const auto rungs = without(ladder.rungs, truth, doubts);
  const std::size_t then = *choose(rungs, ladder.tolerance);
  const double now = *ladder.choice().largest_error(), error = *rungs[then].largest_error();
  if (ladder.tolerance_met && then < ladder.chosen)
    ladder.advice.push_back(input + " would allow rung " + std::to_string(then) + ", which is cheaper");
  else if (!ladder.tolerance_met && error < 0.95 * now)
    ladder.advice.push_back(input + " would leave rung " + std::to_string(then) + " an error of " +
                            percent_text(error) + ", " +
                            (error <= ladder.tolerance ? "within" : "still beyond") + " the tolerance");
}

/// Cheaper rungs, unless one that is cheaper still does nearly as well.
void advise_tolerance(LadderEstimate& ladder) {
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t k = 0; k < ladder.chosen; ++k) {
    const auto error = ladder.rungs[k].largest_error();
    if (!error || !(*error < 0.95 * least))
      continue;
    ladder.advice.push_back("rung " + std::to_string(k) + " would do for a tolerance of " +
                            percent_text(*error));
    least = *error;
  }
}

void advise(LadderEstimate& ladder, const Relaxed& truth, bool fabric_assumed) {
  const std::string rattlers =
      ladder.coordination_estimated ? "z* or the share of rattlers" : "z* without a standard error";
  const std::string fabric = fabric_assumed ? "the fabric a" : "a without a standard error";
  advise_input(ladder, truth, {.coordination = false, .fabric = true}, rattlers);
  advise_input(ladder, truth, {.coordination = true, .fabric = false}, fabric);
  if (ladder.advice.empty())
    advise_input(ladder, truth, {.coordination = false, .fabric = false}, rattlers + " and " + fabric);
  if (!ladder.tolerance_met)
    ladder.advice.emplace_back(
        "a packing of grains, of a DEM code or of granum's own, would allow rung 4, the "
        "response of its contact network, which has no such error");
  advise_tolerance(ladder);
}

void note_tolerance(LadderEstimate& ladder) {
  const auto error = ladder.choice().largest_error();
  if (!error)
    ladder.validity.add("the error of no rung is known: the packing may not be rigid, and the tolerance of " +
                        percent_text(ladder.tolerance) + " is not met");
  else if (!ladder.tolerance_met)
    ladder.validity.add("the tolerance of " + percent_text(ladder.tolerance) +
                        " is not met: the best rung, " + std::to_string(ladder.chosen) +
                        ", has a stated error of " + percent_text(*error));
}

/// Nothing to relax: every rung says zero.
LadderEstimate without_stiffness(LadderEstimate ladder, const KnownPacking& packing) {
  for (RungAssessment& rung : ladder.rungs) {
    if (!rung.missing.empty())
      continue;
    rung.stiffness = TransverselyIsotropic{};
    rung.relative_error = ModulusErrors{};
    rung.error_source = packing.state.coordination_number > 0
                            ? "exact: contacts without force have no stiffness"
                            : "exact: no contacts, no stiffness";
  }
  ladder.tolerance_met = true;
  return ladder;
}

} // namespace

std::optional<double> RungAssessment::largest_error() const {
  return relative_error ? std::optional(largest(*relative_error)) : std::nullopt;
}

Measured estimated_mechanical_coordination_number(double coordination_number) {
  require_non_negative("coordination_number", coordination_number);
  const double gain = std::exp(2.732 - 0.961 * coordination_number);
  return {coordination_number + gain, gain / std::sqrt(3.0)};
}

LadderEstimate estimate(const KnownPacking& packing, double tolerance) {
  require_positive("tolerance", tolerance);
  if (packing.fabric_standard_error)
    require_non_negative("fabric_standard_error", *packing.fabric_standard_error);
  const State& state = packing.state;
  const RungAnswer directional = effective::answer(rung(RungName::directional), {.state = state});
  const Coordination z = coordination_of(packing);
  LadderEstimate answer{.tolerance = tolerance,
                        .mechanical_coordination_number = z.z,
                        .coordination_estimated = z.estimated,
                        .rungs = ladder(packing),
                        .advice = {},
                        .validity = directional.validity};
  if (directional.stiffness == TransverselyIsotropic{}) {
    answer = without_stiffness(std::move(answer), packing);
  } else {
    const bool fabric_assumed = !packing.fabric_standard_error;
    const double fabric_error = packing.fabric_standard_error.value_or(assumed_fabric_error(state));
    const Relaxed truth = relax(state, z.z, fabric_error);
    work_out(answer.rungs, state);
    answer.rungs[relaxed_place()].stiffness = truth.stiffness;
    answer.validity = truth.validity;
    if (z.estimated &&
        (state.coordination_number < smallest_specimen || state.coordination_number > largest_specimen))
      answer.validity.add("z* is estimated from C_n = " + short_text(state.coordination_number) +
                          ": the specimens behind that had 3.6 to 8.7");
    answer.chosen = relaxed_place();
    if (truth.rigid()) {
      state_errors(answer.rungs, truth, parts_text(truth, z, fabric_assumed));
      answer.chosen = *choose(answer.rungs, tolerance);
      answer.tolerance_met = *answer.choice().largest_error() <= tolerance;
      advise(answer, truth, fabric_assumed);
    } else if (z.estimated) {
      answer.advice.emplace_back("z* or the share of rattlers would tell whether the packing is rigid");
    }
    note_tolerance(answer);
  }
  for (RungAssessment& rung : answer.rungs)
    give_reason(rung, answer);
  return answer;
}

} // namespace granum::effective

// SPDX-License-Identifier: GPL-3.0-or-later
#include "ladder_report.hpp"

#include <fmt/core.h>
#include <granum/core/number.hpp>

namespace granum::cli {

namespace {

using effective::LadderEstimate;
using effective::ModulusErrors;
using effective::RungAssessment;
using effective::RungVerdict;
using elastic::TransverselyIsotropic;
using nlohmann::ordered_json;

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
  default:
    return "inputs_missing";
  }
}

ordered_json stiffness_json(const TransverselyIsotropic& c) {
  return {{"C11", c.C11}, {"C33", c.C33},          {"C12", c.C12},     {"C13", c.C13},
          {"C44", c.C44}, {"K", c.bulk_modulus()}, {"G_hh", c.G_hh()}, {"G_vh", c.G_vh()}};
}

ordered_json rung_json(const RungAssessment& rung) {
  ordered_json json = {{"rung", rung.rung}, {"title", rung.title}};
  json["moduli"] = rung.stiffness ? stiffness_json(*rung.stiffness) : ordered_json();
  json["relative_error"] = ordered_json();
  if (const auto& error = rung.relative_error)
    json["relative_error"] = {{"K", error->bulk_modulus}, {"G_hh", error->G_hh}, {"G_vh", error->G_vh}};
  json.update({{"error_source", rung.error_source},
               {"typical_time", rung.typical_time},
               {"missing", rung.missing},
               {"verdict", name(rung.verdict)},
               {"reason", rung.reason}});
  return json;
}

std::string modulus_text(const char* symbol, double value, const std::optional<double>& error) {
  return fmt::format("{} = {}{}", symbol, pretty(value, Dimension::pressure),
                     error ? " +- " + percent_text(*error) : "");
}

std::string answer_text(const RungAssessment& rung) {
  const TransverselyIsotropic& c = *rung.stiffness;
  const auto error = [&rung](double ModulusErrors::*member) {
    return rung.relative_error ? std::optional((*rung.relative_error).*member) : std::nullopt;
  };
  return fmt::format("  {}\n  {}\n  {}\n", modulus_text("G_vh", c.G_vh(), error(&ModulusErrors::G_vh)),
                     modulus_text("G_hh", c.G_hh(), error(&ModulusErrors::G_hh)),
                     modulus_text("K   ", c.bulk_modulus(), error(&ModulusErrors::bulk_modulus)));
}

std::string rung_line(const RungAssessment& rung) {
  const auto error = rung.largest_error();
  const std::string value = rung.stiffness ? pretty(rung.stiffness->G_vh(), Dimension::pressure) : "-";
  return fmt::format("  {}  {:<47} {:>10} {:>8} {:>8}  {}\n", rung.rung, rung.title, value,
                     error ? percent_text(*error) : "-", pretty(rung.typical_time, Dimension::time),
                     rung.verdict == RungVerdict::chosen ? "chosen: " + rung.reason : rung.reason);
}

const char* tolerance_text(const LadderEstimate& ladder) {
  if (ladder.tolerance_met)
    return "met";
  const auto error = ladder.choice().largest_error();
  return error && *error <= ladder.tolerance ? "met only if the assumed C_n is right" : "not met";
}

std::string coordination_text(const LadderEstimate& ladder) {
  const auto& z = ladder.mechanical_coordination_number;
  std::string text = "z* = " + short_text(z.value);
  if (z.standard_error > 0)
    text += " +- " + short_text(z.standard_error, 2);
  return text + (ladder.coordination_estimated ? ", estimated from C_n" : "");
}

} // namespace

LadderEstimate choose_rung(const PackingOptions& options, const effective::State& state, double tolerance) {
  effective::KnownPacking packing{.state = state};
  if (const auto z = resolve_mechanical_coordination_number(options))
    packing.mechanical_coordination_number = Measured{*z, 0};
  if (!options.fabric.given())
    packing.fabric_standard_error.reset();
  LadderEstimate ladder = effective::estimate(packing, tolerance);
  if (!options.coordination_number.given()) {
    ladder.tolerance_met = false;
    ladder.validity.add("--coordination-number was assumed: the stated errors hold for that number, and "
                        "whether this packing has it is not known");
  }
  return ladder;
}

ordered_json ladder_json(const LadderEstimate& ladder) {
  ordered_json json = {{"tolerance", ladder.tolerance},
                       {"tolerance_met", ladder.tolerance_met},
                       {"rung", ladder.choice().rung}};
  json["mechanical_coordination_number"] = {
      {"value", ladder.mechanical_coordination_number.value},
      {"standard_error", ladder.mechanical_coordination_number.standard_error},
      {"estimated", ladder.coordination_estimated}};
  json["rungs"] = ordered_json::array();
  for (const RungAssessment& rung : ladder.rungs)
    json["rungs"].push_back(rung_json(rung));
  json["advice"] = ladder.advice;
  return json;
}

std::string ladder_table(const LadderEstimate& ladder) {
  const RungAssessment& choice = ladder.choice();
  std::string text = fmt::format("\nRung {}, {}: tolerance of {} {}\n\n", choice.rung, choice.title,
                                 percent_text(ladder.tolerance), tolerance_text(ladder));
  text += answer_text(choice);
  text += fmt::format("\n  {:<50} {:>10} {:>8} {:>8}\n", "rung", "G_vh", "error", "time");
  for (const RungAssessment& rung : ladder.rungs)
    text += rung_line(rung);
  text += fmt::format(
      "\nStated errors are standard errors against the packing's own contact network, the largest "
      "of K,\nG_hh and G_vh; {}",
      coordination_text(ladder));
  if (const std::string& source = choice.error_source; !source.empty())
    text += fmt::format(". Rung {}: {}", choice.rung, source);
  text += ".\n";
  for (const std::string& advice : ladder.advice)
    text += "- " + advice + "\n";
  return text;
}

} // namespace granum::cli

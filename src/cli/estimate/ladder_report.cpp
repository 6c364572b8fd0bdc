// SPDX-License-Identifier: GPL-3.0-or-later
#include "estimate.hpp"

#include <fmt/core.h>
#include <granum/core/number.hpp>

namespace granum::cli {

namespace {

using effective::ModulusErrors;
using elastic::TransverselyIsotropic;
using estimate::Ladder;
using estimate::RungAssessment;
using estimate::RungVerdict;
using nlohmann::ordered_json;

ordered_json stiffness_json(const TransverselyIsotropic& c) {
  return {{"C11", c.C11}, {"C33", c.C33},          {"C12", c.C12},     {"C13", c.C13},
          {"C44", c.C44}, {"K", c.bulk_modulus()}, {"G_hh", c.G_hh()}, {"G_vh", c.G_vh()}};
}

ordered_json rung_json(const RungAssessment& rung) {
  ordered_json json = {{"rung", *rung.rung->number}, {"title", rung.rung->title}};
  json["moduli"] = rung.stiffness ? stiffness_json(*rung.stiffness) : ordered_json();
  json["relative_error"] = ordered_json();
  if (const auto& error = rung.relative_error)
    json["relative_error"] = {{"K", error->bulk_modulus}, {"G_hh", error->G_hh}, {"G_vh", error->G_vh}};
  json.update({{"error_source", rung.error_source},
               {"typical_time", rung.rung->typical_time},
               {"missing", rung.missing},
               {"verdict", estimate::name(rung.verdict)},
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
  return fmt::format("  {}  {:<47} {:>10} {:>7} {:>7}\n     {}\n", *rung.rung->number, rung.rung->title,
                     value, error ? percent_text(*error) : "-",
                     pretty(rung.rung->typical_time, Dimension::time),
                     rung.verdict == RungVerdict::chosen ? "chosen: " + rung.reason : rung.reason);
}

} // namespace

ordered_json ladder_json(const Ladder& ladder) {
  ordered_json json = {{"tolerance", ladder.tolerance},
                       {"tolerance_met", ladder.tolerance_met},
                       {"rung", *ladder.choice().rung->number}};
  const estimate::Range& z = ladder.mechanical_coordination_number;
  json["mechanical_coordination_number"] = {{"value", z.value}, {"low", z.low}, {"high", z.high}};
  json["rungs"] = ordered_json::array();
  for (const RungAssessment& rung : ladder.rungs)
    json["rungs"].push_back(rung_json(rung));
  json["advice"] = ladder.advice;
  return json;
}

std::string ladder_table(const Ladder& ladder) {
  const RungAssessment& choice = ladder.choice();
  std::string text =
      fmt::format("\nRung {}, {}: tolerance of {} {}\n\n", *choice.rung->number, choice.rung->title,
                  percent_text(ladder.tolerance), ladder.tolerance_met ? "met" : "not met");
  text += answer_text(choice);
  text += fmt::format("\n  {:<50} {:>10} {:>7} {:>7}\n", "rung", "G_vh", "error", "time");
  for (const RungAssessment& rung : ladder.rungs)
    text += rung_line(rung);
  const estimate::Range& z = ladder.mechanical_coordination_number;
  text += fmt::format(
      "\nStated errors are standard errors relative to the contact network of the packing, the largest "
      "of K, G_hh and G_vh; z* = {} ({} to {})",
      short_text(z.value, 3), short_text(z.low, 3), short_text(z.high, 3));
  if (const std::string& source = choice.error_source; !source.empty())
    text += fmt::format(". Error of rung {}: {}", *choice.rung->number, source);
  text += ".\n";
  for (const std::string& advice : ladder.advice)
    text += "- " + advice + "\n";
  return text;
}

} // namespace granum::cli

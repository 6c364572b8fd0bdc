// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <filesystem>

#include <fmt/format.h>
#include <granum/core/error.hpp>
#include <granum/core/version.hpp>
#include <granum/io/output_file.hpp>

#include "cli/frame/messages.hpp"
#include "sweep.hpp"

namespace granum::cli {

namespace {

using nlohmann::ordered_json;

std::optional<double> exponent(const effective::RungAnswer& answer,
                               double (*of)(const effective::StressExponents&)) {
  return answer.exponents ? std::optional(of(*answer.exponents)) : std::nullopt;
}

/// For G_hv the direction i is h and j is v.
constexpr SweptQuantity quantities[] = {
    {"G_hh", Dimension::pressure,
     [](const effective::RungAnswer& a) { return std::optional(a.stiffness.G_hh()); }},
    {"G_hv", Dimension::pressure,
     [](const effective::RungAnswer& a) { return std::optional(a.stiffness.G_vh()); }},
    {"E_v", Dimension::pressure,
     [](const effective::RungAnswer& a) { return young_modulus(a.stiffness, elastic::Loading::vertical); }},
    {"E_h", Dimension::pressure,
     [](const effective::RungAnswer& a) { return young_modulus(a.stiffness, elastic::Loading::horizontal); }},
    {"K", Dimension::pressure,
     [](const effective::RungAnswer& a) { return std::optional(a.stiffness.bulk_modulus()); }},
    {"m", Dimension::dimensionless,
     [](const effective::RungAnswer& a) {
       return exponent(a, [](const effective::StressExponents& e) { return e.stress_h; });
     }},
    {"n", Dimension::dimensionless,
     [](const effective::RungAnswer& a) {
       return exponent(a, [](const effective::StressExponents& e) { return e.stress_v; });
     }},
    {"s", Dimension::dimensionless,
     [](const effective::RungAnswer& a) {
       return exponent(a, [](const effective::StressExponents& e) { return e.sum(); });
     }},
};

void add_once(std::vector<std::string>& texts, const std::string& text) {
  if (std::find(texts.begin(), texts.end(), text) == texts.end())
    texts.push_back(text);
}

std::string joined(const std::vector<std::string>& texts) {
  return fmt::format("{}", fmt::join(texts, "; "));
}

/// Likely mistakes first: what follows is of these numbers.
std::vector<std::string> remarks_of(const StateResult& result) {
  std::vector<std::string> all = result.slips;
  all.insert(all.end(), result.notes.begin(), result.notes.end());
  return all;
}

} // namespace

std::span<const SweptQuantity> swept_quantities() { return quantities; }

const SweptQuantity& swept_quantity(std::string_view name) {
  const auto found = std::find_if(std::begin(quantities), std::end(quantities),
                                  [name](const SweptQuantity& q) { return name == q.name; });
  if (found == std::end(quantities))
    throw InvalidArgument(fmt::format("{} is no quantity of a sweep", name));
  return *found;
}

StateResult evaluate(const effective::RungInputs& packing, const Rungs& rungs, bool needed) {
  StateResult result;
  std::vector<std::string> errors;
  for (const Rung* rung : rungs) {
    if (!needed && !effective::has_inputs(packing, *rung)) {
      result.answers.emplace_back(std::nullopt);
      continue;
    }
    try {
      result.answers.emplace_back(answer_with_exponents(*rung, packing));
      for (const std::string& note : result.answers.back()->validity.notes)
        add_once(result.notes, note);
    } catch (const Error& error) {
      result.answers.emplace_back(std::nullopt);
      add_once(errors, error.what());
    }
  }
  result.error = joined(errors);
  return result;
}

StateResult failed(const std::string& error, const Rungs& rungs) {
  return {.answers = std::vector<std::optional<effective::RungAnswer>>(rungs.size()),
          .notes = {},
          .slips = {},
          .error = error};
}

std::string heading(const SweptQuantity& quantity, const Rung& rung) {
  const std::string_view unit = si_symbol(quantity.dimension);
  return fmt::format("{}_{}{}{}", quantity.name, rung.column, unit.empty() ? "" : "_", unit);
}

std::vector<std::string> rung_headings(const Rungs& rungs) {
  std::vector<std::string> headings;
  for (const Rung* rung : rungs)
    for (const SweptQuantity& quantity : quantities)
      headings.push_back(heading(quantity, *rung));
  return headings;
}

std::vector<std::string> result_headings(const Rungs& rungs) {
  std::vector<std::string> headings = rung_headings(rungs);
  headings.emplace_back("notes");
  headings.emplace_back("error");
  return headings;
}

void append_rung_cells(std::vector<io::CsvCell>& row, const StateResult& result) {
  for (const std::optional<effective::RungAnswer>& answer : result.answers)
    for (const SweptQuantity& quantity : quantities)
      row.emplace_back(answer ? quantity.of(*answer).value_or(nothing) : nothing);
}

void append_remark_cells(std::vector<io::CsvCell>& row, const StateResult& result) {
  row.emplace_back(joined(remarks_of(result)));
  row.emplace_back(result.error);
}

void append_cells(std::vector<io::CsvCell>& row, const StateResult& result) {
  append_rung_cells(row, result);
  append_remark_cells(row, result);
}

void add_result(ordered_json& json, const StateResult& result, const Rungs& rungs) {
  for (std::size_t k = 0; k < rungs.size(); ++k) {
    ordered_json& of_rung = json[rungs[k]->column];
    for (const SweptQuantity& quantity : quantities) {
      const auto value = result.answers[k] ? quantity.of(*result.answers[k]) : std::nullopt;
      of_rung[quantity.name] = value ? ordered_json(*value) : ordered_json();
    }
  }
  json["notes"] = remarks_of(result);
  json["error"] = result.error.empty() ? ordered_json() : ordered_json(result.error);
}

void Tally::count(const StateResult& result, const std::string& where) {
  ++states_;
  if (!result.error.empty() && ++failed_ == 1)
    first_failure_ = where + ": " + result.error;
  if (!result.notes.empty() && ++noted_ == 1)
    first_note_ = where + ": " + joined(result.notes);
  for (const std::string& slip : result.slips) {
    Slips& of_input = slips_[slip.substr(0, slip.find(' '))];
    if (++of_input.states == 1)
      of_input.first = where + ": " + slip;
  }
}

Validity Tally::validity() const {
  Validity validity;
  if (noted_ > 0)
    validity.add(fmt::format("{} of {} states lie outside a formula's validity, see notes; {}", noted_,
                             states_, first_note_));
  for (const auto& [input, slips] : slips_)
    validity.add(fmt::format("{} of {} states have a likely mistake, see notes; {}", slips.states, states_,
                             slips.first));
  return validity;
}

ExitCode Tally::conclude(ExitCode code) const {
  if (failed_ > 0)
    say("error", fmt::format("{} of {} states failed, see error; {}", failed_, states_, first_failure_));
  return code == ExitCode::ok && failed_ > 0 ? ExitCode::fell_short : code;
}

Notes csv_notes(const ordered_json& inputs, const Rungs& rungs, const std::vector<std::string>& remarks) {
  Notes notes = {{"program", fmt::format("granum {} sweep", version())},
                 {"inputs", json_text(inputs, -1)},
                 {"signs", "compression positive; z is the vertical axis v; q = sigma_v - sigma_h"}};
  if (!rungs.empty())
    notes.emplace_back("exponents", "local, of G_hv: m of sigma_h, n of sigma_v, s = m + n");
  for (const Rung* rung : rungs)
    notes.emplace_back(rung->column, rung->description);
  for (const std::string& remark : remarks)
    notes.emplace_back("note", remark);
  return notes;
}

ordered_json sweep_json_head(const ordered_json& inputs, const Rungs& rungs) {
  ordered_json json = json_head("sweep");
  json["inputs"] = inputs;
  for (const Rung* rung : rungs)
    json["rungs"][rung->column] = rung->description;
  return json;
}

void require_svg(const std::string& picture) {
  if (std::filesystem::path(picture).extension() != ".svg")
    throw InvalidArgument("--picture = '" + picture + "' must end in .svg");
}

void require_free(const OutputOptions& output, const std::vector<std::string>& files) {
  for (const std::string& file : files)
    if (!output.force && !file.empty() && io::is_taken(file))
      throw FileError(file, 0, "exists already and is kept; --force replaces it");
}

} // namespace granum::cli

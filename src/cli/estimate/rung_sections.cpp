// SPDX-License-Identifier: GPL-3.0-or-later
#include "rung_sections.hpp"

#include <functional>
#include <tuple>

#include <fmt/format.h>
#include <granum/core/text.hpp>
#include <granum/effective/rungs.hpp>

namespace granum::cli {

namespace {

using effective::ModulusErrors;
using effective::StressExponents;
using Stiffness = elastic::TransverselyIsotropic;

std::string modulus_text(double value) { return pretty(value, Dimension::pressure); }

// ---- closed forms side by side

struct ClosedForm {
  const char* key;
  effective::RungAnswer answer;

  [[nodiscard]] const ModulusErrors* errors() const {
    return answer.relative_error && !declines(answer) ? &*answer.relative_error : nullptr;
  }
};

std::vector<ClosedForm> closed_forms(const effective::State& state, Validity& validity) {
  using effective::RungName;
  std::vector<ClosedForm> all;
  for (const auto& [key, title, name] :
       {std::tuple{"uniform_strain", "uniform strain", RungName::directional},
        {"uniform_stress", "uniform stress", RungName::uniform_stress},
        {"relaxed", "relaxed", RungName::relaxed}}) {
    all.push_back({key, effective::answer_with_exponents(effective::rung(name), state)});
    const effective::RungAnswer& answer = all.back().answer;
    validity.merge(answer.validity);
    const bool own_note = name != RungName::relaxed; // stable where uniform strain is
    if (own_note && !elastic::young_modulus(answer.stiffness, elastic::Loading::vertical))
      validity.add(
          fmt::format("Young's moduli under {} do not exist: the stiffness is not positive definite", title));
  }
  validity.keep_each_once();
  return all;
}

using GetModulus = std::function<std::optional<double>(const Stiffness&)>;

/// A modulus, and on a screen its stated error, if there is one.
void add_modulus(io::Columns<ClosedForm>& to, const char* key, const char* label, const GetModulus& get,
                 double ModulusErrors::*error = nullptr) {
  to.emplace_back("", key, io::or_null([get](const ClosedForm& of) { return get(of.answer.stiffness); }));
  to.emplace_back(
      "", "",
      [get, error](const ClosedForm& of) {
        if (declines(of.answer))
          return std::string("declines");
        const std::optional<double> value = get(of.answer.stiffness);
        const ModulusErrors* errors = error != nullptr ? of.errors() : nullptr;
        return (value ? modulus_text(*value) : "undefined") +
               (errors != nullptr ? fmt::format(" +- {} %", short_text(100 * errors->*error, 2)) : "");
      },
      shown_as(label));
}

io::Columns<ClosedForm> closed_form_columns() {
  using elastic::Loading;
  io::Columns<ClosedForm> columns = {{"", "", &ClosedForm::key}};
  add_modulus(columns, "K", "K", &Stiffness::bulk_modulus, &ModulusErrors::bulk_modulus);
  add_modulus(columns, "G_vh", "G_vh = C44", &Stiffness::G_vh, &ModulusErrors::G_vh);
  add_modulus(columns, "G_hh", "G_hh = C66", &Stiffness::G_hh, &ModulusErrors::G_hh);
  add_modulus(columns, "E_v", "E_v", [](const Stiffness& c) { return young_modulus(c, Loading::vertical); });
  add_modulus(columns, "E_h", "E_h",
              [](const Stiffness& c) { return young_modulus(c, Loading::horizontal); });
  add_modulus(columns, "C11", "C11", &Stiffness::C11);
  add_modulus(columns, "C33", "C33", &Stiffness::C33);
  add_modulus(columns, "C12", "C12", &Stiffness::C12);
  add_modulus(columns, "C13", "C13", &Stiffness::C13);
  for (const auto& [key, get] :
       {std::pair<const char*, GetModulus>{"C44", &Stiffness::C44}, {"C66", &Stiffness::C66}})
    columns.emplace_back("", key, [get = get](const ClosedForm& of) { return get(of.answer.stiffness); });
  using Exponent = std::function<double(const StressExponents&)>;
  for (const auto& [key, label, get] :
       {std::tuple<const char*, const char*, Exponent>{"m", "m, sigma_h", &StressExponents::stress_h},
        {"n", "n, sigma_v", &StressExponents::stress_v},
        {"s", "s = m + n", &StressExponents::sum}})
    columns.emplace_back(
        "", key, io::or_null([get = get](const ClosedForm& of) {
          return of.answer.exponents ? std::optional(get(*of.answer.exponents)) : std::nullopt;
        }),
        io::ShownColumn{.heading = label, .digits = 4, .fixed = true, .absent = "undefined"});
  columns.emplace_back("", "declines", [](const ClosedForm& of) {
    return declines(of.answer) ? std::optional(true) : std::nullopt;
  });
  columns.emplace_back("", "relative_error", [](const ClosedForm& of) {
    return declines(of.answer) ? io::Value(nullptr) : io::Value();
  });
  io::add_part(
      columns,
      io::Columns<ModulusErrors>{{"", "K", &ModulusErrors::bulk_modulus},
                                 {"", "G_vh", &ModulusErrors::G_vh},
                                 {"", "G_hh", &ModulusErrors::G_hh}},
      [](const ClosedForm& of) { return of.errors(); }, "relative_error/");
  return columns;
}

std::vector<std::string> closed_form_remarks(const AnswerCase& c) {
  const effective::State& state = c.answer.state();
  std::vector<std::string> all;
  if (state.stress_v == 0 && state.stress_h == 0)
    all.emplace_back("m, n and s at zero stress are their limits along the isotropic path");
  if (*state.coordination_number == 0)
    all.emplace_back("m, n and s do not exist: without contacts every modulus is 0 at any stress");
  if (!c.question.state.coordination_number && c.question.grain_shape == estimate::GrainShape::sphere) {
    const estimate::Range& C_n = c.answer[estimate::Field::coordination_number];
    all.push_back(fmt::format(
        "bounds and rungs use the estimated C_n = {} (range {} to {}); --coordination-number replaces it",
        short_text(C_n.value, 3), short_text(C_n.low, 3), short_text(C_n.high, 3)));
  }
  return all;
}

} // namespace

Validity add_closed_forms(Document& to, const AnswerCase& c, Seen seen) {
  const effective::State& state = c.answer.state();
  Validity validity;
  const std::vector<ClosedForm> forms = closed_forms(state, validity);
  Table table = table_of(
      "",
      fmt::format("closed forms at C_n = {}, z* = {}; m, n and s: exponents of stress in G_vh",
                  short_text(*state.coordination_number), short_text(*state.mechanical_coordination_number)),
      closed_form_columns(), forms, Table::Form::columns);
  table.remark = fmt::format(
      "{} G of a real packing, in which grains deviate from the mean strain. Relaxed includes factors for "
      "this, calibrated on contact networks; its exponents are for a constant number of contacts.",
      state.tangential_ratio > 0 ? "Uniform strain and stress overestimate" : "Uniform strain overestimates");
  to.add(seen, std::move(table));
  to.add_notes(closed_form_remarks(c), seen == Seen::data ? Seen::data : Seen::full);
  to.add_notes(validity.notes, Seen::data); // warnings
  return validity;
}

// ---- ladder

namespace {

using estimate::Ladder;
using estimate::RungAssessment;

/// "203.8 MPa +- 21 %".
std::string with_error(const RungAssessment& rung, double modulus, double ModulusErrors::*error) {
  return modulus_text(modulus) +
         (rung.relative_error ? " +- " + percent_text((*rung.relative_error).*error) : "");
}

Items ladder_choice(const Ladder& ladder) {
  const RungAssessment& choice = ladder.choice();
  const estimate::Range& z = ladder.mechanical_coordination_number;
  Items to{.key = "ladder",
           .title = fmt::format("Rung {}, {}: tolerance of {} {}", *choice.rung->number, choice.rung->title,
                                percent_text(ladder.tolerance), ladder.tolerance_met ? "met" : "not met")};
  io::add_item(to.items, "tolerance", ladder.tolerance);
  io::add_item(to.items, "tolerance_met", ladder.tolerance_met);
  io::add_item(to.items, "rung", *choice.rung->number);
  const Stiffness& c = *choice.stiffness;
  io::add_item(to.items, "", with_error(choice, c.G_vh(), &ModulusErrors::G_vh), shown_as("G_vh"));
  io::add_item(to.items, "", with_error(choice, c.G_hh(), &ModulusErrors::G_hh), shown_as("G_hh"));
  io::add_item(to.items, "", with_error(choice, c.bulk_modulus(), &ModulusErrors::bulk_modulus),
               shown_as("K"));
  io::add_item(to.items, "", range_text(Dimension::dimensionless, z), shown_as("z*"));
  add_range(to.items, "mechanical_coordination_number", z);
  io::add_item(to.items, "advice", ladder.advice);
  return to;
}

io::Columns<RungAssessment> ladder_columns() {
  using Of = const RungAssessment&;
  io::Columns<RungAssessment> columns = {
      {"", "rung", [](Of rung) { return *rung.rung->number; }, shown_as("", {}, -3)},
      {"", "title", [](Of rung) { return rung.rung->title; }, shown_as("rung", {}, -48)},
      {"", "", [](Of rung) { return rung.stiffness ? std::optional(rung.stiffness->G_vh()) : std::nullopt; },
       io::ShownColumn{.heading = "G_vh", .width = 11, .absent = "-", .dimension = Dimension::pressure}},
      {"", "", [](Of rung) { return rung.largest_error() ? percent_text(*rung.largest_error()) : "-"; },
       shown_as("error", {}, 8)},
      {"", "typical_time", [](Of rung) { return rung.rung->typical_time; },
       shown_as("time", Dimension::time, 8)},
      {"", "error_source", &RungAssessment::error_source},
      {"", "missing", &RungAssessment::missing},
      {"", "verdict", [](Of rung) { return estimate::name(rung.verdict); }},
      {"", "reason", &RungAssessment::reason},
      {"", "moduli", [](Of rung) { return rung.stiffness ? io::Value() : io::Value(nullptr); }},
      {"", "relative_error", [](Of rung) { return rung.relative_error ? io::Value() : io::Value(nullptr); }}};
  io::add_part(
      columns,
      io::Columns<Stiffness>{{"", "C11", &Stiffness::C11},
                             {"", "C33", &Stiffness::C33},
                             {"", "C12", &Stiffness::C12},
                             {"", "C13", &Stiffness::C13},
                             {"", "C44", &Stiffness::C44},
                             {"", "K", &Stiffness::bulk_modulus},
                             {"", "G_hh", &Stiffness::G_hh},
                             {"", "G_vh", &Stiffness::G_vh}},
      [](Of rung) { return rung.stiffness ? &*rung.stiffness : nullptr; }, "moduli/");
  io::add_part(
      columns,
      io::Columns<ModulusErrors>{{"", "K", &ModulusErrors::bulk_modulus},
                                 {"", "G_hh", &ModulusErrors::G_hh},
                                 {"", "G_vh", &ModulusErrors::G_vh}},
      [](Of rung) { return rung.relative_error ? &*rung.relative_error : nullptr; }, "relative_error/");
  return columns;
}

Prose ladder_reasons(const Ladder& ladder) {
  Prose prose;
  for (const RungAssessment& rung : ladder.rungs)
    prose.lines.push_back(fmt::format("rung {}{}: {}", *rung.rung->number,
                                      rung.verdict == estimate::RungVerdict::chosen ? ", chosen" : "",
                                      rung.reason));
  const std::string& source = ladder.choice().error_source;
  prose.lines.push_back(
      "Errors are standard errors relative to the contact network of the packing, the "
      "largest of K, G_hh and G_vh." +
      (source.empty() ? "" : fmt::format(" Error of rung {}: {}.", *ladder.choice().rung->number, source)));
  for (const std::string& advice : ladder.advice)
    prose.lines.push_back("- " + advice);
  return prose;
}

} // namespace

void add_ladder(Document& to, const Ladder& ladder) {
  to.add(Seen::always, ladder_choice(ladder));
  to.add(Seen::always, table_of("ladder/rungs", "", ladder_columns(), ladder.rungs));
  to.add(Seen::always, ladder_reasons(ladder));
  to.warnings.merge(ladder.validity);
}

} // namespace granum::cli

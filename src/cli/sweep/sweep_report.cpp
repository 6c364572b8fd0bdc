// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cmath>

#include <fmt/format.h>
#include <granum/core/error.hpp>
#include <granum/core/text.hpp>

#include "cli/frame/help.hpp"
#include "cli/frame/json_members.hpp"
#include "cli/frame/messages.hpp"
#include "cli/options/likely_mistakes.hpp"
#include "sweep.hpp"

namespace granum::cli {

namespace {

using effective::Rung;
using effective::RungAnswer;
using effective::StressExponents;
using estimate::Answer;
using estimate::Field;
using nlohmann::ordered_json;

std::optional<double> exponent(const RungAnswer& answer, double (*of)(const StressExponents&)) {
  return answer.exponents ? std::optional(of(*answer.exponents)) : std::nullopt;
}

/// For G_hv the direction i is h and j is v.
constexpr const char* shape_heading = "grain_shape";

constexpr SweptQuantity quantities[] = {
    {"G_hh", Dimension::pressure, Field::horizontal_shear_modulus,
     [](const RungAnswer& a) { return std::optional(a.stiffness.G_hh()); }},
    {"G_hv", Dimension::pressure, Field::shear_modulus,
     [](const RungAnswer& a) { return std::optional(a.stiffness.G_vh()); }},
    {"E_v", Dimension::pressure, Field::young_modulus,
     [](const RungAnswer& a) { return young_modulus(a.stiffness, elastic::Loading::vertical); }},
    {"E_h", Dimension::pressure, Field::horizontal_young_modulus,
     [](const RungAnswer& a) { return young_modulus(a.stiffness, elastic::Loading::horizontal); }},
    {"K", Dimension::pressure, Field::bulk_modulus,
     [](const RungAnswer& a) { return std::optional(a.stiffness.bulk_modulus()); }},
    {"m", Dimension::dimensionless, Field::horizontal_exponent,
     [](const RungAnswer& a) { return exponent(a, [](const StressExponents& e) { return e.stress_h; }); }},
    {"n", Dimension::dimensionless, Field::vertical_exponent,
     [](const RungAnswer& a) { return exponent(a, [](const StressExponents& e) { return e.stress_v; }); }},
    {"s", Dimension::dimensionless, Field::stress_exponent,
     [](const RungAnswer& a) { return exponent(a, [](const StressExponents& e) { return e.sum(); }); }},
};

/// Whether a heading is that of a stress, which practice has in kPa.
bool is_stress(std::string_view heading) {
  constexpr std::string_view stresses[] = {"p_", "q_", "sigma_", "total_sigma_", "pore_pressure_"};
  return std::ranges::any_of(stresses,
                             [heading](std::string_view stress) { return heading.starts_with(stress); });
}

void add_once(std::vector<std::string>& texts, const std::string& text) {
  if (std::find(texts.begin(), texts.end(), text) == texts.end())
    texts.push_back(text);
}

/// Likely mistakes first, because the other notes follow from these numbers.
std::vector<std::string> remarks_of(const SweptState& state) {
  std::vector<std::string> all = state.slips;
  all.insert(all.end(), state.notes.begin(), state.notes.end());
  return all;
}

/// Heading of the column of a quantity: G_hv_rung2_Pa.
std::string heading(const SweptQuantity& quantity, const Rung& rung) {
  const std::string_view unit = si_symbol(quantity.dimension);
  return fmt::format("{}_{}{}{}", quantity.name, rung.column, unit.empty() ? "" : "_", unit);
}

void add_rungs(SweptState& state, const Rungs& rungs) {
  std::vector<std::string> errors;
  for (const Rung* rung : rungs) {
    try {
      state.rungs.emplace_back(answer_with_exponents(*rung, state.answer->answer.state()));
      if (state.answer->question.grain_shape == estimate::GrainShape::sphere) // a sand has measured laws
        for (const std::string& note : state.rungs.back()->validity.notes)
          add_once(state.notes, note);
    } catch (const Error& error) {
      state.rungs.emplace_back(std::nullopt);
      add_once(errors, error.what());
    }
  }
  state.error = joined(errors, "; ");
}

/// The answer, or both, and published laws; null for a state that failed.
void put_answer(ordered_json& place, const SweptState& state, bool laws) {
  if (!state.answer) {
    for (const char* key : {"answer", "sand_answer", "measured_sands"})
      if (laws || key != std::string_view("measured_sands"))
        place[key] = nullptr;
    return;
  }
  Document at;
  add_answers(at, *state.answer);
  if (laws)
    at.add(Seen::data, measured_laws_table(*state.answer));
  place.update(members_of(at.sections));
}

std::string shape_of(const SweptState& state) {
  return state.answer ? std::string(name(state.answer->question.grain_shape)) : "";
}

void add_rung_columns(io::Columns<SweptState>& to, const Rungs& rungs) {
  for (std::size_t k = 0; k < rungs.size(); ++k)
    for (const SweptQuantity& quantity : quantities)
      to.emplace_back(heading(quantity, *rungs[k]), std::string(rungs[k]->column) + "/" + quantity.name,
                      io::or_null([k, of = quantity.of](const SweptState& state) {
                        return state.rungs[k] ? of(*state.rungs[k]) : std::nullopt;
                      }));
}

void add_law_columns(io::Columns<SweptState>& to) {
  for (std::size_t k = 0; k < sands::measured_laws().size(); ++k)
    to.emplace_back(fmt::format("G_{}_Pa", sands::measured_laws()[k].key), "", [k](const SweptState& state) {
      const auto* laws = state.answer ? &state.answer->sands : nullptr;
      const bool any = laws != nullptr && k < laws->size() && (*laws)[k].modulus;
      return any ? std::optional((*laws)[k].modulus->shear_modulus) : std::nullopt;
    });
}

/// What follows the first cells of a row; in JSON besides the answer.
io::Columns<SweptState> result_columns(const SweepOptions& o, const Rungs& rungs, const AskedOfRows& asked,
                                       bool with_shape) {
  using Of = const SweptState&;
  io::Columns<SweptState> columns;
  io::add_part(columns, answer_columns(o.all_columns, asked.strained), answer_in);
  add_rung_columns(columns, rungs);
  columns.emplace_back("notes", "", [](Of state) { return joined(remarks_of(state), "; "); });
  columns.emplace_back("", "notes", remarks_of);
  columns.emplace_back("error", "", &SweptState::error);
  columns.emplace_back("", "error", [](Of state) {
    return state.error.empty() ? io::Value(nullptr) : io::Value(state.error);
  });
  if (with_shape)
    columns.emplace_back(shape_heading, "", shape_of);
  if (asked.both)
    io::add_part(columns, answer_columns(o.all_columns, asked.strained, "sand_"), sand_in);
  if (o.law_columns)
    add_law_columns(columns);
  return columns;
}

} // namespace

PracticeHeading practice_heading(const std::string& heading) {
  constexpr std::string_view pascal = "_Pa";
  if (!heading.ends_with(pascal))
    return {heading};
  const std::string name = heading.substr(0, heading.size() - pascal.size());
  return is_stress(heading) ? PracticeHeading{name + "_kPa", 1e-3} : PracticeHeading{name + "_MPa", 1e-6};
}

double practice_number(double number) {
  constexpr int digits = 5;
  return std::isfinite(number) ? *parse_number(short_text(number, digits)) : number;
}

std::span<const SweptQuantity> swept_quantities() { return quantities; }

const SweptQuantity& swept_quantity(std::string_view name) {
  const auto found = std::find_if(std::begin(quantities), std::end(quantities),
                                  [name](const SweptQuantity& q) { return name == q.name; });
  if (found == std::end(quantities))
    throw InvalidArgument(fmt::format("{} is not a quantity of a sweep", name));
  return *found;
}

const Answer* answer_in(const SweptState& state) { return state.answer ? &state.answer->answer : nullptr; }
const Answer* beads_in(const SweptState& state) {
  return state.answer ? state.answer->of_kind(estimate::GrainShape::sphere) : nullptr;
}
const Answer* sand_in(const SweptState& state) { return state.answer ? state.answer->of_sand() : nullptr; }

SweptState swept(const InputValues& values, const Rungs& rungs) {
  try {
    SweptState state{.answer = bare_answer(values)};
    add_measured_laws(*state.answer);
    state.notes = state.answer->answer.validity().notes;
    if (!state.answer->beads_refused.empty())
      state.notes.insert(state.notes.begin(), state.answer->beads_refused);
    Validity slips = likely_mistakes(values, state.answer->question.state);
    state.slips = slips.notes;
    add_rungs(state, rungs);
    return state;
  } catch (const Error& error) {
    return failed(error.what(), rungs);
  }
}

SweptState failed(const std::string& error, const Rungs& rungs) {
  return {.answer = std::nullopt,
          .rungs = std::vector<std::optional<RungAnswer>>(rungs.size()),
          .notes = {},
          .slips = {},
          .error = error};
}

void Tally::count(const SweptState& state, const std::string& where) {
  ++states_;
  if (!state.error.empty() && ++failed_ == 1)
    first_failure_ = where + ": " + state.error;
  if (!state.notes.empty() && ++noted_ == 1)
    first_note_ = where + ": " + joined(state.notes, "; ");
  for (const std::string& slip : state.slips) {
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

AskedOfRows asked_of(const InputValues& values) {
  return {.both = !known_shape(values), .strained = values.given(Input::shear_strain)};
}

SweptRows::SweptRows(const SweepOptions& options, Rungs rungs, std::vector<std::string> headings,
                     const AskedOfRows& asked, io::CsvManner manner)
    : options_(options), rungs_(std::move(rungs)),
      manner_(manner), rows_{.key = "states", .headings = std::move(headings)} {
  if (const auto found = std::find(rows_.headings.begin(), rows_.headings.end(), shape_heading);
      found != rows_.headings.end())
    shape_cell_ = static_cast<std::size_t>(found - rows_.headings.begin());
  columns_ = in_units(result_columns(options, rungs_, asked, !shape_cell_), options);
}

std::vector<std::string> SweptRows::result_headings() const { return io::headings_of(columns_); }

void SweptRows::add(std::vector<io::CsvCell> cells, ordered_json place, const SweptState& state) {
  if (options_.output.json) {
    put_answer(place, state, options_.law_columns);
    put_members(place, columns_, state);
    rows_.elements.push_back(std::move(place));
    return;
  }
  if (shape_cell_ && state.answer)
    cells[*shape_cell_] = shape_of(state);
  io::add_cells(cells, columns_, state);
  rows_.lines += io::csv_line(cells, manner_);
}

Document SweptRows::document(const estimate::Notes& remarks) && {
  Document to{.command = "sweep", .manner = manner_};
  to.signs += "; q = sigma_v - sigma_h; sigma_v, sigma_h and p are effective stresses";
  to.comments = {{"exponents",
                  "m of sigma_h and n of sigma_v in G_hv, s = m + n; in the answer the number of contacts "
                  "grows with stress, in rungs it is constant and the exponents are local"}};
  Items descriptions{.key = "rungs"};
  for (const Rung* rung : rungs_) {
    to.comments.emplace_back(rung->column, rung->description);
    io::add_item(descriptions.items, rung->column, rung->description);
  }
  if (!rungs_.empty())
    to.add(Seen::data, std::move(descriptions));
  for (const std::string& heading : result_headings())
    rows_.headings.push_back(heading);
  to.add(Seen::data, std::move(rows_));
  to.add_notes(remarks);
  return to;
}

Outlets outlets_of(const SweepOptions& o) {
  return {.output = o.output,
          .picture = o.picture,
          .report = o.report,
          .always_csv = true,
          .csv_on_screen = true};
}

ExitCode deliver_sweep(const Outlets& to, const Document& document) {
  const ExitCode code = deliver(to, document);
  if (!to.output.out.empty()) // else the screen would be empty
    print(fmt::format("written: {}{}{}\n", to.output.out, to.picture.empty() ? "" : ", " + to.picture,
                      to.report.empty() ? "" : ", " + to.report));
  return code;
}

estimate::Notes remarks_on(const SweepOptions& o, estimate::Notes assumptions) {
  const bool counted = o.inputs.given(Input::coordination_number) ||
                       o.inputs.given(Input::rattler_fraction) ||
                       o.inputs.given(Input::mechanical_coordination_number);
  if (known_shape(o.inputs) == estimate::GrainShape::sand) {
    add_sentence(assumptions, "void ratio and sand are the same at every state");
    return assumptions;
  }
  add_sentence(
      assumptions,
      counted
          ? "void ratio and contacts are the same at every state"
          : "void ratio and preparation are the same at every state; the number of contacts grows with p'");
  return assumptions;
}

Band band_of(Field field, const std::vector<double>& at, const std::vector<const SweptState*>& states,
             AnswerOf answer_of) {
  Band band;
  for (std::size_t k = 0; k < states.size(); ++k)
    if (const Answer* answer = answer_of(*states[k]); answer != nullptr && answer->find(field))
      band.add(at[k], (*answer)[field]);
  return band;
}

void add_law_band(plot::Chart& chart, const SweepOptions& o, const std::vector<double>& at,
                  const std::vector<const SweptState*>& states, bool sideways) {
  if (!o.law_columns)
    return;
  std::vector<bool> tested(
      sands::measured_laws().size()); // at any of the states, so that the band has no steps
  for (const SweptState* state : states) {
    const std::vector<bool> here = state->answer ? laws_tested(*state->answer) : std::vector<bool>{};
    for (std::size_t k = 0; k < here.size(); ++k)
      tested[k] = tested[k] || here[k];
  }
  Band band;
  for (std::size_t k = 0; k < states.size(); ++k)
    if (const auto range = states[k]->answer ? range_of_laws(*states[k]->answer, tested) : std::nullopt)
      band.add(at[k], *range);
  add_band(chart, band, sideways, "published laws", plot::Colour::power_law);
}

} // namespace granum::cli

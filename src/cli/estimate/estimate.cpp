// SPDX-License-Identifier: GPL-3.0-or-later
// granum estimate: the answer to one state as a document.
#include <algorithm>
#include <cmath>
#include <memory>

#include <fmt/format.h>
#include <granum/core/error.hpp>
#include <granum/core/text.hpp>
#include <granum/elastic/isotropic.hpp>
#include <granum/elastic/waves.hpp>
#include <granum/estimate/ladder.hpp>
#include <granum/rock_physics/cement.hpp>
#include <granum/sands/strain.hpp>

#include "answer_sections.hpp"
#include "cli/options/densest_packing.hpp"
#include "cli/options/likely_mistakes.hpp"
#include "cli/options/packing_json.hpp"
#include "rung_sections.hpp"

namespace granum::cli {

namespace {

using effective::State;
using estimate::Field;
using estimate::GrainShape;
using nlohmann::ordered_json;

struct Options {
  InputValues inputs;
  std::vector<std::string> uncertain; ///< key=sd
  Outlets outlets;
  Number tolerance, cement;
  bool bounds = false; ///< show the uniform fields and rung 3 side by side
  std::string densest; ///< "made": of the densest packing of the same grains, for z*
};

std::string pressure_text(double value) { return pretty(value, Dimension::pressure); }

// ---- inputs

/// "cone, A_1 = 0.4": the shape and its parameters.
std::string contact_text(const ordered_json& packing) {
  std::string text = packing.at("contact").get<std::string>();
  for (const contact::LawParameter& parameter : contact::row_of(*contact::find_shape(text)).parameters)
    text += fmt::format(", {} = {}{}", parameter.symbol,
                        pretty(packing.at(parameter.name).get<double>(), parameter.dimension),
                        parameter.unit.empty() ? "" : " " + parameter.unit);
  return text;
}

/// "e = 0.802, D_r = 50 %, C_u = 1.39, d50 = 200 um": the known properties of a sand.
std::string sand_text(const sands::Sand& sand, double void_ratio) {
  std::string text = "e = " + short_text(void_ratio);
  if (sand.least_void_ratio && sand.largest_void_ratio)
    text += fmt::format(" (e_min {}, e_max {})", short_text(*sand.least_void_ratio),
                        short_text(*sand.largest_void_ratio));
  else if (sand.relative_density)
    text += ", D_r = " + percent_text(*sand.relative_density);
  if (sand.uniformity)
    text += ", C_u = " + short_text(*sand.uniformity, 3);
  if (sand.d50)
    text += ", d50 = " + pretty(*sand.d50, Dimension::length);
  return text;
}

/// A line each for contact, grains, sizes, packing or sand, and stress.
Items input_lines(const AnswerCase& c, const ordered_json& packing) {
  const State& s = c.question.state;
  const contact::GrainMaterial grain = s.law.grain();
  const std::string moduli =
      fmt::format("G_g = {}, nu_g = {}", pressure_text(grain.shear_modulus), short_text(grain.poisson_ratio));
  Items to;
  const auto add = [&to](const char* label, const std::string& text) {
    io::add_item(to.items, "", text, shown_as(label));
  };
  if (c.question.grain_shape == GrainShape::sand) {
    add("sand", sand_text(c.question.sand, s.void_ratio));
    add("grains", moduli);
    if (c.question.shear_strain)
      add("strain", percent_text(*c.question.shear_strain));
  } else {
    add("contact", contact_text(packing) + "; k_t/k_n = " + short_text(s.tangential_ratio) +
                       (s.rolling > 0 ? ", k_r = " + short_text(s.rolling) : ""));
    add("grains", fmt::format("R = {}, {}", pretty(s.radius, Dimension::length), moduli));
    if (packing.contains("sizes")) {
      const ordered_json& gradation = packing.at("gradation");
      add("sizes", fmt::format("{}: R is the mean by number; d50 = {}, C_u = {}",
                               packing.at("sizes").get<std::string>(),
                               pretty(gradation.at("d50").get<double>(), Dimension::length),
                               short_text(gradation.at("uniformity").get<double>())));
      add("contacts", means_text(s.contacts));
    }
    const double densest = c.question.preparation.densest_void_ratio;
    add("packing",
        fmt::format("e = {}, fabric a = {}", short_text(s.void_ratio), short_text(s.fabric_anisotropy)) +
            (densest > 0 ? fmt::format("; e = {} packed without friction", short_text(densest)) : ""));
  }
  add("stress", fmt::format("sigma_v = {}, sigma_h = {}; mean p' = {}", pressure_text(s.stress_v),
                            pressure_text(s.stress_h), pressure_text(s.mean_stress())));
  return to;
}

void add_inputs(Document& to, const AnswerCase& c, const InputValues& values) {
  const State& s = c.answer.state();
  const bool sand = c.question.grain_shape == GrainShape::sand;
  to.add(Seen::full, input_lines(c, packing_json(sand ? as_sand(values) : values, s)));
  add_packing(to, sand ? as_sand(values) : values, s, c.sand_answer.has_value());
  for (const char* key : {"inputs", "sand_inputs"}) {
    Items stress{.key = key};
    io::add_item(stress.items, "stress_v", s.stress_v);
    io::add_item(stress.items, "stress_h", s.stress_h);
    if (key == std::string_view("inputs") || c.sand_answer)
      to.add(Seen::data, std::move(stress));
  }
  Items state;
  const auto add = [&state](const char* heading, const io::Value& value) {
    state.items.emplace_back(heading, "", [value](const io::Only&) { return value; });
  };
  add("e", s.void_ratio);
  add("sigma_v_Pa", s.stress_v);
  add("sigma_h_Pa", s.stress_h);
  add("grain_shape", std::string(name(c.question.grain_shape)));
  to.add(Seen::data, std::move(state));
}

// ---- cement of the mineral of the grains, dry

/// A model of cemented grains, by the place of the cement.
struct CementModel {
  const char* key;
  const char* place;
  rock_physics::IsotropicEstimate moduli;
  elastic::WaveSpeeds speeds = {}; ///< 0 without stiffness
};

/// In the pores away from contacts (soft sand, friable), as a layer on the grain surfaces, and at the
/// contacts. The coordination number is that of the answer for spheres.
std::vector<CementModel> cement_models(const AnswerCase& c, double before, double after) {
  const State& state = c.answer.state();
  const auto [G, nu] = state.law.grain();
  const double C_n = *state.coordination_number;
  const rock_physics::CementedPacking cemented{.shear_modulus = G,
                                               .poisson_ratio = nu,
                                               .cement_shear_modulus = G,
                                               .cement_poisson_ratio = nu,
                                               .porosity = before,
                                               .coordination_number = C_n,
                                               .cement_saturation =
                                                   rock_physics::cement_saturation(before, after)};
  const rock_physics::SpherePacking loose{.shear_modulus = G,
                                          .poisson_ratio = nu,
                                          .porosity = before,
                                          .coordination_number = C_n,
                                          .pressure = state.mean_stress()};
  using rock_physics::CementScheme;
  std::vector<CementModel> models = {
      {"friable", "in the pores, none at contacts", rock_physics::soft_sand(loose, after)},
      {"surface_layer", "a layer on all grains",
       rock_physics::contact_cement(cemented, CementScheme::surface_layer)},
      {"at_contacts", "all at the contacts",
       rock_physics::contact_cement(cemented, CementScheme::at_contacts)}};
  const double density =
      elastic::bulk_density({.grain_density = *c.question.grain_density, .void_ratio = after / (1 - after)});
  for (CementModel& model : models)
    if (const double bulk = model.moduli.bulk_modulus, shear = model.moduli.shear_modulus;
        bulk > 0 && shear > 0)
      model.speeds = elastic::wave_speeds(elastic::Isotropic::from_bulk_and_shear(bulk, shear), density);
  return models;
}

/// \param    share   of the whole volume that is cement, > 0 and less than the porosity [1]
void add_cement(Document& to, const AnswerCase& c, double share) {
  const double e = c.answer.state().void_ratio, before = e / (1 + e), after = before - share;
  require_open("--cement", share, 0, before);
  if (c.question.saturation > 0)
    throw InvalidArgument("--cement applies to dry pores: leave out --saturation");
  const std::vector<CementModel> models = cement_models(c, before, after);
  for (const CementModel& model : models)
    for (const std::string& note : model.moduli.validity.notes)
      to.warnings.add(std::string("cement, ") + model.place + ": " + note);
  Items head{.key = "cemented", .title = "cemented with the mineral of the grains, dry"};
  io::add_item(head.items, "share", share, shown_as_percent("cement in total volume"));
  io::add_item(head.items, "porosity", after, shown_as_percent("porosity"));
  io::add_item(head.items, "coordination_number", *c.answer.state().coordination_number,
               io::ShownColumn{.heading = "C_n of spheres", .digits = 3});
  to.add(Seen::always, std::move(head));
  using Of = const CementModel&;
  const io::Columns<CementModel> columns = {
      {"", "", &CementModel::key},
      {"", "", &CementModel::place, shown_as("place of the cement", {}, -31)},
      {"", "shear_modulus", [](Of model) { return model.moduli.shear_modulus; },
       shown_as("G", Dimension::pressure, 11)},
      {"", "bulk_modulus", [](Of model) { return model.moduli.bulk_modulus; },
       shown_as("K", Dimension::pressure, 11)},
      {"", "shear_wave_speed", [](Of model) { return model.speeds.s; },
       shown_as("V_s", Dimension::speed, 10)},
      {"", "compression_wave_speed", [](Of model) { return model.speeds.p; },
       shown_as("V_p", Dimension::speed, 10)}};
  Table table = table_of("cemented", "", columns, models, Table::Form::named);
  table.remark =
      "These models assume uniform strain: they are too stiff where grains have few contacts; their "
      "error is not known [DvorkinNur1996].";
  to.add(Seen::always, std::move(table));
}

// ---- picture

/// Options of a state near that of the answer: at another strain, if one is given, or else under stresses
/// times a factor. The given stresses stay the given ones, for they may be uncertain.
Options moved(Options o, double strain_or_factor) {
  if (o.inputs.given(Input::shear_strain))
    o.inputs.set(Input::shear_strain, strain_or_factor);
  else
    for (const Input stress : {Input::pressure, Input::stress_v, Input::stress_h})
      if (o.inputs.given(stress))
        o.inputs.set(stress, o.inputs.number(stress) * strain_or_factor);
  return o;
}

void add_strain_laws(plot::Chart& chart, const AnswerCase& here, const std::vector<double>& strains) {
  for (const sands::StrainLaw& law : sands::strain_laws()) {
    plot::Series line{.name = law.key,
                      .mark = plot::Mark::line,
                      .x = strains,
                      .style = chart.series.size() + 1,
                      .tone = plot::Tone::grey};
    for (const double strain : strains)
      line.y.push_back(here.answer[Field::shear_modulus].value *
                       law.ratio({.strain = strain,
                                  .void_ratio = here.question.state.void_ratio,
                                  .mean_stress = here.question.state.mean_stress(),
                                  .sand = here.question.sand}));
    chart.series.push_back(std::move(line));
  }
}

/// G and its range around the state of the answer: over the shear strain with each published law, if a strain
/// is given; else over the mean stress, from a tenth to tenfold.
/// \throws   InvalidArgument without stress
plot::Chart chart_of(const Options& o, const AnswerCase& here) {
  const double p = here.question.state.mean_stress();
  if (!(p > 0))
    throw InvalidArgument("a picture of G needs a state under stress; the mean stress is 0");
  constexpr double least_strain = 1e-6, largest_strain = 5e-3; // range of the laws of strain
  const std::optional<double> strain = here.question.shear_strain;
  const Field field = strain ? Field::strained_shear_modulus : Field::shear_modulus;
  plot::Chart chart{.title = strain ? "shear modulus over strain" : "shear modulus over stress",
                    .x = {.title = strain ? "shear strain [%]" : "p' [kPa]",
                          .scale = plot::Scale::logarithmic,
                          .unit = strain ? 0.01 : 1e3},
                    .y = {.title = "G [MPa]", .unit = 1e6}};
  Band answers, of_sand;
  for (const double at : strain ? spread(least_strain, std::max(largest_strain, *strain), 61, true)
                                : spread(0.1, 10, 61, true)) {
    const Options there = moved(o, at);
    const AnswerCase c = bare_answer(there.inputs, there.uncertain);
    const double x = strain ? at : at * p;
    if (const estimate::Answer* const one = c.of_kind(here.answer.grain_shape()))
      answers.add(x, (*one)[field]);
    if (here.sand_answer && c.of_sand() != nullptr)
      of_sand.add(x, (*c.of_sand())[field]);
  }
  if (strain)
    add_strain_laws(chart, here, answers.at);
  const bool both = !of_sand.at.empty();
  if (both)
    add_band(chart, of_sand, false, title_of(GrainShape::sand), plot::Colour::measured);
  add_band(chart, answers, false, both ? title_of(here.question.grain_shape) : "answer");
  plot::Series given{.name = strain ? "given strain" : "given stress",
                     .mark = plot::Mark::marker,
                     .style = 0,
                     .colour = plot::Colour::closed_form};
  given.add(strain.value_or(p), here.answer[field].value);
  if (here.sand_answer)
    given.add(strain.value_or(p), (*here.sand_answer)[field].value);
  chart.series.push_back(std::move(given));
  return chart;
}

// ---- the document

Validity slips_of(const Options& o, const State& state) {
  Validity slips = likely_mistakes(o.inputs, state);
  if (o.tolerance.value > 1)
    slips.add(fmt::format("--tolerance {0} is {1}; did you mean {0}%?", short_text(o.tolerance.value),
                          percent_text(o.tolerance.value)));
  return slips;
}

/// The lines below the answer on the first screen.
Prose first_lines(const AnswerCase& c) {
  Prose prose{{"in brackets: one standard deviation to each side, about 68 %; most of it from"}};
  const auto add_share = [&](const char* whose, const estimate::Answer& answer) {
    if (const std::string share = largest_share(answer, c.question); !share.empty())
      prose.lines.push_back(std::string("  ") + whose + share);
  };
  if (c.sand_answer)
    add_share("sand: ", *c.sand_answer);
  add_share(c.sand_answer ? "beads: " : "", c.answer);
  if (prose.lines.size() == 1)
    prose.lines.clear(); // all inputs are exact
  if (c.sand_answer && c.question.saturation > 0)
    prose.lines.emplace_back("V_p is that of wet pores; K, E and nu are drained");
  if (c.sand_answer)
    prose.lines.emplace_back("sand or beads? --grain-shape sand (or sphere) prints one of them");
  prose.lines.push_back(fmt::format("--full: inputs, {} notes, {}every number", c.assumptions.size(),
                                    c.sands.empty() ? "" : "published laws, "));
  return prose;
}

std::string title_text(const State& s) {
  return fmt::format("Small-strain stiffness at e = {}, ", short_text(s.void_ratio)) +
         (s.stress_v == s.stress_h ? "p' = " + pressure_text(s.stress_v)
                                   : fmt::format("sigma_v = {}, sigma_h = {}", pressure_text(s.stress_v),
                                                 pressure_text(s.stress_h)));
}

/// "Within two standard deviations G of a sand is 60 to 230 MPa, for about 19 of 20 sands.": the stated
/// factor of a sand holds squared. Empty without a sand or stress.
std::vector<std::string> two_deviations(const AnswerCase& c) {
  const estimate::Answer* const sand = c.of_sand();
  if (sand == nullptr || !(c.question.state.mean_stress() > 0))
    return {};
  const estimate::Range& G = (*sand)[Field::shear_modulus];
  return {fmt::format("Within two standard deviations G of a sand is {} to {}, for about 19 of 20 sands.",
                      pressure_text(G.low * G.low / G.value), pressure_text(G.high * G.high / G.value))};
}

/// Every section of the result but the picture, and the warnings.
Document document_of(const Options& o, const AnswerCase& c) {
  const State& state = c.answer.state();
  Document to{.command = "estimate", .title = title_text(c.question.state)};
  to.sentences_after = two_deviations(c);
  to.warnings = slips_of(o, state);
  to.add_notes(c.assumptions);
  add_inputs(to, c, o.inputs);
  add_answers(to, c);
  Items notes{.key = "answer"};
  std::vector<std::string> sentences;
  for (const estimate::Note& note : c.assumptions)
    sentences.push_back(note.sentence());
  io::add_item(notes.items, "notes", sentences);
  to.add(Seen::data, std::move(notes));
  to.add(Seen::first, first_lines(c));
  to.add(Seen::full, measured_laws_table(c));
  to.add(Seen::full, strain_laws_table(c));
  const Validity of_forms = add_closed_forms(to, c, o.bounds ? Seen::always : Seen::data);
  if (o.bounds || c.question.grain_shape == GrainShape::sphere) // a sand has measured laws
    to.warnings.merge(of_forms);
  for (const std::string& refused : {c.beads_refused, c.sand_refused})
    if (!refused.empty())
      to.warnings.add(refused);
  to.warnings.merge(c.answer.validity());
  if (c.sand_answer)
    for (const std::string& note : c.sand_answer->validity().notes)
      to.warnings.add("sand: " + note);
  if (o.tolerance.given() && !c.beads_refused.empty())
    throw InvalidArgument("--tolerance chooses among rungs, which are for beads; " + c.beads_refused);
  if (o.tolerance.given())
    add_ladder(to, estimate::choose(c.answer, o.tolerance.value));
  if (o.cement.given())
    add_cement(to, c, o.cement.value);
  to.warnings.keep_each_once();
  return to;
}

ExitCode run(Options o) {
  require_free(o.outlets);
  o.inputs = estimate::completed(std::move(o.inputs));
  if (!o.densest.empty())
    make_densest(o.inputs);
  const AnswerCase c = solve_answer(o.inputs, o.uncertain);
  Document document = document_of(o, c);
  add_sources(document);
  if (o.outlets.draws())
    document.add(Seen::data,
                 Picture{{chart_of(o, c)}, "The shear modulus around this state, with its range."});
  return deliver(o.outlets, document);
}

} // namespace

Command make_estimate() {
  auto options = std::make_shared<Options>();
  Command command{.name = "estimate",
                  .meaning =
                      "Small-strain stiffness and wave speeds of a packing at one state, with their range",
                  .notes = "Examples:\n"
                           "  granum estimate --void-ratio 0.6 --pressure 100kPa\n"
                           "  granum estimate --sand ottawa --relative-density 60% --pressure 100kPa\n"
                           "  granum estimate --void-ratio 0.7 --stress-v 200kPa --stress-h 100kPa",
                  .run = [options] { return run(*options); }};
  add_packing_options(command, options->inputs);
  add_answer_options(command, options->inputs);
  command.add(input_option(options->inputs, Input::k0));
  command.add(input_option(options->inputs, Input::shear_strain));
  command.add(
      "More results",
      {{.name = "--bounds",
        .value = flag(options->bounds),
        .meaning = "Also show three closed forms with their exponents: uniform strain (all grains move with "
                   "the mean strain), uniform stress (all contacts carry the forces of the mean stress), and "
                   "relaxed"},
       {.name = "--tolerance",
        .value = number_without_default(options->tolerance),
        .meaning =
            "Choose the cheapest closed form (rung) whose stated error is within this tolerance, such as 5%"},
       {.name = "--cement",
        .value = number_without_default(options->cement),
        .meaning = "Also show the packing with cement that fills this share of the total volume, such as 2%",
        .synonyms = {{"cementation bond"}}},
       densest_row(options->densest),
       uncertainty_row(options->uncertain)});
  add_outlets(command, options->outlets,
              "Draw G and its range over the mean stress, or over the shear strain with --strain");
  return command;
}

} // namespace granum::cli

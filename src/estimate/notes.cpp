// SPDX-License-Identifier: GPL-3.0-or-later
#include <granum/estimate/notes.hpp>

#include <algorithm>

#include <granum/core/text.hpp>
#include <granum/sands/known_sands.hpp>
#include <granum/sands/pooled_law.hpp>

#include "parts.hpp"

namespace granum::estimate {

std::string Note::sentence() const {
  if (name.empty())
    return reason;
  return "assumed " + name + " " + value + (deviation > 0 ? " +- " + pretty(deviation, dimension) : "") +
         (reason.empty() ? "" : ", " + reason);
}

namespace {

/// A default as a note.
Note default_note(const InputValues& values, Input input, std::span<const UncertainInput> inputs) {
  const InputRow& row = row_of(input);
  const auto found = std::find_if(inputs.begin(), inputs.end(), [&](const UncertainInput& one) {
    return one.assumed && one.input == key_of(row);
  });
  return {.name = values.name(input),
          .value = pretty(values.number(input), row.dimension),
          .number = values.number(input),
          .deviation = found == inputs.end() ? 0 : found->deviation,
          .dimension = row.dimension,
          .reason = row.origin};
}

/// The no-slip value, which follows from nu_g: a formula, if that differs from row to row of a table.
Note tangential_note(const InputValues& values, const effective::State& state) {
  const bool differs = values[Input::grain_poisson_ratio].source == Source::table ||
                       values[Input::grain_bulk_modulus].source == Source::table;
  return {.name = values.name(Input::tangential_ratio),
          .value = differs ? "2(1-nu_g)/(2-nu_g)" : short_text(state.tangential_ratio),
          .number = state.tangential_ratio,
          .reason = "the no-slip contact of Mindlin"};
}

void add_size_notes(Notes& notes, const InputValues& values) {
  if (!values.sizes)
    return;
  constexpr double compared = 1.75; // the largest C_u of validation/sizes
  const double uniformity = sizes::gradation(*values.sizes, 1).uniformity();
  if (uniformity > compared)
    add_sentence(notes, "C_u is " + short_text(uniformity) +
                            ": the sizes in contact were validated with packings only up to " +
                            short_text(compared));
  if (!values.given(Input::rattler_fraction) && !values.given(Input::mechanical_coordination_number))
    add_sentence(notes, values.spelled(
                            "contacts of unequal grains: the sizes in contact are those of a packing without "
                            "rattlers; rattlers are small, so grains in contact are larger than average; "
                            "{rattler_fraction} sets the share of rattlers"));
}

} // namespace

Notes assumed_of_spheres(const InputValues& values, const effective::State& state,
                         std::span<const UncertainInput> inputs) {
  Notes notes;
  const auto note_default = [&](Input input) {
    if (!values.given(input))
      notes.push_back(default_note(values, input, inputs));
  };
  if (!values.given(Input::contact))
    notes.push_back({.name = values.name(Input::contact), .value = "sphere"});
  for (const InputRow& row : estimate::inputs())
    if (row.law != nullptr && row.law->shape == values.contact)
      note_default(row.input);
  note_default(Input::grain_shear_modulus);
  if (!values.given(Input::grain_bulk_modulus))
    note_default(Input::grain_poisson_ratio);
  if (!values.given(Input::d50) && !(values.sizes && values.sizes->mean_radius()) &&
      !values.given(Input::radius)) {
    note_default(Input::radius);
    if (values.sizes)
      notes.back().reason += ", their mean by number";
  }
  if (!values.given(Input::tangential_ratio))
    notes.push_back(tangential_note(values, state));
  note_default(Input::fabric);
  add_size_notes(notes, values);
  return notes;
}

std::optional<Note> assumed_density(const InputValues& values, std::span<const UncertainInput> inputs) {
  if (values.given(Input::grain_density))
    return std::nullopt;
  return default_note(values, Input::grain_density, inputs);
}

namespace {

void add_names(Notes& notes, const InputValues& values) {
  for (const auto& [mineral, share] : values.minerals)
    add_sentence(
        notes,
        (values.minerals.size() > 1 ? short_text(100 * share) + " % of the grains are of " : "grains of ") +
            mineral->name + " [" + mineral->source + "]",
        mineral->source);
  if (values.known_sand == nullptr)
    return;
  const sands::KnownSand& sand = *values.known_sand;
  add_sentence(notes,
               std::string(sand.name) + ": d50, C_u, e_min and e_max as far as published [" + sand.source +
                   "]" + (sand.tests ? "" : "; no tests of this sand are included"),
               sand.source);
  if (sand.tests)
    add_sentence(notes,
                 std::to_string(sand.tests->count) + " tests of this sand [Lo2021]" +
                     (*sand.remark == '\0' ? "" : ", " + std::string(sand.remark)) + ": void ratios " +
                     short_text(sand.tests->void_ratio_low) + " to " +
                     short_text(sand.tests->void_ratio_high) + ", " +
                     pretty(sand.tests->stress_low, Dimension::pressure) + " to " +
                     pretty(sand.tests->stress_high, Dimension::pressure),
                 "Lo2021");
}

/// "0.43", or below sands::low_stress both exponents.
std::string exponent_text(const sands::Sand& sand, double mean_stress) {
  const double here = sands::growth_exponent(sand, mean_stress).value,
               above = sands::growth_exponent(sand, sands::low_stress).value;
  if (here == above)
    return short_text(here, 3);
  return short_text(above, 3) + " from " + pretty(sands::low_stress, Dimension::pressure) + " on and " +
         short_text(here, 3) + " below";
}

/// The grading that published laws need and nobody gave; q knows C_u and d50 of a sand by its name.
void add_assumed_grading(Notes& notes, const InputValues& values, const Question& q) {
  const sands::SandState usual;
  const auto add = [&](Input input, double number, const char* reason) {
    const Dimension dimension = row_of(input).dimension;
    notes.push_back({.name = values.name(input),
                     .value = pretty(number, dimension),
                     .number = number,
                     .dimension = dimension,
                     .reason = reason});
  };
  if (!q.sand.uniformity)
    add(Input::uniformity, usual.uniformity, "of a uniform sand, where a law of sands needs C_u");
  if (!q.sand.d50)
    add(Input::d50, usual.d50,
        "for the published laws of Menq and of Wang and Stokoe, by some per cent; the answer does not need "
        "it");
}

/// The basis of an answer for a sand.
void add_sand_notes(Notes& notes, const InputValues& values, const Question& q) {
  const double p = q.state.mean_stress();
  const auto add = [&notes](const std::string& sentence, std::string source = {}) {
    add_sentence(notes, "sand: " + sentence, std::move(source));
  };
  add("G = " + sands::formula(q.sand) + ", p_a = 100 kPa, s = " + exponent_text(q.sand, p) +
          "; one standard deviation of G is a factor of " +
          short_text(sands::stated_factor(q.sand, q.state.void_ratio, p), 3) +
          ", two are its square [Lo2021]",
      "Lo2021");
  if (q.shear_strain && p > 0)
    add("G/G0 = 1/(1 + (strain/g_r)^0.81), g_r = 0.062 % C_u^-0.3 (p'/p_a)^0.37" +
        std::string(q.sand.uniformity ? "" : " with C_u = 1.5") +
        "; one standard deviation is a factor of 1.6 of g_r. D = 0.8 % (p'/p_a)^-0.15 + 19.5 % (1 - "
        "G/G0)^1.22, "
        "a centre of published laws, not of tests");
  if (p > 0 && p < sands::least_tested_stress)
    add("no sand was tested below p' = 25 kPa; the factor is larger there");
  add(std::string("nu is a mean of measurements; its scatter changes E little, ") +
      (q.saturation < 1 ? "V_p by about 10 %, and " : "V_p of saturated sand hardly, and ") +
      "K by a factor of 1.5");
  add("G_hh is taken as " + short_text(sands::shear_anisotropy) + " +- " +
      short_text(sands::shear_anisotropy_deviation) + " times G_vh under equal stresses, and E_h as E_v +- " +
      short_text(100 * sands::young_anisotropy_deviation) + " %; laboratories differ");
  if (p > 0)
    add_assumed_grading(notes, values, q);
  if (p > 0)
    add("z* and k/k_H are not measured: they are inferred from nu and G by the formula for spheres, with "
        "grains "
        "of quartz (G_g = " +
        pretty(contact::mineral("quartz").material.shear_modulus, Dimension::pressure) +
        ") unless others are given and k_t/k_n of smooth spheres. From G alone, few contacts and soft "
        "contacts cannot be distinguished");
  if (by_usual_limits(values)) {
    const sands::UsualLimits usual = sands::usual_limits(q.sand.uniformity);
    add("void ratio " + short_text(q.state.void_ratio) + " follows from the relative density with e_min " +
        short_text(usual.least) + " and e_max " + short_text(usual.largest) + ", usual values of sands" +
        (q.sand.uniformity ? " of this C_u" : "; G does not depend on this void ratio"));
  }
  if (q.knows_contacts() || q.preparation != effective::Preparation{} || q.state.rolling > 0)
    add("contacts, their rolling resistance and preparation are for the model of spheres; measured laws do "
        "not use them");
}

} // namespace

Notes notes_of(const InputValues& values, const Question& question, std::span<const UncertainInput> inputs,
               bool of_sand) {
  Notes notes;
  if (question.grain_shape == GrainShape::sphere)
    notes = assumed_of_spheres(values, question.state, inputs);
  if (const std::optional<Note> density = assumed_density(values, inputs))
    notes.push_back(*density);
  add_names(notes, values);
  if (of_sand)
    add_sand_notes(notes, values, question);
  if (question.saturation > 0 && question.saturation < 1)
    add_sentence(notes, "air and water share one pressure in the pores; menisci between grains are left out");
  return notes;
}

} // namespace granum::estimate

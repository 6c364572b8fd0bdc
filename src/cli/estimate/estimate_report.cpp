// SPDX-License-Identifier: GPL-3.0-or-later
#include <tuple>

#include <fmt/core.h>
#include <granum/core/number.hpp>

#include "cli/frame/frame.hpp"
#include "cli/options/packing_json.hpp"
#include "estimate.hpp"

namespace granum::cli {

namespace {

using effective::State;
using nlohmann::ordered_json;

ordered_json json_of(const std::optional<double>& value) {
  return value ? ordered_json(*value) : ordered_json();
}

/// For G_hv the direction i is h and j is v.
ordered_json json_of(const effective::RungAnswer& answer) {
  const elastic::TransverselyIsotropic& c = answer.stiffness;
  ordered_json json = {{"C11", c.C11},
                       {"C33", c.C33},
                       {"C12", c.C12},
                       {"C13", c.C13},
                       {"C44", c.C44},
                       {"C66", c.C66()},
                       {"K", c.bulk_modulus()},
                       {"G_hh", c.G_hh()},
                       {"G_vh", c.G_vh()},
                       {"E_v", json_of(elastic::young_modulus(c, elastic::Loading::vertical))},
                       {"E_h", json_of(elastic::young_modulus(c, elastic::Loading::horizontal))}};
  const auto& exponents = answer.exponents;
  json["m"] = exponents ? ordered_json(exponents->stress_h) : ordered_json();
  json["n"] = exponents ? ordered_json(exponents->stress_v) : ordered_json();
  json["s"] = exponents ? ordered_json(exponents->sum()) : ordered_json();
  if (declines(answer))
    json.update({{"declines", true}, {"relative_error", nullptr}});
  else if (const auto& error = answer.relative_error)
    json["relative_error"] = {{"K", error->bulk_modulus}, {"G_vh", error->G_vh}, {"G_hh", error->G_hh}};
  return json;
}

/// "cone, A_1 = 0.4": the shape and its parameters.
std::string contact_text(const ordered_json& contact) {
  std::string text = contact.at("contact").get<std::string>();
  for (const contact::LawParameter& parameter : contact::row_of(*contact::find_shape(text)).parameters)
    text += fmt::format(", {} = {}{}", parameter.symbol,
                        pretty(contact.at(parameter.name).get<double>(), parameter.dimension),
                        parameter.unit.empty() ? "" : " " + parameter.unit);
  return text;
}

/// One line: a label, and the value of each closed form.
std::string row(const std::string& label, const std::vector<std::string>& cells) {
  std::string line = fmt::format("  {:<12}", label);
  for (std::size_t k = 0; k < cells.size(); ++k)
    line += fmt::format(" {:>{}}", cells[k], k == 2 ? 22 : 14);
  line.erase(line.find_last_not_of(' ') + 1);
  return line + "\n";
}

/// "+- 3 %" of the moduli whose error is stated.
std::string error_text(const ordered_json& answer, const char* key) {
  if (!answer.contains("relative_error") || !answer["relative_error"].contains(key))
    return "";
  return fmt::format(" +- {} %", short_text(100 * answer["relative_error"][key].get<double>(), 2));
}

struct Label {
  const char* key; ///< in the JSON
  const char* label;
};

constexpr Label moduli[] = {{"K", "K"},     {"G_vh", "G_vh = C44"}, {"G_hh", "G_hh = C66"},
                            {"E_v", "E_v"}, {"E_h", "E_h"},         {"C11", "C11"},
                            {"C33", "C33"}, {"C12", "C12"},         {"C13", "C13"}};

constexpr Label exponents[] = {{"m", "m, sigma_h"}, {"n", "n, sigma_v"}, {"s", "s = m + n"}};

std::string pressure_text(const ordered_json& value) {
  return value.is_null() ? "undefined" : pretty(value.get<double>(), Dimension::pressure);
}

std::string exponent_text(const ordered_json& value) {
  return value.is_null() ? "undefined" : fmt::format("{:.4f}", value.get<double>());
}

/// The limits of mean-field closed forms.
std::string relaxation_text(const State& state) {
  return fmt::format(
      "\n{} G of a real packing, in which grains deviate from the mean strain. The last column "
      "includes factors for this, calibrated on contact networks; its exponents apply to "
      "a constant number of contacts.\n",
      state.tangential_ratio > 0 ? "Uniform strain and stress overestimate" : "Uniform strain overestimates");
}

} // namespace

Bounds bounds_of(const AnswerCase& c) {
  using effective::RungName;
  Bounds bounds;
  const State& state = c.answer.state();
  for (const auto& [key, title, name] :
       {std::tuple{"uniform_strain", "uniform strain", RungName::directional},
        {"uniform_stress", "uniform stress", RungName::uniform_stress},
        {"relaxed", "relaxed", RungName::relaxed}}) {
    const effective::Rung& rung = effective::rung(name);
    bounds.forms.push_back({key, title, &rung, effective::answer_with_exponents(rung, state)});
    const effective::RungAnswer& answer = bounds.forms.back().answer;
    bounds.validity.merge(answer.validity);
    const bool own_note = name != RungName::relaxed; // stable where uniform strain is
    if (own_note && !elastic::young_modulus(answer.stiffness, elastic::Loading::vertical))
      bounds.validity.add(
          fmt::format("Young's moduli under {} do not exist: the stiffness is not positive definite", title));
  }
  bounds.validity.keep_each_once();
  if (state.stress_v == 0 && state.stress_h == 0)
    bounds.assumptions.emplace_back("m, n and s at zero stress are their limits along the isotropic path");
  if (*state.coordination_number == 0)
    bounds.assumptions.emplace_back(
        "m, n and s do not exist: without contacts every modulus is 0 at any stress");
  if (!c.question.state.coordination_number && c.question.grain_shape == estimate::GrainShape::sphere) {
    const estimate::Range& C_n = c.answer[estimate::Field::coordination_number];
    bounds.assumptions.push_back(fmt::format(
        "bounds and rungs use the estimated C_n = {} (range {} to {}); --coordination-number replaces it",
        short_text(C_n.value, 3), short_text(C_n.low, 3), short_text(C_n.high, 3)));
  }
  return bounds;
}

namespace {

/// "e = 0.802, D_r = 50 %, C_u = 1.39, d50 = 200 um": the known properties of a sand.
std::string sand_line(const sands::Sand& sand, double void_ratio) {
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

std::string stress_line(const State& s) {
  return fmt::format("  stress    sigma_v = {}, sigma_h = {}; mean p' = {}\n\n",
                     pretty(s.stress_v, Dimension::pressure), pretty(s.stress_h, Dimension::pressure),
                     pretty(s.mean_stress(), Dimension::pressure));
}

} // namespace

std::string state_text(const ordered_json& packing, const AnswerCase& c) {
  const State& s = c.question.state;
  if (c.question.grain_shape == estimate::GrainShape::sand) {
    std::string text = fmt::format("Small-strain stiffness of a sand\n\n  sand      {}\n",
                                   sand_line(c.question.sand, s.void_ratio));
    text += fmt::format("  grains    G_g = {}, nu_g = {}\n",
                        pretty(s.law.grain().shear_modulus, Dimension::pressure),
                        short_text(s.law.grain().poisson_ratio));
    if (c.question.shear_strain)
      text += fmt::format("  strain    {}\n", percent_text(*c.question.shear_strain));
    return text + stress_line(s);
  }
  std::string text =
      fmt::format("Small-strain stiffness of a {}packing of {}equal spheres\n\n",
                  c.sand_answer ? "sand, and of a " : "", packing.contains("sizes") ? "un" : "");
  text +=
      fmt::format("  contact   {}; k_t/k_n = {}\n", contact_text(packing), short_text(s.tangential_ratio));
  text += fmt::format("  grains    R = {}, G_g = {}, nu_g = {}\n", pretty(s.radius, Dimension::length),
                      pretty(s.law.grain().shear_modulus, Dimension::pressure),
                      short_text(s.law.grain().poisson_ratio));
  if (packing.contains("sizes")) {
    const ordered_json& g = packing.at("gradation");
    text += fmt::format("  sizes     {}: R is the mean by number; d50 = {}, C_u = {}\n",
                        packing.at("sizes").get<std::string>(),
                        pretty(g.at("d50").get<double>(), Dimension::length),
                        short_text(g.at("uniformity").get<double>()));
    text += "  contacts  " + means_text(s.contacts) + "\n";
  }
  text += fmt::format("  packing   e = {}, fabric a = {}\n", short_text(s.void_ratio),
                      short_text(s.fabric_anisotropy));
  return text + stress_line(s);
}

ordered_json estimate_json(const ordered_json& packing, const Bounds& bounds, const AnswerCase& answer) {
  ordered_json json = json_head("estimate");
  json["answer"] = answer_json(answer);
  json["inputs"] = packing;
  const State& state = answer.answer.state();
  json["inputs"].update({{"stress_v", state.stress_v}, {"stress_h", state.stress_h}});
  for (const ShownForm& form : bounds.forms)
    json[form.key] = json_of(form.answer);
  json["sand_answer"] = sand_answer_json(answer);
  json["measured_sands"] = sands_json(answer);
  json["strain_laws"] = strain_laws_json(answer);
  json["notes"] = answer.assumptions;
  for (const std::vector<std::string>& more : {bounds.assumptions, bounds.validity.notes})
    for (const std::string& note : more)
      json["notes"].push_back(note);
  return json;
}

std::string bounds_table(const State& state, const Bounds& bounds) {
  std::vector<ordered_json> answers;
  std::vector<std::string> titles;
  for (const ShownForm& form : bounds.forms) {
    answers.push_back(json_of(form.answer));
    titles.emplace_back(form.title);
  }
  const auto cells = [&answers](const auto& text_of) {
    std::vector<std::string> texts;
    for (const ordered_json& one : answers)
      texts.push_back(text_of(one));
    return texts;
  };
  std::string text = fmt::format("  at C_n = {}, z* = {}\n", short_text(*state.coordination_number),
                                 short_text(*state.mechanical_coordination_number));
  text += row("", titles);
  for (const Label& m : moduli)
    text += row(m.label, cells([&m](const ordered_json& one) {
                  return one.contains("declines") ? "declines"
                                                  : pressure_text(one[m.key]) + error_text(one, m.key);
                }));
  text += "\n  exponents of stress in G_vh\n";
  for (const Label& e : exponents)
    text += row(e.label, cells([&e](const ordered_json& one) { return exponent_text(one[e.key]); }));
  return text + relaxation_text(state);
}

} // namespace granum::cli

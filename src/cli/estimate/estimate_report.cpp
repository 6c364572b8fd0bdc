// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>

#include <fmt/core.h>
#include <granum/core/number.hpp>

#include "cli/frame/frame.hpp"
#include "cli/options/size_options.hpp"
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

ordered_json inputs(const EstimateCase& question) {
  ordered_json json = question.packing;
  const State& state = question.subject.state;
  json.update({{"stress_v", state.stress_v}, {"stress_h", state.stress_h}});
  if (const auto& z = question.subject.mechanical_coordination_number)
    json["mechanical_coordination_number"] = *z;
  return json;
}

/// "cone, A_1 = 0.4": the shape and what belongs to it.
std::string contact_text(const ordered_json& contact) {
  std::string text = contact.at("contact").get<std::string>();
  for (const contact::LawParameter& parameter : contact::row_of(*contact::find_shape(text)).parameters)
    text += fmt::format(", {} = {}{}", parameter.symbol,
                        pretty(contact.at(parameter.name).get<double>(), parameter.dimension),
                        parameter.unit.empty() ? "" : " " + parameter.unit);
  return text;
}

/// One line: a label, what each closed form says, and the meaning.
std::string row(const std::string& label, const std::vector<std::string>& cells, const std::string& meaning) {
  std::string line = fmt::format("  {:<12}", label);
  for (std::size_t k = 0; k < cells.size(); ++k)
    line += fmt::format(" {:>{}}", cells[k], k == 0 ? 14 : k == 1 ? 16 : 22);
  line += "   " + meaning;
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
  const char* meaning;
};

constexpr Label moduli[] = {
    {"K", "K", "bulk modulus"},
    {"G_vh", "G_vh = C44", "shear in a vertical plane (= G_hv)"},
    {"G_hh", "G_hh = C66", "shear in the horizontal plane"},
    {"E_v", "E_v", "Young's modulus, vertical"},
    {"E_h", "E_h", "Young's modulus, horizontal"},
    {"C11", "C11", ""},
    {"C33", "C33", ""},
    {"C12", "C12", ""},
    {"C13", "C13", ""},
};

constexpr Label exponents[] = {
    {"m", "m", "of sigma_h in G_hv"},
    {"n", "n", "of sigma_v in G_hv"},
    {"s", "s = m + n", "of the mean stress"},
};

std::string pressure_text(const ordered_json& value) {
  return value.is_null() ? "undefined" : pretty(value.get<double>(), Dimension::pressure);
}

std::string exponent_text(const ordered_json& value) {
  return value.is_null() ? "undefined" : fmt::format("{:.4f}", value.get<double>());
}

/// What no closed form of a mean field knows; ratios measured on contact networks of all three shapes.
std::string relaxation_text(const EstimateCase& question) {
  const bool both = question.subject.state.tangential_ratio > 0;
  if (question.subject.mechanical_coordination_number)
    return fmt::format(
        "\n{} G of a real packing, whose grains relax. The last column corrects that by\n"
        "factors calibrated on contact networks; its exponents are those of frozen contacts.\n",
        both ? "Uniform strain and stress overestimate" : "Uniform strain overestimates");
  return fmt::format(
      "\n{} G of a real packing, whose grains relax: it has about 0.7 of it if dense,\n"
      "0.2 to 0.5 if weakly coordinated. --mechanical-coordination-number or --rattler-fraction\n"
      "tell which; granum verify measures it, by network and by DEM.\n",
      both ? "Both overestimate" : "Uniform strain overestimates");
}

} // namespace

std::string state_text(const EstimateCase& question) {
  const State& s = question.subject.state;
  const ordered_json& packing = question.packing;
  std::string text = fmt::format("Small-strain stiffness of a packing of {}equal grains\n\n",
                                 packing.contains("sizes") ? "un" : "");
  text += fmt::format("  contact   {}; k_t/k_n = {}\n", contact_text(question.packing),
                      short_text(s.tangential_ratio));
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
  text += fmt::format("  stress    sigma_v = {}, sigma_h = {}\n\n", pretty(s.stress_v, Dimension::pressure),
                      pretty(s.stress_h, Dimension::pressure));
  return text;
}

ordered_json estimate_json(const EstimateCase& question, const EstimateAnswer& rungs,
                           const AnswerCase& answer) {
  ordered_json json = json_head("estimate");
  json["answer"] = answer_json(answer);
  json["inputs"] = inputs(question);
  for (const ShownAnswer& shown : rungs.forms)
    json[shown.form.key] = json_of(shown.answer);
  json["measured_sands"] = sands_json(answer);
  json["notes"] = question.assumptions;
  for (const std::string& note : rungs.validity.notes)
    json["notes"].push_back(note);
  return json;
}

std::string rungs_table(const EstimateCase& question, const EstimateAnswer& rungs) {
  std::vector<ordered_json> answers;
  std::vector<std::string> titles;
  for (const ShownAnswer& shown : rungs.forms) {
    answers.push_back(json_of(shown.answer));
    titles.emplace_back(shown.form.title);
  }
  const auto cells = [&answers](const auto& text_of) {
    std::vector<std::string> texts;
    for (const ordered_json& one : answers)
      texts.push_back(text_of(one));
    return texts;
  };
  const auto& z = question.subject.mechanical_coordination_number;
  std::string text = fmt::format("  at C_n = {}{}\n", short_text(question.subject.state.coordination_number),
                                 z ? ", z* = " + short_text(*z) : "");
  text += row("", titles, "");
  for (const Label& m : moduli)
    text += row(m.label, cells([&m](const ordered_json& one) {
                  return one.contains("declines") ? "declines"
                                                  : pressure_text(one[m.key]) + error_text(one, m.key);
                }),
                m.meaning);
  text += "\n  exponents of stress\n";
  for (const Label& e : exponents)
    text +=
        row(e.label, cells([&e](const ordered_json& one) { return exponent_text(one[e.key]); }), e.meaning);
  return text + relaxation_text(question);
}

std::string notes_table(const std::vector<std::string>& of_answer, const std::vector<std::string>& of_rungs) {
  std::string text = "\n";
  const auto said = [&](const std::string& note) { // with a spread it may go on
    const std::string begin = note.substr(0, note.find(','));
    return std::any_of(of_answer.begin(), of_answer.end(),
                       [&](const std::string& other) { return other.starts_with(begin); });
  };
  for (const std::string& note : of_answer)
    text += "- " + note + "\n";
  for (const std::string& note : of_rungs)
    if (!said(note))
      text += "- " + note + "\n";
  return text;
}

} // namespace granum::cli

// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/core.h>
#include <granum/core/number.hpp>

#include "estimate.hpp"
#include "frame.hpp"

namespace granum::cli {

namespace {

using effective::State;
using nlohmann::ordered_json;

ordered_json json_of(const std::optional<double>& value) {
  return value ? ordered_json(*value) : ordered_json();
}

/// For G_hv the direction i is h and j is v.
ordered_json json_of(const FieldAnswer& answer) {
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
                       {"E_v", json_of(young_modulus(c, Loading::vertical))},
                       {"E_h", json_of(young_modulus(c, Loading::horizontal))}};
  const auto& exponents = answer.exponents;
  json["m"] = exponents ? ordered_json(exponents->stress_h) : ordered_json();
  json["n"] = exponents ? ordered_json(exponents->stress_v) : ordered_json();
  json["s"] = exponents ? ordered_json(exponents->sum()) : ordered_json();
  return json;
}

ordered_json inputs(const EstimateCase& question) {
  ordered_json json = question.packing;
  json.update({{"stress_v", question.state.stress_v}, {"stress_h", question.state.stress_h}});
  return json;
}

/// "cone, slope 0.4": the shape and what belongs to it.
std::string contact_text(const ordered_json& contact) {
  std::string text = contact.at("contact").get<std::string>();
  if (contact.contains("slope"))
    text += " of slope " + short_text(contact["slope"].get<double>());
  if (contact.contains("punch_radius"))
    text += " punch of radius " + pretty(contact["punch_radius"].get<double>(), Dimension::length);
  if (contact.contains("alpha"))
    text += fmt::format(", profile {} r^{} (SI)", short_text(contact["profile_constant"].get<double>()),
                        short_text(contact["alpha"].get<double>()));
  return text;
}

std::string state_text(const EstimateCase& question) {
  const State& s = question.state;
  std::string text = "Small-strain stiffness of a packing of equal grains, closed form\n\n";
  text += fmt::format("  contact   {}; k_t/k_n = {}\n", contact_text(question.packing),
                      short_text(s.tangential_ratio));
  text += fmt::format("  grains    R = {}, G_g = {}, nu_g = {}\n", pretty(s.radius, Dimension::length),
                      pretty(s.law.grain().shear_modulus, Dimension::pressure),
                      short_text(s.law.grain().poisson_ratio));
  text += fmt::format("  packing   e = {}, C_n = {}, fabric a = {}\n", short_text(s.void_ratio),
                      short_text(s.coordination_number), short_text(s.fabric_anisotropy));
  text += fmt::format("  stress    sigma_v = {}, sigma_h = {}\n\n", pretty(s.stress_v, Dimension::pressure),
                      pretty(s.stress_h, Dimension::pressure));
  return text;
}

std::string row(const std::string& label, const std::string& strain, const std::string& stress,
                const std::string& meaning) {
  std::string line = fmt::format("  {:<12} {:>14} {:>16}   {}", label, strain, stress, meaning);
  line.erase(line.find_last_not_of(' ') + 1);
  return line + "\n";
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
std::string relaxation_text(const State& state) {
  return fmt::format(
      "\n{} G of a real packing, whose grains relax: it has about 0.7 of it if dense,\n"
      "0.2 to 0.5 if weakly coordinated. granum verify measures this, by network and by DEM.\n",
      state.tangential_ratio > 0 ? "Both overestimate" : "Uniform strain overestimates");
}

} // namespace

ordered_json estimate_json(const EstimateCase& question, const EstimateAnswer& answer) {
  ordered_json json = json_head("estimate");
  json["inputs"] = inputs(question);
  json["uniform_strain"] = json_of(answer.uniform_strain);
  json["uniform_stress"] = json_of(answer.uniform_stress);
  json["notes"] = question.assumptions;
  for (const std::string& note : answer.validity.notes)
    json["notes"].push_back(note);
  return json;
}

std::string estimate_table(const EstimateCase& question, const EstimateAnswer& answer) {
  const ordered_json strain = json_of(answer.uniform_strain);
  const ordered_json stress = json_of(answer.uniform_stress);
  std::string text = state_text(question);
  text += row("", "uniform strain", "uniform stress", "");
  for (const Label& m : moduli)
    text += row(m.label, pressure_text(strain[m.key]), pressure_text(stress[m.key]), m.meaning);
  text += "\n  exponents of stress\n";
  for (const Label& e : exponents)
    text += row(e.label, exponent_text(strain[e.key]), exponent_text(stress[e.key]), e.meaning);
  text += relaxation_text(question.state);
  for (const std::string& note : question.assumptions)
    text += "- " + note + "\n";
  return text;
}

} // namespace granum::cli

// SPDX-License-Identifier: GPL-3.0-or-later
#include "estimate.hpp"

#include <fmt/core.h>
#include <granum/core/check.hpp>
#include <granum/core/error.hpp>
#include <granum/core/number.hpp>
#include <granum/elastic/isotropic.hpp>
#include <granum/elastic/wave_speeds.hpp>
#include <granum/rock_physics/contact_cement.hpp>
#include <granum/rock_physics/sand_bounds.hpp>

namespace granum::cli {

CementAnswer cement_answer(const AnswerCase& c, double share) {
  const effective::State& state = c.answer.state();
  const double e = state.void_ratio, before = e / (1 + e);
  require_open("--cement", share, 0, before);
  if (c.question.saturation > 0)
    throw InvalidArgument("--cement applies to dry pores: leave out --saturation");
  const contact::GrainMaterial grain = state.law.grain();
  CementAnswer answer{.share = share,
                      .porosity = before - share,
                      .coordination_number = *state.coordination_number,
                      .models = {},
                      .validity = {}};
  const rock_physics::CementedPacking cemented{.shear_modulus = grain.shear_modulus,
                                               .poisson_ratio = grain.poisson_ratio,
                                               .cement_shear_modulus = grain.shear_modulus,
                                               .cement_poisson_ratio = grain.poisson_ratio,
                                               .porosity = before,
                                               .coordination_number = answer.coordination_number,
                                               .cement_saturation =
                                                   rock_physics::cement_saturation(before, answer.porosity)};
  const rock_physics::SpherePacking loose{.shear_modulus = grain.shear_modulus,
                                          .poisson_ratio = grain.poisson_ratio,
                                          .porosity = before,
                                          .coordination_number = answer.coordination_number,
                                          .pressure = state.mean_stress()};
  answer.models = {
      {"friable", "in the pores, none at contacts", rock_physics::soft_sand(loose, answer.porosity)},
      {"surface_layer", "a layer on all grains",
       rock_physics::contact_cement(cemented, rock_physics::CementScheme::surface_layer)},
      {"at_contacts", "all at the contacts",
       rock_physics::contact_cement(cemented, rock_physics::CementScheme::at_contacts)}};
  const double density = elastic::bulk_density(
      {.grain_density = *c.question.grain_density, .void_ratio = answer.porosity / (1 - answer.porosity)});
  for (CementModel& model : answer.models) {
    for (const std::string& note : model.moduli.validity.notes)
      answer.validity.add(std::string("cement, ") + model.title + ": " + note);
    const auto& [K, G, notes] = model.moduli;
    if (!(K > 0 && G > 0))
      continue;
    const elastic::WaveSpeeds speeds =
        elastic::wave_speeds(elastic::Isotropic::from_bulk_and_shear(K, G), density);
    model.shear_wave_speed = speeds.s;
    model.compression_wave_speed = speeds.p;
  }
  return answer;
}

nlohmann::ordered_json cement_json(const CementAnswer& answer) {
  nlohmann::ordered_json json = {{"share", answer.share},
                                 {"porosity", answer.porosity},
                                 {"coordination_number", answer.coordination_number}};
  for (const CementModel& model : answer.models)
    json[model.key] = {{"shear_modulus", model.moduli.shear_modulus},
                       {"bulk_modulus", model.moduli.bulk_modulus},
                       {"shear_wave_speed", model.shear_wave_speed},
                       {"compression_wave_speed", model.compression_wave_speed}};
  return json;
}

std::string cement_table(const CementAnswer& answer) {
  const auto modulus = [](double value) { return pretty(value, Dimension::pressure); };
  std::string text = fmt::format("\ncemented: {} of the total volume is cement of the grains' mineral, dry\n"
                                 "  porosity {}, C_n = {} of spheres; by location of the cement\n"
                                 "  {:<30}{:>11}{:>11}{:>10}{:>10}\n",
                                 percent_text(answer.share), percent_text(answer.porosity),
                                 short_text(answer.coordination_number, 3), "", "G", "K", "V_s", "V_p");
  for (const CementModel& model : answer.models)
    text +=
        fmt::format("  {:<30}{:>11}{:>11}{:>10}{:>10}\n", model.title, modulus(model.moduli.shear_modulus),
                    modulus(model.moduli.bulk_modulus), pretty(model.shear_wave_speed, Dimension::speed),
                    pretty(model.compression_wave_speed, Dimension::speed));
  return text + "  these models assume uniform strain: they are too stiff where grains have few\n"
                "  contacts; their error is not known [DvorkinNur1996]\n";
}

} // namespace granum::cli

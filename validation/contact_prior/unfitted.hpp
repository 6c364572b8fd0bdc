// SPDX-License-Identifier: GPL-3.0-or-later
// Packings that the prior was not fitted to, compared with what it states of them: of rough spheres, and of
// `granum verify`.
#pragma once

#include <granum/contact/rough_sphere.hpp>
#include <granum/effective/contact_prior.hpp>
#include <granum/estimate/answer.hpp>

#include "../common.hpp"
#include "../infer/packings.hpp"
#include "../relaxation/reading.hpp"
#include "calibration.hpp"

namespace contact_prior::unfitted {

using granum::effective::ContactCounts;
using granum::effective::Preparation;
using granum::effective::State;

struct Packing {
  std::string recipe; ///< with the roughness before it, or the shape
  std::string specimen;
  State state;
  Preparation preparation;
  ContactCounts counts;     ///< counted
  double shear_modulus = 0; ///< of the network; 0 where it is not recorded [Pa]
};

inline Preparation preparation(bool dense, double friction_coefficient) {
  if (dense)
    return {.kind = Preparation::Kind::dense};
  return {.kind = Preparation::Kind::friction, .friction_coefficient = friction_coefficient};
}

/// validation/relaxation/rough.csv: 50 and 200 nm between grains of 0.5 mm.
inline std::vector<Packing> read_relaxation(const std::string& path) {
  constexpr granum::contact::GrainMaterial grain{.shear_modulus = 30e9, .poisson_ratio = 0.15};
  constexpr double radius = 0.5e-3;
  std::vector<Packing> all;
  for (const Entry& row : read_record(path)) {
    const std::string roughness = row.text("contact").substr(5), &recipe = row.text("preparation");
    all.push_back({.recipe = roughness + ", " + recipe,
                   .specimen = roughness + recipe + row.text("seed"),
                   .state = {.law = granum::contact::RoughSphere(grain, radius, std::stod(roughness) * 1e-9),
                             .radius = radius,
                             .void_ratio = row("e"),
                             .stress_v = row("p_Pa"),
                             .stress_h = row("p_Pa")},
                   .preparation = preparation(recipe == "dense", row("friction_coefficient")),
                   .counts = {.mechanical_coordination_number = row("z_star"),
                              .rattler_fraction = row("rattler_fraction")}});
  }
  return all;
}

/// Of the record of another reader, whose moduli are known too.
template <class Other>
Packing packing(const Other& p, const std::string& recipe, const std::string& specimen,
                const Preparation& preparation, double shear_modulus) {
  Packing out{.recipe = recipe,
              .specimen = specimen,
              .state = p.state,
              .preparation = preparation,
              .counts = {.mechanical_coordination_number = p.mechanical_coordination,
                         .rattler_fraction = p.rattler_fraction},
              .shear_modulus = shear_modulus};
  out.state.coordination_number.reset();
  return out;
}

/// validation/infer/states.csv: 20 nm between grains of 0.1 mm.
inline std::vector<Packing> read_infer(const std::string& path) {
  std::vector<Packing> all;
  for (const infer_packings::Packing& p : infer_packings::read(path))
    if (p.contact == "rough")
      all.push_back(packing(p, "20nm, " + p.recipe, p.specimen(), p.preparation(), p.shear_modulus));
  return all;
}

/// States of `granum verify`: cones, spheres and flat contacts.
inline std::vector<Packing> read_verify(const std::string& path) {
  std::vector<Packing> all;
  for (const relaxation::Packing& p : relaxation::read_verify_states(path))
    all.push_back(packing(p, p.contact + " " + p.preparation, p.specimen,
                          preparation(p.preparation == "dense", p.friction_coefficient),
                          relaxation::isotropic_shear_modulus(p.networks.front().stiffness)));
  return all;
}

/// z* by the recipe, z* carried to all larger pressures of the specimen, and ln G of the network over that of
/// estimate::answer: how far they are off, and how often by more than is stated.
struct Judged {
  Errors z, carried, shear;
};

inline Judged judge(const std::string& what, const std::vector<Packing>& all) {
  Judged judged;
  for (const Packing& p : all) {
    // The range of a friction is one number; both ends are the middle.
    const auto prior = granum::effective::contact_prior(p.state, p.preparation);
    judged.z.add(prior.middle.mechanical_coordination_number - p.counts.mechanical_coordination_number,
                 prior.coordination_error);
    if (p.shear_modulus > 0) {
      const auto answer = granum::estimate::answer({.state = p.state, .preparation = p.preparation});
      const granum::estimate::Range G = answer[granum::estimate::Field::shear_modulus];
      const double off = std::log(G.value / p.shear_modulus);
      judged.shear.add(off, off > 0 ? std::log(G.value / G.low) : std::log(G.high / G.value));
    }
    for (const Packing& later : all)
      if (later.specimen == p.specimen && later.state.mean_stress() > p.state.mean_stress()) {
        const auto carried =
            granum::effective::carried_contacts(p.state, p.counts, later.state.mean_stress());
        judged.carried.add(carried.counts.mechanical_coordination_number -
                               later.counts.mechanical_coordination_number,
                           carried.coordination_error);
      }
  }
  print_errors("  " + what, {{"z*", &judged.z}, {"carried", &judged.carried}}, 1);
  if (judged.shear.count() > 0)
    print_errors("  -", {{"G", &judged.shear}});
  return judged;
}

inline Judged judge_recipes(const std::vector<Packing>& all) {
  return judge_each(
             "", all, [](const Packing& p) { return p.recipe; }, judge)
      .at("together");
}

inline void check_rough(const std::string& relaxation_path, const std::string& infer_path, Claims& claims) {
  std::printf("rough spheres, of which the prior has seen none\n");
  for (const std::vector<Packing>& all : {read_relaxation(relaxation_path), read_infer(infer_path)}) {
    const Judged together = judge_recipes(all);
    claims.require_covered(together.z, "z* of rough packings");
    // Smooth packings of the recipes of infer/states.csv are covered no better.
    claims.require_covered(together.carried, "carried to larger pressures", 0.55, 0.85);
    if (together.shear.count() > 0)
      claims.require_covered(together.shear, "G of the estimate");
  }
}

inline void check_verify(const std::string& path, Claims& claims) {
  std::printf("specimens of verify, of seeds that the prior has not seen\n");
  claims.require_covered(judge_recipes(read_verify(path)).z, "z* of verify's specimens");
}

} // namespace contact_prior::unfitted

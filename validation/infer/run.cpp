// SPDX-License-Identifier: GPL-3.0-or-later
// Does inference give back the contacts of packings that are known, and foretell their moduli elsewhere? The
// network's G and K of granum's own packings are the measurements, the counted z* and the networks at other
// pressures the truth.
//     infer_run <validation/relaxation/states.csv> <validation/laboratory/beads_states.csv> [states.csv]
// Exit code 0 only if what README.md promises holds.
#include <granum/inverse/inference.hpp>

#include "../common.hpp"
#include "../relaxation/reading.hpp"
#include "contacts.hpp"

namespace {

using namespace granum;
using effective::State;
using inverse::GrowthRule;
using inverse::Observation;
using inverse::Quantity;

/// A packing that is known altogether.
struct Known {
  std::string group;    ///< what it is reported under
  std::string specimen; ///< one a specimen
  State state;
  double coordination = 0;   ///< z* as counted
  double shear_modulus = 0;  ///< of the network [Pa]
  double bulk_modulus = 0;   ///< of the network [Pa]
  double overlap = 0;        ///< of the mean force over the diameter
  bool on_the_way_up = true; ///< pressure was never larger before
};

constexpr double largest_overlap = 0.01;

std::vector<Known> packings_of_relaxation(const std::string& path) {
  std::vector<Known> all;
  for (const relaxation::Packing& p : relaxation::read_packings(path)) {
    if (!p.isotropic())
      continue;
    const auto network = std::ranges::find(p.networks, p.state.tangential_ratio, &relaxation::Network::ratio);
    State state = p.state;
    state.stress_v = state.stress_h = (p.state.stress_v + 2 * p.state.stress_h) / 3;
    state.fabric_anisotropy = 0;
    all.push_back({.group = p.contact,
                   .specimen = p.specimen,
                   .state = state,
                   .coordination = p.mechanical_coordination,
                   .shear_modulus = relaxation::isotropic_shear_modulus(network->stiffness),
                   .bulk_modulus = network->stiffness.bulk_modulus(),
                   .overlap = p.relative_overlap,
                   .on_the_way_up = p.preparation != "cycle"});
  }
  // The file has the states of a specimen in the order of its path, but those of others between them.
  std::ranges::stable_sort(all, {}, &Known::specimen);
  return all;
}

/// Specimens of `granum verify`: other seeds, other grains.
std::vector<Known> packings_of_beads(const std::string& path) {
  const contact::GrainMaterial glass{.shear_modulus = 29e9, .poisson_ratio = 0.2};
  const double radius = 0.05e-3;
  std::vector<Known> all;
  for (const Entry& row : read_record(path)) {
    const State state{.law = contact::PowerLaw::sphere(glass, radius),
                      .tangential_ratio = contact::mindlin_stiffness_ratio(0.2),
                      .radius = radius,
                      .void_ratio = row("e"),
                      .coordination_number = row("C_n"),
                      .stress_v = row("p_Pa"),
                      .stress_h = row("p_Pa")};
    all.push_back({.group = "beads",
                   .specimen = row.text("density") + row.text("seed"),
                   .state = state,
                   .coordination = row("z_star"),
                   .shear_modulus = row("G_network_Pa"),
                   .bulk_modulus = row("K_network_Pa"),
                   .overlap = relaxation::detail::relative_overlap(state)});
  }
  return all;
}

inverse::InferenceAnswer infer_from(const Known& known, Quantity quantity, GrowthRule growth) {
  const double value = quantity == Quantity::K ? known.bulk_modulus : known.shear_modulus;
  const Observation measured{quantity, {value, 0}, known.state};
  return inverse::infer(std::span(&measured, 1), {.growth = growth});
}

/// z* as found minus z* as counted, of one group or of all (""), z* from 4.4 to 6.3; printed.
Errors coordination_errors(const std::string& name, const std::vector<Known>& all, Quantity quantity,
                           const std::string& group = "") {
  constexpr double low = 4.4, high = 6.3;
  Errors errors;
  int within_tenth = 0;
  for (const Known& known : all) {
    if ((!group.empty() && known.group != group) || known.coordination < low || known.coordination > high ||
        known.overlap > largest_overlap)
      continue;
    const auto answer = infer_from(known, quantity, GrowthRule::fixed);
    if (!answer.together)
      continue; // K below what any rigid network has
    const Measured z = answer.together->packing(known.state).mechanical_coordination_number;
    errors.add(z.value - known.coordination, z.standard_error);
    within_tenth += std::abs(z.value - known.coordination) <= 0.1;
  }
  print_errors("  " + name, {{"z*", &errors}}, 1);
  std::printf("%47s within 0.1 %3.0f %%\n", "|", 100.0 * within_tenth / errors.count());
  return errors;
}

/// ln G as predicted from the first state of each specimen, minus ln G of its network there; printed. Misses
/// of one specimen are not independent.
struct Predictions {
  Errors all;
  std::map<std::string, Errors> in_stated; ///< of each specimen, over the stated errors

  /// Share of the specimens whose root mean square is at most two.
  [[nodiscard]] double specimens_within_two() const {
    const auto within = std::ranges::count_if(in_stated, [](const auto& s) { return s.second.rms() <= 2; });
    return static_cast<double>(within) / static_cast<double>(in_stated.size());
  }
};
Predictions prediction_errors(const std::string& name, const std::vector<Known>& all, GrowthRule growth) {
  Predictions errors;
  const Known* first = nullptr;
  std::optional<inverse::InferenceAnswer> answer;
  for (const Known& known : all) {
    if (!known.on_the_way_up || known.overlap > largest_overlap)
      continue;
    if (first == nullptr || first->specimen != known.specimen) {
      first = &known;
      answer = infer_from(known, Quantity::G_vh, growth);
      continue;
    }
    if (!answer->together)
      continue;
    const Measured G = answer->together->predict(Quantity::G_vh, known.state);
    const double error = std::log(G.value / known.shear_modulus), stated = G.standard_error / G.value;
    errors.all.add(error, stated);
    errors.in_stated[known.specimen].add(error / stated);
  }
  print_errors("  " + name, {{"ln G", &errors.all}});
  return errors;
}

void run(const std::string& states, const std::string& beads, Claims& claims) {
  const std::vector<Known> own = packings_of_relaxation(states), fresh = packings_of_beads(beads);
  std::printf("z* of G of the network, minus z* as counted, z* from 4.4 to 6.3\n");
  const Errors all = coordination_errors("all that rung 3 was calibrated on", own, Quantity::G_vh);
  for (const char* shape : {"cone", "sphere", "alpha1.5", "flat", "alpha4"})
    coordination_errors(shape, own, Quantity::G_vh, shape);
  const Errors of_beads = coordination_errors("glass beads, fresh seeds", fresh, Quantity::G_vh);
  std::printf("the same of K\n");
  coordination_errors("all", own, Quantity::K);
  std::printf("ln G predicted from the first pressure of each specimen, z* growing as own packings'\n");
  const Errors grown = prediction_errors("all", own, GrowthRule::packings).all;
  const Predictions beads_grown = prediction_errors("glass beads, fresh seeds", fresh, GrowthRule::packings);
  const double beads_within = beads_grown.specimens_within_two();
  std::printf("  %-34s %.0f %% within two stated errors (rms)\n", "- their specimens", 100 * beads_within);
  std::printf("the same with z* fixed\n");
  const Errors fixed = prediction_errors("all", own, GrowthRule::fixed).all;
  prediction_errors("glass beads, fresh seeds", fresh, GrowthRule::fixed);

  claims.require(all.count() > 0 && all.rms() < 0.1 && of_beads.rms() < 0.1, "z*: rms within 0.1");
  claims.require(all.two() > 0.9, "z*: more than 90 % within two stated errors");
  claims.require(grown.rms() < 0.5 * fixed.rms(), "ln G: half the rms of a z* that is fixed");
  claims.require(grown.two() > 0.9, "ln G: more than 90 % within two stated errors");
  Claims::aim(beads_grown.all.two() > 0.8, "ln G of fresh beads: more than 80 % within two stated errors");
  claims.require(beads_within > 0.8, "ln G of fresh beads: more than 80 % of the specimens in rms");
}

} // namespace

int main(int argc, char** argv) {
  return program(
      argc, argv,
      {{"", "relaxation/states.csv laboratory/beads_states.csv [states.csv]", [](const Arguments& files) {
          Claims claims;
          run(files[0], files[1], claims);
          if (files.size() == 3)
            implied::judge(files[2], claims);
          return claims.exit_code();
        }}});
}

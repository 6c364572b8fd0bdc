// SPDX-License-Identifier: GPL-3.0-or-later
//
// Example 06: which estimate of a modulus is accurate enough?
//
// A closed form (formula) takes nanoseconds and may be wrong by a factor of up to four. The linear response
// of the contact network needs a packing and a fraction of a second, and is exact for small strain. Each
// estimate is a rung of a ladder: a higher rung assumes less and costs more. estimate::choose takes the
// cheapest rung whose stated error (standard error) is within a tolerance, and lists the inputs that would
// allow a better one. Here it estimates G_vh, the shear modulus of a vertical plane, of one loose packing,
// each time with more known inputs. Each answer is compared with the network of this packing, rung 4.
//
// e is the void ratio and C_n the number of contacts per grain. z* is the same number without rattlers, the
// grains that carry no load. The fabric is the distribution of contact directions.
#include <cmath>
#include <cstdio>
#include <string>
#include <vector>

#include <granum/analysis/measure.hpp>
#include <granum/core/text.hpp>
#include <granum/dem/specimen.hpp>
#include <granum/elastic/isotropic.hpp>
#include <granum/estimate/ladder.hpp>
#include <granum/triaxial/specimen.hpp>

using namespace granum;

namespace {

constexpr double pressure = 100e3; // [Pa]

dem::Specimen loose_specimen(const triaxial::SpecimenRecipe& recipe) {
  dem::Specimen last;
  const dem::Specimen frictionless = triaxial::frictionless_specimen(recipe).state;
  triaxial::isotropic_path(triaxial::start_of_compression(frictionless, triaxial::Density::loose, recipe),
                           recipe.material, {10e3, pressure}, triaxial::compression_options(),
                           [&last](const triaxial::Snapshot& snapshot) {
                             last = snapshot.state;
                             return true;
                           });
  return last;
}

/// The answer if the fabric was not measured: a fabric is assumed, with a standard deviation, as for other
/// uncertain inputs.
estimate::Answer with_unknown_fabric(const estimate::Question& packing,
                                     std::vector<estimate::UncertainInput> inputs = {}) {
  const effective::State& s = packing.state;
  inputs.push_back({.input = std::string(estimate::fabric_input),
                    .deviation = estimate::assumed_fabric_deviation(s.stress_v, s.stress_h),
                    .assumed = true,
                    .moved = [packing](double change) {
                      estimate::Question moved = packing;
                      moved.state.fabric_anisotropy += change;
                      return moved;
                    }});
  return estimate::answer(packing, inputs);
}

/// Asks for three tolerances, prints the answers, and counts violations of two promises: a looser tolerance
/// never chooses a more expensive rung, and the actual error of an answer is at most three stated errors.
int ask(const char* what, const estimate::Answer& answer, double network_modulus) {
  std::printf("\n%s\n", what);
  int broken = 0;
  std::size_t last_rung = 0;
  for (const double tolerance : {5.0, 0.3, 0.05}) {
    const estimate::Ladder ladder = estimate::choose(answer, tolerance);
    const estimate::RungAssessment& choice = ladder.choice();
    const double modulus = choice.stiffness->G_vh();
    const double error = modulus / network_modulus - 1;
    std::printf("  within %-6s %s  G = %5.1f MPa, stated error %6s, actual %6s%s\n",
                percent_text(tolerance).c_str(), effective::label(*choice.rung).c_str(), modulus / 1e6,
                percent_text(choice.relative_error->G_vh).c_str(), percent_text(error).c_str(),
                ladder.tolerance_met ? "" : "  (tolerance not met)");
    broken += ladder.chosen < last_rung;
    broken += std::abs(error) > 3 * choice.relative_error->G_vh;
    last_rung = ladder.chosen;
    if (tolerance == 0.05)
      for (const std::string& advice : ladder.advice)
        std::printf("      %s\n", advice.c_str());
  }
  return broken;
}

} // namespace

int main() {
  // 1. A packing: 500 spheres of 1 mm, compressed with friction to 100 kPa.
  const contact::GrainMaterial grain{.shear_modulus = 30e9, .poisson_ratio = 0.15};
  const triaxial::SpecimenRecipe recipe{
      .material = {.law = contact::PowerLaw::sphere(grain, 0.5e-3),
                   .tangential_ratio = contact::mindlin_stiffness_ratio(grain.poisson_ratio),
                   .friction_coefficient = 0.4986},
      .radius = 0.5e-3,
      .grains = 500};
  const dem::Specimen specimen = loose_specimen(recipe);
  const analysis::Measurement measured =
      analysis::measure(dem::contact_network(specimen, recipe.material),
                        {.law = recipe.material.law, .tangential_ratio = recipe.material.tangential_ratio},
                        {.network = network::ResponseOptions{}});

  // 2. Rung 4, the contact network: the reference for all other answers.
  const auto network =
      elastic::transversely_isotropic_projection(measured.solved_network().response.relaxed());
  std::printf("contact network of the packing: G_vh = %.1f MPa\n", network.G_vh() / 1e6);

  // 3. Known: contact law, void ratio, C_n and the stress, as a paper may give them. The share of rattlers is
  //    not known, so z* is uncertain: the contacts may belong to all grains or only to a part of them.
  const packing::MechanicalCoordination& counted = measured.counts.mechanical;
  estimate::Question packing{.state = {.law = recipe.material.law,
                                       .tangential_ratio = recipe.material.tangential_ratio,
                                       .radius = recipe.radius,
                                       .void_ratio = measured.void_ratio,
                                       .coordination_number = measured.counts.coordination_number,
                                       .stress_v = pressure,
                                       .stress_h = pressure}};
  int broken = ask("known: law, e, C_n, stress", with_unknown_fabric(packing), network.G_vh());

  // 4. The rattlers were counted in a part of the packing, with a standard error of 1 grain in 100.
  packing.rattler_fraction = counted.rattler_fraction;
  const estimate::UncertainInput rattlers{
      .input = "rattlers", .deviation = 0.01, .moved = [packing](double change) {
        estimate::Question moved = packing;
        moved.rattler_fraction = *packing.rattler_fraction + change;
        return moved;
      }};
  broken += ask("also the rattlers, to 1 % of the grains", with_unknown_fabric(packing, {rattlers}),
                network.G_vh());

  // 5. The list of contacts gives the rattlers, and so z*, exactly. It gives the fabric as well.
  broken += ask("z* from the list of contacts", with_unknown_fabric(packing), network.G_vh());
  packing.state.fabric_anisotropy = measured.microstructure().fabric_anisotropy;
  broken += ask("and the fabric", estimate::answer(packing), network.G_vh());

  // 6. Check: no promise was broken.
  return broken == 0 ? 0 : 1;
}

// SPDX-License-Identifier: GPL-3.0-or-later
//
// Example 06: which estimate of a modulus is accurate enough?
//
// A closed form (formula) takes nanoseconds and may be wrong by a factor of three. The linear response of the
// contact network needs a packing and a fraction of a second, and is exact for small strain. estimate::choose
// takes the cheapest rung (estimate) of the ladder whose stated error is within a tolerance, and lists the
// inputs that would allow a better one. Here it estimates G of one loose packing four times, each time with
// one more known input. Each answer is compared with the network of this packing.
#include <cmath>
#include <cstdio>
#include <string>
#include <vector>

#include <granum/analysis/measure.hpp>
#include <granum/core/number.hpp>
#include <granum/dem/specimen.hpp>
#include <granum/elastic/projection.hpp>
#include <granum/estimate/ladder.hpp>
#include <granum/triaxial/specimen.hpp>

using namespace granum;

namespace {

constexpr double pressure = 100e3;

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

/// The answer where nobody measured the fabric: an assumption, like other inputs that are not exact.
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

/// Asks for several tolerances, prints the answers, and returns how many broke a promise: a looser tolerance
/// takes no dearer rung, and no answer is off by more than three stated errors.
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

  // 2. Rung 4, the answer that all others are measured against.
  const auto network =
      elastic::transversely_isotropic_projection(measured.solved_network().response.relaxed());
  std::printf("contact network of the packing: G_vh = %.1f MPa\n", network.G_vh() / 1e6);

  // 3. Known: law, void ratio, C_n and the stress, as one would have them from a paper. How many grains
  //    rattle is not known, and so z* may be off: so many contacts may be those of few grains or of all.
  const packing::MechanicalCoordination& counted = measured.counts.mechanical;
  estimate::Question packing{.state = {.law = recipe.material.law,
                                       .tangential_ratio = recipe.material.tangential_ratio,
                                       .radius = recipe.radius,
                                       .void_ratio = measured.void_ratio,
                                       .coordination_number = measured.counts.coordination_number,
                                       .stress_v = pressure,
                                       .stress_h = pressure}};
  int broken = ask("known: law, e, C_n, stress", with_unknown_fabric(packing), network.G_vh());

  // 4. Someone has counted the rattlers in a part of it: to 1 grain in 100.
  packing.rattler_fraction = counted.rattler_fraction;
  const estimate::UncertainInput rattlers{
      .input = "rattlers", .deviation = 0.01, .moved = [packing](double change) {
        estimate::Question moved = packing;
        moved.rattler_fraction = *packing.rattler_fraction + change;
        return moved;
      }};
  broken += ask("also the rattlers, to 1 % of the grains", with_unknown_fabric(packing, {rattlers}),
                network.G_vh());

  // 5. Exactly, from the list of contacts; which has the fabric as well.
  broken += ask("z* from the list of contacts", with_unknown_fabric(packing), network.G_vh());
  packing.state.fabric_anisotropy = measured.microstructure().fabric_anisotropy;
  broken += ask("and the fabric", estimate::answer(packing), network.G_vh());

  // 6. Check: no promise was broken.
  return broken == 0 ? 0 : 1;
}

// SPDX-License-Identifier: GPL-3.0-or-later
//
// Example 14: why is a well graded sand softer than a uniform one of the same void ratio?
//
// Spheres at 100 kPa, with uniformity coefficients C_u = d60/d10 from 1 to 4. The closed form (formula) of
// the shear modulus G needs the sizes and z*, the number of contacts per grain without rattlers (grains that
// carry no load). z* does not follow from the sizes: it was counted in packings that granum made by DEM
// (validation/gradation). A wide gradation packs denser. So at a void ratio e at which equal grains are
// nearly as dense as possible, a wide gradation is loose, has few contacts, and is soft. At equal relative
// density z* changes far less, and from C_u = 1 to 2.5 G is nearly constant.
//
// Columns of the table: e, C_u and the counted z*; G under uniform strain (all grains move with the mean
// strain); the share of this G that remains when grains relax until their forces balance; G of the relaxed
// closed form with its stated error; G of sands by the law of Wichtmann and Triantafyllidis.
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <optional>
#include <vector>

#include <granum/effective/relaxation.hpp>
#include <granum/effective/uniform_field.hpp>
#include <granum/sands/known_sands.hpp>
#include <granum/sizes/contact_means.hpp>

using namespace granum;

namespace {

/// Counts in packings of one kind, mean of four packings.
struct Counted {
  double void_ratio;
  double z_star;           // contacts of a grain, rattlers left out
  double rattler_fraction; // grains that carry no load, over all grains
};

/// Grains with the same mass in each step of diameter, and their packings from the densest to the loosest:
/// made without friction, and compressed with a friction coefficient of 0.1, 0.3 and 0.5.
struct Gradation {
  double size_ratio; // largest over smallest diameter
  std::vector<Counted> packings;
};
const std::vector<Gradation> gradations{
    {1, {{0.571, 6.10, 0.01}, {0.621, 5.40, 0.02}, {0.680, 4.71, 0.04}, {0.713, 4.39, 0.07}}},
    {2.11, {{0.535, 6.08, 0.04}, {0.582, 5.32, 0.05}, {0.640, 4.68, 0.10}, {0.664, 4.34, 0.15}}},
    {3.5, {{0.485, 6.03, 0.11}, {0.522, 5.30, 0.12}, {0.580, 4.59, 0.20}, {0.611, 4.27, 0.26}}},
    {5.29, {{0.437, 6.01, 0.21}, {0.461, 5.26, 0.25}, {0.510, 4.51, 0.35}, {0.548, 4.23, 0.41}}},
    {7.67, {{0.386, 5.96, 0.33}, {0.409, 5.08, 0.26}, {0.459, 4.51, 0.48}, {0.496, 4.14, 0.53}}},
    {16, {{0.312, 5.66, 0.63}, {0.326, 4.98, 0.61}, {0.377, 4.30, 0.71}}}}; // left out: 0.5, z* = 3.97

/// Relative density 0 is the packing with friction 0.3, relative density 1 the one made without friction.
double void_ratio(const Gradation& g, double relative_density) {
  const double loose = g.packings[2].void_ratio; // friction 0.3
  return loose - relative_density * (loose - g.packings[0].void_ratio);
}

/// Linear interpolation between two packings; empty for void ratios beyond the densest or the loosest
/// packing.
std::optional<Counted> packing(const Gradation& g, double e) {
  for (std::size_t k = 1; k < g.packings.size(); ++k) {
    const Counted &a = g.packings[k - 1], &b = g.packings[k];
    const double t = (e - a.void_ratio) / (b.void_ratio - a.void_ratio);
    if (t >= 0 && t <= 1)
      return Counted{e, a.z_star + t * (b.z_star - a.z_star),
                     a.rattler_fraction + t * (b.rattler_fraction - a.rattler_fraction)};
  }
  return std::nullopt;
}

/// Prints one line of the table; returns G of the relaxed closed form [Pa].
double answer(const Gradation& g, const Counted& c) {
  const contact::GrainMaterial quartz{.shear_modulus = 30e9, .poisson_ratio = 0.15};
  const double radius = 0.5e-3, pressure = 100e3; // the mean radius; any other gives the same G
  const sizes::Distribution sizes = sizes::Distribution::power_law(3, g.size_ratio);
  const sizes::ContactMeans contacts = sizes::expected_contact_means(sizes, c.rattler_fraction);
  const effective::State state{.law = contact::PowerLaw::sphere(quartz, radius * contacts.pair_radius),
                               .tangential_ratio = contact::mindlin_stiffness_ratio(quartz.poisson_ratio),
                               .radius = radius,
                               .void_ratio = c.void_ratio,
                               .coordination_number = c.z_star * (1 - c.rattler_fraction),
                               .stress_v = pressure,
                               .stress_h = pressure,
                               .contacts = contacts};
  const double strain = effective::uniform_strain(state).stiffness.G_vh();
  const effective::RelaxedEstimate relaxed = effective::relaxed(state, c.z_star);
  const double C_u = sizes::gradation(sizes, radius).uniformity(), G = relaxed.stiffness.G_vh();
  const double sand =
      sands::shear_modulus(sands::measured_law("wichtmann-triantafyllidis"), {c.void_ratio, pressure, C_u})
          .shear_modulus;
  std::printf("%.3f  %4.1f  %.2f  %7.0f  %9.2f  %6.0f +- %2.0f %%  %8.0f MPa\n", c.void_ratio, C_u, c.z_star,
              strain / 1e6, G / strain, G / 1e6, 100 * relaxed.relative_error.G_vh, sand / 1e6);
  return G;
}

} // namespace

int main() {
  std::printf("           counted   uniform                 closed form   measured\n"
              "    e   C_u    z*     strain   relaxed             G       sands\n");

  // 1. At equal void ratio G and z* fall as C_u grows. No void ratio occurs in the packings of all C_u.
  bool falls = true;
  for (const double e : {0.60, 0.55, 0.50, 0.45}) {
    double last = INFINITY;
    for (const Gradation& g : gradations)
      if (const std::optional<Counted> counted = packing(g, e)) {
        const double G = answer(g, *counted);
        falls = falls && G < last;
        last = G;
      }
    std::printf("\n");
  }

  // 2. At equal relative density, half way between the packing with friction 0.3 and the densest one. Beyond
  //    C_u = 2.5 the means over contacts, estimated from the sizes, are too large (validation/gradation), and
  //    so is G.
  double least = INFINITY, most = 0;
  for (const Gradation& g : gradations) {
    const double G = answer(g, packing(g, void_ratio(g, 0.5)).value());
    if (g.size_ratio < 6) {
      least = std::min(least, G);
      most = std::max(most, G);
    }
  }
  std::printf("\nat equal relative density, C_u 1 to 2.5: G within %.0f %%\n", 100 * (most / least - 1));

  // 3. Check: at equal void ratio G falls in every step of C_u; at equal relative density the values of G up
  //    to C_u = 2.5 are within 10 %.
  return falls && most < 1.1 * least ? 0 : 1;
}

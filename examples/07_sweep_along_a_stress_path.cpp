// SPDX-License-Identifier: GPL-3.0-or-later
//
// Example 07: how do the moduli of a packing change while it is sheared?
//
// Triaxial compression (TXC) from 100 kPa: the vertical stress sigma_v grows, the horizontal stress sigma_h
// is constant. p' is the mean stress, q = sigma_v - sigma_h, and eta = q/p' the stress ratio. The number of
// contacts and the fabric (their directions) are constant, which is nearly true of dense specimens.
//
// G_hh is the shear modulus of the horizontal plane, G_hv = G_vh that of a vertical plane, and E_v Young's
// modulus in the vertical direction. The stresses in the horizontal plane are constant, and yet G_hh grows a
// little, because all contacts that are not horizontal carry part of the vertical stress. With a file name
// the program draws the moduli as SVG:
//   07_sweep_along_a_stress_path moduli.svg
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <numbers>
#include <string>

#include <granum/effective/exponents.hpp>
#include <granum/effective/uniform_field.hpp>
#include <granum/io/output_file.hpp>
#include <granum/plot/chart.hpp>
#include <granum/stress/stress.hpp>

using namespace granum;

namespace {

constexpr double start = 100e3; // mean stress at which the path begins [Pa]
constexpr int steps = 10;

/// Moduli [Pa] at one stress ratio.
struct Row {
  double eta;
  stress::AxialStress stress;
  double G_hh;
  double G_hv;
  double E_v;
  effective::StressExponents exponents; // of G_hv
};

/// The packing on the path that begins at a mean stress p.
Row evaluate(effective::State packing, double p, double eta) {
  const stress::AxialStress stress = stress::stress_on_path(stress::ShearPath::txc, p, eta);
  packing.stress_v = stress.v;
  packing.stress_h = stress.h;
  const auto stiffness = effective::uniform_strain(packing).stiffness;
  return {.eta = eta,
          .stress = stress,
          .G_hh = stiffness.G_hh(),
          .G_hv = stiffness.G_vh(), // G_hv = G_vh
          .E_v = stiffness.E_v(),
          .exponents = effective::uniform_strain_exponents(packing, effective::Modulus::G_vh)};
}

void print(const Row& row) {
  std::printf("%5.2f  %7.1f  %7.1f   %6.1f  %6.1f  %6.1f   %.4f + %.4f = %.4f\n", row.eta,
              row.stress.mean() / 1e3, row.stress.v / 1e3, row.G_hh / 1e6, row.G_hv / 1e6, row.E_v / 1e6,
              row.exponents.stress_h, row.exponents.stress_v, row.exponents.sum());
}

/// Adds a point to the curves of G_hh, G_hv and E_v.
void add(plot::Chart& chart, const Row& row) {
  const double moduli[] = {row.G_hh, row.G_hv, row.E_v};
  for (std::size_t k = 0; k < chart.series.size(); ++k) {
    chart.series[k].x.push_back(row.eta);
    chart.series[k].y.push_back(moduli[k]);
  }
}

} // namespace

int main(int argc, char** argv) {
  // 1. A dense packing of spheres, with a few more contacts near the vertical than near the horizontal.
  const contact::GrainMaterial grain{.shear_modulus = 30e9, .poisson_ratio = 0.15};
  const double radius = 0.5e-3;
  const effective::State packing{.law = contact::PowerLaw::sphere(grain, radius),
                                 .tangential_ratio = contact::mindlin_stiffness_ratio(grain.poisson_ratio),
                                 .radius = radius,
                                 .void_ratio = 0.558,
                                 .coordination_number = 5.73,
                                 .fabric_anisotropy = 0.1,
                                 .stress_v = start,
                                 .stress_h = start};

  // 2. The path ends at the failure of a material with a friction angle of 26.5 degrees.
  const double angle = 26.5 * std::numbers::pi / 180;
  const double end = stress::failure_ratio(stress::ShearPath::txc, angle);

  // 3. The moduli along the path, and for the check also along the path from 800 kPa. The exponents m and n
  //    are those of G_hv ~ sigma_h^m sigma_v^n; s is their sum, and b = 1/(1+alpha) its expected value. alpha
  //    is the exponent of the profile of a grain near a contact (spheres: 2).
  plot::Chart chart{.title = "Uniform strain along TXC from 100 kPa",
                    .x = {.title = "\u03b7 = q/p'"},
                    .y = {.title = "modulus [MPa]", .unit = 1e6},
                    .series = {{.name = "G_hh", .x = {}, .y = {}},
                               {.name = "G_hv", .x = {}, .y = {}},
                               {.name = "E_v", .x = {}, .y = {}}}};
  std::printf("                kPa                      MPa      G_hv ~ sigma_h^m sigma_v^n\n"
              "  eta       p'  sigma_v     G_hh    G_hv     E_v        m +      n =      s\n");
  double worst = 0;
  const double b = packing.law.constant_exponent().value();
  for (int k = 0; k <= steps; ++k) {
    const double eta = end * k / steps;
    const Row row = evaluate(packing, start, eta);
    print(row);
    add(chart, row);
    const Row at_eight_times = evaluate(packing, 8 * start, eta);
    const double secant = std::log(at_eight_times.G_hv / row.G_hv) / std::log(8);
    worst = std::max({worst, std::abs(row.exponents.sum() - b), std::abs(secant - b)});
  }

  // 4. A picture, if a file name was given.
  if (argc > 1)
    io::write_file(argv[1], plot::svg(chart), io::Existing::replace);

  // 5. Check: m and n change with the stress ratio, their sum does not. The sum is s = 1/(1+alpha) of the
  //    contact law, both by exact derivatives and by comparison of the paths from 100 and from 800 kPa.
  std::printf("largest departure from s = 1/(1+alpha) = %.4f on the path: %.1e\n", b, worst);
  return worst < 1e-12 ? 0 : 1;
}

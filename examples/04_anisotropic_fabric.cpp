// SPDX-License-Identifier: GPL-3.0-or-later
//
// Example 04: what is the effect of a preferred direction of the contacts?
//
// Deposited or sheared grains have more contacts along one direction than across it. The density of contact
// directions, the fabric, is E(gamma) = 3(1 + a cos 2 gamma)/(4 pi (3-a)). gamma is the angle from the
// vertical, and a, the anisotropy, is one number. Here a dense packing of spheres under equal stresses has
// fabrics from a = -0.2 (more horizontal contacts) to 0.2 (more vertical contacts); all other inputs are
// constant.
//
// Index 3 and v are the vertical axis, index 1 and h a horizontal one. C33 and C11 are the stiffnesses
// without lateral strain, G_vh and G_hh the shear moduli of a vertical and of the horizontal plane. F33/F11
// is the ratio of vertical to horizontal contacts, by the second moments of their directions. Uniform strain
// means that all grains move with the mean strain; relaxed grains move until their forces balance.
#include <cmath>
#include <cstdio>
#include <vector>

#include <granum/effective/exponents.hpp>
#include <granum/effective/relaxation.hpp>
#include <granum/effective/uniform_field.hpp>
#include <granum/elastic/waves.hpp>
#include <granum/fabric/orientation.hpp>

using namespace granum;

namespace {

/// z*, the mean number of contacts of the grains that carry load: C_n = 5.73 contacts per grain in the mean
/// of all grains, of which two in a hundred are rattlers (carry no load).
constexpr double mechanical_coordination_number = 5.85;

/// The properties of the packing with one fabric.
struct Row {
  double a;
  double contacts;                         // F33/F11
  elastic::TransverselyIsotropic strained; // by uniform strain
  elastic::TransverselyIsotropic relaxed;  // by rung 3, the relaxed closed form
  effective::StressExponents exponents;    // of G_vh
  elastic::ThomsenParameters thomsen;
  elastic::TransverselyIsotropicWaves upwards, sideways; // waves that travel in this direction
};

Row evaluate(effective::State state, double a, double density) {
  state.fabric_anisotropy = a;
  const fabric::SecondMoments F = fabric::second_moments(a);
  const auto relaxed = effective::relaxed(state, mechanical_coordination_number).stiffness;
  return {.a = a,
          .contacts = F.F33 / F.F11,
          .strained = effective::uniform_strain(state).stiffness,
          .relaxed = relaxed,
          .exponents = effective::uniform_strain_exponents(state, effective::Modulus::G_vh),
          .thomsen = elastic::thomsen_parameters(relaxed),
          .upwards = elastic::plane_waves(relaxed, density, {0, 0, 1}),
          .sideways = elastic::plane_waves(relaxed, density, {1, 0, 0})};
}

double axis_ratio(const elastic::TransverselyIsotropic& c) { return c.C33 / c.C11; }
double shear_ratio(const elastic::TransverselyIsotropic& c) { return c.G_vh() / c.G_hh(); }

/// Rounded to three decimals; zero has no sign.
double shown(double x) { return std::round(1000 * x) / 1000 + 0.0; }

bool close(double x, double y, double tolerance) { return std::abs(x - y) <= tolerance * std::abs(y); }

/// 0 if the results obey symmetry and scaling.
int check(const std::vector<Row>& rows) {
  for (const Row& row : rows) {
    // Spheres: G ~ p^(1/3) for any directions of the contacts.
    if (!close(row.exponents.sum(), 1.0 / 3, 1e-12))
      return 1;
    // A shear wave that travels horizontally with vertical motion is as fast as one that travels vertically.
    if (!close(row.sideways.quasi_s.speed, row.upwards.pure_s.speed, 1e-12))
      return 1;
    // Stiffer along the direction of more contacts.
    if ((axis_ratio(row.relaxed) - 1) * row.a < 0 || (shear_ratio(row.relaxed) - 1) * row.a < 0)
      return 1;
    if (row.a == 0 && (std::abs(row.thomsen.epsilon) > 1e-14 || std::abs(row.thomsen.gamma) > 1e-14))
      return 1;
  }
  return 0;
}

} // namespace

int main() {
  // 1. The packing, dry quartz-like spheres under 100 kPa from all sides.
  const contact::GrainMaterial grain{.shear_modulus = 30e9, .poisson_ratio = 0.15};
  const effective::State state{.law = contact::PowerLaw::sphere(grain, 0.5e-3),
                               .tangential_ratio = contact::mindlin_stiffness_ratio(grain.poisson_ratio),
                               .radius = 0.5e-3,
                               .void_ratio = 0.558,
                               .coordination_number = 5.73,
                               .stress_v = 100e3,
                               .stress_h = 100e3};
  const double density = elastic::bulk_density({.grain_density = 2650, .void_ratio = state.void_ratio});

  // 2. Five fabrics.
  std::vector<Row> rows;
  for (const double a : {-0.2, -0.1, 0.0, 0.1, 0.2})
    rows.push_back(evaluate(state, a, density));

  // 3. Moduli. Under uniform strain the stiffness is less anisotropic than the contacts, F33/F11: in a
  //    direction of few contacts each contact carries more force, and is stiffer. With relaxation the
  //    stiffness is more anisotropic: grains relax less in directions of many contacts.
  std::printf("                  mean strain           relaxed\n");
  std::printf("    a  F33/F11  C33/C11  G_vh/G_hh   C33/C11  G_vh/G_hh\n");
  for (const Row& row : rows)
    std::printf("%5.1f  %7.3f  %7.3f  %9.3f   %7.3f  %9.3f\n", row.a, row.contacts, axis_ratio(row.strained),
                shear_ratio(row.strained), axis_ratio(row.relaxed), shear_ratio(row.relaxed));

  // 4. Exponents n of the vertical stress sigma_v and m of the horizontal stress sigma_h. The contact law
  //    determines their sum, the directions of the contacts determine n and m.
  std::printf("\n    a   G_vh ~ sigma_v^n sigma_h^m\n");
  for (const Row& row : rows)
    std::printf("%5.1f   n = %.4f  m = %.4f  sum %.4f\n", row.a, row.exponents.stress_v,
                row.exponents.stress_h, row.exponents.sum());

  // 5. Speeds that bender elements or a seismic survey would measure in the relaxed packing. V_p: compression
  //    waves that travel upright or sideways. V_s: shear waves that travel upright, or sideways with motion
  //    in the horizontal plane. Thomsen's epsilon = (C11-C33)/(2 C33) compares the stiffnesses of compression
  //    waves, gamma = (C66-C44)/(2 C44), with C66 = G_hh and C44 = G_vh, those of shear waves. Both are
  //    negative if vertical contacts prevail. delta describes compression waves in directions near the
  //    vertical.
  std::printf("\n         Thomsen                     V_p [m/s]           V_s [m/s]\n");
  std::printf("    a   epsilon   delta   gamma   upright  sideways   upright  in the plane\n");
  for (const Row& row : rows)
    std::printf("%5.1f   %7.3f  %6.3f  %6.3f   %7.1f  %8.1f   %7.1f  %12.1f\n", row.a,
                shown(row.thomsen.epsilon), shown(row.thomsen.delta), shown(row.thomsen.gamma),
                row.upwards.quasi_p.speed, row.sideways.quasi_p.speed, row.upwards.pure_s.speed,
                row.sideways.pure_s.speed);

  // 6. Unequal stresses have a similar effect. Which ratio of stresses gives, with a = 0, the G_vh/G_hh of
  //    a = 0.1 under equal stresses?
  effective::State stressed = state;
  double low = 1, high = 4;
  while (high - low > 1e-6) {
    const double middle = (low + high) / 2;
    stressed.stress_v = middle * stressed.stress_h;
    const auto c = effective::relaxed(stressed, mechanical_coordination_number).stiffness;
    (shear_ratio(c) < shear_ratio(rows[3].relaxed) ? low : high) = middle;
  }
  std::printf("\na = 0.1 at equal stresses has the G_vh/G_hh of a = 0 at sigma_v/sigma_h = %.2f\n", high);

  // 7. Check: every fabric obeys symmetry and scaling.
  return check(rows);
}

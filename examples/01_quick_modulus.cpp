// SPDX-License-Identifier: GPL-3.0-or-later
//
// Example 01: how stiff is this packing, now?
//
// A dense packing of quartz-like spheres, 1 mm in diameter, under 100 kPa. The closed forms (formulas) need
// inputs that a laboratory or a simulation can give: elasticity and size of the grains, void ratio, contacts
// per grain, fabric (directions of the contacts) and stress. One evaluation takes less than a microsecond.
//
// Uniform strain, in which all grains move with the mean strain, is an upper estimate: real grains deviate
// from the mean strain, and the packing is softer. Uniform stress, in which the mean stress determines the
// force of each contact, is printed for comparison.
//
// v is the vertical direction, the axis of symmetry; h is any horizontal one. K is the bulk modulus. G_hh is
// the shear modulus of the horizontal plane, G_vh that of a vertical plane. E_v and E_h are Young's moduli.
#include <chrono>
#include <cmath>
#include <cstdio>

#include <granum/effective/exponents.hpp>
#include <granum/effective/uniform_field.hpp>

using namespace granum;

namespace {

void print(const char* name, const effective::Estimate& estimate) {
  const auto& c = estimate.stiffness;
  std::printf("%-28s K %6.1f   G_hh %6.1f   G_vh %6.1f   E_v %6.1f   E_h %6.1f MPa\n", name,
              c.bulk_modulus() / 1e6, c.G_hh() / 1e6, c.G_vh() / 1e6, c.E_v() / 1e6, c.E_h() / 1e6);
  for (const std::string& note : estimate.validity.notes)
    std::printf("  note: %s\n", note.c_str());
}

/// Mean time of a call while the coordination number changes a little each time [ns].
double nanoseconds_per_call(effective::State state) {
  constexpr int calls = 20000;
  double sum = 0;
  const auto start = std::chrono::steady_clock::now();
  for (int i = 0; i < calls; ++i) {
    *state.coordination_number += 1e-9;
    sum += effective::uniform_strain(state).stiffness.C44;
  }
  const std::chrono::duration<double, std::nano> time = std::chrono::steady_clock::now() - start;
  return sum > 0 ? time.count() / calls : 0;
}

} // namespace

int main() {
  // 1. The grains: an elastic solid, and the shape of the surface where they touch.
  const contact::GrainMaterial grain{.shear_modulus = 30e9, .poisson_ratio = 0.15};
  const double radius = 0.5e-3;

  // 2. The packing and its stress [Pa]. Each number has a name; if one is missing, the closed form throws an
  //    error with this name. tangential_ratio is the tangential over the normal stiffness of a contact.
  const effective::State isotropic{.law = contact::PowerLaw::sphere(grain, radius),
                                   .tangential_ratio = contact::mindlin_stiffness_ratio(grain.poisson_ratio),
                                   .radius = radius,
                                   .void_ratio = 0.558,
                                   .coordination_number = 5.73,
                                   .stress_v = 100e3,
                                   .stress_h = 100e3};

  // 3. Two estimates: grains move with the mean strain, or contact forces follow from the mean stress.
  const effective::Estimate upper = effective::uniform_strain(isotropic);
  print("uniform strain, isotropic", upper);
  print("uniform stress, isotropic", effective::uniform_stress(isotropic));

  // 4. The same packing at rest in the ground: the horizontal stress is half the vertical one, and more
  //    contacts are near the vertical (fabric anisotropy a = 0.1). The exponents are those of
  //    G_vh ~ sigma_v^n sigma_h^m, from exact derivatives.
  effective::State at_rest = isotropic;
  at_rest.stress_h = 50e3;
  at_rest.fabric_anisotropy = 0.1;
  print("uniform strain, at rest", effective::uniform_strain(at_rest));
  const auto exponents = effective::uniform_strain_exponents(at_rest, effective::Modulus::G_vh);
  std::printf("G_vh ~ sigma_v^%.3f sigma_h^%.3f there, sum %.3f\n", exponents.stress_v, exponents.stress_h,
              exponents.sum());

  // 5. Time of one evaluation. With unequal stresses the stiffness of a contact depends on its direction, and
  //    the closed form is a numerical integral.
  std::printf("time of one estimate: %.0f ns isotropic, %.0f ns direction-dependent\n",
              nanoseconds_per_call(isotropic), nanoseconds_per_call(at_rest));

  // 6. Check: the stiffness of a contact of spheres grows with the cube root of the force, so eight times the
  //    stress doubles every modulus.
  effective::State loaded = isotropic;
  loaded.stress_v *= 8;
  loaded.stress_h *= 8;
  const double ratio = effective::uniform_strain(loaded).stiffness.G_vh() / upper.stiffness.G_vh();
  std::printf("G at 800 kPa over G at 100 kPa: %.15g\n", ratio);
  return std::abs(ratio - 2) < 1e-14 ? 0 : 1;
}

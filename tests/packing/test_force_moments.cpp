// SPDX-License-Identifier: GPL-3.0-or-later
#include <granum/packing/forces.hpp>

#include <granum/contact/power_law.hpp>
#include <granum/packing/assembly.hpp>
#include <granum/packing/coordination.hpp>

#include "sample_packings.hpp"
#include "sphere_chain.hpp"
#include "unit.hpp"

TEST_CASE("moments of two forces by hand, contacts that carry nothing do not count") {
  packing::Assembly a = samples::sphere_chain();
  a.contacts[0].normal_force = 1;
  a.contacts[1].normal_force = 3;
  a.contacts[0].tangential_force = {0, 0.5, 0};
  CHECK(normal_force_moment(a, 0) == 1);
  CHECK(normal_force_moment(a, 1) == doctest::Approx(1).epsilon(1e-15));
  CHECK(normal_force_moment(a, 2) == doctest::Approx(5.0 / 4).epsilon(1e-14));
  CHECK_THROWS_AS(static_cast<void>(normal_force_moment(a, std::numeric_limits<double>::infinity())),
                  InvalidArgument);
  a.contacts[0].normal_force = 0;
  CHECK(normal_force_moment(a, -0.5) == doctest::Approx(1).epsilon(1e-15));
  for (const double none : {0.0, -1e-9}) {
    a.contacts[1].normal_force = none;
    CHECK_THROWS_AS(static_cast<void>(normal_force_moment(a, 1)), InvalidArgument);
  }
}

TEST_CASE("unevenness: of equal grains the moment of the forces, of others by hand, none of equal forces") {
  const contact::GrainMaterial grain{.shear_modulus = 30e9, .poisson_ratio = 0.15};
  const double R = 0.5e-3;
  for (const contact::NormalLaw& law : {contact::NormalLaw(contact::PowerLaw::cone(grain, 0.4)),
                                        contact::NormalLaw(contact::PowerLaw::sphere(grain, R)),
                                        contact::NormalLaw(contact::PowerLaw::flat(grain, 5e-6))}) {
    packing::Assembly a = samples::lattice(samples::face_centred, {.radius = R, .normal_force = 0.02});
    CHECK(std::abs(force_unevenness(a, law, R)) < 1e-13);
    samples::Uniform uniform(7);
    for (packing::Contact& c : a.contacts)
      c.normal_force = uniform(0, 0.1);
    const double b = law.constant_exponent().value();
    const double moment = b > 0 ? std::log(normal_force_moment(a, b)) : 0;
    CHECK(force_unevenness(a, law, R) == doctest::Approx(moment).epsilon(1e-12).scale(1));
    for (packing::Contact& c : a.contacts)
      c.normal_force = 0;
    CHECK(force_unevenness(a, law, R) == 0);
    CHECK_THROWS_AS((void)force_unevenness(a, law, 0), InvalidArgument);
  }
  // Two contacts of spheres: k_n of a pair is (f R*)^(1/3) times a number that cancels.
  packing::Assembly two = samples::sphere_chain();
  two.radius[0] = 0.7e-3;
  double stiffness = 0, squares = 0, work = 0, lengths = 0;
  for (packing::Contact& c : two.contacts) {
    c.normal_force = 1 + 2 * c.i;
    const double l = norm(c.branch), radius = 2 / (1 / two.radius[c.i] + 1 / two.radius[c.j]);
    stiffness += std::cbrt(c.normal_force * radius) * l * l;
    squares += l * l;
    work += c.normal_force * l;
    lengths += l;
  }
  CHECK(force_unevenness(two, contact::PowerLaw::sphere(grain, R), R) ==
        doctest::Approx(std::log(stiffness / (std::cbrt(work / lengths * R) * squares))).epsilon(1e-12));
}

TEST_CASE("Hertz contacts: the bounds are those written in force moments") { // [AgnolinRoux2007c]
  const double young = 70e9, poisson = 0.3, radius = 1e-3, diameter = 2 * radius;
  const double stiff = young / (1 - poisson * poisson), ratio = 2 * (1 - poisson) / (2 - poisson);
  packing::Assembly a = samples::lattice(samples::face_centred, {.radius = radius});
  samples::Uniform uniform(4);
  for (packing::Contact& c : a.contacts) {
    const double h = uniform(0, 1e-7);
    c.normal_force = stiff * std::sqrt(diameter) / 3 * std::pow(h, 1.5);
    c.normal_stiffness = 1.5 * c.normal_force / h;
    c.tangential_stiffness = ratio * c.normal_stiffness;
    const Vec3 push = uniform.vector(0.3 * c.normal_force);
    c.tangential_force = push - dot(push, normal(c)) * normal(c);
  }
  const double density = coordination_number(a) * solid_fraction(a);
  const double scale =
      0.5 * std::pow(density * stiff / (3 * std::numbers::pi), 2.0 / 3) * std::cbrt(contact_stress(a).mean());
  // Z'(5/3) = <f_n^(5/3) (1 + (f_t/f_n)^2/r)>/<f_n>^(5/3)
  double forces = 0, energy = 0;
  for (const packing::Contact& c : a.contacts) {
    const double slope = norm(c.tangential_force) / c.normal_force;
    forces += c.normal_force;
    energy += std::pow(c.normal_force, 5.0 / 3) * (1 + slope * slope / ratio);
  }
  const double contacts = static_cast<double>(a.contacts.size());
  const double energy_moment = energy / contacts / std::pow(forces / contacts, 5.0 / 3);
  const auto bounds = bulk_modulus_bounds(a);
  CHECK(bounds.upper == doctest::Approx(scale * normal_force_moment(a, 1.0 / 3)).epsilon(1e-12));
  CHECK(bounds.lower == doctest::Approx(scale / energy_moment).epsilon(1e-12));
  CHECK(bounds.lower < bounds.upper);
}

TEST_CASE("no force, no stiffness: bounds stay defined") {
  packing::Assembly a = samples::lattice(samples::simple_cubic, {});
  CHECK(bulk_modulus_bounds(a).lower == 0); // no pressure
  CHECK(bulk_modulus_bounds(a).upper > 0);
  a = samples::sphere_chain();
  a.contacts[0].tangential_force = {0, 1e-3, 0};
  a.contacts[0].tangential_stiffness = 0;
  CHECK(bulk_modulus_bounds(a).lower == 0); // a force on nothing
  a.contacts.clear();
  CHECK(bulk_modulus_bounds(a).upper == 0);
  CHECK(bulk_modulus_bounds(a).lower == 0);
}

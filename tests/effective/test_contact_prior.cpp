// SPDX-License-Identifier: GPL-3.0-or-later
#include <granum/effective/contact_prior.hpp>

#include <tuple>

#include <granum/contact/rough_sphere.hpp>
#include <granum/effective/relaxation.hpp>

#include "effective/contact_prior_coefficients.hpp"
#include "effective/contact_prior_kernel.hpp"
#include "support.hpp"
#include "thresholds.hpp"
#include "unit.hpp"

using namespace granum::test;
using effective::ContactCounts;
using effective::ContactPrior;
using effective::Preparation;

namespace {

constexpr Preparation dense{.kind = Preparation::Kind::dense};
constexpr Preparation loose{.kind = Preparation::Kind::loose};
Preparation friction(double coefficient) {
  return {.kind = Preparation::Kind::friction, .friction_coefficient = coefficient};
}

/// Spheres of Table 1 of the paper; C_n is left unset, as it is what is asked for.
State spheres(double void_ratio, double pressure) {
  return {.law = law_of(2, 0.15),
          .radius = 5e-4,
          .void_ratio = void_ratio,
          .stress_v = pressure,
          .stress_h = pressure};
}

double z(const ContactCounts& counts) { return counts.mechanical_coordination_number; }

/// Overlap of the mean force of a packing, by the state's own functions.
double overlap_of(State s, const ContactCounts& counts) {
  s.tangential_ratio = 0.9;
  s.coordination_number = counts.coordination_number();
  return s.law.overlap(effective::mean_contact_force(s)) / (2 * s.radius * s.contacts.branch);
}

/// Moduli with the contacts that the prior expects.
elastic::TransverselyIsotropic prepared(double e, double p, double alpha, const Preparation& preparation) {
  State s = spheres(e, p);
  s.law = law_of(alpha, 0.15);
  s.tangential_ratio = 0.9;
  const ContactCounts counts = effective::contact_prior(s, preparation).middle;
  s.coordination_number = counts.coordination_number();
  return effective::relaxed(s, z(counts)).stiffness;
}

} // namespace

// Packings of granum's own and of others: validation/contact_prior.
TEST_CASE("contact prior: published states of friction 0.3, dense by vibration and loose") {
  CHECK(std::abs(z(effective::contact_prior(spheres(0.575, 10e3), friction(0.3)).middle) - 4.56) < 0.25);
  CHECK(std::abs(z(effective::contact_prior(spheres(0.689, 10e3), friction(0.3)).middle) - 4.55) < 0.25);
}

TEST_CASE("contact prior: roughness makes no contacts, and rattlers are those expected at z*") {
  for (const auto& [e, recipe] : {std::pair{0.5443, dense}, std::pair{0.5684, friction(0.4986)},
                                  std::pair{0.6053, friction(0.1)}, std::pair{0.6672, friction(0.3)}}) {
    State s = spheres(e, 10e3);
    s.tangential_ratio = 0.9;
    const ContactPrior smooth = effective::contact_prior(s, recipe);
    s.law = contact::RoughSphere({.shear_modulus = 30e9, .poisson_ratio = 0.15}, s.radius, 50e-9);
    const ContactPrior rough = effective::contact_prior(s, recipe);
    CHECK(close(z(rough.middle), z(smooth.middle), 1e-12));
    CHECK(close(effective::expected_rattlers(s, z(rough.middle)).fraction, rough.middle.rattler_fraction,
                1e-9));
  }
}

TEST_CASE("contact prior: the less a packing was opened, the faster it gains contacts") {
  // Spheres of friction 0.5 from 10 to 100 kPa: 4.38 to 4.75 at e = 0.573, 4.28 to 4.46 at 0.716.
  const auto growth = [](double e, double z_star, double x0) {
    const ContactCounts counts{.mechanical_coordination_number = z_star, .rattler_fraction = x0};
    return z(effective::carried_contacts(spheres(e, 1e4), counts, 1e5).counts) - z_star;
  };
  CHECK(std::abs(growth(0.573, 4.38, 0.083) - 0.37) < 2 * 0.0552);
  CHECK(std::abs(growth(0.716, 4.285, 0.085) - 0.18) < 2 * 0.0552);
}

TEST_CASE("contact prior: the overlap is that of the mean force at its own contacts") {
  for (const double e : {0.5, 0.57, 0.65, 0.8})
    for (const double p : {1e3, 1e5, 1e7})
      for (const double alpha : {1.0, 2.0, infinity}) {
        State s = spheres(e, p);
        s.law = law_of(alpha, 0.15);
        for (const sizes::ContactMeans& means :
             {sizes::ContactMeans{},
              sizes::ContactMeans{
                  .branch = 0.9, .branch_square = 0.86, .pair_radius = 0.93, .grain_volume = 0.6}}) {
          s.contacts = means;
          const ContactPrior prior = effective::contact_prior(s, dense);
          CHECK(close(overlap_of(s, prior.middle), prior.relative_overlap, 1e-12));
        }
      }
}

TEST_CASE("contact prior: pressure counts over the modulus of the grains, and lengths do not count") {
  const ContactPrior prior = effective::contact_prior(spheres(0.6, 1e5), friction(0.3));
  State stiff = spheres(0.6, 8e5);
  stiff.law = law_of(2, 0.15, 5e-4, 8 * 30e9);
  State large = spheres(0.6, 1e5);
  large.radius = 1e-3;
  large.law = law_of(2, 0.15, 1e-3);
  for (const State& s : {stiff, large}) {
    const ContactPrior same = effective::contact_prior(s, friction(0.3));
    CHECK(close(z(same.middle), z(prior.middle), 1e-13));
    CHECK(close(same.middle.rattler_fraction, prior.middle.rattler_fraction, 1e-12));
  }
}

TEST_CASE("contact prior: a preparation narrows the range, and more friction means fewer contacts") {
  for (const double e : {0.56, 0.6, 0.65, 0.7}) {
    const State s = spheres(e, 1e5);
    const ContactPrior all = effective::contact_prior(s);
    for (const Preparation& preparation : {dense, loose, friction(0.1), friction(0.5)}) {
      const ContactPrior some = effective::contact_prior(s, preparation);
      CHECK(z(some.loosest) >= z(all.loosest) - 1e-12);
      CHECK(z(some.densest) <= z(all.densest) + 1e-12);
      CHECK(z(some.loosest) <= z(some.middle));
      CHECK(z(some.middle) <= z(some.densest));
    }
    CHECK(z(effective::contact_prior(s, friction(0.5)).middle) == z(all.loosest));
    CHECK(z(effective::contact_prior(s, friction(0.5)).middle) ==
          z(effective::contact_prior(s, loose).loosest));
    CHECK(z(effective::contact_prior(s, friction(0.3)).middle) ==
          z(effective::contact_prior(s, loose).densest));
    CHECK(z(effective::contact_prior(s, dense).middle) == z(all.densest));
    double before = z(all.densest) + 1e-12;
    for (const double mu : {1e-9, 0.02, 0.1, 0.3, 0.5, 1.0, 10.0}) {
      const double now = z(effective::contact_prior(s, friction(mu)).middle);
      CHECK(now <= before);
      before = now;
    }
    CHECK(before > 3.96);
  }
  // At 0.56 friction alone decides.
  CHECK(z(effective::contact_prior(spheres(0.56, 1e5), friction(1e-9)).middle) ==
        doctest::Approx(z(effective::contact_prior(spheres(0.56, 1e5), dense).middle)).epsilon(1e-6));
}

TEST_CASE("contact prior: denser is never softer, for any preparation, shape and pressure") {
  for (const double alpha : {1.0, 1.5, 2.0, 4.0, infinity})
    for (const double p : {1.0, 1e3, 1e4, 1e5, 2e6, 1e7, 1e9, 1e12})
      for (const Preparation& preparation :
           {Preparation{}, dense, loose, friction(1e-3), friction(0.02), friction(0.1), friction(0.3),
            friction(0.5), friction(1), friction(3)}) {
        double G_before = infinity, K_before = infinity, e_before = 0;
        // With more friction than minerals have one begins where packings of spheres do: closer than they can
        // be, a larger void ratio presses contacts faster (0.3 %) than it takes them away.
        for (double e = preparation.friction_coefficient > 0.5 ? 0.56 : 0.2; e < 1.5; e += 0.01) {
          const auto moduli = prepared(e, p, alpha, preparation);
          const double G = moduli.C44, K = moduli.bulk_modulus();
          CAPTURE(alpha);
          CAPTURE(p);
          CAPTURE(e_before);
          CAPTURE(preparation.friction_coefficient);
          REQUIRE(G <= G_before * (1 + 1e-9));
          REQUIRE(K <= K_before * (1 + 1e-9));
          std::tie(G_before, K_before, e_before) = std::tuple(G, K, e);
        }
      }
}

TEST_CASE("contact prior: more pressure is never softer, where contacts are not given") {
  for (const double alpha : {1.0, 2.0, infinity})
    for (const double e : {0.45, 0.6, 0.75, 0.95})
      for (const Preparation& preparation : {Preparation{}, dense, loose, friction(0.1), friction(0.5)}) {
        double before = 0;
        for (double p = 1e3; p < 2e7; p *= 1.3) {
          const auto moduli = prepared(e, p, alpha, preparation);
          const double G = moduli.C44;
          if (p > 0.01 * moduli.bulk_modulus()) // not nearly rigid any more
            break;
          CAPTURE(p);
          REQUIRE(G >= before * (1 - 1e-9));
          before = G;
        }
      }
}

TEST_CASE("contact prior: void ratios without sphere packings are reported, and the error grows") {
  const auto noted = [](double e) { return !effective::contact_prior(spheres(e, 1e5)).validity.ok(); };
  for (const double e : {0.56, 0.6, 0.7, 0.73, 0.8, 0.9, 0.45})
    CHECK(noted(e) == (e > 0.75 || e < 0.5));
  const auto error_at = [](double e) { return effective::contact_prior(spheres(e, 1e5)).coordination_error; };
  CHECK(error_at(0.65) < error_at(0.8));
  CHECK(error_at(0.8) < error_at(0.9));
  CHECK(error_at(0.5) < error_at(0.4));
  // Rigid grains: what is added to the scatter grows with the distance, on the dense side as z* of the
  // densest packings falls with e, on the loose side by one contact up to the loosest packing in theory.
  const auto added_at = [](double e) {
    const ContactPrior prior = effective::contact_prior(spheres(e, 0));
    return std::sqrt(std::pow(prior.coordination_error, 2) - std::pow(prior.packing_scatter, 2));
  };
  const auto densest_at = [](double e) { return z(effective::contact_prior(spheres(e, 0), dense).middle); };
  const double dense_slope = (densest_at(0.58) - densest_at(0.62)) / 0.04;
  CHECK((added_at(0.45) - added_at(0.5)) / 0.05 == relative(dense_slope, 0.15));
  CHECK((added_at(0.86) - added_at(0.80)) / 0.06 * (0.866 - 0.72) == relative(1, 0.15));
  CHECK(error_at(50) < 2.1);
  CHECK(error_at(1e-6) < 6.1);
}

TEST_CASE("contact prior: notes on friction, sizes and overlaps") {
  const auto notes = [](const State& s, const Preparation& preparation = {}) {
    return effective::contact_prior(s, preparation).validity.notes.size();
  };
  CHECK(notes(spheres(0.7, 1e5), friction(0.05)) == notes(spheres(0.7, 1e5), friction(0.5)) + 1);
  CHECK(notes(spheres(0.6, 1e9)) > notes(spheres(0.6, 1e5)));
  State unequal = spheres(0.5, 1e5);
  unequal.contacts.branch = 1.1;
  unequal.contacts.branch_square = 1.3;
  const ContactPrior prior = effective::contact_prior(unequal);
  CHECK(prior.validity.notes != effective::contact_prior(spheres(0.5, 1e5)).validity.notes);
  CHECK(prior.rattler_error == 1.5);
  CHECK(effective::contact_prior(spheres(0.6, 1e5)).rattler_error == effective::kernel::rattler_scatter);
  const std::string loose_note = effective::contact_prior(spheres(0.81234, 0)).validity.notes.front();
  CHECK((loose_note.find("0.812") != std::string::npos && loose_note.find("0.8123") == std::string::npos));
  int small = 0; // where friction is too little for the void ratio by more than two deviations
  for (double mu = 0.01; mu < 0.6; mu *= 1.01) {
    const auto& c = effective::kernel::contact_coefficients;
    const bool too_small =
        effective::kernel::rigid_contacts_of_friction(mu, c) >
        effective::kernel::densest_rigid_contacts(0.65, c) + 2 * effective::kernel::friction_scatter;
    CHECK(notes(spheres(0.65, 0), friction(mu)) == (too_small ? 1 : 0));
    small += too_small;
  }
  CHECK((small > 10 && small < 400));
  // Overlaps before and after a change of stress are noted from 0.01 diameters on.
  const ContactCounts counts{.mechanical_coordination_number = 5, .rattler_fraction = 0.02};
  for (double p = 1e6; p < 1e9; p *= 1.05) {
    const auto there = effective::carried_contacts(spheres(0.6, 1e5), counts, p);
    const auto back = effective::carried_contacts(spheres(0.6, p), counts, 1e5);
    CHECK(there.validity.notes.size() == (there.relative_overlap > 0.01 ? 1 : 0));
    CHECK(back.validity.notes.size() == (overlap_of(spheres(0.6, p), counts) > 0.01 ? 1 : 0));
  }
}

TEST_CASE(
    "contact prior: how far packings scatter, and the pressure up to which they were made without friction") {
  namespace k = effective::kernel;
  const auto prior = [](double e, Preparation preparation, double densest, double made_at = 0) {
    preparation.densest_void_ratio = densest;
    preparation.pressure = made_at;
    return effective::contact_prior(spheres(e, 1e5), preparation);
  };
  CHECK(prior(0.62, dense, 0).packing_scatter == k::line_scatter);
  for (const Preparation& other : {Preparation{}, loose, friction(0.3)})
    CHECK(prior(0.62, other, 0).packing_scatter == k::friction_scatter);
  CHECK(prior(0.62, loose, 0.57).packing_scatter ==
        relative(std::hypot(k::above_densest_scatter, k::above_densest_code_scatter), 1e-12));
  const auto at = [&](double pressure) { return z(prior(0.62, dense, 0.57, pressure).middle); };
  CHECK(at(0) == at(10e3)); // where it is not known
  CHECK(at(0.5) != at(0));
  CHECK(std::abs(at(0.5) - at(2)) < std::abs(at(0.5) - at(0)) / 10);
  State unequal = spheres(0.6, 1e5);
  unequal.contacts.branch = 1.1;
  unequal.contacts.branch_square = 1.3;
  const auto refused = [](const State& s, double densest) {
    Preparation preparation = loose;
    preparation.densest_void_ratio = densest;
    return refusals([&] { effective::require_valid(preparation, s); });
  };
  check_threshold(0.5, [&](double densest) { return refused(spheres(0.6, 1e5), densest); });
  check_threshold(0.2, [&](double densest) { return refused(unequal, densest); });
  check_threshold(1.02 * 1.6 - 1, [&](double densest) { return refused(unequal, densest); });
}

TEST_CASE("contact prior: rattlers of z* are those of the prior, and fewer the more contacts there are") {
  const ContactPrior prior = effective::contact_prior(spheres(0.65, 1e5), dense);
  CHECK(close(effective::typical_rattler_fraction(z(prior.middle), prior.relative_overlap),
              prior.middle.rattler_fraction, 1e-9));
  CHECK(effective::typical_rattler_fraction(4.38, 6.5e-5) == doctest::Approx(0.083).epsilon(0.3));
  CHECK(effective::typical_rattler_fraction(6.08, 5e-5) < effective::typical_rattler_fraction(4.38, 5e-5));
  CHECK(effective::typical_rattler_fraction(0, 0) == 0.9);
  CHECK_THROWS_AS((void)effective::typical_rattler_fraction(-1, 0), InvalidArgument);
  // Without pressure the contacts are those of rigid grains.
  const ContactPrior rigid = effective::contact_prior(spheres(0.56, 0), dense);
  CHECK((z(rigid.middle) == 6 && rigid.relative_overlap == 0));
}

TEST_CASE("contact prior: to another stress and back") {
  for (const double z_star : {4.3, 5.0, 6.2}) // the last above the densest line
    for (const double e : {0.572, 0.6, 0.7}) {
      const State start = spheres(e, 1e4);
      const ContactCounts counts{.mechanical_coordination_number = z_star, .rattler_fraction = 0.04};
      const auto there = effective::carried_contacts(start, counts, 1e5);
      CHECK(z(there.counts) > z_star);
      CHECK(there.counts.rattler_fraction < 0.04);
      CHECK(there.void_ratio < e);
      CHECK(there.relative_overlap ==
            doctest::Approx(overlap_of(spheres(there.void_ratio, 1e5), there.counts)));
      const auto back = effective::carried_contacts(spheres(there.void_ratio, 1e5), there.counts, 1e4);
      CHECK(close(z(back.counts), z_star, 1e-9));
      CHECK(close(back.counts.rattler_fraction, 0.04, 1e-9));
      CHECK(close(back.void_ratio, e, 1e-9));
    }
}

TEST_CASE("contact prior: a packing of the densest line is on it at every stress") {
  const ContactPrior prior = effective::contact_prior(spheres(0.65, 1e4), dense);
  const auto carried = effective::carried_contacts(spheres(0.65, 1e4), prior.middle, 1e6);
  const ContactPrior there = effective::contact_prior(spheres(carried.void_ratio, 1e6), dense);
  CHECK(close(z(carried.counts), z(there.middle), 1e-9));
  CHECK(close(carried.counts.rattler_fraction, there.middle.rattler_fraction, 1e-9));
}

TEST_CASE(
    "contact prior: the error of a change of stress is that of a random walk in the root of the overlap") {
  const ContactCounts counts{.mechanical_coordination_number = 4.5, .rattler_fraction = 0.05};
  const State start = spheres(0.6, 1e4);
  CHECK(effective::carried_contacts(start, counts, 1e4).coordination_error < 1e-6);
  const auto near = effective::carried_contacts(start, counts, 1e5);
  const auto far = effective::carried_contacts(start, counts, 1e6);
  const auto onward = effective::carried_contacts(spheres(near.void_ratio, 1e5), near.counts, 1e6);
  const auto back = effective::carried_contacts(spheres(near.void_ratio, 1e5), near.counts, 1e4);
  CHECK(near.coordination_error == doctest::Approx(0.0464).epsilon(0.05)); // spheres of 30 GPa
  CHECK(far.coordination_error ==
        doctest::Approx(std::hypot(near.coordination_error, onward.coordination_error)).epsilon(1e-9));
  CHECK(back.coordination_error == doctest::Approx(near.coordination_error).epsilon(1e-9));
}

TEST_CASE("contact prior: the densest packing of the same grains is the measure of the void ratio") {
  const auto z_of = [](double e, double densest, const effective::Preparation& like) {
    effective::Preparation preparation = like;
    preparation.densest_void_ratio = densest;
    return effective::contact_prior(spheres(e, 1e5), preparation).middle.mechanical_coordination_number;
  };
  // The densest packing has its z* whatever its void ratio is.
  for (const double densest : {0.5, 0.56, 0.575})
    CHECK(z_of(densest, densest, dense) ==
          doctest::Approx(z_of(0.56912606, 0.56912606, dense)).epsilon(3e-3));
  CHECK(z_of(0.62, 0.575, loose) > z_of(0.62, 0.56, loose));
  // None of spheres: not used, and noted.
  CHECK(z_of(0.62, 0.6, loose) == z_of(0.62, 0, loose));
  effective::Preparation sand = loose;
  sand.densest_void_ratio = 0.6;
  CHECK_FALSE(effective::contact_prior(spheres(0.62, 1e5), sand).validity.ok());
}

TEST_CASE("contact prior: a preparation that the state cannot have had is refused") {
  const auto refused = [](const State& s, const effective::Preparation& preparation) {
    try {
      (void)effective::contact_prior(s, preparation);
      return std::string();
    } catch (const InvalidArgument& error) {
      return error.refused().value().name;
    }
  };
  effective::Preparation made = dense;
  made.pressure = 1e5;
  CHECK(refused(spheres(0.6, 1e5), made) == "");
  CHECK(refused(spheres(0.6, 0.999e5), made) == "pressure of preparation");
  CHECK(refused(spheres(0.6, 0), made) == ""); // without stress there are no forces
  effective::Preparation of_densest = loose;
  of_densest.densest_void_ratio = 0.5;
  CHECK(refused(spheres(0.6, 1e5), of_densest) == "");
  of_densest.densest_void_ratio = 0.499;
  CHECK(refused(spheres(0.6, 1e5), of_densest) == "least_void_ratio");
  of_densest.densest_void_ratio = 0.57; // denser than the densest, by more than overlaps explain
  CHECK(refused(spheres(0.53, 1e5), of_densest) == "least_void_ratio");
}

TEST_CASE("contact prior: preparations as text, and refused texts") {
  CHECK(effective::preparation_of("dense") == dense);
  CHECK(effective::preparation_of("dense:10kPa") ==
        effective::Preparation{.kind = effective::Preparation::Kind::dense, .pressure = 10e3});
  CHECK(effective::preparation_of("loose") == loose);
  CHECK(effective::preparation_of("friction:0.3") == friction(0.3));
  for (const char* text : {"", "tapped", "friction", "friction:", "dense:", "dense:10", "dense:0kPa",
                           "dense:-1kPa", "loose:10kPa", "friction:-0.1", "friction:0", "friction:nan"})
    CHECK_THROWS_AS((void)effective::preparation_of(text), InvalidArgument);
  CHECK_THROWS_AS((void)effective::contact_prior(spheres(0, 1e5)), InvalidArgument);
  CHECK_THROWS_AS((void)effective::contact_prior(spheres(0.6, -1)), InvalidArgument);
  CHECK_THROWS_AS((void)effective::contact_prior(spheres(0.6, 1e5), friction(0)), InvalidArgument);
  const ContactCounts counts{.mechanical_coordination_number = 5, .rattler_fraction = 0.02};
  CHECK_THROWS_AS((void)effective::carried_contacts(spheres(0.6, 1e5), {}, 1e6), InvalidArgument);
  CHECK_THROWS_AS((void)effective::carried_contacts(spheres(0.6, 1e5), counts, -1), InvalidArgument);
}

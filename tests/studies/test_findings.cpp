// SPDX-License-Identifier: GPL-3.0-or-later
#include "studies/verify/findings.hpp"
#include "studies/verify/seed_mean.hpp"

#include <cmath>
#include <functional>

#include <doctest/doctest.h>

#include "relative.hpp"
#include "synthetic_study.hpp"

using namespace granum;
using namespace granum::studies;
using contact::Shape;
using granum::studies::test::power_law_specimen;
using triaxial::Density;

namespace {

const std::vector<double> pressures{10e3, 20e3, 40e3, 100e3};

Scene sphere_scene() {
  Scene scene;
  scene.study.contacts = {Shape::sphere};
  scene.study.pressures = pressures;
  return scene;
}

SpecimenResult sphere(Density density, double s, std::uint64_t seed = 1) {
  return power_law_specimen(Shape::sphere, density, seed, s, pressures);
}

/// Gives G of the network this ratio to that of uniform strain.
void set_ratio(CompressedState& state, double ratio) {
  test::set_uniform_strain(state, state.uniform_strain().bulk_modulus(),
                           state.network().shear_modulus() / ratio);
}

double ratio_of(const CompressedState& state) {
  return state.network().shear_modulus() / state.uniform_strain().shear_modulus();
}

/// Makes G of the network larger by a factor.
void scale_G(CompressedState& state, double factor) {
  test::set_network(state, state.network().bulk_modulus(), factor * state.network().shear_modulus());
}

/// A study of which every claim holds, with its 8 states on one curve of z*: 1 + z/50 + z^2/100 - z^3/200.
std::vector<SpecimenResult> sound_study(double dense_s = 1.0 / 3, double loose_s = 0.5) {
  std::vector<SpecimenResult> study{sphere(Density::dense, dense_s), sphere(Density::loose, loose_s)};
  for (std::size_t k = 0; k < 8; ++k) {
    CompressedState& state = study[k / 4].states[k % 4];
    const double z = state.packing.counts.mechanical.coordination_number = 4 + 0.25 * static_cast<double>(k);
    set_ratio(state, 1 + z / 50 + z * z / 100 - z * z * z / 200);
  }
  return study;
}

/// Whether the one verdict with these words holds, all others holding anyway.
bool holds(const std::vector<SpecimenResult>& study, const std::string& words,
           const Scene& scene = sphere_scene()) {
  int found = 0;
  bool result = false;
  for (const Verdict& verdict : verdicts(scene, study))
    if (verdict.claim.find(words) != std::string::npos) {
      ++found;
      result = verdict.holds;
      CHECK_FALSE(verdict.measured.empty());
    } else {
      INFO(verdict.claim, ": ", verdict.measured);
      CHECK(verdict.holds);
    }
  INFO(words);
  REQUIRE(found == 1);
  return result;
}

/// The same after a change of one state, of a loose specimen.
bool holds_after(const std::string& words, const std::function<void(CompressedState&)>& change) {
  std::vector<SpecimenResult> study = sound_study();
  change(study[1].states[2]);
  return holds(study, words);
}

} // namespace

TEST_CASE("exponents are those of exact power laws") {
  Scene scene;
  scene.study.pressures = pressures;
  std::vector<SpecimenResult> study;
  double s = 0.02;
  for (const Shape shape : scene.study.contacts)
    for (const Density density : scene.study.densities)
      study.push_back(power_law_specimen(shape, density, 1, s += 0.07, pressures));
  const std::vector<ExponentRow> rows = exponents(scene, study);
  REQUIRE(rows.size() == study.size());
  s = 0.02;
  for (std::size_t k = 0; k < rows.size(); ++k) {
    s += 0.07;
    CHECK(rows[k].contact == study[k].contact);
    CHECK(rows[k].density == study[k].density);
    // Levenberg-Marquardt stops at relative steps of 1e-10 or better; void ratio does not change here.
    for (const auto& [found, route] : {std::pair(rows[k].closed_form, ExponentRoute::closed_form),
                                       std::pair(rows[k].network, ExponentRoute::network),
                                       std::pair(rows[k].network_void, ExponentRoute::network),
                                       std::pair(rows[k].probe, ExponentRoute::probe)}) {
      REQUIRE(found);
      CHECK(found->value == relative(s, 1e-9));
      // An exact law leaves no regression error, and so what is known of the scatter.
      const KnownScatter known =
          exponent_scatter(rows[k].contact, rows[k].density, route, scene.study.grains);
      CHECK(found->standard_error == relative(known.deviation, 1e-6));
    }
    CHECK(rows[k].paper.has_value());
  }
  CHECK(rows[0].contact_law == relative(1.0 / 2, 1e-14));
  CHECK(rows[2].contact_law == relative(1.0 / 3, 1e-14));
  CHECK(rows[4].contact_law == 0);
  // G_hv of [Chung2014], Table 5: s, not m or n
  CHECK(rows[0].paper == 0.510);
  CHECK(rows[3].paper == 0.533);
}

TEST_CASE("each route takes its own modulus") {
  SpecimenResult specimen = sphere(Density::dense, 0.2);
  for (CompressedState& state : specimen.states) {
    const double p = state.pressure / 100e3;
    state.G_closed = 1e8 * std::pow(p, 0.3);
    // The mean of the probes follows p^0.4, none of them does.
    const double mean = 1e8 * std::pow(p, 0.4);
    state.probes = Probes{mean * (1 + 0.1 * p), mean * (1 - 0.3 * p), mean * (1 + 0.2 * p), 1e-6};
  }
  const ExponentRow row = exponents(sphere_scene(), {specimen}).front();
  CHECK(row.closed_form->value == relative(0.3, 1e-9));
  CHECK(row.network->value == relative(0.2, 1e-9));
  CHECK(row.probe->value == relative(0.4, 1e-9));
}

TEST_CASE("with f(e) the exponent is that at constant void ratio") {
  SpecimenResult specimen = sphere(Density::loose, 0.3);
  for (CompressedState& state : specimen.states) {
    const double e = state.packing.void_ratio = 0.62 - 0.02 * std::log10(state.pressure / 10e3);
    scale_G(state, (2.17 - e) * (2.17 - e) / (1 + e));
  }
  const ExponentRow row = exponents(sphere_scene(), {specimen}).back();
  REQUIRE(row.density == Density::loose);
  CHECK(row.network_void->value == relative(0.3, 1e-9));
  CHECK(row.network->value > 0.31); // densification counts as stress
}

TEST_CASE("one seed: the known scatter, or the regression error if larger") {
  const double known =
      exponent_scatter(Shape::sphere, Density::dense, ExponentRoute::network, sphere_scene().study.grains)
          .deviation;
  SpecimenResult specimen = sphere(Density::dense, 0.3);
  const auto error = [&] { return exponents(sphere_scene(), {specimen}).front().network->standard_error; };
  CHECK(error() == relative(known, 1e-9));
  scale_G(specimen.states[1], 1.05);
  CHECK(error() > 2 * known);
}

TEST_CASE("several seeds: the mean, and their scatter pooled with the known scatter") {
  const std::vector<SpecimenResult> study{sphere(Density::dense, 0.30, 1), sphere(Density::dense, 0.34, 2),
                                          sphere(Density::dense, 0.38, 3)};
  const Measured s = exponents(sphere_scene(), study).front().network.value();
  CHECK(s.value == relative(0.34, 1e-9));
  const KnownScatter known =
      exponent_scatter(Shape::sphere, Density::dense, ExponentRoute::network, sphere_scene().study.grains);
  // deviation of 0.04 among 3
  const double pooled =
      std::sqrt((2 * 0.04 * 0.04 + known.degrees * known.deviation * known.deviation) / (2 + known.degrees));
  CHECK(s.standard_error == relative(pooled / std::sqrt(3), 1e-7));
}

TEST_CASE("several seeds that agree: the mean regression error") {
  SpecimenResult specimen = sphere(Density::dense, 0.3);
  scale_G(specimen.states[1], 1.05);
  const Scene scene = sphere_scene();
  const Measured one = exponents(scene, {specimen}).front().network.value();
  const Measured four = exponents(scene, {specimen, specimen, specimen, specimen}).front().network.value();
  CHECK(one.standard_error > 4e-3); // more than is known of the scatter
  CHECK(four.value == relative(one.value, 1e-14));
  CHECK(four.standard_error == relative(one.standard_error / 2, 1e-12));
}

TEST_CASE("fewer than three states or probes give no exponent") {
  SpecimenResult specimen = sphere(Density::dense, 0.3);
  specimen.states[0].probes.reset();
  specimen.states[2].probes.reset();
  const ExponentRow row = exponents(sphere_scene(), {specimen}).front();
  CHECK(row.network.has_value());
  CHECK_FALSE(row.probe.has_value());
  specimen.states.resize(2);
  const std::vector<ExponentRow> rows = exponents(sphere_scene(), {specimen});
  REQUIRE(rows.size() == 2); // a row each, empty
  for (const ExponentRow& empty : rows)
    CHECK_FALSE((empty.closed_form || empty.network || empty.network_void || empty.probe));
  // A specimen that ended early leaves the mean to the others.
  const ExponentRow mixed = exponents(sphere_scene(), {specimen, sphere(Density::dense, 0.35, 2)}).front();
  CHECK(mixed.network->value == relative(0.35, 1e-9));
}

TEST_CASE("a shape of one's own has no exponent of the paper's") {
  Scene scene = sphere_scene();
  scene.study.contacts = {Shape::power_law};
  const ExponentRow row = exponents(scene, {}).front();
  CHECK_FALSE(row.paper.has_value());
  CHECK(row.contact_law == relative(0.4, 1e-14));
}

TEST_CASE("relaxation curve: a cubic is met, a deviation from it is measured") {
  std::vector<SpecimenResult> study = sound_study();
  const RelaxationCurve exact = relaxation_curve(study).value();
  CHECK(exact.states == 8);
  CHECK(exact.rms < 1e-13); // eight ratios near 1, rounding only
  // The seventh difference of equidistant points is orthogonal to every cubic: the whole of it remains.
  // Root of the mean of the squares of 1, -7, 21, -35, 35, ...: sqrt(C(14,7)/8) = sqrt(429).
  const double difference[] = {1, -7, 21, -35, 35, -21, 7, -1};
  for (std::size_t k = 0; k < 8; ++k) {
    CompressedState& state = study[k / 4].states[k % 4];
    set_ratio(state, ratio_of(state) + 1e-3 * difference[k]);
  }
  CHECK(relaxation_curve(study).value().rms == relative(1e-3 * std::sqrt(429.0), 1e-9));
  study[1].states.pop_back();
  CHECK_FALSE(relaxation_curve(study).has_value());
  CHECK_FALSE(relaxation_curve({}).has_value());
}

TEST_CASE("a correct study confirms every claim") {
  const std::vector<Verdict> all = verdicts(sphere_scene(), sound_study());
  CHECK(all.size() == 9);
  for (const Verdict& verdict : all) {
    INFO(verdict.claim, ": ", verdict.measured);
    CHECK(verdict.holds);
  }
}

TEST_CASE("verdict on dense specimens: s from 0.01 below to 0.05 above the contact law's") {
  const double law = 1.0 / 3;
  CHECK(holds(sound_study(law - 0.0099), "dense sphere"));
  CHECK_FALSE(holds(sound_study(law - 0.0101), "dense sphere"));
  CHECK(holds(sound_study(law + 0.0499, 0.6), "dense sphere"));
  CHECK_FALSE(holds(sound_study(law + 0.0501, 0.6), "dense sphere"));
}

TEST_CASE("verdict on loose specimens: s larger than dense by 0.12") {
  CHECK(holds(sound_study(0.34, 0.4601), "loose sphere"));
  CHECK_FALSE(holds(sound_study(0.34, 0.4599), "loose sphere"));
}

TEST_CASE("a claim whose limit is within the standard error of s is undecided, and no difference") {
  const auto of = [](double dense, double loose, const std::string& words) {
    for (const Verdict& verdict : verdicts(sphere_scene(), sound_study(dense, loose)))
      if (verdict.claim.find(words) != std::string::npos)
        return verdict;
    FAIL("no verdict on ", words);
    return Verdict{};
  };
  const std::size_t grains = sphere_scene().study.grains;
  const double error =
      std::hypot(exponent_scatter(Shape::sphere, Density::dense, ExponentRoute::network, grains).deviation,
                 exponent_scatter(Shape::sphere, Density::loose, ExponentRoute::network, grains).deviation);
  for (const double beyond : {-1.01, -0.99, 0.99, 1.01}) {
    CAPTURE(beyond);
    const Verdict loose = of(0.34, 0.46 + beyond * error, "loose sphere");
    CHECK(loose.holds == (beyond > 0));
    CHECK(loose.decided == (std::abs(beyond) > 1));
    CHECK(std::string(word_of(loose)) == (std::abs(beyond) < 1 ? "undecided"
                                          : beyond > 0         ? "holds"
                                                               : "differs"));
    CHECK(differing_findings({loose}).size() == (beyond < -1 ? 1 : 0));
  }
  CHECK(of(0.34, 0.5, "dense sphere").decided);
  CHECK_FALSE(of(1.0 / 3 + 0.0499, 0.6, "dense sphere").decided);
  CHECK(std::string(word_of({"of granum", false, "", false, false})) == "FAILS");
}

TEST_CASE("verdict on the relaxation curve: rms 0.03") {
  const auto disturbed = [](double rms) {
    const double difference[] = {1, -7, 21, -35, 35, -21, 7, -1};
    std::vector<SpecimenResult> study = sound_study();
    for (std::size_t k = 0; k < 8; ++k) {
      CompressedState& state = study[k / 4].states[k % 4];
      set_ratio(state, ratio_of(state) + rms / std::sqrt(429.0) * difference[k]);
    }
    return study;
  };
  CHECK(holds(disturbed(0.0299), "one curve of z*"));
  CHECK_FALSE(holds(disturbed(0.0301), "one curve of z*"));
}

TEST_CASE("verdict on the bounds of K") {
  const char* words = "K(uniform stress, refined) <= K <= K(uniform strain)";
  const auto lower = [&](double over_K) {
    return holds_after(words, [=](CompressedState& s) {
      s.packing.network->bulk_bounds.lower = over_K * s.network().bulk_modulus();
    });
  };
  const auto upper = [&](double over_K) {
    return holds_after(words, [=](CompressedState& s) {
      test::set_uniform_strain(s, over_K * s.network().bulk_modulus(), s.uniform_strain().shear_modulus());
    });
  };
  CHECK(lower(1));
  CHECK_FALSE(lower(1 + 1e-8));
  CHECK(upper(1));
  CHECK_FALSE(upper(1 - 1e-8));
}

TEST_CASE(
    "verdict on the probes beside the network: 0.3 % if dense, 1 % if loose, more where grains are few") {
  const auto within = [&](std::size_t specimen, double part, std::size_t grains, bool across) {
    std::vector<SpecimenResult> study = sound_study();
    Probes& probes = *study[specimen].states[2].probes;
    if (across) {
      probes.G_hv *= 1 + part;
      probes.G_vh *= 1 + part;
    } else {
      probes.G_hh *= 1 + part;
    }
    Scene scene = sphere_scene();
    scene.study.grains = grains;
    return holds(study, specimen == 0 ? "dense: the moduli of probe" : "loose: the moduli of probe", scene);
  };
  for (const double sign : {1.0, -1.0})
    for (const bool across : {false, true})
      for (const std::size_t specimen : {0U, 1U}) {
        const double limit = sign * (specimen == 0 ? 0.003 : 0.01);
        CHECK(within(specimen, 0.99 * limit, 1000, across));
        CHECK_FALSE(within(specimen, 1.01 * limit, 1000, across));
        CHECK_FALSE(within(specimen, 1.01 * limit, 10000, across));
        CHECK(within(specimen, 4.95 * limit, 200, across));
        CHECK_FALSE(within(specimen, 5.05 * limit, 200, across));
      }
}

TEST_CASE(
    "verdict on the probes: with what forces add, and states that forces hold are left out and counted") {
  const char* claim = "loose: the moduli of probe";
  const auto with_terms = [&](double probed, double geometric, double shedding) {
    std::vector<SpecimenResult> study = sound_study();
    CompressedState& state = study[1].states[2];
    const double G = G_hh_network(state);
    test::set_force_terms(state, geometric * G, shedding * G);
    for (double* modulus : {&state.probes->G_hh, &state.probes->G_hv, &state.probes->G_vh})
      *modulus *= 1 + probed;
    return study;
  };
  CHECK_FALSE(holds(with_terms(0.012, 0, 0), claim));
  CHECK(holds(with_terms(0.012, 0.002, 0.003), claim));
  CHECK_FALSE(holds(with_terms(0.012, -0.002, 0.003), claim));
  CHECK(holds(with_terms(0.5, -0.3, 0), claim));
  for (const Verdict& verdict : verdicts(sphere_scene(), with_terms(0.5, -0.3, 0)))
    if (verdict.claim.starts_with(claim))
      CHECK(verdict.measured.ends_with("; 1 stable by forces only, left out"));
}

TEST_CASE("verdict on specimens at rest: three quarters, and the others by name") {
  const char* claim = "three quarters of the states";
  std::vector<SpecimenResult> study = sound_study(); // 8 states with probes
  study[1].left_out = {"10 kPa: a probe did not come to rest"};
  CHECK(holds(study, claim));
  for (const Verdict& verdict : verdicts(sphere_scene(), study))
    if (verdict.claim.starts_with(claim))
      CHECK(verdict.measured == "16 of 17; " + title(study[1]) + " at 10 kPa: a probe did not come to rest");
  study[1].left_out.assign(5, "10 kPa: why");
  CHECK(holds(study, claim)); // 16 of 21
  study[1].left_out.assign(6, "10 kPa: why");
  CHECK_FALSE(holds(study, claim)); // 16 of 22
}

TEST_CASE("verdict on G_hv = G_vh") {
  const char* symmetry = "G_hv = G_vh";
  for (const double sign : {1.0, -1.0}) {
    CHECK(holds_after(symmetry, [&](CompressedState& s) { s.probes->G_vh *= 1 + sign * 0.0098; }));
    CHECK_FALSE(holds_after(symmetry, [&](CompressedState& s) { s.probes->G_vh *= 1 + sign * 0.0102; }));
  }
}

TEST_CASE("verdict on the two routes to the pressure") {
  const char* words = "pressure by contacts";
  for (const double sign : {1.0, -1.0}) {
    CHECK(holds_after(words, [&](CompressedState& s) { *s.packing.pressure_by_work *= 1 + sign * 0.99e-6; }));
    CHECK_FALSE(
        holds_after(words, [&](CompressedState& s) { *s.packing.pressure_by_work *= 1 + sign * 1.01e-6; }));
  }
}

TEST_CASE("a specimen that ended early is a claim that fails, by its name and reason") {
  std::vector<SpecimenResult> study = sound_study();
  study[1].seed = 7;
  study[1].failure = "compression to 40 kPa ended early";
  CHECK_FALSE(holds(study, "sphere loose #7"));
  const Verdict last = verdicts(sphere_scene(), study).back();
  CHECK(last.measured == "compression to 40 kPa ended early");
  CHECK_FALSE(last.finding);
}

TEST_CASE("stopped specimens have no verdict, nor has s of a partial path") {
  std::vector<SpecimenResult> study = sound_study();
  study[1].failure = "stopped on request";
  bool of_dense = false;
  for (const Verdict& verdict : verdicts(sphere_scene(), study)) {
    CHECK_FALSE(verdict.claim.starts_with("loose sphere"));
    of_dense = of_dense || verdict.claim.starts_with("dense sphere");
  }
  CHECK(of_dense);
  CHECK(failed_checks(verdicts(sphere_scene(), study)).empty());
}

TEST_CASE("an s beyond the paper's differs, a broken identity fails") {
  std::vector<Verdict> all{{"a", true, "", true}, {"b", false, "", true}, {"c", false, ""}, {"d", true, ""}};
  REQUIRE(failed_checks(all).size() == 1);
  CHECK(failed_checks(all)[0].claim == "c");
  REQUIRE(differing_findings(all).size() == 1);
  CHECK(differing_findings(all)[0].claim == "b");
  for (const Verdict& verdict : verdicts(sphere_scene(), sound_study()))
    CHECK(verdict.finding == (verdict.claim.find(" sphere: s is ") != std::string::npos));
}

TEST_CASE("no verdict without data for it") {
  CHECK(verdicts(sphere_scene(), {}).empty());
  std::vector<SpecimenResult> study{sphere(Density::loose, 0.5)}; // no dense one to compare with, 4 states
  for (CompressedState& state : study[0].states)
    state.probes.reset();
  const std::vector<Verdict> all = verdicts(sphere_scene(), study);
  REQUIRE(all.size() == 3);
  CHECK(all[0].claim.starts_with("K("));
  CHECK(all[1].claim.starts_with("pressure"));
  CHECK(all[2].claim.starts_with("three quarters"));
}

// SPDX-License-Identifier: GPL-3.0-or-later
#include "studies/verify/findings.hpp"
#include "studies/verify/seed_mean.hpp"

#include <functional>
#include <set>
#include <tuple>

#include "synthetic_study.hpp"
#include "unit.hpp"

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

/// Makes G of the network larger by a factor.
void scale_G(CompressedState& state, double factor) {
  test::set_network(state, state.network().bulk_modulus(), factor * state.network().shear_modulus());
}

/// A study whose claims all hold, its 8 states on one curve of z*, 1 + z/50 + z^2/100 - z^3/200, and
/// off it by the seventh difference of equidistant points, which is orthogonal to every cubic: of the squares
/// of 1, -7, 21, -35, 35, ... the root of the mean is sqrt(C(14,7)/8) = sqrt(429).
std::vector<SpecimenResult> sound_study(double dense_s = 1.0 / 3, double loose_s = 0.5, double rms = 0) {
  constexpr double difference[] = {1, -7, 21, -35, 35, -21, 7, -1};
  std::vector<SpecimenResult> study{sphere(Density::dense, dense_s), sphere(Density::loose, loose_s)};
  for (std::size_t k = 0; k < 8; ++k) {
    CompressedState& state = study[k / 4].states[k % 4];
    const double z = state.packing.counts.mechanical.coordination_number = 4 + 0.25 * static_cast<double>(k);
    set_ratio(state, 1 + z / 50 + z * z / 100 - z * z * z / 200 + rms / std::sqrt(429.0) * difference[k]);
  }
  return study;
}

KnownScatter network_scatter(Density density) {
  return exponent_scatter(Shape::sphere, density, ExponentRoute::network, sphere_scene().study.grains);
}

/// Whether every verdict holds; if not, a single one fails.
bool holds(const std::vector<SpecimenResult>& study, const Scene& scene = sphere_scene()) {
  const std::vector<Verdict> all = verdicts(scene, study);
  CHECK(std::ranges::none_of(all, [](const Verdict& v) { return v.measured.empty(); }));
  const auto failing = std::ranges::count_if(all, [](const Verdict& v) { return !v.holds; });
  CHECK(failing <= 1);
  return failing == 0;
}

/// The same after a change of one state, of a loose specimen.
bool holds_after(const std::function<void(CompressedState&)>& change) {
  std::vector<SpecimenResult> study = sound_study();
  change(study[1].states[2]);
  return holds(study);
}

/// The verdicts that do not hold.
std::vector<Verdict> failing(const std::vector<SpecimenResult>& study) {
  std::vector<Verdict> all = verdicts(sphere_scene(), study);
  std::erase_if(all, [](const Verdict& v) { return v.holds; });
  return all;
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
    CHECK((rows[k].contact == study[k].contact && rows[k].density == study[k].density));
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
  }
  CHECK(rows[0].contact_law == relative(1.0 / 2, 1e-14));
  CHECK(rows[4].contact_law == 0);
  // G_hv of [Chung2014], Table 5: s, not m or n
  CHECK(rows[0].paper == 0.510);
  CHECK(rows[3].paper == 0.533);
  scene.study.contacts = {Shape::power_law};
  CHECK_FALSE(exponents(scene, {}).front().paper.has_value());
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

TEST_CASE(
    "one seed: the known scatter, or the regression error if larger, and the mean of several that agree") {
  const double known = network_scatter(Density::dense).deviation;
  SpecimenResult specimen = sphere(Density::dense, 0.3);
  const auto found = [&](std::size_t seeds) {
    return exponents(sphere_scene(), std::vector(seeds, specimen)).front().network.value();
  };
  CHECK(found(1).standard_error == relative(known, 1e-9));
  scale_G(specimen.states[1], 1.05);
  CHECK(found(1).standard_error > 2 * known);
  CHECK(found(4).value == relative(found(1).value, 1e-14));
  CHECK(found(4).standard_error == relative(found(1).standard_error / 2, 1e-12));
}

TEST_CASE("several seeds: the mean, and their scatter pooled with the known scatter") {
  const std::vector<SpecimenResult> study{sphere(Density::dense, 0.30, 1), sphere(Density::dense, 0.34, 2),
                                          sphere(Density::dense, 0.38, 3)};
  const Measured s = exponents(sphere_scene(), study).front().network.value();
  CHECK(s.value == relative(0.34, 1e-9));
  const KnownScatter known = network_scatter(Density::dense);
  // deviation of 0.04 among 3
  const double pooled =
      std::sqrt((2 * 0.04 * 0.04 + known.degrees * known.deviation * known.deviation) / (2 + known.degrees));
  CHECK(s.standard_error == relative(pooled / std::sqrt(3), 1e-7));
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

TEST_CASE("relaxation curve: a cubic is met, a deviation from it is measured") {
  std::vector<SpecimenResult> study = sound_study(1.0 / 3, 0.5, 0.02);
  CHECK(relaxation_curve(study).value().states == 8);
  CHECK(relaxation_curve(study).value().rms == relative(0.02, 1e-9));
  CHECK(relaxation_curve(sound_study()).value().rms < 1e-13); // eight ratios near 1, rounding only
  study[1].states.pop_back();
  CHECK_FALSE(relaxation_curve(study).has_value());
  CHECK_FALSE(relaxation_curve({}).has_value());
}

TEST_CASE("a sound study confirms every claim, and each claim fails just beyond its limit") {
  CHECK(verdicts(sphere_scene(), sound_study()).size() == 9);
  CHECK(holds(sound_study()));
  // s of dense specimens from 0.01 below to 0.05 above the contact law's, that of loose ones larger by 0.12
  constexpr double law = 1.0 / 3;
  for (const auto& [dense, loose, rms, sound] : {std::tuple{law - 0.0099, 0.5, 0.0, true},
                                                 {law - 0.0101, 0.5, 0.0, false},
                                                 {law + 0.0499, 0.6, 0.0, true},
                                                 {law + 0.0501, 0.6, 0.0, false},
                                                 {0.34, 0.4601, 0.0, true},
                                                 {0.34, 0.4599, 0.0, false},
                                                 {law, 0.5, 0.0299, true},
                                                 {law, 0.5, 0.0301, false}})
    CHECK(holds(sound_study(dense, loose, rms)) == sound);
  for (const auto& [lower, upper, sound] :
       {std::tuple{1.0, 1.15, true}, {1 + 1e-8, 1.15, false}, {0.9, 1.0, true}, {0.9, 1 - 1e-8, false}})
    CHECK(holds_after([&, low = lower, high = upper](CompressedState& s) {
            const double K = s.network().bulk_modulus();
            s.packing.network->bulk_bounds.lower = low * K;
            test::set_uniform_strain(s, high * K, s.uniform_strain().shear_modulus());
          }) == sound);
  for (const double sign : {1.0, -1.0}) {
    for (const auto& [part, sound] : {std::pair{0.0098, true}, {0.0102, false}})
      CHECK(holds_after([factor = 1 + sign * part](CompressedState& s) { s.probes->G_vh *= factor; }) ==
            sound);
    for (const auto& [part, sound] : {std::pair{0.99e-6, true}, {1.01e-6, false}})
      CHECK(holds_after([factor = 1 + sign * part](CompressedState& s) {
              *s.packing.pressure_by_work *= factor;
            }) == sound);
  }
}

TEST_CASE("a claim whose limit is within the standard error of s is undecided, and no difference") {
  const double error =
      std::hypot(network_scatter(Density::dense).deviation, network_scatter(Density::loose).deviation);
  for (const double beyond : {-1.01, -0.99, 0.99, 1.01}) {
    CAPTURE(beyond);
    const std::vector<Verdict> all = verdicts(sphere_scene(), sound_study(0.34, 0.46 + beyond * error));
    const auto undecided = std::ranges::count_if(all, [](const Verdict& v) { return !v.decided; });
    CHECK(std::ranges::all_of(all, &Verdict::holds) == (beyond > 0));
    CHECK(undecided == (std::abs(beyond) < 1 ? 1 : 0));
    CHECK(differing_findings(all).size() == (beyond < -1 ? 1 : 0));
  }
  const auto words = {word_of({"", true, "", true, true}), word_of({"", false, "", true, true}),
                      word_of({"", true, "", true, false}), word_of({"", false, "", false, false})};
  CHECK(std::set<std::string>(words.begin(), words.end()).size() == 4);
}

TEST_CASE(
    "verdict on the probes beside the network: 0.3 % if dense, 1 % if loose, more where grains are few") {
  const auto within = [&](std::size_t specimen, double part, std::size_t grains, bool across) {
    std::vector<SpecimenResult> study = sound_study();
    Probes& probes = *study[specimen].states[2].probes;
    for (double* modulus : across ? std::vector{&probes.G_hv, &probes.G_vh} : std::vector{&probes.G_hh})
      *modulus *= 1 + part;
    Scene scene = sphere_scene();
    scene.study.grains = grains;
    return holds(study, scene);
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

TEST_CASE("verdict on the probes: with what forces add, and states that forces hold are left out") {
  const auto with_terms = [&](double probed, double geometric, double shedding) {
    std::vector<SpecimenResult> study = sound_study();
    CompressedState& state = study[1].states[2];
    const double G = G_hh_network(state);
    test::set_force_terms(state, geometric * G, shedding * G);
    for (double* modulus : {&state.probes->G_hh, &state.probes->G_hv, &state.probes->G_vh})
      *modulus *= 1 + probed;
    return study;
  };
  CHECK_FALSE(holds(with_terms(0.012, 0, 0)));
  CHECK(holds(with_terms(0.012, 0.002, 0.003)));
  CHECK_FALSE(holds(with_terms(0.012, -0.002, 0.003)));
  CHECK(holds(with_terms(0.5, -0.3, 0)));
  for (const std::ptrdiff_t judged : {2, 1, 0}) { // states of the loose specimen, and one that is left out
    std::vector<SpecimenResult> study = with_terms(0.5, -0.3, 0);
    study[1].states = {study[1].states.begin() + 2 - judged, study[1].states.begin() + 3};
    CHECK(std::ranges::any_of(verdicts(sphere_scene(), study), [](const Verdict& v) {
            return v.measured.find("; 1 ") != std::string::npos;
          }) == (judged > 0));
  }
}

TEST_CASE("verdict on specimens at rest: three quarters of the states") {
  std::vector<SpecimenResult> study = sound_study(); // 8 states with probes
  study[1].left_out.assign(5, "10 kPa: why");
  CHECK(holds(study)); // 16 of 21
  study[1].left_out.assign(6, "10 kPa: why");
  CHECK_FALSE(holds(study)); // 16 of 22
  CHECK(failing(study)[0].measured.starts_with("16 of 22"));
}

TEST_CASE("a specimen that ended early and a broken identity fail, an s beyond the paper only differs") {
  std::vector<SpecimenResult> study = sound_study();
  study[1].seed = 7;
  study[1].failure = "compression to 40 kPa ended early";
  const std::vector<Verdict> failed = failing(study);
  REQUIRE(failed.size() == 1);
  CHECK(failed[0].claim.find("#7") != std::string::npos);
  CHECK(failed[0].measured == study[1].failure);
  CHECK_FALSE(failed[0].finding);
  const std::vector<Verdict> all{
      {"a", true, "", true}, {"b", false, "", true}, {"c", false, ""}, {"d", true, ""}};
  REQUIRE(failed_checks(all).size() == 1);
  CHECK(failed_checks(all)[0].claim == "c");
  REQUIRE(differing_findings(all).size() == 1);
  CHECK(differing_findings(all)[0].claim == "b");
}

TEST_CASE("stopped specimens have no verdict, nor has s of a partial path, nor has anything without data") {
  std::vector<SpecimenResult> study = sound_study();
  const auto with_loose = verdicts(sphere_scene(), study).size();
  study[1].failure = "stopped on request";
  const std::vector<Verdict> all = verdicts(sphere_scene(), study);
  CHECK(all.size() < with_loose);
  CHECK(std::ranges::count_if(all, &Verdict::finding) == 1); // s of the dense one
  CHECK(failed_checks(all).empty());
  CHECK(verdicts(sphere_scene(), {}).empty());
  study = {sphere(Density::loose, 0.5)}; // no dense one to compare with, 4 states
  for (CompressedState& state : study[0].states)
    state.probes.reset();
  CHECK(verdicts(sphere_scene(), study).size() == 3);
}

// SPDX-License-Identifier: GPL-3.0-or-later
#include <granum/elastic/waves.hpp>
#include <granum/inverse/inference.hpp>

#include <granum/core/stop.hpp>
#include <granum/core/text.hpp>
#include <granum/effective/contact_prior.hpp>
#include <granum/estimate/answer.hpp>

#include "inferences.hpp"
#include "inverse/contact_model.hpp"
#include "unit.hpp"

using namespace inferences;

TEST_CASE("inference: forward and back is the identity") {
  for (const auto& row : inverse::quantities())
    for (const double z : {4.3, 5.1, 6.2})
      for (const double ratio : {1.0, 0.5}) {
        const Observation one = measurement(row.quantity, beads(3e6, ratio * 3e6), z, 0.02);
        const auto answer = infer(std::span(&one, 1), options_with());
        REQUIRE(answer.together);
        const auto found = answer.together->packing(one.state);
        CHECK(found.mechanical_coordination_number.value == relative(z, 1e-10));
        const double rattlers = effective::expected_rattlers(one.state, z).fraction;
        CHECK(found.rattler_fraction.value == relative(rattlers, 1e-9));
        CHECK(answer.alone.front().mechanical_coordination_number->value == relative(z, 1e-10));
        for (const auto& other : inverse::quantities()) {
          const State elsewhere = beads(50e3, 80e3, 0.58);
          CHECK(answer.together->predict(other.quantity, elsewhere).value ==
                relative(value_of(other.quantity, elsewhere, z, rattlers), 1e-9));
        }
      }
}

TEST_CASE("inference: measurements of one packing agree, and narrow the error") {
  std::vector<Observation> all;
  const double rattlers = effective::expected_rattlers(beads(1e6), 5.2).fraction;
  for (const double p : {1e6, 3e6, 10e6})
    for (const Quantity q : {Quantity::V_s, Quantity::V_p}) {
      const double value = value_of(q, beads(p), 5.2, rattlers);
      all.push_back({q, {value, 0.02 * value}, beads(p)});
    }
  const auto together = infer(all, options_with());
  REQUIRE(together.together);
  const Measured z = together.together->packing(all.front().state).mechanical_coordination_number;
  CHECK(z.value == relative(5.2, 1e-10));
  CHECK(z.standard_error < together.alone.front().mechanical_coordination_number->standard_error);
  CHECK(together.together->chi_square() < 1e-15);
  CHECK(together.together->degrees_of_freedom() == 5);
  CHECK(together.together->probability() == doctest::Approx(1));
  CHECK(together.validity.ok());
  double sum = 0;
  for (const auto& share : together.together->error_shares())
    sum += share.share;
  CHECK(sum == relative(1, 1e-9));
}

TEST_CASE("inference: the growth of z* is fitted on request") {
  const double isostatic = effective::isostatic_coordination_number(beads(1e6).tangential_ratio);
  const auto grown = [&](double p) { return isostatic + 0.8 * std::pow(p / 1e6, 0.13); };
  std::vector<Observation> all;
  for (const double p : {1e6, 2e6, 8e6})
    all.push_back(measurement(Quantity::V_s, beads(p), grown(p), 0.01));
  const auto answer = infer(all, options_with(GrowthRule::fitted));
  REQUIRE(answer.together);
  CHECK(answer.together->growth_exponent()->value == relative(0.13, 1e-9));
  CHECK(answer.together->predict(Quantity::G_vh, beads(30e6)).value ==
        relative(value_of(Quantity::G_vh, beads(30e6), grown(30e6)), 1e-9));
  CHECK(answer.together->degrees_of_freedom() == 1);
  // With one z* for all the same data do not fit.
  const auto fixed = infer(all, options_with());
  CHECK(fixed.together->chi_square() > 1);
  CHECK_FALSE(fixed.together->growth_exponent());
  CHECK_THROWS_AS((void)infer(std::span(all).first(1), options_with(GrowthRule::fitted)), InvalidArgument);
  // Stresses too close, and a growth that no packing has.
  const auto second = [&](double p, double z) {
    return infer(std::vector{all.front(), measurement(Quantity::V_s, beads(p), z, 0.01)},
                 options_with(GrowthRule::fitted));
  };
  CHECK_THROWS_AS((void)second(1.01e6, 4.8), InvalidArgument);
  CHECK_THROWS_AS((void)second(1.6e6, isostatic + 0.8 * std::pow(1.6, 2.5)), InvalidArgument);
}

TEST_CASE(
    "inference: a compression wave too slow for its shear wave is refused, and a state beyond the limits") {
  const auto speed = [](Quantity quantity, double value) {
    return Observation{quantity, {value, 0.01 * value}, beads(1e6)};
  };
  for (const Quantity wave : {Quantity::V_p, Quantity::V_p_h})
    for (const Quantity shear : {Quantity::V_s, Quantity::V_s_hh})
      CHECK_THROWS_WITH_AS((void)infer(std::vector{speed(shear, 200), speed(wave, 220)}, options_with()),
                           doctest::Contains(inverse::row_of(wave).key), InvalidArgument);
  const auto at = [](const State& state) {
    Observation one = measurement(Quantity::V_s, beads(1e6), 5.2, 0.02);
    one.state = state;
    return infer(std::vector{one}, options_with());
  };
  CHECK_THROWS_WITH_AS((void)at(beads(1e6, 1e4)), doctest::Contains("stress_h"), InvalidArgument);
  CHECK_THROWS_WITH_AS((void)at(beads(1e6, 1e6, 2e6)), doctest::Contains("void_ratio"), InvalidArgument);
}

TEST_CASE("inference: z* grows as in granum's packings, and the void ratio decreases") {
  const State at_rest = beads(1e6, 1e6, 0.6);
  const double z = 5.3;
  const effective::ContactCounts counts{z, effective::expected_rattlers(at_rest, z).fraction};
  std::vector<Observation> all;
  for (const double p : {1e6, 3e6, 10e6}) {
    const auto carried = effective::carried_contacts(at_rest, counts, p);
    const State here = beads(p, p, p == 1e6 ? 0.6 : carried.void_ratio);
    const double value = value_of(Quantity::V_s, here, carried.counts.mechanical_coordination_number,
                                  carried.counts.rattler_fraction);
    all.push_back({Quantity::V_s, {value, 0.01 * value}, here});
  }
  const auto answer = infer(all, options_with(GrowthRule::packings));
  REQUIRE(answer.together);
  CHECK(answer.together->packing(at_rest).mechanical_coordination_number.value == relative(z, 1e-10));
  CHECK(answer.together->chi_square() < 1e-14);
  CHECK(answer.together->void_ratio_at(10e6) == relative(all.back().state.void_ratio, 1e-12));
  CHECK(answer.together->void_ratio_at(10e6) < 0.59);
  // From the first alone: the same prediction of the last, with an error that the growth has a share in.
  const auto one = infer(std::span(all).first(1), options_with(GrowthRule::packings));
  const Measured grown = one.together->predict(Quantity::V_s, all.back().state);
  CHECK(grown.value == relative(all.back().value.value, 1e-10));
  const auto fixed = infer(std::span(all).first(1), options_with());
  const Measured stays = fixed.together->predict(Quantity::V_s, all.back().state);
  CHECK(stays.value < 0.97 * grown.value);
  CHECK(stays.standard_error / stays.value < grown.standard_error / grown.value);
  CHECK(fixed.together->void_ratio_at(10e6) == 0.6);
}

TEST_CASE("inference: another packing, prepared alike") {
  const State known = beads(1e6, 1e6, 0.6);
  const Observation one = measurement(Quantity::G_vh, known, 5.3, 0.02);
  const auto answer = infer(std::span(&one, 1), options_with());
  const auto share_at = [&](const State& state) {
    const effective::ContactPrior prior = effective::contact_prior(state);
    const double low = prior.loosest.mechanical_coordination_number;
    const Measured z =
        answer.together->packing(state, inverse::AskedPacking::prepared_alike).mechanical_coordination_number;
    return (z.value - low) / (prior.densest.mechanical_coordination_number - low);
  };
  const State looser = beads(1e6, 1e6, 0.68);
  CHECK(share_at(looser) == relative(share_at(known), 1e-9));
  const auto same = answer.together->packing(known),
             alike = answer.together->packing(known, inverse::AskedPacking::prepared_alike);
  CHECK(alike.mechanical_coordination_number.value == relative(5.3, 1e-9));
  CHECK(alike.mechanical_coordination_number.standard_error >
        same.mechanical_coordination_number.standard_error);
  const auto square = [](const inverse::InferredPacking& p) {
    return std::pow(p.mechanical_coordination_number.standard_error, 2);
  };
  const double scatter = effective::contact_prior(answer.together->state(known)).coordination_error;
  CHECK(square(alike) - square(same) == relative(scatter * scatter, 1e-6));
  // Sands lose more with the void ratio than equal contacts would let them.
  const double there =
      answer.together->predict(Quantity::G_vh, looser, inverse::AskedPacking::prepared_alike).value;
  CHECK(there < 0.9 * answer.together->predict(Quantity::G_vh, looser).value);
  // Beside one that is looser than packings of spheres a dense one has more contacts, but not any number.
  for (const double z : {4.2, 5.3}) {
    const Observation loose = measurement(Quantity::G_vh, beads(1e6, 1e6, 0.85), z, 0.02);
    const auto from_loose = infer(std::span(&loose, 1), options_with());
    const auto z_at = [&](double void_ratio) {
      return from_loose.together->packing(beads(1e6, 1e6, void_ratio), inverse::AskedPacking::prepared_alike)
          .mechanical_coordination_number.value;
    };
    CHECK(z_at(0.85) == relative(z, 1e-9));
    CHECK((z_at(0.6) > z && z_at(0.6) < 9));
  }
}

TEST_CASE(
    "inference: a contradiction beyond any packing is no usage error, a speed whose modulus overflows is") {
  Observation soft = measurement(Quantity::G_hh, beads(1e5, 1e5, 0.6), 5, 0.02);
  soft.value = {1e3, 1e-3};
  const std::vector<Observation> both{measurement(Quantity::V_s, beads(1e5, 1e5, 0.6), 5, 0.02), soft};
  CHECK_THROWS_AS((void)infer(both, options_with()), granum::NotConverged);
  for (const double speed : {1e200, 1e-200}) {
    const Observation one{Quantity::V_s, {speed, 0.02 * speed}, beads(1e5, 1e5, 0.6)};
    CHECK_THROWS_WITH_AS((void)infer(std::span(&one, 1), options_with()), doctest::Contains("V_s = "),
                         granum::InvalidArgument);
  }
}

TEST_CASE("inference: contacts that no packing of that void ratio has, within two errors of both") {
  int larger = 0, smaller = 0;
  for (const double e : {0.5, 0.61, 0.72})
    for (double z = 4.2; z < 8; z += 0.1) {
      const Observation one = measurement(Quantity::G_vh, beads(1e6, 1e6, e), z, 0.02);
      const auto answer = infer(std::span(&one, 1), options_with());
      const effective::ContactPrior prior = effective::contact_prior(answer.together->state(one.state));
      const double room =
          2 * std::hypot(prior.coordination_error,
                         answer.together->packing(one.state).mechanical_coordination_number.standard_error);
      const bool above = z > prior.densest.mechanical_coordination_number + room,
                 below = z < prior.loosest.mechanical_coordination_number - room;
      CHECK(answer.validity.notes.size() - answer.together->doubts(one.state).notes.size() ==
            (above || below ? 1 : 0));
      (above ? larger : smaller) += above || below;
    }
  CHECK((larger > 0 && smaller > 0));
}

TEST_CASE("inference: a probability of three in a thousand counts as a contradiction") {
  bool before = false;
  for (double factor = 1; factor < 1.5; factor *= 1.01) {
    std::vector<Observation> all{measurement(Quantity::G_vh, beads(1e6), 5.2, 0.02),
                                 measurement(Quantity::K, beads(1e6), 5.2, 0.02)};
    all[1].value.value *= factor;
    const auto answer = infer(all, options_with());
    const bool contradicts = !answer.validity.ok();
    CHECK(contradicts == (answer.together->probability() < 0.003));
    CHECK((contradicts || !before));
    before = contradicts;
    for (Observation& m : all) // wide errors hold the same
      m.value.standard_error = 0.6 * m.value.value;
    CHECK(infer(all, options_with()).together->probability() > 0.1);
  }
  CHECK(before);
}

TEST_CASE("inference: measurements that no coordination number explains") {
  Observation stiff = measurement(Quantity::V_s, beads(1e6), 12);
  stiff.value.value *= 1.01;
  const auto none = infer(std::span(&stiff, 1), options_with());
  CHECK_FALSE(none.together);
  CHECK_FALSE(none.alone.front().mechanical_coordination_number);
  CHECK(none.validity.notes.size() == 1);
  Observation soft = measurement(Quantity::K, beads(1e6), 4.3);
  soft.value.value *= 0.5;
  const auto too_soft = infer(std::span(&soft, 1), options_with());
  CHECK_FALSE(too_soft.together);
  const std::string value = granum::detail::formatted("%.4g MPa", soft.value.value / 1e6);
  CHECK(too_soft.validity.notes.front().find(value) != std::string::npos);
  const auto names = [](const inverse::InferenceAnswer& answer, const char* format, double number) {
    return answer.validity.notes.front().find(granum::detail::formatted(format, number)) != std::string::npos;
  };
  CHECK((names(too_soft, "%.4g kPa", 1e3) && names(none, "%.4g m/s", stiff.value.value)));
  CHECK(names(too_soft, "would have %.4g MPa", too_soft.alone.front().implied.softest / 1e6));
  CHECK(names(none, "would be %.4g m/s", stiff.value.value / 1.01));
  // Beside one that is explained, the fit goes on and the note stays.
  const auto mixed = infer(std::vector{measurement(Quantity::G_vh, beads(1e6), 5), soft}, options_with());
  CHECK(mixed.together);
  CHECK_FALSE(mixed.validity.ok());
}

TEST_CASE(
    "inference: uncertain inputs move a state as other values of them do, all positive ones in logarithms") {
  using estimate::Input;
  estimate::InputValues values;
  const std::pair<Input, double> numbers[] = {{Input::grain_shear_modulus, 29e9},
                                              {Input::grain_poisson_ratio, 0.2},
                                              {Input::radius, 0.5e-3},
                                              {Input::tangential_ratio, 0.7},
                                              {Input::rolling, 0.3},
                                              {Input::void_ratio, 0.6},
                                              {Input::fabric, 0.2},
                                              {Input::grain_density, 2500},
                                              {Input::pressure, 1e5}};
  estimate::Deviations stated;
  for (const auto& [input, number] : numbers) {
    values.give(input, number);
    stated[input] = 0.1 * number;
  }
  values.grain_shape = estimate::GrainShape::sphere;
  const estimate::InputValues all = completed(values);
  const inverse::SharedInputs shared = inverse::shared_inputs(all, uncertain_inputs(all, stated));
  CHECK(shared.keys.size() == 8); // the pressure is of a state alone
  CHECK(inverse::shared_rows(all).size() >= 8);
  const State state = state_of(all, {3e5, 2e5});
  for (std::size_t k = 0; k < shared.keys.size(); ++k) {
    CAPTURE(shared.keys[k]);
    std::vector<double> deviations(shared.keys.size());
    deviations[k] = 0.7;
    const auto row = std::find_if(estimate::inputs().begin(), estimate::inputs().end(),
                                  [&](const auto& r) { return r.option() == "--" + shared.keys[k]; });
    const double number = all.number(row->input);
    const bool by_sum = row->input == Input::fabric || row->input == Input::grain_poisson_ratio;
    estimate::InputValues other = all;
    other.set(row->input, by_sum ? 1.07 * number : std::exp(0.07) * number);
    const State expected = state_of(other, {3e5, 2e5});
    State moved = state;
    double grain_density = 2500;
    shared.move(moved, grain_density, deviations);
    CHECK(grain_density == relative(other.number(Input::grain_density), 1e-12));
    CHECK(moved.law.stiffness_at_force(0.1) == relative(expected.law.stiffness_at_force(0.1), 1e-12));
    for (const auto member : {&State::tangential_ratio, &State::rolling, &State::radius, &State::void_ratio,
                              &State::fabric_anisotropy, &State::stress_v, &State::stress_h})
      CHECK(moved.*member == relative(expected.*member, 1e-12));
    for (const double far : {-1e3, 1e3})
      if (row->input == Input::rolling) {
        deviations[k] = far;
        shared.move(moved, grain_density, deviations);
        CHECK(moved.rolling == doctest::Approx(far > 0 ? 1 : 0).epsilon(1e-12));
      }
  }
}

TEST_CASE("inference: each measurement has its own water, which forecasts of other states do not have") {
  const InferenceOptions dry = options_with();
  const double e = 0.61;
  std::vector<Observation> all = {measurement(Quantity::V_s, beads(1e6), 5.2, 0.01),
                                  measurement(Quantity::V_s, beads(4e6), 5.35, 0.01)};
  const auto without = infer(all, dry);
  const double slower = 1 / std::sqrt((density + e * elastic::water_density) / density);
  all.back().value = {all.back().value.value * slower, all.back().value.standard_error * slower};
  all.back().saturation = 1;
  const auto answer = infer(all, dry);
  CHECK(answer.together->packing(beads(1e6)).mechanical_coordination_number.value ==
        relative(without.together->packing(beads(1e6)).mechanical_coordination_number.value, 1e-9));
  CHECK(answer.together->chi_square() == relative(without.together->chi_square(), 1e-6));
  CHECK(answer.alone.back().mechanical_coordination_number->value ==
        relative(without.alone.back().mechanical_coordination_number->value, 1e-9));
  const auto V_s = [&](std::optional<double> saturation) {
    return answer.together->predict(Quantity::V_s, beads(2e6), inverse::AskedPacking::same, saturation).value;
  };
  CHECK(V_s({}) == V_s(0));
  CHECK(V_s(0.5) / V_s(0) == relative(std::sqrt(density / (density + e * elastic::water_density / 2)),
                                      1e-3)); // e shrinks a little
  all.back().saturation = 1.5;
  CHECK_THROWS_AS((void)infer(all, dry), InvalidArgument);
}

TEST_CASE("inference: pore water adds mass, and excludes the compression wave") {
  InferenceOptions wet = options_with();
  wet.pore_density = 998;
  const double ratio = (density + 0.61 * 998) / density;
  Observation one = measurement(Quantity::V_s, beads(1e6), 5.2, 0.01);
  one.value.value /= std::sqrt(ratio);
  const auto answer = infer(std::span(&one, 1), wet);
  CHECK(answer.together->packing(one.state).mechanical_coordination_number.value == relative(5.2, 1e-10));
  CHECK(answer.together->predict(Quantity::V_s, beads(1e6)).value == relative(one.value.value, 1e-9));
  CHECK_THROWS_AS((void)answer.together->predict(Quantity::V_p, one.state), InvalidArgument);
  const Observation compression = measurement(Quantity::V_p, beads(1e6), 5.2, 0.01);
  CHECK_THROWS_AS((void)infer(std::span(&compression, 1), wet), InvalidArgument);
}

TEST_CASE("inference: a stop request ends it, whichever of several starts it reaches") {
  const Observation m = measurement(Quantity::V_s, beads(1e6), 5);
  InferenceOptions options = options_with();
  int calls = 0, last = 1 << 30;
  const StopScope scope([&] { return ++calls > last; });
  for (const char* contacts : {"given", "power-law"}) {
    options.contacts = inverse::unknown_contacts(contacts);
    calls = 0, last = 1 << 30;
    (void)infer(std::span(&m, 1), options);
    const int all = calls;
    for (const int quarter : {0, 1, 2, 3}) {
      calls = 0, last = all * quarter / 4;
      CHECK_THROWS_AS((void)infer(std::span(&m, 1), options), Stopped);
    }
  }
}

TEST_CASE("inference: refuses unusable measurements") {
  const Observation good = measurement(Quantity::V_s, beads(1e6), 5);
  const auto refused = [](const Observation& m, const InferenceOptions& o) {
    CHECK_THROWS_AS((void)infer(std::span(&m, 1), o), InvalidArgument);
  };
  refused(good, {});
  const Observation modulus = measurement(Quantity::G_vh, beads(1e6), 5); // for which no density is needed
  CHECK_NOTHROW((void)infer(std::span(&modulus, 1), {}));
  refused(modulus, {.grain_density = 0});
  refused(modulus, {.pore_density = -1});
  CHECK_THROWS_AS((void)infer({}, options_with()), InvalidArgument);
  void (*const changes[])(Observation&) = {
      [](Observation& m) { m.value.value = 0; },
      [](Observation& m) { m.value.value = NAN; },
      [](Observation& m) { m.value.value = 2e14; }, // no solid is as stiff, let alone as fast
      [](Observation& m) { m.value.standard_error = -1; },
      [](Observation& m) { m.value.standard_error = 1.001 * m.value.value; }, // any number would do
      [](Observation& m) { m.state.stress_v = m.state.stress_h = 0; },
      [](Observation& m) { m.state.void_ratio = -0.5; }};
  for (const auto change : changes) {
    Observation bad = good;
    change(bad);
    refused(bad, options_with());
  }
  const auto answer = infer(std::span(&good, 1), options_with());
  CHECK_THROWS_AS((void)answer.together->predict(Quantity::G_vh, beads(-1e3)), InvalidArgument);
}

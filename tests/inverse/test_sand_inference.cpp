// SPDX-License-Identifier: GPL-3.0-or-later
#include <granum/elastic/waves.hpp>
#include <granum/inverse/sand_inference.hpp>

#include <granum/contact/grains.hpp>
#include <granum/contact/power_law.hpp>
#include <granum/core/stop.hpp>

#include "thresholds.hpp"
#include "unit.hpp"

using namespace granum::inverse;
using estimate::Field;

namespace {

estimate::Question quartz(const sands::Sand& sand = {}) {
  const contact::GrainMaterial grain = contact::mineral("quartz").material;
  return {.state = {.law = contact::PowerLaw::sphere(grain, 0.2e-3),
                    .tangential_ratio = contact::mindlin_stiffness_ratio(grain.poisson_ratio),
                    .radius = 0.2e-3,
                    .void_ratio = 0.58,
                    .stress_v = 1e5,
                    .stress_h = 1e5},
          .grain_density = 2650,
          .grain_shape = estimate::GrainShape::sand,
          .sand = sand};
}

effective::State at(double p) {
  effective::State state = quartz().state;
  state.stress_v = state.stress_h = p;
  return state;
}

Observation measured(Quantity quantity, double value, double error, double p) {
  return {.quantity = quantity, .value = {value, error * value}, .state = at(p)};
}

} // namespace

TEST_CASE("a sand's own law gives level 1, its exponent and its ratio back") {
  const estimate::Question sand = quartz({.uniformity = 1.48});
  const double G = estimate::answer(sand)[Field::shear_modulus].value;
  const SandInference found = infer_sand(std::vector{measured(Quantity::G_vh, G, 0.01, 1e5)}, sand);
  CHECK(found.level().value == relative(1, 1e-9));
  CHECK(found.exponent().value == relative(sands::growth_exponent(sand.sand, 1e5).value, 1e-9));
  CHECK_FALSE(found.tells_contacts());
  CHECK(found.degrees_of_freedom() == 0);
  // An error below 0.01 % counts as that, beside half of the variance from test to test.
  CHECK(infer_sand(std::vector{measured(Quantity::G_vh, G, 0, 1e5)}, sand).level().standard_error ==
        relative(std::hypot(1e-4, sands::scatter_within_a_sand / std::numbers::sqrt2), 1e-6));
  const StopScope scope([] { return true; });
  CHECK_THROWS_AS((void)infer_sand(std::vector{measured(Quantity::G_vh, 1e8, 0.01, 1e5)}, quartz()), Stopped);
}

TEST_CASE("forecasts are the answers of estimate for the sand that was found, to the bit") {
  const SandInference found = infer_sand(
      std::vector{measured(Quantity::G_vh, 90e6, 0.02, 50e3), measured(Quantity::V_p, 480, 0.01, 2e5)},
      quartz({.uniformity = 1.48}));
  for (const double p : {20e3, 100e3, 500e3}) {
    const estimate::Answer answer = estimate::answer(found.question(at(p)));
    CHECK(found.predict(Quantity::G_vh, at(p)).value == answer[Field::shear_modulus].value);
    CHECK(found.predict(Quantity::V_s, at(p)).value == answer[Field::shear_wave_speed].value);
    CHECK(found.predict(Quantity::V_p, at(p)).value == answer[Field::compression_wave_speed].value);
    CHECK(found.predict(Quantity::K, at(p)).value == answer[Field::bulk_modulus].value);
  }
}

TEST_CASE("an Ottawa sand: 222.1 MPa at 500 kPa are predicted from 68.3 at 50 within two stated errors") {
  const SandInference found =
      infer_sand(std::vector{measured(Quantity::G_vh, 68.3e6, 0, 50e3)}, quartz({.uniformity = 1.48}));
  const Measured there = found.predict(Quantity::G_vh, at(500e3));
  const double error = there.standard_error / there.value;
  CHECK(std::abs(std::log(222.1e6 / there.value)) < 2 * error);
  CHECK(error == relative(std::hypot(0.04, 0.045 * std::log(10)), 0.001)); // a factor of 1.12
}

TEST_CASE("with one measurement the error combines forecast and measurement") {
  const sands::Sand sand{.uniformity = 2};
  for (const double p : {20e3, 100e3, 150e3, 800e3}) {
    const SandInference found =
        infer_sand(std::vector{measured(Quantity::G_vh, 90e6, 0.03, 100e3)}, quartz(sand));
    const Measured there = found.predict(Quantity::G_vh, at(p));
    if (p >= 50e3) // below, the deviation of s is taken as that of the measurement's side
      CHECK(there.standard_error / there.value ==
            relative(std::sqrt(sands::forecast_variance(sand, 100e3, p) + 0.03 * 0.03), 1e-6));
    CHECK(there.value ==
          relative(90e6 * sands::growth_factor(sand, p) / sands::growth_factor(sand, 100e3), 1e-9));
    const Measured speed = found.predict(Quantity::V_s, at(p));
    CHECK(speed.standard_error / speed.value == relative(there.standard_error / there.value / 2, 1e-6));
  }
}

TEST_CASE("forecasts do not jump with the pressure they are for") {
  const SandInference found = infer_sand(std::vector{measured(Quantity::V_s, 250, 0.02, 80e3)}, quartz());
  Measured last = found.predict(Quantity::V_s, at(30e3));
  for (double p = 30e3; p < 200e3; p *= 1.01) {
    const Measured next = found.predict(Quantity::V_s, at(p));
    CHECK(std::abs(std::log(next.value / last.value)) < 0.006);
    CHECK(std::abs(std::log(next.standard_error / last.standard_error)) < 0.03);
    last = next;
  }
}

TEST_CASE("several pressures change the exponent, and determine it if it is fitted") {
  const double s = 0.55;
  std::vector<Observation> all;
  for (const double p : {50e3, 100e3, 200e3, 400e3})
    all.push_back(measured(Quantity::G_vh, 80e6 * std::pow(p / 1e5, s), 0.01, p));
  const SandInference held = infer_sand(all, quartz()), free = infer_sand(all, quartz(), SandGrowth::fitted);
  CHECK(free.exponent().value == relative(s, 1e-6));
  CHECK(held.exponent().value > 0.48);
  CHECK(held.exponent().value < s);
  CHECK(held.widening() > 1); // s of 0.55 is 2.4 deviations off
  CHECK(free.exponent().standard_error > held.exponent().standard_error / held.widening());
  CHECK_THROWS_AS((void)infer_sand(std::span(all).first(1), quartz(), SandGrowth::fitted), InvalidArgument);
}

TEST_CASE("a contradiction enlarges the errors and is reported") {
  const std::vector alike{measured(Quantity::G_vh, 90e6, 0.02, 1e5),
                          measured(Quantity::G_vh, 92e6, 0.02, 1e5)};
  const std::vector apart{measured(Quantity::G_vh, 90e6, 0.02, 1e5),
                          measured(Quantity::G_vh, 140e6, 0.02, 1e5)};
  const SandInference good = infer_sand(alike, quartz()), bad = infer_sand(apart, quartz());
  CHECK(good.widening() == 1);
  CHECK(good.validity().ok());
  CHECK(bad.widening() > 3);
  CHECK(bad.probability() < 0.01);
  CHECK_FALSE(bad.validity().ok());
  // the growth is fitted where that is possible: not at one pressure
  const std::vector far{apart[0], measured(Quantity::G_vh, 900e6, 0.02, 2e5)};
  const auto names_fitted = [](const SandInference& sand) {
    return std::ranges::any_of(sand.validity().notes, [](const std::string& note) {
      return note.find("fitted") != std::string::npos;
    });
  };
  CHECK_FALSE(names_fitted(bad));
  CHECK(names_fitted(infer_sand(far, quartz())));
  CHECK(bad.level().standard_error / bad.level().value >
        3 * good.level().standard_error / good.level().value);
}

TEST_CASE("from which scatter values of one sand contradict each other, and their sum of squares") {
  int some = 0;
  for (double factor = 1.005; factor < 1.4; factor *= 1.005) {
    const SandInference found = infer_sand(std::vector{measured(Quantity::G_vh, 90e6, 0.02, 1e5),
                                                       measured(Quantity::G_vh, 90e6 * factor, 0.02, 1e5)},
                                           quartz());
    const double square =
        std::pow(std::log(factor), 2) / 2 / (0.02 * 0.02 + std::pow(sands::scatter_within_a_sand, 2) / 2);
    CHECK(found.chi_square() == relative(square, 1e-9));
    CHECK(found.degrees_of_freedom() == 1);
    CHECK(found.probability() == relative(std::erfc(std::sqrt(square / 2)), 1e-9));
    CHECK(found.widening() == relative(std::max(1.0, std::sqrt(square)), 1e-9));
    CHECK(found.validity().ok() == (found.probability() >= 0.01));
    CHECK(found.measurements()[1].value.standard_error / found.measurements()[1].value.value ==
          relative(found.level().standard_error / found.level().value, 1e-6));
    some += found.validity().ok();
  }
  CHECK((some > 10 && some < 60));
}

TEST_CASE("from which ratio of speeds contacts are known, and from which they are too stiff") {
  const double deviation = sands::poisson_ratio({}, 1e5).deviation;
  int known = 0, stiff = 0;
  const auto look = [&](double V_s, double nu, double error) {
    const double V_p = V_s * std::sqrt(2 * (1 - nu) / (1 - 2 * nu));
    const SandInference found = infer_sand(
        std::vector{measured(Quantity::V_s, V_s, error, 1e5), measured(Quantity::V_p, V_p, error, 1e5)},
        quartz());
    CHECK(found.tells_contacts() ==
          (found.poisson_ratio().standard_error / found.widening() < 0.7 * deviation));
    known += found.tells_contacts();
    // ln of the softness by the parameters, whose covariance is known for each alone.
    const auto softness = found.contacts(Field::contact_softness, at(1e5));
    const bool bonded =
        found.tells_contacts() && softness.low > 2 && sands::level_remark(found.level().value).empty();
    CHECK((found.validity().notes.size() > found.doubts(at(1e5)).notes.size()) ==
          (bonded || !sands::level_remark(found.level().value).empty() || found.probability() < 0.01));
    stiff += bonded;
  };
  for (int k = 0; k < 60; ++k)
    look(250, 0.15, 0.005 * std::exp(0.05 * k));
  CHECK((known > 5 && known < 55));
  for (int k = 0; k < 60; ++k)
    look(250 + 4 * k, 0.3, 0.002);
  CHECK(stiff > 0);
}

TEST_CASE("V_p and V_s together determine contacts, V_s alone does not") {
  const double nu = 0.12;
  const double ratio = std::sqrt(2 * (1 - nu) / (1 - 2 * nu));
  const std::vector both{measured(Quantity::V_s, 250, 0.01, 1e5),
                         measured(Quantity::V_p, 250 * ratio, 0.01, 1e5)};
  const SandInference found = infer_sand(both, quartz());
  CHECK(found.tells_contacts());
  CHECK(found.poisson_ratio().value > nu);
  CHECK(found.poisson_ratio().value < 0.16);
  const estimate::Range z = found.contacts(Field::mechanical_coordination_number, at(1e5));
  CHECK(z.value > estimate::answer(quartz())[Field::mechanical_coordination_number].value);
  CHECK(z.high / z.value == relative(z.value / z.low, 1e-12));
  const std::vector exact{measured(Quantity::V_s, 250, 0.005, 1e5),
                          measured(Quantity::V_p, 250 * ratio, 0.005, 1e5)};
  const estimate::Range narrow =
      infer_sand(exact, quartz()).contacts(Field::mechanical_coordination_number, at(1e5));
  CHECK(z.high / z.value > 1.001 * narrow.high / narrow.value);
  CHECK(narrow.high > narrow.value);
  CHECK_FALSE(infer_sand(std::span(both).first(1), quartz()).tells_contacts());
}

TEST_CASE(
    "a forecast far beyond the tests and a bonded stiffness are doubtful, V_p in wet pores is refused") {
  CHECK_FALSE(infer_sand(std::vector{measured(Quantity::V_s, 700, 0.02, 1e5)}, quartz()).validity().ok());
  estimate::Question wet = quartz({.uniformity = 1.48});
  wet.saturation = 1;
  const SandInference found = infer_sand(std::vector{measured(Quantity::V_s, 250, 0.02, 1e5)}, wet);
  CHECK(found.doubts(at(2e5)).ok());
  CHECK_FALSE(found.doubts(at(5e7)).ok());
  CHECK(found.predict(Quantity::V_s, at(2e5)).value > 250);
  CHECK_THROWS_AS((void)found.predict(Quantity::V_p, at(2e5)), InvalidArgument);
}

TEST_CASE("V_s above and below the water of one sand have one level, as their moduli have") {
  const estimate::Question dry = quartz({.uniformity = 1.48});
  const auto density = [](double saturation) {
    return elastic::bulk_density(
        {.grain_density = 2650, .void_ratio = 0.58, .pore_density = saturation * elastic::water_density});
  };
  std::vector<Observation> moduli, speeds;
  for (const auto& [p, saturation] : {std::pair{5e4, 0.2}, {1e5, 1.0}, {2e5, 1.0}}) {
    const double G = 1.1 * 80e6 * std::sqrt(p / 1e5) * (1 + 0.02 * saturation);
    moduli.push_back(measured(Quantity::G_vh, G, 0.02, p));
    speeds.push_back(measured(Quantity::V_s, std::sqrt(G / density(saturation)), 0.01, p));
    speeds.back().saturation = saturation;
  }
  const SandInference by_moduli = infer_sand(moduli, dry), by_speeds = infer_sand(speeds, dry);
  CHECK(by_speeds.level().value == relative(by_moduli.level().value, 1e-9));
  CHECK(by_speeds.exponent().value == relative(by_moduli.exponent().value, 1e-9));
  CHECK(by_speeds.chi_square() == relative(by_moduli.chi_square(), 1e-6));
  CHECK(
      by_speeds.predict(Quantity::V_s, at(1e5), 1).value ==
      relative(by_speeds.predict(Quantity::V_s, at(1e5)).value * std::sqrt(density(0) / density(1)), 1e-12));
  CHECK_THROWS_AS((void)by_speeds.predict(Quantity::V_p, at(1e5), 0.5), InvalidArgument);
  speeds.front().quantity = Quantity::V_p;
  CHECK_THROWS_AS((void)infer_sand(speeds, dry), InvalidArgument); // in wet pores of its own
}

TEST_CASE("measurements without information are refused") {
  CHECK_THROWS_AS((void)infer_sand({}, quartz()), InvalidArgument);
  estimate::Question wet = quartz(), light = quartz();
  wet.saturation = 1;
  light.grain_density.reset();
  for (const auto& [one, question] : {std::pair{measured(Quantity::V_s, 200, 1.001, 1e5), quartz()},
                                      {measured(Quantity::V_p, 1700, 0.02, 1e5), wet},
                                      {measured(Quantity::V_s, 250, 0.02, 1e5), light}})
    CHECK_THROWS_AS((void)infer_sand(std::vector{one}, question), InvalidArgument);
}

TEST_CASE("a compression wave too slow for its shear wave is refused") {
  // sqrt(4/3) = 1.155, and three errors of 1 % in either speed.
  const auto of = [](double V_p, double error) {
    return infer_sand(
        std::vector{measured(Quantity::V_s, 200, error, 1e5), measured(Quantity::V_p, V_p, error, 1e5)},
        quartz());
  };
  CHECK_THROWS_WITH_AS((void)of(220, 0.01), doctest::Contains("V_p"), InvalidArgument);
  const auto refused = [](const auto& infer) { return refusals([&] { infer(); }); };
  const double least = 200 * std::sqrt(4 / 3.0);
  for (const double error : {0.01, 0.02})
    check_threshold(least * std::exp(-3 * error * std::sqrt(2)),
                    [&](double V_p) { return refused([&] { (void)of(V_p, error); }); });
  // A modulus beside a speed, by the density of the packing.
  const double rho = 2650 / 1.58;
  const auto beside = [&](Quantity quantity, double modulus) {
    return infer_sand(std::vector{measured(Quantity::V_p, 300, 0, 1e5), measured(quantity, modulus, 0, 1e5)},
                      quartz());
  };
  check_threshold(0.75 * rho * 300 * 300 * std::exp(3 * 0.05),
                  [&](double modulus) { // by the error of the modulus
                    return refused([&] {
                      (void)infer_sand(std::vector{measured(Quantity::V_p, 300, 0, 1e5),
                                                   measured(Quantity::G_vh, modulus, 0.05, 1e5)},
                                       quartz());
                    });
                  });
  CHECK_THROWS_AS((void)beside(Quantity::K, 1.01 * rho * 300 * 300), InvalidArgument);
  CHECK_NOTHROW((void)beside(Quantity::K, 0.99 * rho * 300 * 300));
  CHECK_THROWS_AS((void)beside(Quantity::G_hh, 0.76 * rho * 300 * 300), InvalidArgument);
  // At another stress both may be true.
  CHECK_NOTHROW((void)infer_sand(
      std::vector{measured(Quantity::V_s, 300, 0.01, 4e5), measured(Quantity::V_p, 200, 0.01, 1e4)},
      quartz()));
}

TEST_CASE("an exponent that fitted measurements do not determine, or that no sand has, makes no forecast") {
  const auto fitted = [](double G_1, double p_2, double G_2, double error) {
    return infer_sand(
        std::vector{measured(Quantity::G_vh, G_1, error, 1e5), measured(Quantity::G_vh, G_2, error, p_2)},
        quartz(), SandGrowth::fitted);
  };
  CHECK_THROWS_AS((void)fitted(90e6, 101e3, 91e6, 0.02), InvalidArgument);
  CHECK_THROWS_AS((void)fitted(90e6, 4e5, 90e6 * std::pow(4, 1.4), 0.01), InvalidArgument);
  CHECK_THROWS_AS((void)fitted(90e6, 4e5, 90e6 * std::pow(4, -0.4), 0.01), InvalidArgument);
  CHECK(fitted(90e6, 4e5, 180e6, 0.02).exponent().standard_error < 0.05);
  double close = 101e3, far = 4e5; // the nearest pressures that determine it do so within 0.25
  const auto error = [&](double p) -> std::optional<double> {
    try {
      return fitted(90e6, p, 90e6 * std::sqrt(p / 1e5), 0.02).exponent().standard_error;
    } catch (const InvalidArgument&) {
      return std::nullopt;
    }
  };
  for (int step = 0; step < 14; ++step)
    (error(std::sqrt(close * far)) ? far : close) = std::sqrt(close * far);
  CHECK(error(far).value() == relative(0.25, 0.01));
}

TEST_CASE(
    "a sand whose relative density is known is forecast at another void ratio by the one that this is") {
  const SandInference found =
      infer_sand(std::vector{measured(Quantity::G_vh, 80e6, 0.02, 1e5)}, quartz({.relative_density = 0.6}));
  effective::State denser = at(1e5);
  denser.void_ratio -= 0.1;
  const sands::UsualLimits usual = sands::usual_limits({});
  const double here = found.predict(Quantity::G_vh, at(1e5)).value;
  CHECK(here == relative(80e6, 1e-9));
  CHECK(found.predict(Quantity::G_vh, denser).value ==
        relative(here * std::pow(10, 0.241 * 0.1 / (usual.largest - usual.least)), 1e-9));
  // Measured states are looked at as predicted ones are.
  CHECK(found.validity().ok());
  Observation far = measured(Quantity::G_vh, 2e9, 0.02, 1e5);
  far.state.stress_v = far.state.stress_h = 50e6;
  CHECK_FALSE(infer_sand(std::vector{far}, quartz()).validity().ok());
}

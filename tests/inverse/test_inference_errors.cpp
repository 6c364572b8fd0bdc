// SPDX-License-Identifier: GPL-3.0-or-later
#include <granum/inverse/inference.hpp>

#include <random>

#include "inferences.hpp"
#include "inverse/contact_model.hpp"
#include "sample_statistics.hpp"
#include "thresholds.hpp"
#include "unit.hpp"

using namespace inferences;

TEST_CASE("inference: errors common to measurement and prediction cancel") {
  InferenceOptions options = options_with();
  const Observation one = measurement(Quantity::V_s, beads(3e6), 5.3, 0.01);
  const auto error_at = [&](double p) {
    const auto answer = infer(std::span(&one, 1), options);
    const Measured predicted = answer.together->predict(Quantity::V_s, beads(p));
    return predicted.standard_error / predicted.value;
  };
  const double z_error = infer(std::span(&one, 1), options)
                             .together->packing(one.state)
                             .mechanical_coordination_number.standard_error;
  const double without = error_at(30e6);
  options.inputs = grain_modulus_within(0.1);
  // V_s ~ G_g^(1/3): by itself 3.3 % and much of z*, nearly nothing of the prediction.
  const auto answer = infer(std::span(&one, 1), options);
  CHECK(answer.together->packing(one.state).mechanical_coordination_number.standard_error > 1.5 * z_error);
  CHECK(error_at(30e6) == relative(without, 0.02));
  CHECK(without < 0.025);
}

TEST_CASE("inference: stated errors agree with the scatter of a sample") {
  // Truth: z* 5.2; everything else scatters as it is said to. A measurement at 3 MPa, a prediction at 30.
  const double z = 5.2, noise = 0.005, grain_error = 0.05, shared = 0.42;
  InferenceOptions options = options_with();
  options.inputs = grain_modulus_within(grain_error);
  std::mt19937 generator(7);
  std::normal_distribution<double> normal;
  std::vector<double> found, missed;
  for (int draw = 0; draw < 2000; ++draw) {
    const auto [expected, scatter] = effective::expected_rattlers(beads(3e6), z);
    const double x = expected * std::exp(scatter * normal(generator));
    const double grain_modulus = 29e9 * std::exp(grain_error * normal(generator));
    const double preparation = normal(generator);
    const auto truth = [&](double p) {
      const State state = beads(p, p, 0.61, grain_modulus);
      const double error = relaxed(effective::with_contacts(state, z, x), z).relative_error.G_vh;
      return value_of(Quantity::G_vh, state, z, x) *
             std::exp(error * (std::sqrt(shared) * preparation + std::sqrt(1 - shared) * normal(generator)));
    };
    const double measured = truth(3e6) * std::exp(noise * normal(generator));
    const Observation one{Quantity::G_vh, {measured, noise * measured}, beads(3e6)};
    const auto answer = infer(std::span(&one, 1), options);
    const Measured predicted = answer.together->predict(Quantity::G_vh, beads(30e6));
    found.push_back(answer.together->packing(one.state).mechanical_coordination_number.value);
    missed.push_back(std::log(predicted.value / truth(30e6)));
  }
  const Observation typical = measurement(Quantity::G_vh, beads(3e6), z, noise);
  const auto answer = infer(std::span(&typical, 1), options);
  const Measured stated_z = answer.together->packing(typical.state).mechanical_coordination_number;
  const Measured stated_value = answer.together->predict(Quantity::G_vh, beads(30e6));
  CHECK(deviation(found) == relative(stated_z.standard_error, 0.05));
  CHECK(deviation(missed) == relative(stated_value.standard_error / stated_value.value, 0.05));
  CHECK(std::abs(mean(found) - z) < 0.1 * stated_z.standard_error);
}

TEST_CASE("inference: shares of the error by leaving its sources out") {
  InferenceOptions options = options_with();
  options.inputs = grain_modulus_within(0.05);
  const Observation one = measurement(Quantity::G_vh, beads(3e6), 5.2, 0.03);
  const auto variance = [&](const InferenceOptions& o, const Observation& m) {
    const double error =
        infer(std::span(&m, 1), o).together->packing(m.state).mechanical_coordination_number.standard_error;
    return error * error;
  };
  const auto answer = infer(std::span(&one, 1), options);
  const double all = variance(options, one);
  for (const auto& [source, share] : answer.together->error_shares()) {
    InferenceOptions fewer = options;
    Observation exact = one;
    if (source == "measurement")
      exact.value.standard_error = 0;
    else if (source == "grain-shear-modulus")
      fewer.inputs = {};
    else
      continue;
    CHECK((all - variance(fewer, exact)) / all == relative(share, 1e-3));
  }
}

TEST_CASE("inference: of one measurement each source has its square over that of the slope by z*") {
  InferenceOptions options = options_with();
  options.inputs = grain_modulus_within(0.05);
  const double z = 5.2, p = 3e6, h = 1e-4;
  const auto [x, scatter] = effective::expected_rattlers(beads(p), z);
  const effective::RelaxedEstimate rung = relaxed(effective::with_contacts(beads(p), z, x), z);
  for (const auto& row : inverse::quantities()) {
    CAPTURE(row.key);
    const Observation one = measurement(row.quantity, beads(p), z, 0.03);
    const inverse::Inference found = infer(std::span(&one, 1), options).together.value();
    const double K = rung.stiffness.bulk_modulus(), X = modulus(rung.stiffness, row.modulus);
    const double by_K = row.modulus == Modulus::K                                    ? 1
                        : row.modulus == Modulus::C11 || row.modulus == Modulus::C33 ? K / X
                                                                                     : 0;
    const double G_error = row.modulus == Modulus::G_hh ? rung.relative_error.G_hh : rung.relative_error.G_vh;
    const auto slope = [&](const auto& function) {
      return (std::log(function(h)) - std::log(function(-h))) / (2 * h);
    };
    const double of_rung =
        (row.speed ? 0.5 : 1) * std::hypot(by_K * rung.relative_error.bulk_modulus, (1 - by_K) * G_error);
    const double of_rattlers = scatter * slope([&, fraction = double(x)](double d) {
                                 return value_of(row.quantity, beads(p), z, fraction * std::exp(d));
                               });
    const double of_grains =
        0.05 * slope([&, fraction = double(x)](double d) {
          return value_of(row.quantity, beads(p, p, 0.61, 29e9 * std::exp(d)), z, fraction);
        });
    const double by_z = slope([&](double d) { return value_of(row.quantity, beads(p), z + d); });
    const std::pair<const char*, double> parts[] = {{"measurement", 0.03},
                                                    {"rung 3", of_rung},
                                                    {"rattlers", of_rattlers},
                                                    {"grain-shear-modulus", of_grains}};
    double all = 0;
    for (const auto& part : parts)
      all += part.second * part.second;
    for (const auto& share : found.error_shares()) {
      double expected = 0;
      for (const auto& part : parts)
        if (share.source == part.first)
          expected = part.second * part.second / all;
      CHECK(std::abs(share.share - expected) < 1e-5);
    }
    CHECK(found.packing(one.state).mechanical_coordination_number.standard_error ==
          relative(std::sqrt(all) / by_z, 1e-5));
    // Only what one state has of its own is added where the quantity itself is predicted.
    const double own = (1 - effective::scatter_share_of_preparation()) * of_rung * of_rung;
    const Measured again = found.predict(row.quantity, one.state);
    CHECK(again.standard_error / again.value == relative(std::sqrt(0.03 * 0.03 + 2 * own), 1e-5));
  }
}

TEST_CASE("inference: two values of one state share the scatter of rung 3, those of two states do not") {
  const double off = 0.01, noise = 0.02;
  for (const double apart : {0.0, 1e-9}) {
    std::vector<Observation> two{measurement(Quantity::G_vh, beads(1e6), 5.2, noise),
                                 measurement(Quantity::G_vh, beads(1e6 * (1 + apart)), 5.2, noise)};
    two[0].value = {two[0].value.value * std::exp(off), noise * two[0].value.value * std::exp(off)};
    two[1].value = {two[1].value.value * std::exp(-off), noise * two[1].value.value * std::exp(-off)};
    const inverse::Inference found = infer(two, options_with()).together.value();
    const State fitted = found.state(beads(1e6));
    const double rung = relaxed(fitted, *fitted.mechanical_coordination_number).relative_error.G_vh,
                 own = std::sqrt(1 - effective::scatter_share_of_preparation()) * rung;
    CHECK(found.chi_square() ==
          relative(2 * off * off / (noise * noise + (apart > 0 ? own * own : 0)), 1e-5));
    CHECK(found.measurements()[0].deviation == relative(off / std::hypot(noise, own), 1e-4));
    CHECK(found.measurements()[1].deviation == relative(-off / std::hypot(noise, own), 1e-4));
  }
}

TEST_CASE("inference: errors below 0.01 % count as that, and no solid has values beyond the limits") {
  const auto error = [](double stated) {
    Observation one = measurement(Quantity::G_vh, beads(1e6), 5.2, stated);
    const auto answer = infer(std::span(&one, 1), options_with());
    for (const auto& share : answer.together->error_shares())
      if (share.source == "measurement")
        return share.share;
    return 0.0;
  };
  CHECK(error(0) == relative(error(1e-4), 1e-6));
  CHECK(error(1.1e-4) == relative(1.21 * error(1e-4), 1e-3));
  const auto limit = [](Quantity quantity, double at) {
    check_threshold(at, [&](double value) {
      return refusals([&] { require_measured(inverse::row_of(quantity), {value, 0}); });
    });
  };
  limit(Quantity::G_vh, 1);
  limit(Quantity::G_vh, 1e14);
  limit(Quantity::V_s, 0.01);
  limit(Quantity::V_s, 1e5);
}

TEST_CASE("inference: a fitted growth is refused beyond its error, and beyond twice that outside of 0 to 1") {
  const auto refused = [](double value, double error) {
    return refusals([&] { inverse::detail::require_determined_growth({value, error}, 0.3); });
  };
  check_threshold(0.3, [&](double error) { return refused(0.5, error); });
  check_threshold(0.2, [&](double below) { return refused(-below, 0.1); });
  check_threshold(1.2, [&](double value) { return refused(value, 0.1); });
  // The nearest stresses that determine it do so within 0.5.
  double close = 1.01, far = 8;
  const auto exponent_error = [](double ratio) -> std::optional<double> {
    std::vector<Observation> all;
    for (const double p : {1e6, ratio * 1e6})
      all.push_back(measurement(Quantity::V_s, beads(p), 5, 0.01));
    try {
      return infer(all, options_with(GrowthRule::fitted)).together->growth_exponent()->standard_error;
    } catch (const InvalidArgument&) {
      return std::nullopt;
    }
  };
  for (int step = 0; step < 14; ++step)
    (exponent_error(std::sqrt(close * far)) ? far : close) = std::sqrt(close * far);
  CHECK(exponent_error(far).value() == relative(0.5, 0.01));
}

TEST_CASE("inference: exact measurements of dependent quantities") {
  std::vector<Observation> all;
  for (const Quantity q : {Quantity::K, Quantity::G_vh, Quantity::V_p, Quantity::V_s})
    all.push_back(measurement(q, beads(1e6), 5));
  const auto answer = infer(all, options_with());
  CHECK(answer.together->packing(beads(1e6)).mechanical_coordination_number.value == relative(5.0, 1e-9));
}

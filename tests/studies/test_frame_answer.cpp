// SPDX-License-Identifier: GPL-3.0-or-later
#include "studies/analyse/frame_answer.hpp"

#include <granum/elastic/isotropic.hpp>

#include "studies/analyse/state_series.hpp"
#include "unit.hpp"

using namespace granum::studies;

namespace {

const elastic::TransverselyIsotropic layered{
    .C11 = 310e6, .C33 = 402e6, .C12 = 118e6, .C13 = 133e6, .C44 = 121e6};

/// Frames of one packing whose network has G ~ p^s.
std::vector<FrameAnswer> states(double s) {
  std::vector<FrameAnswer> frames;
  for (const double p : {10e3, 20e3, 50e3, 100e3}) {
    FrameAnswer frame;
    frame.file = "packing_" + std::to_string(frames.size()) + ".csv";
    frame.measured.packing.void_ratio = 0.6;
    frame.measured.packing.stress.emplace();
    frame.measured.packing.stress->symmetric = Mat3::diagonal(p, p, p);
    const double G = 100e6 * std::pow(p / 100e3, s);
    frame.rungs = {
        {.name = network_name(), .title = "network", .moduli = Moduli{.K = 2 * G, .G = G, .G_vh = G}}};
    frames.push_back(frame);
  }
  return frames;
}

} // namespace
TEST_CASE("moduli of a stiffness are those of the nearest isotropic and transversely isotropic ones") {
  const elastic::Isotropic nearest = elastic::isotropic_projection(elastic::voigt(layered));
  for (const Moduli& m : {moduli_of(layered), moduli_of(elastic::voigt(layered))}) {
    CHECK(m.K == relative(nearest.bulk_modulus(), 1e-14));
    CHECK(m.G == relative(nearest.shear_modulus(), 1e-14));
    CHECK(m.G_vh == relative(layered.C44, 1e-14));
    CHECK(m.C13 == relative(layered.C13, 1e-14));
  }
}

TEST_CASE("a stress is compared with that of the code, except for zero components") {
  FrameAnswer frame;
  CHECK_FALSE(largest_stress_difference(frame));
  frame.measured.packing.stress.emplace();
  frame.measured.packing.stress->tensor = Mat3::diagonal(100, 200, 300);
  CHECK_FALSE(mean_code_stress(frame));
  frame.code_stress = PrintedStress{100, 200, 303, 0, 0, 0};
  CHECK(*mean_code_stress(frame) == relative(201, 1e-15));
  CHECK(*stress_differences(frame)[0] == 0);
  CHECK(*stress_differences(frame)[2] == relative(-3.0 / 303, 1e-12));
  CHECK_FALSE(stress_differences(frame)[3]);
  CHECK(*largest_stress_difference(frame) == relative(3.0 / 303, 1e-12));
}

TEST_CASE("a series gives back the exponent of its rung") {
  const std::vector<StateSeries> series = series_of(states(0.4), SeriesBy::name);
  REQUIRE(series.size() == 1);
  REQUIRE(series[0].rungs.size() == 1);
  CHECK(series[0].frames.size() == 4);
  REQUIRE(series[0].rungs[0].fit.sum);
  CHECK(series[0].rungs[0].fit.sum->exponent_sum.value == relative(0.4, 1e-9));
  CHECK(series_of({}, SeriesBy::all).empty());
}

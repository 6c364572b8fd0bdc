// SPDX-License-Identifier: GPL-3.0-or-later
#include "studies/analyse/frame_answer.hpp"

#include <granum/elastic/isotropic.hpp>

#include "read_specimen.hpp"
#include "studies/analyse/state_series.hpp"
#include "unit.hpp"
#include "written_packing.hpp"

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
    const double expected[] = {layered.C44, (layered.C11 - layered.C12) / 2,
                               layered.C11, layered.C33,
                               layered.C12, layered.C13},
                 own[] = {m.G_vh, m.G_hh, m.C11, m.C33, m.C12, m.C13};
    for (int k = 0; k < 6; ++k)
      CHECK(own[k] == relative(expected[k], 1e-14));
  }
}

TEST_CASE("a stress is compared with that of the code, except for zero components") {
  FrameAnswer frame;
  CHECK_FALSE(largest_stress_difference(frame));
  frame.measured.packing.stress.emplace();
  frame.measured.packing.stress->tensor = {{{100, 1, 2}, {10, 200, 3}, {20, 30, 300}}};
  CHECK(printed(*frame.measured.packing.stress) == PrintedStress{100, 200, 300, 10, 20, 30});
  CHECK_FALSE(mean_code_stress(frame));
  frame.code_stress = PrintedStress{100, 200, 303, 0, 25, 15};
  CHECK(*mean_code_stress(frame) == relative(201, 1e-15));
  const std::optional<double> apart[] = {0, 0, -3.0 / 303, {}, -0.2, 1};
  for (std::size_t k = 0; k < 6; ++k) {
    REQUIRE(stress_differences(frame)[k].has_value() == apart[k].has_value());
    CHECK(std::abs(stress_differences(frame)[k].value_or(0) - apart[k].value_or(0)) < 1e-12);
  }
  CHECK(*largest_stress_difference(frame) == relative(15.0 / 303, 1e-12));
  frame.code_stress = printed(*frame.measured.packing.stress);
  CHECK(*largest_stress_difference(frame) == 0);
}

TEST_CASE("an answer has each rung beside the network, the window, slices and modes that are asked for") {
  const io::ImportedPacking packing = samples::through_csv(samples::specimen());
  MeasureOptions options{
      .given = {.grain_shear_modulus = samples::specimen_grain.shear_modulus, .grain_density = 2650},
      .wanted = analysis::everything()};
  const FrameAnswer whole = answer_frame(packing, options);
  REQUIRE((find_rung(whole, network_name()) && find_rung(whole, relaxed_name()) && whole.rungs.size() > 4));
  const Moduli own = *find_rung(whole, network_name())->moduli;
  CHECK(own.G == moduli_of(whole.measured.packing.network->response.relaxed()).G);
  CHECK(find_rung(whole, "affine")->moduli->K ==
        moduli_of(whole.measured.packing.network->response.affine()).K);
  for (const RungResult& rung : whole.rungs) {
    REQUIRE(rung.moduli);
    CHECK((rung.one_axis && rung.error.empty()));
    CHECK(*rung.network_over_K == relative(own.K / rung.moduli->K, 1e-14));
    CHECK(*rung.network_over_G == relative(own.G / rung.moduli->G, 1e-14));
  }
  CHECK(*network_over_relaxed(whole) == *find_rung(whole, relaxed_name())->network_over_G);
  CHECK(*mean_stress(whole) == whole.measured.packing.stress->mean());
  CHECK((!whole.window && whole.profile.empty() && whole.modes.empty() && whole.seconds > 0));

  options.window.emplace().high[2] = packing.assembly.cell(2, 2) / 2;
  options.window->low[2] = 0;
  options.profile = ProfileChoice{.axis = 0, .slices = 3};
  options.modes = 1;
  options.wanted.network->iteration_limit = 1;
  const FrameAnswer part = answer_frame(packing, options);
  CHECK(*mean_stress(part) == trace(part.measured.packing.interior->stress) / 3);
  CHECK(part.window->high[2] == packing.assembly.cell(2, 2) / 2);
  CHECK((part.profile_axis == 0 && part.profile.size() == 3));
  CHECK((part.modes.size() == 1 && part.modes[0].motion.empty()));
  CHECK((part.rungs.back().name == network_name() && !part.rungs.back().error.empty()));
  CHECK_FALSE((find_rung(part, network_name()) || network_over_relaxed(part)));

  io::ImportedPacking loose = packing; // not rigid, and pressed along x far more
  for (packing::Contact& c : loose.assembly.contacts)
    c.normal_force *= std::abs(c.branch.x) > 0.5 * norm(c.branch) ? 9 : 1;
  std::erase_if(loose.assembly.contacts, [k = 0](const packing::Contact&) mutable { return k++ % 2 == 0; });
  const FrameAnswer turned = answer_frame(loose, {.given = options.given, .wanted = analysis::everything()});
  const auto relaxed = std::ranges::find(turned.rungs, relaxed_name(), &RungResult::name);
  REQUIRE(relaxed != turned.rungs.end());
  CHECK((!relaxed->moduli && !relaxed->error.empty() && !relaxed->one_axis && turned.measured.triaxial));
}

TEST_CASE("a series gives back the exponent of its rung") {
  const std::vector<StateSeries> series = series_of(states(0.4), SeriesBy::name);
  REQUIRE(series.size() == 1);
  REQUIRE(series[0].rungs.size() == 1);
  CHECK(series[0].frames.size() == 4);
  REQUIRE(series[0].rungs[0].fit.sum);
  CHECK(series[0].rungs[0].fit.sum->exponent_sum.value == relative(0.4, 1e-9));
  CHECK(series[0].rungs[0].fit.states == 4);
  CHECK_FALSE(series[0].rungs[0].separate);
  std::vector<FrameAnswer> one = states(0.4);
  one.resize(1);
  CHECK((series_of({}, SeriesBy::all).empty() && series_of(one, SeriesBy::all).empty()));
}

TEST_CASE("a series is of files alike in name, its rungs those of its fullest frame, m and n by direction") {
  std::vector<FrameAnswer> frames = states(0.4);
  const auto named = [&](std::vector<std::string> files, SeriesBy by) {
    std::vector<std::vector<std::size_t>> members;
    for (std::size_t k = 0; k < frames.size(); ++k)
      frames[k].file = files[k];
    for (const StateSeries& one : series_of(frames, by))
      members.push_back(one.frames);
    return members;
  };
  using Members = std::vector<std::vector<std::size_t>>;
  CHECK(named({"a1", "b1", "a2", "c"}, SeriesBy::name) == Members{{0, 2}, {1}, {3}});
  CHECK(named({"a1", "b1", "a2", "c"}, SeriesBy::all) == Members{{0, 1, 2, 3}});
  CHECK(named({"a", "b", "c", "d"}, SeriesBy::name) == Members{{0, 1, 2, 3}});
  for (std::size_t k = 0; k < 4; ++k) { // G_vh = C sigma_v^0.3 sigma_h^0.1
    const double p = 10e3 * static_cast<double>(k + 1), v = p * (1 + 0.2 * static_cast<double>(k * k));
    frames[k].measured.packing.state = effective::State{.law = contact::PowerLaw::sphere({30e9, 0.2}, 1e-3),
                                                        .radius = 1e-3,
                                                        .void_ratio = 0.6,
                                                        .stress_v = v,
                                                        .stress_h = p};
    frames[k].rungs[0].moduli->G_vh = std::pow(v, 0.3) * std::pow(p, 0.1);
  }
  frames[1].rungs.push_back({.name = "other", .title = "other", .moduli = frames[1].rungs[0].moduli});
  frames[2].rungs[0].moduli->G = 0; // is no modulus
  const StateSeries found = series_of(frames, SeriesBy::all).front();
  REQUIRE(found.rungs.size() == 2);
  CHECK((found.rungs[0].fit.states == 3 && found.rungs[1].fit.states == 1));
  REQUIRE(found.rungs[0].separate);
  CHECK(found.rungs[0].separate->exponent_i->value == relative(0.3, 1e-6));
  CHECK(found.rungs[0].separate->exponent_j->value == relative(0.1, 1e-6));
  frames[0].rungs[0].one_axis = false; // no G_vh of a state without an axis
  frames[3].rungs[0].moduli->G_vh = 0;
  CHECK_FALSE(series_of(frames, SeriesBy::all).front().rungs[0].separate);
}

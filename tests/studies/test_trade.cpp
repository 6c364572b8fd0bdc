// SPDX-License-Identifier: GPL-3.0-or-later
#include "studies/trade/trade.hpp"

#include <atomic>
#include <chrono>

#include "studies/trade/trade_parts.hpp"
#include "studies/verify/findings.hpp"
#include <granum/sizes/distribution.hpp>

#include "thresholds.hpp"
#include "unit.hpp"

using namespace granum::studies;
using contact::Shape;
using triaxial::Density;

namespace {

/// Every quantity varied once, with as few and small specimens as there can be.
TradeScene small_trade() {
  TradeScene trade = default_trade();
  trade.scene.study.grains = 100;
  trade.scene.study.seeds = 2;
  trade.scene.study.pressures = {20e3, 40e3, 80e3};
  trade.scene.study.densities = {Density::dense};
  trade.scene.study.threads = 2;
  trade.shear_inertial_number = 2e-3;
  trade.grains = {60, 100};
  trade.compression = {1e-3, 5e-4};
  trade.shear = {4e-3, 2e-3};
  trade.time_step = {0.8, 0.5};
  trade.probe = {1e-4};
  trade.walls = {100};
  return trade;
}

double seconds_of_small_study = 0;

/// Run once: it takes longest.
const std::vector<TradeSample>& small_study() {
  static const std::vector<TradeSample> samples = [] {
    const auto start = std::chrono::steady_clock::now();
    std::vector<TradeSample> out = run_trade(small_trade());
    seconds_of_small_study = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
    return out;
  }();
  return samples;
}

std::vector<TradeSample> of(Varied varied, double value, Boundary boundary = Boundary::periodic) {
  std::vector<TradeSample> found;
  std::ranges::copy_if(small_study(), std::back_inserter(found), [&](const TradeSample& s) {
    return s.varied == varied && s.value == value && s.boundary == boundary;
  });
  return found;
}

/// 3 specimens of 60 grains and 2 of 100; two values, of two specimens each, of the next three quantities;
/// probe and network; 100 grains between smooth and rough walls and without.
constexpr std::size_t samples_in_all = 5 + 4 + 4 + 4 + 4 + 3 * 2;

void check_that_it_is_whole() {
  CHECK(small_study().size() == samples_in_all);
  for (const TradeSample& sample : small_study()) {
    CAPTURE(name(sample.varied));
    CAPTURE(sample.value);
    CHECK(sample.failure == "");
    const bool sheared_only = sample.varied == Varied::shear;
    REQUIRE(sample.shear_modulus.size() == (sheared_only ? 1 : 3));
    CHECK(std::ranges::all_of(sample.shear_modulus, [](double modulus) { return modulus > 1e6; }));
    CHECK(sample.exponent.has_value() != sheared_only);
    CHECK(sample.peak_ratio.has_value() ==
          (sheared_only || sample.varied == Varied::grains || sample.varied == Varied::time_step));
    CHECK(
        (sample.cpu_seconds > 0 && sample.cpu_seconds < seconds_of_small_study)); // one part after the other
    CHECK((sample.steps > 0) == (sample.varied != Varied::probe || sample.value > 0));
  }
}

/// Samples of specimens as they are by default, against the states of verify, to the bit.
void check_against_verify(const Scene& scene, const std::vector<TradeSample>& samples) {
  const std::vector<SpecimenResult> study = run_study(scene);
  const std::vector<ExponentRow> rows = exponents(scene, {study.front()});
  REQUIRE(samples.size() == study.size());
  for (std::size_t k = 0; k < samples.size(); ++k)
    for (std::size_t stage = 0; stage < 3; ++stage) {
      CHECK(samples[k].seed == study[k].seed);
      CHECK(samples[k].shear_modulus[stage] == study[k].states[stage].network().shear_modulus());
    }
  CHECK(*samples[0].exponent == rows.front().network->value);
}

void check_defaults() {
  const TradeSample specimen = of(Varied::grains, 100).front();
  const TradeSample compression = of(Varied::compression, 5e-4).front();
  const TradeSample time_step = of(Varied::time_step, 0.8).front();
  const TradeSample shear = of(Varied::shear, 2e-3).front();
  CHECK(compression.shear_modulus == specimen.shear_modulus);
  CHECK(time_step.shear_modulus == specimen.shear_modulus);
  CHECK(time_step.peak_ratio == specimen.peak_ratio);
  CHECK(shear.peak_ratio == specimen.peak_ratio);
  // Work that does not depend on the varied quantity is not charged to it.
  CHECK(compression.steps < specimen.steps);
  CHECK(shear.steps + compression.steps == time_step.steps);
  CHECK(of(Varied::compression, 1e-3).front().shear_modulus != specimen.shear_modulus);
  CHECK(of(Varied::shear, 4e-3).front().steps < 0.6 * static_cast<double>(shear.steps));
  CHECK(of(Varied::time_step, 0.5).front().steps > time_step.steps);
}

void check_probes_and_walls() {
  const std::vector<TradeSample> probes = of(Varied::probe, 1e-4), networks = of(Varied::probe, 0);
  REQUIRE(probes.size() == 2);
  for (std::size_t k = 0; k < probes.size(); ++k)
    for (std::size_t stage = 0; stage < 3; ++stage) // 1 %: contacts of a small specimen that barely touch
      CHECK(probes[k].shear_modulus[stage] == relative(networks[k].shear_modulus[stage], 0.01));
  const auto mean = [](Boundary boundary) {
    double sum = 0;
    for (const TradeSample& sample : of(Varied::boundary, 100, boundary))
      sum += sample.shear_modulus.at(2) / 2;
    return sum;
  };
  // Without walls the mean of both planes is nearly the isotropic modulus.
  const std::vector<TradeSample> planes = of(Varied::boundary, 100), isotropic = of(Varied::grains, 100);
  REQUIRE(planes.size() == isotropic.size());
  for (std::size_t k = 0; k < planes.size(); ++k)
    for (std::size_t stage = 0; stage < 3; ++stage)
      CHECK(planes[k].shear_modulus[stage] == relative(isotropic[k].shear_modulus[stage], 0.08));
  // Of 100 grains most stand at a wall, and smooth ones bear no shear; specimens scatter by a few per cent.
  CHECK(mean(Boundary::smooth_walls) < 0.8 * mean(Boundary::periodic));
  CHECK(mean(Boundary::rough_walls) > mean(Boundary::smooth_walls));
}

} // namespace

TEST_CASE("a trade study contains every value of every varied quantity, complete, with its cost") {
  check_that_it_is_whole();
  // A default specimen is that of granum verify, to the bit, and the same at the default of every quantity.
  check_against_verify(small_trade().scene, of(Varied::grains, 100));
  check_defaults();
  // Probe and network agree; walls are softer.
  check_probes_and_walls();
}

TEST_CASE(
    "a trade study of unequal grains has as many as their sizes allow, one of equal grains keeps its own") {
  TradeScene trade = small_trade();
  trade.scene.grain.sizes = sizes::parse_distribution("lognormal:0.35");
  trade.scene.study.grains = 300;
  CHECK_THROWS_AS(require_valid(trade), InvalidArgument); // 60 and 100 grains, and 100 between walls
  trade = with_enough_grains(trade);
  CHECK(trade.grains == std::vector<std::size_t>{294});
  CHECK(trade.walls == std::vector<std::size_t>{294});
  trade.grains.push_back(300);
  CHECK_NOTHROW(require_valid(trade));
  CHECK(with_enough_grains(quick_trade()).grains == quick_trade().grains);
  CHECK(with_enough_grains(full_trade()).walls == full_trade().walls);
}

TEST_CASE("a stop keeps finished samples and marks the rest") {
  TradeScene trade = small_trade();
  trade.scene.study.threads = 1;
  std::atomic<bool> stop = false;
  double last = 0;
  const auto report = [&](const Progress& progress) {
    CHECK(progress.done >= last);
    last = progress.done;
    stop = progress.what == "compressions";
  };
  const std::vector<TradeSample> samples = run_trade(trade, {.report = report, .stop = &stop});
  CHECK(samples.size() == samples_in_all);
  CHECK(last == relative(1.0, 1e-12));
  std::size_t whole = 0;
  for (const TradeSample& sample : samples) {
    whole += sample.failure.empty();
    if (!sample.failure.empty()) {
      CHECK(sample.shear_modulus.empty());
      CHECK_FALSE(sample.exponent);
    }
  }
  // The first compression was finished; where a sample needs no more than it, there is one.
  CHECK(whole > 0);
  CHECK(whole < samples.size() / 2);
}

TEST_CASE(
    "a budget cuts the largest of sizes that have about as many grains in all, and two specimens at least") {
  TradeScene full = default_trade();
  full.grains = full_trade().grains;
  // Whatever this machine's speed is and whatever else it does: the speed is given.
  constexpr double speed = 1e-7;
  const auto processor_seconds = [](const TradeScene& study) { return trade::predicted_work(study) * speed; };
  const double all = processor_seconds(full) / static_cast<double>(thread_count(full.scene));
  const TradeScene part = within_budget(full, 0.5 * all, speed);
  CHECK(part.grains.size() >= 2);
  CHECK(part.grains.size() < full.grains.size());
  CHECK(std::equal(part.grains.begin(), part.grains.end(), full.grains.begin()));
  CHECK(processor_seconds(part) <= 0.5 * processor_seconds(full));
  CHECK(within_budget(full, 1.001 * all, speed).grains == full.grains);
  CHECK(within_budget(full, 0.999 * all, speed).grains.size() == full.grains.size() - 1);
  // An engine half as fast fits half as much.
  CHECK(within_budget(full, all, 2 * speed).grains == part.grains);
  CHECK_THROWS_AS((void)within_budget(full, 1, speed), InvalidArgument);
  TradeScene trade = default_trade();
  trade.scene.study.grains = 1000;
  trade.scene.study.seeds = 4;
  for (const auto& [grains, specimens] : {std::pair{250, 16}, {1000, 4}, {2000, 2}, {16000, 2}})
    CHECK(specimens_of(trade, std::size_t(grains)) == std::size_t(specimens));
}

TEST_CASE(
    "studies of a minute, of the default and of everything vary about the defaults, each way by a ladder") {
  for (const TradeScene& trade : {quick_trade(), default_trade(), full_trade()}) {
    CHECK_NOTHROW(require_valid(trade));
    const auto descends = [](const auto& ladder) { return std::ranges::is_sorted(ladder, std::greater{}); };
    CHECK((descends(trade.compression) && descends(trade.shear) && descends(trade.time_step)));
    CHECK((std::ranges::is_sorted(trade.grains) && std::ranges::is_sorted(trade.probe)));
    const auto has = [](const auto& ladder, auto value) { return std::ranges::count(ladder, value) == 1; };
    CHECK(has(trade.grains, trade.scene.study.grains));
    CHECK(has(trade.grains, trade.walls.front()));
    CHECK(has(trade.compression, trade.compression_inertial_number));
    CHECK(has(trade.shear, trade.shear_inertial_number));
    CHECK(has(trade.time_step, trade.time_step_fraction));
    CHECK(trade.scene.study.pressures == std::vector<double>{10e3, 20e3, 50e3, 100e3});
    // Sizes are doubled, and rates and time steps become less by a factor of up to four.
    for (std::size_t k = 1; k < trade.grains.size(); ++k)
      CHECK(trade.grains[k] == 2 * trade.grains[k - 1]);
    for (const std::vector<double>* ladder : {&trade.compression, &trade.shear, &trade.time_step})
      for (std::size_t k = 1; k < ladder->size(); ++k) {
        const double ratio = (*ladder)[k - 1] / (*ladder)[k];
        CHECK((ratio > 1.2 && ratio < 4.1));
      }
  }
  CHECK((default_trade().scene.study.grains == 500 && default_trade().scene.study.seeds == 4));
  CHECK(full_trade().grains.back() == 16000);
}

TEST_CASE("the predicted work of shear tests and probes is that of the measured steps") {
  const TradeScene trade = default_trade();
  trade::Part part{.kind = trade::Kind::shear, .settings = {.grains = 300, .time_step = 0.8, .shear = 2e-4}};
  CHECK(trade::predicted_work(trade, part) == relative(6400 * 300, 0.01)); // strain of 0.004
  part.settings.shear *= 2;
  part.settings.time_step /= 2;
  CHECK(trade::predicted_work(trade, part) == relative(6400 * 300, 0.01));
  part.kind = trade::Kind::probing;
  CHECK(trade::predicted_work(trade, part) == relative(1000 * 4 * 300, 1e-12));
}

TEST_CASE("trade studies are possible within the range of each number") {
  using Change = void (*)(TradeScene&, double);
  const std::pair<double, Change> rows[] = {
      {0.1, [](TradeScene& t, double x) { t.compression_inertial_number = x; }},
      {0.1, [](TradeScene& t, double x) { t.shear_inertial_number = x; }},
      {0.1, [](TradeScene& t, double x) { t.compression[0] = x; }},
      {0.1, [](TradeScene& t, double x) { t.shear[0] = x; }},
      {1, [](TradeScene& t, double x) { t.shear_strain = x; }},
      {1, [](TradeScene& t, double x) { t.time_step[0] = x; }},
      {1, [](TradeScene& t, double x) { t.probe[0] = x; }},
      {1000, [](TradeScene& t, double x) { t.scene.study.seeds = static_cast<std::size_t>(x); }},
      {1e6, [](TradeScene& t, double x) { t.walls[0] = static_cast<std::size_t>(x); }}};
  for (const auto& row : rows)
    check_threshold(row.first, [&](double x) {
      TradeScene trade = small_trade();
      row.second(trade, x);
      try {
        require_valid(trade);
      } catch (const InvalidArgument&) {
        return 0;
      }
      return 1;
    });
}

TEST_CASE("impossible trade studies are refused") {
  void (*const changes[])(TradeScene&) = {
      [](TradeScene& t) { t.scene.study.contacts.push_back(Shape::cone); },
      [](TradeScene& t) { t.scene.study.seeds = 1; },
      [](TradeScene& t) { t.grains = {}; },
      [](TradeScene& t) { t.grains = {20}; },
      [](TradeScene& t) {
        t.grains = {60, 1'000'001};
      },
      [](TradeScene& t) {
        t.grains = {100, 100};
      },
      [](TradeScene& t) { t.compression = {0.5}; },
      [](TradeScene& t) { t.shear = {0}; },
      [](TradeScene& t) { t.time_step = {1.1}; },
      [](TradeScene& t) { t.probe = {0}; },
      [](TradeScene& t) { t.shear_strain = 0; }};
  for (const auto change : changes) {
    TradeScene bad = small_trade();
    change(bad);
    CHECK_THROWS_AS(require_valid(bad), InvalidArgument);
    CHECK_THROWS_AS((void)run_trade(bad), InvalidArgument);
  }
}

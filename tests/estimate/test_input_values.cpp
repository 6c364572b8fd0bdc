// SPDX-License-Identifier: GPL-3.0-or-later
#include <granum/estimate/input_values.hpp>

#include <granum/core/text.hpp>
#include <granum/estimate/answer.hpp>
#include <granum/estimate/notes.hpp>
#include <granum/sands/pooled_law.hpp>

#include "thresholds.hpp"

#include "unit.hpp"

using namespace granum::estimate;

namespace {

InputValues with(std::initializer_list<std::pair<Input, double>> numbers) {
  InputValues values;
  for (const auto& [input, number] : numbers)
    values.give(input, number);
  return values;
}

/// A packing whose density and stress are known, and nothing else.
InputValues usual(double p = 100e3) {
  return with({{Input::void_ratio, 0.6}, {Input::stress_v, p}, {Input::stress_h, p}});
}

/// The refusal of values; empty if they are possible.
std::string refusal(const InputValues& values) {
  try {
    (void)answer(question_of(completed(values)));
    return "";
  } catch (const InvalidArgument& error) {
    return error.what();
  }
}

const UncertainInput& of(const std::vector<UncertainInput>& all, const std::string& name) {
  const auto found = std::find_if(all.begin(), all.end(), [&](const auto& one) { return one.input == name; });
  REQUIRE(found != all.end());
  return *found;
}

} // namespace

TEST_CASE("inputs: several minerals are the mixture of their contacts, and set the moduli") {
  InputValues values = usual();
  values.give(Input::grain, "quartz:70%,calcite:30%");
  values.grain_shape = GrainShape::sphere;
  const Question q = question_of(completed(values));
  const auto quartz = contact::mineral("quartz"), calcite = contact::mineral("calcite");
  const auto mixed =
      effective::mixed_contacts(std::array{quartz.material, calcite.material}, std::array{0.7, 0.3}, 1.0 / 3);
  const doctest::Approx modulus = doctest::Approx(mixed.mean.shear_modulus).epsilon(1e-12);
  CHECK(q.state.law.grain().shear_modulus == modulus);
  REQUIRE(q.state.pair_shares.size() == 3);
  CHECK(q.state.pair_shares[0].stiffness == doctest::Approx(mixed.pair_shares[0].stiffness).epsilon(1e-12));
  CHECK(q.state.pair_shares[2].share == doctest::Approx(mixed.pair_shares[2].share).epsilon(1e-12));
  CHECK(q.grain_density.value() == doctest::Approx(0.7 * quartz.density + 0.3 * calcite.density));
  const double spread = std::hypot(0.7 * quartz.modulus_spread, 0.3 * calcite.modulus_spread);
  CHECK(completed(values)[Input::grain_shear_modulus].deviation ==
        doctest::Approx(spread * mixed.mean.shear_modulus));
  CHECK(refusal(values).empty());
  for (const Input own :
       {Input::grain_shear_modulus, Input::grain_poisson_ratio, Input::grain_bulk_modulus}) {
    InputValues more = values;
    more.give(own, own == Input::grain_poisson_ratio ? 0.1 : 30e9);
    CHECK(refusal(more).find(more.name(own)) != std::string::npos);
  }
  InputValues rough = values;
  rough.give(Input::contact, "rough");
  for (const InputRow& row : inputs())
    if (row.law != nullptr && row.law->shape == rough.contact)
      rough.give(row.input, 1e-7);
  CHECK_FALSE(refusal(rough).empty());
  // A punch is as wide as its grain at most, whatever its grains are of.
  for (const char* const grain : {"quartz", "quartz:70%,calcite:30%"})
    for (const double radius : {1e-6, 0.005, 100.0})
      check_threshold(radius, [&](double punch) {
        InputValues flat = usual();
        flat.give(Input::grain, grain);
        flat.give(Input::contact, "flat");
        flat.give(Input::radius, radius);
        flat.give(find_input("punch_radius")->input, punch);
        return refusal(flat).empty() ? 1 : 0;
      });
  // The one mineral of a sand stays one; grains of glass and steel are spheres.
  InputValues balls = usual();
  balls.give(Input::grain, "glass:50%,steel:50%");
  CHECK(known_shape(balls) == GrainShape::sphere);
}

TEST_CASE("input values: refusals of missing and contradicting inputs name the door's own names") {
  InputValues none;
  CHECK(refusal(none).find("--void-ratio") != std::string::npos);
  none.by_keywords = true;
  CHECK(refusal(none).find("--") == std::string::npos);
  CHECK(refusal(none).find("void_ratio") != std::string::npos);
  InputValues twice = usual();
  twice.give(Input::porosity, 0.4);
  CHECK(refusal(twice).find("--porosity") != std::string::npos);
  InputValues sizes = usual();
  sizes.give(Input::uniformity, 2.0);
  CHECK_THROWS_AS(sizes.give(Input::sizes, std::string("bidisperse:2")), InvalidArgument);
  InputValues cone = usual();
  cone.give(find_input("slope")->input, 0.3);
  for (const char* part : {"--slope", "--contact", "cone", "sphere"})
    CHECK(refusal(cone).find(part) != std::string::npos);
}

TEST_CASE("input values: what is implied follows what is given, and may be completed again") {
  InputValues values;
  values.give(Input::sand, std::string("toyoura"));
  values.give(Input::relative_density, 0.5);
  values.give(Input::stress_v, 100e3);
  values.give(Input::k0, 0.5);
  const InputValues once = completed(values), twice = completed(once);
  CHECK(known_shape(once) == GrainShape::sand);
  CHECK(once.number(Input::stress_h) == 50e3);
  CHECK(once[Input::void_ratio].source == Source::implied);
  const Question q = question_of(once), again = question_of(twice);
  CHECK(q.state.void_ratio == again.state.void_ratio);
  CHECK(q.sand == again.sand);
  const double least = once.number(Input::least_void_ratio), largest = once.number(Input::largest_void_ratio);
  CHECK(q.state.void_ratio == doctest::Approx((least + largest) / 2).epsilon(1e-15));

  // A deviation of D_r moves e, one of sigma_v or K_0 moves sigma_h.
  const std::vector<UncertainInput> moved = uncertain_inputs(
      once, Deviations{{Input::relative_density, 0.1}, {Input::stress_v, 10e3}, {Input::k0, 0.1}});
  CHECK(of(moved, "relative-density").moved(0.1).state.void_ratio ==
        doctest::Approx(q.state.void_ratio - 0.1 * (largest - least)).epsilon(1e-14));
  CHECK(of(moved, "stress-v").moved(10e3).state.stress_h == doctest::Approx(55e3).epsilon(1e-15));
  CHECK(of(moved, "k0").moved(0.1).state.stress_h == doctest::Approx(60e3).epsilon(1e-15));
}

TEST_CASE(
    "input values: K_0 and sigma_h of a row agree within 1 %, silt of a sieve curve is its share by mass") {
  check_threshold(0.01, [](double off) {
    InputValues row = with({{Input::void_ratio, 0.6}});
    row.give(Input::stress_v, 100e3, Source::table);
    row.give(Input::stress_h, 50e3, Source::table);
    row.give(Input::k0, 0.5 * (1 + off), Source::table);
    return refusal(row).empty() ? 0 : 1;
  });
  InputValues sieved = usual();
  sieved.give(Input::sieve, sizes::Distribution::sieve(std::vector<sizes::SievePoint>{
                                {0.02e-3, 0}, {sands::silt_size, 0.04}, {0.5e-3, 1}}));
  const Question q = question_of(completed(sieved));
  CHECK(q.sand.fines.value() == doctest::Approx(0.04).epsilon(1e-12));
  CHECK(q.sand.d50.value() ==
        doctest::Approx(2 * q.state.radius * sieved.sizes->quantile(0.5, 3)).epsilon(1e-12));
  InputValues of_radius = usual();
  of_radius.give(Input::radius, 0.2e-3);
  CHECK(question_of(completed(of_radius)).sand.d50.value() == 2 * 0.2e-3);
}

TEST_CASE("input values: limits of the void ratio may be uncertain, of a sand and of beads") {
  const InputValues known = completed(with({{Input::relative_density, 0.6},
                                            {Input::least_void_ratio, 0.6},
                                            {Input::largest_void_ratio, 0.9},
                                            {Input::pressure, 100e3}}));
  const std::vector<UncertainInput> moved =
      uncertain_inputs(known, Deviations{{Input::least_void_ratio, 0.02}, {Input::largest_void_ratio, 0.03}});
  // The relative density is the given one, e = e_max - D_r (e_max - e_min) follows.
  const Question less = of(moved, "least-void-ratio").moved(-0.02),
                 more = of(moved, "largest-void-ratio").moved(0.03);
  CHECK(less.state.void_ratio == doctest::Approx(0.72 - 0.6 * 0.02).epsilon(1e-14));
  CHECK(less.sand.least_void_ratio.value() == 0.6 - 0.02);
  CHECK(more.state.void_ratio == doctest::Approx(0.72 + 0.4 * 0.03).epsilon(1e-14));
  InputValues beads = usual();
  beads.grain_shape = GrainShape::sphere;
  beads.give(Input::least_void_ratio, 0.56);
  const InputValues of_beads = completed(beads);
  const std::vector<UncertainInput> stated =
      uncertain_inputs(of_beads, Deviations{{Input::least_void_ratio, 0.004}});
  const Question q = of(stated, "least-void-ratio").moved(0.004);
  CHECK(q.preparation.densest_void_ratio == 0.56 + 0.004);
  CHECK(q.state.void_ratio == question_of(of_beads).state.void_ratio);
  CHECK(answer(question_of(of_beads), stated)[Field::mechanical_coordination_number].high >
        answer(question_of(of_beads))[Field::mechanical_coordination_number].high);
}

TEST_CASE("input values: a computed number has the deviation that was set, unless one is stated") {
  InputValues beads = usual();
  beads.grain_shape = GrainShape::sphere;
  beads.give(Input::least_void_ratio, 0.56);
  beads.set_deviation(Input::least_void_ratio, 0.001);
  const auto deviation = [known = completed(beads)](const Deviations& stated) {
    const std::vector<UncertainInput> uncertain = uncertain_inputs(known, stated);
    return std::pair(of(uncertain, "least-void-ratio").deviation, of(uncertain, "least-void-ratio").assumed);
  };
  CHECK(deviation({}) == std::pair(0.001, true));
  CHECK(deviation({{Input::least_void_ratio, 0.005}}) == std::pair(0.005, false));
}

TEST_CASE("input values: deviations are those of defaults, and none of what is given") {
  const std::vector<UncertainInput> assumed = uncertain_inputs(completed(usual()), Deviations{});
  for (const char* input : {"grain-shear-modulus", "grain-poisson-ratio", "fabric", "grain-density"}) {
    CAPTURE(input);
    CHECK(of(assumed, input).assumed);
    CHECK(of(assumed, input).deviation > 0);
  }
  CHECK(assumed.size() == 4);
  InputValues given = usual();
  for (const auto& [input, number] : {std::pair{Input::grain_shear_modulus, 29e9},
                                      {Input::grain_bulk_modulus, 40e9}, // instead of Poisson's ratio
                                      {Input::fabric, 0.0},
                                      {Input::grain_density, 2500.0}})
    given.give(input, number);
  CHECK(uncertain_inputs(completed(given), Deviations{}).empty());
  const std::string texts[] = {"grain-bulk-modulus=10%", "saturation=0.1"};
  const std::vector<UncertainInput> stated = uncertain_inputs(completed(given), texts);
  CHECK(of(stated, "grain-bulk-modulus").deviation == doctest::Approx(4e9).epsilon(1e-15));
  CHECK_FALSE(of(stated, "saturation").assumed);
  const std::string unknown[] = {"grain-poisson-ratio=0.1"};
  CHECK_THROWS_AS((void)uncertain_inputs(completed(given), unknown), InvalidArgument);
}

TEST_CASE("input values: notes are the defaults that a packing uses, with their deviations") {
  const InputValues values = completed(usual());
  const std::vector<UncertainInput> inputs = uncertain_inputs(values, Deviations{});
  const std::vector<Note> notes = notes_of(values, question_of(values), inputs, false);
  std::vector<std::string> names;
  for (const Note& note : notes)
    names.push_back(note.name);
  CHECK(names == std::vector<std::string>{"--contact", "--grain-shear-modulus", "--grain-poisson-ratio",
                                          "--radius", "--tangential-ratio", "--fabric", "--grain-density"});
  CHECK(notes[1].number == 30e9);
  CHECK(notes[1].deviation == doctest::Approx(9e9));
  CHECK(notes[1].sentence().find("9 GPa") != std::string::npos);
}

TEST_CASE("input values: what laws of sands assume is among the notes until it is given") {
  const auto names = [](InputValues values) {
    values.grain_shape = GrainShape::sand;
    const InputValues all = completed(std::move(values));
    std::vector<std::string> assumed;
    for (const Note& note : notes_of(all, question_of(all), {}, true))
      assumed.push_back(note.name.empty() && note.reason.find("G_hh") != std::string::npos ? "G_hh"
                                                                                           : note.name);
    std::erase(assumed, "");
    return assumed;
  };
  CHECK(names(usual()) == std::vector<std::string>{"G_hh", "--uniformity", "--d50"});
  InputValues given = usual();
  given.give(Input::d50, 0.3e-3);
  given.give(Input::uniformity, 2);
  CHECK(names(given) == std::vector<std::string>{"G_hh"});
}

TEST_CASE("input values: a packing is the same by its void ratio, its porosity and its share of solid") {
  for (const auto& [input, number] :
       {std::pair(Input::void_ratio, 0.6), {Input::porosity, 0.375}, {Input::solid_fraction, 0.625}})
    CHECK(question_of(completed(with({{input, number}, {Input::pressure, 1e5}}))).state.void_ratio ==
          doctest::Approx(0.6).epsilon(1e-14));
}

TEST_CASE("input values: what an answer rests on has a note each, where it applies") {
  const auto count = [](GrainShape shape, double p, const auto& change) {
    InputValues values = usual(p);
    values.grain_shape = shape;
    change(values);
    const InputValues all = completed(std::move(values));
    return notes_of(all, question_of(all), {}, shape == GrainShape::sand).size();
  };
  using Change = void (*)(InputValues&);
  const std::pair<int, Change> rows[] = {
      {1,
       [](InputValues& v) {
         v.give(Input::mechanical_coordination_number, 5.0), v.give(Input::rattler_fraction, 0.1);
       }},
      {1, [](InputValues& v) { v.preparation = {.kind = effective::Preparation::Kind::dense}; }},
      {1, [](InputValues& v) { v.give(Input::rolling, 0.1); }},
      {1, [](InputValues& v) { v.give(Input::saturation, 0.5); }},
      {0, [](InputValues& v) { v.give(Input::saturation, 0.0); }},
      {0, [](InputValues& v) { v.give(Input::saturation, 1.0); }},
      {-1, [](InputValues& v) { v.give(Input::d50, 1e-3); }}};
  const auto none = [](InputValues&) {};
  for (const auto& [more, change] : rows)
    CHECK(static_cast<int>(count(GrainShape::sand, 1e5, change)) -
              static_cast<int>(count(GrainShape::sand, 1e5, none)) ==
          more);
  check_threshold(25e3, [&](double p) { return count(GrainShape::sand, p, none); });
  for (const double deviation : {0.3, 0.35, 0.4, 0.45}) { // the note on rattlers goes where they are given
    const sizes::Distribution sizes = sizes::Distribution::lognormal(deviation);
    CHECK(count(GrainShape::sphere, 1e5,
                [&](InputValues& v) { v.give(Input::sizes, "lognormal:" + exact_text(deviation)); }) ==
          count(GrainShape::sphere, 1e5, none) + (sizes::gradation(sizes, 1).uniformity() > 1.75 ? 2 : 1));
  }
  const auto sizes_with = [&](std::optional<Input> known, double value) {
    return count(GrainShape::sphere, 1e5, [&](InputValues& v) {
      v.give(Input::sizes, std::string("lognormal:0.2"));
      if (known)
        v.give(*known, value);
    });
  };
  CHECK(sizes_with(Input::rattler_fraction, 0.1) + 1 == sizes_with({}, 0));
  CHECK(sizes_with(Input::mechanical_coordination_number, 5) + 1 == sizes_with({}, 0));
  InputValues sand = usual(); // E_h as E_v within the deviation of young_anisotropy
  sand.grain_shape = GrainShape::sand;
  const std::string within = "+- " + short_text(100 * sands::young_anisotropy_deviation) + " %";
  const InputValues whole = completed(sand);
  const std::vector<Note> notes = notes_of(whole, question_of(whole), {}, true);
  CHECK(std::count_if(notes.begin(), notes.end(),
                      [&](const Note& note) { return note.reason.find(within) != std::string::npos; }) == 1);
  const auto by_density = [&](bool limits) {
    InputValues values =
        with({{Input::relative_density, 0.5}, {Input::stress_v, 1e5}, {Input::stress_h, 1e5}});
    values.grain_shape = GrainShape::sand;
    if (limits)
      values.give(Input::least_void_ratio, 0.5), values.give(Input::largest_void_ratio, 0.9);
    const InputValues all = completed(std::move(values));
    return notes_of(all, question_of(all), {}, true).size();
  };
  CHECK(by_density(false) == by_density(true) + 1);
}

// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/verify/verify_document.hpp"

#include "studies/synthetic_study.hpp"
#include "unit.hpp"

using namespace granum::cli;
using contact::Shape;
using studies::Verdict;
using triaxial::Density;

namespace {

bool has(const std::string& text, const std::string& part) { return text.find(part) != std::string::npos; }

/// A study of two specimens of power laws, where the second ended early.
struct Study {
  studies::Scene scene = {};
  std::vector<studies::SpecimenResult> specimens = {};
  std::vector<Verdict> verdicts = {
      {"this", true, "1"}, {"that", false, "2"}, {"from theirs", false, "3", true}};

  Study() {
    const std::vector<double> pressures{10e3, 100e3 / 3, 100e3};
    scene.study.contacts = {Shape::sphere, Shape::flat};
    specimens = {studies::test::power_law_specimen(Shape::sphere, Density::dense, 7, 0.34, pressures),
                 studies::test::power_law_specimen(Shape::flat, Density::loose, 8, 0.21, pressures)};
    specimens[1].failure = "stopped on request";
  }
  [[nodiscard]] StudyDocument document(const StudyOptions& options = {}, const Validity& slips = {}) const {
    return study_document(scene, results_of(scene, specimens, verdicts, 1.5, options, slips));
  }
};

} // namespace

TEST_CASE("verify: the screen names each specimen, its end, the exponents and the verdicts") {
  const std::string text = screen(Study().document().document, false);
  for (const char* part :
       {"sphere, dense", "flat, loose", "7\n", "8\n", "stopped on request", // its own reason
        "0.800",                                                            // G network over uniform strain
        "0.340+-0.001", "0.349", "this: 1\n", "that: 2\n", "from theirs: 3\n"})
    CHECK_MESSAGE(has(text, part), part, " is missing in\n", text);
}

TEST_CASE("verify: what is read again from its JSON gives the same page, and the same JSON") {
  Study found;
  found.verdicts.push_back(
      {.claim = "near", .holds = true, .measured = "4", .finding = true, .decided = false});
  Validity slips;
  slips.add("beware");
  StudyOptions options;
  options.scene_file = "a.toml";
  options.settings = {"x=1"};
  const StudyDocument first = found.document(options, slips);
  const nlohmann::ordered_json manifest = with_warnings(json(first.document), slips);
  const StudyDocument again = study_document(found.scene, nlohmann::ordered_json::parse(json_text(manifest)));
  CHECK(has(screen(first.document, false), "near: 4\n"));
  CHECK(page(again.document) == page(first.document));
  CHECK(json(again.document) == json(first.document));
  CHECK(has(page(again.document), "beware"));
  CHECK(manifest.at("specimens").at(1).at("failure") == "stopped on request");
  CHECK(manifest.at("exponents").at(0).at("network").at("value") ==
        studies::exponents(found.scene, found.specimens)[0].network->value);
  CHECK(first.panels.size() == 6);
}

TEST_CASE("verify: the page draws rung 3 of the states, and that of usual forces for runs that lack it") {
  Study found;
  studies::SpecimenResult& first = found.specimens[0];
  for (studies::CompressedState& state : first.states)
    state.packing.state =
        effective::State{.law = studies::law(found.scene, Shape::sphere),
                         .tangential_ratio = studies::tangential_ratio(found.scene),
                         .radius = found.scene.grain.radius,
                         .void_ratio = 0.6,
                         .coordination_number = 5.5,
                         .mechanical_coordination_number = 5.5,
                         .stress_v = state.pressure,
                         .stress_h = state.pressure,
                         .unevenness = effective::Unevenness{.value = 0.2, .standard_error = 0.01}};
  nlohmann::ordered_json results = results_of(found.scene, found.specimens, found.verdicts, 1.5, {}, {});
  const auto drawn = [&] {
    for (const studies::Panel& panel : study_document(found.scene, results).panels)
      for (const plot::Series& series : panel.chart.series)
        if (series.kind.starts_with("rung 3"))
          return series.y;
    return std::vector<double>();
  };
  const std::vector<double> with = drawn();
  REQUIRE(with.size() == first.states.size());
  for (std::size_t k = 0; k < with.size(); ++k)
    CHECK(with[k] == studies::relaxed_modulus(first.states[k]).value());
  for (nlohmann::ordered_json& state : results.at("specimens").at(0).at("states"))
    state.erase("G_rung3_Pa");
  const std::vector<double> without = drawn();
  REQUIRE(without.size() == with.size());
  CHECK(without[0] > 0);
  CHECK(without[0] != with[0]);
}

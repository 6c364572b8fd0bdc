// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/verify/verify_document.hpp"

#include <doctest/doctest.h>

#include "studies/synthetic_study.hpp"

using namespace granum;
using namespace granum::cli;
using contact::Shape;
using studies::Verdict;
using triaxial::Density;

namespace {

bool has(const std::string& text, const std::string& part) { return text.find(part) != std::string::npos; }

/// Two specimens of power laws, the second of which ended early.
StudyOutcome outcome() {
  const std::vector<double> pressures{10e3, 100e3 / 3, 100e3};
  StudyOutcome out;
  out.scene.study.contacts = {Shape::sphere, Shape::flat};
  out.specimens = {studies::test::power_law_specimen(Shape::sphere, Density::dense, 7, 0.34, pressures),
                   studies::test::power_law_specimen(Shape::flat, Density::loose, 8, 0.21, pressures)};
  out.specimens[1].failure = "stopped on request";
  out.exponents = studies::exponents(out.scene, out.specimens);
  out.verdicts = {{"this", true, "1"}, {"that", false, "2"}, {"from theirs", false, "3", true}};
  return out;
}

} // namespace

TEST_CASE("verify: the screen names each specimen, its end, the exponents and the verdicts") {
  const StudyOutcome found = outcome();
  const std::string text = screen(study_document(found.scene, results_of(found, "", {}, {})).document, false);
  for (const char* part :
       {"some ended early", "\nsphere, dense, seed 7\n", "\nflat, loose, seed 8\n",
        "flat, loose, seed 8: ended early: stopped on request", "0.800", // G network over uniform strain
        "0.340+-0.001", "0.349", "  holds    this: 1\n  FAILS    that: 2\n  differs  from theirs: 3\n",
        "0 of 1 results of the paper are reproduced"})
    CHECK_MESSAGE(has(text, part), part, " is missing in\n", text);
}

TEST_CASE("verify: what is read again from its JSON gives the same page, and the same JSON") {
  const StudyOutcome found = outcome();
  Validity slips;
  slips.add("beware");
  const StudyDocument first = study_document(found.scene, results_of(found, "a.toml", {"x=1"}, slips));
  const nlohmann::ordered_json manifest = with_warnings(json(first.document), slips);
  const StudyDocument again = study_document(found.scene, nlohmann::ordered_json::parse(json_text(manifest)));
  CHECK(page(again.document) == page(first.document));
  CHECK(json(again.document) == json(first.document));
  CHECK(has(page(again.document), "beware"));
  CHECK(manifest.at("specimens").at(1).at("failure") == "stopped on request");
  CHECK(manifest.at("exponents").at(0).at("network").at("value") == found.exponents[0].network->value);
  CHECK(first.panels.size() == 6);
}

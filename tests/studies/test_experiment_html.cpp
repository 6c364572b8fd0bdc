// SPDX-License-Identifier: GPL-3.0-or-later
#include "studies/reproduce/experiment_html.hpp"

#include "studies/reproduce/experiment_findings.hpp"
#include <doctest/doctest.h>

#include "count_pieces.hpp"
#include "synthetic_experiment.hpp"
#include "well_formed.hpp"

using namespace granum;
using namespace granum::studies;

namespace {

std::string report(const Experiment& experiment, const RunTime& time = {.seconds = 90}) {
  return experiment_report(experiment, experiment_verdicts(experiment), experiment_figures(experiment),
                           assembly_picture(experiment), time)
      .html;
}

/// The page without its script, which is no markup.
std::string markup(std::string page) {
  const std::size_t from = page.find("<script>"), end = page.find("</script>");
  return page.erase(from, end + 9 - from);
}

} // namespace

TEST_CASE("a report opens with the question, the answer and one figure, and folds the rest away") {
  const Experiment experiment = synthetic::experiment();
  const std::string html = report(experiment);
  CHECK(well_formed(markup(html)));
  std::size_t last = 0;
  for (const char* part : {"<h1>Why does the stiffness",
                           "In dense packings s is",
                           "In loose packings",
                           "data-choice=\"G_hv\"",
                           "id=\"why\"",
                           "One contact",
                           "Contacts of a grain",
                           "G relative to uniform strain",
                           "id=\"verdicts\"",
                           "<details>",
                           "Table 2:",
                           "Table 4:",
                           "Table 5:",
                           "Fig. 3:",
                           "Fig. 4:",
                           "Fig. 6:",
                           "Fig. 7:",
                           "Fig. 9:",
                           "Fig. 14:",
                           "Fig. 15:",
                           "Fig. 16:",
                           "Fig. 17:",
                           "Fig. 19:",
                           "id=\"run\"",
                           "What was run",
                           "How to read this",
                           "Left out"}) {
    CAPTURE(part);
    const std::size_t at = html.find(part, last);
    CHECK(at != std::string::npos);
    last = at;
  }
  std::size_t panels = 1 + 6; // the assembly, and those that come first
  for (const Figure& figure : experiment_figures(experiment))
    panels += figure.panels.size();
  CHECK(count(html, "<svg ") == panels);
  CHECK(count(html, "<?xml") == 0);
  CHECK(count(markup(html), "nan") == 0);
  CHECK(count(html, "href=\"figures/fig09_cone_dense_G_hv_p.csv\"") == 1);
  CHECK(count(html, "href=\"figures/log_G_log_p_G_hv.csv\"") == 1);
  // Nothing from outside.
  CHECK(count(html, "http") == 0);
  CHECK(count(html, "src=") == 0);
  CHECK(count(html, "<link") == 0);
  CHECK(html.find("90 s") != std::string::npos);
  CHECK(report(experiment, {.seconds = 600, .resumed = true}).find("10 min, since it was resumed") !=
        std::string::npos);
}

TEST_CASE("the files of the first pictures are among the report's panels") {
  const Experiment experiment = synthetic::experiment();
  const auto panels = experiment_report(experiment, {}, {}, {}, {}).panels;
  REQUIRE(panels.size() == 6);
  CHECK(panels[0].stem == "log_G_log_p_G_hv");
  CHECK(panels[5].stem == "relaxation");
}

TEST_CASE("a result that contradicts the paper differs, and a check of granum passes or fails") {
  Experiment experiment = synthetic::experiment();
  const std::vector<Verdict> verdicts = experiment_verdicts(experiment);
  CHECK(!differing_findings(verdicts).empty()); // C_n of the loose specimens
  // G_hv and G_vh of the probes differ by 1 %; 2 % are allowed.
  CHECK(failed_checks(verdicts).empty());
  for (ExperimentSpecimen& specimen : experiment.specimens)
    for (PathRun& run : specimen.runs)
      for (StateRecord& point : run.points)
        if (point.probes)
          point.probes->G_hv *= 1.1;
  const std::vector<Verdict> failed = failed_checks(experiment_verdicts(experiment));
  REQUIRE(failed.size() == 1);
  CHECK(failed[0].claim.starts_with("G_vh = G_hv"));
  CHECK(report(experiment).find("FAILS: G_vh = G_hv") != std::string::npos);
}

TEST_CASE("a report shows our number with its error next to the printed one") {
  const Experiment experiment = synthetic::experiment();
  const std::string html = report(experiment);
  // Dense cones: C_n = 6 +- 0.05, the paper has 5.90, which is within 0.4, as is asked for.
  const std::string row = html.substr(html.find("C_n</td>"), 300);
  for (const char* piece : {"6 \u00b1 0.05<", ">5.9<", ">yes<"}) {
    CAPTURE(piece);
    CHECK(row.find(piece) != std::string::npos);
  }
  // Loose cones: 3.91.
  const std::string loose = html.substr(html.find(">loose</td>"), 400);
  CHECK(loose.find(">3.91<") != std::string::npos);
  CHECK(loose.find(">no<") != std::string::npos);
}

TEST_CASE("a report lists omitted parts, with markup escaped") {
  Experiment experiment = synthetic::experiment();
  CHECK(report(experiment).find("Nothing: every path ran to its end") != std::string::npos);
  experiment.specimens[4].runs[1].failure = "stress < 0 & \"unstable\"";
  experiment.specimens[4].runs[2].notes = {"a state at eta > 1 did not come to rest"};
  const std::string html = report(experiment);
  CHECK(well_formed(markup(html)));
  CHECK(html.find("flat, dense, seed 1, TXC: ended early: stress &lt; 0 &amp; &quot;unstable&quot;") !=
        std::string::npos);
  CHECK(html.find("flat, dense, seed 1, RTXC: a state at eta &gt; 1") != std::string::npos);
  CHECK(html.find("no, see the end of this page") != std::string::npos);
}

TEST_CASE("a report without any data is a page all the same") {
  const std::string html = report(Experiment{});
  CHECK(well_formed(markup(html)));
  CHECK(html.find("Nothing was measured") != std::string::npos);
  CHECK(html.find("No figures.") != std::string::npos);
}

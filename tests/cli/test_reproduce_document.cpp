// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/reproduce/reproduce_document.hpp"

#include "studies/count_pieces.hpp"
#include "synthetic_experiment.hpp"
#include "unit.hpp"
#include "well_formed.hpp"

using namespace granum::cli;
using studies::count;
using studies::Verdict;

namespace {

ExperimentDocument document(const Experiment& experiment, const RunTime& time = {.seconds = 90}) {
  return experiment_document(experiment, experiment_verdicts(experiment), time);
}

/// The page without its script, which is no markup.
std::string markup(const Experiment& experiment, const RunTime& time = {.seconds = 90}) {
  std::string text = page(document(experiment, time).document);
  const std::size_t from = text.find("<script>"), end = text.find("</script>");
  return text.erase(from, end + 9 - from);
}

const std::string& file(const ExperimentDocument& of, const std::string& name) {
  const auto found = std::ranges::find(of.files, name, &Files::value_type::first);
  REQUIRE_MESSAGE(found != of.files.end(), name);
  return found->second;
}

bool has(const std::string& text, const std::string& part) { return text.find(part) != std::string::npos; }

} // namespace

TEST_CASE("reproduce: the page begins with the answer, and folds figures and tables") {
  const Experiment experiment = synthetic::experiment();
  const std::string html = markup(experiment);
  CHECK(well_formed(html));
  std::size_t last = 0;
  for (const char* part :
       {"<h1>", "data-choice=\"G_hv\"", "<details>", "Fig. 3:", "Fig. 4:", "Fig. 9:", "Fig. 15:", "Fig. 19:",
        "Table 2:", "Table 4:", "Table 5:", "Chung2014</a>]", "<td id=\"Chung2014\">"}) {
    CAPTURE(part);
    last = html.find(part, last);
    CHECK(last != std::string::npos);
  }
  std::size_t panels = 1 + 6; // the assembly, and those that come first
  for (const Figure& figure : experiment_figures(experiment))
    panels += figure.panels.size();
  CHECK(count(html, "<svg ") == panels);
  CHECK(document(experiment).panels.size() == panels - 1);
  CHECK(count(html, "nan") == 0);
  CHECK(count(html, "href=\"figures/fig09_cone_dense_G_hv_p.csv\"") == 1);
  // Nothing from outside.
  for (const char* part : {"http:", "src=", "<link"})
    CHECK(count(html, part) == 0);
  CHECK(count(html, "https:") == 2 * count(html, "<a href=\"https:")); // addresses of sources
  CHECK(has(html, "90.0 s"));
  CHECK(markup(experiment, {.seconds = 90, .resumed = true}) != html);
}

TEST_CASE("reproduce: a result that contradicts the paper differs, and a check of granum passes or fails") {
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
  CHECK(has(screen(document(experiment).document, false), "\n  FAILS      G_vh = G_hv"));
}

TEST_CASE("reproduce: our number with its error is next to the printed one, on screen, page and in files") {
  const Experiment experiment = synthetic::experiment();
  // Dense cones: C_n = 6 +- 0.05, the paper has 5.90, within 0.4 as is asked for. Loose cones: 3.91.
  const ExperimentDocument of = document(experiment);
  CHECK(has(screen(of.document, false),
            "cone     dense   C_n                                    6+-0.05   5.9       yes\n"));
  CHECK(has(file(of, "table2.csv"),
            "contact,density,quantity,granum,standard_error,paper,difference,reach,within\n"
            "cone,dense,C_n,6,0.05,5.9,0.09999999999999964,0.4,yes\n"));
  CHECK(has(file(of, "table2.csv"), "cone,loose,C_n,6,0.05,3.91,2.09,0.4,no\n"));
  const std::string html = markup(experiment);
  const std::string row = html.substr(html.find("C_n</td>"), 300);
  for (const char* piece : {"6 \u00b1 0.05<", ">5.9<", ">yes<"})
    CHECK_MESSAGE(has(row, piece), piece);
  const nlohmann::ordered_json all = json(of.document);
  CHECK(all.at("table_2").at(0).at("within") == true);
  CHECK(all.at("runs").at(1).at("path") == "TXC");
  CHECK(all.at("complete") == true);
}

TEST_CASE("reproduce: a cell that is too uncertain is undecided, and null in JSON") {
  studies::Cell cell{.quantity = "s of G_hv", .ours = {0.53, 0.05}, .printed = 0.53, .reach = 0.04};
  const Table table = table_of_cells("cells", "", {cell});
  CHECK(has(io::csv_text(table.columns, table.rows), ",0.04,undecided\n"));
  CHECK(members_of({{Seen::always, table}}).at("cells").at(0).at("within").is_null());
}

TEST_CASE("reproduce: omitted parts are listed, with markup escaped") {
  Experiment experiment = synthetic::experiment();
  experiment.specimens[4].runs[1].failure = "stress < 0 & \"unstable\"";
  experiment.specimens[4].runs[2].notes = {"a state at eta > 1 did not come to rest"};
  const std::string html = markup(experiment);
  CHECK(well_formed(html));
  CHECK(has(html, "stress &lt; 0 &amp; &quot;unstable&quot;"));
  CHECK(has(html, "a state at eta &gt; 1"));
}

TEST_CASE("reproduce: files have a row for each state, and empty cells for missing measurements") {
  Experiment experiment = synthetic::experiment();
  experiment.specimens[0].runs[0].points[0].probes.reset();
  std::size_t points = 0, curve = 0;
  for (const ExperimentSpecimen& specimen : experiment.specimens)
    for (const PathRun& run : specimen.runs) {
      points += run.points.size();
      curve += run.curve.size();
    }
  const ExperimentDocument of = document(experiment);
  const std::string& states = file(of, "states.csv");
  CHECK(count(states, "\n") == 4 + 1 + points);
  CHECK(has(states, "cone,dense,1,ISO,0,25000,25000,25000,"));
  CHECK(count(states, "nan") == 0);
  CHECK(count(file(of, "curves.csv"), "\n") == 4 + 1 + curve);
  CHECK(count(file(of, "histograms.csv"), "\n") ==
        4 + 1 + points * (studies::polar_bins + studies::force_bins));
}

TEST_CASE("reproduce: a document without any data is a page all the same") {
  CHECK(well_formed(markup(Experiment{})));
}

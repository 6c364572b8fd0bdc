// SPDX-License-Identifier: GPL-3.0-or-later
#include "studies/reproduce/experiment_findings.hpp"

#include "fitted_experiment.hpp"
#include "unit.hpp"

using namespace granum::studies;
using contact::Shape;
using stress::ShearPath;
using triaxial::Density;

namespace {

Cell cell(const std::vector<Cell>& cells, const std::string& quantity) {
  const auto found = std::ranges::find(cells, quantity, &Cell::quantity);
  REQUIRE(found != cells.end());
  return *found;
}

Scene one_kind(Shape contact = Shape::sphere, Density density = Density::dense) {
  Scene scene;
  scene.study.contacts = {contact};
  scene.study.densities = {density};
  return scene;
}

/// Claims that do not hold.
std::vector<Verdict> not_confirmed(const Experiment& experiment) {
  std::vector<Verdict> all = experiment_verdicts(experiment);
  std::erase_if(all, [](const Verdict& v) { return v.holds; });
  return all;
}

} // namespace

TEST_CASE("Table 5 gives back the exponents that the moduli were made with") {
  const Synthetic made{.C = 640, .m = 0.23, .n = 0.11};
  const auto rows = table_5(synthetic_experiment(one_kind(), made));
  REQUIRE(rows.size() == 5);
  CHECK(cell(rows, "m of G_hv").ours.value == relative(0.23, 1e-9));
  CHECK(cell(rows, "n of G_hv").ours.value == relative(0.11, 1e-9));
  CHECK(cell(rows, "s of G_hv").ours.value == relative(0.34, 1e-9));
  CHECK(cell(rows, "s of G_hh").ours.value == relative(0.34, 1e-9));
  CHECK(cell(rows, "C of G_hv").ours.value == relative(640, 1e-9));
  CHECK(*cell(rows, "s of G_hv").printed == 0.349);
  const auto further = further_exponents(synthetic_experiment(one_kind(), made));
  CHECK(cell(further, "exponent of sigma_h in G_hh").ours.value == relative(0.34, 1e-9));
  CHECK(std::abs(cell(further, "exponent of sigma_v in G_hh").ours.value) < 1e-9);
  CHECK(cell(further, "s of G_vh, probes").ours.value == relative(0.34, 1e-9));
}

TEST_CASE("Table 5 looks at |eta| <= 0.6 only, and not at states past the peak that fall below it") {
  Experiment experiment = synthetic_experiment(one_kind());
  for (PathRun& run : experiment.specimens[0].runs)
    for (StateRecord& point : run.points)
      if (std::abs(point.at.stress.ratio()) > 0.61)
        for (double& c : point.network)
          c *= 0.1;
  StateRecord residual = synthetic_point({.C = 10}, 120e3, 100e3, 0.03);
  experiment.specimens[0].runs[1].points.push_back(residual);
  CHECK(cell(table_5(experiment), "s of G_hv").ours.value == relative(0.35, 1e-9));
}

TEST_CASE("Table 4 turns the peak into a friction angle, and averages over seeds with the scatter as error") {
  Scene scene = one_kind();
  scene.study.seeds = 2;
  Experiment experiment{.scene = scene, .specimens = {}};
  std::array<double, 2> angles{25.0, 27.0};
  for (std::size_t k = 0; k < 2; ++k) {
    const double sine = std::sin(angles[k] * std::numbers::pi / 180);
    const Synthetic made{.peak_eta = 6 * sine / (3 - sine)};
    experiment.specimens.push_back(synthetic_specimen(scene, Shape::sphere, Density::dense, k + 1, made));
  }
  const Cell txc = cell(table_4(experiment), "TXC [deg]");
  CHECK(txc.ours.value == relative(26, 1e-12));
  // Scatter of two values 2 apart: sqrt(2); of their mean: 1.
  CHECK(*txc.ours.standard_error == relative(1, 1e-12));
  CHECK(*txc.printed == 26.0);
  CHECK(txc.agreement() == Agreement::within);
  const Cell rtxe = cell(table_4(experiment), "RTXE [deg]");
  CHECK(rtxe.ours.value != relative(26, 1e-3));
}

TEST_CASE("Table 2 shows the first state, with the error of one specimen or the scatter of several") {
  const auto rows = table_2(synthetic_experiment(one_kind()));
  CHECK(cell(rows, "C_n").ours.value == 5.8);
  CHECK(*cell(rows, "C_n").ours.standard_error == relative(0.05, 1e-14));
  CHECK(cell(rows, "C_n").agreement() == Agreement::within);
  CHECK_FALSE(cell(rows, "e").ours.standard_error.has_value());
  Experiment walled = synthetic_experiment(one_kind());
  walled.specimens[0].runs[0].points[0].void_ratio = 0.62; // of the whole box, its layers at walls included
  CHECK(cell(table_2(walled), "e").ours.value == 0.56);
  const auto off =
      table_2(synthetic_experiment(one_kind(Shape::sphere, Density::loose), {.void_ratio = 0.6}));
  CHECK(cell(off, "C_n").agreement() == Agreement::beyond); // 5.8 against 3.50
}

TEST_CASE("a path that failed has no peak, and leaves its cell out") {
  Experiment experiment = synthetic_experiment(one_kind());
  experiment.specimens[0].runs[1].failure = "why";
  CHECK(table_4(experiment).size() == 3);
  CHECK(std::ranges::count(not_confirmed(experiment), "why", &Verdict::measured) == 1);
  CHECK_FALSE(experiment.complete());
}

TEST_CASE("claims on the structure and on G_vh = G_hv of dense specimens look at the states they are about") {
  Experiment experiment = synthetic_experiment(one_kind());
  std::vector<PathRun>& runs = experiment.specimens[0].runs;
  const std::size_t before = not_confirmed(experiment).size();
  runs[1].points.back().probes->G_vh *= 1.1; // at the peak: not looked at, by 0.9 of it only
  CHECK(not_confirmed(experiment).size() == before);
  runs[1].points[2].probes->G_vh *= 1.03;
  CHECK(not_confirmed(experiment).size() == before + 1);
  StateRecord& early = runs[2].points[4];
  early.micro.coordination_number *= 0.96; // 3 % are claimed
  CHECK(not_confirmed(experiment).size() == before + 2);
  early.micro.fabric_anisotropy = -0.04; // 0.03 is claimed
  CHECK(not_confirmed(experiment).size() == before + 3);
  runs[3].points.back().micro.fabric_anisotropy = 0.4; // the wrong sense in extension
  CHECK(not_confirmed(experiment).size() == before + 4);
}

TEST_CASE("flat contacts: G constant is claimed of dense specimens, and not of loose ones") {
  const auto of = [](Density density, const Synthetic& made) {
    return not_confirmed(synthetic_experiment(one_kind(Shape::flat, density), made)).size();
  };
  const Synthetic constant{.m = 0, .n = 0}, growing{.m = 0.2, .n = 0.2};
  CHECK(of(Density::dense, constant) < of(Density::dense, growing));
  CHECK(of(Density::loose, constant) > of(Density::loose, growing));
  const std::vector<Verdict> before = not_confirmed(synthetic_experiment(one_kind(Shape::flat), constant));
  for (const bool horizontal : {true, false}) { // one of both moduli
    Experiment experiment = synthetic_experiment(one_kind(Shape::flat), constant);
    std::array<double, 36>& network = experiment.specimens[0].runs[2].points[1].network;
    for (const int place : horizontal ? std::vector{35} : std::vector{21, 28})
      network[static_cast<std::size_t>(place)] *= 1.1;
    CHECK(std::ranges::any_of(not_confirmed(experiment), [&](const Verdict& v) {
      return std::ranges::none_of(before, [&](const Verdict& b) { return b.claim == v.claim; });
    }));
  }
}

TEST_CASE("a cell whose standard error exceeds the tolerance is undecided, near or far") {
  using enum Agreement;
  const struct {
    TableValue ours;
    std::optional<double> reach;
    Agreement expected;
  } rows[] = {{{0.5, 0.02}, 0.04, within},     {{0.6, 0.02}, 0.04, beyond}, {{0.6, 0.05}, 0.04, undecided},
              {{0.53, 0.05}, 0.04, undecided}, {{0.53, {}}, 0.04, within},  {{0.53, {}}, {}, not_asked}};
  for (const auto& [ours, reach, expected] : rows)
    CHECK(Cell{.quantity = "s", .ours = ours, .printed = 0.53, .reach = reach}.agreement() == expected);
}

TEST_CASE("a claim of Table 5 is not confirmed if its exponents are too uncertain") {
  Experiment experiment = synthetic_experiment(one_kind());
  const std::size_t before = not_confirmed(experiment).size();
  double factor = 1.5;
  for (PathRun& run : experiment.specimens[0].runs)
    for (StateRecord& point : run.points) {
      factor = 1 / factor;
      for (const std::size_t index : {21u, 28u, 35u})
        point.network[index] *= factor;
    }
  const auto rows = table_5(experiment);
  CHECK(cell(rows, "s of G_hv").agreement() == Agreement::undecided);
  CHECK(not_confirmed(experiment).size() > before);
}

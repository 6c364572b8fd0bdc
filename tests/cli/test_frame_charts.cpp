// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/reproduce/figures.hpp"

#include <fstream>
#include <numbers>
#include <set>

#include <fmt/format.h>

#include "cli/analyse/analyse.hpp"
#include "cli/reproduce/reproduce_document.hpp"
#include "cli/trade/trade.hpp"
#include "studies/reproduce/experiment_findings.hpp"
#include <granum/core/text.hpp>
#include <granum/effective/relaxation.hpp>
#include <granum/fabric/orientation.hpp>
#include <granum/io/csv/table.hpp>

#include "io/temporary_folder.hpp"
#include "studies/count_pieces.hpp"
#include "studies/read_specimen.hpp"
#include "studies/written_packing.hpp"
#include "synthetic_experiment.hpp"
#include "thresholds.hpp"
#include "unit.hpp"

using namespace granum::cli;
using studies::count;
using triaxial::Density;

namespace {

constexpr double pi = std::numbers::pi;

/// Frames of one packing whose network has G ~ p^0.4.
AnalyseAnswer analysed_states(const std::vector<double>& pressures) {
  AnalyseAnswer answer;
  for (const double p : pressures) {
    FrameAnswer frame;
    frame.measured.contacts_known = true;
    frame.measured.packing.void_ratio = 0.6;
    frame.measured.packing.counts.coordination_number = 5 + 1e-6 * p;
    frame.measured.packing.counts.mechanical.coordination_number = 6 + 1e-6 * p;
    frame.measured.packing.stress.emplace().symmetric = Mat3::diagonal(p, p, p);
    const double G = 100e6 * std::pow(p / 100e3, 0.4);
    for (const effective::Rung& rung : effective::rungs())
      frame.rungs.push_back(
          {.name = rung.column, .title = rung.column, .moduli = studies::Moduli{.K = 2 * G, .G = G}});
    answer.frames.push_back(frame);
  }
  answer.series = studies::series_of(answer.frames, studies::SeriesBy::all);
  return answer;
}

} // namespace

TEST_CASE("charts of states are there from stresses that vary by a tenth, in the order of the stresses") {
  check_threshold(1.1, [](double x) { return !state_pictures(analysed_states({x * 50e3, 50e3})).empty(); });
  CHECK(state_pictures(analysed_states({})).empty());
  const AnalyseAnswer answer = analysed_states({40e3, 10e3, 20e3});
  const std::vector<Picture> all = state_pictures(answer);
  REQUIRE(all.size() == 5);
  for (const Picture& one : all) {
    const plot::Chart& chart = one.charts.front();
    CHECK(chart.x.unit == 1e3);
    CHECK(chart.y.unit == (chart.y.title.find("[MPa]") != std::string::npos ? 1e6 : 1));
    for (const plot::Series& series : chart.series)
      CHECK(series.x == std::vector{10e3, 20e3, 40e3});
  }
  REQUIRE(all[0].charts.front().series.size() == 3); // network, rung 3, and the law through them
  for (const plot::Series& series : all[0].charts.front().series)
    for (std::size_t k = 0; k < 3; ++k)
      CHECK(series.y[k] == relative(100e6 * std::pow(series.x[k] / 100e3, 0.4), 1e-6));
  const double last[] = {2 * all[0].charts[0].series[0].y[2], 6.04, 5.04, 0.6}; // K, z*, C_n, e
  for (std::size_t k = 0; k < 4; ++k)
    CHECK(all[k + 1].charts.front().series.front().y[2] == relative(last[k], 1e-12));
}

TEST_CASE("charts of a frame: directions beside even ones, forces that occur, and rungs beside the network") {
  FrameAnswer frame = analysed_states({50e3}).frames.front();
  frame.measured.packing.fabric.emplace();
  analysis::Fabric& fabric = *frame.measured.packing.fabric;
  for (std::size_t k = 0; k < 18; ++k)
    fabric.rose.push_back({.count = 10 + k});
  const auto longer = [&](double a) {
    fabric.by_moment.anisotropy = a;
    return rose_chart(frame).finding.find("vertical") != std::string::npos;
  };
  CHECK((longer(0.1) && !longer(-0.1)));
  const std::vector<plot::Series> rose = rose_chart(frame).series;
  REQUIRE(rose.size() == 3);
  double total = 0;
  const double width = pi / 2 / static_cast<double>(rose[0].x.size());
  for (std::size_t k = 0; k < rose[0].x.size(); ++k)
    total +=
        rose[0].y[k] * 4 * pi * (std::cos(rose[0].x[k] - width / 2) - std::cos(rose[0].x[k] + width / 2));
  CHECK(total == relative(1, 1e-12));
  CHECK((rose[1].x.size() == 91 && rose[1].x.back() == relative(pi / 2, 1e-14)));
  for (std::size_t k = 0; k < 91; ++k)
    CHECK(rose[1].y[k] == fabric::density(rose[1].x[k], -0.1));
  for (std::size_t k = 0; k < 5; ++k)
    CHECK(std::abs(rose[2].x[k] - pi / 8 * static_cast<double>(k)) +
              std::abs(rose[2].y[k] - fabric::density(rose[2].x[k], 0)) <
          1e-15);

  frame.measured.packing.forces.emplace().distribution.bins = {
      {0, 1, 4, 0.4, 0.2}, {1, 2, 0, 0, 0}, {2, 3, 1, 0.1, 0.1}, {3, 4, 2, 0.2, 0.1}};
  const plot::Series forces = force_chart(frame).series.front();
  CHECK(forces.x == std::vector{0.5, 2.5, 3.5});
  CHECK(forces.y == std::vector{0.4, 0.1, 0.2});
  CHECK(forces.y_error == std::vector{0.2, 0.0, 0.1}); // one contact has no error

  for (RungResult& rung : frame.rungs)
    rung.relative_error = effective::ModulusErrors{.G_vh = 0.1};
  const plot::Chart rungs = rung_chart(frame);
  CHECK(rungs.y.unit == 1e6);
  const double G = frame.rungs.front().moduli->G;
  std::multiset<double> places;
  for (std::size_t s = 0; s + 1 < rungs.series.size(); ++s)
    for (std::size_t k = 0; k < rungs.series[s].x.size(); ++k) {
      places.insert(rungs.series[s].x[k]);
      CHECK((rungs.series[s].y[k] == G && rungs.series[s].y_error[k] == relative(0.1 * G, 1e-14)));
    }
  std::multiset<double> expected;
  for (const effective::Rung& rung : effective::rungs())
    if (rung.number && rung.name != effective::RungName::network)
      expected.insert(*rung.number);
  CHECK(places == expected);
  CHECK(rungs.series.back().y == std::vector{G, G});
  CHECK((megapascal(336.4e6) == "336 MPa" && rungs.finding.ends_with(megapascal(G))));
}

TEST_CASE("of more than eight files the first and last of each kind are named, and how many are between") {
  const auto named = [](std::size_t grains, std::size_t contacts) {
    AnalyseAnswer answer = analysed_states({50e3});
    for (std::size_t k = 0; k < grains + contacts; ++k) {
      answer.files.push_back(fmt::format("file{}.x", k));
      answer.kinds.push_back(
          {.format = io::packing_formats[0], .holds = k < grains ? io::Holds::grains : io::Holds::contacts});
    }
    return screen(analysed(answer), false);
  };
  AnalyseAnswer softer = analysed_states({50e3}); // the page names the difference of rung 3
  for (RungResult& rung : softer.frames[0].rungs)
    rung.moduli->G *= rung.name == studies::relaxed_name() ? 1.1 : 1;
  CHECK(page(analysed(softer)).find("+10.0 %") != std::string::npos);
  CHECK((count(named(8, 0), ".x:") == 8 && count(named(4, 4), ".x:") == 8));
  const std::string nine = named(9, 0), both = named(7, 3), pairs = named(7, 2);
  CHECK((count(nine, ".x:") == 2 && count(nine, " 7 more") == 1));
  CHECK((count(both, ".x:") == 4 && count(both, " 5 more") == 1 && count(both, " 1 more") == 1));
  CHECK((count(pairs, ".x:") == 4 && count(pairs, " more") == 1));
}

namespace {

/// Frames of a specimen at two pressures, with everything that can be asked for.
AnalyseAnswer measured_answer() {
  AnalyseAnswer answer;
  for (const packing::Assembly& assembly : samples::specimen_at({50e3, 100e3}, 60)) {
    studies::MeasureOptions options{.given = {.grain_shear_modulus = 30e9, .grain_density = 2650},
                                    .wanted = analysis::everything(),
                                    .profile = studies::ProfileChoice{.axis = 2, .slices = 2},
                                    .modes = 2};
    answer.frames.push_back(studies::answer_frame(samples::through_csv(assembly), options));
    answer.frames.back().code_stress = studies::PrintedStress{1e5, 1e5, 1e5, 1, 1, 1};
    answer.frames.back().probes = {{.modulus = "G", .value = 1e8, .network_over_probe = 1}};
  }
  answer.series = studies::series_of(answer.frames, studies::SeriesBy::all);
  return answer;
}

studies::TradeRow trade_row(studies::Varied varied, double value, double x) {
  studies::TradeRow row;
  row.varied = varied;
  row.value = value;
  row.specimens = 3;
  row.reference = x > 0.5;
  row.cpu_seconds = 10 * x;
  row.steps = 1000 * x;
  row.shear_modulus = studies::Deviation{.bias = 0.01 * x, .standard_error = 0.02 * x, .scatter = 0.03 * x};
  row.exponent = studies::Deviation{.bias = 0.04 * x, .standard_error = 0.05 * x, .scatter = 0.06 * x};
  return row;
}

} // namespace

TEST_CASE("every column and axis is in the unit of its title, on the screen, in files and in pictures") {
  std::set<std::string> units;
  const auto check = [&](const std::string& title, double factor) {
    const std::size_t open = title.find('[');
    const std::string unit =
        open == std::string::npos ? "" : title.substr(open + 1, title.find(']') - open - 1);
    CAPTURE(title);
    const auto known = find_unit(unit);
    units.insert(unit);
    if (known || unit == "10\u207b\u2076" || unit == "1/sr" || unit.empty())
      CHECK(factor == relative(known ? known->factor : unit.starts_with("10") ? 1e-6 : 1, 1e-14));
  };
  const auto check_shown = [&](const io::ShownColumn& shown, const std::string& of_all) {
    const bool quotient = shown.heading.find('/') != std::string::npos; // has no unit
    std::string title = shown.heading + (quotient || !shown.symbol.empty() ? "" : of_all);
    if (!shown.symbol.empty())
      title += " [" + std::string(trimmed(shown.symbol)) + "]";
    if (title.find('[') != std::string::npos && !shown.dimension)
      check(title, shown.unit);
  };
  std::vector<studies::TradeRow> rows;
  for (const studies::Varied varied : studies::all_varied)
    for (const double x : {0.25, 0.375, 0.75})
      rows.push_back(trade_row(varied, 1000 * x, x));
  const Experiment experiment = synthetic::experiment();
  for (const Document& document :
       {analysed(measured_answer()),
        experiment_document(experiment, experiment_verdicts(experiment), {}).document, rows_document(rows),
        trade_document({.trade = studies::default_trade(), .samples = {}, .rows = rows}, {})})
    for (const Section& section : document.sections) {
      if (const auto* table = std::get_if<Table>(&section.what)) {
        std::string of_all; // the unit of a whole table is the heading of its names
        for (const auto& column : table->columns)
          if (column.shown && column.shown->heading.starts_with('['))
            of_all = column.shown->heading;
          else if (column.shown)
            check_shown(*column.shown, of_all);
      }
      if (const auto* items = std::get_if<Items>(&section.what))
        for (const auto& item : items->items)
          if (item.shown)
            check_shown(*item.shown, "");
      if (const auto* picture = std::get_if<Picture>(&section.what))
        for (const plot::Chart& chart : picture->charts)
          for (const plot::Axis& axis : {chart.x, chart.y})
            check(axis.title, axis.unit);
    }
  for (const Figure& figure : experiment_figures(experiment))
    for (const Panel& panel : figure.panels)
      for (const plot::Axis& axis : {panel.chart.x, panel.chart.y})
        check(axis.title, axis.unit);
  for (const char* unit : {"kPa", "MPa", "%", "mm", "10\u207b\u2076", "1/sr", ""})
    CHECK_MESSAGE(units.contains(unit), unit);
}

TEST_CASE("rows of a trade study go through their CSV file, laws are shown where they have a scatter") {
  std::vector<studies::TradeRow>
      sizes; // whose scatter follows c N^(-1/2), which the screen has with its biases
  for (const double x : {0.25, 0.375, 0.75})
    sizes.push_back(trade_row(studies::Varied::grains, 1000 * x, x));
  const auto laws_shown = [&] {
    return screen(trade_document({.trade = studies::default_trade(), .samples = {}, .rows = sizes}, {}),
                  false)
               .find("b/N") != std::string::npos;
  };
  CHECK(laws_shown());
  for (studies::TradeRow& row : sizes)
    row.shear_modulus->scatter = row.exponent->scatter = 0;
  CHECK_FALSE(laws_shown());
  const TemporaryFolder folder;
  std::vector<studies::TradeRow> rows{trade_row(studies::Varied::shear, 2e-4, 0.7),
                                      trade_row(studies::Varied::boundary, 250, 0.3)};
  rows[0].peak_ratio = studies::Deviation{.bias = 0.1, .standard_error = 0.2, .scatter = 0.3};
  rows[0].exponent.reset();
  rows[1].boundary = studies::Boundary::rough_walls;
  rows[1].density = Density::loose;
  std::ofstream(folder.path() / "rows.csv") << csv(rows_document(rows));
  const std::vector<studies::TradeRow> read = read_trade_rows(folder.path() / "rows.csv");
  REQUIRE(read.size() == 2);
  for (std::size_t k = 0; k < 2; ++k) {
    CHECK((read[k].varied == rows[k].varied && read[k].boundary == rows[k].boundary));
    CHECK((read[k].density == rows[k].density && read[k].reference == rows[k].reference));
    CHECK((read[k].value == rows[k].value && read[k].specimens == rows[k].specimens));
    CHECK((read[k].cpu_seconds == rows[k].cpu_seconds && read[k].steps == rows[k].steps));
    for (const auto figure :
         {&studies::TradeRow::shear_modulus, &studies::TradeRow::exponent, &studies::TradeRow::peak_ratio}) {
      const std::optional<studies::Deviation>&a = read[k].*figure, &b = rows[k].*figure;
      REQUIRE(a.has_value() == b.has_value());
      if (a)
        CHECK((a->bias == b->bias && a->standard_error == b->standard_error && a->scatter == b->scatter));
    }
  }
}

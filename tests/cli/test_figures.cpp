// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/reproduce/figures.hpp"

#include <complex>
#include <map>
#include <set>

#include "cli/reproduce/reproduce_document.hpp"
#include "studies/paper/paper.hpp"
#include "studies/reproduce/experiment_findings.hpp"
#include <granum/effective/relaxation.hpp>
#include <granum/fabric/orientation.hpp>
#include <granum/io/csv/table.hpp>

#include "plot/chart_text.hpp"
#include "studies/count_pieces.hpp"
#include "synthetic_experiment.hpp"
#include "unit.hpp"
#include "well_formed.hpp"

using namespace granum::cli;
using contact::Shape;
using stress::ShearPath;
using studies::count;
using triaxial::Density;

namespace {

constexpr double pi = std::numbers::pi;

Panel find_panel(const Experiment& experiment, const std::string& stem) {
  for (const Figure& figure : experiment_figures(experiment))
    for (const Panel& panel : figure.panels)
      if (panel.stem == stem)
        return panel;
  FAIL("no panel " << stem);
  return {};
}

bool has(const Panel& panel, const std::string& key) {
  return std::find(panel.keys.begin(), panel.keys.end(), key) != panel.keys.end();
}

plot::Series find_series(const Panel& panel, const std::string& key) {
  const auto found = std::find(panel.keys.begin(), panel.keys.end(), key);
  if (found == panel.keys.end())
    FAIL("no series " << key);
  return panel.chart.series[static_cast<std::size_t>(found - panel.keys.begin())];
}

/// Dense spheres: contacts come first, cone before sphere.
const ExperimentSpecimen& dense_sphere(const Experiment& experiment) { return experiment.specimens[2]; }

} // namespace

TEST_CASE("every figure of the paper is drawn in its order, with a panel for each of its parts") {
  const std::vector<Figure> figures = experiment_figures(synthetic::experiment());
  const std::vector<std::pair<std::string, std::size_t>> expected = {
      {"Fig. 4", 1},  {"Fig. 6", 6},  {"Fig. 7", 6},  {"Fig. 8", 12},         {"Fig. 9", 6},  {"Fig. 10", 6},
      {"Fig. 11", 6}, {"Fig. 12", 6}, {"Fig. 13", 6}, {"Fig. 14", 6},         {"Fig. 15", 2}, {"Fig. 16", 6},
      {"Fig. 17", 6}, {"Fig. 18", 6}, {"Fig. 19", 6}, {"Beyond the paper", 1}};
  REQUIRE(figures.size() == expected.size());
  std::set<std::string> stems;
  std::size_t panels = 0;
  for (std::size_t k = 0; k < figures.size(); ++k) {
    CAPTURE(expected[k].first);
    CHECK(figures[k].name == expected[k].first);
    CHECK(figures[k].panels.size() == expected[k].second);
    CHECK(!figures[k].title.empty());
    CHECK(figures[k].caption.size() > 40);
    for (const Panel& panel : figures[k].panels) {
      stems.insert(panel.stem);
      ++panels;
    }
  }
  CHECK(stems.size() == panels);
  CHECK(stems.contains("fig09_cone_dense_G_hv_p"));
  CHECK(stems.contains("fig14_flat_loose_G_hh_eta"));
  CHECK(assembly_picture(synthetic::experiment())->stem == "fig03_sphere_dense");
}

TEST_CASE("pictures are well-formed, without NaN, and each series has a colour with a meaning, or is grey") {
  for (const Figure& figure : experiment_figures(synthetic::experiment()))
    for (const Panel& panel : figure.panels) {
      CAPTURE(panel.stem);
      REQUIRE(panel.keys.size() == panel.chart.series.size());
      for (std::size_t k = 0; k < panel.keys.size(); ++k) {
        CAPTURE(panel.keys[k]);
        CHECK(panel.keys[k].find_first_of(",\"'") == std::string::npos); // a heading without quotes
        const plot::Series& series = panel.chart.series[k];
        CHECK((series.colour.has_value() || series.tone == plot::Tone::grey));
      }
      const std::string svg = plot::svg(panel.chart);
      CHECK(well_formed(svg));
      CHECK(svg.find("nan") == std::string::npos);
      CHECK(svg.find("inf") == std::string::npos);
    }
}

TEST_CASE("a path has the same colour and marker in all figures") {
  std::map<std::string, std::set<std::size_t>> styles;
  std::map<std::string, std::set<plot::Colour>> colours;
  for (const Figure& figure : experiment_figures(synthetic::experiment()))
    for (const Panel& panel : figure.panels)
      for (const plot::Series& series : panel.chart.series)
        if (series.name.starts_with("TX") || series.name.starts_with("RTX") || series.name == "ISO") {
          REQUIRE(series.style.has_value());
          REQUIRE(series.colour.has_value());
          const std::string path = series.name.substr(0, series.name.find(' '));
          styles[path].insert(*series.style);
          colours[path].insert(*series.colour);
        }
  CHECK(styles.size() == 5);
  std::set<std::size_t> all;
  for (const auto& path : styles) {
    CAPTURE(path.first);
    CHECK(path.second.size() == 1);
    all.insert(*path.second.begin());
  }
  CHECK(all.size() == 5);
  std::set<plot::Colour> all_colours;
  for (const auto& path : colours) {
    CAPTURE(path.first);
    CHECK(path.second.size() == 1);
    all_colours.insert(*path.second.begin());
  }
  CHECK(all_colours.size() == 5);
}

TEST_CASE("moduli begin at the end of isotropic compression and end at the peak, with the rest as dots") {
  const Experiment experiment = synthetic::experiment();
  const std::vector<StateRecord>& points = dense_sphere(experiment).runs[2].points; // RTXC
  const Panel panel = find_panel(experiment, "fig10_sphere_dense_G_hv_p");
  const plot::Series network = find_series(panel, "RTXC network");
  REQUIRE(network.x.size() == 9);
  CHECK(network.x[0] == 100e3);
  CHECK(network.y[0] == relative(1e8, 1e-14));
  for (std::size_t k = 0; k < 8; ++k) {
    CHECK(network.x[k + 1] == points[k].at.stress.mean());
    CHECK(network.y[k + 1] == points[k].G_vh());
  }
  const plot::Series past = find_series(panel, "RTXC past the peak");
  CHECK(past.mark == plot::Mark::marker);
  CHECK(past.x == std::vector{points[8].at.stress.mean(), points[9].at.stress.mean()});
  const plot::Series probes = find_series(panel, "RTXC cyclic shear");
  CHECK(probes.y == std::vector{1.02 * points[4].G_vh()});
  CHECK(find_series(panel, "RTXC uniform strain").y[3] == relative(2 * network.y[3], 1e-14));
  CHECK(find_series(panel, "RTXC relaxed (closed form)").y[3] == relative(1.1 * network.y[3], 1e-14));
  CHECK(find_series(panel, "ISO network").x == std::vector{25e3, 50e3, 75e3, 100e3});

  const Panel against_eta = find_panel(experiment, "fig10_sphere_dense_G_hv_eta");
  CHECK(!has(against_eta, "ISO network"));
  CHECK(find_series(against_eta, "RTXC network").x[2] == relative(0.2, 1e-14));
  CHECK(find_series(find_panel(experiment, "fig10_sphere_dense_G_hh_p"), "TXC cyclic shear").y[0] ==
        dense_sphere(experiment).runs[1].points[4].probes->G_hh);
  CHECK(find_series(find_panel(experiment, "fig10_sphere_dense_G_vh_p"), "TXC cyclic shear").y[0] ==
        dense_sphere(experiment).runs[1].points[4].probes->G_vh);
}

TEST_CASE("curves and paths show stresses and strains of the experiment") {
  const Experiment experiment = synthetic::experiment();
  const PathRun& txe = dense_sphere(experiment).runs[4];
  const plot::Series ratio = find_series(find_panel(experiment, "fig06_sphere_dense"), "TXE");
  const plot::Series volume = find_series(find_panel(experiment, "fig07_sphere_dense"), "TXE");
  REQUIRE(ratio.x.size() == txe.curve.size());
  for (std::size_t k = 0; k < ratio.x.size(); ++k) {
    CHECK(ratio.x[k] == txe.curve[k].axial_strain);
    CHECK(ratio.y[k] == txe.curve[k].stress.ratio());
    CHECK(volume.y[k] == txe.curve[k].volumetric_strain);
  }
  const plot::Series path = find_series(find_panel(experiment, "fig04_cone_dense"), "TXE");
  CHECK(path.x.size() == 10);
  // TXE holds the vertical stress: q = -3 (p' - 100 kPa)/2
  for (std::size_t k = 0; k < path.x.size(); ++k)
    CHECK(path.y[k] == relative(-1.5 * (path.x[k] - 100e3), 1e-10));
}

TEST_CASE("exponents are shown next to the printed ones") {
  const Experiment experiment = synthetic::experiment();
  const Panel panel = find_panel(experiment, "fig15_loose");
  const plot::Series ours = find_series(panel, "G_hv granum"), paper = find_series(panel, "G_hv paper");
  REQUIRE(ours.y.size() == 3);
  REQUIRE(paper.y.size() == 3);
  std::size_t k = 0;
  for (const Shape contact : {Shape::cone, Shape::sphere, Shape::flat}) {
    CHECK(paper.y[k] == studies::printed(contact, Density::loose)->hv.s);
    CHECK(ours.x[k] == paper.x[k]);
    // The moduli were made with sqrt(p') alone, and a power of sigma_h and sigma_v comes near to it.
    CHECK(ours.y[k] == relative(0.5, 0.02));
    CHECK(std::abs(ours.x[k] - contact_exponent(experiment.scene, contact)) < 0.01);
    ++k;
  }
}

TEST_CASE("directions of contacts are a density, and the fit has the a of the same contacts") {
  const Experiment experiment = synthetic::experiment();
  const Panel panel = find_panel(experiment, "fig16_cone_loose");
  const plot::Series counted = find_series(panel, "RTXE counted"), fit = find_series(panel, "RTXE fitted");
  CHECK(panel.chart.rose);
  REQUIRE(counted.x.size() == 3); // few contacts, few bins
  double total = 0;
  for (std::size_t k = 0; k < 3; ++k) {
    const double low = pi / 6 * static_cast<double>(k), high = low + pi / 6;
    total += counted.y[k] * 4 * pi * (std::cos(low) - std::cos(high));
    CHECK(counted.x[k] == relative((low + high) / 2, 1e-13));
    // six bins from 6k on hold 3 + 12k, 5 + 12k, ... contacts
    CHECK(counted.y_error[k] / counted.y[k] ==
          relative(1 / std::sqrt(48.0 + 72.0 * static_cast<double>(k)), 1e-13));
  }
  CHECK(total == relative(1, 1e-13));
  const double a = fabric::anisotropy_from_F33(0.4);
  for (std::size_t k = 0; k < fit.x.size(); ++k)
    CHECK(fit.y[k] == fabric::density(fit.x[k], a));
  CHECK((fit.x.front() == 0 && fit.x.back() == relative(pi / 2, 1e-14)));
  CHECK(has(panel, "ISO counted"));
  CHECK(has(panel, "TXC counted"));
  CHECK(!has(panel, "TXE counted"));
}

TEST_CASE("microstructure carries its errors on some of its points") {
  const Experiment experiment = synthetic::experiment();
  const plot::Series a = find_series(find_panel(experiment, "fig18_sphere_dense_a"), "RTXE");
  REQUIRE(a.y_error.size() == 9);
  CHECK(a.y[0] == 0);
  CHECK(a.y[8] == relative(-0.08, 1e-13));
  CHECK(std::count(a.y_error.begin(), a.y_error.end(), 0.02) == 2);
  CHECK(std::count(a.y_error.begin(), a.y_error.end(), 0.0) == 7);
  const plot::Series C_n = find_series(find_panel(experiment, "fig18_sphere_dense_C_n"), "RTXE");
  CHECK(C_n.y[8] == relative(5.6, 1e-13));
  CHECK(std::count(C_n.y_error.begin(), C_n.y_error.end(), 0.05) == 2);
  const plot::Series z = find_series(find_panel(experiment, "fig18_sphere_dense_z_star"), "RTXE");
  CHECK(z.y[8] == relative(5.7, 1e-13));
  CHECK(z.y_error.empty());
}

TEST_CASE("the relaxation figure contains all states of all seeds and the calibrated curve") {
  Experiment experiment = synthetic::experiment();
  experiment.scene.study.seeds = 2;
  experiment.specimens.push_back(dense_sphere(experiment)); // a second seed
  const Panel panel = find_panel(experiment, "more_relaxation");
  const plot::Series dense = find_series(panel, "sphere_dense"), loose = find_series(panel, "sphere_loose");
  CHECK(dense.x.size() == 2 * (4 + 4 * 10));
  CHECK(loose.x.size() == 4 + 4 * 10);
  for (const double ratio : dense.y)
    CHECK(ratio == relative(0.5, 1e-13));
  const plot::Series line = find_series(panel, "closed form cone");
  CHECK(line.x.front() == relative(5.7, 1e-13)); // |eta| = 0.8
  CHECK(line.x.back() == relative(6.1, 1e-13));
  const dem::Material cone = recipe(experiment.scene, Shape::cone, 1).material;
  CHECK(line.y[7] ==
        effective::relaxation(line.x[7], cone.tangential_ratio, cone.law.constant_exponent().value())
            .shear.value);
  CHECK(experiment_figures(experiment).front().caption.find("2 specimens") != std::string::npos);
}

TEST_CASE("an experiment with missing parts gives partial results") {
  Experiment experiment = synthetic::experiment();
  // Dense cones never compressed, loose ones have no paths, dense spheres no closed forms and no probes.
  experiment.specimens[0].end_of_iso = {};
  experiment.specimens[0].runs = {PathRun{}};
  experiment.specimens[0].runs[0].failure = "did not come to rest";
  experiment.specimens[1].runs.resize(1);
  for (PathRun& run : experiment.specimens[2].runs)
    for (StateRecord& point : run.points) {
      point.closed = std::nullopt;
      point.probes = std::nullopt;
    }
  experiment.specimens[3].runs[1].points[9].network = {}; // fell apart
  const std::vector<Figure> figures = experiment_figures(experiment);
  std::set<std::string> stems;
  for (const Figure& figure : figures)
    for (const Panel& panel : figure.panels) {
      stems.insert(panel.stem);
      CHECK(plot::svg(panel.chart).find("nan") == std::string::npos);
    }
  CHECK(!stems.contains("fig09_cone_dense_G_hv_p"));
  CHECK(!stems.contains("fig12_cone_loose_G_hv_eta"));
  CHECK(stems.contains("fig12_cone_loose_G_hv_p")); // isotropic compression is there
  CHECK(stems.contains("fig10_sphere_dense_G_hv_p"));
  CHECK(!has(find_panel(experiment, "more_relaxation"), "sphere_dense"));
  CHECK(find_series(find_panel(experiment, "more_relaxation"), "sphere_loose").x.size() == 4 + 4 * 10 - 1);
  CHECK(assembly_picture(experiment)->stem == "fig03_sphere_dense");
  experiment.specimens[2].end_of_iso = {};
  CHECK(assembly_picture(experiment)->stem == "fig03_cone_loose");

  CHECK(experiment_figures(Experiment{}).empty());
  CHECK(!assembly_picture(Experiment{}));
}

TEST_CASE("the numbers of a panel go through its CSV file") {
  const Experiment experiment = synthetic::experiment();
  const Panel panel = find_panel(experiment, "fig18_sphere_dense_a");
  const io::CsvTable csv("panel", panel_csv(panel));
  const auto cell = [&](std::size_t row, const std::string& heading) {
    const auto at = std::find(csv.headings().begin(), csv.headings().end(), heading);
    REQUIRE(at != csv.headings().end());
    return csv.fields(row)[static_cast<std::size_t>(at - csv.headings().begin())];
  };
  const plot::Series line = find_series(panel, "TXC"), dots = find_series(panel, "TXC past the peak");
  CHECK(csv.row_count() == line.x.size());
  CHECK(std::stod(cell(3, "TXC eta")) == line.x[3]);
  CHECK(std::stod(cell(3, "TXC a")) == line.y[3]);
  CHECK(std::stod(cell(1, "TXC error a")) == 0.02);
  CHECK(std::stod(cell(1, "TXC past the peak a")) == dots.y[1]);
  CHECK(cell(2, "TXC past the peak a").empty()); // shorter than the line
}

TEST_CASE("an assembly is painted from back to front, grains moved into the cell") {
  const dem::Specimen state = synthetic::state();
  const std::string svg = plot::svg(assembly_drawing(state));
  CHECK(well_formed(svg));
  CHECK(count(svg, "<circle") == 8);
  CHECK(count(svg, "<line") == 12); // edges of the cell
  CHECK(svg.find("nan") == std::string::npos);
  // The far corner's three edges come first, the rest after the grains; shades fall towards the front.
  CHECK(count(svg.substr(0, svg.find("<circle")), "<line") == 3);
  CHECK(svg.find("url(#granum-grain-5)") < svg.find("url(#granum-grain-0)"));
  // A grain a cell's length away is drawn where its image is.
  dem::Specimen moved = state;
  moved.position[3].x -= 4e-3;
  CHECK(plot::svg(assembly_drawing(moved)) == svg);

  // A parallel projection of a cube: the squares of its edges, as complex numbers, add up to nothing, their
  // sizes to twice that of an edge. Twelve edges lie between eight corners, grains among them.
  using Spot = std::complex<double>;
  const plot::SvgPicture picture = assembly_drawing(moved);
  const auto spots = [&](const char* element, const char* x, const char* y) {
    const auto at_x = chart_text::all(picture.content, element, x),
               at_y = chart_text::all(picture.content, element, y);
    std::vector<Spot> out;
    for (std::size_t k = 0; k < at_x.size(); ++k)
      out.emplace_back(at_x[k], at_y.at(k));
    return out;
  };
  std::vector<Spot> ends = spots("<line", "x1", "y1");
  const std::vector<Spot> others = spots("<line", "x2", "y2"), centres = spots("<circle", "cx", "cy");
  const Spot origin = ends[0];
  const std::array<Spot, 3> edge{others[0] - origin, others[1] - origin, others[2] - origin};
  ends.insert(ends.end(), others.begin(), others.end());
  const auto place_of = [&](const Vec3& parts) {
    return origin + parts.x * edge[0] + parts.y * edge[1] + parts.z * edge[2];
  };
  const double length = std::sqrt((std::norm(edge[0]) + std::norm(edge[1]) + std::norm(edge[2])) / 2),
               radius = length * moved.radius / moved.cell(0, 0);
  CHECK(std::abs(edge[0] * edge[0] + edge[1] * edge[1] + edge[2] * edge[2]) < 1e-3 * length * length);
  CHECK((edge[2].imag() < 0 && edge[0].real() < 0 && edge[1].real() > 0)); // z is up, x to the left
  const double fine = 0.03;                                                // digits of a picture
  double left = 1e9, right = 0, top = 1e9, foot = 0;
  for (int corner = 0; corner < 8; ++corner) {
    const Spot at = place_of({corner & 1 ? 1.0 : 0.0, corner & 2 ? 1.0 : 0.0, corner & 4 ? 1.0 : 0.0});
    CHECK(std::ranges::count_if(ends, [&](const Spot& end) { return std::abs(end - at) < fine; }) == 3);
    left = std::min(left, at.real() - radius), right = std::max(right, at.real() + radius);
    top = std::min(top, at.imag() - radius), foot = std::max(foot, at.imag() + radius);
  }
  for (const auto& [edge_at, expected] : {std::pair{left, 14.0},
                                          {top, 14.0},
                                          {picture.width - right, 14.0},
                                          {picture.height - foot, 14.0},
                                          {std::max(picture.width, picture.height), 520.0}})
    CHECK(std::abs(edge_at - expected) < fine);
  std::vector<std::ptrdiff_t> order; // in which grains are painted
  for (const Vec3& x : moved.position) {
    const Spot at = place_of((1 / moved.cell(0, 0)) * x);
    const auto found = std::ranges::find_if(centres, [&](const Spot& c) { return std::abs(c - at) < fine; });
    REQUIRE(found != centres.end());
    order.push_back(found - centres.begin());
  }
  for (std::size_t a = 0; a < order.size(); ++a)
    for (std::size_t b = 0; b < order.size(); ++b)
      if (const Vec3 nearer = moved.position[a] - moved.position[b];
          a != b && std::min({nearer.x, nearer.y, nearer.z}) >= 0)
        CHECK(order[a] > order[b]);
  for (const double r : chart_text::all(picture.content, "<circle", "r"))
    CHECK(std::abs(r - radius) < fine);
  // Depths are what the projection leaves of the edges; shades divide them in six.
  const auto depth = [&](const Vec3& x) {
    double sum = 0;
    for (int k = 0; k < 3; ++k)
      sum += x[k] * std::sqrt(1 - std::norm(edge[static_cast<std::size_t>(k)]) / (length * length));
    return sum;
  };
  const double nearest = depth({3e-3, 3e-3, 3e-3}), farthest = depth({1e-3, 1e-3, 1e-3});
  std::size_t at = picture.content.find("<circle");
  std::vector<int> shades;
  for (; at != std::string::npos; at = picture.content.find("<circle", at + 1))
    shades.push_back(std::stoi(picture.content.substr(picture.content.rfind("-grain-", at) + 7)));
  for (std::size_t k = 0; k < order.size(); ++k)
    CHECK(shades.at(static_cast<std::size_t>(order[k])) ==
          std::min(5, int(6 * (nearest - depth(moved.position[k])) / (nearest - farthest))));

  // Each grain has its own radius.
  dem::Specimen unequal = state;
  unequal.size.assign(8, 1);
  unequal.size[5] = 0.5;
  const std::string drawn = assembly_drawing(unequal).content;
  std::set<std::string> radii;
  for (at = drawn.find(" r=\"", drawn.find("<circle")); at != std::string::npos;
       at = drawn.find(" r=\"", at + 1))
    radii.insert(drawn.substr(at + 4, drawn.find('"', at + 4) - at - 4));
  REQUIRE(radii.size() == 2);
  const double first = std::stod(*radii.begin()), second = std::stod(*radii.rbegin());
  CHECK(std::max(first, second) / std::min(first, second) == relative(2, 0.01)); // digits of a picture

  // Of a large cube only the part that can be seen.
  dem::Specimen large;
  large.cell = Mat3::diagonal(20e-3, 20e-3, 20e-3);
  large.radius = 0.5e-3;
  for (int k = 0; k < 8000; ++k)
    large.position.push_back({(k % 20 + 0.5) * 1e-3, (k / 20 % 20 + 0.5) * 1e-3, (k / 400 + 0.5) * 1e-3});
  CHECK(count(assembly_drawing(large).content, "<circle") == 8000 - 16 * 16 * 16);
  CHECK_THROWS_AS((void)assembly_drawing(dem::Specimen{}), InvalidArgument);
}

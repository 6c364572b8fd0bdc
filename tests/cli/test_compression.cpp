// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/verify/compression.hpp"

#include <set>

#include <granum/core/text.hpp>
#include <granum/effective/relaxation.hpp>

#include "unit.hpp"

using namespace granum::cli;
using contact::Shape;
using studies::Panel;
using studies::Scene;
using triaxial::Density;

namespace {

/// G = 100 MPa (p/100 kPa)^s by every route, z* from 4 + s to 5 + s.
Compression compression(Shape shape, Density density, double s) {
  Compression out{
      .contact = shape, .density = density, .contact_exponent = 1 / 3.0, .exponent = Measured{s, 0.004}};
  for (const double share : {0.1, 0.4, 1.0}) {
    const double G = 1e8 * std::pow(share, s);
    out.states.push_back({.pressure = 1e5 * share,
                          .mechanical_coordination_number = 4 + s + share,
                          .network = {G, G, 1.1 * G},
                          .relaxed = {G, G, G},
                          .probe = {G, G, G},
                          .softening = 0.2 + share / 2});
  }
  return out;
}

std::vector<Compression> both() {
  return {compression(Shape::sphere, Density::dense, 0.36), compression(Shape::sphere, Density::loose, 0.56)};
}

std::vector<Panel> panels_of(const Scene& scene, const std::vector<Compression>& all) {
  Document document;
  return add_compression(document, scene, all);
}

bool contains(const std::string& text, const std::string& piece) {
  return text.find(piece) != std::string::npos;
}

const plot::Series& series(const Panel& panel, const std::string& key) {
  for (std::size_t k = 0; k < panel.keys.size(); ++k)
    if (panel.keys[k] == key)
      return panel.chart.series[k];
  FAIL("no series " << key);
  return panel.chart.series.front();
}

} // namespace

TEST_CASE("the answer is three sentences with the numbers of the run, and reasons where they show them") {
  std::vector<Compression> all = both();
  const std::vector<std::string> answer = compression_answer(all);
  REQUIRE(answer.size() == 3);
  for (const char* number : {"0.360 \u00b1 0.004", "1/3", "4.46", "5.36"})
    CHECK(contains(answer[1], number));
  for (const char* number : {"0.560 \u00b1 0.004", "4.66", "5.56", "0.25", "0.70"})
    CHECK(contains(answer[2], number));
  for (const std::string& sentence : answer)
    CHECK(sentence.ends_with("."));
  all[0].exponent->value = all[0].contact_exponent + 0.1;
  all[1].exponent->value = all[1].contact_exponent;
  for (std::size_t k : {1u, 2u}) // without the reason
    CHECK(compression_answer(all)[k].size() < answer[k].size());
  // Rung 3 beside the network of each state, in per cent.
  const RouteState& state = all[0].states[0];
  const double off = 100 * std::abs(*state.relaxed[2] / *state.network[2] - 1);
  CHECK(off > 1);
  CHECK(contains(modulus_panel(all, 2).chart.finding, detail::formatted("%.2g", off) + " %"));
}

TEST_CASE("parts that were not run have no result") {
  CHECK(compression_answer({compression(Shape::cone, Density::dense, 0.5)}).size() == 2);
  std::vector<Compression> all = both();
  all[1].exponent = {};
  CHECK(compression_answer(all).size() == 2);
  CHECK(compression_answer({}).size() == 1);
  Document document;
  CHECK(add_compression(document, Scene{}, {}).empty());
  CHECK(document.sections.size() == 1);
}

TEST_CASE("log G over log p has every route of every specimen, and triangles of slope s at their ends") {
  const Panel panel = modulus_panel(both(), 2); // G_hh
  CHECK(panel.stem == "log_G_log_p_G_hh");
  CHECK(panel.chart.x.scale == plot::Scale::logarithmic);
  CHECK(panel.chart.y.scale == plot::Scale::logarithmic);
  CHECK(panel.keys.size() == 6);
  CHECK(series(panel, "sphere_dense network").y[1] == relative(1.1e8 * std::pow(0.4, 0.36), 1e-14));
  CHECK(series(panel, "sphere_loose closed form").y[0] == relative(1e8 * std::pow(0.1, 0.56), 1e-14));
  CHECK(series(panel, "sphere_loose network").tone == plot::Tone::hollow);
  CHECK(series(panel, "sphere_dense network").tone == plot::Tone::full);
  REQUIRE(panel.chart.triangles.size() == 2);
  const plot::SlopeTriangle& loose = panel.chart.triangles[1];
  CHECK(loose.slope == 0.56);
  CHECK(loose.text == "s = 0.56");
  CHECK(loose.y0 * std::pow(loose.x1 / loose.x0, loose.slope) ==
        relative(1.1e8, 1e-13)); // ends on the network
  for (const char* number : {"0.36", "0.56"})
    CHECK(contains(panel.chart.finding, number));
}

TEST_CASE("a shape has its colour in all pictures, and is listed once in each") {
  std::vector<Compression> all = both();
  all.push_back(compression(Shape::cone, Density::dense, 0.5));
  all.push_back(compression(Shape::cone, Density::loose, 0.7));
  const std::vector<Panel> panels = panels_of(Scene{}, all);
  CHECK(panels.size() == 6);
  for (const Panel& panel : panels) {
    CAPTURE(panel.stem);
    std::multiset<std::string> named;
    for (const plot::Series& one : panel.chart.series) {
      if (one.name == "sphere")
        CHECK(one.colour == plot::Colour::sphere);
      if (one.name == "cone")
        CHECK(one.colour == plot::Colour::cone);
      named.insert(one.name);
    }
    CHECK(named.count("sphere") == 1);
    CHECK(named.count("cone") == 1);
    CHECK(panel.chart.finding.size() > 40);
  }
}

TEST_CASE("curves of the closed form that coincide are drawn once, others one by one") {
  Scene scene;
  const Panel of_spheres = panels_of(scene, both()).back();
  CHECK_FALSE(series(of_spheres, "closed form").name.empty());
  std::vector<Compression> all = both();
  all.push_back(compression(Shape::cone, Density::dense, 0.5));
  const Panel of_two = panels_of(scene, all).back();
  const plot::Series& spheres = series(of_two, "closed form sphere");
  const dem::Material sphere = recipe(scene, Shape::sphere, 1).material;
  CHECK(spheres.y[7] == effective::relaxation(spheres.x[7], sphere.tangential_ratio, 1 / 3.0).shear.value);
  CHECK(series(of_two, "closed form cone").y[7] != spheres.y[7]);
}

TEST_CASE("the pictures of a document show one modulus at a time, with links to their numbers") {
  Document document;
  (void)add_compression(document, Scene{}, both());
  REQUIRE(document.sections.size() == 4);
  const auto& first = std::get<Picture>(document.sections.front().what);
  CHECK(first.choices == std::vector<std::string>{"G_hv", "G_vh", "G_hh"});
  CHECK(first.files.front() == "figures/log_G_log_p_G_hv.csv");
  CHECK(document.sentences.size() == 3);
  const std::string html = page(document);
  CHECK(contains(html, "data-choice=\"G_hh\""));
  CHECK(contains(html, "<a href=\"figures/relaxation.csv\">relaxation.csv</a>"));
}

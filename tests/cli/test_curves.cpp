// SPDX-License-Identifier: GPL-3.0-or-later
// Curves of G/G0 and damping over strain, by the rules of the programs that read them:
// pystrata, src/pystrata/site.py: models have unique names; strains are positive, as many as values, and
// fractions; G/G0 is cut to [0.001, 1] and damping to [0, 0.49].
// Strata, source/SoilType.cpp, NonlinearProperty.cpp: each key below is read; strains and damping are in per
// cent and strains increase; two strains would have no interpolation.
#include <cstdio>
#include <fstream>
#include <set>

#include <fmt/format.h>
#include <granum/core/text.hpp>
#include <granum/io/csv/table.hpp>
#include <nlohmann/json.hpp>
#include <toml++/toml.h>

#include "swept_file.hpp"
#include "unit.hpp"

namespace {

const std::vector<std::string> state{"--void-ratio", "0.7", "--uniformity", "1.5", "--pressure", "100kPa"};

std::vector<std::string> with(std::vector<std::string> words, std::initializer_list<const char*> more) {
  words.insert(words.end(), more.begin(), more.end());
  return words;
}

void check_strains(const std::vector<double>& strains, double first, double last) {
  REQUIRE(strains.size() >= 3);
  CHECK(strains.front() == doctest::Approx(first).epsilon(1e-12));
  CHECK(strains.back() == doctest::Approx(last).epsilon(1e-12));
  for (std::size_t k = 1; k < strains.size(); ++k)
    CHECK(strains[k] > strains[k - 1]);
}

void check_curve(const std::vector<double>& ratios, const std::vector<double>& damping, double largest) {
  REQUIRE(ratios.size() == damping.size());
  for (std::size_t k = 0; k < ratios.size(); ++k) {
    CHECK(ratios[k] > 0);
    CHECK(ratios[k] <= 1);
    CHECK(damping[k] >= 0);
    CHECK(damping[k] <= largest);
    if (k > 0) {
      CHECK(ratios[k] <= ratios[k - 1]);
      CHECK(damping[k] >= damping[k - 1]);
    }
  }
}

std::vector<double> numbers_in(const toml::node_view<toml::node>& array) {
  std::vector<double> numbers;
  REQUIRE(array.is_array());
  for (const toml::node& node : *array.as_array()) {
    REQUIRE(node.is_floating_point());
    numbers.push_back(*node.value<double>());
  }
  return numbers;
}

} // namespace

TEST_CASE("curves: a table has strain, G/G0 and damping first, then their ranges") {
  const std::string text = swept(with(state, {"--strain", "0.0001%..1%", "--for", "table"}));
  const io::CsvTable table("curve", text);
  const std::vector<std::string> first(table.headings().begin(), table.headings().begin() + 3);
  CHECK(first == std::vector<std::string>{"strain_percent", "G_over_G0", "damping_percent"});
  REQUIRE(table.row_count() == 13);
  const auto column = [&](const char* name) { return table.numbers(name, Dimension::dimensionless); };
  const std::vector<double> strains = column("strain_percent"), ratios = column("G_over_G0"),
                            damping = column("damping_percent");
  check_strains(strains, 1e-4, 1);
  check_curve(ratios, damping, 49);
  CHECK(strains[1] == 0.0002154);
  for (const auto& [name, low, high] : {std::tuple{&ratios, "G_over_G0_low", "G_over_G0_high"},
                                        std::tuple{&damping, "damping_low_percent", "damping_high_percent"}})
    for (std::size_t k = 0; k < name->size(); ++k) {
      CHECK(column(low)[k] <= (*name)[k]);
      CHECK(column(high)[k] >= (*name)[k]);
    }
}

TEST_CASE("curves: pystrata reads models of unique names, fractions, and numbers within its limits") {
  const std::string text =
      swept({"--sand", "toyoura", "--relative-density", "60%", "--depth", "0m..20m", "--points", "5",
             "--water-table", "3m", "--strain", "0.0001%..1%", "--for", "pystrata"});
  const toml::table file = toml::parse(text);
  const toml::array& models = *file["models"].as_array();
  REQUIRE(models.size() == 4); // without stress, at the surface, there is no curve
  std::set<std::string> names;
  for (const toml::node& node : models) {
    toml::table model = *node.as_table();
    names.insert(model["name"].value_or(std::string()));
    const std::vector<double> strains = numbers_in(model["mod_reduc"]["strains"]);
    CHECK(strains == numbers_in(model["damping"]["strains"]));
    check_strains(strains, 1e-6, 1e-2);
    const std::vector<double> ratios = numbers_in(model["mod_reduc"]["values"]);
    CHECK(ratios.size() == strains.size());
    CHECK(ratios.back() >= 0.001);
    check_curve(ratios, numbers_in(model["damping"]["values"]), 0.49);
  }
  CHECK(names.size() == models.size());
}

TEST_CASE("curves: Strata reads soil types in per cent, atm and kN/m3") {
  const auto check = [](const nlohmann::json& type, double atmospheres) {
    for (const char* key : {"name", "notes", "modulusType", "dampingType"})
      CHECK(type.at(key).is_string());
    for (const char* key : {"untWt", "damping", "meanStress", "pi", "ocr", "freq", "nCycles"})
      CHECK(type.at(key).is_number());
    for (const char* key : {"isVaried", "saveData"})
      CHECK(type.at(key).is_boolean());
    CHECK(type.at("modulusType") == "CustomNonlinearProperty");
    CHECK(type.at("dampingType") == "CustomNonlinearProperty");
    CHECK(type.at("modulusModel").at("type") == 0);
    CHECK(type.at("dampingModel").at("type") == 1);
    const auto of = [&type](const char* model, const char* key) {
      return type.at(model).at(key).get<std::vector<double>>();
    };
    check_strains(of("modulusModel", "strain"), 1e-4, 1);
    CHECK(of("modulusModel", "strain") == of("dampingModel", "strain"));
    check_curve(of("modulusModel", "average"), of("dampingModel", "average"), 49);
    CHECK(type.at("damping") == of("dampingModel", "average").front());
    CHECK(type.at("meanStress").get<double>() == doctest::Approx(atmospheres).epsilon(1e-4));
    CHECK(type.at("untWt").get<double>() > 12);
    CHECK(type.at("untWt").get<double>() < 24);
  };
  check(nlohmann::json::parse(swept(with(state, {"--strain", "0.0001%..1%", "--for", "strata"}))),
        100 / 101.325);
  // Dry ground of 16 kN/m3: at 5 m 80 kPa and K_0 0.5, so a mean of two thirds of that.
  const nlohmann::json types =
      nlohmann::json::parse(swept({"--void-ratio", "0.7", "--unit-weight", "16kN/m3", "--depth", "5m..10m",
                                   "--points", "2", "--strain", "0.0001%..1%", "--for", "strata"}));
  REQUIRE(types.size() == 2);
  check(types[0], 80 * 2 / 3.0 / 101.325);
  CHECK(types[0].at("untWt") == 16);
  check(types[1], 160 * 2 / 3.0 / 101.325);
  CHECK(types[0].at("name") != types[1].at("name"));
}

TEST_CASE("curves: the numbers are those of a single strain") {
  const std::string curve =
      swept(with(state, {"--strain", "0.01%..0.1%", "--points", "3", "--for", "table", "--json"}));
  const nlohmann::json points = nlohmann::json::parse(curve).at("curves");
  REQUIRE(points.size() == 3);
  const TemporaryFolder folder;
  const std::string file = (folder.path() / "row.csv").string();
  std::ofstream(file) << "e,C_u,p_kPa,strain_%\n0.7,1.5,100,0.1\n";
  const nlohmann::json row = nlohmann::json::parse(swept({"--table", file, "--json"})).at("states")[0];
  for (const char* key : {"modulus_ratio", "damping_ratio", "strained_shear_modulus"})
    CHECK(points[2].at(key) == row.at("answer").at(key));
}

TEST_CASE("sweeps: weights below each layer's water, names of equal curves, depths of a picture, porosity of "
          "a fit") {
  const TemporaryFolder folder;
  const auto written = [&](const std::string& text) {
    const std::string file = (folder.path() / "table.csv").string();
    std::ofstream(file) << text;
    return file;
  };
  const nlohmann::json layered = nlohmann::json::parse(
      swept({"--layers",
             written("top_m,e,unit_weight_kN/m3,saturated_unit_weight_kN/m3\n0,0.8,15,18\n5,0.7,17,20\n"),
             "--water-table", "12m", "--depth", "10m..15m", "--points", "2", "--strain", "0.0001%..1%",
             "--for", "strata"}));
  REQUIRE(layered.size() == 2);
  CHECK(layered[0].at("untWt") == 17); // above the water
  CHECK(layered[1].at("untWt") == 20);
  const nlohmann::json alike = // at depths of one text
      nlohmann::json::parse(
          swept({"--void-ratio", "0.7", "--unit-weight", "16kN/m3", "--depth", "5m..5.00001m", "--points",
                 "3", "--strain", "0.0001%..1%", "--for", "strata"}));
  std::set<std::string> names;
  for (const nlohmann::json& curve : alike)
    names.insert(curve.at("name").get<std::string>());
  CHECK(names.size() == 3);
  const std::string svg = (folder.path() / "depth.svg").string();
  (void)swept({"--void-ratio", "0.7", "--unit-weight", "16kN/m3", "--depth", "5m..10m", "--points", "3",
               "--picture", svg});
  std::ostringstream picture;
  picture << std::ifstream(svg).rdbuf();
  std::size_t labels = 0;
  const std::string begin = "<text class=\"y-label\"", text = picture.str();
  for (std::size_t at = text.find(begin); at != std::string::npos; at = text.find(begin, at + 1), ++labels)
    CHECK(parse_number(text.substr(text.find('>', at) + 1, text.find('<', at + 1) - text.find('>', at) - 1))
              .value_or(0) <= 10);
  CHECK(labels > 0);
  const auto fitted = [&](const std::string& heading, const std::string& one, const std::string& other) {
    std::string rows = "sigma_v_kPa,sigma_h_kPa,G_MPa," + heading + "\n";
    bool first = true;
    for (const char* const row : {"50,50,60,", "100,60,85,", "200,150,130,", "400,180,170,", "100,100,95,"}) {
      rows += row + (first ? one : other) + "\n";
      first = !first;
    }
    return nlohmann::json::parse(swept({written(rows), "--json"}, "fit"));
  };
  CHECK(fitted("porosity", "0.375", "0.4").at("s").get<double>() ==
        doctest::Approx(fitted("e", "0.6", "0.66666666666666667").at("s").get<double>()).epsilon(1e-9));
}

TEST_CASE(
    "pictures: a fit's laws meet in the middle with the slopes of their legend, curves are six of many") {
  const TemporaryFolder folder;
  const std::string table = (folder.path() / "p.csv").string(), svg = (folder.path() / "p.svg").string();
  std::ofstream(table) << "p_kPa,G_MPa\n50,70\n100,100\n200,130\n400,190\n";
  const auto drawn = [&](std::vector<std::string> words, const std::string& command) {
    words.insert(words.end(), {"--picture", svg, "--force"});
    (void)swept(words, command);
    std::ostringstream text;
    text << std::ifstream(svg).rdbuf();
    return text.str();
  };
  const std::string fit = drawn({table}, "fit");
  std::vector<double> rises, middles; // of the law, of cones and of spheres
  for (std::size_t at = fit.find(" d=\"M"); rises.size() < 3; at = fit.find(" d=\"M", at + 1)) {
    REQUIRE(at != std::string::npos);
    double x1 = 0, y1 = 0, x2 = 0, y2 = 0;
    if (std::sscanf(fit.c_str() + at, " d=\"M%lf,%lfL%lf,%lf\"", &x1, &y1, &x2, &y2) != 4)
      continue;
    middles.push_back((y1 + y2) / 2);
    rises.push_back(y1 - y2);
    CHECK(middles.back() == doctest::Approx(middles.front()).epsilon(1e-3));
  }
  CHECK(rises[1] == doctest::Approx(1.5 * rises[2]).epsilon(1e-3));
  CHECK(rises[0] > rises[2]);
  for (const char* legend : {" = 0.500, cone<", " = 0.333, sphere<"})
    CHECK(fit.find(legend) != std::string::npos);
  const std::string curves = drawn({"--void-ratio", "0.7", "--unit-weight", "16kN/m3", "--depth", "2m..20m",
                                    "--points", "10", "--strain", "0.0001%..1%", "--for", "table"},
                                   "sweep");
  for (int depth = 2; depth <= 20; depth += 2)
    CHECK((curves.find(fmt::format(", {} m,", depth)) != std::string::npos) ==
          (depth == 2 || depth == 4 || depth == 8 || depth == 12 || depth == 16 || depth == 20));
}

TEST_CASE(
    "completion: options with a value have one in bash and zsh, words, files or folders, flags have none") {
  const TemporaryFolder folder;
  std::vector<std::string> words{"granum", "reference", "--out", folder.path().string()};
  std::vector<char*> arguments;
  for (std::string& word : words)
    arguments.push_back(word.data());
  REQUIRE(granum::cli::parse_and_run(4, arguments.data()) == granum::cli::ExitCode::ok);
  const auto has = [&](const char* file, const std::string& part) {
    std::ostringstream text;
    text << std::ifstream(folder.path() / file).rdbuf();
    return text.str().find(part) != std::string::npos;
  };
  const std::string fills = ")\n      mapfile -t COMPREPLY < <(compgen ";
  CHECK(has("bash/granum", "'granum infer --growth'" + fills + "-W 'packings fixed fitted sand'"));
  CHECK(has("bash/granum", "'granum estimate --out'" + fills + "-f"));
  CHECK(has("bash/granum", "'granum analyse --out'" + fills + "-d"));
  CHECK(has("bash/granum", "'granum estimate --void-ratio'"));
  CHECK(has("zsh/_granum", "'*--growth=["));
  CHECK(has("zsh/_granum", ":(packings fixed fitted sand)'"));
  CHECK_FALSE(has("bash/granum", "'granum estimate --json'"));
  CHECK((has("zsh/_granum", "'*--json[") && !has("zsh/_granum", "'*--json=[")));
  CHECK(has("man1/granum-estimate.1", "\\-\\-void\\-ratio"));
}

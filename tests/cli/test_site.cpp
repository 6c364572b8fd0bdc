// SPDX-License-Identifier: GPL-3.0-or-later
// V_s30, travel time and period of a profile, against a sum over many depths; and tables in units of
// practice.
#include <fstream>

#include <granum/core/text.hpp>
#include <granum/io/csv/table.hpp>
#include <nlohmann/json.hpp>

#include "swept_file.hpp"
#include "unit.hpp"

namespace {

using nlohmann::json;

std::vector<std::string> profile(const char* depths, const char* points,
                                 std::initializer_list<std::string> more) {
  std::vector<std::string> words{"--depth", depths, "--points", points};
  words.insert(words.end(), more.begin(), more.end());
  return words;
}

/// Travel time down to a depth, by the trapezium rule over V_s of the states; above the first of them sands
/// of small stress have V_s ~ z^(1/4).
double summed_time(const json& states, double depth) {
  double time = 0, before = 0, slowness = 0;
  for (const json& state : states) {
    const double z = state.at("depth").get<double>();
    if (z == 0 || z > depth * (1 + 1e-12))
      continue;
    const double here = 1 / state.at("answer").at("shear_wave_speed").at("value").get<double>();
    time += before == 0 ? z * here / 0.75 : (z - before) * (slowness + here) / 2;
    before = z;
    slowness = here;
  }
  return time;
}

} // namespace

TEST_CASE("site: travel time, V_s30 and period are those of a sum over many depths") {
  const json dense =
      json::parse(swept(profile("0m..40m", "401", {"--void-ratio", "0.7", "--water-table", "3m", "--json"})));
  const double to_30 = summed_time(dense.at("states"), 30), to_40 = summed_time(dense.at("states"), 40);
  const json& site = dense.at("site");
  CHECK(site.at("base") == 40);
  CHECK(site.at("averaged_to") == 30);
  CHECK(site.at("travel_time").at("value").get<double>() == doctest::Approx(to_40).epsilon(1e-3));
  CHECK(site.at("average_shear_wave_speed").at("value").get<double>() ==
        doctest::Approx(30 / to_30).epsilon(1e-3));
  CHECK(site.at("period").at("value").get<double>() == doctest::Approx(4 * to_40).epsilon(1e-3));
  for (const char* key : {"average_shear_wave_speed", "travel_time", "period"}) {
    const json& range = site.at(key);
    CHECK(range.at("low") < range.at("value"));
    CHECK(range.at("high") > range.at("value"));
  }
}

TEST_CASE("site: layers of two sands, a profile that begins below the surface, and one above 30 m") {
  const TemporaryFolder folder;
  const std::string layers = (folder.path() / "layers.csv").string();
  std::ofstream(layers) << "top_m,D_r,sand,unit_weight_kN/m3,saturated_unit_weight_kN/m3,water_table_m\n"
                           "0,50%,toyoura,15,18.8,4\n8,70%,hostun,16,19.5,\n";
  const json dense = json::parse(swept(profile("0m..20m", "401", {"--layers", layers, "--json"})));
  const json few = json::parse(swept(profile("15m..20m", "2", {"--layers", layers, "--json"})));
  const double time = summed_time(dense.at("states"), 20);
  CHECK(few.at("site") == dense.at("site"));
  CHECK(few.at("site").at("averaged_to") == 20);
  CHECK(few.at("site").at("travel_time").at("value").get<double>() == doctest::Approx(time).epsilon(2e-3));
  const auto G = [&dense](std::size_t k) {
    return dense.at("states")[k].at("answer").at("shear_modulus").at("value").get<double>();
  };
  // Each layer has its own sand: G jumps at 8 m, which is point 160, by far more than from point to point.
  CHECK(std::abs(G(160) / G(159) - 1) > 10 * std::abs(G(159) / G(158) - 1));
}

TEST_CASE("site: a strain does not change it, and its columns hold numbers of their ranges") {
  const auto of = [](std::initializer_list<std::string> more) {
    std::vector<std::string> words = profile("5m..30m", "3", {"--void-ratio", "0.7"});
    words.insert(words.end(), more.begin(), more.end());
    return swept(words);
  };
  CHECK(json::parse(of({"--json"})).at("site") == json::parse(of({"--strain", "0.1%", "--json"})).at("site"));
  const io::CsvTable table("depths", of({"--strain", "0.1%"}));
  for (const char* name : {"G_over_G0", "damping"}) {
    const auto numbers = [&](const char* part) {
      return table.numbers(std::string(name) + part, Dimension::dimensionless);
    };
    for (std::size_t k = 0; k < table.row_count(); ++k) {
      CHECK(numbers("_low")[k] < numbers("_answer")[k]);
      CHECK(numbers("_answer")[k] < numbers("_high")[k]);
    }
  }
  const auto G0 = table.numbers("G_answer", Dimension::pressure),
             G = table.numbers("G_strained_answer", Dimension::pressure),
             ratio = table.numbers("G_over_G0_answer", Dimension::dimensionless);
  for (std::size_t k = 0; k < table.row_count(); ++k)
    CHECK(G[k] == doctest::Approx(G0[k] * ratio[k]).epsilon(1e-4));
}

TEST_CASE("units: practice has kPa, MPa and five digits, and is within rounding of exact SI") {
  for (const std::vector<std::string>& words :
       {profile("2m..30m", "3", {"--void-ratio", "0.7", "--water-table", "3m", "--columns", "all"}),
        std::vector<std::string>{"--void-ratio", "0.7", "--from", "30kPa", "--to", "1MPa", "--points", "3",
                                 "--laws"}}) {
    std::vector<std::string> exact = words;
    exact.insert(exact.end(), {"--units", "si"});
    const io::CsvTable practice("practice", swept(words)), si("si", swept(exact));
    REQUIRE(practice.headings().size() == si.headings().size());
    for (std::size_t k = 0; k < si.headings().size(); ++k) {
      const std::string &here = practice.headings()[k], &there = si.headings()[k];
      const bool pascal = there.ends_with("_Pa");
      CHECK((here == there) == !pascal);
      double factor = 1;
      if (pascal) {
        const bool stress = there.starts_with("p_") || there.starts_with("q_") || there.find("sigma") == 0 ||
                            there.starts_with("total_") || there.starts_with("pore_");
        factor = stress ? 1e-3 : 1e-6;
        CHECK(here == there.substr(0, there.size() - 2) + (stress ? "kPa" : "MPa"));
      }
      for (std::size_t row = 0; row < si.row_count(); ++row)
        if (const auto number = parse_number(si.fields(row)[k])) {
          CHECK(parse_number(practice.fields(row)[k]).value() ==
                doctest::Approx(*number * factor).epsilon(5.1e-5));
          std::string digits = practice.fields(row)[k].substr(0, practice.fields(row)[k].find('e'));
          std::erase_if(digits, [](char c) { return c < '0' || c > '9'; });
          digits.erase(0, std::min(digits.find_first_not_of('0'), digits.size()));
          while (digits.size() > 5 && digits.back() == '0')
            digits.pop_back();
          CHECK(digits.size() <= 5);
        }
    }
  }
}

// SPDX-License-Identifier: GPL-3.0-or-later
// The rules of the table of inputs at the doors of the program: options and columns of tables.
#include <cctype>
#include <granum/core/text.hpp>
#include <granum/effective/contact_prior.hpp>
#include <granum/estimate/answer.hpp>

#include "cli/analyse/analyse_options.hpp"
#include "cli/options/input_columns.hpp"
#include "cli/options/input_options.hpp"
#include "cli/options/slips.hpp"
#include "thresholds.hpp"
#include "unit.hpp"

namespace {

using namespace granum::cli;
using estimate::InputRow;

/// A door: gives an input its value, written as text in SI.
using Door = void (*)(InputValues& values, const InputRow& row, const std::string& text);

void by_option(InputValues& values, const InputRow& row, const std::string& text) {
  const OptionRow option = input_option(values, row.input);
  option.value.take(option.name, text + std::string(si_symbol(row.dimension)));
}

void by_column(InputValues& values, const InputRow& row, const std::string& text) {
  const std::string unit(si_symbol(row.dimension));
  const io::CsvTable table("rows.csv", row.key + (unit.empty() ? "" : "_" + unit) + "\n" + text + "\n");
  const InputValues given = values;
  InputColumns columns(table, given);
  REQUIRE(columns.bind(row.input));
  CHECK(columns.unread().empty());
  values = columns.row(0);
}

/// As Python gives it.
void by_keyword(InputValues& values, const InputRow& row, const std::string& text) {
  values.by_keywords = true;
  if (row.input == Input::uniformity) // which gives a distribution
    by_option(values, row, text);
  else if (row.kind == estimate::Kind::number)
    values.give(row.input, parse_number(text).value());
  else
    values.give(row.input, text);
}

constexpr Door doors[] = {&by_option, &by_column, &by_keyword};

/// Density and stress for an input, beside which nothing contradicts it.
InputValues beside(const InputRow& row) {
  InputValues values;
  const bool density = row.input == Input::void_ratio || row.input == Input::porosity ||
                       row.input == Input::solid_fraction || row.input == Input::relative_density;
  const bool stress = row.input == Input::pressure || row.input == Input::stress_v;
  if (!density)
    values.give(Input::void_ratio, 0.6);
  if (row.input == Input::k0)
    values.give(Input::stress_v, 100e3);
  else if (row.input == Input::stress_v)
    values.give(Input::stress_h, 100e3);
  else if (row.input == Input::stress_h)
    values.give(Input::stress_v, 100e3);
  else if (!stress)
    values.give(Input::pressure, 100e3);
  if (row.input == Input::grain_bulk_modulus)
    values.give(Input::grain_shear_modulus, 30e9);
  if (row.law != nullptr) {
    values.contact = row.law->shape;
    for (const InputRow& other : estimate::inputs())
      if (other.law == row.law && other.input != row.input)
        values.give(other.input, *other.by_default);
  }
  return values;
}

/// The refusal of a value; empty if it is answered.
std::string refusal(Door door, const InputRow& row, const std::string& text) {
  try {
    InputValues values = beside(row);
    door(values, row, text);
    const InputValues all = completed(values);
    (void)estimate::answer(question_of(all), uncertain_inputs(all, estimate::Deviations{}));
    return "";
  } catch (const InvalidArgument& error) {
    return error.what();
  }
}

std::vector<const InputRow*> numbers() {
  std::vector<const InputRow*> all;
  for (const InputRow& row : estimate::inputs())
    if (row.kind == estimate::Kind::number)
      all.push_back(&row);
  return all;
}

} // namespace

TEST_CASE("inputs at doors: a number beyond its limits is refused by each, with the name that it has there") {
  for (const InputRow* const row : numbers()) {
    CAPTURE(row->key);
    for (const double beyond : {row->limits.low - 1, row->limits.high * 1.5 + 1}) {
      if (!std::isfinite(beyond))
        continue;
      const std::string text = exact_text(beyond), of_option = refusal(by_option, *row, text),
                        of_column = refusal(by_column, *row, text),
                        of_keyword = refusal(by_keyword, *row, text);
      CAPTURE(of_option);
      CHECK(!of_option.empty());
      CHECK(of_option == of_column);
      CHECK(!of_keyword.empty());
      CHECK(of_keyword.find("--") == std::string::npos);
    }
  }
}

TEST_CASE("inputs at doors: a possible number makes one question, by option and by column") {
  for (const InputRow* const row : numbers()) {
    CAPTURE(row->key);
    const bool limited = std::isfinite(row->limits.low) && std::isfinite(row->limits.high);
    const double usual = row->by_default && *row->by_default > 0 ? *row->by_default
                         : limited && row->limits.high < 10      ? 0.45 * (row->limits.low + row->limits.high)
                                                                 : 5;
    const double number = row->input == Input::void_ratio         ? 0.6
                          : row->dimension == Dimension::pressure ? std::max(usual, 100e3)
                          : row->dimension == Dimension::length   ? std::min(usual, 0.4e-3)
                                                                  : usual;
    std::vector<estimate::Question> questions;
    for (const Door door : doors) {
      InputValues values = beside(*row);
      REQUIRE_NOTHROW(door(values, *row, exact_text(number)));
      CHECK(values.stated(row->input));
      CHECK(values.number(row->input) == number);
      questions.push_back(question_of(completed(values)));
    }
    for (std::size_t k = 1; k < std::size(doors); ++k) {
      CHECK(questions[0].state.law == questions[k].state.law);
      CHECK(questions[0].state.void_ratio == questions[k].state.void_ratio);
      CHECK(questions[0].state.stress_h == questions[k].state.stress_h);
      CHECK(questions[0].sand == questions[k].sand);
      CHECK(questions[0].grain_shape == questions[k].grain_shape);
      if (row->read != nullptr) {
        REQUIRE(row->read(questions[0]).has_value());
        CHECK(*row->read(questions[0]) == *row->read(questions[k]));
      }
    }
  }
}

TEST_CASE("inputs at doors: words are read alike, and refused alike with the words that there are") {
  for (const InputRow& row : estimate::inputs()) {
    if (row.kind != estimate::Kind::word)
      continue;
    CAPTURE(row.key);
    for (const std::string& word : row.words) {
      std::string text = word;
      for (const auto& [place, value] : {std::pair{"NUMBER", "0.3"}, std::pair{"PRESSURE", "10kPa"}})
        if (const std::size_t at = text.find(place); at != std::string::npos)
          text.replace(at, std::string::npos, value);
      for (const Door door : doors) {
        InputValues values;
        REQUIRE_NOTHROW(door(values, row, text));
        CHECK(values.stated(row.input));
      }
    }
    for (const Door door : doors) {
      InputValues values;
      CHECK_THROWS_AS(door(values, row, "nonsense"), InvalidArgument);
    }
  }
}

TEST_CASE("inputs at doors: an option and a column of one input contradict each other") {
  for (const InputRow* const row : numbers()) {
    CAPTURE(row->key);
    InputValues values;
    if (row->input == Input::uniformity)
      by_option(values, *row, "2");
    else
      values.give(row->input, 1);
    CHECK_THROWS_AS(by_column(values, *row, "1"), InvalidArgument);
  }
}

TEST_CASE("inputs: headings that people have are those of the inputs") {
  struct Case {
    const char* heading;
    Input input;
    double number; ///< of "2" in SI
  };
  for (const Case& one :
       {Case{"e_c", Input::void_ratio, 2}, Case{"Void Ratio", Input::void_ratio, 2},
        Case{"Mean Effective Stress (kPa)", Input::pressure, 2e3},
        Case{"mean_effective_stress_kPa", Input::pressure, 2e3}, Case{"p' [kPa]", Input::pressure, 2e3},
        Case{"Confining pressure (MPa)", Input::pressure, 2e6}, Case{"\u03c33'(kPa)", Input::pressure, 2e3},
        Case{"\u03c3'1 (kPa)", Input::stress_v, 2e3},
        Case{"Vertical effective stress (kPa)", Input::stress_v, 2e3},
        Case{"Dr (%)", Input::relative_density, 0.02},
        Case{"Relative density (%)", Input::relative_density, 0.02}, Case{"D50 (mm)", Input::d50, 2e-3},
        Case{"Coefficient of uniformity", Input::uniformity, 2}}) {
    CAPTURE(one.heading);
    const io::CsvTable table("rows.csv", std::string(one.heading) + "\n2\n");
    const InputValues given;
    InputColumns columns(table, given);
    columns.bind_packing();
    columns.bind_material();
    CHECK(columns.unread().empty());
    const InputValues row = columns.row(0);
    REQUIRE(row.stated(one.input));
    CHECK(row.number(one.input) == doctest::Approx(one.number).epsilon(1e-14));
  }
}

TEST_CASE("inputs: of two headings of one input the first is read, and others are named") {
  const InputValues given;
  const auto remarks = [&](const char* text) {
    const io::CsvTable table("rows.csv", text);
    InputColumns columns(table, given);
    columns.bind_packing();
    columns.bind(Input::shear_strain);
    return std::pair(columns.row(0), columns.remarks());
  };
  const auto [first, unread] = remarks("e_0,e_c\n0.8,0.7\n");
  CHECK(first.number(Input::void_ratio) == 0.7); // after consolidation
  REQUIRE(unread.size() == 1);
  CHECK(unread[0].find("e_0") != std::string::npos);
  const auto [both, none] = remarks("sigma_1_kPa,sigma_3_kPa\n200,100\n");
  CHECK(both.number(Input::stress_h) == 100e3);
  CHECK(none.empty());
  CHECK(remarks("sigma_3_kPa\n100\n").second.size() == 1); // taken as the mean stress
  CHECK(remarks("strain\n1e-4\n").second.size() == 1);     // without a unit
  for (const char* heading : {"strain_%", "strain_percent", "strain (%)", "strain [-]"})
    CHECK(remarks((std::string(heading) + "\n0.01\n").c_str()).second.empty());
  CHECK(remarks("strain_percent\n0.01\n").first.number(Input::shear_strain) == 1e-4);
}

TEST_CASE("inputs: two columns of one input are refused by their places") {
  const io::CsvTable table("rows.csv", "note,e,p_kPa,void_ratio\nx,0.6,100,0.7\n");
  const InputValues given;
  InputColumns columns(table, given);
  try {
    columns.bind_packing();
    FAIL("both are read");
  } catch (const FileError& error) {
    CHECK(std::string(error.what()).find("columns 2 and 4,") != std::string::npos);
  }
}

TEST_CASE("inputs: gamma is a strain without a unit, and no strain with the unit of a weight") {
  const InputValues given;
  for (const auto& [text, strain] :
       {std::pair("gamma\n1e-4\n", true), std::pair("gamma_kN/m3\n17\n", false)}) {
    const io::CsvTable table("rows.csv", text);
    InputColumns columns(table, given);
    CHECK(columns.bind(Input::shear_strain) == strain);
  }
}

TEST_CASE("inputs: suction is refused with its line") {
  const InputValues given;
  for (const char* text :
       {"suction_kPa\n0\n5\n", "Matric suction (kPa)\n0\n5\n", "pore_pressure_kPa\n5\n-5\n"}) {
    const io::CsvTable table("rows.csv", text);
    CHECK_THROWS_AS(InputColumns(table, given), FileError);
  }
  for (const char* text : {"suction_kPa\n0\n", "pore_pressure_kPa\n5\n", "e\n0.7\n"}) {
    const io::CsvTable table("rows.csv", text);
    CHECK_NOTHROW(InputColumns(table, given));
  }
}

TEST_CASE("numbers that look like a mistake are noted from where on, with the number that was meant") {
  using Judge = void (*)(const Typed&, Validity&);
  const struct {
    Judge judge;
    Dimension dimension;
    std::vector<double> thresholds, words; ///< where a note begins or ends, and where it says something else
    std::vector<std::pair<double, double>> meant;
  } rows[] = {
      {judge_stress, Dimension::pressure, {150, 100e6}, {100e9}, {{100, 100e3}, {2e8, 2e5}, {2e11, 2e5}}},
      {judge_length, Dimension::length, {1e-7, 0.1}, {}, {{5e-8, 5e-5}, {0.5, 5e-4}}},
      {judge_modulus,
       Dimension::pressure,
       {200e6, 1e12},
       {10e6},
       {{44e3, 44e9}, {44e6, 44e9}, {44e12, 44e9}, {3e5, 300e9}}},
      {judge_density, Dimension::density, {500, 20000}, {}, {{2.65, 2650}, {2.65e6, 2650}}},
      {[](const Typed& e, Validity& v) { judge_void_ratio(e, false, v); },
       Dimension::dimensionless,
       {0.1, 0.25, 0.4, 3},
       {10, 100},
       {}},
      {[](const Typed& e, Validity& v) { judge_void_ratio(e, true, v); },
       Dimension::dimensionless,
       {0.1, 3},
       {},
       {}}};
  for (const auto& [judge, dimension, thresholds, words, meant] : rows) {
    const auto notes = [&, j = judge, d = dimension](double value) {
      Validity validity;
      j({"x", value, d}, validity);
      return validity.notes;
    };
    for (const double at : thresholds)
      check_threshold(at, [&](double x) { return notes(x).size(); });
    for (const double at : words) {
      const auto without_digits = [&](double x) {
        std::string text = notes(x).front();
        std::erase_if(text, [](unsigned char c) { return std::isdigit(c) || c == '.'; });
        return text;
      };
      CHECK(without_digits(0.99 * at) != without_digits(1.01 * at));
    }
    for (const auto& [typed, other] : meant) {
      REQUIRE(notes(typed).size() == 1);
      CHECK(notes(typed).front().find(" " + pretty(other, dimension) + "?") != std::string::npos);
    }
  }
  // Contacts: three deviations above those of a dense packing; of C_n, of other codes, a fifth more.
  const effective::State state{.law = contact::PowerLaw::sphere({30e9, 0.15}, 5e-4),
                               .radius = 5e-4,
                               .void_ratio = 0.6,
                               .stress_v = 1e5,
                               .stress_h = 1e5};
  const auto prior = effective::contact_prior(state, {.kind = effective::Preparation::Kind::dense});
  const double most = prior.densest.mechanical_coordination_number + 3 * prior.coordination_error;
  for (const bool without : {true, false})
    check_threshold((without ? 1 : 1.2) * most, [&](double z) {
      Validity validity;
      judge_contacts({"z", z}, without, state, validity);
      return validity.notes.size();
    });
}

TEST_CASE("frames are chosen as all, the last, one, or a range with a stride") {
  const auto taken = [](const char* text) { // of eight
    const FrameChoice choice = parse_frames(text);
    std::string out = choice.only_last ? "last " : "";
    for (std::size_t k = 0; k < 8; ++k)
      out += choice.takes(k) ? static_cast<char>('0' + k) : '.';
    return out;
  };
  for (const auto& [text, frames] : {std::pair{"all", "01234567"},
                                     {"last", "last 01234567"},
                                     {"3", "...3...."},
                                     {"0", "0......."},
                                     {"2:5", "..2345.."},
                                     {"4:", "....4567"},
                                     {":4", "01234..."},
                                     {":", "01234567"},
                                     {"2:2", "..2....."},
                                     {"1:6:2", ".1.3.5.."},
                                     {"1::3", ".1..4..7"}})
    CHECK(taken(text) == frames);
  CHECK(parse_frames("1000000000000000").first == 1000000000000000); // 1e15, the largest
  for (const char* wrong :
       {"", "none", "-1", "1.5", "1:2:3:4", "3:2", "1:2:0", "1:2:", "x:2", "2:x", "1000000000000002"})
    CHECK_THROWS_AS((void)parse_frames(wrong), InvalidArgument);
}

TEST_CASE("files that exist stay unless they are to be replaced") {
  CHECK((existing(true) == io::Existing::replace && existing(false) == io::Existing::keep));
}

TEST_CASE("a box, stresses and a profile are read item by item, each in its own unit") {
  const auto box = parse_box("1mm,2cm,3m");
  CHECK(box->cell == Mat3::diagonal(1e-3, 2e-2, 3));
  CHECK_FALSE(parse_box(""));
  CHECK(parse_stress("1Pa,2kPa,3MPa,-4Pa,5Pa,-6kPa") == studies::PrintedStress{1, 2e3, 3e6, -4, 5, -6e3});
  for (const auto& [text, axis] : {std::pair{"x:1", 0}, {"y:1", 1}, {"z:1", 2}})
    CHECK((parse_profile(text)->axis == axis && parse_profile(text)->slices == 1));
  CHECK(parse_profile("y:10000")->slices == 10000);
  CHECK_FALSE(parse_profile(""));
  for (const char* wrong :
       {"1mm,2mm", "1mm,2mm,3mm,4mm", "1mm,0mm,1mm", "1mm,1mm,-1mm", "1kPa,1mm,1mm", "1mm,,1mm"})
    CHECK_THROWS_AS((void)parse_box(wrong), InvalidArgument);
  for (const char* wrong : {"1Pa,2Pa,3Pa,4Pa,5Pa", "1Pa,2Pa,3Pa,4Pa,5Pa,6Pa,7Pa", "1Pa,2Pa,3Pa,4Pa,5Pa,6m"})
    CHECK_THROWS_AS((void)parse_stress(wrong), InvalidArgument);
  for (const char* wrong :
       {"z", "z:", "z:0", "z:-1", "z:1.5", "z:10001", "w:3", "zz:3", " z:3", "3:z", "z3:2"})
    CHECK_THROWS_AS((void)parse_profile(wrong), InvalidArgument);
}

TEST_CASE("a window is read axis by axis, its depth instead of z") {
  const auto ends = [](const char* window, const char* depth) {
    const studies::WindowChoice choice = parse_window(window, depth).value();
    std::array<double, 8> out{}; // in mm; -9 where open
    for (std::size_t k = 0; k < 3; ++k) {
      out[2 * k] = 1e3 * choice.low[k].value_or(-9e-3);
      out[2 * k + 1] = 1e3 * choice.high[k].value_or(-9e-3);
    }
    out[6] = choice.depth ? 1e3 * choice.depth->first : -9;
    out[7] = choice.depth ? 1e3 * choice.depth->second : -9;
    return out;
  };
  CHECK(ends("1mm..2mm,3mm..4mm,5mm..6mm", "") == std::array<double, 8>{1, 2, 3, 4, 5, 6, -9, -9});
  CHECK(ends("..2mm,3mm..,..", "") == std::array<double, 8>{-9, 2, 3, -9, -9, -9, -9, -9});
  CHECK(ends("..,..,..2mm", "") == std::array<double, 8>{-9, -9, -9, -9, -9, 2, -9, -9});
  CHECK(ends("1mm..2mm,..,..", "0mm..4mm") == std::array<double, 8>{1, 2, -9, -9, -9, -9, 0, 4});
  CHECK(ends("..,1mm..2mm,..", "2mm..4mm") == std::array<double, 8>{-9, -9, 1, 2, -9, -9, 2, 4});
  CHECK(ends("", "2mm..4mm") == std::array<double, 8>{-9, -9, -9, -9, -9, -9, 2, 4});
  CHECK_FALSE(parse_window("", ""));
  for (const auto& [window, depth] : {std::pair{"..,..", ""},
                                      {"..,..,..,..", ""},
                                      {"..,..,1mm", ""},
                                      {"..,..,1kPa..", ""},
                                      {"..,..,1mm..", "0mm..1mm"},
                                      {"..,..,..1mm", "0mm..1mm"},
                                      {"", "1mm.."},
                                      {"", "..1mm"},
                                      {"", "-1mm..1mm"},
                                      {"", "0mm..0mm"},
                                      {"", ".."}})
    CHECK_THROWS_AS((void)parse_window(window, depth), InvalidArgument);
}

TEST_CASE("materials of types are read by either pair of moduli, each once") {
  const auto read = parse_materials(
      {"1:shear-modulus=30GPa,poisson-ratio=0.2", "-1000000000:bulk-modulus=40GPa,shear-modulus=30GPa"});
  REQUIRE(read.size() == 2);
  // K = 2 G (1+nu)/(3 (1-2nu)): 40 = 2*30*1.2/(3*0.6)
  for (const long type : {1L, -1000000000L}) {
    CHECK(read.at(type).shear_modulus == 30e9);
    CHECK(read.at(type).poisson_ratio == relative(0.2, 1e-14));
  }
  const char* const one = "1:shear-modulus=30GPa,poisson-ratio=0.2";
  CHECK_THROWS_AS((void)parse_materials({one, one}), InvalidArgument);
  for (const char* wrong :
       {"shear-modulus=30GPa,poisson-ratio=0.2", "x:shear-modulus=30GPa,poisson-ratio=0.2",
        "1.5:shear-modulus=30GPa,poisson-ratio=0.2", "1000000001:shear-modulus=30GPa,poisson-ratio=0.2",
        "1:shear-modulus=30GPa", "1:poisson-ratio=0.2", "1:bulk-modulus=40GPa,poisson-ratio=0.2",
        "1:shear-modulus", "1:shear-modulus=30GPa,poisson-ratio=0.2,bulk-modulus=40GPa",
        "1:shear-modulus=30GPa,poisson-ratio=0.2,x=1",
        "1:shear-modulus=30GPa,shear-modulus=30GPa,poisson-ratio=0.2",
        "1:shear-modulus=-30GPa,poisson-ratio=0.2", "1:shear-modulus=30GPa,bulk-modulus=0GPa",
        "1:shear-modulus=30GPa,poisson-ratio=0.51",
        "1:shear-modulus=30GPa,poisson-ratio=0.2,poisson-ratio=0.2",
        "1:shear-modulus=30GPa,bulk-modulus=40GPa,bulk-modulus=40GPa"})
    CHECK_THROWS_AS((void)parse_materials({wrong}), InvalidArgument);
}

TEST_CASE("springs against turning and the surface energy of grains are read in each of their units") {
  using Of = packing::TurningSpring::Of;
  const std::tuple<const char*, Of, double> springs[] = {{"", Of::normal, 1},
                                                         {"N/m", Of::displacement, 1},
                                                         {"kN/m", Of::displacement, 1e3},
                                                         {"MN/m", Of::displacement, 1e6},
                                                         {"Nm", Of::angle, 1},
                                                         {"N*m", Of::angle, 1},
                                                         {"Nmm", Of::angle, 1e-3},
                                                         {" kNm", Of::angle, 1e3}};
  for (const auto& [unit, of, factor] : springs) {
    const auto spring = parse_turning("--rolling-stiffness", "50" + std::string(unit));
    CHECK(spring->of == of);
    CHECK(spring->value == relative(50 * factor, 1e-14));
  }
  CHECK(parse_turning("", "marshall")->of == Of::marshall);
  CHECK(parse_turning("", "0")->value == 0);
  CHECK_FALSE(parse_turning("", ""));
  for (const char* wrong : {"-1N/m", "1Pa", "N/m", "mars"})
    CHECK_THROWS_AS((void)parse_turning("", wrong), InvalidArgument);
  using enum contact::AdhesionModel;
  for (const auto& [unit, factor] : {std::pair("J/m2", 1.0),
                                     {"J/m^2", 1.0},
                                     {"N/m", 1.0},
                                     {"mJ/m2", 1e-3},
                                     {"mJ/m^2", 1e-3},
                                     {"mN/m", 1e-3}})
    for (const auto& [name, model] : {std::pair("jkr:50", jkr), {"DMT:50", dmt}}) {
      CHECK(parse_adhesion(std::string(name) + unit)->model == model);
      CHECK(parse_adhesion(std::string(name) + unit)->surface_energy == relative(50 * factor, 1e-14));
    }
  CHECK(parse_adhesion("jkr:0J/m2")->surface_energy == 0);
  CHECK_FALSE(parse_adhesion(""));
  for (const char* wrong : {"jkr", "jkr:", "jkr:1", "jkr:1Pa", "jkr:-1J/m2", "sjkr:1J/m2", "1J/m2"})
    CHECK_THROWS_AS((void)parse_adhesion(wrong), InvalidArgument);
}

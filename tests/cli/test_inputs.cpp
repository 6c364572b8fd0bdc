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

TEST_CASE("the surface energy of grains is read in each of its units") {
  for (const auto& [unit, factor] : {std::pair("J/m2", 1.0),
                                     {"J/m^2", 1.0},
                                     {"N/m", 1.0},
                                     {"mJ/m2", 1e-3},
                                     {"mJ/m^2", 1e-3},
                                     {"mN/m", 1e-3}})
    CHECK(parse_adhesion(std::string("jkr:50") + unit)->surface_energy ==
          doctest::Approx(50 * factor).epsilon(1e-14));
}

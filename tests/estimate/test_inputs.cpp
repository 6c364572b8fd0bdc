// SPDX-License-Identifier: GPL-3.0-or-later
#include <granum/estimate/inputs.hpp>

#include <set>

#include <granum/estimate/answer.hpp>
#include <granum/estimate/input_values.hpp>

#include "questions.hpp"
#include "thresholds.hpp"
#include "unit.hpp"

using namespace granum::estimate;

TEST_CASE("inputs: rows are in the order of their names, with keys and symbols of their own") {
  std::set<std::string> keys;
  for (std::size_t k = 0; k < inputs().size(); ++k) {
    const InputRow& row = inputs()[k];
    CAPTURE(row.key);
    CHECK(static_cast<std::size_t>(row.input) == k);
    CHECK(&row_of(row.input) == &row);
    CHECK(find_input(row.key) == &row);
    CHECK(find_input(row.name()) == &row);
    CHECK(keys.insert(row.key).second);
    CHECK(row.limits.low < row.limits.high);
    CHECK((!row.by_default || row.limits.contain(*row.by_default)));
    CHECK((row.kind != Kind::word) == row.words.empty());
    CHECK((row.law == nullptr) == (row.input < Input::of_laws));
    for (const Conflict& of : row.excludes)
      CHECK(InputValues().spelled(of.sentence).find('{') == std::string::npos);
  }
  CHECK(inputs().size() > static_cast<std::size_t>(Input::of_laws));
  CHECK(find_input("e") == nullptr);
  CHECK(InputValues().spelled("{void_ratio} and {k0}.") == "--void-ratio and --k0.");
}

TEST_CASE("inputs: limits are closed or open as they are written, and print so that they exclude what they "
          "refuse") {
  const Limits half{.low = 0, .high = 1, .without_low = true, .reason = "a share"};
  CHECK_FALSE(half.contain(0));
  CHECK(half.contain(1));
  CHECK_FALSE(half.contain(std::nextafter(1, 2)));
  CHECK_FALSE(half.contain(NAN));
  CHECK_FALSE(Limits{}.contain(INFINITY));
  CHECK(half.text(2).starts_with("(0, 1]"));
  CHECK(Limits{.low = 0}.text(-1) == "[0, inf)");
  CHECK(Limits{.high = 2.0 / 3}.text(0.6666667) == "(-inf, 0.66666667]");
}

TEST_CASE("inputs: every limit of a question is demanded by its answer, whatever built the question") {
  // A number of each row that has a place in a question, just outside of its limits.
  using Set = void (*)(Question&, double);
  const std::pair<Input, Set> places[] = {
      {Input::radius, [](Question& q, double x) { q.state.radius = x; }},
      {Input::d50, [](Question& q, double x) { q.sand.d50 = x; }},
      {Input::tangential_ratio, [](Question& q, double x) { q.state.tangential_ratio = x; }},
      {Input::rolling, [](Question& q, double x) { q.state.rolling = x; }},
      {Input::void_ratio, [](Question& q, double x) { q.state.void_ratio = x; }},
      {Input::coordination_number, [](Question& q, double x) { q.state.coordination_number = x; }},
      {Input::mechanical_coordination_number,
       [](Question& q, double x) { q.state.mechanical_coordination_number = x; }},
      {Input::rattler_fraction, [](Question& q, double x) { q.rattler_fraction = x; }},
      {Input::fabric, [](Question& q, double x) { q.state.fabric_anisotropy = x; }},
      {Input::stress_v, [](Question& q, double x) { q.state.stress_v = x; }},
      {Input::stress_h, [](Question& q, double x) { q.state.stress_h = x; }},
      {Input::grain_density, [](Question& q, double x) { q.grain_density = x; }},
      {Input::relative_density, [](Question& q, double x) { q.sand.relative_density = x; }},
      {Input::least_void_ratio, [](Question& q, double x) { q.sand.least_void_ratio = x; }},
      {Input::largest_void_ratio, [](Question& q, double x) { q.sand.largest_void_ratio = x; }},
      {Input::saturation, [](Question& q, double x) { q.saturation = x; }},
      {Input::shear_strain, [](Question& q, double x) { q.shear_strain = x; }}};
  std::size_t read = 0;
  for (const InputRow& row : inputs())
    read += row.read != nullptr;
  CHECK(std::size(places) + 2 == read); // the grains' moduli are checked by their own type
  CHECK_NOTHROW(require_within(row_of(Input::shear_strain), 0.05, "5 %"));
  CHECK_FALSE(row_of(Input::shear_strain).limits.contain(0.0501));
  for (const double end : {-7.0 / 3, 7.0 / 5}) { // where means of fourth powers would be negative
    CHECK(row_of(Input::fabric).limits.contain(0.999 * end));
    CHECK_FALSE(row_of(Input::fabric).limits.contain(1.001 * end));
  }
  for (const InputRow& row : inputs()) { // "write 60%" to a share that may have been per cent
    const auto asked = [&](double value, bool is_signed) {
      try {
        require_within(row, value, "share", is_signed);
      } catch (const InvalidArgument& error) {
        return std::string_view(error.what()).ends_with("% for per cent") ? 1 : 0;
      }
      return 0;
    };
    CAPTURE(row.key);
    CHECK(asked(99.9 * row.limits.high, true) == 0);
    if (row.share) {
      check_threshold(100 * row.limits.high, [&](double value) { return asked(value, false); });
      check_threshold(row.limits.high < 0.1 ? row.limits.high : std::max(row.limits.high, 1.0),
                      [&](double value) { return asked(value, false); });
    } else {
      CHECK(asked(99.9 * row.limits.high, false) == 0);
    }
  }
  for (const GrainShape shape : all_grain_shapes)
    for (const auto& place : places) {
      const InputRow& row = row_of(place.first);
      const Limits& limits = row.limits;
      const double below = limits.without_low ? limits.low : limits.low - 1e-3,
                   above = limits.without_high ? limits.high : limits.high + 1e-3;
      for (const double outside : {below, above})
        if (std::isfinite(outside)) {
          Question q = test::grains_of(2, 0, 100e3, 100e3);
          q.grain_shape = shape;
          place.second(q, outside);
          CAPTURE(row.key);
          CAPTURE(outside);
          std::string refused;
          try {
            (void)answer(q);
          } catch (const InvalidArgument& error) {
            refused = error.refused() ? error.refused()->name : "?";
          }
          CHECK(refused == row.name());
        }
    }
}

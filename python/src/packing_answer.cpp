// SPDX-License-Identifier: GPL-3.0-or-later
#include <pybind11/pybind11.h>
#include <pybind11/stl.h>

#include <array>
#include <cmath>
#include <cstddef>
#include <limits>

#include <granum/effective/answer.hpp>

#include "bindings.hpp"
#include "docstrings.hpp"
#include "estimate.hpp"
#include "state.hpp"

namespace granum::python {

namespace {

using effective::PackingAnswer;
using effective::Range;

/// The ranges of an answer, in the order of `shown_ranges`.
constexpr std::size_t quantity_count = 14;

struct AnswerRow {
  std::array<Range, quantity_count> ranges;
  std::vector<effective::Share> shares;

  AnswerRow() { ranges.fill({StiffnessRow::nan, StiffnessRow::nan, StiffnessRow::nan}); }
  explicit AnswerRow(PackingAnswer&& answer)
      : ranges{answer.shear_modulus,
               answer.bulk_modulus,
               answer.young_modulus,
               answer.poisson_ratio,
               answer.G_hh,
               answer.horizontal_young_modulus,
               answer.coordination_number,
               answer.mechanical_coordination_number,
               answer.rattler_fraction,
               or_nan(answer.shear_wave_speed),
               or_nan(answer.compression_wave_speed),
               or_nan(answer.horizontal_shear_wave_speed),
               or_nan(answer.horizontal_compression_wave_speed),
               or_nan(answer.bulk_density)},
        shares(std::move(answer.shares)) {}

 private:
  static Range or_nan(const std::optional<Range>& range) {
    return range.value_or(Range{StiffnessRow::nan, StiffnessRow::nan, StiffnessRow::nan});
  }
};

struct ShownRange {
  const char* name;
  const char* documentation;
};

constexpr ShownRange shown_ranges[quantity_count] = {
    {"shear_modulus", "G_vh [Pa]."},
    {"bulk_modulus", "K of the skeleton [Pa]."},
    {"young_modulus", "E_v of the skeleton [Pa]."},
    {"poisson_ratio", "nu_vh of the skeleton [1]."},
    {"G_hh", "Shear modulus of the horizontal plane [Pa]."},
    {"horizontal_young_modulus", "E_h of the skeleton [Pa]."},
    {"coordination_number", "C_n [1]."},
    {"mechanical_coordination_number", "z* [1]."},
    {"rattler_fraction", "x_0 [1]."},
    {"shear_wave_speed", "Up and down, or sideways in a vertical plane [m/s]; NaN without grain_density."},
    {"compression_wave_speed", "Up and down, undrained [m/s]; NaN without grain_density."},
    {"horizontal_shear_wave_speed", "In the horizontal plane [m/s]; NaN without grain_density."},
    {"horizontal_compression_wave_speed", "Undrained [m/s]; NaN without grain_density."},
    {"bulk_density", "With the water in its pores [kg/m3]; NaN without grain_density."}};

/// One of the ranges of a result, which it keeps alive.
struct RangeView {
  py::object result;
  std::size_t offset;

  [[nodiscard]] py::object number(std::size_t part) const { return member<AnswerRow>(result, offset + part); }
};

py::object packing_answer(const Arguments& a) {
  const StateArguments arguments(a, StateArguments::CoordinationNumber::optional);
  const std::size_t more = state_keyword_count;
  const auto preparation = a.given(more) ? effective::preparation_of(a.text(more)) : effective::Preparation{};
  const bool has_density = a.given(more + 1);
  std::vector<Argument> columns(arguments.columns().begin(), arguments.columns().end());
  columns.push_back({"grain_density", 0.0});
  if (has_density)
    columns.back().value = a[more + 1];
  columns.push_back({"saturation", 0.0});
  if (a.given(more + 2))
    columns.back().value = a[more + 2];
  const std::size_t density = arguments.columns().size();
  return py::cast(answer_rows(columns, arguments.strict(), AnswerRow{}, [&](const double* x, Notes& notes) {
    effective::PackingQuestion question = arguments.question(x);
    question.preparation = preparation;
    if (has_density)
      question.grain_density = x[density];
    question.saturation = x[density + 1];
    PackingAnswer answer = effective::answer(question);
    notes.add(answer.validity);
    return AnswerRow(std::move(answer));
  }));
}

/// The share of each input; 0 where an element has none of it.
py::dict shares(const Rows<AnswerRow>& rows) {
  std::set<std::string> inputs;
  for (const AnswerRow& row : rows.rows)
    for (const effective::Share& share : row.shares)
      inputs.insert(share.input);
  py::dict out;
  for (const std::string& input : inputs)
    out[py::str(input)] = computed(rows, [&](const AnswerRow& row) {
      for (const effective::Share& share : row.shares)
        if (share.input == input)
          return share.share;
      return 0.0;
    });
  return out;
}

std::string text_of(const py::object& result) {
  const auto& rows = result.cast<const Rows<AnswerRow>&>();
  if (!rows.scalar)
    return "<PackingAnswer of shape " + std::string(py::str(result.attr("shape"))) + ">";
  const Range& g = rows.front().ranges[0];
  const auto MPa = [](double value) { return std::string(py::str("{:.4g}").format(value / 1e6)); };
  return "PackingAnswer(shear_modulus=" + MPa(g.value) + " MPa, from " + MPa(g.low) + " to " + MPa(g.high) +
         " MPa)";
}

constexpr const char* parameters = R"(preparation : str, optional
    "dense", "loose", or "friction:0.3", a friction coefficient; without it unknown.
grain_density : array_like, optional
    Of the grains' solid [kg/m3]; without it no wave speeds.
saturation : array_like
    Share of the pores' volume that is water, in [0, 1] [1].

Returns
-------
PackingAnswer

Raises
------
InvalidArgument
    For numbers that no packing can have; arrays: under strict.
)";

} // namespace

void bind_packing_answer(py::module_& module) {
  py::class_<RangeView>(module, "Range", "Numbers and what they may be as well: floats, or arrays.")
      .def_property_readonly(
          "value", [](const RangeView& r) { return r.number(offsetof(Range, value)); }, "The best answer.")
      .def_property_readonly(
          "low", [](const RangeView& r) { return r.number(offsetof(Range, low)); },
          "The lower end of the range.")
      .def_property_readonly(
          "high", [](const RangeView& r) { return r.number(offsetof(Range, high)); },
          "The upper end of the range.");
  auto type = result_class<AnswerRow>(module, "PackingAnswer",
                                      "Relaxed moduli and wave speeds of packings, each with its range.");
  for (std::size_t k = 0; k < quantity_count; ++k)
    type.def_property_readonly(
        shown_ranges[k].name,
        [offset = offsetof(AnswerRow, ranges) + k * sizeof(Range)](const py::object& result) {
          return RangeView{result, offset};
        },
        shown_ranges[k].documentation);
  type.def_property_readonly("shares", &shares,
                             "How much of the range of shear_modulus each input makes: by name, [0, 1].");
  type.def("__repr__", &text_of);
  define(module,
         {"packing_answer",
          question_keywords({{"preparation", "None"}, {"grain_density", "None"}, {"saturation", "0.0"}}),
          &packing_answer,
          std::string(
              "The best answer there is for a packing, with its range: what granum estimate says first."
              "\n\nRung 3 at the contacts that are known, or else in the middle of those that a packing "
              "of this void ratio may have. The range holds the preparation and the error of rung 3.\n") +
              state_parameters + parameters +
              notes("Water in full pores by Gassmann. [Gassmann1951] [Mavko2009]", "effective::answer",
                    "effective/answer.hpp")});
}

} // namespace granum::python

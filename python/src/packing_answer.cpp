// SPDX-License-Identifier: GPL-3.0-or-later
#include <pybind11/pybind11.h>
#include <pybind11/stl.h>

#include <array>
#include <cmath>
#include <cstddef>
#include <limits>

#include <granum/estimate/answer.hpp>

#include "bindings.hpp"
#include "estimate.hpp"
#include "question.hpp"
#include "range.hpp"

namespace granum::python {

namespace {

using estimate::Range;

struct AnswerRow {
  std::array<Range, estimate::field_count> ranges;
  std::vector<estimate::Share> shares;

  AnswerRow() { ranges.fill({StiffnessRow::nan, StiffnessRow::nan, StiffnessRow::nan}); }
  explicit AnswerRow(const estimate::Answer& answer) : AnswerRow() {
    for (const estimate::FieldRow& row : estimate::fields())
      if (const auto& range = answer.find(row.field))
        ranges[static_cast<std::size_t>(row.field)] = *range;
    shares = answer.shares();
  }
};

/// "shear modulus, vertical plane [Pa]; NaN without grain_density."
std::string documentation(const estimate::FieldRow& row) {
  const std::string unit(si_symbol(row.dimension));
  return std::string(row.directed_meaning) + " [" + (unit.empty() ? "1" : unit) + "]" +
         (row.needs_density ? "; NaN without grain_density." : ".");
}

/// One of the ranges of a result.
RangeView range_view(const py::object& result, std::size_t offset) {
  const auto number = [&](std::size_t part) { return member<AnswerRow>(result, offset + part); };
  return {number(offsetof(Range, value)), number(offsetof(Range, low)), number(offsetof(Range, high))};
}

py::object packing_answer(const Arguments& a) {
  const QuestionArguments arguments(a);
  return py::cast(
      answer_rows(arguments.columns(), arguments.strict(), AnswerRow{}, [&](const double* x, Notes& notes) {
        const estimate::Answer answer = arguments.answer(x);
        notes.add(answer.validity());
        return AnswerRow(answer);
      }));
}

/// The share of each input; 0 for elements without this input.
py::dict shares(const Rows<AnswerRow>& rows) {
  std::set<std::string> inputs;
  for (std::size_t k = 0; k < rows.rows.size(); ++k) {
    hear_signals(k);
    for (const estimate::Share& share : rows.rows[k].shares)
      inputs.insert(share.input);
  }
  py::dict out;
  for (const std::string& input : inputs)
    out[py::str(input)] = computed(rows, [&](const AnswerRow& row) {
      for (const estimate::Share& share : row.shares)
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

} // namespace

void bind_packing_answer(py::module_& module) {
  py::class_<RangeView>(module, "Range", "Values with their ranges: floats, or arrays.")
      .def_readonly("value", &RangeView::value, "The best estimate.")
      .def_readonly("low", &RangeView::low, "The lower end of the range.")
      .def_readonly("high", &RangeView::high, "The upper end of the range.");
  auto type = result_class<AnswerRow>(module, "PackingAnswer",
                                      "Relaxed moduli and wave speeds of packings, each with its range.");
  for (const estimate::FieldRow& row : estimate::fields())
    type.def_property_readonly(
        row.key,
        [offset = offsetof(AnswerRow, ranges) + static_cast<std::size_t>(row.field) * sizeof(Range)](
            const py::object& result) { return range_view(result, offset); },
        documentation(row).c_str());
  type.def_property_readonly("shares", &shares,
                             "Share of each input in the range of shear_modulus: by name, in [0, 1].");
  type.def("__repr__", &text_of);
  define(module, "packing_answer", question_keywords(),
         {.summary =
              "The best estimate for a packing, with its range: the first result of granum "
              "estimate.\n\nRung 3 with the given contacts, or else with the middle of the possible "
              "contacts of a packing of this void\nratio. The range covers the preparation, the error of "
              "rung 3 and uncertain inputs.",
          .returns = "PackingAnswer",
          .refuses = "For impossible numbers; with arrays only under strict.",
          .remarks = "Water in saturated pores by Gassmann. [Gassmann1951] [Mavko2009]",
          .function = "estimate::answer",
          .header = "estimate/answer.hpp"},
         &packing_answer);
}

} // namespace granum::python

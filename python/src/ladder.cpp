// SPDX-License-Identifier: GPL-3.0-or-later
#include <pybind11/pybind11.h>
#include <pybind11/stl.h>

#include <cstddef>

#include <granum/core/numerics.hpp>
#include <granum/core/text.hpp>
#include <granum/effective/contact_prior.hpp>
#include <granum/effective/rungs.hpp>
#include <granum/estimate/ladder.hpp>

#include "bindings.hpp"
#include "estimate.hpp"
#include "members.hpp"
#include "question.hpp"
#include "shared_keywords.hpp"

namespace granum::python {

namespace {

using effective::CarriedContacts;
using effective::ContactCounts;
using effective::ContactPrior;

effective::State grains_at_rest(const contact::NormalLaw& law, double radius, double void_ratio,
                                double pressure, const std::optional<sizes::ContactMeans>& contacts) {
  return {.law = law,
          .tangential_ratio = contact::mindlin_stiffness_ratio(law.grain().poisson_ratio),
          .radius = radius,
          .void_ratio = void_ratio,
          .stress_v = pressure,
          .stress_h = pressure,
          .contacts = contacts.value_or(sizes::ContactMeans{})};
}

std::vector<Keyword> grains_keywords() {
  using estimate::Input;
  return {law_keyword(), of_input(Input::radius, "float"), of_input(Input::void_ratio, "float"),
          of_input(Input::pressure, "float").called("stress_v"), contact_means_keyword()};
}

void bind_classes(py::module_& module) {
  ResultClass<ContactCounts>(module, "ContactCounts",
                             "Number of load-bearing contacts, and share of grains without load.")
      .show("mechanical_coordination_number", "z* [1].", &ContactCounts::mechanical_coordination_number)
      .show("rattler_fraction", "x_0 [1].", &ContactCounts::rattler_fraction)
      .show("coordination_number", "C_n, over all grains [1].", &ContactCounts::coordination_number);
  ResultClass<ContactPrior>(module, "ContactPrior", "Possible coordination numbers of a packing.")
      .show("loosest", "The fewest.", &ContactPrior::loosest)
      .show("middle", "Half way, by z*.", &ContactPrior::middle)
      .show("densest", "The most.", &ContactPrior::densest)
      .show("coordination_error", "Standard deviation of z* about each of the three [1].",
            &ContactPrior::coordination_error)
      .show("rattler_error", "Standard deviation of ln x_0 [1].", &ContactPrior::rattler_error)
      .show("relative_overlap", "Overlap at the mean force over the diameter [1].",
            &ContactPrior::relative_overlap)
      .show_notes();
  ResultClass<CarriedContacts>(module, "CarriedContacts",
                               "A packing with known contacts at another mean stress.")
      .show("counts", "Contacts at that stress.", &CarriedContacts::counts)
      .show("void_ratio", "[1]", &CarriedContacts::void_ratio)
      .show("coordination_error", "Standard deviation of z* due to the change of stress [1].",
            &CarriedContacts::coordination_error)
      .show_notes();
}

// ---- exponents

struct ExponentRow {
  double stress_v = nan;
  double stress_h = nan;
};

using Modulus = effective::Modulus;
constexpr std::pair<const char*, Modulus> moduli[] = {
    {"K", Modulus::K},     {"G_hh", Modulus::G_hh}, {"G_vh", Modulus::G_vh},
    {"E_v", Modulus::E_v}, {"E_h", Modulus::E_h},   {"C11", Modulus::C11},
    {"C33", Modulus::C33}, {"C12", Modulus::C12},   {"C13", Modulus::C13}};

py::object exponents(const Arguments& a) {
  const StateArguments arguments(a);
  const effective::Rung& rung = closed_form_of(a[state_keyword_count]);
  const effective::Modulus modulus = a.choice(state_keyword_count + 1, moduli);
  return py::cast(
      answer_rows(arguments.columns(), arguments.strict(), ExponentRow{}, [&](const double* x, Notes&) {
        const auto found = effective::exponents(rung, arguments.state(x), modulus);
        return found ? ExponentRow{found->stress_v, found->stress_h} : ExponentRow{};
      }));
}

void bind_exponents(py::module_& module) {
  auto type = result_class<ExponentRow>(module, "Exponents", "Exponents of the stresses in a modulus.");
  type.show("stress_v", "d ln X/d ln stress_v [1].", &ExponentRow::stress_v)
      .show("stress_h", "d ln X/d ln stress_h [1].", &ExponentRow::stress_h);
  type.def_property_readonly(
      "sum",
      [](const Rows<ExponentRow>& rows) {
        return computed(rows, [](const ExponentRow& row) {
          return effective::StressExponents{row.stress_v, row.stress_h}.sum();
        });
      },
      "s = d ln X/d ln p at constant stress ratio [1].");
  define(module, "exponents",
         state_keywords(
             {rung_keyword(),
              required("modulus",
                       "{\"K\", \"G_hh\", \"G_vh\", \"E_v\", \"E_h\", \"C11\", \"C33\", \"C12\", \"C13\"}",
                       "Of the packing.")}),
         {"Exponents of a modulus at frozen contacts: C_n, z* and a do not change.",
          "Exponents\n    NaN where the modulus vanishes at every stress.",
          "For impossible numbers (with arrays only under strict), or another rung or modulus.",
          "Differentiated exactly under the integral. [Chung2014]", "effective::exponents",
          "effective/rungs.hpp"},
         &exponents);
}

// ---- the ladder

py::object choose(const Arguments& a) {
  QuestionArguments arguments(a);
  const double* numbers = arguments.one_packing("estimate");
  return py::cast(estimate::choose(arguments.answer(numbers), a.number(question_keyword_count())));
}

py::object estimate_of(const estimate::RungAssessment& r) {
  if (!r.stiffness)
    return py::none();
  return estimate_object({.stiffness = *r.stiffness, .validity = {}, .relative_error = r.relative_error});
}

void bind_ladder(py::module_& module) {
  ResultClass<Measured>(module, "Measured", "A number and its standard error, in its unit.")
      .show("value", "The number, in its unit.", &Measured::value)
      .show("standard_error", "Its standard error, in the same unit.", &Measured::standard_error)
      .def("__repr__", [](const Measured& m) {
        return "Measured(" + exact_text(m.value) + " +- " + exact_text(m.standard_error) + ")";
      });
  using estimate::RungAssessment;
  ResultClass<RungAssessment>(module, "RungAssessment", "One rung of the ladder for one packing.")
      .show("rung", "Its number.", [](const RungAssessment& r) { return *r.rung->number; })
      .show("title", "Short description.", [](const RungAssessment& r) { return r.rung->title; })
      .show("typical_time", "Time of one evaluation [s].",
            [](const RungAssessment& r) { return r.rung->typical_time; })
      .show("missing", "Required inputs that are not given.", &RungAssessment::missing)
      .show("estimate", "Stiffness and stated errors; None if an input is missing.", &estimate_of)
      .show("largest_error", "Largest stated error of K, G_hh and G_vh [1]; None if none is stated.",
            &RungAssessment::largest_error)
      .show("error_source", "Source of its stated errors.", &RungAssessment::error_source)
      .show("verdict", "chosen, cheaper_does, beyond_tolerance, error_unknown or inputs_missing.",
            [](const RungAssessment& r) { return estimate::name(r.verdict); })
      .show("reason", "The verdict in words.", &RungAssessment::reason);
  using estimate::Ladder;
  ResultClass<Ladder>(module, "Ladder", "The ladder for one packing, and the chosen rung.")
      .show("tolerance", "[1]", &Ladder::tolerance)
      .show("tolerance_met", "Whether the stated error of the choice is within it.", &Ladder::tolerance_met)
      .show("mechanical_coordination_number", "z* of the answer, with the ends of its range.",
            [](const Ladder& ladder) {
              const estimate::Range& z = ladder.mechanical_coordination_number;
              return std::array{z.value, z.low, z.high};
            })
      .show("rungs", "Rungs 0 to 5; 4 and 5 are not evaluated, because they need a packing.", &Ladder::rungs)
      .show("choice", "The chosen rung.", &Ladder::choice)
      .show("advice", "Inputs that would allow a better or a cheaper rung.", &Ladder::advice)
      .show_notes();
  define(
      module, "estimate",
      question_keywords({required("tolerance", "float",
                                  "> 0, of the largest stated error among K, G_hh and G_vh [1]: 0.05 for "
                                  "5 %.")}),
      {.summary = "The cheapest rung whose stated error is within a tolerance, for one packing.",
       .returns = "Ladder",
       .refuses = "For impossible numbers, and for a sand: rungs apply to spheres. The error of the answer "
                  "for a sand is the\n    range of packing_answer; use grain_shape=\"sphere\" for the rungs.",
       .remarks = "The stated error of rung 3 is half of the range of packing_answer; those of other rungs "
                  "include their\ndistance from it.",
       .function = "estimate::choose",
       .header = "estimate/ladder.hpp",
       .more_errors = "TypeError\n    For arrays.\n"},
      &choose);
}

} // namespace

void bind_contact_prior(py::module_& module) {
  using Means = std::optional<sizes::ContactMeans>;
  bind_classes(module);
  define(module, "contact_prior", grains_keywords() + std::vector{preparation_keyword()},
         {"Possible coordination numbers of a packing if only void ratio and stress are known.",
          "ContactPrior",
          "For impossible numbers, another preparation, or a pressure of preparation above `pressure`.",
          "Calibrated on granum's own packings of all recipes, with their scatter: validation/contact_prior.",
          "effective::contact_prior", "effective/contact_prior.hpp"},
         [](const contact::NormalLaw& law, double radius, double void_ratio, double pressure,
            const Means& means, const std::optional<std::string>& preparation) {
           return effective::contact_prior(grains_at_rest(law, radius, void_ratio, pressure, means),
                                           preparation ? effective::preparation_of(*preparation)
                                                       : effective::Preparation{});
         });
  define(module, "carried_contacts",
         grains_keywords() +
             std::vector{of_input(estimate::Input::mechanical_coordination_number, "float"),
                         of_input(estimate::Input::rattler_fraction, "float"),
                         required("to_pressure", "float", "The other pressure [Pa].").called("pressure")},
         {"z* and rattlers of a packing at another pressure than the one where they are known.",
          "CarriedContacts", "For impossible numbers.",
          "Calibrated on the contacts that form in granum's own packings during compression: "
          "validation/contact_prior.",
          "effective::carried_contacts", "effective/contact_prior.hpp"},
         [](const contact::NormalLaw& law, double radius, double void_ratio, double pressure,
            const Means& means, double coordination, double rattlers, double to_pressure) {
           return effective::carried_contacts(
               grains_at_rest(law, radius, void_ratio, pressure, means),
               {.mechanical_coordination_number = coordination, .rattler_fraction = rattlers}, to_pressure);
         });
}

void bind_sensitivity(py::module_& module) {
  bind_exponents(module);
  bind_ladder(module);
}

} // namespace granum::python

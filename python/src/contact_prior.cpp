// SPDX-License-Identifier: GPL-3.0-or-later
#include <pybind11/pybind11.h>
#include <pybind11/stl.h>

#include <granum/effective/contact_prior.hpp>

#include "bindings.hpp"
#include "members.hpp"
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

} // namespace

void bind_contact_prior(py::module_& module) {
  using Means = std::optional<sizes::ContactMeans>;
  bind_classes(module);
  define(module, "contact_prior",
         grains_keywords() +
             std::vector{
                 optional("preparation", "str",
                          "\"dense\", \"loose\", or \"friction:0.3\", a friction coefficient; without it "
                          "unknown.")},
         {"Possible coordination numbers of a packing if only void ratio and stress are known.",
          "ContactPrior", "For impossible numbers, or another preparation.",
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

} // namespace granum::python

// SPDX-License-Identifier: GPL-3.0-or-later
#include <pybind11/pybind11.h>
#include <pybind11/stl.h>

#include <granum/effective/contact_prior.hpp>

#include "arrays.hpp"
#include "bindings.hpp"
#include "docstrings.hpp"
#include "keywords.hpp"
#include "rows.hpp"

namespace granum::python {

namespace {

using effective::ContactCounts;
using effective::ContactPrior;

/// Law, radius, void ratio, pressure and contact means, in this order.
effective::State grains_at_rest(const Arguments& a) {
  const auto& law = a.as<const contact::NormalLaw&>(0, "a contact law");
  const double pressure = number_of("pressure", a[3]);
  effective::State state{.law = law,
                         .tangential_ratio = contact::mindlin_stiffness_ratio(law.grain().poisson_ratio),
                         .radius = number_of("radius", a[1]),
                         .void_ratio = number_of("void_ratio", a[2]),
                         .stress_v = pressure,
                         .stress_h = pressure};
  if (a.given(4))
    state.contacts = a.as<sizes::ContactMeans>(4, "ContactMeans");
  return state;
}

template <class Ask>
auto with_typed_names(const Ask& ask) {
  try {
    return ask();
  } catch (const InvalidArgument& error) {
    const Argument typed[] = {{"pressure", 0.0, "stress_v"}, {"to_pressure", 0.0, "pressure"}};
    throw as_typed(error, typed);
  }
}

const std::vector<Keyword> grains_keywords{
    {"law"}, {"radius"}, {"void_ratio"}, {"pressure"}, {"contact_means", "None"}};

constexpr const char* grains_parameters = R"(
Parameters
----------
law : NormalLaw
    Normal contact of two grains.
radius : float
    R > 0 of a grain [m].
void_ratio : float
    e > 0 [1].
pressure : float
    Isotropic stress [Pa].
contact_means : ContactMeans, optional
    Of unequal grains; without it those of equal ones.
)";

std::vector<Keyword> and_keywords(std::vector<Keyword> all, std::initializer_list<Keyword> more) {
  all.insert(all.end(), more);
  return all;
}

py::object contact_prior(const Arguments& a) {
  const auto preparation = a.given(5) ? effective::preparation_of(a.text(5)) : effective::Preparation{};
  const effective::State grains = grains_at_rest(a);
  return py::cast(with_typed_names([&] { return effective::contact_prior(grains, preparation); }));
}

py::object carried_contacts(const Arguments& a) {
  const ContactCounts counts{.mechanical_coordination_number =
                                 number_of("mechanical_coordination_number", a[5]),
                             .rattler_fraction = number_of("rattler_fraction", a[6])};
  const effective::State grains = grains_at_rest(a);
  const double to_pressure = number_of("to_pressure", a[7]);
  return py::cast(with_typed_names([&] { return effective::carried_contacts(grains, counts, to_pressure); }));
}

} // namespace

void bind_contact_prior(py::module_& module) {
  py::class_<ContactCounts>(module, "ContactCounts",
                            "Number of load-bearing contacts, and share of grains without load.")
      .def_readonly("mechanical_coordination_number", &ContactCounts::mechanical_coordination_number,
                    "z* [1].")
      .def_readonly("rattler_fraction", &ContactCounts::rattler_fraction, "x_0 [1].")
      .def_property_readonly("coordination_number", &ContactCounts::coordination_number,
                             "C_n, over all grains [1].");
  py::class_<ContactPrior>(module, "ContactPrior", "Possible coordination numbers of a packing.")
      .def_readonly("loosest", &ContactPrior::loosest, "The fewest.")
      .def_readonly("middle", &ContactPrior::middle, "Half way, by z*.")
      .def_readonly("densest", &ContactPrior::densest, "The most.")
      .def_readonly("coordination_error", &ContactPrior::coordination_error,
                    "Standard deviation of z* about each of the three [1].")
      .def_readonly("rattler_error", &ContactPrior::rattler_error, "Standard deviation of ln x_0 [1].")
      .def_readonly("relative_overlap", &ContactPrior::relative_overlap,
                    "Overlap at the mean force over the diameter [1].")
      .def_property_readonly(
          "notes", [](const ContactPrior& prior) { return prior.validity.notes; },
          "Remarks on numbers outside the range of a formula, a sentence each.");
  define(
      module,
      {"contact_prior", and_keywords(grains_keywords, {{"preparation", "None"}}), &contact_prior,
       std::string("Possible coordination numbers of a packing if only void ratio and stress are known.\n") +
           grains_parameters + R"(preparation : str, optional
    "dense", "loose", or "friction:0.3", a friction coefficient; without it unknown.

Returns
-------
ContactPrior
)" + raises_invalid("For impossible numbers, or another preparation.") +
           notes("Calibrated on granum's own packings of all recipes, with their scatter: "
                 "validation/contact_prior.",
                 "effective::contact_prior", "effective/contact_prior.hpp")});
  using effective::CarriedContacts;
  py::class_<CarriedContacts>(module, "CarriedContacts",
                              "A packing with known contacts at another mean stress.")
      .def_readonly("counts", &CarriedContacts::counts, "Contacts at that stress.")
      .def_readonly("void_ratio", &CarriedContacts::void_ratio, "[1]")
      .def_readonly("coordination_error", &CarriedContacts::coordination_error,
                    "Standard deviation of z* due to the change of stress [1].")
      .def_property_readonly(
          "notes", [](const CarriedContacts& carried) { return carried.validity.notes; },
          "Remarks on numbers outside the range of a formula, a sentence each.");
  define(
      module,
      {"carried_contacts",
       and_keywords(grains_keywords,
                    {{"mechanical_coordination_number"}, {"rattler_fraction"}, {"to_pressure"}}),
       &carried_contacts,
       std::string("z* and rattlers of a packing at another pressure than the one where they are known.\n") +
           grains_parameters + R"(mechanical_coordination_number : float
    z* at that pressure [1].
rattler_fraction : float
    x_0 there, in [0, 1) [1].
to_pressure : float
    The other pressure [Pa].

Returns
-------
CarriedContacts
)" + raises_invalid("For impossible numbers.") +
           notes("Calibrated on the contacts that form in granum's own packings during compression: "
                 "validation/contact_prior.",
                 "effective::carried_contacts", "effective/contact_prior.hpp")});
}

} // namespace granum::python

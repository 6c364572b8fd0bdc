// SPDX-License-Identifier: GPL-3.0-or-later
#include "state.hpp"

#include <string>

#include <granum/effective/relaxation.hpp>

#include "shared_keywords.hpp"

namespace granum::python {

namespace {

enum : std::size_t {
  law_at,
  radius_at,
  void_ratio_at,
  coordination_number_at,
  pressure_at,
  stress_v_at,
  stress_h_at,
  fabric_at,
  tangential_ratio_at,
  rolling_at,
  unevenness_at,
  mechanical_at,
  rattlers_at,
  contact_means_at,
  strict_at
};

Argument stress_of(const Arguments& a, bool vertical) {
  return stress_argument(a, pressure_at, stress_v_at, stress_h_at, vertical);
}

} // namespace

Argument stress_argument(const Arguments& a, std::size_t pressure, std::size_t stress_v, std::size_t stress_h,
                         bool vertical) {
  if (a.given(pressure)) {
    if (a.given(stress_v) || a.given(stress_h))
      throw py::type_error("pressure sets both stresses: leave out stress_v and stress_h");
    return {"pressure", a[pressure], vertical ? "stress_v" : "stress_h"};
  }
  const char* const name = vertical ? "stress_v" : "stress_h";
  const std::size_t at = vertical ? stress_v : stress_h;
  if (!a.given(at))
    throw py::type_error(std::string(name) + " is missing: give pressure, or stress_v and stress_h");
  return {name, a[at]};
}

std::vector<Keyword> state_keywords(std::initializer_list<Keyword> more) {
  using estimate::Input;
  static const std::vector<Keyword> all{law_keyword(),
                                        of_input(Input::radius),
                                        of_input(Input::void_ratio),
                                        of_input(Input::coordination_number),
                                        of_input(Input::pressure).or_none().called("stress_v"),
                                        of_input(Input::stress_v).or_none(),
                                        of_input(Input::stress_h).or_none(),
                                        of_input(Input::fabric).or_number(0),
                                        tangential_ratio_keyword("array_like"),
                                        of_input(Input::rolling).or_number(0),
                                        optional("unevenness", "array_like",
                                                 "Q, in [-1, 1]: ln of K under uniform strain over that of "
                                                 "equal forces, of equal grains\n    ln(<f^b>/<f>^b) with "
                                                 "k_n ~ f^b [1]; measure counts it. Rung 3 uses it, as if "
                                                 "without error and the\n    same at every stress; by "
                                                 "default forces are as uneven as in the packings of its "
                                                 "fit."),
                                        of_input(Input::mechanical_coordination_number).or_none(),
                                        of_input(Input::rattler_fraction).or_none(),
                                        contact_means_keyword(),
                                        strict_keyword()};
  return all + more;
}

std::string state_parameters() { return "\nParameters\n----------\n" + entries(state_keywords()); }

StateArguments::StateArguments(const Arguments& a, CoordinationNumber coordination_number)
    : law_(&a.as<const contact::NormalLaw&>(law_at, "a contact law")),
      contacts_(a.given(contact_means_at) ? a.as<sizes::ContactMeans>(contact_means_at, "ContactMeans")
                                          : sizes::ContactMeans{}),
      knows_coordination_number_(coordination_number == CoordinationNumber::needed ||
                                 a.given(coordination_number_at)),
      knows_fabric_(a.given(fabric_at)), knows_tangential_ratio_(a.given(tangential_ratio_at)),
      columns_{Argument{"radius", a[radius_at]},
               Argument{"void_ratio", a[void_ratio_at]},
               Argument{"coordination_number", 0.0},
               stress_of(a, true),
               stress_of(a, false),
               Argument{"fabric_anisotropy", 0.0},
               Argument{"tangential_ratio", 0.0},
               Argument{"mechanical_coordination_number", 0.0},
               Argument{"rolling", 0.0},
               Argument{"unevenness", 0.0}},
      strict_(a.flag(strict_at)) {
  if (knows_coordination_number_)
    columns_[2].value = a[coordination_number_at];
  if (a.given(fabric_at))
    columns_[5].value = a[fabric_at];
  if (a.given(tangential_ratio_at))
    columns_[6].value = a[tangential_ratio_at];
  else
    columns_[6].value = contact::mindlin_stiffness_ratio(law_->grain().poisson_ratio);
  if (a.given(rolling_at))
    columns_[8].value = a[rolling_at];
  if (a.given(unevenness_at)) {
    knows_unevenness_ = true;
    columns_[9].value = a[unevenness_at];
  }
  if (a.given(mechanical_at) && a.given(rattlers_at))
    throw py::type_error("mechanical_coordination_number and rattler_fraction are alternatives: give one");
  if (a.given(mechanical_at)) {
    coordination_ = Coordination::mechanical;
    columns_[7].value = a[mechanical_at];
  } else if (a.given(rattlers_at)) {
    coordination_ = Coordination::rattlers;
    columns_[7] = {"rattler_fraction", a[rattlers_at]};
  }
}

estimate::Question StateArguments::question(const double* x) const {
  estimate::Question out{.state = {.law = *law_,
                                   .tangential_ratio = x[6],
                                   .radius = x[0],
                                   .void_ratio = x[1],
                                   .fabric_anisotropy = x[5],
                                   .stress_v = x[3],
                                   .stress_h = x[4],
                                   .contacts = contacts_,
                                   .rolling = x[8]}};
  if (knows_unevenness_)
    out.state.unevenness = effective::Unevenness{.value = x[9]};
  if (knows_coordination_number_)
    out.state.coordination_number = x[2];
  if (coordination_ == Coordination::mechanical)
    out.state.mechanical_coordination_number = x[7];
  if (coordination_ == Coordination::rattlers)
    out.rattler_fraction = x[7];
  return out;
}

effective::State StateArguments::state(const double* x) const {
  estimate::Question packing = question(x);
  if (packing.rattler_fraction)
    packing.state.mechanical_coordination_number =
        effective::mechanical_coordination_number(x[2], *packing.rattler_fraction);
  return packing.state;
}

Keyword rung_keyword() {
  return required("rung", "int or str",
                  "0 to 3, or isotropic, fabric, directional, relaxed, uniform_stress.");
}

const effective::Rung& closed_form_of(const py::handle& name) {
  using enum effective::RungName;
  static constexpr std::pair<const char*, effective::RungName> names[] = {{"isotropic", isotropic},
                                                                          {"fabric", fabric},
                                                                          {"directional", directional},
                                                                          {"relaxed", relaxed},
                                                                          {"uniform_stress", uniform_stress}};
  const std::string text = py::str(py::reinterpret_borrow<py::object>(name));
  for (const effective::Rung& rung : effective::closed_forms())
    if (text == rung.key || text == rung.column)
      return rung;
  for (const auto& [known, rung] : names)
    if (text == known)
      return effective::rung(rung);
  throw InvalidArgument(
      "rung is a number from 0 to 3, isotropic, fabric, directional, relaxed or uniform_stress, not " + text);
}

} // namespace granum::python

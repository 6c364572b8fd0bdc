// SPDX-License-Identifier: GPL-3.0-or-later
#include <pybind11/pybind11.h>
#include <pybind11/stl.h>

#include <granum/analysis/measure.hpp>
#include <granum/core/number.hpp>
#include <granum/network/linear_response.hpp>

#include "bindings.hpp"
#include "docstrings.hpp"
#include "errors.hpp"
#include "estimate.hpp"
#include "keywords.hpp"
#include "packing.hpp"
#include "rows.hpp"
#include "studies/analyse/measured_frame.hpp"

namespace granum::python {

namespace {

using analysis::Measurement;
using studies::MeasuredFrame;

// ---- parts of a measurement

template <class Type, class Member>
void show_matrix(py::class_<Type>& type, const char* name, Member Type::*member, const char* documentation) {
  type.def_property_readonly(
      name, [member](const Type& value) { return array_of(value.*member); }, documentation);
}

void bind_counts(py::module_& module) {
  using analysis::Counts;
  py::class_<Counts>(module, "Counts", "Numbers of grains and contacts.")
      .def_readonly("grains", &Counts::grains, "Number of grains.")
      .def_readonly("contacts", &Counts::contacts, "Contacts between grains.")
      .def_readonly("wall_contacts", &Counts::wall_contacts, "Contacts of grains with walls.")
      .def_readonly("without_contact", &Counts::without_contact, "Grains without a contact.")
      .def_readonly("coordination_number", &Counts::coordination_number, "C_n = 2 N_c/N, all grains [1].")
      .def_readonly("coordination_error", &Counts::coordination_error, "Its standard error [1].")
      .def_readonly("touching_coordination_number", &Counts::touching_coordination_number,
                    "C_n over the grains with a contact [1].")
      .def_readonly("coordination_number_with_walls", &Counts::coordination_number_with_walls, "[1]")
      .def_readonly("sliding_fraction", &Counts::sliding_fraction, "Share of sliding contacts [1].")
      .def_property_readonly(
          "mechanical_coordination_number", [](const Counts& c) { return c.mechanical.coordination_number; },
          "z*, without rattlers [1].")
      .def_property_readonly(
          "rattler_fraction", [](const Counts& c) { return c.mechanical.rattler_fraction; }, "x_0 [1].")
      .def_property_readonly(
          "rattlers", [](const Counts& c) { return c.mechanical.rattler_count; }, "Number of rattlers.")
      .def_property_readonly(
          "is_rattler",
          [](const Counts& c) {
            py::array_t<bool> out(static_cast<py::ssize_t>(c.mechanical.rattler.size()));
            std::copy(c.mechanical.rattler.begin(), c.mechanical.rattler.end(), out.mutable_data());
            return out;
          },
          "One flag for each grain, or for each body if grains form bodies.");
  using analysis::Microstructure;
  py::class_<Microstructure>(module, "Microstructure", "Numbers of the contact network.")
      .def_readonly("coordination_number", &Microstructure::coordination_number, "C_n, all grains [1].")
      .def_readonly("mechanical_coordination_number", &Microstructure::mechanical_coordination_number,
                    "z* [1].")
      .def_readonly("rattler_fraction", &Microstructure::rattler_fraction, "[1]")
      .def_readonly("fabric_anisotropy", &Microstructure::fabric_anisotropy, "a of E(gamma; a) [1].")
      .def_readonly("fabric_anisotropy_error", &Microstructure::fabric_anisotropy_error,
                    "Its standard error [1].")
      .def_readonly("sliding_fraction", &Microstructure::sliding_fraction, "[1]");
  using analysis::Sizes;
  py::class_<Sizes>(module, "Sizes", "Sizes of the grains.")
      .def_readonly("smallest", &Sizes::smallest, "Radius [m].")
      .def_readonly("largest", &Sizes::largest, "Radius [m].")
      .def_readonly("equivalent", &Sizes::equivalent, "<R^3>/<R^2> [m].")
      .def_readonly("gradation", &Sizes::gradation, "d10, d50, d60.")
      .def_readonly("contacts", &Sizes::contacts, "Means over the contacts of the packing.");
}

void bind_fabric_parts(py::module_& module) {
  using analysis::Fabric;
  py::class_<Fabric> type(module, "Fabric", "Directions of the contacts.");
  show_matrix(type, "tensor", &Fabric::tensor, "F_ij, mean of n_i n_j, (3, 3).");
  type.def_readonly("contacts", &Fabric::contacts, "Number of contacts.")
      .def_property_readonly(
          "anisotropy", [](const Fabric& f) { return f.by_moment.anisotropy; }, "a, by F33 [1].")
      .def_property_readonly(
          "standard_error", [](const Fabric& f) { return f.by_moment.standard_error; },
          "Standard error of a [1].")
      .def_property_readonly(
          "likeliest_anisotropy",
          [](const Fabric& f) {
            return f.by_likelihood ? std::optional(f.by_likelihood->anisotropy) : std::nullopt;
          },
          "a by maximum likelihood [1].")
      .def_property_readonly(
          "isotropy_p_value",
          [](const Fabric& f) { return f.isotropy ? std::optional(f.isotropy->p_value) : std::nullopt; },
          "p-value of these directions if the packing were isotropic.")
      .def_readonly("rose", &Fabric::rose, "Bins over [0, pi/2].");
}

void bind_forces(py::module_& module) {
  py::class_<packing::ContactStress> stress(module, "ContactStress", "Mean stress from the contact forces.");
  show_matrix(stress, "symmetric", &packing::ContactStress::symmetric, "[Pa], (3, 3).");
  show_matrix(stress, "tensor", &packing::ContactStress::tensor, "As summed [Pa], (3, 3).");
  stress
      .def_readonly("asymmetry", &packing::ContactStress::asymmetry, "Antisymmetric over symmetric part [1].")
      .def_property_readonly("mean", &packing::ContactStress::mean, "p = trace/3 [Pa].");
  using analysis::Forces;
  py::class_<Forces>(module, "Forces", "Forces of the contacts.")
      .def_property_readonly(
          "mean", [](const Forces& f) { return f.distribution.mean; },
          "Mean normal force <f_n> of contacts with f_n > 0 [N].")
      .def_property_readonly(
          "largest", [](const Forces& f) { return f.distribution.largest; }, "[N]")
      .def_property_readonly(
          "pressing", [](const Forces& f) { return f.distribution.pressing; }, "Contacts with f_n > 0.")
      .def_property_readonly(
          "in_tension", [](const Forces& f) { return f.distribution.in_tension; }, "Contacts with f_n < 0.")
      .def_readonly("Z_2", &Forces::Z_2, "<f_n^2>/<f_n>^2 [1].")
      .def_readonly("mean_tangential_over_normal", &Forces::mean_tangential_over_normal, "[1]")
      .def_property_readonly(
          "friction_coefficient",
          [](const Forces& f) { return f.friction ? std::optional(f.friction->coefficient) : std::nullopt; },
          "Estimated from the forces [1].")
      .def_readonly("sliding_fraction", &Forces::sliding_fraction,
                    "With the given coefficient, else with the estimated one [1].")
      .def_property_readonly(
          "unbalanced_force_ratio",
          [](const Forces& f) {
            return f.unbalance ? std::optional(f.unbalance->force_ratio) : std::nullopt;
          },
          "Mean residual force over mean contact force [1].");
  using analysis::LawCheck;
  py::class_<LawCheck>(module, "LawCheck", "Comparison of forces and overlaps with a contact law.")
      .def_readonly("contacts", &LawCheck::contacts, "Number of compared contacts.")
      .def_property_readonly(
          "force_exponent",
          [](const LawCheck& c) {
            return c.force_exponent ? std::optional(c.force_exponent->value) : std::nullopt;
          },
          "1 + 1/alpha [1].")
      .def_readonly("coefficient_ratio", &LawCheck::coefficient_ratio,
                    "Median of f_n over the force of the law [1]; None if G_g is not known.")
      .def_readonly("median_misfit", &LawCheck::median_misfit, "[1]")
      .def_readonly("worst_misfit", &LawCheck::worst_misfit, "[1]");
}

void bind_network(py::module_& module) {
  using analysis::Network;
  py::class_<Network>(module, "Network", "Linear response of the contact network, rung 4.")
      .def_property_readonly(
          "relaxed", [](const Network& n) { return array_of(n.response.relaxed().matrix); },
          "6 x 6 with every grain in equilibrium [Pa]. Raises NotConverged if not solved.")
      .def_property_readonly(
          "affine", [](const Network& n) { return array_of(n.response.affine().matrix); },
          "6 x 6 under uniform strain without spin [Pa].")
      .def_property_readonly(
          "converged", [](const Network& n) { return n.response.converged(); },
          "Whether the solver converged.")
      .def_property_readonly(
          "iterations", [](const Network& n) { return n.response.report().iterations; },
          "Iterations of conjugate gradients.")
      .def_property_readonly(
          "residual", [](const Network& n) { return n.response.report().residual; },
          "Residual force over affine force, for the worst load case [1].")
      .def_property_readonly(
          "grains", [](const Network& n) { return n.response.report().grains; },
          "Number of grains that carry load.")
      .def_property_readonly(
          "contacts", [](const Network& n) { return n.response.report().contacts; },
          "Number of contacts between them.")
      .def_property_readonly("G_hh", &Network::G_hh, "Shear modulus of the horizontal plane [Pa].")
      .def_property_readonly("G_vh", &Network::G_vh, "Mean shear modulus of both vertical planes [Pa].")
      .def_property_readonly(
          "bulk_modulus", [](const Network& n) { return n.isotropic_relaxed().bulk_modulus(); },
          "K of the nearest isotropic solid [Pa].")
      .def_property_readonly(
          "shear_modulus", [](const Network& n) { return n.isotropic_relaxed().shear_modulus(); },
          "G of the nearest isotropic solid [Pa].")
      .def_property_readonly(
          "moduli", [](const Network& n) { return n.relaxed.moduli; }, "Moduli of the relaxed network.")
      .def_property_readonly(
          "symmetry", [](const Network& n) { return n.relaxed.symmetry; }, "Symmetry of the relaxed network.")
      .def_property_readonly(
          "bulk_modulus_bounds",
          [](const Network& n) { return py::make_tuple(n.bulk_bounds.lower, n.bulk_bounds.upper); }, "[Pa]");
}

// ---- the measurement

/// Results of the closed forms by the names of their columns, rung0 to rung3 and uniform_stress.
py::dict rungs_of(const MeasuredFrame& frame) {
  py::dict out;
  for (const analysis::ClosedForm& form : frame.packing.closed_forms)
    if (form.answer)
      out[form.rung->column] = estimate_object(*form.answer);
  return out;
}

template <class Part>
void show_part(py::class_<MeasuredFrame>& type, const char* name, Part Measurement::*part,
               const char* documentation) {
  type.def_property_readonly(
      name, [part](const MeasuredFrame& frame) -> const Part& { return frame.packing.*part; }, documentation);
}
template <class Part>
void show_part(py::class_<MeasuredFrame>& type, const char* name, std::optional<Part> Measurement::*part,
               const char* documentation) {
  type.def_property_readonly(
      name,
      [part](const MeasuredFrame& frame) -> const Part* {
        const std::optional<Part>& value = frame.packing.*part;
        return value ? &*value : nullptr;
      },
      documentation);
}

void bind_interior(py::module_& module) {
  using analysis::InteriorMeasures;
  py::class_<InteriorMeasures> type(module, "Interior",
                                    "The part of a packing away from walls, used for the closed forms.");
  type.def_readonly("grains", &InteriorMeasures::grains, "Number of grains with centres inside.")
      .def_readonly("void_ratio", &InteriorMeasures::void_ratio, "Void ratio of this part [1].")
      .def_readonly("microstructure", &InteriorMeasures::micro,
                    "C_n, z*, rattlers, a and sliding in this part.");
  show_matrix(type, "stress", &InteriorMeasures::stress, "Stress from the contacts [Pa], (3, 3).");
}

void bind_measurement(py::module_& module) {
  py::class_<MeasuredFrame> type(
      module, "Measurement",
      "Results of measure() for one packing. Parts that were not requested, or lack an input, are "
      "None; notes list the missing inputs.");
  show_part(type, "volume", &Measurement::volume, "Volume of the cell [m^3].");
  show_part(type, "void_ratio", &Measurement::void_ratio, "Void ratio of the whole cell [1].");
  show_part(type, "sizes", &Measurement::sizes, "Sizes of the grains.");
  show_part(type, "counts", &Measurement::counts, "Numbers of grains and contacts.");
  show_part(type, "fabric", &Measurement::fabric, "Directions of the contacts.");
  show_part(type, "stress", &Measurement::stress, "Stress from the contact forces.");
  show_part(type, "bulk_density", &Measurement::bulk_density, "Dry [kg/m3].");
  show_part(type, "forces", &Measurement::forces, "Forces of the contacts.");
  show_part(type, "law_check", &Measurement::law_check,
            "Comparison of forces and overlaps with a contact law.");
  show_part(type, "law", &Measurement::law, "Contact law of grains of the equivalent radius.");
  show_part(type, "interior", &Measurement::interior,
            "Results in the window; None if the whole packing is used.");
  show_part(type, "network", &Measurement::network, "Rung 4; None if no grain carries load.");
  type.def_property_readonly(
          "microstructure", [](const MeasuredFrame& f) { return f.packing.microstructure(); },
          "C_n, z*, rattlers, a, sliding. Raises InvalidArgument for fewer than 2 contacts.")
      .def_property_readonly("rungs", &rungs_of,
                             "Results of the closed forms for this packing: rung0 to rung3, uniform_stress.")
      .def_property_readonly(
          "notes", [](const MeasuredFrame& f) { return f.packing.notes; },
          "Assumptions and missing inputs, one sentence each.")
      .def_readonly("warnings", &MeasuredFrame::warnings,
                    "Problems that invalidate comparisons, one sentence each.")
      .def("__repr__", [](const MeasuredFrame& f) {
        const analysis::Counts& c = f.packing.counts;
        return "<Measurement of " + std::to_string(c.grains) +
               " grains: C_n = " + short_text(c.coordination_number) +
               ", z* = " + short_text(c.mechanical.coordination_number) +
               ", e = " + short_text(f.packing.void_ratio) + ">";
      });
}

} // namespace

void bind_analysis(py::module_& module) {
  bind_counts(module);
  bind_fabric_parts(module);
  bind_forces(module);
  bind_network(module);
  bind_interior(module);
  bind_measurement(module);
}

} // namespace granum::python

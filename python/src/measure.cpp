// SPDX-License-Identifier: GPL-3.0-or-later
#include <pybind11/pybind11.h>
#include <pybind11/stl.h>

#include <array>
#include <limits>
#include <tuple>

#include <granum/analysis/measure.hpp>
#include <granum/analysis/profile.hpp>
#include <granum/core/error.hpp>
#include <granum/core/text.hpp>
#include <granum/network/linear_response.hpp>

#include "bindings.hpp"
#include "errors.hpp"
#include "estimate.hpp"
#include "measure.hpp"
#include "members.hpp"
#include "packing.hpp"
#include "shared_keywords.hpp"
#include "studies/analyse/materials.hpp"
#include "studies/analyse/measured_frame.hpp"
#include "studies/analyse/overlaps.hpp"
#include "studies/analyse/window.hpp"

namespace granum::python {

namespace {

using analysis::Measurement;
using studies::MeasuredFrame;

// ---- parts of a measurement

py::array_t<bool> flags(const std::vector<bool>& all) {
  py::array_t<bool> out(static_cast<py::ssize_t>(all.size()));
  std::copy(all.begin(), all.end(), out.mutable_data());
  return out;
}

void bind_counts(py::module_& module) {
  using analysis::Counts;
  using Mechanical = packing::MechanicalCoordination;
  ResultClass<Counts>(module, "Counts", "Numbers of grains and contacts.")
      .show("grains", "Number of grains.", &Counts::grains)
      .show("contacts", "Contacts between grains.", &Counts::contacts)
      .show("wall_contacts", "Contacts of grains with walls.", &Counts::wall_contacts)
      .show("without_contact", "Grains without a contact.", &Counts::without_contact)
      .show("coordination_number", "C_n = 2 N_c/N, all grains [1].", &Counts::coordination_number)
      .show("coordination_error", "Its standard error [1].", &Counts::coordination_error)
      .show("touching_coordination_number", "C_n over the grains with a contact [1].",
            &Counts::touching_coordination_number)
      .show("coordination_number_with_walls", "[1]", &Counts::coordination_number_with_walls)
      .show("sliding_fraction", "Share of sliding contacts [1].", &Counts::sliding_fraction)
      .show("mechanical_coordination_number", "z*, without rattlers [1].", &Counts::mechanical,
            &Mechanical::coordination_number)
      .show("rattler_fraction", "x_0 [1].", &Counts::mechanical, &Mechanical::rattler_fraction)
      .show("rattlers", "Number of rattlers.", &Counts::mechanical, &Mechanical::rattler_count)
      .show("is_rattler", "One flag for each grain, or for each body if grains form bodies.",
            [](const Counts& c) { return flags(c.mechanical.rattler); });
  using analysis::Microstructure;
  ResultClass<Microstructure>(module, "Microstructure", "Numbers of the contact network.")
      .show("coordination_number", "C_n, all grains [1].", &Microstructure::coordination_number)
      .show("mechanical_coordination_number", "z* [1].", &Microstructure::mechanical_coordination_number)
      .show("rattler_fraction", "[1]", &Microstructure::rattler_fraction)
      .show("fabric_anisotropy", "a of E(gamma; a) [1].", &Microstructure::fabric_anisotropy)
      .show("fabric_anisotropy_error", "Its standard error [1].", &Microstructure::fabric_anisotropy_error)
      .show("sliding_fraction", "[1]", &Microstructure::sliding_fraction);
  using analysis::Sizes;
  ResultClass<Sizes>(module, "Sizes", "Sizes of the grains.")
      .show("smallest", "Radius [m].", &Sizes::smallest)
      .show("largest", "Radius [m].", &Sizes::largest)
      .show("equivalent", "<R^3>/<R^2> [m].", &Sizes::equivalent)
      .show("gradation", "d10, d50, d60.", &Sizes::gradation)
      .show("contacts", "Means over the contacts of the packing.", &Sizes::contacts);
}

void bind_fabric_parts(py::module_& module) {
  using analysis::Fabric;
  using fabric::AnisotropyEstimate;
  ResultClass<Fabric>(module, "Fabric", "Directions of the contacts.")
      .show("tensor", "F_ij, mean of n_i n_j, (3, 3).", &Fabric::tensor)
      .show("contacts", "Number of contacts.", &Fabric::contacts)
      .show("anisotropy", "a, by F33 [1].", &Fabric::by_moment, &AnisotropyEstimate::anisotropy)
      .show("standard_error", "Standard error of a [1].", &Fabric::by_moment,
            &AnisotropyEstimate::standard_error)
      .show("likeliest_anisotropy", "a by maximum likelihood [1].", &Fabric::by_likelihood,
            &fabric::LikelihoodEstimate::anisotropy)
      .show("isotropy_p_value", "p-value of these directions if the packing were isotropic.",
            &Fabric::isotropy, [](const auto& test) { return test.p_value; })
      .show("rose", "Bins over [0, pi/2].", &Fabric::rose);
}

void bind_forces(py::module_& module) {
  using packing::ContactStress;
  ResultClass<ContactStress>(module, "ContactStress", "Mean stress from the contact forces.")
      .show("symmetric", "[Pa], (3, 3).", &ContactStress::symmetric)
      .show("tensor", "As summed [Pa], (3, 3).", &ContactStress::tensor)
      .show("asymmetry", "Antisymmetric over symmetric part [1].", &ContactStress::asymmetry)
      .show("mean", "p = trace/3 [Pa].", &ContactStress::mean);
  using analysis::Forces;
  ResultClass<Forces>(module, "Forces", "Forces of the contacts.")
      .show("mean", "Mean normal force <f_n> of contacts with f_n > 0 [N].",
            [](const Forces& f) { return f.distribution.mean; })
      .show("largest", "[N]", [](const Forces& f) { return f.distribution.largest; })
      .show("pressing", "Contacts with f_n > 0.", [](const Forces& f) { return f.distribution.pressing; })
      .show("in_tension", "Contacts with f_n < 0.", [](const Forces& f) { return f.distribution.in_tension; })
      .show("Z_2", "<f_n^2>/<f_n>^2 [1].", &Forces::Z_2)
      .show(
          "unevenness",
          "Q, ln of K under uniform strain over that of equal forces, which rung 3 uses [1]; None where the "
          "contact law is not known.",
          &Forces::unevenness)
      .show("strong_anisotropy", "a of contacts with f_n above the mean [1].", &Forces::strong,
            &fabric::AnisotropyEstimate::anisotropy)
      .show("weak_anisotropy", "a of the other pressing contacts [1].", &Forces::weak,
            &fabric::AnisotropyEstimate::anisotropy)
      .show("mean_tangential_over_normal", "[1]", &Forces::mean_tangential_over_normal)
      .show("friction_coefficient", "Estimated from the forces [1].", &Forces::friction,
            [](const auto& friction) { return friction.coefficient; })
      .show("sliding_fraction", "With the given coefficient, else with the estimated one [1].",
            &Forces::sliding_fraction)
      .show("unbalanced_force_ratio", "Mean residual force over mean contact force [1].", &Forces::unbalance,
            [](const auto& unbalance) { return unbalance.force_ratio; });
  using analysis::LawCheck;
  ResultClass<LawCheck>(module, "LawCheck", "Comparison of forces and overlaps with a contact law.")
      .show("contacts", "Number of compared contacts.", &LawCheck::contacts)
      .show("force_exponent", "1 + 1/alpha [1].", &LawCheck::force_exponent,
            [](const auto& exponent) { return exponent.value; })
      .show("coefficient_ratio", "Median of f_n over the force of the law [1]; None if G_g is not known.",
            &LawCheck::coefficient_ratio)
      .show("median_misfit", "[1]", &LawCheck::median_misfit)
      .show("worst_misfit", "[1]", &LawCheck::worst_misfit);
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

void bind_interior(py::module_& module) {
  using analysis::InteriorMeasures;
  ResultClass<InteriorMeasures>(module, "Interior",
                                "The part of a packing away from walls, used for the closed forms.")
      .show("grains", "Number of grains with centres inside.", &InteriorMeasures::grains)
      .show("void_ratio", "Void ratio of this part [1].", &InteriorMeasures::void_ratio)
      .show("microstructure", "C_n, z*, rattlers, a and sliding in this part.", &InteriorMeasures::micro)
      .show("stress", "Stress from the contacts [Pa], (3, 3).", &InteriorMeasures::stress);
}

void bind_measurement(py::module_& module) {
  constexpr auto packing = &MeasuredFrame::packing;
  ResultClass<MeasuredFrame>(module, "Measurement",
                             "Results of measure() for one packing. Parts that were not requested, or lack "
                             "an input, are None; notes list the missing inputs.")
      .show("volume", "Volume of the cell [m^3].", packing, &Measurement::volume)
      .show("void_ratio", "Void ratio of the whole cell [1].", packing, &Measurement::void_ratio)
      .show("sizes", "Sizes of the grains.", packing, &Measurement::sizes)
      .show("counts", "Numbers of grains and contacts.", packing, &Measurement::counts)
      .show("fabric", "Directions of the contacts.", packing, &Measurement::fabric)
      .show("stress", "Stress from the contact forces.", packing, &Measurement::stress)
      .show("bulk_density", "Dry [kg/m3].", packing, &Measurement::bulk_density)
      .show("forces", "Forces of the contacts.", packing, &Measurement::forces)
      .show("law_check", "Comparison of forces and overlaps with a contact law.", packing,
            &Measurement::law_check)
      .show("law", "Contact law of grains of the equivalent radius.", packing, &Measurement::law)
      .show("interior", "Results in the window; None if the whole packing is used.", packing,
            &Measurement::interior)
      .show("network", "Rung 4; None if no grain carries load.", packing, &Measurement::network)
      .show("microstructure",
            "C_n, z*, rattlers, a, sliding. Raises InvalidArgument for fewer than 2 contacts.", packing,
            &Measurement::microstructure)
      .show("rungs", "Results of the closed forms for this packing: rung0 to rung3, uniform_stress.",
            &rungs_of)
      .show("notes", "Assumptions and missing inputs, one sentence each.", packing, &Measurement::notes)
      .show("warnings", "Problems that invalidate comparisons, one sentence each.", &MeasuredFrame::warnings)
      .def("__repr__", [](const MeasuredFrame& f) {
        const analysis::Counts& c = f.packing.counts;
        return "<Measurement of " + std::to_string(c.grains) +
               " grains: C_n = " + short_text(c.coordination_number) +
               ", z* = " + short_text(c.mechanical.coordination_number) +
               ", e = " + short_text(f.packing.void_ratio) + ">";
      });
}

using studies::MeasuredFrame;

constexpr std::pair<const char*, packing::StiffnessFrom> sources_of_stiffness[] = {
    {"overlap", packing::StiffnessFrom::overlap},
    {"force", packing::StiffnessFrom::force},
    {"ratio", packing::StiffnessFrom::ratio}};

/// A number, or a pair of a number and its kind.
std::optional<packing::TurningSpring> turning_spring(const Arguments& a, std::size_t at) {
  using Of = packing::TurningSpring::Of;
  if (!a.given(at))
    return std::nullopt;
  if (!py::isinstance<py::str>(a[at]) && !py::isinstance<py::tuple>(a[at]))
    return packing::TurningSpring{.value = a.number(at), .of = Of::normal};
  const bool alone = py::isinstance<py::str>(a[at]);
  const auto [value, of] = alone
                               ? std::pair(0.0, a.text(at))
                               : a.as<std::pair<double, std::string>>(at, "a number, a pair, or 'marshall'");
  static constexpr std::pair<const char*, Of> known[] = {{"angle", Of::angle},
                                                         {"displacement", Of::displacement},
                                                         {"normal", Of::normal},
                                                         {"marshall", Of::marshall}};
  for (const auto& [word, meaning] : known)
    if (of == word && alone == (meaning == Of::marshall))
      return packing::TurningSpring{.value = value, .of = meaning};
  throw InvalidArgument(
      a.keyword(at).name +
      " is a number, (number, 'angle'), (number, 'displacement'), (number, 'normal') or 'marshall'");
}

/// A model and a surface energy.
std::optional<contact::Adhesion> adhesion_of(const Arguments& a, std::size_t at) {
  using enum contact::AdhesionModel;
  if (!a.given(at))
    return std::nullopt;
  const auto [model, energy] = a.as<std::pair<std::string, double>>(at, "a pair, such as ('jkr', 0.05)");
  if (model != "jkr" && model != "dmt")
    throw InvalidArgument("adhesion is ('jkr', J/m2) or ('dmt', J/m2), not of '" + model + "'");
  return contact::Adhesion{.model = model == "jkr" ? jkr : dmt, .surface_energy = energy};
}

/// The part of the packing used for the closed forms: the interior, the whole, or three ranges.
std::optional<analysis::Window> window_of(const Arguments& a, const Packing& packing) {
  const std::size_t window = a.at("window");
  if (a.is_none(window))
    return std::nullopt;
  if (!a.given(window) || py::isinstance<py::str>(a[window])) {
    if (a.given(window) && a.text(window) != "auto")
      throw InvalidArgument("window is 'auto', None or three ranges, not " + a.text(window));
    const auto interior = studies::interior_window(packing);
    return interior ? std::optional(studies::window_in(packing, *interior)) : std::nullopt;
  }
  using Range = std::optional<std::pair<std::optional<double>, std::optional<double>>>;
  const auto ranges = a.as<std::array<Range, 3>>(window, "'auto', None or three ranges (low, high)");
  studies::WindowChoice choice;
  for (std::size_t axis = 0; axis < 3; ++axis)
    if (ranges[axis])
      std::tie(choice.low[axis], choice.high[axis]) = *ranges[axis];
  return studies::window_in(packing, choice);
}

studies::MaterialsByType materials_by_type(const Arguments& a) {
  studies::MaterialsByType out;
  for (const auto& [type, material] : a.as<std::map<long, std::pair<double, double>>>(
           a.at("materials"), "a dict of types and their (shear modulus, Poisson's ratio)"))
    out[type] = {material.first, material.second};
  return out;
}

/// The law of all contacts, and the material of their grains.
void take_law(const Arguments& a, std::size_t at, analysis::Given& given) {
  const auto& law = a.as<const contact::NormalLaw&>(at);
  given.law_family = [law](const contact::GrainMaterial& grain, double radius) {
    return law.of(grain, radius);
  };
  given.grain_shear_modulus = law.grain().shear_modulus;
  given.grain_poisson_ratio = law.grain().poisson_ratio;
}

py::object measure(const Arguments& a) {
  const auto packing = a.as<SharedPacking>(a.at("packing"));
  analysis::Given given = given_of(a, *packing);
  given.grain_density = a.number_if_given(a.at("grain_density"));
  given.friction_coefficient = a.number_if_given(a.at("friction_coefficient"));
  analysis::Wanted wanted = analysis::everything();
  wanted.network->stop_requested = stop_on_signal();
  wanted.network->prestress = a.flag(a.at("prestress"));
  wanted.network->motions = a.flag(a.at("motions"));
  if (a.given(a.at("network")) && !a.flag(a.at("network")))
    wanted.network.reset();
  wanted.window = window_of(a, *packing);
  MeasuredFrame frame;
  {
    const Unlocked unlocked;
    if (packing->has(io::Finding::contacts_unknown))
      frame = studies::measure_frame(studies::with_overlap_contacts(*packing, given), given, wanted);
    else
      frame = studies::measure_frame(*packing, given, wanted);
  }
  throw_if_signalled();
  return py::cast(std::move(frame));
}

std::vector<Keyword> measure_keywords() {
  using estimate::Input;
  std::vector<Keyword> keywords = given_keywords();
  const Keyword all[] = {
      optional("friction_coefficient", "float",
               "Friction between grains [1]; without it estimated from the forces."),
      of_input(Input::grain_density, "float").or_none(),
      with_default("network", "True", "bool",
                   "Solve the contact network, rung 4: the part that takes the time."),
      with_default("motions", "False", "bool",
                   "Keep what the grains do beside each uniform strain, network.motions."),
      with_default("window", "'auto'", "\"auto\", None or three ranges, optional",
                   "The part whose e, C_n, z*, fabric and stress are used for the closed forms: \"auto\", "
                   "the interior between walls or under a free surface, if there is one; None, the whole; or "
                   "(low, high) [m] along each axis, with None for a whole axis or an open end.")};
  keywords.insert(keywords.end(), std::begin(all), std::end(all));
  return keywords;
}

/// Keywords of measure() that say what is known of the packing, without those of the network.
std::vector<Keyword> profile_keywords() {
  std::vector<Keyword> all{
      required("packing", "Packing", "From read() or packing()."),
      with_default("axis", "'z'", "{\"x\", \"y\", \"z\"}", "Across which the slices are."),
      with_default("slices", "10", "int", "Number of slices, of equal width.")};
  constexpr std::string_view others[] = {"packing",   "network",       "motions",
                                         "prestress", "grain_density", "friction_coefficient"};
  for (Keyword& known : measure_keywords())
    if (std::ranges::find(others, known.name) == std::end(others))
      all.push_back(std::move(known));
  return all;
}

constexpr std::pair<const char*, int> axes[] = {{"x", 0}, {"y", 1}, {"z", 2}};

py::object profile(const Arguments& a) {
  const auto packing = a.as<SharedPacking>(a.at("packing"));
  const analysis::Given given = given_of(a, *packing);
  const int axis = a.given(a.at("axis")) ? a.choice(a.at("axis"), axes) : 2;
  const auto slices = a.given(a.at("slices")) ? a.as<std::size_t>(a.at("slices"), "a whole number") : 10;
  const std::optional<analysis::Window> window =
      a.given(a.at("window")) ? window_of(a, *packing) : std::nullopt;
  std::vector<analysis::Slice> all;
  {
    const Unlocked unlocked;
    const Packing whole = studies::with_overlap_contacts(*packing, given);
    const MeasuredFrame frame = studies::measure_frame(whole, given, {.closed_forms = true});
    all = analysis::profile(whole.assembly, frame.packing, window ? *window : studies::window_in(whole, {}),
                            axis, slices);
  }
  py::dict out;
  const auto add = [&](const char* name, const auto& of) {
    std::vector<double> numbers;
    for (const analysis::Slice& slice : all)
      numbers.push_back(of(slice));
    out[name] = array_of(numbers);
  };
  using Of = const analysis::Slice&;
  add("low", [](Of slice) { return slice.low; });
  add("high", [](Of slice) { return slice.high; });
  add("grains", [](Of slice) { return static_cast<double>(slice.part.grains); });
  add("solid_fraction", [](Of slice) { return slice.solid_fraction; });
  add("coordination_number", [](Of slice) { return slice.part.micro.coordination_number; });
  add("mechanical_coordination_number",
      [](Of slice) { return slice.part.micro.mechanical_coordination_number; });
  add("rattler_fraction", [](Of slice) { return slice.part.micro.rattler_fraction; });
  add("fabric_anisotropy", [](Of slice) { return slice.part.micro.fabric_anisotropy; });
  static constexpr std::tuple<const char*, int, int> components[] = {
      {"stress_xx", 0, 0}, {"stress_yy", 1, 1}, {"stress_zz", 2, 2},
      {"stress_xy", 0, 1}, {"stress_xz", 0, 2}, {"stress_yz", 1, 2}};
  for (const auto& component : components)
    add(std::get<0>(component),
        [&](Of slice) { return slice.part.stress(std::get<1>(component), std::get<2>(component)); });
  add("shear_modulus", [](Of slice) {
    return slice.relaxed ? slice.relaxed->stiffness.G_vh() : std::numeric_limits<double>::quiet_NaN();
  });
  return out;
}

void define_overlap_contacts(py::module_& module) {
  define(
      module, "overlap_contacts",
      {required("packing", "Packing", "Without contacts; a packing with contacts is returned unchanged."),
       optional("law", "NormalLaw",
                "Law of all contacts, for their normal forces; without it there are no forces.")},
      {"Adds the contacts of overlapping spheres to a packing of grains without contacts.",
       "Packing\n    Its notes list the assumptions. Tangential forces depend on the history and remain "
       "unknown.",
       "For a material refused by the law.", "", "analysis::Given", "analysis/measure.hpp"},
      [](const Arguments& a) {
        const auto packing = a.as<SharedPacking>(0);
        analysis::Given given;
        if (a.given(1))
          take_law(a, 1, given);
        return py::cast(unlocked(
            [&] { return std::make_shared<Packing>(studies::with_overlap_contacts(*packing, given)); }));
      },
      1);
}

} // namespace

analysis::Given given_of(const Arguments& a, const Packing& packing) {
  analysis::Given given{.grain_shear_modulus = a.number_if_given(a.at("grain_shear_modulus")),
                        .law_assumed = !a.given(a.at("law")),
                        .tangential_ratio = a.number_if_given(a.at("tangential_ratio"))};
  if (a.given(a.at("grain_poisson_ratio")))
    given.grain_poisson_ratio = a.number(a.at("grain_poisson_ratio"));
  if (a.given(a.at("law"))) {
    if (a.given(a.at("grain_shear_modulus")) || a.given(a.at("grain_poisson_ratio")) ||
        a.given(a.at("materials")))
      throw py::type_error("law contains the material of the grains: leave out grain_shear_modulus, "
                           "grain_poisson_ratio and materials");
    take_law(a, a.at("law"), given);
  }
  if (a.given(a.at("materials")))
    given.materials = studies::materials_of(packing, materials_by_type(a));
  if (a.given(a.at("stiffness_from")))
    given.stiffness_from = a.choice(a.at("stiffness_from"), sources_of_stiffness);
  given.adhesion = adhesion_of(a, a.at("adhesion"));
  given.rolling = turning_spring(a, a.at("rolling_stiffness"));
  given.twisting = turning_spring(a, a.at("twisting_stiffness"));
  return given;
}

std::vector<Keyword> given_keywords() {
  using estimate::Input;
  const std::string spring = "float, (float, str) or \"marshall\"";
  return {
      required("packing", "Packing",
               "From read() or packing(). Without contacts, overlapping spheres are assumed to touch."),
      optional("law", "NormalLaw",
               "Contact law and material of the grains; for spheres the radii are those of the packing. "
               "Default: derived from forces and overlaps."),
      optional("grain_shear_modulus", "float", ""),
      optional("grain_poisson_ratio", "float",
               "Material of spheres, instead of a law: G_g [Pa] and nu_g [1]."),
      optional("materials", "dict",
               "Materials of spheres of several types: {type: (shear modulus [Pa], Poisson's ratio [1])}."),
      of_input(Input::tangential_ratio, "float").or_none(),
      optional("stiffness_from", "{\"overlap\", \"force\", \"ratio\"}",
               "Source of k_n of the network; default: the overlaps, or the forces if the overlaps have few "
               "digits."),
      with_default("prestress", "False", "bool", "Add the geometric stiffness of the contact forces."),
      optional(
          "adhesion", "(str, float)",
          "Spheres that attract: \"jkr\" or \"dmt\", and the surface energy of each grain [J/m2], half of "
          "the work of adhesion. It needs the material; the closed forms are without."),
      optional("rolling_stiffness", spring, ""),
      optional(
          "twisting_stiffness", spring,
          "For all contacts: a number times k_n R*^2 [1]; (k, \"displacement\"), k [N/m] times R*^2; (k, "
          "\"angle\"), k [N m]; or \"marshall\", k_t R* d/2. Without it the values of the contacts.")};
}

void bind_analysis(py::module_& module) {
  bind_counts(module);
  bind_fabric_parts(module);
  bind_forces(module);
  bind_network(module);
  bind_interior(module);
  bind_measurement(module);
}

void bind_measure(py::module_& module) {
  define(module,
         with_bulk_modulus(
             function("measure", measure_keywords(),
                      {"Measures a packing: contacts, fabric, stress, both 6 x 6 stiffnesses, every "
                       "rung.\n\nOther threads can run meanwhile, and Ctrl-C ends it within a second.",
                       "Measurement", "For an impossible packing or number.",
                       "The linear response of the network is exact to 1e-10 of its largest entry; affine "
                       "and relaxed parts as [AgnolinRoux2007c].",
                       "analysis::measure", "analysis/measure.hpp"},
                      &measure, 1),
             "grain_"));
  define(module,
         with_bulk_modulus(
             function(
                 "profile", profile_keywords(),
                 {"How a packing changes along an axis: stress, solid fraction, contacts, and G by rung 3 of "
                  "slices.\n\nThe stress of a slice takes each contact with the share of its branch "
                  "inside. Slices narrower than two diameters show single layers of grains.",
                  "dict of ndarray\n    One number for each slice: low, high [m], grains, solid_fraction, "
                  "coordination_number,\n    mechanical_coordination_number, rattler_fraction, "
                  "fabric_anisotropy, stress_xx to stress_yz [Pa], and\n    shear_modulus [Pa], NaN where "
                  "a slice has none. pandas.DataFrame takes it as it is.",
                  "For an impossible packing or number.",
                  "Slices of a whole periodic packing add up to its stress and its solids to 1e-12. "
                  "[Goldhirsch2010]",
                  "analysis::profile", "analysis/profile.hpp"},
                 &profile, 1),
             "grain_"));
  define_overlap_contacts(module);
}

} // namespace granum::python

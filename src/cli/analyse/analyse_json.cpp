// SPDX-License-Identifier: GPL-3.0-or-later
#include "analyse_stiffness.hpp"
#include "cli/frame/frame.hpp"
#include "cli/options/size_options.hpp"

namespace granum::cli {

namespace {

using nlohmann::ordered_json;

template <class Value>
ordered_json or_null(const std::optional<Value>& value) {
  return value ? ordered_json(*value) : ordered_json();
}

ordered_json json_of(const Mat3& m) {
  ordered_json rows = ordered_json::array();
  for (const auto& row : m.m)
    rows.push_back(row);
  return rows;
}

ordered_json json_of(const analysis::Counts& c) {
  return {{"grains", c.grains},
          {"contacts", c.contacts},
          {"wall_contacts", c.wall_contacts},
          {"grains_without_contact", c.without_contact},
          {"rattlers", c.mechanical.rattler_count},
          {"rattler_fraction", c.mechanical.rattler_fraction},
          {"coordination_number", c.coordination_number},
          {"mechanical_coordination_number", c.mechanical.coordination_number},
          {"touching_coordination_number", c.touching_coordination_number},
          {"coordination_number_with_walls", c.coordination_number_with_walls}};
}

/// Of grains whose contacts nobody knows.
ordered_json unknown_counts(const analysis::Counts& c) {
  ordered_json json = json_of(c);
  for (auto& [key, value] : json.items())
    if (key != "grains" && key != "wall_contacts")
      value = nullptr;
  return json;
}

ordered_json json_of(const fabric::ChiSquareTest& test) {
  return {{"chi_square", test.statistic},
          {"degrees_of_freedom", test.degrees_of_freedom},
          {"p_value", test.p_value}};
}

ordered_json json_of(const analysis::Fabric& f) {
  ordered_json json = {{"tensor", json_of(f.tensor)},
                       {"anisotropy", f.by_moment.anisotropy},
                       {"anisotropy_standard_error", f.by_moment.standard_error}};
  if (f.by_likelihood)
    json.update({{"most_likely_anisotropy", f.by_likelihood->anisotropy},
                 {"most_likely_anisotropy_standard_error", f.by_likelihood->standard_error}});
  if (f.isotropy)
    json["isotropy"] = {{"z_score", f.isotropy->z_score}, {"p_value", f.isotropy->p_value}};
  if (f.density)
    json["density"] = json_of(f.density->chi_square);
  if (f.axisymmetry)
    json["axisymmetry"] = json_of(f.axisymmetry->both);
  return json;
}

ordered_json json_of(const FrameAnswer& frame, const packing::ContactStress& stress) {
  ordered_json json;
  const PrintedStress by_contacts = printed(stress);
  for (std::size_t k = 0; k < by_contacts.size(); ++k)
    json["by_contacts"][stress_names[k]] = by_contacts[k];
  json["mean"] = stress.mean();
  json["asymmetry"] = stress.asymmetry;
  if (frame.code_stress)
    for (std::size_t k = 0; k < by_contacts.size(); ++k) {
      const double code = (*frame.code_stress)[k];
      json["by_code"][stress_names[k]] = code;
      json["relative_difference"][stress_names[k]] =
          code == 0 ? ordered_json() : ordered_json(by_contacts[k] / code - 1);
    }
  return json;
}

ordered_json json_of(const analysis::Forces& f) {
  const packing::ForceDistribution& d = f.distribution;
  ordered_json json = {{"pressing", d.pressing},
                       {"in_tension", d.in_tension},
                       {"unloaded", d.unloaded},
                       {"mean_normal_force", d.mean},
                       {"largest_normal_force", d.largest},
                       {"Z_2", f.Z_2},
                       {"Z_5_3", f.Z_5_3},
                       {"mean_tangential_over_normal", or_null(f.mean_tangential_over_normal)},
                       {"friction_coefficient", nullptr},
                       {"sliding_fraction", or_null(f.sliding_fraction)},
                       {"unbalanced_force_ratio", nullptr},
                       {"unbalanced_moment_ratio", nullptr}};
  if (f.unbalance) {
    json["unbalanced_force_ratio"] = f.unbalance->force_ratio;
    json["unbalanced_moment_ratio"] = f.unbalance->moment_ratio;
  }
  if (f.weight) {
    const Vec3& w = f.weight->per_volume;
    json["weight_per_solid_volume"] = {w.x, w.y, w.z};
    json["unbalanced_over_weight"] = f.weight->left_over;
  }
  if (f.friction)
    json["friction_coefficient"] = f.friction->coefficient;
  return json;
}

ordered_json json_of(const std::optional<Measured>& exponent) {
  if (!exponent)
    return nullptr;
  return {{"value", exponent->value}, {"standard_error", exponent->standard_error}};
}

ordered_json json_of(const analysis::LawCheck& check) {
  return {{"contacts", check.contacts},
          {"left_out", check.left_out},
          {"force_exponent", json_of(check.force_exponent)},
          {"alpha", json_of(check.alpha)},
          {"force_over_law", check.coefficient_ratio},
          {"median_misfit", check.median_misfit},
          {"misfit_90", check.misfit_90},
          {"worst_misfit", check.worst_misfit}};
}

ordered_json json_of(const Moduli& m) {
  return {{"K", m.K},     {"G", m.G},     {"G_hh", m.G_hh}, {"G_vh", m.G_vh},
          {"C11", m.C11}, {"C33", m.C33}, {"C12", m.C12},   {"C13", m.C13}};
}

ordered_json json_of(const RungResult& rung, const Moduli* network) {
  if (!rung.moduli)
    return {{"error", rung.error}};
  ordered_json json = json_of(*rung.moduli);
  if (rung.relative_error)
    json["relative_error"] = {{"K", rung.relative_error->bulk_modulus},
                              {"G_hh", rung.relative_error->G_hh},
                              {"G_vh", rung.relative_error->G_vh}};
  if (network != nullptr && rung.moduli->K > 0 && rung.moduli->G > 0)
    json["measured_over_this"] = {{"K", network->K / rung.moduli->K}, {"G", network->G / rung.moduli->G}};
  return json;
}

ordered_json json_of(const analysis::Network& n) {
  const network::Response::Report& report = n.response.report();
  return {{"converged", n.response.converged()},
          {"grains", report.grains},
          {"contacts", report.contacts},
          {"iterations", report.iterations},
          {"residual", report.residual},
          {"distance_from_isotropy", n.relaxed.symmetry.isotropic},
          {"distance_from_transverse_isotropy", n.relaxed.symmetry.transversely_isotropic},
          {"K_lower", n.bulk_bounds.lower},
          {"K_upper", n.bulk_bounds.upper}};
}

ordered_json read_json(const FrameAnswer& frame, bool missing) {
  ordered_json list = ordered_json::array();
  for (const io::ImportNote& note : frame.read)
    if (says_what_is_missing(note.finding) == missing)
      list.push_back(note.text);
  return list;
}

ordered_json window_json(const analysis::Window& window, const analysis::InteriorMeasures& inside) {
  const auto list = [](const Vec3& v) { return ordered_json{v.x, v.y, v.z}; };
  return {{"low", list(window.low)},
          {"high", list(window.high)},
          {"grains", inside.grains},
          {"void_ratio", inside.void_ratio},
          {"coordination_number", inside.micro.coordination_number},
          {"mechanical_coordination_number", inside.micro.mechanical_coordination_number},
          {"rattler_fraction", inside.micro.rattler_fraction},
          {"anisotropy", inside.micro.fabric_anisotropy},
          {"stress", json_of(inside.stress)}};
}

ordered_json json_of(const FrameAnswer& frame) {
  const analysis::Measurement& a = frame.measured.packing;
  ordered_json json = {{"frame", frame.number},
                       {"step", frame.measured.step},
                       {"time", or_null(frame.measured.time)},
                       {"found", read_json(frame, false)},
                       {"not_in_the_files", read_json(frame, true)}};
  if (a.counts.grains > 0)
    json.update(
        {{"volume", a.volume},
         {"void_ratio", a.void_ratio},
         {"radius",
          {{"smallest", a.sizes.smallest}, {"largest", a.sizes.largest}, {"equivalent", a.sizes.equivalent}}},
         {"gradation", cli::json_of(a.sizes.gradation)},
         {"contact_means", frame.measured.contacts_known ? cli::json_of(a.sizes.contacts) : ordered_json()},
         {"counts", frame.measured.contacts_known ? json_of(a.counts) : unknown_counts(a.counts)}});
  if (frame.window && a.interior)
    json["window"] = window_json(*frame.window, *a.interior);
  if (a.fabric)
    json["fabric"] = json_of(*a.fabric);
  if (a.counts.grains > 0 && !a.forces)
    json.update({{"stress", nullptr}, {"forces", nullptr}});
  if (a.stress)
    json["stress"] = json_of(frame, *a.stress);
  if (a.forces)
    json["forces"] = json_of(*a.forces);
  if (a.law_check && a.law_check->contacts > 0)
    json["contact_law"] = json_of(*a.law_check);
  if (a.grain)
    json["grain"] = {{"shear_modulus", a.grain->shear_modulus}, {"poisson_ratio", a.grain->poisson_ratio}};
  for (const RungResult& rung : frame.rungs)
    json["moduli"][rung.name] = json_of(rung, network_moduli(frame));
  if (a.network)
    json["network"] = json_of(*a.network);
  for (const NamedMatrix& m : network_matrices(frame))
    json["network"][m.name] = matrix_json(*m.matrix);
  if (a.bulk_density)
    json["bulk_density"] = *a.bulk_density;
  json["notes"] = a.notes;
  json["warnings"] = frame.measured.warnings;
  json["seconds"] = frame.seconds;
  return json;
}

ordered_json json_of(const Measured& estimate) {
  return {{"value", estimate.value}, {"standard_error", estimate.standard_error}};
}

ordered_json json_of(const studies::SeriesFit& fit) {
  ordered_json json = {{"states", fit.states}, {"remark", fit.remark}};
  if (fit.sum)
    json.update({{"C", json_of(fit.sum->coefficient)}, {"s", json_of(fit.sum->exponent_sum)}});
  if (fit.sum_with_void_ratio)
    json["s_with_void_ratio_function"] = json_of(fit.sum_with_void_ratio->exponent_sum);
  if (fit.separate)
    json.update({{"m", json_of(*fit.separate->exponent_i)}, {"n", json_of(*fit.separate->exponent_j)}});
  return json;
}

} // namespace

ordered_json analyse_json(const AnalyseAnswer& answer) {
  ordered_json json = json_head("analyse");
  for (std::size_t k = 0; k < answer.files.size(); ++k)
    json["files"].push_back({{"path", answer.files[k]}, {"kind", io::description(answer.kinds[k])}});
  json["conventions"] = {
      {"units", "SI"},
      {"signs", "compression positive; z is the vertical axis v"},
      {"stiffness",
       "C of the network in the axes of the file, Voigt order 11 22 33 23 13 12, engineering shear "
       "strains; moduli are projections: K and G isotropic, the others symmetric about z"}};
  json["frames_skipped"] = answer.skipped;
  json["frames"] = ordered_json::array();
  for (const FrameAnswer& frame : answer.frames)
    json["frames"].push_back(json_of(frame));
  for (const RungSeries& series : answer.series)
    json["series"][series.name] = json_of(series.fit);
  return json;
}

} // namespace granum::cli

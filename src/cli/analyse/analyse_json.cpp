// SPDX-License-Identifier: GPL-3.0-or-later
#include "analyse_parts.hpp"
#include "analyse_series.hpp"
#include "analyse_stiffness.hpp"
#include "cli/frame/frame.hpp"
#include "cli/frame/json_members.hpp"
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

/// Null where the contacts are not known.
ordered_json json_of(const analysis::Counts& counts, bool contacts_known) {
  ordered_json json = members(grain_count_columns(), counts);
  for (const io::Column<analysis::Counts>& column : contact_count_columns())
    json[column.key] = nullptr;
  if (contacts_known)
    put_members(json, contact_count_columns(), counts);
  return json;
}

ordered_json json_of(const fabric::ChiSquareTest& test) {
  return {{"chi_square", test.statistic},
          {"degrees_of_freedom", test.degrees_of_freedom},
          {"p_value", test.p_value}};
}

ordered_json json_of(const analysis::Fabric& f) {
  ordered_json json = {{"tensor", json_of(f.tensor)}};
  put_members(json, fabric_columns(), f);
  if (f.isotropy)
    json["isotropy"] = {{"z_score", f.isotropy->z_score}, {"p_value", f.isotropy->p_value}};
  if (f.density)
    json["density"] = json_of(f.density->chi_square);
  if (f.axisymmetry)
    json["axisymmetry"] = json_of(f.axisymmetry->both);
  return json;
}

ordered_json json_of(const FrameAnswer& frame, const packing::ContactStress& stress) {
  ordered_json json = members(stress_columns(), stress);
  const PrintedStress by_contacts = printed(stress);
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
  ordered_json json = members(force_columns(), f, Absent::null);
  if (f.weight) {
    const Vec3& w = f.weight->per_volume;
    json["weight_per_solid_volume"] = {w.x, w.y, w.z};
    json["unbalanced_over_weight"] = f.weight->left_over;
  }
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

ordered_json json_of(const RungResult& rung, const Moduli* network) {
  if (!rung.moduli)
    return {{"error", rung.error}};
  ordered_json json = members(modulus_columns(), *rung.moduli);
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
                       {"file", frame.file},
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
         {"counts", json_of(a.counts, frame.measured.contacts_known)}});
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
  if (!answer.series.empty())
    json["series"] = series_json(answer);
  return json;
}

} // namespace granum::cli
